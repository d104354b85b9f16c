//! The lights of the scene: where they are, or in which direction.

use super::super::names;
use super::sketch::Sketch;
use crate::color::Rgb;
use crate::picture::{Ink, Picture, Rect, Tag};
use crate::scene::Light;
use glam::{DVec3, Vec2};

impl Sketch<'_> {
    /// Point lights where they are; directional ones as an arrow in a corner.
    pub fn lights(&mut self) {
        let prepared = self.input.run.prepared().clone();
        let mut corner = 0.0;
        for (number, light) in prepared.scene.lights.iter().enumerate() {
            let name = names::light(number as u32, self.input.language);
            match *light {
                Light::Point {
                    position,
                    color,
                    radius,
                    ..
                } => {
                    let Some(seen) = self.seen(position) else {
                        continue;
                    };
                    let radius = radius as f32 * self.space.scale() * seen.scale;
                    let radius = radius.clamp(6.0, 40.0);
                    self.picture.tagged(Tag::Light(number), |picture| {
                        sun(picture, seen.at, radius, color);
                    });
                    self.labels
                        .reserve(Rect::between(seen.at, seen.at).grown(radius));
                    self.name(seen.at, radius + 2.0, Vec2::X, &name, Ink::Text);
                }
                Light::Directional { toward, .. } => {
                    corner += 1.0;
                    self.far_light(number, toward, corner, &name);
                }
            }
        }
    }

    fn far_light(&mut self, number: usize, toward: DVec3, corner: f32, name: &str) {
        let area = self.space.area;
        let at = Vec2::new(area.right() - 34.0, area.y + 50.0 * corner - 20.0);
        if at.y + 24.0 > area.bottom() {
            return;
        }
        let half = 16.0 * self.space.flat(toward);
        self.picture.tagged(Tag::Light(number), |picture| {
            picture.arrow(at - half, at + half, Ink::Warn.stroke(2.5));
        });
        self.name(at, 18.0, Vec2::NEG_X, name, Ink::Text);
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
