use super::*;
use crate::numeric::Random;

fn regions(corners: &[[f64; 2]]) -> Option<Vec<Vec<DVec2>>> {
    let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
    match outline(&corners, &mut 100_000) {
        Outline::Simple => None,
        Outline::Crossing(regions) => {
            let at = |place: &Place| {
                let edge = place.edge as usize;
                corners[edge].lerp(corners[(edge + 1) % corners.len()], place.share)
            };
            Some(
                regions
                    .iter()
                    .map(|region| region.iter().map(at).collect())
                    .collect(),
            )
        }
        Outline::TooOften => panic!("too often"),
    }
}

fn area(region: &[DVec2]) -> f64 {
    (0..region.len())
        .map(|i| 0.5 * region[i].perp_dot(region[(i + 1) % region.len()]))
        .sum()
}

fn areas(corners: &[[f64; 2]]) -> Vec<f64> {
    let mut areas: Vec<f64> = regions(corners)
        .unwrap()
        .iter()
        .map(|region| area(region))
        .collect();
    areas.sort_by(f64::total_cmp);
    areas
}

fn is_near(found: &[f64], expected: &[f64]) -> bool {
    found.len() == expected.len()
        && found
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 1e-12)
}

#[test]
fn a_bow_tie_is_two_triangles_and_a_pentagram_five() {
    assert!(is_near(
        &areas(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]),
        &[0.25, 0.25]
    ));
    let tip = |i: u32| {
        let angle = std::f64::consts::TAU * f64::from(2 * i) / 5.0;
        [angle.sin(), angle.cos()]
    };
    let pentagram = [0, 1, 2, 3, 4].map(tip);
    let found = regions(&pentagram).unwrap();
    assert!(
        found
            .iter()
            .all(|region| region.len() == 3 && area(region) > 0.0)
    );
    // A tip: base 2r·tan 36° and height 1 − r of the inner pentagon, whose edges are at r = cos 72°.
    let r = 72_f64.to_radians().cos();
    let expected = r * 36_f64.to_radians().tan() * (1.0 - r);
    assert!(is_near(&areas(&pentagram), &[expected; 5]));
}

#[test]
fn edges_that_meet_at_a_corner_of_another_or_lie_on_each_other_count_as_well() {
    // A figure of eight whose lobes meet at a corner of both
    let eight = [
        [-1.0, 0.0],
        [0.0, 0.5],
        [1.0, 1.0],
        [1.0, 0.0],
        [0.0, 0.5],
        [-1.0, 1.0],
    ];
    assert!(is_near(&areas(&eight), &[0.5, 0.5]));
    // A square run around twice is outside everywhere.
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    assert_eq!(regions(&[square, square].concat()), Some(vec![]));
    // A square, and on its way back over one edge another one inside the first
    let inner = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [0.0, 0.0],
        [0.5, 0.0],
        [0.5, 0.5],
        [0.0, 0.5],
    ];
    assert!(is_near(&areas(&inner), &[0.75]));
}

#[test]
fn what_only_touches_itself_is_simple() {
    let dart = [[0.0, 0.0], [1.0, 0.0], [0.2, 0.2], [0.0, 1.0]];
    assert_eq!(regions(&dart), None);
    let with_hole = [
        [0.0, 0.0],
        [0.9, 0.0],
        [0.9, 0.9],
        [0.0, 0.9],
        [0.0, 0.0],
        [0.2, 0.2],
        [0.2, 0.5],
        [0.5, 0.2],
        [0.2, 0.2],
    ];
    assert_eq!(regions(&with_hole), None);
    let spike = [
        [0.0, 0.0],
        [1.0, 0.0],
        [1.0, 0.5],
        [1.0, 1.0],
        [1.0, 0.5],
        [0.0, 0.5],
    ];
    assert_eq!(regions(&spike), None);
    let touched = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.5, 0.0], [0.0, 1.0]];
    assert_eq!(regions(&touched), None);
    // There and back
    assert_eq!(
        regions(&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [0.0, 1.0]]),
        None
    );
}

fn crossed(outline: &[DVec2], point: DVec2) -> usize {
    (0..outline.len())
        .filter(|&i| {
            let (a, b) = (outline[i], outline[(i + 1) % outline.len()]);
            let is_passed = (a.y > point.y) != (b.y > point.y);
            is_passed && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
        })
        .count()
}

/// Corners on a coarse grid make edges that overlap, and many edges through one point.
#[test]
fn random_polygons_are_filled_where_an_odd_number_of_edges_is_crossed() {
    let mut random = Random(7);
    let mut filled = 0;
    for round in 0..600 {
        let count = 4 + round % 12;
        let cells = [4.0, 1e9][round % 2];
        let mut coordinate = || (random.number() * cells).floor() / cells;
        let corners: Vec<[f64; 2]> = (0..count).map(|_| [coordinate(), coordinate()]).collect();
        let Some(regions) = regions(&corners) else {
            continue;
        };
        filled += regions.len();
        let whole: Vec<DVec2> = corners.iter().copied().map(DVec2::from).collect();
        for _ in 0..50 {
            let point = DVec2::new(random.number(), random.number());
            let around = regions
                .iter()
                .filter(|region| crossed(region, point) % 2 == 1)
                .count();
            assert_eq!(around, crossed(&whole, point) % 2, "{corners:?}, {point}");
        }
    }
    assert!(filled > 1000);
}

#[test]
fn a_polygon_run_around_many_times_takes_no_more_work() {
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    assert_eq!(regions(&square.repeat(100_000)), Some(vec![]));
    assert!(is_near(&areas(&square.repeat(99_999)), &[1.0]));
}

#[test]
fn work_has_a_bound() {
    let corners: Vec<DVec2> = (0..100).map(|i| DVec2::new(0.0, f64::from(i))).collect();
    assert_eq!(outline(&corners, &mut 100), Outline::TooOften);
}
