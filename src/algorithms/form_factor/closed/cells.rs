//! A polygon divided where other surfaces meet it: along the borders of what lies in its plane and looks the other way, and along what
//! passes through it or stands on it. In front of a cell all points lie on the same side of every surface.

use super::super::polygon::Polygon;
use super::super::sheet::Sheet;
use glam::DVec3;

/// The cells of a sheet. `slack` is how far rounding may have moved a corner.
pub fn cells(sheet: &Sheet, others: &[Sheet], slack: f64) -> Vec<Polygon<'static>> {
    let mut cells = vec![sheet.polygon.clone()];
    let near = || others.iter().filter(|other| sheet.is_near(other, slack));
    for other in near().filter(|other| sheet.is_opposite(other, slack)) {
        cells = (cells.into_iter())
            .flat_map(|cell| {
                let (inside, outside) = cell.parted_by(&other.polygon, slack);
                outside.into_iter().chain(inside)
            })
            .collect();
    }
    for ends in near().filter_map(|other| crossing(&sheet.polygon, &other.polygon, slack)) {
        let across = sheet
            .polygon
            .normal
            .cross(ends[1] - ends[0])
            .normalize_or_zero();
        cells = (cells.into_iter())
            .flat_map(|cell| match passes(&cell, ends, slack) {
                true => [across, -across]
                    .into_iter()
                    .filter_map(|side| {
                        cell.clone()
                            .in_front_of(&Polygon::plane(ends[0], side), slack)
                    })
                    .collect(),
                false => vec![cell],
            })
            .collect();
    }
    cells
}

/// From where to where a polygon meets the plane of another, where that is not in a point.
fn crossing(of: &Polygon, other: &Polygon, slack: f64) -> Option<[DVec3; 2]> {
    let height = |corner: DVec3| of.normal.dot(corner - of.corners[0]);
    let direction = of.normal.cross(other.normal).try_normalize()?;
    let mut ends = [
        (f64::INFINITY, DVec3::ZERO),
        (f64::NEG_INFINITY, DVec3::ZERO),
    ];
    let mut meet = |point: DVec3| {
        let along = direction.dot(point);
        if along < ends[0].0 {
            ends[0] = (along, point);
        }
        if along > ends[1].0 {
            ends[1] = (along, point);
        }
    };
    let mut is_in_plane = true;
    for [from, to] in other.edges() {
        let [start, end] = [from, to].map(height);
        is_in_plane &= start.abs() <= slack;
        if start.abs() <= slack {
            meet(from);
        } else if end.abs() > slack && (start > 0.0) != (end > 0.0) {
            meet(from + start / (start - end) * (to - from));
        }
    }
    (!is_in_plane && ends[1].0 - ends[0].0 > slack).then_some(ends.map(|(_, point)| point))
}

/// Whether a line in the plane of a convex polygon runs through its inside.
fn passes(polygon: &Polygon, [from, to]: [DVec3; 2], slack: f64) -> bool {
    let (mut start, mut end) = (0.0, 1.0);
    for [a, b] in polygon.edges() {
        let inward = polygon.normal.cross(b - a).normalize_or_zero();
        let [depth, rise] = [inward.dot(from - a) - slack, inward.dot(to - from)];
        let at = -depth / rise;
        match rise {
            _ if rise.abs() <= slack && depth <= 0.0 => return false,
            _ if rise.abs() <= slack => {}
            _ if rise > 0.0 => start = at.max(start),
            _ => end = at.min(end),
        }
    }
    (end - start) * from.distance(to) > slack
}
