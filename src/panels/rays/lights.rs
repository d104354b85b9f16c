//! Lights in a view: where they are, or in which direction.

use super::super::names;
use super::draw::Layout;
use crate::color::Rgb;
use crate::figure::within;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::scene::Light;
use glam::Vec2;

impl Layout<'_> {
    /// Point lights where they are, or, beyond the view, at its border; directional ones as an arrow in a corner.
    pub fn lights(&mut self) {
        let prepared = &self.state.prepared;
        let mut corner = 0.0;
        for (number, light) in prepared.scene.lights.iter().enumerate() {
            let name = names::light(number as u32, self.input.language);
            let style = Style::Label.size(self.text);
            match *light {
                Light::Point {
                    position,
                    color,
                    radius,
                    ..
                } => {
                    let at = self.view.place(position);
                    let size = (radius as f32 * self.view.scale()).clamp(6.0, 40.0);
                    if self.view.shows(at, size + 3.0) {
                        self.picture
                            .tagged(Tag::Light(number), |picture| sun(picture, at, size, color));
                        self.labels.reserve(Rect::between(at, at).grown(size));
                        self.labels
                            .put(self.picture, (at, size + 2.0), Vec2::X, &name, style);
                    } else {
                        self.far_light(number, at, &name);
                    }
                }
                Light::Directional { toward, .. } => {
                    let along = self.view.flat(toward);
                    let along = Vec2::new(along.x as f32, -along.y as f32);
                    let area = self.view.area;
                    let at = Vec2::new(area.right() - 34.0, area.y + 30.0 + corner);
                    corner += 50.0;
                    if at.y + 24.0 > area.bottom() {
                        continue;
                    }
                    let half = 16.0 * along;
                    self.picture.tagged(Tag::Light(number), |picture| {
                        picture.arrow(at - half, at + half, Ink::Warn.stroke(2.5));
                    });
                    self.labels
                        .put(self.picture, (at, 18.0), Vec2::NEG_X, &name, style);
                }
            }
        }
    }

    /// A light beyond the border: an arrow toward it.
    fn far_light(&mut self, number: usize, at: Vec2, name: &str) {
        let inner = self.view.area.grown(-14.0);
        let middle = self.view.area.center();
        let border = within([middle, at], inner);
        let Some([_, end]) = border else { return };
        let toward = (at - middle).normalize_or_zero();
        self.picture.tagged(Tag::Light(number), |picture| {
            picture.arrow(
                end - 14.0 * toward,
                end + 6.0 * toward,
                Ink::Warn.stroke(2.5),
            );
        });
        let style = Style::Label.size(self.text);
        self.labels.put(
            self.picture,
            (end - 4.0 * toward, 12.0),
            -toward,
            name,
            style,
        );
    }
}

/// A light: a disc of its colour with short rays.
fn sun(picture: &mut Picture, at: Vec2, size: f32, color: Rgb) {
    let brightest = color.max_channel().max(f64::MIN_POSITIVE);
    let paint = Ink::Rgb(color / brightest).fill();
    picture.circle(at, size - 2.0, paint.outlined(Ink::Warn.stroke(2.0)));
    for turn in 0..8 {
        let toward = Vec2::from_angle(turn as f32 * std::f32::consts::FRAC_PI_4);
        picture.line(
            at + (size - 1.0) * toward,
            at + (size + 2.0) * toward,
            Ink::Warn.stroke(1.5),
        );
    }
}
