//! The place in the panel of an enclosure whose light is interpolated between the corners of patches, and the size at which it is
//! drawn.

use super::room_view::RoomView;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Region;
use crate::color::Rgb;
use crate::figure::Fit;
use crate::picture::{Image, Rect};
use crate::render::DrawPatches;
use crate::scene::View;
use glam::DVec2;
use std::ops::Range;

/// More pixels are not drawn: what is that near is shown coarser.
const MOST_PIXELS: f64 = 2e6;

/// The fronts of all patches, transparent where there are none, and its place in the panel. `colors` has one a patch.
pub(super) fn image(
    draw: DrawPatches,
    room: &Enclosure,
    view: &RoomView,
    fit: &Fit,
    colors: &[Rgb],
) -> (Rect, Image) {
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

    let patches: Vec<usize> = view.seen.iter().map(|seen| seen.patch).collect();
    let frame = draw(room, &patches, &enlarged, &region, colors);
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
