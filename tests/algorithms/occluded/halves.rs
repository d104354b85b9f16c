//! What is in the way covers half of a plane of symmetry, and its mirror image the other half.

use super::*;

/// F between unit squares: opposite at distance 1, and at a right angle along an edge.
const OPPOSITE: f64 = 0.199_824_895_698_387_38;
const ADJACENT: f64 = 0.200_043_776_075_403_15;

/// The cells of a checkerboard over the unit square.
fn checkerboard(n: u32) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let side = 1.0 / f64::from(n);
    let span = move |k: u32| [f64::from(k) * side, f64::from(k + 1) * side];
    let all = (0..n).flat_map(move |row| (0..n).map(move |column| (row, column)));
    all.filter(|(row, column)| (row + column) % 2 == 0)
        .map(move |(row, column)| [span(row), span(column)])
}

#[test]
fn a_checkerboard_half_way_passes_half() {
    for n in [2, 4, 8] {
        let mut polygons = vec![floor(UNIT, 0.0, UNIT), lid(UNIT, 1.0, UNIT)];
        polygons.extend(checkerboard(n).map(|[x, z]| floor(x, 0.5, z)));
        assert_exchange(&format!("checkerboard of {n}"), &polygons, 0.5 * OPPOSITE);
    }
}

#[test]
fn a_quadrant_half_way_passes_a_quarter() {
    let ends = [UNIT, WIDE].map(|x| floor([x[0], 0.5], 0.5, WIDE));
    for half in ends {
        let other = floor(WIDE, 0.5, [-1.0, 0.5]);
        let polygons = [floor(UNIT, 0.0, UNIT), lid(UNIT, 1.0, UNIT), half, other];
        assert_exchange("quadrant", &polygons, 0.25 * OPPOSITE);
    }
}

#[test]
fn a_checkerboard_aslant_between_floor_and_wall_passes_half() {
    // In the plane that mirrors the floor into the wall; the cells' mirror image in z covers the other half of it.
    let axes = [[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for n in [2, 4] {
        let mut polygons = vec![floor(UNIT, 0.0, UNIT), wall(0.0, UNIT, UNIT)];
        let stripe = |k: u32| [f64::from(k) / f64::from(n), f64::from(k + 1) / f64::from(n)];
        let cells = (0..n).flat_map(|row| (0..n).map(move |column| (row, column)));
        let cells = cells.filter(|(row, column)| (row + column) % 2 == 0);
        polygons.extend(
            cells.map(|(row, column)| parallelogram([0.0; 3], axes, [stripe(row), stripe(column)])),
        );
        assert_exchange(&format!("aslant, of {n}"), &polygons, 0.5 * ADJACENT);
    }
}
