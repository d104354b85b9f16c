use super::*;
use glam::DMat3;
use std::f64::consts::{FRAC_PI_4, PI};

const X: DVec3 = DVec3::X;
const Y: DVec3 = DVec3::Y;
const Z: DVec3 = DVec3::Z;

/// Unit squares facing each other, by their distance (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11).
const PARALLEL: [(f64, f64); 4] = [
    (0.1, 0.8269945223972566),
    (1.0, 0.19982489569838738),
    (100.0, 3.18288667328292e-05),
    (1000.0, 3.183096739773803e-07),
];

/// Unit squares with a common edge, by their angle in degrees (C-16).
const FOLDED: [(f64, f64); 3] = [
    (30.0, 0.6190283230908032),
    (90.0, 0.20004377607540316),
    (150.0, 0.02134532541268937),
];

fn folded(degrees: f64) -> [[DVec3; 4]; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [
        parallelogram(DVec3::ZERO, X, Y),
        parallelogram(DVec3::ZERO, cos * Y + sin * Z, X),
    ]
}

#[test]
fn parallel_and_folded_squares_are_exact_to_the_tolerance() {
    for tolerance in [1e-3, 1e-6, 1e-9] {
        for (distance, exact) in PARALLEL {
            let below = parallelogram(DVec3::ZERO, X, Y);
            let above = parallelogram(distance * Z, Y, X);
            let found = automatic(&below, &above, tolerance);
            assert!(
                (found / exact - 1.0).abs() < tolerance,
                "{distance}: {found}"
            );
        }
        for (degrees, exact) in FOLDED {
            let [i, j] = folded(degrees);
            let found = automatic(&i, &j, tolerance);
            assert!(
                (found / exact - 1.0).abs() < tolerance,
                "{degrees}: {found}"
            );
        }
    }
}

/// Coaxial discs of radius r at distance r: F = 2(r₂/r₁)² / (S + √(S² − 4(r₂/r₁)²)), S = 1 + (1 + R₂²)/R₁² = 3 (C-41).
#[test]
fn discs_are_the_limit_of_regular_polygons() {
    let exact = 2.0 / (3.0 + 5.0_f64.sqrt());
    let of_sides = |n: u32| {
        let disc = |z: f64, sense: f64| -> Vec<DVec3> {
            let corner = |k| f64::from(k) * sense * 2.0 * PI / f64::from(n);
            let corners = (0..n).map(corner);
            corners
                .map(|phi| DVec3::new(phi.cos(), phi.sin(), z))
                .collect()
        };
        automatic(&disc(0.0, 1.0), &disc(1.0, -1.0), 1e-9)
    };
    // The error of n sides falls like 1/n²: two of them give the limit to the fourth order (Richardson).
    let limit = (4.0 * of_sides(128) - of_sides(64)) / 3.0;
    assert!((limit / exact - 1.0).abs() < 1e-6, "{limit}");
}

#[test]
fn where_the_squares_stand_makes_no_difference() {
    let turn = DMat3::from_rotation_x(0.3) * DMat3::from_rotation_y(1.0);
    for (degrees, exact) in FOLDED {
        for scale in [1e-6, 1.0, 1e6] {
            let moved = |p: DVec3| scale * (turn * p + DVec3::new(0.3, 4.0, 1.0));
            let [i, j] = folded(degrees).map(|square| square.map(moved));
            let found = automatic(&i, &j, 1e-9);
            assert!((found / exact - 1.0).abs() < 1e-9, "{degrees}: {found}");
        }
    }
}

#[test]
fn each_method_converges_on_squares_at_distance_1() {
    let exact = PARALLEL[1].1;
    let (i, j) = (parallelogram(DVec3::ZERO, X, Y), parallelogram(Z, Y, X));
    let (i, j) = (polygon(&i), polygon(&j));
    let none = &mut Unrecorded;
    for (found, most) in [
        (area_to_area::exchange(&i, &j, [8, 8], none), 1e-9),
        (element_to_polygon::exchange(&i, &j, 8, &mut 0, none), 1e-9),
        (
            element_to_polygon::adaptive_exchange(&i, &j, 1e-8, &mut 0, none),
            1e-8,
        ),
        (contour::exchange(&i, &j, 1e-13, none), 1e-12),
    ] {
        assert!((found / exact - 1.0).abs() < most, "{found}");
    }
}

