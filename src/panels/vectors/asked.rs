//! The arrow that a question asks for, among the vectors that are known.

use super::plane::Plane;
use crate::figure::{Arrow, Labels};
use crate::panels::Answered;
use crate::picture::{Picture, Tag};

/// `text` is the size of its name.
pub(super) fn draw(
    answered: &Answered,
    plane: &Plane,
    text: f32,
    picture: &mut Picture,
    labels: &mut Labels,
) {
    let below = labels.area().bottom() - plane.middle.y - 1.4 * text;
    for arrow in answered.arrows() {
        let shown = Arrow {
            from: plane.middle,
            to: plane.tip(plane.project(arrow.direction), below),
            stroke: arrow.ink.stroke(4.0),
            tag: Tag::Field(arrow.field),
            name: &arrow.name,
            size: text,
            here: false,
        };
        shown.draw(picture, labels);
    }
}
