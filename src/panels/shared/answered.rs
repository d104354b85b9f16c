//! What a question asks for, in pictures: the pixel or the thing that was clicked, or the arrow as it is turned; and once there
//! is a verdict the right one.

use crate::picture::{Ink, Picture, Rect, Tag};
use glam::DVec3;

/// Pixels and things as tags of what pictures show.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Answered {
    pub own: Option<Tag>,
    pub right: Option<Tag>,
    pub arrow: Option<AskedArrow>,
}

/// An arrow that the question asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AskedArrow {
    /// The name of the value.
    pub field: &'static str,
    /// Where it starts.
    pub point: DVec3,
    /// Unit: as it is turned so far, or was answered.
    pub own: DVec3,
    /// Unit, once there is a verdict.
    pub right: Option<DVec3>,
    /// Whether the verdict is that the answer was right.
    pub is_right: bool,
}

/// As a picture shows it.
pub struct ShownArrow {
    pub field: &'static str,
    pub name: String,
    pub point: DVec3,
    pub direction: DVec3,
    pub ink: Ink,
}

/// The side below which a mark is drawn larger than what it marks, in points.
const SMALLEST: f32 = 10.0;

impl Answered {
    /// The arrow that was turned, with a question mark, and the right one beside it.
    pub fn arrows(&self) -> impl Iterator<Item = ShownArrow> {
        self.arrow.into_iter().flat_map(|asked| {
            let shown = |name, direction, ink| ShownArrow {
                field: asked.field,
                name,
                point: asked.point,
                direction,
                ink,
            };
            let wrong = asked.right.is_some() && !asked.is_right;
            let ink = if wrong { Ink::Bad } else { Ink::Linked };
            let own = shown(format!("{}?", asked.field), asked.own, ink);
            let right = asked
                .right
                .map(|right| shown(asked.field.to_owned(), right, Ink::Good));
            std::iter::once(own).chain(right)
        })
    }

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
