use super::*;
use crate::algorithms::fixtures::{self, Cuboid};
use crate::scene::Scene;

/// The faces of the box from `low` to `high`, n × n patches each, seen from inside or outside.
fn faces(name: &str, low: [f64; 3], high: [f64; 3], n: u32, is_room: bool) -> Vec<String> {
    let cuboid = Cuboid { low, high };
    match is_room {
        true => cuboid.room(name, [n; 6]),
        false => cuboid.block(name, n),
    }
}

fn scene(objects: &[String]) -> Scene {
    fixtures::scene("", objects)
}

fn patches(scene: &Scene) -> Patches {
    Patches::of(scene, 100_000).unwrap()
}

fn report_of(patches: &Patches, matrix: &[f64]) -> Report {
    Report::of(&patches.areas(), matrix, &vec![true; patches.len()])
}

fn enclosure(n: u32) -> Scene {
    scene(&faces("wall", [0.0; 3], [1.0; 3], n, true))
}

#[test]
fn rows_of_a_closed_cube_sum_to_1() {
    let patches = patches(&enclosure(4));
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let matrix = FormFactors::new(&patches, Method::Auto { tolerance }, None).matrix();
        let report = report_of(&patches, &matrix);
        assert!(report.closure_defect < tolerance, "{report:?}");
        assert!(report.reciprocity_defect < 1e-15);
    }
}

#[test]
fn faces_of_a_unit_cube_exchange_as_the_closed_forms_say() {
    let patches = patches(&enclosure(1));
    let matrix = FormFactors::new(&patches, Method::Auto { tolerance: 1e-9 }, None).matrix();
    for i in 0..6 {
        for j in 0..6 {
            let exact = match i {
                _ if i == j => 0.0,
                _ if i / 2 == j / 2 => 0.19982489569838738,
                _ => 0.20004377607540316,
            };
            assert!((matrix[6 * i + j] - exact).abs() < 1e-9);
        }
    }
}

#[test]
fn far_pairs_by_the_row_are_exact_to_the_tolerance() {
    let patches = patches(&scene(
        &[
            faces("wall", [0.0; 3], [1.0; 3], 8, true),
            vec![
                r#"{"name": "ball", "material": "m", "sphere": {"center": [0.5, 0.5, 0.5], "radius": 0.05}}"#.into(),
                r#"{"name": "t", "material": "m", "polygon": {"vertices": [[0.2,0.3,0.2],[0.2,0.3,0.4],[0.4,0.3,0.2]]}, "patches": 2}"#.into(),
            ],
        ]
        .concat(),
    ));
    let n = patches.len();
    let exact = FormFactors::new(&patches, Method::Auto { tolerance: 1e-10 }, None);
    let loose = FormFactors::new(&patches, Method::Auto { tolerance: 1e-3 }, None);
    let (mut row, mut right) = (vec![0.0; n], vec![0.0; n]);
    let mut worst = 0.0_f64;
    for i in (0..n).step_by(7) {
        loose.row(i, &mut row);
        exact.row(i, &mut right);
        for j in 0..n {
            if right[j] == 0.0 {
                assert_eq!(row[j], 0.0, "{i} {j}");
            } else {
                worst = worst.max((row[j] / right[j] - 1.0).abs());
            }
        }
    }
    println!("worst {worst:e}");
    assert!(worst < 1e-3, "{worst}");
}

#[test]
fn a_block_in_a_room_hides_and_nothing_leaks_past_it() {
    let enclosure = scene(
        &[
            faces("wall", [0.0; 3], [1.0; 3], 6, true),
            faces("block", [0.3, 0.2, 0.3], [0.7, 0.6, 0.7], 3, false),
        ]
        .concat(),
    );
    let patches = patches(&enclosure);
    let blockers = Blockers::of(&enclosure, &patches);
    let method = Method::Auto { tolerance: 1e-6 };
    let matrix = FormFactors::new(&patches, method, Some(&blockers)).matrix();
    let report = report_of(&patches, &matrix);
    println!("{report:?}");
    assert!(report.closure_defect < 0.01, "{report:?}");
    // Walls that stand between nothing are not asked.
    assert!(!blockers.can_stand_between(0, 1));
    let open = FormFactors::new(&patches, method, None).matrix();
    assert!(report_of(&patches, &open).row_sums[1] > 1.1);
}

#[test]
fn a_warped_wall_hides_nothing_that_rises_from_it() {
    // A saddle under a shelf: where nothing is said to stand between, no line of sight is blocked.
    let wall = r#"{"name": "saddle", "material": "m", "patches": 4,
        "polygon": {"vertices": [[0, 0, 0], [1, 0, 0.03], [1, 1, 0], [0, 1, 0.03]]}}"#;
    let mut objects = faces("shelf", [0.3, 0.3, 0.4], [0.7, 0.7, 0.5], 2, false);
    objects.extend([
        wall.to_owned(),
        wall.replace("saddle", "lid")
            .replace("0, 0, 0]", "0, 0, 1]")
            .replace("1, 0, 0.03]", "0, 1, 1]")
            .replace("1, 1, 0]", "1, 1, 1]")
            .replace("0, 1, 0.03]", "1, 0, 1]"),
    ]);
    let scene = scene(&objects);
    let patches = patches(&scene);
    let blockers = Blockers::of(&scene, &patches);
    let (mut clear, mut rays) = (0, 0);
    for i in 0..patches.len() {
        for j in 0..i {
            if blockers.can_stand_between(i, j) {
                continue;
            }
            clear += 1;
            let sobol = super::super::sobol::Sobol::new(7);
            for index in 0..32 {
                let [s, t, u, v] = sobol.point(index);
                let x = super::super::sample::at(&patches, i, [s, t]);
                let y = super::super::sample::at(&patches, j, [u, v]);
                let [cos_x, cos_y, _] =
                    super::super::area_to_area::cosines(x.point, x.normal, y.point, y.normal);
                if cos_x > 0.0 && cos_y > 0.0 {
                    rays += 1;
                    assert!(!blockers.stand_between(&x, &y), "{i} {j}");
                }
            }
        }
    }
    // And that is said of many: of most pairs of saddle and lid that the shelf does not part.
    assert!(clear > 300 && rays > 2000, "{clear} {rays}");
}

