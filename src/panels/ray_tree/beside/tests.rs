use super::super::draw;
use super::super::tests::{all_words, rays_of};
use super::*;
use crate::color::Rgb;
use crate::language::Language;
use crate::panels::fixture::{BALL, FLOOR, Fixture, SKY, SPARK, rays_scene};
use crate::panels::fixtures::{SIZES, assert_legible, texts};
use crate::picture::Shape;
use crate::render::Method;

const KEY_PANEL: Vec2 = Vec2::new(728.0, 584.0);

/// A pixel's tree at the end of its run.
fn end(pixel: (u32, u32), depth: u32) -> Fixture {
    end_of(Fixture::rays(Method::RayTracing, pixel, depth))
}

fn end_of(mut fixture: Fixture) -> Fixture {
    let last = fixture.walk().len() - 1;
    fixture.seek(last);
    fixture
}

/// Pixels of one scene.
fn ends<const N: usize>(pixels: [(u32, u32); N]) -> [Fixture; N] {
    Fixture::pixels_of(rays_scene(), Method::RayTracing, pixels, 4).map(end_of)
}

fn compared(fixture: &Fixture, pinned: &Fixture, size: Vec2, language: Language) -> Picture {
    let input = PanelInput {
        pinned: Some(rays_of(pinned)),
        ..fixture.show_in(language)
    };
    draw(&input, size)
}

#[test]
fn trees_stand_beside_each_other_and_nothing_overlaps() {
    let pixels = ends([BALL, SPARK, FLOOR, SKY]);
    for (one, other) in [(0, 1), (1, 0), (2, 0), (3, 2)] {
        for size in SIZES.into_iter().chain([KEY_PANEL]) {
            for language in Language::ALL {
                let picture = compared(&pixels[one], &pixels[other], size, language);
                assert_legible(&picture, &format!("{one} and {other} at {size}"));
            }
        }
    }
}

#[test]
fn both_pixels_stand_with_their_colours_and_levels() {
    let [ball, floor] = ends([BALL, FLOOR]);
    let picture = compared(&floor, &ball, KEY_PANEL, Language::English);
    let halves = [0.0..364.0, 364.0..728.0];
    for ((fixture, x), name) in [&ball, &floor]
        .into_iter()
        .zip(halves)
        .zip(["pinned", "here"])
    {
        let state = rays_of(fixture);
        let texts = texts(&picture).into_iter();
        let said: Vec<&str> = texts
            .filter(|(_, place)| x.contains(&place.x))
            .map(|(text, _)| text)
            .collect();
        let (px, py) = state.pixel.unwrap();
        let light = color(state.light_so_far(), Language::English);
        let title = format!("{name}: pixel ({px}, {py})");
        let light = format!("I  {light}");
        assert!(said.contains(&&*title), "{title} in {said:?}");
        assert!(said.contains(&&*light), "{light} in {said:?}");
        for level in state.light_by_level().into_iter().flatten() {
            let level = color(level, Language::English);
            let parts: Vec<&str> = level.split(' ').collect();
            let in_parts = parts.iter().all(|part| said.contains(part));
            assert!(said.contains(&&*level) || in_parts, "{level} in {said:?}");
        }
        let words = format!("{title}, {light}");
        assert!(picture.alt.contains(&words), "{words} in {}", picture.alt);
    }
}

#[test]
fn the_first_difference_is_named_and_ringed_in_both_trees() {
    let [ball, floor] = ends([BALL, FLOOR]);
    let picture = compared(&floor, &ball, KEY_PANEL, Language::English);
    let expected = "First difference, at level 1: glass ball in the pinned tree, floor here";
    assert!(
        all_words(&picture).contains(expected),
        "{}",
        all_words(&picture)
    );
    let is_ring = |shape: &Shape| matches!(shape, Shape::Rect { paint, .. } if paint.stroke == Some(Ink::Warn.stroke(2.5)));
    let rings: Vec<f32> = picture
        .items
        .iter()
        .filter(|item| is_ring(&item.shape))
        .map(|item| item.shape.bounds().center().x)
        .collect();
    assert!(
        matches!(rings[..], [left, right] if left < 364.0 && right > 364.0),
        "{rings:?}"
    );
}

