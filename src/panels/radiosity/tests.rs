use super::super::fixture::Fixture;
use super::super::fixtures::{
    self, SIZES, assert_legible, assert_steps_are_legible, views_in_turn,
};
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::radiosity::Solver;
use crate::picture::{Item, Shape};
use crate::render::{Method, smooth_patches};
use crate::scene::View;
use crate::scene::primitives::Ray;
use glam::DVec2;

const WIDE: Vec2 = Vec2::new(800.0, 500.0);
const NARROW: Vec2 = Vec2::new(380.0, 280.0);

fn stage_of(fixture: &Fixture) -> &PreparedScene {
    match &fixture.run {
        Run::Radiosity(setup, _) | Run::FormFactor(setup, _) => &setup.prepared,
        _ => panic!("the sample is a room"),
    }
}

fn room_of(fixture: &Fixture) -> &Enclosure {
    let enclosure = fixture.run.enclosure();
    enclosure.expect("the sample has patches")
}

fn state_of(fixture: &Fixture) -> &State {
    match &fixture.run {
        Run::Radiosity(_, replay) => replay.state(),
        _ => panic!("the sample has a solver"),
    }
}

fn tagged(picture: &Picture, tag: Tag) -> impl Iterator<Item = &Item> {
    picture
        .items
        .iter()
        .filter(move |item| item.tag == Some(tag))
}

#[test]
fn every_step_is_legible_at_every_size() {
    for mut fixture in [
        Fixture::room(Solver::GaussSeidel, Focus::Frame),
        Fixture::room(Solver::Overshooting, Focus::Frame),
        Fixture::room(Solver::Shooting, Focus::Patch(60)),
        Fixture::room(Solver::Auto, Focus::Iterations { start: 1, end: 3 }),
        Fixture::room(Solver::Auto, Focus::FormFactor { i: 0, j: 60 }),
        fixtures::fixtures(Method::Gouraud),
        fixtures::rays(Method::RayCasting, 1),
    ] {
        assert_steps_are_legible(&mut fixture, 9973, &views_in_turn(), |input, size| {
            let smooth = (input.run.walk().position() % 2 == 1).then_some(smooth_patches as _);
            draw(&PanelInput { smooth, ..*input }, size)
        });
    }
}

#[test]
fn every_patch_that_shows_its_front_is_tagged_and_no_other() {
    let fixture = Fixture::room(Solver::Auto, Focus::Frame);
    let picture = draw(&fixture.input(), NARROW);
    let eye = stage_of(&fixture).view.eye;
    for (number, patch) in room_of(&fixture).patches.iter().enumerate() {
        let front = patch.normal.dot(eye - patch.center) > 0.0;
        let count = tagged(&picture, Tag::Patch(number)).count();
        assert_eq!(count, usize::from(front), "patch {number}");
    }
}

#[test]
fn the_nearest_patch_answers_the_pointer() {
    let fixture = Fixture::room(Solver::Auto, Focus::Frame);
    let (prepared, room) = (stage_of(&fixture), room_of(&fixture));
    let picture = draw(&fixture.input(), WIDE);
    let view = RoomView::new(prepared, room);
    let mut layout = Picture::new(WIDE.x, WIDE.y);
    let place = place(&layout);
    let fit = view.fit(coloring(&fixture.input(), room).frame(&mut layout, place, None));
    let nearest = |at: Vec2| {
        let View {
            eye,
            focal,
            right,
            up,
            forward,
            width,
            height,
            ..
        } = prepared.view;
        let from_middle = fit.point(at) - 0.5 * DVec2::new(width.into(), height.into());
        let direction = focal * forward + from_middle.x * right - from_middle.y * up;
        let ray = Ray {
            origin: eye,
            direction: direction.normalize(),
        };
        room.primitives.nearest(&ray).map(|(patch, _)| patch)
    };
    let mut checked = 0;
    for seen in &view.seen {
        let at = fit.place(view.center(seen.patch).expect("before the camera"));
        // At an edge the pointer takes what is within its reach.
        let around =
            [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y].map(|aside| nearest(at + 6.0 * aside));
        if around == [nearest(at); 4] {
            assert_eq!(picture.hit(at), nearest(at).map(Tag::Patch), "{at}");
            checked += 1;
        }
    }
    assert!(checked > 20, "{checked}");
}

#[test]
fn neighbours_overlap_by_as_much_at_every_edge() {
    let thin = [[0.0, 0.0], [30.0, 30.0], [30.5, 29.5], [0.5, -0.5]].map(Vec2::from);
    let backward: Vec<Vec2> = thin.iter().rev().copied().collect();
    for corners in [&thin[..], &backward] {
        let wider = overlapping(corners);
        let across = (wider[0] - wider[wider.len() - 1]).length();
        assert!(
            (across - 0.5_f32.sqrt() - 2.0 * OVERLAP).abs() < 1e-4,
            "{across}"
        );
    }
}

