//! An enclosure with its light interpolated between the corners of patches, as Gouraud shading interpolates intensity: constant
//! patches look faceted, as the eye exaggerates every edge (Cohen & Greenberg 1985, §5).

use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Region;
use crate::algorithms::frame::Frame;
use crate::algorithms::patch_view::corner_values;
use crate::algorithms::scan_line::{self, Corner, EdgeTable};
use crate::color::Rgb;
use crate::record::Unrecorded;
use crate::scene::View;
use std::iter::zip;

/// Draws patches as `view` sees them from their fronts, in their order. Arguments: the enclosure, the numbers of the patches to
/// draw, the view, the part of it to draw, and the colour of every patch of the enclosure.
pub type DrawPatches = fn(&Enclosure, &[usize], &View, &Region, &[Rgb]) -> Frame;

/// A [`DrawPatches`] that interpolates colours. What is drawn has an inverse depth above 0.
pub fn smooth_patches(
    enclosure: &Enclosure,
    patches: &[usize],
    view: &View,
    region: &Region,
    colors: &[Rgb],
) -> Frame {
    let mut frame = Frame::new(view.width, 0..view.height, Rgb::BLACK);
    let corners = corner_values(enclosure, colors);
    let mut edge_table = EdgeTable::new(view, region);
    for &patch in patches {
        let mut values = corners[patch].iter();
        for piece in enclosure.patches.pieces(patch) {
            let corners: Vec<Corner<Rgb>> = zip(piece.corners, values.by_ref())
                .map(|(&at, &value)| Corner {
                    position: view.to_camera(at),
                    value,
                })
                .collect();
            if piece.normal.dot(view.eye - piece.corners[0]) > 0.0 {
                edge_table.fill::<scan_line::Event<Rgb>, _>(
                    corners,
                    &mut frame,
                    &mut Unrecorded,
                    |_, _, value| value,
                );
            }
        }
    }
    frame
}
