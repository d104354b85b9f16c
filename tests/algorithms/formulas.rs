//! The law of the formulas: what the right side amounts to, computed from the values that the panel shows, is the recorded left
//! side; over the runs of the lessons, and of scenes at random by every method.

use super::rays::scenes::scene;
use lightwalk::algorithms::enclosure;
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::radiosity::Solver;
use lightwalk::color::Rgb;
use lightwalk::lesson::builtins;
use lightwalk::methods::Setup;
use lightwalk::panels::evaluated;
use lightwalk::record::RecordingLimit;
use lightwalk::render::Method;
use lightwalk::replay::Run;
use lightwalk::scene::{Scene, Shape, View};
use proptest::prelude::*;
use std::sync::Arc;

/// Checks the formulas at every `stride`-th step; how many were evaluated.
fn check(run: &Run, stride: usize, what: &str) -> usize {
    let walk = run.walk();
    let mut count = 0;
    for step in (0..walk.len()).step_by(stride) {
        for formula in evaluated(run, step) {
            let Some(holds) = formula.holds() else {
                continue;
            };
            count += 1;
            assert!(
                holds,
                "{what}, step {step}, {}: {}: {:?} and {:?}",
                walk.kind(step),
                formula.formula.text,
                formula.left,
                formula.right
            );
        }
    }
    count
}

#[test]
fn in_every_lesson_both_sides_of_every_formula_agree() {
    for builtin in builtins() {
        let open = builtin.read().and_then(|lesson| lesson.open());
        let open = open.unwrap_or_else(|error| panic!("{}: {error}", builtin.id));
        // Every step of all but the longest runs
        let stride = 1 + open.run.walk().len() / 30_000;
        let count = check(&open.run, stride, builtin.id);
        assert!(count > 10, "{}: {count} formulas", builtin.id);
    }
}

/// The run of the whole of a small picture.
fn recorded(mut scene: Scene, method: Method, solver: Solver) -> Run {
    for object in &mut scene.objects {
        object.divisions = 4;
    }
    if method == Method::Radiosity {
        scene
            .objects
            .retain(|object| matches!(object.shape, Shape::Polygon { .. }));
        for material in &mut scene.materials {
            material.reflectance = material.specular * 0.9;
            material.emission = Rgb::splat(material.shininess);
        }
    }
    let view = View::new(&scene.camera.expect("a camera"), 12, 9);
    let settings = enclosure::Settings {
        solver,
        ..enclosure::Settings::default()
    };
    let setup = Setup::new(PreparedScene::new(scene, view), settings);
    let limit = RecordingLimit::default();
    Run::record(Arc::new(setup), method, Focus::Frame, limit)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn in_scenes_at_random_both_sides_of_every_formula_agree(
        scene in scene(),
        solver in prop::sample::select(Solver::ALL.to_vec()),
    ) {
        for method in Method::ALL {
            let run = recorded(scene.clone(), method, solver);
            let stride = 1 + run.walk().len() / 4000;
            check(&run, stride, method.name());
        }
    }
}
