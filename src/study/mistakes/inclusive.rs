//! Scan conversion that rounds a polygon's borders outward and counts both ends: the rows from ⌊y_top⌋ to ⌈y_bottom⌉, and in each the
//! pixels from ⌊x_left⌋ to ⌈x_right⌉. So edges that two polygons share are drawn by both, and the last wins.

use crate::algorithms::frame::Frame;
use crate::algorithms::scan_line::{Corner, clip_near};
use crate::color::Rgb;
use crate::numeric::{Linear, interpolate};
use crate::scene::View;
use glam::{DVec2, DVec3};
use std::ops::Range;

/// What is drawn before is hidden unless it is nearer by more than this share: along a shared edge depths agree but for rounding.
const AS_NEAR: f64 = 1e-9;

/// Where a scan line cuts an edge: the column, 1/depth and the value there.
#[derive(Clone, Copy)]
struct Cut<V>(f64, f64, V);

/// Outside the polygon's border a pixel takes what is interpolated on it.
pub fn fill<V: Linear>(
    polygon: impl IntoIterator<Item = Corner<V>>,
    view: &View,
    frame: &mut Frame,
    color: impl Fn(DVec3, V) -> Rgb,
) {
    let polygon: Vec<Corner<V>> = polygon.into_iter().collect();
    let mut corners = Vec::new();
    clip_near(&polygon, view.near, &mut corners);
    let placed = |corner: &Corner<V>| {
        let DVec2 { x, y } = view.to_screen(corner.position);
        (y, Cut(x, 1.0 / corner.position.z, corner.value))
    };
    let corners: Vec<(f64, Cut<V>)> = corners.iter().map(placed).collect();
    let heights = || corners.iter().map(|&(y, _)| y);
    let top = heights().fold(f64::INFINITY, f64::min);
    let bottom = heights().fold(f64::NEG_INFINITY, f64::max);
    for y in inclusive(top, bottom, frame.rows.clone()) {
        let row = (f64::from(y) + 0.5).clamp(top, bottom);
        let mut cuts = cuts(&corners, row, bottom);
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        for pair in cuts.chunks_exact(2) {
            let (Cut(x_4, near_4, left), Cut(x_5, near_5, right)) = (pair[0], pair[1]);
            for x in inclusive(x_4, x_5, 0..frame.width) {
                let x_p = (f64::from(x) + 0.5).clamp(x_4, x_5);
                let between = x_5 - x_4 > 0.0;
                let (near, value) = match between {
                    true => (
                        interpolate(near_4, x_4, near_5, x_5, x_p),
                        interpolate(left, x_4, right, x_5, x_p),
                    ),
                    false => (near_4, left),
                };
                let index = frame.index(x, y);
                if near >= (1.0 - AS_NEAR) * frame.inverse_depth[index] {
                    let centre = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
                    frame.inverse_depth[index] = near;
                    frame.color[index] = color(view.from_screen(centre, 1.0 / near), value);
                }
            }
        }
    }
}

/// Where the edges pass a row: an even number of times, since of each edge the upper end counts, and the lower one only at the polygon's
/// bottom.
fn cuts<V: Linear>(corners: &[(f64, Cut<V>)], row: f64, bottom: f64) -> Vec<Cut<V>> {
    let edges = (0..corners.len()).map(|from| (corners[from], corners[(from + 1) % corners.len()]));
    let passed = edges.filter(|((a, _), (b, _))| {
        let (upper, lower) = (a.min(*b), a.max(*b));
        match row < bottom {
            true => upper <= row && row < lower,
            false => upper < row && row <= lower,
        }
    });
    let cut = |((y_1, a), (y_2, b)): ((f64, Cut<V>), (f64, Cut<V>))| {
        Cut(
            interpolate(a.0, y_1, b.0, y_2, row),
            interpolate(a.1, y_1, b.1, y_2, row),
            interpolate(a.2, y_1, b.2, y_2, row),
        )
    };
    passed.map(cut).collect()
}

/// From ⌊start⌋ to ⌈end⌉, both counted, as far as they are among `all`.
fn inclusive(start: f64, end: f64, all: Range<u32>) -> Range<u32> {
    let within = |place: f64| place.clamp(all.start.into(), all.end.into()) as u32;
    within(start.floor())..within(end.ceil() + 1.0)
}
