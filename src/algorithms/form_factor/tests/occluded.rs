//! What stands between: against closed forms and sums of rectangles.

use super::*;
use crate::algorithms::fixtures::Cuboid;
use crate::scene::{Limits, Scene, read};

/// A scene of polygons, each one patch each way.
pub(super) fn scene(polygons: &[(&str, Vec<[f64; 3]>, u32)]) -> Scene {
    let objects: Vec<String> = polygons
        .iter()
        .enumerate()
        .map(|(number, (name, vertices, patches))| {
            format!(
                r#"{{"name": "{name}{number}", "material": "m", "polygon": {{"vertices": {vertices:?}}}, "patches": {patches}}}"#
            )
        })
        .collect();
    let text = format!(
        r#"{{"schema": 1, "materials": {{"m": {{}}}}, "objects": [{}]}}"#,
        objects.join(", ")
    );
    read(text.as_bytes(), &Limits::default(), &mut |_| {
        Err(String::new())
    })
    .unwrap()
}

/// A horizontal rectangle at height `y`, seen from above or from below.
pub(super) fn level(
    name: &'static str,
    [x0, x1]: [f64; 2],
    y: f64,
    [z0, z1]: [f64; 2],
    is_floor: bool,
    patches: u32,
) -> (&'static str, Vec<[f64; 3]>, u32) {
    let mut corners = vec![[x0, y, z0], [x0, y, z1], [x1, y, z1], [x1, y, z0]];
    if !is_floor {
        corners.reverse();
    }
    (name, corners, patches)
}

pub(super) fn estimated(scene: &Scene) -> (Patches, Estimated) {
    let patches = Patches::of(scene, 100_000).unwrap();
    let blockers = Blockers::of(scene, &patches);
    let method = Method::Auto { tolerance: 1e-6 };
    let estimated = FormFactors::new(&patches, method, Some(&blockers)).estimated();
    (patches, estimated)
}

/// F from the first patch to the second.
pub(super) fn first_to_second(polygons: &[(&str, Vec<[f64; 3]>, u32)]) -> f64 {
    let (patches, estimated) = estimated(&scene(polygons));
    assert!(patches.len() > 1);
    estimated.matrix[1]
}

/// A F between parallel rectangles at distance `c`, by the sums of what rectangles from one corner exchange: G(x, y) with x and y the
/// shifts between the sides (Ehlert & Smith 1993, "View factors for perpendicular and parallel rectangular plates").
fn parallel(
    [a1, a2]: [f64; 2],
    [b1, b2]: [f64; 2],
    [p1, p2]: [f64; 2],
    [q1, q2]: [f64; 2],
    c: f64,
) -> f64 {
    let g = |u: f64, v: f64| {
        let (su, sv) = ((u * u + c * c).sqrt(), (v * v + c * c).sqrt());
        (v * su * (v / su).atan() + u * sv * (u / sv).atan()
            - 0.5 * c * c * ((u * u + v * v + c * c) / (c * c)).ln())
            / std::f64::consts::TAU
    };
    let mut sum = 0.0;
    for (a, sa) in [(a1, -1.0), (a2, 1.0)] {
        for (p, sp) in [(p1, -1.0), (p2, 1.0)] {
            for (b, sb) in [(b1, -1.0), (b2, 1.0)] {
                for (q, sq) in [(q1, -1.0), (q2, 1.0)] {
                    sum += sa * sp * sb * sq * g(a - p, b - q);
                }
            }
        }
    }
    sum
}

#[test]
fn the_sum_of_rectangles_is_right_of_unit_squares() {
    let f = parallel([0.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 1.0], 1.0);
    assert!((f - 0.199_824_895_698_387_38).abs() < 1e-14, "{f}");
}

/// Within 1e-4, and within 1 % above 1e-5.
pub(super) fn assert_right(name: &str, found: f64, right: f64) {
    let error = (found - right).abs();
    println!("{name}: {found:e} for {right:e}");
    assert!(error <= 1e-4, "{name}: {found} for {right}");
    assert!(
        right <= 1e-5 || error <= 0.01 * right,
        "{name}: {found} for {right}"
    );
}

