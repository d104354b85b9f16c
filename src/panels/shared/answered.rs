//! What a question asks for, in pictures: the pixel or the thing that was clicked, and once there is a verdict the right one.

use crate::picture::{Ink, Picture, Rect, Tag};

/// Both as tags of what pictures show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Answered {
    pub own: Option<Tag>,
    pub right: Option<Tag>,
}

/// The side below which a mark is drawn larger than what it marks, in points.
const SMALLEST: f32 = 10.0;

impl Answered {
    /// A cross on what was clicked, unless it is right, and a ring around what is right. `place` says where the picture shows it.
    pub fn draw(&self, picture: &mut Picture, place: impl Fn(Tag) -> Option<Rect>) {
        let reach = |rect: Rect| 0.5 * rect.width.max(SMALLEST);
        if let Some(rect) = self.own.filter(|_| self.own != self.right).and_then(&place) {
            let (at, reach) = (rect.center(), reach(rect));
            for (ink, width) in [(Ink::Surface, 4.5), (Ink::Bad, 2.5)] {
                for arm in [[reach, reach], [reach, -reach]] {
                    let arm = glam::Vec2::from(arm);
                    picture.line(at - arm, at + arm, ink.stroke(width));
                }
            }
        }
        if let Some(rect) = self.right.and_then(place) {
            for (ink, width) in [(Ink::Surface, 4.5), (Ink::Good, 2.5)] {
                let radius = reach(rect) + 3.0;
                picture.circle(rect.center(), radius, ink.stroke(width));
            }
        }
    }
}
