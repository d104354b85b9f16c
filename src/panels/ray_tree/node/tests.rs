use super::super::arrange::Arrangement;
use super::super::pick::Rays;
use super::super::places::Places;
use super::super::tests::rays_of;
use super::super::{TreeView, draw};
use super::*;
use crate::panels::fixture::{BALL, Fixture, SPARK};
use crate::panels::fixtures::{assert_legible, texts};
use crate::render::Method;
use glam::Vec2;

/// The key panel in a window of 1280×800 points.
const KEY_PANEL: Vec2 = Vec2::new(728.0, 584.0);

/// The texts within each node, and the arrangement.
fn nodes(fixture: &Fixture) -> (Vec<Vec<String>>, Arrangement) {
    let rays = Rays::new(rays_of(fixture));
    let arrangement = Places::new(&rays, TreeView::whole(), KEY_PANEL).1;
    let picture = draw(&fixture.input(), KEY_PANEL);
    let texts = texts(&picture);
    let within = arrangement.rects.iter().map(|rect| {
        let inside = texts
            .iter()
            .filter(|(_, place)| rect.grown(1.0).encloses(place));
        inside.map(|(text, _)| (*text).to_owned()).collect()
    });
    (within.collect(), arrangement)
}

/// Every ray that has met something: its name, t, own light and sum stand in its node.
fn assert_complete(fixture: &Fixture) {
    let state = rays_of(fixture);
    let describer = Describer {
        state,
        language: Language::English,
    };
    let rays = Rays::new(state);
    let (texts, arrangement) = nodes(fixture);
    for (node, texts) in arrangement.tree.nodes.iter().zip(&texts) {
        let Some(ray) = rays.ray(node) else { continue };
        let has = |wordings: &[String]| wordings.iter().any(|wording| texts.contains(wording));
        let step = fixture.walk().position();
        assert!(has(&describer.name(ray)), "{step}: {texts:?}");
        assert!(has(&own_light(&describer, ray)), "{step}: {texts:?}");
        let sum = &sum(&describer, ray)[..1];
        assert!(has(sum), "{step}: {sum:?} in {texts:?}");
        let place = describer.place(ray);
        let placed = texts.iter().any(|text| text.starts_with(&place));
        assert!(placed, "{step}: {place} in {texts:?}");
    }
}

#[test]
fn nine_rays_and_their_numbers_can_be_read_in_the_key_panel_at_every_step() {
    let mut most = 0;
    for (pixel, depth) in [(BALL, 4), (SPARK, 4)] {
        let mut fixture = Fixture::rays(Method::RayTracing, pixel, depth);
        for step in 0..fixture.walk().len() {
            fixture.seek(step);
            if rays_of(&fixture).ray().is_none() {
                continue;
            }
            most = most.max(rays_of(&fixture).rays.len());
            assert_complete(&fixture);
            let picture = draw(&fixture.input(), KEY_PANEL);
            assert_legible(&picture, &format!("step {step}"));
        }
    }
    assert!(most >= 9, "{most} rays");
}

#[test]
fn a_sum_stands_in_its_node_from_the_step_that_returns_it_to_the_end() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 4);
    let last = fixture.walk().len() - 1;
    let returned: Vec<(usize, usize)> = {
        let rays = &rays_of(fixture.seek(last)).rays;
        let step = |ray: &RayState| ray.returned.expect("all have returned").1;
        rays.iter().map(|ray| (ray.step, step(ray))).collect()
    };
    for step in 0..=last {
        fixture.seek(step);
        if rays_of(&fixture).ray().is_none() {
            continue;
        }
        let (texts, arrangement) = nodes(&fixture);
        let rays = Rays::new(rays_of(&fixture));
        for (node, texts) in arrangement.tree.nodes.iter().zip(&texts) {
            let Some(ray) = rays.ray(node) else { continue };
            let (_, at) = returned
                .iter()
                .find(|(opened, _)| *opened == ray.step)
                .unwrap();
            let sum = texts.iter().find(|text| text.starts_with("I  ")).unwrap();
            assert_eq!(
                sum.contains(NOT_KNOWN),
                step < *at,
                "step {step}, back at {at}: {sum}"
            );
            if step < *at {
                continue;
            }
            let recorded = fixture.walk().own_fields(*at).get("I");
            let Some(crate::record::Value::Rgb(recorded)) = recorded else {
                panic!("the light that comes back is recorded")
            };
            assert_eq!(*sum, format!("I  {}", color(recorded, Language::English)));
        }
    }
}

#[test]
fn every_edge_says_its_kind_and_coefficient() {
    for (pixel, depth) in [(BALL, 4), (SPARK, 4)] {
        let mut fixture = Fixture::rays(Method::RayTracing, pixel, depth);
        for step in 0..fixture.walk().len() {
            fixture.seek(step);
            let state = rays_of(&fixture);
            if state.ray().is_none() {
                continue;
            }
            let mut expected: Vec<String> = state
                .rays
                .iter()
                .flat_map(|ray| ray.branches.into_iter().flatten())
                .filter(|branch| matches!(branch.outcome, Outcome::Ray(_) | Outcome::Open))
                .map(|branch| {
                    let coefficient = branch.branch.expect("it is sent").coefficient;
                    let coefficient = color(coefficient, Language::English);
                    format!("{} {coefficient}", letter(branch.kind))
                })
                .collect();
            let picture = draw(&fixture.input(), KEY_PANEL);
            let mut labels: Vec<String> = texts(&picture)
                .into_iter()
                .map(|(text, _)| text.to_owned())
                .filter(|text| expected.contains(text))
                .collect();
            expected.sort();
            labels.sort();
            assert_eq!(labels, expected, "step {step}");
        }
    }
}
