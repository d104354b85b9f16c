use super::super::crowd::{self, SIZES, assert_legible, texts};
use super::super::sample::{self, Sample};
use super::*;
use crate::picture::Tag;
use crate::render::Method;
use crate::scene::Light;

const LARGE: Vec2 = Vec2::new(900.0, 420.0);

#[test]
fn every_step_is_legible_at_every_size() {
    for mut sample in [
        Sample::rays(Method::RayTracing, sample::BALL, 5),
        Sample::rays(Method::RayTracing, sample::SKY, 5),
        crowd::rays(Method::RayTracing, 1),
        crowd::rays(Method::RayCasting, 1),
        crowd::crowd(Method::Gouraud),
        crowd::nothing(),
    ] {
        for step in sample.some_steps(397) {
            sample.seek(step);
            for (size, language) in SIZES.into_iter().zip(Language::ALL.into_iter().cycle()) {
                let picture = draw(&sample.show_in(language), size);
                let what = format!("{} {step} at {size}", sample.walk().kind(step));
                assert_legible(&picture, &what);
                assert!(!picture.items.is_empty(), "{what}");
            }
        }
    }
}

#[test]
fn every_ray_so_far_is_tagged_by_the_step_that_opened_it() {
    let mut sample = Sample::rays(Method::RayTracing, sample::BALL, 5);
    for rays in 0..14 {
        sample.go_to("Ray", rays);
        let picture = draw(&sample.show(), LARGE);
        let walk = sample.walk();
        let opened = (0..=walk.position()).filter(|&step| walk.kind(step) == "Ray");
        assert!(opened.clone().count() == rays + 1);
        for step in opened {
            assert!(picture.tagged_bounds(Tag::Scope(step)).is_some(), "{step}");
        }
    }
}

#[test]
fn a_ray_ends_where_it_meets_its_surface() {
    let mut sample = Sample::rays(Method::RayTracing, sample::BALL, 5);
    sample.go_to("SurfaceMet", 0);
    let show = sample.show();
    let state = show.run.rays().expect("rays");
    let ray = state.ray().expect("a ray");
    for (view, _) in views(state, LARGE) {
        let picture = draw(&show, LARGE);
        let tip = view.place(ray.surface.expect("a surface").position);
        let bounds = picture.tagged_bounds(Tag::Scope(ray.step)).expect("drawn");
        assert!(bounds.grown(1.0).contains(tip));
    }
}

#[test]
fn views_stay_as_they_are_from_step_to_step() {
    let mut sample = Sample::rays(Method::RayTracing, sample::BALL, 5);
    let views_at = |sample: &Sample| -> Vec<View> {
        let show = sample.show();
        let views = views(show.run.rays().expect("rays"), LARGE);
        views.into_iter().map(|(view, _)| view).collect()
    };
    let first = views_at(&sample);
    assert_eq!(first.len(), 2);
    let last = sample.walk().len() - 1;
    assert_eq!(views_at(sample.seek(last)), first);
}

#[test]
fn a_light_follows_the_pointer_in_the_plane_of_its_view() {
    let sample = Sample::rays(Method::RayTracing, sample::BALL, 5);
    let show = sample.show();
    let state = show.run.rays().expect("rays");
    for (view, _) in views(state, LARGE) {
        for (number, light) in state.stage.scene.lights.iter().enumerate() {
            let Light::Point { position, .. } = *light else {
                continue;
            };
            let at = view.place(position);
            let grip = grip(&show, LARGE, at + Vec2::new(2.0, 1.0)).expect("a light");
            assert_eq!(grip.light, number);
            // Taken and not moved, it stays.
            let scale = f64::from(view.scale());
            assert!(
                grip.position(at + Vec2::new(2.0, 1.0)).distance(position) < 1e-4 / scale.min(1.0)
            );
            let moved = grip.position(at + Vec2::new(32.0, -19.0));
            let toward = view.toward_viewer();
            assert!((moved - position).dot(toward).abs() < 1e-9);
            assert!(view.place(moved).distance(at + Vec2::new(30.0, -20.0)) < 1e-2);
            // Far outside it stops at the border.
            let outside = view.place(grip.position(Vec2::splat(1e6)));
            assert!(view.area.grown(0.1).contains(outside));
        }
        assert_eq!(grip(&show, LARGE, view.area.max() - 2.0), None);
    }
}

#[test]
fn a_light_that_blocks_nothing_and_a_name_are_printed_once() {
    let mut sample = Sample::rays(Method::RayTracing, sample::FLOOR, 5);
    sample.go_to("Shadow", 0);
    let picture = draw(&sample.show(), Vec2::new(470.0, 380.0));
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
    let mut sample = Sample::rays(Method::RayTracing, sample::BALL, 9);
    let last = sample.walk().len() - 1;
    sample.seek(last);
    let show = sample.show();
    let state = show.run.rays().expect("rays");
    assert!(state.rays.len() > 24, "{} rays", state.rays.len());
    let way: Vec<usize> = state.way().collect();
    let picture = draw(&show, LARGE);
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
