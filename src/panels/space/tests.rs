use super::super::fixture::{self, Fixture};
use super::super::fixtures::{self, SIZES, assert_legible};
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::radiosity::Solver;
use crate::color::Rgb;
use crate::picture::{Dash, Shape as Drawn, Tag};
use crate::render::Method;

fn looked_at(orbit: Orbit) -> SpaceView {
    SpaceView {
        orbit,
        ..SpaceView::default()
    }
}

const LARGE: Vec2 = Vec2::new(900.0, 560.0);

#[test]
fn every_step_is_legible_at_every_size_and_from_everywhere() {
    let presets = Preset::ALL.into_iter().cycle().skip(1);
    let languages = Language::ALL.into_iter().cycle();
    let sizes = SIZES.into_iter().cycle().zip(languages).zip(presets);
    let mut sizes = sizes.map(|((size, language), preset)| (size, language, preset));
    for mut fixture in [
        Fixture::rays(Method::RayTracing, fixture::BALL, 5),
        Fixture::rays(Method::RayTracing, fixture::SKY, 5),
        fixtures::rays(Method::RayTracing, 1),
        fixtures::rays(Method::RayCasting, 1),
        fixtures::fixtures(Method::Gouraud),
        Fixture::room(Solver::GaussSeidel, Focus::Frame),
        fixtures::nothing(),
    ] {
        for step in fixture.some_steps(997) {
            fixture.seek(step);
            let (size, language, preset) = sizes.next().unwrap();
            let input = PanelInput {
                space: looked_at(Orbit::preset(preset).turned(Vec2::new(0.3, -0.2))),
                ..fixture.show_in(language)
            };
            let picture = draw(&input, size);
            let what = format!("{} {step} at {size}", fixture.walk().kind(step));
            assert_legible(&picture, &what);
            assert!(!picture.items.is_empty(), "{what}");
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
fn from_the_eye_the_scene_stands_as_in_the_picture() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("SurfaceMet", 0);
    let input = PanelInput {
        space: looked_at(Orbit::preset(Preset::Eye)),
        ..fixture.input()
    };
    let (space, _) = space(&input, LARGE);
    let prepared = input.run.prepared();
    let view = &prepared.view;
    // Two points of the world lie on the panel as their pixels lie on the screen.
    let points = [DVec3::new(0.3, 0.4, -0.2), DVec3::new(-0.8, 0.1, 0.5)];
    let [a, b] = points.map(|point| view.to_screen(view.to_camera(point)));
    let [at_a, at_b] = points.map(|point| space.place(point).unwrap());
    let pixel = (at_b - at_a).as_dvec2() / (b - a);
    assert!((pixel.x - pixel.y).abs() < 1e-4 * pixel.x, "{pixel}");
    let state = input.run.rays().unwrap();
    let surface = state.ray().unwrap().surface.unwrap();
    let met = view.to_screen(view.to_camera(surface.position));
    let at = at_a + (pixel * (met - a)).as_vec2();
    assert!(space.place(surface.position).unwrap().distance(at) < 0.1);
}

#[test]
fn the_plane_of_incidence_holds_the_ray_and_its_normal() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("SurfaceMet", 0);
    let input = PanelInput {
        space: looked_at(Orbit::preset(Preset::Incidence)),
        ..fixture.input()
    };
    let (space, _) = space(&input, LARGE);
    let ray = input.run.rays().unwrap().ray().unwrap();
    let normal = ray.surface.unwrap().geometric;
    assert!(space.toward.dot(ray.ray.direction).abs() < 1e-12);
    assert!(space.toward.dot(normal).abs() < 1e-12);
    let along = PanelInput {
        space: looked_at(Orbit::preset(Preset::Ray)),
        ..input
    };
    let (space, _) = self::space(&along, LARGE);
    assert!((space.toward.dot(ray.ray.direction) + 1.0).abs() < 1e-12);
}

#[test]
fn turned_and_moved_as_far_as_one_likes_something_stays_in_sight() {
    let fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    for preset in Preset::ALL {
        let mut orbit = Orbit::preset(preset);
        for turn in 0..40 {
            orbit = orbit.turned(Vec2::new(0.7, 0.4 * (turn % 7) as f32 - 1.2));
            let input = PanelInput {
                space: looked_at(orbit),
                ..fixture.input()
            };
            let (space, _) = space(&input, LARGE);
            let upright = space.up.dot(orbit::axes(input.run.prepared()).1);
            assert!(
                upright > -1e-6,
                "{preset:?} stands on its head after {turn}"
            );
            if preset != Preset::Eye {
                for point in shown(&input) {
                    assert!(space.area.contains(space.place(point).unwrap()));
                }
            }
        }
        // From the eye, the border is that of the picture.
        let moves = [(-100.0, 0.01), (-3.0, 4.0), (0.4, 1e6), (100.0, 30.0)];
        for (by, zoom) in moves.into_iter().filter(|_| preset != Preset::Eye) {
            let far = orbit.moved(Vec2::splat(by)).zoomed(zoom, Vec2::splat(0.3));
            let input = PanelInput {
                space: looked_at(far.moved(Vec2::splat(by))),
                ..fixture.input()
            };
            let (space, _) = space(&input, LARGE);
            let places = shown(&input).into_iter();
            let places = places.filter_map(|point| space.place(point));
            let around = Rect::around(places).expect("something lies before the viewer");
            let in_sight = around.intersection(&space.area);
            assert!(!in_sight.is_empty(), "{preset:?}, {by}, {zoom}: {around:?}");
        }
    }
}

#[test]
fn what_stands_behind_a_surface_is_dotted_and_what_stands_before_it_is_not() {
    let fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    let input = fixture.input();
    let (space, extent) = space(&input, LARGE);
    let prepared = input.run.prepared();
    let mut solids = Solids::new(space.area);
    surfaces::objects(&mut solids, &space, prepared, PLANE * extent, true);
    let (_, depths) = solids.finish();
    let ball = prepared.scene.objects.iter().find_map(|object| {
        let material = &prepared.scene.materials[object.material];
        match object.shape {
            Shape::Sphere { center, radius } if material.transmission == Rgb::BLACK => {
                Some((center, radius))
            }
            _ => None,
        }
    });
    let (center, radius) = ball.expect("an opaque ball");
    let mut picture = Picture::new(LARGE.x, LARGE.y);
    let mut sketch = Sketch {
        picture: &mut picture,
        input: &input,
        space,
        depths: depths.into(),
        labels: Labels::new(space.area),
        text: 12.0,
        extent,
    };
    for toward in [1.0, -1.0] {
        let middle = center + toward * 1.5 * radius * space.toward;
        let half = 0.3 * radius * space.right;
        sketch.line(middle - half, middle + half, Ink::Text.stroke(1.0));
    }
    let dashes = picture.items.iter().map(|item| match &item.shape {
        Drawn::Polyline { stroke, .. } => stroke.dash,
        other => panic!("{other:?} is no line"),
    });
    assert!(dashes.eq([Dash::Solid, Dash::Dotted]));
}

#[test]
fn every_patch_that_shows_its_front_can_be_pointed_at() {
    let fixture = Fixture::room(Solver::GaussSeidel, Focus::Frame);
    let input = fixture.input();
    let picture = draw(&input, LARGE);
    let room = input.run.enclosure().unwrap();
    let (space, _) = space(&input, LARGE);
    let mut fronts = 0;
    for (patch, known) in room.patches.iter().enumerate() {
        if !surfaces::faces_viewer(&space, known.center, known.normal) {
            continue;
        }
        fronts += 1;
        assert!(
            picture.tagged_bounds(Tag::Patch(patch)).is_some(),
            "{patch}"
        );
    }
    assert!(fronts > 5, "{fronts}");
}
