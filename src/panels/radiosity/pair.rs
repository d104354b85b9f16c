//! The two patches that are selected, and the form factors between them.

use super::exchange::outline;
use super::room_view::RoomView;
use crate::figure::{Fit, within};
use crate::panels::PanelInput;
use crate::panels::patches::form_factor;
use crate::picture::{Ink, Picture, Rect, Tag};

/// F_ij and F_ji, as far as they are known.
pub fn in_words(input: &PanelInput, [i, j]: [usize; 2]) -> String {
    let both = [[i, j], [j, i]].map(|pair| form_factor(input, pair));
    both.into_iter().flatten().collect::<Vec<_>>().join("  ·  ")
}

/// Outlines around both, broken where a patch turns its back on the viewer, and a line from the one to the other.
pub fn draw(picture: &mut Picture, [i, j]: [usize; 2], (view, fit): (&RoomView, &Fit), area: Rect) {
    for patch in [i, j] {
        let stroke = match view.shows(patch) {
            true => Ink::Linked.stroke(2.5),
            false => Ink::Linked.stroke(2.0).dashed(),
        };
        outline(picture, view, patch, fit, stroke);
    }
    let ends = [i, j].map(|patch| view.center(patch).map(|center| fit.place(center)));
    if let [Some(from), Some(to)] = ends
        && i != j
        && let Some([from, to]) = within([from, to], area.grown(-3.0))
    {
        picture.tagged(Tag::FormFactor { i, j }, |picture| {
            picture.line(from, to, Ink::Linked.stroke(1.75));
        });
    }
}