#[test]
fn what_is_gathered_comes_along_an_arrow() {
    let mut fixture = Fixture::room(Solver::GaussSeidel, Focus::Frame);
    // Patch 0, of the floor, from the lamp's first.
    fixture.go_to("Exchanged", 60);
    let exchange = Exchange::of(&fixture.run, fixture.focus).expect("an exchange");
    assert_eq!((exchange.i, exchange.j), (0, Some(60)));
    let picture = draw(&fixture.input(), NARROW);
    let line = tagged(&picture, Tag::Patch(60)).find_map(|item| match &item.shape {
        Shape::Polyline { points, stroke } if stroke.ink == Ink::This => Some(points.clone()),
        _ => None,
    });
    let line = line.expect("an arrow");
    // From the lamp above down to the floor, where a head of some points ends it.
    let floor = picture.tagged_bounds(Tag::Patch(0)).expect("drawn");
    let lamp = tagged(&picture, Tag::Patch(60)).next().expect("drawn");
    let lamp = lamp.shape.bounds();
    assert!(lamp.contains(line[0]), "{lamp:?} {line:?}");
    assert!(floor.grown(12.0).contains(line[1]), "{floor:?} {line:?}");
    assert!(
        picture
            .alt
            .contains("i = floor (0, 0) ← j = lamp (0, 0), F_ij B_j = ")
    );
}

/// The fill of a patch in the panel.
fn fill(fixture: &Fixture, patch: usize, unshot: bool) -> Ink {
    let input = PanelInput {
        unshot,
        ..fixture.input()
    };
    let picture = draw(&input, WIDE);
    let mut items = tagged(&picture, Tag::Patch(patch));
    let Some(Shape::Polygon { paint, .. }) = items.next().map(|item| &item.shape) else {
        panic!("patch {patch} is drawn");
    };
    paint.fill.expect("it is filled").ink
}

#[test]
fn the_switch_shows_what_is_unshot_in_place_of_what_patches_have() {
    let mut fixture = Fixture::room(Solver::Shooting, Focus::Frame);
    fixture.go_to("Received", 5);
    let state = state_of(&fixture);
    let unshot = state.unshot(room_of(&fixture));
    let shares = shares(&unshot.expect("a solver that shoots"));
    // The first of the lamp's patches has just shot all it had, and the others have not.
    assert_eq!(shares[60..], [0.0, 1.0, 1.0, 1.0]);
    assert!(shares[3] > 0.0 && shares[3] < 1.0);
    for patch in [3, 61] {
        assert_eq!(
            fill(&fixture, patch, true),
            Ink::Rgb(viridis(shares[patch]))
        );
        assert_ne!(fill(&fixture, patch, false), fill(&fixture, patch, true));
    }
    // Who gathers keeps nothing to shoot, and shows the light.
    let gathering = Fixture::room(Solver::GaussSeidel, Focus::Frame);
    assert_eq!(fill(&gathering, 3, true), fill(&gathering, 3, false));
}

#[test]
fn two_selected_patches_are_outlined_with_their_form_factors() {
    let mut fixture = Fixture::room(Solver::GaussSeidel, Focus::Frame);
    fixture.go_to("RoomDone", 0);
    let room = room_of(&fixture);
    let n = room.patches.len();
    let f = |i: usize, j: usize| room.matrix().expect("made")[i * n + j];
    for size in SIZES {
        for language in Language::ALL {
            let input = PanelInput {
                pair: Some([3, 60]),
                ..fixture.show_in(language)
            };
            for picture in [draw(&input, size), super::super::space::draw(&input, size)] {
                assert_legible(&picture, &format!("pair at {size}"));
                let printed = fixtures::texts(&picture);
                let printed: Vec<&str> = printed.into_iter().map(|(text, _)| text).collect();
                let f = language.significant(f(3, 60), 4);
                let begins = |text: &&str| text.starts_with(&format!("F_{{3, 60}} = {f}"));
                assert!(printed.iter().any(begins), "{size}: {printed:?}");
            }
        }
    }
    let input = PanelInput {
        pair: Some([3, 60]),
        ..fixture.input()
    };
    let picture = draw(&input, WIDE);
    for patch in [3, 60] {
        let mut outlines = tagged(&picture, Tag::Patch(patch));
        let is_blue = |item: &Item| match &item.shape {
            Shape::Polygon { paint, .. } => paint.stroke.is_some_and(|s| s.ink == Ink::Linked),
            _ => false,
        };
        assert!(outlines.any(is_blue), "patch {patch}");
    }
}

