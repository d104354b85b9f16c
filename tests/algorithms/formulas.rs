//! The law of the formulas: what the right side amounts to, computed from the values that the panel shows, is the recorded left
//! side; over the runs of the lessons, and of scenes at random by every method.

use super::rays::scenes::scene;
use super::runs;
use crate::common;
use lightwalk::algorithms::radiosity::Solver;
use lightwalk::panels::evaluated;
use lightwalk::render::Method;
use lightwalk::replay::Run;
use proptest::prelude::*;
use std::collections::BTreeMap;

/// Checks the formulas at every step, and puts down the first fault of each; how many hold.
///
/// A formula is passed over where its right side has no value and it says why (a system's unknowns, an integral). Nothing else may
/// lack a value.
///
/// Both sides agree to 10⁻¹² relative to the numbers that the right side adds and multiplies. Components of a vector are compared
/// relative to the largest one: an algorithm moves a point along a normal, and turns a direction, as a whole, so the rounding of
/// the large components ends up in the small ones.
fn check(run: &Run, what: &str, faults: &mut BTreeMap<&'static str, String>) -> usize {
    let walk = run.walk();
    let mut count = 0;
    for step in 0..walk.len() {
        for evaluated in evaluated(run, step) {
            let formula = evaluated.formula;
            let place = || format!("{what}, step {step}, {}", walk.kind(step));
            match evaluated.holds() {
                Some(true) => count += 1,
                Some(false) => {
                    let (left, right) = (evaluated.left, evaluated.right);
                    let sides = || format!("{}: {left:?} and {right:?}", place());
                    faults.entry(formula.text).or_insert_with(sides);
                }
                None if formula.unevaluated.is_some() => {}
                None => {
                    let unknown = || format!("{}: without a value", place());
                    faults.entry(formula.text).or_insert_with(unknown);
                }
            }
        }
    }
    count
}

#[test]
fn in_every_lesson_both_sides_of_every_formula_agree() {
    let mut faults = BTreeMap::new();
    for (lesson, run) in runs::lessons() {
        let count = check(&run, lesson, &mut faults);
        assert!(count > 10, "{lesson}: {count} formulas");
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

/// What the texture leaves is far less than what it takes away, so the rounding of I_d remains in I.
#[test]
fn under_a_nearly_black_texture_both_sides_of_every_formula_agree() {
    let scene = common::prepared(
        r#"{
            "schema": 1,
            "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
            "lights": [{ "point": { "position": [1, 2, 3], "color": [0.9, 0.7, 0.3] } }],
            "materials": {
                "soot": {
                    "diffuse": [1, 0.9, 0.8],
                    "specular": [1e-9, 1e-9, 1e-9],
                    "shininess": 5,
                    "texture": { "checker": { "colors": [[1e-9, 1e-8, 0], [1e-9, 1e-8, 0]], "scale": 1 } }
                }
            },
            "objects": [{ "name": "ball", "material": "soot", "sphere": { "center": [0, 0, 0], "radius": 1 } }]
        }"#,
        1,
        1,
    )
    .scene
    .clone();
    let mut faults = BTreeMap::new();
    for method in Method::ALL {
        let run = runs::recorded(scene.clone(), method, Solver::Shooting);
        check(&run, method.name(), &mut faults);
    }
    assert!(faults.is_empty(), "{faults:#?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn in_scenes_at_random_both_sides_of_every_formula_agree(
        scene in scene(),
        solver in prop::sample::select(Solver::ALL.to_vec()),
    ) {
        let mut faults = BTreeMap::new();
        for method in Method::ALL {
            check(&runs::recorded(scene.clone(), method, solver), method.name(), &mut faults);
        }
        prop_assert!(faults.is_empty(), "{:#?}", faults);
    }
}
