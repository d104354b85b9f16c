//! Squares, rectangles and discs in front of each other, and their form factors in closed form.

use super::case::{Measured, Ran};
use super::scenes::scene;
use crate::algorithms::form_factor::hemicube::Hemicubes;
use crate::algorithms::form_factor::polygon::Polygon;
use crate::algorithms::form_factor::{FormFactors, Method, auto, facing};
use crate::record::Unrecorded;
use crate::scene::Scene;
use crate::scene::patches::Patches;
use glam::DVec3;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

pub const X: DVec3 = DVec3::X;
pub const Y: DVec3 = DVec3::Y;
pub const Z: DVec3 = DVec3::Z;

/// What is asked of the method that chooses by itself.
pub const EXACT: f64 = 1e-9;

/// Unit squares at distance 1, and with a common edge at a right angle.
pub const OPPOSITE: f64 = 0.199_824_895_698_387_38;
pub const ADJACENT: f64 = 0.200_043_776_075_403_15;

pub fn relative(found: f64, exact: f64) -> Result<Ran, String> {
    Ok(Measured::relative(found, exact).into())
}

pub fn square(origin: DVec3, along: DVec3, across: DVec3) -> [DVec3; 4] {
    [
        origin,
        origin + along,
        origin + along + across,
        origin + across,
    ]
}

/// Unit squares with the common edge X.
pub fn fold(degrees: f64) -> [[DVec3; 4]; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [
        square(DVec3::ZERO, X, Y),
        square(DVec3::ZERO, cos * Y + sin * Z, X),
    ]
}

pub fn folded(degrees: f64) -> f64 {
    let [i, j] = fold(degrees);
    between(&i, &j, EXACT)
}

pub fn parallel(distance: f64) -> f64 {
    let (below, above) = (square(DVec3::ZERO, X, Y), square(distance * Z, Y, X));
    between(&below, &above, EXACT)
}

/// A convex planar polygon.
fn polygon(corners: &[DVec3]) -> Option<Polygon<'_>> {
    let &[a, b, c, ..] = corners else {
        return None;
    };
    let normal = (b - a).cross(c - a).normalize_or_zero();
    Polygon::new(corners.into(), normal)
}

/// What `exchange` says of the parts of two polygons that face each other, and the area of the first; none where none do.
fn facing_parts(
    i: &[DVec3],
    j: &[DVec3],
    exchange: impl FnOnce(&Polygon, &Polygon) -> f64,
) -> Option<[f64; 2]> {
    let (i, j) = (polygon(i)?, polygon(j)?);
    let area = i.area;
    let [i, j] = facing(i, j)?;
    Some([exchange(&i, &j), area])
}

/// F from the first polygon to the second, by the method that chooses by itself.
pub fn between(i: &[DVec3], j: &[DVec3], tolerance: f64) -> f64 {
    let found = facing_parts(i, j, |i, j| {
        auto::exchange(i, j, tolerance, &mut 0, &mut Unrecorded)
    });
    found.map_or(0.0, |[exchange, area]| exchange / area)
}

/// What one method finds of folded squares.
pub fn by(degrees: f64, exchange: impl FnOnce(&Polygon, &Polygon) -> f64) -> Result<Ran, String> {
    let exact = if degrees == 90.0 {
        ADJACENT
    } else {
        0.619_028_323_090_803_3
    };
    let [i, j] = fold(degrees);
    let [found, area] =
        facing_parts(&i, &j, exchange).ok_or("the squares do not face each other")?;
    relative(found / area, exact)
}

/// Parallel unit squares, as printed in textbooks (Howell C-11 with X = Y = 1/d).
pub fn textbook(d: f64) -> f64 {
    let x = 1.0 / d;
    let root = (1.0 + x * x).sqrt();
    let logarithm = 0.5 * ((1.0 + x * x) * (1.0 + x * x) / (1.0 + 2.0 * x * x)).ln();
    2.0 / (PI * x * x) * (logarithm + 2.0 * x * root * (x / root).atan() - 2.0 * x * x.atan())
}

/// Parallel unit squares far away.
pub fn far(d: f64) -> f64 {
    (1.0 - 2.0 / (3.0 * d * d)) / (PI * d * d)
}

/// Perpendicular rectangles with a common edge of length 1, `w` and `h` wide (Howell C-14).
pub fn perpendicular(w: f64, h: f64) -> f64 {
    let (w2, h2) = (w * w, h * h);
    let root = (w2 + h2).sqrt();
    let all = 1.0 + w2 + h2;
    let logarithm = ((1.0 + w2) * (1.0 + h2) / all).ln()
        + w2 * (w2 * all / ((1.0 + w2) * (w2 + h2))).ln()
        + h2 * (h2 * all / ((1.0 + h2) * (h2 + w2))).ln();
    let arcs = w * (1.0 / w).atan() + h * (1.0 / h).atan() - root * (1.0 / root).atan();
    (arcs + 0.25 * logarithm) / (PI * w)
}

/// Coaxial regular polygons of n sides, radius and distance 1.
pub fn discs(n: u32) -> f64 {
    let disc = |z: f64, sense: f64| -> Vec<DVec3> {
        let angles = (0..n).map(|k| f64::from(k) * sense * TAU / f64::from(n) + FRAC_PI_4);
        angles
            .map(|phi| DVec3::new(phi.cos(), phi.sin(), z))
            .collect()
    };
    between(&disc(0.0, 1.0), &disc(1.0, -1.0), 1e-8)
}

/// A closed unit cube seen from inside, its walls divided n × n: the first two are opposite ones, at z = 0 and 1.
pub fn enclosure(more: &str, n: u32, by: f64) -> Result<Scene, String> {
    let walls = [
        [0, 1, 3, 2],
        [5, 4, 6, 7],
        [4, 0, 2, 6],
        [1, 5, 7, 3],
        [4, 5, 1, 0],
        [2, 3, 7, 6],
    ];
    let wall = |(number, corners): (usize, &[usize; 4])| {
        let corners = corners.map(|corner| [0, 1, 2].map(|axis| by + (corner >> axis & 1) as f64));
        format!(
            r#"{{ "name": "{number}", "material": "m", "polygon": {{ "vertices": {corners:?} }}, "patches": {n} }}"#
        )
    };
    let walls: Vec<String> = walls.iter().enumerate().map(wall).collect();
    scene(&format!(
        r#"{{ "schema": 1, "materials": {{ "m": {{}} }}, "objects": [ {}{more} ] }}"#,
        walls.join(",")
    ))
}

pub fn hemicube(resolution: u32, points: u32) -> Result<Ran, String> {
    let patches = Patches::of(&enclosure("", 1, 0.0)?, 1000).map_err(|error| error.to_string())?;
    let method = Method::Hemicube(Hemicubes { resolution, points });
    let found = FormFactors::new(&patches, method, None).pair(0, 1, &mut Unrecorded);
    relative(found, OPPOSITE)
}
