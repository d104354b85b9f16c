//! What is in the way divides both patches into parts that see all of each other, and parts that see nothing.

use super::*;
use crate::rooms::rectangles::{self, Rectangle};

/// Above the patches and below by next to nothing.
const GAP: f64 = 1e-9;

fn level(y: f64, x: [f64; 2], z: [f64; 2]) -> Rectangle {
    Rectangle {
        axis: 1,
        height: y,
        sides: [x, z],
    }
}

fn upright(y: [f64; 2], z: [f64; 2]) -> Rectangle {
    Rectangle {
        axis: 0,
        height: 0.0,
        sides: [y, z],
    }
}

fn exchange(i: Rectangle, j: Rectangle) -> f64 {
    rectangles::exchange(&i, &j)
}

/// A rectangle across the z axis.
fn across(z: f64, x: [f64; 2], y: [f64; 2]) -> Corners {
    parallelogram([0.0, 0.0, z], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [x, y])
}

fn opposite() -> Vec<Corners> {
    vec![floor(UNIT, 0.0, UNIT), lid(UNIT, 1.0, UNIT)]
}

fn adjacent() -> Vec<Corners> {
    vec![floor(UNIT, 0.0, UNIT), wall(0.0, UNIT, UNIT)]
}

fn parts(cuts: &[f64]) -> Vec<[f64; 2]> {
    let ends = [&[0.0], cuts, &[1.0]].concat();
    ends.windows(2).map(|ends| [ends[0], ends[1]]).collect()
}

#[test]
fn compartments_exchange_with_what_lies_above_them() {
    for (xs, zs) in [
        (vec![0.5], vec![0.3]),
        (vec![0.2, 0.7], vec![0.1, 0.4, 0.9]),
        (vec![0.999], vec![]),
    ] {
        let mut polygons = opposite();
        polygons.extend(xs.iter().map(|&x| wall(x, UNIT, [-0.5, 1.5])));
        polygons.extend(zs.iter().map(|&z| across(z, [-0.5, 1.5], UNIT)));
        let of = |x: &[f64; 2], z: &[f64; 2]| exchange(level(0.0, *x, *z), level(1.0, *x, *z));
        let right = parts(&xs)
            .iter()
            .flat_map(|x| parts(&zs).iter().map(|z| of(x, z)).collect::<Vec<_>>())
            .sum();
        assert_exchange(&format!("walls at {xs:?} and {zs:?}"), &polygons, right);
    }
}

#[test]
fn a_wall_along_the_diagonal_leaves_triangles_above_each_other() {
    let mut polygons = opposite();
    polygons.push(vec![
        [-0.5, 0.0, -0.5],
        [1.5, 0.0, 1.5],
        [1.5, 1.0, 1.5],
        [-0.5, 1.0, -0.5],
    ]);
    let below = vec![[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0]];
    let above = turned(below.iter().map(|&[x, _, z]| [x, 1.0, z]).collect());
    assert_exchange("diagonal", &polygons, 2.0 * exact::exchange(&below, &above));
}

#[test]
fn a_wall_between_floor_and_wall_leaves_what_is_on_its_sides() {
    for zs in [vec![0.3], vec![0.002], vec![0.25, 0.5, 0.75]] {
        let mut polygons = adjacent();
        polygons.extend(zs.iter().map(|&z| across(z, [-0.0, 1.5], [0.0, 1.5])));
        let of = |z: &[f64; 2]| exchange(level(0.0, UNIT, *z), upright(UNIT, *z));
        let right = parts(&zs).iter().map(of).sum();
        assert_exchange(&format!("walls at z = {zs:?}"), &polygons, right);
    }
}

#[test]
fn a_shelf_on_the_wall_hides_what_is_above_it() {
    for y in [0.4, 0.05, 0.002] {
        let mut polygons = adjacent();
        polygons.push(floor([0.0, 1.5], y, [-0.5, 1.5]));
        let right = exchange(level(0.0, UNIT, UNIT), upright([0.0, y], UNIT));
        assert_exchange(&format!("shelf at {y}"), &polygons, right);
    }
}

#[test]
fn a_fence_on_the_floor_hides_what_is_behind_it() {
    for x in [0.3, 0.01] {
        let mut polygons = adjacent();
        polygons.push(wall(x, [0.0, 1.5], [-0.5, 1.5]));
        let right = exchange(level(0.0, [0.0, x], UNIT), upright(UNIT, UNIT));
        assert_exchange(&format!("fence at {x}"), &polygons, right);
    }
}

#[test]
fn a_plate_on_a_wall_shows_of_it_what_is_open() {
    // 5 % open, in slits; and a window in a frame.
    let mut plate = adjacent();
    let mut open = 0.0;
    for k in 0..20 {
        let y = 0.05 * f64::from(k);
        plate.push(wall(GAP, [y + 0.0025, y + 0.05], UNIT));
        open += exchange(level(0.0, UNIT, UNIT), upright([y, y + 0.0025], UNIT));
    }
    assert_exchange("slits on the wall", &plate, open);
    let window = [[0.5, 0.6], [0.2, 0.25]];
    let mut frame = adjacent();
    frame.extend(around(window, [UNIT; 2]).map(|[y, z]| wall(GAP, y, z)));
    let right = exchange(level(0.0, UNIT, UNIT), upright(window[0], window[1]));
    assert_exchange("window", &frame, right);
}

#[test]
fn a_frame_on_the_lid_or_on_the_floor_shows_what_it_frames() {
    for side in [0.5, 0.05, 0.002] {
        let window = [[0.3, 0.3 + side]; 2];
        let right = exchange(level(0.0, UNIT, UNIT), level(1.0, window[0], window[1]));
        for y in [1.0 - GAP, GAP] {
            let mut polygons = opposite();
            polygons.extend(around(window, [UNIT; 2]).map(|[x, z]| floor(x, y, z)));
            let name = format!("frame around {side} at {y}");
            assert_exchange(&name, &polygons, right);
        }
    }
}