#[test]
fn facets_of_a_sphere_do_not_hide_each_other_from_outside() {
    let objects = [
        faces("wall", [-1.0; 3], [1.0; 3], 4, true),
        vec![
            r#"{"name": "ball", "material": "m", "sphere": {"center": [0, 0, 0], "radius": 0.5}}"#
                .into(),
        ],
    ]
    .concat();
    let scene = scene(&objects);
    let patches = patches(&scene);
    let blockers = Blockers::of(&scene, &patches);
    let method = Method::Auto { tolerance: 1e-6 };
    let factors = FormFactors::new(&patches, method, Some(&blockers));
    let mut row = vec![0.0; patches.len()];
    for i in 0..patches.len() {
        factors.row(i, &mut row);
        let sum: f64 = row.iter().sum();
        assert!((sum - 1.0).abs() < 0.01, "{i}: {sum}");
        if i >= 96 {
            // Convex: nothing hides a wall from a facet that faces it, and rows are exact.
            assert!((sum - 1.0).abs() < 1e-3, "{i}: {sum}");
        }
    }
}

#[test]
fn an_object_that_casts_no_shadow_hides_nothing() {
    let text = |shadow: bool| {
        let mut objects = faces("wall", [0.0; 3], [1.0; 3], 1, true);
        objects.push(format!(
            r#"{{"name": "screen", "material": "m", "casts_shadow": {shadow}, "polygon": {{"vertices": [[0,0,0.5],[1,0,0.5],[1,1,0.5],[0,1,0.5]]}}}}"#
        ));
        objects
    };
    for (shadow, expected) in [(true, 0.0), (false, 0.19982489569838738)] {
        let scene = scene(&text(shadow));
        let patches = patches(&scene);
        let blockers = Blockers::of(&scene, &patches);
        for (method, error) in [
            (Method::Auto { tolerance: 1e-6 }, 1e-6),
            (
                Method::MonteCarlo {
                    rays: 1 << 12,
                    seed: 1,
                },
                0.01,
            ),
            (
                Method::Hemicube(Hemicubes {
                    resolution: 64,
                    points: 4,
                }),
                0.01,
            ),
        ] {
            let factors = FormFactors::new(&patches, method, Some(&blockers));
            let found = factors.pair(0, 1, &mut Unrecorded);
            assert!(
                (found - expected).abs() < error,
                "{shadow} {method:?}: {found}"
            );
        }
    }
}

#[test]
fn sampled_methods_come_near_and_close_the_cube() {
    let patches = patches(&enclosure(2));
    let n = patches.len();
    let exact = FormFactors::new(&patches, Method::Auto { tolerance: 1e-9 }, None).matrix();
    for (method, error, closure) in [
        (
            Method::MonteCarlo {
                rays: 1 << 12,
                seed: 3,
            },
            0.01,
            1e-12,
        ),
        (
            Method::Hemicube(Hemicubes {
                resolution: 128,
                points: 4,
            }),
            0.01,
            1e-3,
        ),
    ] {
        let factors = FormFactors::new(&patches, method, None);
        let matrix = factors.matrix();
        let worst = (0..n * n)
            .map(|k| (matrix[k] - exact[k]).abs())
            .fold(0.0, f64::max);
        let report = report_of(&patches, &matrix);
        println!("{method:?}: off by {worst:e}, {report:?}");
        assert!(worst < error, "{method:?}: {worst}");
        assert!(report.closure_defect < closure, "{method:?}: {report:?}");
        assert_eq!(factors.pair(0, 5, &mut Unrecorded), matrix[5]);
    }
}

#[test]
fn a_hemicube_at_the_centre_does_not_improve_with_the_resolution() {
    let patches = patches(&enclosure(1));
    let error = |resolution, points| {
        let method = Method::Hemicube(Hemicubes { resolution, points });
        let found = FormFactors::new(&patches, method, None).pair(0, 1, &mut Unrecorded);
        (found / 0.19982489569838738 - 1.0).abs()
    };
    assert!(error(64, 1) > 0.15 && error(256, 1) > 0.15);
    assert!(error(64, 4) < 0.02);
}

#[test]
fn blocks_of_rows_make_the_matrix() {
    let patches = patches(&enclosure(3));
    let n = patches.len();
    let factors = FormFactors::new(&patches, Method::Auto { tolerance: 1e-6 }, None);
    let mut matrix = vec![0.0; n * n];
    for (number, block) in matrix.chunks_mut(7 * n).enumerate() {
        let rows = 7 * number..n.min(7 * number + 7);
        factors.block(rows, block);
    }
    factors.complete(&mut matrix);
    assert_eq!(matrix, factors.matrix());
    let mut row = vec![0.0; n];
    factors.row(20, &mut row);
    for j in 0..n {
        assert!((row[j] - matrix[20 * n + j]).abs() < 1e-9);
    }
}
