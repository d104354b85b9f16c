use super::super::super::{Orbit, Preset, SpaceView};
use super::super::fixture::{self, Fixture};
use super::*;
use crate::picture::{Shape, Tag};
use crate::render::Method;

const LARGE: Vec2 = Vec2::new(900.0, 560.0);

fn all(panel: Panel, input: &PanelInput) -> Vec<Handle> {
    let movable = Movable::all(&input.run.prepared().scene);
    handles(panel, input, LARGE, movable)
}

fn assert_follows(handle: &Handle) {
    let grip = Grip {
        handle: *handle,
        offset: Vec2::new(-2.0, -1.0),
    };
    let taken = handle.at - grip.offset;
    // Taken and not moved, it stays.
    let stays = grip.position(taken).distance(handle.position);
    assert!(stays < 1e-3, "{handle:?} moved by {stays}");
    for by in [Vec2::new(30.0, -20.0), Vec2::new(-3.0, 8.0)] {
        let to = (handle.at + by).clamp(handle.sight.area().min(), handle.sight.area().max());
        let moved = handle.sight.place(grip.position(taken + by)).unwrap();
        assert!(moved.distance(to) < 1e-2, "{handle:?} at {moved}, not {to}");
    }
    let away = |point| match &handle.sight {
        Sight::Space(space) => space.toward.dot(point),
        Sight::Camera { view, .. } => view.to_camera(point).z,
    };
    let moved = grip.position(taken + Vec2::new(30.0, -20.0));
    let (far, as_far) = (away(moved), away(handle.position));
    assert!(
        (far - as_far).abs() < 1e-9 * as_far.abs().max(1.0),
        "{handle:?}"
    );
    // Far outside it stops at the border.
    let outside = handle.sight.place(grip.position(Vec2::splat(1e6))).unwrap();
    assert!(handle.sight.area().grown(0.1).contains(outside));
}

#[test]
fn whatever_is_held_follows_the_pointer_in_every_panel() {
    let mut triangle = Fixture::triangle(Method::Gouraud);
    triangle.go_to("EdgeInterpolated", 9);
    let rays = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    for (fixture, panel, least) in [
        (&triangle, Panel::ScanLine, 3),
        (&triangle, Panel::Image, 4),
        (&triangle, Panel::Space, 6),
        (&rays, Panel::Image, 3),
        (&rays, Panel::Space, 4),
    ] {
        let found = all(panel, &fixture.input());
        assert!(found.len() >= least, "{panel:?}: {}", found.len());
        found.iter().for_each(assert_follows);
    }
    assert!(all(Panel::Formula, &rays.input()).is_empty());
}

#[test]
fn in_space_it_follows_from_wherever_it_is_seen() {
    let fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    for preset in Preset::ALL {
        let input = PanelInput {
            space: SpaceView {
                orbit: Orbit::preset(preset),
                ..SpaceView::default()
            },
            ..fixture.input()
        };
        let found = all(Panel::Space, &input);
        assert!(!found.is_empty(), "{preset:?}");
        found.iter().for_each(assert_follows);
    }
}

#[test]
fn a_vertex_is_held_where_the_scan_line_panel_draws_it() {
    let mut fixture = Fixture::triangle(Method::Gouraud);
    fixture.go_to("EdgeInterpolated", 9);
    let input = fixture.input();
    let picture = super::super::super::draw(Panel::ScanLine, &input, LARGE);
    let found = all(Panel::ScanLine, &input);
    assert_eq!(found.len(), 3);
    for handle in found {
        let disc = picture.items.iter().find(|item| {
            matches!(item.tag, Some(Tag::Corner(_)))
                && matches!(item.shape, Shape::Circle { .. })
                && item.shape.bounds().center().distance(handle.at) < 0.5
        });
        assert!(disc.is_some(), "nothing is drawn at {}", handle.at);
    }
}

#[test]
fn the_nearest_is_taken_and_nothing_that_is_far() {
    let fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    let found = all(Panel::Space, &fixture.input());
    for handle in &found {
        let grip = Grip::nearest(&found, handle.at).unwrap();
        assert!(grip.offset.length() < 1e-6);
    }
    let away = Vec2::splat(-100.0);
    assert_eq!(Grip::nearest(&found, away), None);
}
