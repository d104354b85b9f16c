//! The pixel that a question asks for, in pictures: the one that was clicked, and once there is a verdict the right one.

use crate::picture::{Ink, Picture, Rect};

/// Pixels by column and row.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Answered {
    pub own: Option<(u32, u32)>,
    pub right: Option<(u32, u32)>,
}

/// The side below which a pixel's mark is drawn larger than the pixel, in points.
const SMALLEST: f32 = 10.0;

impl Answered {
    /// A cross on the clicked pixel, unless it is the right one, and a ring around the right one. `place` says where a pixel lies.
    pub fn draw(&self, picture: &mut Picture, place: impl Fn(u32, u32) -> Rect) {
        let reach = |rect: Rect| 0.5 * rect.width.max(SMALLEST);
        if let Some((x, y)) = self.own.filter(|_| self.own != self.right) {
            let rect = place(x, y);
            let (at, reach) = (rect.center(), reach(rect));
            for (ink, width) in [(Ink::Surface, 4.5), (Ink::Bad, 2.5)] {
                for arm in [[reach, reach], [reach, -reach]] {
                    let arm = glam::Vec2::from(arm);
                    picture.line(at - arm, at + arm, ink.stroke(width));
                }
            }
        }
        if let Some((x, y)) = self.right {
            let rect = place(x, y);
            for (ink, width) in [(Ink::Surface, 4.5), (Ink::Good, 2.5)] {
                let radius = reach(rect) + 3.0;
                picture.circle(rect.center(), radius, ink.stroke(width));
            }
        }
    }
}
