//! The eye, its image plane with the pixel in it, and the edges of what it sees.

use super::orbit::target;
use super::sketch::Sketch;
use crate::language::Message;
use crate::picture::Ink;
use crate::replay::Run;
use crate::scene::View;
use glam::{DVec2, Vec2};

const EYE: Message = Message("common-eye");
/// Where the image plane is drawn, in distances from eye to target.
const IMAGE_PLANE: f64 = 0.16;

impl Sketch<'_> {
    pub fn camera(&mut self) {
        let prepared = self.input.run.prepared().clone();
        let view = &prepared.view;
        let depth = IMAGE_PLANE * view.eye.distance(target(&prepared));
        let (width, height) = (f64::from(view.width), f64::from(view.height));
        let corner = |x: f64, y: f64| view.from_screen(DVec2::new(x, y), depth);
        let corners = [
            corner(0.0, 0.0),
            corner(width, 0.0),
            corner(width, height),
            corner(0.0, height),
        ];
        for to in corners {
            self.line(view.eye, to, Ink::Muted.stroke(0.75));
        }
        self.outline(&corners, Ink::Text.stroke(1.5));
        self.pixel(view, depth);
        let Some(at) = self.disc(
            view.eye,
            5.0,
            Ink::Surface.fill().outlined(Ink::Text.stroke(2.0)),
        ) else {
            return;
        };
        self.picture.circle(at, 2.0, Ink::Text);
        self.name(
            at,
            5.0,
            Vec2::NEG_X,
            EYE.text(self.input.language),
            Ink::Text,
        );
    }

    /// The pixel whose ray is followed, on the image plane.
    fn pixel(&mut self, view: &View, depth: f64) {
        let pixel = match self.input.run {
            Run::Rays(_, replay) => replay.state().pixel,
            Run::Shading(_, replay) => replay.state().pixel.map(|pixel| {
                let row = replay.state().scan_line.map_or(0, |row| row.y);
                (pixel.x, row)
            }),
            _ => None,
        };
        let Some((x, y)) = pixel else { return };
        let (x, y) = (f64::from(x), f64::from(y));
        let corner = |dx: f64, dy: f64| view.from_screen(DVec2::new(x + dx, y + dy), depth);
        let corners = [
            corner(0.0, 0.0),
            corner(1.0, 0.0),
            corner(1.0, 1.0),
            corner(0.0, 1.0),
        ];
        self.outline(&corners, Ink::This.stroke(2.0));
    }
}
