use super::super::fixture::{self, Fixture};
use super::super::fixtures::{self, SIZES, assert_legible, texts};
use super::*;
use crate::picture::Tag;
use crate::render::Method;
use crate::scene::Light;

const LARGE: Vec2 = Vec2::new(900.0, 420.0);

#[test]
fn every_step_is_legible_at_every_size() {
    for mut fixture in [
        Fixture::rays(Method::RayTracing, fixture::BALL, 5),
        Fixture::rays(Method::RayTracing, fixture::SKY, 5),
        fixtures::rays(Method::RayTracing, 1),
        fixtures::rays(Method::RayCasting, 1),
        fixtures::fixtures(Method::Gouraud),
        fixtures::nothing(),
    ] {
        for step in fixture.some_steps(397) {
            fixture.seek(step);
            for (size, language) in SIZES.into_iter().zip(Language::ALL.into_iter().cycle()) {
                let picture = draw(&fixture.show_in(language), size);
                let what = format!("{} {step} at {size}", fixture.walk().kind(step));
                assert_legible(&picture, &what);
                assert!(!picture.items.is_empty(), "{what}");
            }
        }
    }
}

#[test]
fn every_ray_so_far_is_tagged_by_the_step_that_opened_it() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    for rays in 0..14 {
        fixture.go_to("Ray", rays);
        let picture = draw(&fixture.input(), LARGE);
        let walk = fixture.walk();
        let opened = (0..=walk.position()).filter(|&step| walk.kind(step) == "Ray");
        assert!(opened.clone().count() == rays + 1);
        for step in opened {
            assert!(picture.tagged_bounds(Tag::Scope(step)).is_some(), "{step}");
        }
    }
}

#[test]
fn a_ray_ends_where_it_meets_its_surface() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("SurfaceMet", 0);
    let input = fixture.input();
    let state = input.run.rays().expect("rays");
    let ray = state.ray().expect("a ray");
    for (view, _) in views(state, LARGE) {
        let picture = draw(&input, LARGE);
        let tip = view.place(ray.surface.expect("a surface").position);
        let bounds = picture.tagged_bounds(Tag::Scope(ray.step)).expect("drawn");
        assert!(bounds.grown(1.0).contains(tip));
    }
}

#[test]
fn views_stay_as_they_are_from_step_to_step() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    let views_at = |fixture: &Fixture| -> Vec<View> {
        let input = fixture.input();
        let views = views(input.run.rays().expect("rays"), LARGE);
        views.into_iter().map(|(view, _)| view).collect()
    };
    let first = views_at(&fixture);
    assert_eq!(first.len(), 2);
    let last = fixture.walk().len() - 1;
    assert_eq!(views_at(fixture.seek(last)), first);
}

#[test]
fn a_light_follows_the_pointer_in_the_plane_of_its_view() {
    let fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    let input = fixture.input();
    let state = input.run.rays().expect("rays");
    for (view, _) in views(state, LARGE) {
        for (number, light) in state.prepared.scene.lights.iter().enumerate() {
            let Light::Point { position, .. } = *light else {
                continue;
            };
            let at = view.place(position);
            let grip = grip(&input, LARGE, at + Vec2::new(2.0, 1.0)).expect("a light");
            assert_eq!(grip.light, number);
            // Taken and not moved, it stays.
            let scale = f64::from(view.scale());
            assert!(
                grip.position(at + Vec2::new(2.0, 1.0)).distance(position) < 1e-4 / scale.min(1.0)
            );
            let moved = grip.position(at + Vec2::new(32.0, -19.0));
            let toward = view.projection.toward_viewer();
            assert!((moved - position).dot(toward).abs() < 1e-9);
            assert!(view.place(moved).distance(at + Vec2::new(30.0, -20.0)) < 1e-2);
            // Far outside it stops at the border.
            let outside = view.place(grip.position(Vec2::splat(1e6)));
            assert!(view.area.grown(0.1).contains(outside));
        }
        assert_eq!(grip(&input, LARGE, view.area.max() - 2.0), None);
    }
}

#[test]
fn a_light_that_blocks_nothing_and_a_name_are_printed_once() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::FLOOR, 5);
    fixture.go_to("Shadow", 0);
    let picture = draw(&fixture.input(), Vec2::new(470.0, 380.0));
    for name in ["eye", "light 0", "light 1", "from the side"] {
        let count = texts(&picture)
            .iter()
            .filter(|(text, _)| *text == name)
            .count();
        assert_eq!(count, 1, "{name}");
    }
}

#[test]
fn of_many_rays_those_stand_out_from_which_the_ray_in_hand_comes() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 9);
    let last = fixture.walk().len() - 1;
    fixture.seek(last);
    let input = fixture.input();
    let state = input.run.rays().expect("rays");
    assert!(state.rays.len() > 24, "{} rays", state.rays.len());
    let way: Vec<usize> = state.way().collect();
    let picture = draw(&input, LARGE);
    // The sky and what is out of sight aside, all are there to be clicked.
    for (index, ray) in state
        .rays
        .iter()
        .enumerate()
        .filter(|(_, ray)| ray.surface.is_some())
    {
        let items = picture.items.iter();
        let mut items = items.filter(|item| item.tag == Some(Tag::Scope(ray.step)));
        let arrow = items.any(|item| matches!(item.shape, crate::picture::Shape::Polygon { .. }));
        assert_eq!(arrow, way.contains(&index), "ray {index}");
        assert!(picture.tagged_bounds(Tag::Scope(ray.step)).is_some());
    }
}
