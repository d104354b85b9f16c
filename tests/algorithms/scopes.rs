//! The scopes of a run have names that differ among those in the same scope, so that the time line always says where one is. A
//! kind of scope without a number stands at most once in a scope.

use super::rays::scenes::scene;
use super::runs;
use lightwalk::algorithms::form_factor;
use lightwalk::algorithms::form_factor::hemicube::Hemicubes;
use lightwalk::algorithms::radiosity::Solver;
use lightwalk::language::Language;
use lightwalk::panels::scope_names;
use lightwalk::render::Method;
use lightwalk::replay::Run;
use lightwalk::scene::{Object, Shape};
use proptest::prelude::*;
use std::collections::HashSet;

/// Looks at every scope of the run; how many there are.
fn check(run: &Run, what: &str) -> usize {
    let walk = run.walk();
    // The names and the kinds without a number, of the scopes in each scope that is open.
    let mut names: Vec<HashSet<String>> = Vec::new();
    let mut kinds: Vec<HashSet<&str>> = Vec::new();
    let mut count = 0;
    for step in (0..walk.len()).filter(|&step| walk.outline().opens(step)) {
        count += 1;
        let depth = walk.outline().depth(step);
        names.resize_with(depth + 1, HashSet::new);
        kinds.resize_with(depth + 1, HashSet::new);
        let kind = walk.declared(step);
        let name = scope_names(run, step, usize::MAX, Language::English).swap_remove(0);
        assert!(
            !name.is_empty(),
            "{what}, step {step}: {} has no name",
            kind.name
        );
        // A ray is named by where it goes.
        if kind.numbers.is_empty() && kind.name != "Ray" {
            assert!(
                kinds[depth].insert(kind.name),
                "{what}, step {step}: a second {} without a number",
                kind.name
            );
        }
        assert!(
            names[depth].insert(name.clone()),
            "{what}, step {step}: a second “{name}”"
        );
    }
    count
}

#[test]
fn in_every_lesson_no_two_scopes_of_a_scope_have_the_same_name() {
    for (lesson, run) in runs::lessons() {
        let count = check(&run, lesson);
        assert!(count > 0, "{lesson} has no scopes");
    }
}

/// Two patches that see each other: one of three pieces, the other of two.
fn bent() -> Vec<Object> {
    let polygon = |corners: &[[f64; 3]]| {
        let vertices = corners.iter().copied().map(Into::into).collect();
        Object::new("", 0, Shape::Polygon { vertices })
    };
    vec![
        polygon(&[
            [0.0, 0.0, 0.0],
            [3.0, 0.0, 0.0],
            [3.0, 1.0, 0.0],
            [1.0, 1.0, 0.0],
            [1.0, 3.0, 0.0],
            [0.0, 3.0, 0.0],
        ]),
        polygon(&[
            [0.0, 0.0, 1.0],
            [0.0, 3.0, 1.0],
            [1.0, 1.0, 1.0],
            [3.0, 0.0, 1.0],
        ]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(6))]

    #[test]
    fn in_scenes_at_random_no_two_scopes_of_a_scope_have_the_same_name(
        scene in scene(),
        solver in prop::sample::select(Solver::ALL.to_vec()),
    ) {
        for method in Method::ALL {
            check(&runs::recorded(scene.clone(), method, solver), method.name());
        }
        let hemicubes = form_factor::Method::Hemicube(Hemicubes { resolution: 8, points: 3 });
        for method in form_factor::Method::ALL.into_iter().chain([hemicubes]) {
            let scene = lightwalk::scene::Scene { objects: bent(), ..scene.clone() };
            check(&runs::form_factor(scene, method), method.name());
        }
    }
}