#[test]
fn a_wall_from_floor_to_lid_parts_what_rectangles_say() {
    // On either side of the wall floor and lid see all of each other.
    for at in [0.5, 0.3, 0.07] {
        let wall = (
            "wall",
            vec![
                [at, 0.0, -1.0],
                [at, 0.0, 2.0],
                [at, 1.0, 2.0],
                [at, 1.0, -1.0],
            ],
            1,
        );
        let unit = [0.0, 1.0];
        let found = first_to_second(&[
            level("floor", unit, 0.0, unit, true, 1),
            level("lid", unit, 1.0, unit, false, 1),
            wall,
        ]);
        let side = |x: [f64; 2]| parallel(x, unit, x, unit, 1.0);
        assert_right(
            &format!("wall at {at}"),
            found,
            side([0.0, at]) + side([at, 1.0]),
        );
    }
}

#[test]
fn a_card_close_to_the_lid_hides_what_lies_behind_it() {
    let unit = [0.0, 1.0];
    for (x, z) in [
        ([0.2, 0.7], [0.1, 0.6]),
        ([0.0, 1.0], [0.0, 0.5]),
        ([0.499, 0.501], unit),
    ] {
        for (is_above, gap) in [(true, 1e-9), (false, 1e-9)] {
            let y = if is_above { 1.0 - gap } else { gap };
            let found = first_to_second(&[
                level("floor", unit, 0.0, unit, true, 1),
                level("lid", unit, 1.0, unit, false, 1),
                level("card", x, y, z, true, 1),
            ]);
            let whole = parallel(unit, unit, unit, unit, 1.0);
            assert_right(
                &format!("{x:?} {z:?} {is_above}"),
                found,
                whole - parallel(unit, unit, x, z, 1.0),
            );
        }
    }
}

#[test]
fn a_slit_is_seen_and_a_grating_lets_through_its_share() {
    let unit = [0.0, 1.0];
    let plate = |x: [f64; 2]| level("plate", x, 0.5, [-1.0, 2.0], true, 1);
    let slit = first_to_second(&[
        level("floor", unit, 0.0, unit, true, 1),
        level("lid", unit, 1.0, unit, false, 1),
        plate([-1.0, 0.499]),
        plate([0.501, 2.0]),
    ]);
    // From x through the slit to the strip of the lid about 1 − x, twice as wide as the slit.
    let steps = 400;
    let exact: f64 = (0..steps)
        .map(|k| (f64::from(k) + 0.5) / f64::from(steps))
        .map(|x| strip(x, [0.998 - x, 1.002 - x], 1.0) / f64::from(steps))
        .sum();
    assert_right("slit", slit, exact);
}

/// A F a unit of width of a line (x, 0, z), 0 ≤ z ≤ 1, to what the lid at height `c` has between two x.
fn strip(x: f64, [from, to]: [f64; 2], c: f64) -> f64 {
    let (from, to) = (from.clamp(0.0, 1.0), to.clamp(0.0, 1.0));
    let half = 1e-5;
    parallel([x - half, x + half], [0.0, 1.0], [from, to], [0.0, 1.0], c) / (2.0 * half)
}

#[test]
fn a_grating_passes_the_same_light_at_every_division() {
    let unit = [0.0, 1.0];
    let mut passed = Vec::new();
    for side in [1, 2, 4, 8] {
        let mut polygons = vec![
            level("floor", unit, 0.0, unit, true, side),
            level("lid", unit, 4.0, unit, false, side),
        ];
        // Bars of .0475 every .05, 5 % open.
        polygons.extend((-20..40).map(|k| {
            let x = 0.05 * f64::from(k);
            level("bar", [x + 0.00125, x + 0.04875], 2.0, [-2.0, 3.0], true, 1)
        }));
        let (patches, estimated) = estimated(&scene(&polygons));
        let (n, count) = (patches.len(), (side * side) as usize);
        let through: f64 = (0..count)
            .flat_map(|i| (count..2 * count).map(move |j| (i, j)))
            .map(|(i, j)| patches[i].area * estimated.matrix[i * n + j])
            .sum();
        passed.push(through);
    }
    // Each gap shows a strip of the lid, twice as wide as itself.
    let steps = 400;
    let exact: f64 = (0..steps)
        .map(|k| (f64::from(k) + 0.5) / f64::from(steps))
        .flat_map(|x| (-20..40).map(move |k| (x, 0.05 * f64::from(k) - 0.00125)))
        .map(|(x, gap)| strip(x, [2.0 * gap - x, 2.0 * (gap + 0.0025) - x], 4.0) / f64::from(steps))
        .sum();
    for through in &passed {
        assert!((through / exact - 1.0).abs() < 0.01, "{exact} {passed:?}");
    }
}