#[test]
fn trees_differ_first_in_what_is_met_then_in_coefficients_and_ends() {
    let ball = end(BALL, 4);
    let difference = |other: &Fixture| first_difference([rays_of(&ball), rays_of(other)]);
    assert_eq!(difference(&end(BALL, 4)), None);
    // The next pixel meets the same objects, or differs further down.
    let what = difference(&end(FLOOR, 4)).unwrap();
    assert!(matches!(what.what, Differs::Met(_)) && what.rays == [0, 0]);
    // One level less: the branches of the last level end.
    let what = difference(&end(BALL, 3)).unwrap();
    assert!(
        matches!(what.what, Differs::End(_, [None, Some(End::Depth)])),
        "{what:?}"
    );
    // Glass that mirrors more.
    let mut scene = rays_scene();
    for material in &mut scene.materials {
        if material.transmission != Rgb::BLACK {
            material.reflection = Rgb::splat(0.25);
        }
    }
    let other = end_of(Fixture::rays_of(scene, Method::RayTracing, BALL, 4));
    let what = difference(&other).unwrap();
    let Differs::Coefficient(RayKind::Reflected, [a, b]) = what.what else {
        panic!("{what:?}")
    };
    assert!(a != b && b == Rgb::splat(0.25));
}

#[test]
fn what_is_not_traced_yet_is_no_difference() {
    let ball = end(BALL, 4);
    let mut other = Fixture::rays(Method::RayTracing, BALL, 4);
    for step in other.first("Ray")..other.walk().len() {
        other.seek(step);
        assert_eq!(
            first_difference([rays_of(&ball), rays_of(&other)]),
            None,
            "{step}"
        );
    }
}

#[test]
fn the_same_pixel_of_another_scene_is_compared_and_of_the_same_is_not() {
    let ball = end(BALL, 4);
    let alone = draw(&ball.input(), KEY_PANEL);
    assert_eq!(compared(&ball, &ball, KEY_PANEL, Language::English), alone);
    let other = end(BALL, 4);
    let said = all_words(&compared(&ball, &other, KEY_PANEL, Language::English));
    assert!(said.contains("before the change"), "{said}");
    assert!(said.contains("No difference so far"), "{said}");
}

#[test]
fn the_pinned_tree_follows_the_view_and_leads_to_no_step() {
    let (ball, spark) = (end(BALL, 5), end(SPARK, 5));
    let trees = [rays_of(&ball), rays_of(&spark)];
    // The transmitted ray is held, and the reflected one collapsed.
    let branches = trees[1].rays.get(0).unwrap().branches;
    let [reflected, transmitted] = branches.map(|branch| match branch.unwrap().outcome {
        Outcome::Ray(index) => trees[1].rays.get(index).unwrap().step,
        other => panic!("{other:?}"),
    });
    let at = Vec2::new(10.0, -20.0);
    let held = HeldNode {
        ray: transmitted,
        at,
    };
    let view = TreeView::WHOLE.toggled(reflected).zoomed(4.0, Some(held));
    let followed = followed(&view, trees);
    let pinned = trees[0].rays.get(0).unwrap().branches;
    let steps = pinned.map(|branch| match branch.unwrap().outcome {
        Outcome::Ray(index) => trees[0].rays.get(index).unwrap().step,
        other => panic!("{other:?}"),
    });
    assert_eq!(followed.zoom, 4.0);
    assert_eq!(followed.held, Some(HeldNode { ray: steps[1], at }));
    assert!(followed.collapsed.contains(&steps[0]) && followed.collapsed.len() == 1);
    let picture = compared(&spark, &ball, KEY_PANEL, Language::English);
    let left = picture
        .items
        .iter()
        .filter(|item| item.shape.bounds().right() < 364.0);
    let leads = |tag: &Tag| matches!(tag, Tag::Scope(_) | Tag::Step(_) | Tag::Fold(_));
    assert!(left.filter_map(|item| item.tag).all(|tag| !leads(&tag)));
}
