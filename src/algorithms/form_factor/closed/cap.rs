//! Caps: what closes the rim of a block that has no face where it stands.

use super::super::polygon::Polygon;
use super::rim::Edge;
use super::{Cell, Sheet};
use glam::DVec3;
use std::f64::consts::TAU;

/// The normals of the surfaces that have an edge there.
pub fn normals_at(edge: &Edge, sheets: &[Sheet], slack: f64) -> Vec<DVec3> {
    let middle = edge.ends[0].midpoint(edge.ends[1]);
    let is_at = |[a, b]: [DVec3; 2]| {
        let along = (b - a).normalize_or_zero();
        let at = along.dot(middle - a);
        (0.0..=a.distance(b)).contains(&at) && middle.distance(a + at * along) <= 4.0 * slack
    };
    let polygons = sheets.iter().map(|sheet| &sheet.polygon);
    let with_edge = polygons.filter(|polygon| polygon.edges().any(is_at));
    with_edge.map(|polygon| polygon.normal).collect()
}

/// Caps the cells that the rim of what stands on them goes around once, counter-clockwise seen from their front, and returns the caps. Beside
/// the edges of the rim are the normals of the surfaces that end there.
pub fn cap(cells: &mut [Cell], rim: &[(Edge, Vec<DVec3>)], slack: f64) -> Vec<Polygon<'static>> {
    let mut caps = Vec::new();
    for cell in cells {
        let polygon = &cell.sheet.polygon;
        let in_plane = |end: &DVec3| polygon.normal.dot(*end - polygon.corners[0]).abs() <= slack;
        let angle = |edge: &Edge| {
            let [a, b] = edge.ends.map(|end| end - polygon.center);
            let angle = polygon.normal.dot(a.cross(b)).atan2(a.dot(b));
            f64::from(edge.passes) * angle
        };
        let stands = |normal: &DVec3| normal.cross(polygon.normal).length() > 1e-6;
        let around = rim
            .iter()
            .filter(|(edge, normals)| edge.ends.iter().all(in_plane) && normals.iter().all(stands));
        let turns = around.map(|(edge, _)| angle(edge)).sum::<f64>() / TAU;
        // Where a block stands in a corner, its rim leaves the plane along the line in which the two walls meet.
        if turns.round() == 1.0 {
            let reversed: Vec<DVec3> = polygon.corners.iter().rev().copied().collect();
            cell.is_capped = true;
            caps.extend(Polygon::new(reversed.into(), -polygon.normal));
        }
    }
    caps
}