/// From an element to a parallel rectangle of unit sides at distance 1 whose corner lies above it (Howell B-3):
/// (1/2π)·2·(1/√2)·atan(1/√2) with a = b = c = 1.
#[test]
fn an_element_sees_a_corner_rectangle_as_the_closed_form_says() {
    let exact = (0.5_f64.sqrt()).atan() / (PI * 2.0_f64.sqrt());
    assert!((exact - 0.138531605994893).abs() < 1e-16);
    let small = 1e-4;
    let element = parallelogram(-0.5 * small * (X + Y), small * X, small * Y);
    let rectangle = parallelogram(Z, Y, X);
    let found = automatic(&element, &rectangle, 1e-9);
    // The element is not quite a point: by symmetry its size enters with its square.
    assert!((found / exact - 1.0).abs() < 1e-8, "{found}");
}

/// An element below the middle of a half-infinite wall sees a quarter turn of it: with the wall reaching below its horizon or not.
#[test]
fn what_lies_below_the_horizon_is_not_seen() {
    let element = parallelogram(DVec3::ZERO, 1e-3 * X, 1e-3 * Y);
    let wall = |low: f64| parallelogram(-4.0 * X + low * Z - Y, 8.0 * X, (3.0 - low) * Z);
    let (whole, above) = (wall(-5.0), wall(0.0));
    let flipped = |mut corners: [DVec3; 4]| {
        corners.reverse();
        corners
    };
    let found = [whole, above].map(|wall| {
        automatic(&element, &wall, 1e-9).max(automatic(&element, &flipped(wall), 1e-9))
    });
    assert!(found[1] > 0.1);
    assert!((found[0] / found[1] - 1.0).abs() < 1e-9, "{found:?}");
}

#[test]
fn nothing_is_exchanged_in_one_plane_or_between_backs() {
    let i = parallelogram(DVec3::ZERO, X, Y);
    assert_eq!(automatic(&i, &parallelogram(X, X, Y), 1e-6), 0.0);
    assert_eq!(automatic(&i, &parallelogram(Z, X, Y), 1e-6), 0.0);
    assert_eq!(automatic(&i, &parallelogram(-Z, Y, X), 1e-6), 0.0);
    let turn = DMat3::from_rotation_x(0.7) * DMat3::from_rotation_z(0.4);
    let turned = |square: [DVec3; 4]| square.map(|p| turn * p + DVec3::splat(0.1));
    assert_eq!(
        automatic(&turned(i), &turned(parallelogram(X, X, Y)), 1e-6),
        0.0
    );
}

/// Two plates of one long edge: F of the fold is 1 − sin(α/2) where the plates are long without end (crossed strings, Hottel 1954).
#[test]
fn a_long_fold_of_1_degree_follows_crossed_strings() {
    let (sin, cos) = 1.0_f64.to_radians().sin_cos();
    let long = 1e6;
    let found = automatic(
        &parallelogram(DVec3::ZERO, long * X, Y),
        &parallelogram(DVec3::ZERO, cos * Y + sin * Z, long * X),
        1e-9,
    );
    let exact = 1.0 - 0.5_f64.to_radians().sin();
    // What leaves at the two ends is of the order of the gap over the length.
    assert!((found - exact).abs() < 1e-7, "{found} {exact}");
    let right = automatic(
        &parallelogram(DVec3::ZERO, long * X, Y),
        &parallelogram(DVec3::ZERO, Z, long * X),
        1e-9,
    );
    assert!((right - (1.0 - FRAC_PI_4.sin())).abs() < 1e-6, "{right}");
}

/// Areas 1 : 10⁸, touching at a corner: perpendicular rectangles with a common edge exchange as in the closed form of Hamilton & Morgan
/// 1952, here by the crossed strings of one small strip seen from the corner: reciprocity, and the limit of an element at the edge.
#[test]
fn areas_of_one_to_a_hundred_million_keep_reciprocity() {
    let floor = parallelogram(DVec3::ZERO, X, Y);
    let small = parallelogram(0.5 * X, 1e-4 * Z, 1e-4 * X);
    let [there, back] = [
        automatic(&floor, &small, 1e-9),
        automatic(&small, &floor, 1e-9),
    ];
    assert!((there * 1e8 / back - 1.0).abs() < 1e-9);
    // An element at the foot of a wall sees half its hemisphere of floor, less what lies beyond the floor's far edges.
    assert!(back > 0.4 && back < 0.5, "{back}");
}