pub(super) fn box_faces(
    name: &'static str,
    low: [f64; 3],
    high: [f64; 3],
    is_room: bool,
    patches: u32,
) -> Vec<(&'static str, Vec<[f64; 3]>, u32)> {
    let faces = Cuboid { low, high }.corners(!is_room);
    let with_corners = |corners: [[f64; 3]; 4]| (name, corners.to_vec(), patches);
    faces.map(with_corners).to_vec()
}

#[test]
fn nothing_enters_a_sealed_box_and_rows_of_the_room_around_it_sum_to_1() {
    let (low, high) = ([0.3, 0.2, 0.35], [0.6, 0.7, 0.6]);
    let polygons = [
        box_faces("room", [0.0; 3], [1.0; 3], true, 2),
        box_faces("inside", low, high, true, 2),
        box_faces("outside", low, high, false, 2),
    ]
    .concat();
    let (patches, estimated) = estimated(&scene(&polygons));
    let n = patches.len();
    for i in 0..n {
        let row = &estimated.matrix[i * n..][..n];
        let sum: f64 = row.iter().sum();
        assert!((sum - 1.0).abs() < 1e-3, "{i}: {sum}");
        assert!(
            (sum - 1.0).abs() < 2.0 * estimated.row_errors[i] + 1e-6,
            "{i}: {sum}"
        );
        let is_inside = |patch: usize| (24..48).contains(&patch);
        for (j, &f) in row.iter().enumerate() {
            assert!(is_inside(i) == is_inside(j) || f == 0.0, "{i} {j}: {f}");
        }
    }
}

#[test]
fn a_room_with_blocks_that_share_edges_closes() {
    let polygons = [
        box_faces("room", [0.0; 3], [1.0; 3], true, 2),
        box_faces("one", [0.1, 0.05, 0.2], [0.4, 0.6, 0.5], false, 1),
        box_faces("two", [0.4, 0.05, 0.2], [0.7, 0.3, 0.5], false, 1),
    ]
    .concat();
    let (patches, estimated) = estimated(&scene(&polygons));
    let n = patches.len();
    // What the two blocks share looks at the other's back.
    let rows = (0..n).map(|i| (i, estimated.matrix[i * n..][..n].iter().sum::<f64>()));
    for (i, sum) in rows.filter(|&(i, _)| i < 24) {
        assert!((sum - 1.0).abs() < 1e-3, "{i}: {sum}");
    }
}

#[test]
fn rays_agree_with_what_is_clipped() {
    // A card between squares at a distance, and between two that touch.
    let unit = [0.0, 1.0];
    let floor = level("floor", unit, 0.0, unit, true, 1);
    let card = level("card", [0.1, 0.6], 0.4, [0.2, 0.7], true, 1);
    let lid = level("lid", unit, 1.0, unit, false, 1);
    let wall = (
        "wall",
        vec![
            [0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 1.0, 1.0],
            [0.0, 0.0, 1.0],
        ],
        1,
    );
    for other in [lid, wall] {
        let scene = scene(&[floor.clone(), other, card.clone()]);
        let patches = Patches::of(&scene, 10).unwrap();
        let blockers = Blockers::of(&scene, &patches);
        let none = &mut Unrecorded;
        let [exact, _] = blockers.share(&patches, [0, 1], 0.2, false, none);
        let [share, error] = sampled::share(&blockers, &patches, [0, 1], 0.2, none);
        println!("{share} ± {error} for {exact}");
        assert!(exact < 0.9 && error < 0.02, "{exact} {error}");
        assert!(
            (share - exact).abs() < 3.0 * error,
            "{share} ± {error} for {exact}"
        );
    }
}
