//! Integrals that rounding keeps from their tolerance end all the same.

use super::*;

fn factors(corners: [Vec<DVec3>; 2]) -> [f64; 3] {
    let [i, j] = [polygon(&corners[0]), polygon(&corners[1])];
    let none = &mut Unrecorded;
    let Some([i, j]) = facing(i, j) else {
        return [0.0; 3];
    };
    [
        auto::exchange(&i, &j, 1e-6, &mut 0, none),
        contour::exchange(&i, &j, 1e-9 * i.area.min(j.area), none),
        element_to_polygon::adaptive_exchange(&i, &j, 1e-7, &mut 0, none),
    ]
}

#[test]
fn triangles_that_bend_by_next_to_nothing_exchange_next_to_nothing() {
    for bend in [1e-12, 1e-10, 1e-8, 1e-6, 1e-4] {
        let [a, b, c] = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0)];
        let d = DVec3::new(0.0, 1.0, bend);
        for f in factors([vec![a, b, c], vec![a, c, d]]) {
            assert!((0.0..1e-4).contains(&f), "{bend}: {f}");
        }
    }
}

#[test]
fn corners_as_sharp_as_needles_are_found_their_light() {
    for size in [1e-8, 1e-30, 6.424_161_190_722_158e-44, 1e-300] {
        let needle = vec![
            DVec3::ZERO,
            DVec3::new(3.0, 0.0, 5.0),
            DVec3::new(3.0, 2.0, 0.0),
            DVec3::splat(size),
        ];
        let wall = [[0.0, 2.4], [0.0, 0.0], [2.0, 0.0], [2.0, 2.4]];
        let wall = wall.map(|[y, z]| DVec3::new(0.0, y, z)).to_vec();
        let blunt = factors([needle[..3].to_vec(), wall.clone()]);
        for (f, right) in factors([needle, wall]).into_iter().zip(blunt) {
            assert!((f / right - 1.0).abs() < 1e-5, "{size}: {f} for {right}");
        }
    }
}
