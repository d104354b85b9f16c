//! Light through an opening in a plate: behind it lies a lid so wide that all of it arrives there.

use super::*;

/// A plane by a point and two vectors in it.
type Plane = ([f64; 3], [[f64; 3]; 2]);

const LEVEL: [[f64; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];

fn assert_passes(
    name: &str,
    emitter: Corners,
    (origin, axes): Plane,
    hole: [[f64; 2]; 2],
    wide: f64,
) {
    let of_lid = [-wide, 1.0 + wide];
    // Seen from below.
    let opening = parallelogram(origin, axes, hole);
    let right = exact::exchange(&emitter, &opening);
    let mut polygons = vec![emitter, lid(of_lid, 1.0, of_lid)];
    let plate = around(hole, [[-wide, 1.0 + wide]; 2]);
    polygons.extend(plate.map(|part| parallelogram(origin, axes, part)));
    assert_exchange(name, &polygons, right);
}

#[test]
fn a_square_hole_passes_what_reaches_it() {
    let half_way = ([0.0, 0.5, 0.0], LEVEL);
    for (low, high) in [(0.25, 0.75), (0.5, 0.55), (0.0, 0.1), (0.5, 0.502)] {
        let name = format!("hole {low} to {high}");
        assert_passes(
            &name,
            floor(UNIT, 0.0, UNIT),
            half_way,
            [[low, high]; 2],
            4.0,
        );
    }
}

#[test]
fn a_hole_of_two_thousandths_passes_what_reaches_it_from_a_patch_beneath() {
    let plane = ([0.0, 0.5, 0.0], LEVEL);
    let beneath = floor([0.48, 0.5], 0.48, [0.48, 0.5]);
    assert_passes("pinhole", beneath, plane, [[0.49, 0.492]; 2], 40.0);
}

#[test]
fn a_slit_of_two_thousandths_passes_what_reaches_it() {
    for (y, x) in [(0.5, 0.499), (0.2, 0.1)] {
        let plane = ([0.0, y, 0.0], LEVEL);
        let name = format!("slit at {x}, {y} high");
        assert_passes(
            &name,
            floor(UNIT, 0.0, UNIT),
            plane,
            [[x, x + 0.002], UNIT],
            8.0,
        );
    }
}

#[test]
fn a_hole_in_a_plate_aslant_passes_what_reaches_it() {
    for degrees in [20.0_f64, -35.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        // About a line across the middle, as far as the plate stays between floor and lid.
        let aslant = ([0.5, 0.5, 0.0], [[cos, sin, 0.0], [0.0, 0.0, 1.0]]);
        let hole = [[-0.1, 0.15], [0.2, 0.6]];
        let opening = parallelogram(aslant.0, aslant.1, hole);
        let emitter = floor(UNIT, 0.0, UNIT);
        let right = exact::exchange(&emitter, &opening);
        let of_plate = [[-0.49 / sin.abs(), 0.49 / sin.abs()], [-40.0, 41.0]];
        let mut polygons = vec![emitter, lid([-40.0, 41.0], 1.0, [-40.0, 41.0])];
        polygons.extend(around(hole, of_plate).map(|part| parallelogram(aslant.0, aslant.1, part)));
        // Nothing passes under its lower end, nor under the higher one to the lid beyond.
        for [x, y] in of_plate[0].map(|u| [0.5 + u * cos, 0.5 + u * sin]) {
            let closed = if y < 0.5 { [0.0, y] } else { UNIT };
            polygons.push(wall(x, closed, [-40.0, 41.0]));
        }
        assert_exchange(&format!("aslant by {degrees}"), &polygons, right);
    }
}

#[test]
fn a_round_hole_passes_what_reaches_it_from_a_disc() {
    let sides = 24;
    let circle = |radius: f64, y: f64| -> Corners {
        let at = |k: u32| {
            let (sin, cos) = (f64::from(k) / f64::from(sides) * std::f64::consts::TAU).sin_cos();
            [radius * cos, y, radius * sin]
        };
        (0..sides).map(at).collect()
    };
    for (radius, y) in [(0.4, 0.5), (0.05, 0.3)] {
        // Around the y axis from x to z: seen from below.
        let opening = circle(radius, y);
        let disc = turned(circle(1.0, 0.0));
        let right = exact::exchange(&disc, &opening);
        let outer = circle(20.0, y);
        let mut polygons = vec![disc, lid([-30.0, 30.0], 1.0, [-30.0, 30.0])];
        polygons.extend((0..sides as usize).map(|k| {
            let next = (k + 1) % sides as usize;
            vec![opening[k], opening[next], outer[next], outer[k]]
        }));
        assert_exchange(&format!("round hole of {radius}"), &polygons, right);
    }
}