#[test]
fn a_patch_says_what_it_has() {
    let mut fixture = Fixture::room(Solver::Shooting, Focus::Frame);
    fixture.go_to("Received", 5);
    let (state, room) = (state_of(&fixture), room_of(&fixture));
    let said = super::super::patches::patch_values(&fixture.input(), 5).expect("a patch");
    let unshot = state.unshot(room).expect("a solver that shoots").patches[5];
    let english = Language::English;
    for value in [unshot, room.patches[5].area, room.reflectance[5].r] {
        assert!(said.contains(&english.short(value, 4)), "{value} in {said}");
    }
    assert!(
        said.contains("patch 5") && said.contains("B = 0\n"),
        "{said}"
    );
    assert_eq!(
        super::super::patches::patch_values(&fixture.input(), 1 << 20),
        None
    );
}

#[test]
fn the_light_begins_with_the_emission_and_ends_with_the_solution() {
    for solver in [
        Solver::GaussSeidel,
        Solver::ConjugateGradients,
        Solver::Shooting,
    ] {
        let mut fixture = Fixture::room(solver, Focus::Frame);
        let room = room_of(&fixture);
        assert_eq!(state_of(&fixture).light(room), room.emission);
        fixture.go_to("RoomDone", 0);
        let room = room_of(&fixture);
        let finished = room.light(room.matrix().expect("made")).expect("solved");
        let shown = state_of(&fixture).light(room);
        for (shown, finished) in shown.into_iter().zip(&finished.radiosity) {
            let apart = (shown - *finished).channels().map(f64::abs);
            // What is left unshot is below the tolerance of the solver.
            let allowed = if solver.shoots() { 1e-4 } else { 0.0 };
            assert!(apart.into_iter().all(|apart| apart <= allowed), "{apart:?}");
        }
    }
}

#[test]
fn a_smooth_room_shows_at_a_corner_the_mean_of_the_patches_that_meet_there() {
    let fixture = Fixture::room(Solver::Auto, Focus::Frame);
    let (prepared, room) = (stage_of(&fixture), room_of(&fixture));
    let view = RoomView::new(prepared, room);
    let fit = view.fit(Rect::new(10.0, 20.0, 700.0, 420.0));
    // Grey like a landscape whose height is the place: linear, so the mean at a corner between equal cells is the corner's own.
    let gray = |at: glam::DVec3| 0.5 + 0.05 * (at.x + 0.5 * at.z - at.y);
    let colors: Vec<Rgb> = room
        .patches
        .iter()
        .map(|patch| Rgb::splat(gray(patch.center)))
        .collect();
    let (place, image) = smooth::image(smooth_patches, room, &view, &fit, &colors);
    let mut picture = Picture::new(800.0, 500.0);
    picture.image(place, image);
    let pixels = crate::picture::rasterize(&picture, crate::picture::Theme::Light, 1.0).unwrap();
    let mut corners = 0;
    let all = room.patches.iter().enumerate();
    let outlines: Vec<(u32, glam::DVec3)> = all
        .flat_map(|(number, patch)| {
            let pieces = room.patches.pieces(number);
            pieces.flat_map(move |piece| piece.corners.iter().map(move |&at| (patch.object, at)))
        })
        .collect();
    for &(object, corner) in &outlines {
        let meeting = outlines
            .iter()
            .filter(|&&other| other == (object, corner))
            .count();
        let camera = prepared.view.to_camera(corner);
        // Of the floor: on the ball cells are not equal, and corners lie on its outline.
        if meeting != 4 || corner.y != 0.0 || camera.z <= prepared.view.near {
            continue;
        }
        let seen = prepared.view.to_screen(camera);
        let ray = Ray {
            origin: prepared.view.eye,
            direction: (corner - prepared.view.eye).normalize(),
        };
        let nearest = room
            .primitives
            .nearest(&ray)
            .map(|(patch, _)| room.patches[patch].object);
        let at = fit.place(seen);
        let Some(pixel) = pixels.pixel(at.x as u32, at.y as u32) else {
            continue;
        };
        if nearest != Some(object) {
            continue;
        }
        corners += 1;
        let recorded = f64::from(pixel.red());
        let [wanted, ..] = Rgb::splat(gray(corner)).to_srgb8();
        assert!(
            (recorded - f64::from(wanted)).abs() < 6.0,
            "{corner}: {recorded}, not {wanted}"
        );
    }
    assert!(corners > 20, "{corners} corners");
}
