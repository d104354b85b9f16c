//! The room with its light interpolated between the corners of patches, as Gouraud shading interpolates intensity: constant patches
//! look faceted, as the eye exaggerates every edge (Cohen & Greenberg 1985, §5).

use super::super::fit::Fit;
use super::room_view::RoomView;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Region;
use crate::algorithms::frame::Frame;
use crate::algorithms::patch_view::corner_values;
use crate::algorithms::scan_line::{self, Corner, EdgeTable};
use crate::color::Rgb;
use crate::picture::{Image, Rect};
use crate::record::Unrecorded;
use crate::scene::View;
use glam::DVec2;
use std::iter::zip;
use std::ops::Range;

/// More pixels are not drawn: what is that near is shown coarser.
const MOST_PIXELS: f64 = 2e6;

/// The fronts of all patches, transparent where there are none, and its place in the panel. `colors` has one a patch.
pub(super) fn image(room: &Enclosure, view: &RoomView, fit: &Fit, colors: &[Rgb]) -> (Rect, Image) {
    let View { width, height, .. } = view.view;
    let size = DVec2::new(width.into(), height.into());
    let scale = fit.scale.min((MOST_PIXELS / (size.x * size.y)).sqrt());
    let [width, height] = (size * scale).ceil().max(DVec2::ONE).to_array();
    let enlarged = View {
        focal: view.view.focal * scale,
        width: width as u32,
        height: height as u32,
        ..view.view
    };
    // Both screens have their middle in common.
    let on_enlarged = |at: DVec2| scale * (at - 0.5 * size) + 0.5 * DVec2::new(width, height);
    let (low, high) = (on_enlarged(view.low).floor(), on_enlarged(view.high).ceil());
    let region = Region {
        columns: within(low.x, high.x, enlarged.width),
        rows: within(low.y, high.y, enlarged.height),
    };

    let mut frame = Frame::new(enlarged.width, 0..enlarged.height, Rgb::BLACK);
    let corners = corner_values(room, colors);
    let mut edge_table = EdgeTable::new(&enlarged, &region);
    for seen in &view.seen {
        let mut values = corners[seen.patch].iter();
        for piece in room.patches.pieces(seen.patch) {
            let corners: Vec<Corner<Rgb>> = zip(piece.corners, values.by_ref())
                .map(|(&at, &value)| Corner {
                    position: enlarged.to_camera(at),
                    value,
                })
                .collect();
            if piece.normal.dot(enlarged.eye - piece.corners[0]) > 0.0 {
                edge_table.fill::<scan_line::Event<Rgb>, _>(
                    corners,
                    &mut frame,
                    &mut Unrecorded,
                    |_, _, value| value,
                );
            }
        }
    }

    let mut pixels = Vec::with_capacity(4 * region.columns.len() * region.rows.len());
    for y in region.rows.clone() {
        for x in region.columns.clone() {
            let index = frame.index(x, y);
            let [r, g, b] = frame.color[index].to_srgb8();
            let drawn = frame.inverse_depth[index] > 0.0;
            pixels.extend([r, g, b, if drawn { 255 } else { 0 }]);
        }
    }
    let on_screen = |x: u32, y: u32| {
        let at = DVec2::new(x.into(), y.into());
        fit.place((at - 0.5 * DVec2::new(width, height)) / scale + 0.5 * size)
    };
    let place = Rect::between(
        on_screen(region.columns.start, region.rows.start),
        on_screen(region.columns.end, region.rows.end),
    );
    let [columns, rows] = [&region.columns, &region.rows].map(|part| part.len() as u32);
    (place, Image::new(columns, rows, pixels))
}

/// Whole pixels of a screen.
fn within(low: f64, high: f64, size: u32) -> Range<u32> {
    let start = (low.max(0.0) as u32).min(size);
    start..(high.max(0.0) as u32).clamp(start, size)
}
