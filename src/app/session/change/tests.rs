mod by_path;
mod questions;

use super::super::{Command, Session};
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::primary;
use crate::color::Rgb;
use crate::lesson::{Coefficient, Lesson, builtin};
use crate::methods::Setup;
use crate::panels::strings::Language;
use crate::panels::{Panel, draw};
use crate::picture::Picture;
use crate::record::Value;
use crate::render::render;
use crate::scene::{Light, Movable};
use glam::DVec3;
use std::num::NonZeroUsize;

const THERE: DVec3 = DVec3::new(-1.0, 2.0, 2.5);

fn lesson() -> Lesson {
    let mut lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
    lesson.parameters = vec![Parameter::Place(Movable::Light(0))];
    lesson
}

fn session() -> Session {
    Session::new(lesson()).unwrap()
}

fn put(session: &mut Session, position: DVec3) {
    let light = 0;
    session
        .update(Command::Change(Change::Place {
            of: Movable::Light(light),
            position,
        }))
        .unwrap();
}

fn picture(session: &mut Session) -> Picture {
    session.wait_for_picture();
    draw(
        Panel::Image,
        &session.panel_input(),
        glam::Vec2::new(400.0, 300.0),
    )
}

fn intensity(session: &Session) -> Value {
    let fields = session.walk().fields(session.step());
    fields.get("I_v").expect("a vertex that is lit")
}

#[test]
fn a_moved_light_is_seen_in_picture_run_and_narration_at_the_same_step() {
    let mut session = session();
    session.update(Command::Questions).unwrap();
    while session.narration_here().is_none() || session.walk().kind(session.step()) != "VertexLit" {
        session.update(Command::NextNarrated).unwrap();
    }
    let (step, recording) = (session.step(), session.recording());
    let said = |session: &Session| {
        session
            .narration_here()
            .unwrap()
            .text(Language::English)
            .to_owned()
    };
    let before = (intensity(&session), said(&session), picture(&mut session));
    put(&mut session, THERE);
    assert!(session.is_changed() && session.recording() > recording);
    assert_eq!(
        (session.step(), session.walk().kind(step)),
        (step, "VertexLit")
    );
    let after = (intensity(&session), said(&session), picture(&mut session));
    assert!(before.0 != after.0 && before.1 != after.1 && before.2 != after.2);

    let mut lit = lesson();
    let Light::Point { position, .. } = &mut lit.scene.lights[0] else {
        panic!("a point light")
    };
    *position = THERE;
    let open = lit.open().unwrap();
    let rays = |setup: &Setup| setup.settings.get::<primary::Settings>();
    assert_eq!(rays(&session.open.setup), rays(&open.setup));
    let rendered = render(
        &open.setup,
        open.lesson.method,
        NonZeroUsize::MIN,
        &|_, _| {},
    );
    assert!(session.panel_input().finished.picture == rendered);

    let recording = session.recording();
    put(&mut session, THERE);
    assert_eq!(session.recording(), recording, "it stood there already");
}

#[test]
fn a_light_goes_where_the_lesson_and_numbers_allow_and_nowhere_else() {
    let mut session = session();
    let far = DVec3::new(0.0, 2e75, 0.0);
    for (light, position, why) in [
        (1, THERE, strings::STAYS),
        (usize::MAX, THERE, strings::STAYS),
        (0, DVec3::NAN, strings::TOO_FAR),
        (0, DVec3::NEG_INFINITY, strings::TOO_FAR),
        (0, far, strings::TOO_FAR),
    ] {
        let command = Command::Change(Change::Place {
            of: Movable::Light(light),
            position,
        });
        assert_eq!(
            session.update(command),
            Err(why.into()),
            "{light} {position}"
        );
    }
    assert!(!session.is_changed() && session.recording() == 1);
    session.open.lesson.parameters.clear();
    let command = Command::Change(Change::Place {
        of: Movable::Light(0),
        position: THERE,
    });
    assert_eq!(session.allows(&command), Err(strings::STAYS.into()));
    assert_eq!(session.update(command), Err(strings::STAYS.into()));
}

#[test]
fn every_parameter_changes_run_and_picture_as_a_scene_with_that_value_would() {
    let mut lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
    let red = |coefficient| Parameter::Coefficient(0, coefficient);
    lesson.parameters = vec![
        red(Coefficient::Ambient),
        red(Coefficient::Diffuse),
        red(Coefficient::Specular),
        red(Coefficient::Shininess),
        Parameter::Place(Movable::Eye),
    ];
    let of_material = |coefficient, value| Change::Coefficient {
        material: 0,
        coefficient,
        value,
    };
    let eye = Change::Place {
        of: Movable::Eye,
        position: DVec3::new(1.0, -0.5, 4.0),
    };
    for change in [
        of_material(Coefficient::Ambient, 0.3),
        of_material(Coefficient::Diffuse, 0.0),
        of_material(Coefficient::Specular, 0.9),
        of_material(Coefficient::Shininess, 3.0),
        eye,
    ] {
        let mut session = Session::new(lesson.clone()).unwrap();
        let before = picture(&mut session);
        session.update(Command::Change(change)).unwrap();
        assert!(session.is_changed() && session.recording() == 2);
        assert_eq!(session.value(change.parameter()), Some(change));
        assert!(picture(&mut session) != before, "{change:?}");

        let mut written = lesson.clone();
        (written.scene, written.settings) = written.changed(&[change]).unwrap();
        let mut afresh = Session::new(written).unwrap();
        assert!(picture(&mut session) == picture(&mut afresh), "{change:?}");
        assert_eq!(session.walk().len(), afresh.walk().len());

        session.update(Command::Reset).unwrap();
        assert!(!session.is_changed() && picture(&mut session) == before);
    }
}

/// A ball of four divisions, drawn flat.
fn ball() -> Lesson {
    let json = r#"{ "schema": 1, "id": "ball", "number": 1, "topics": [],
        "title": { "en": "T", "id": "T" }, "summary": { "en": "S", "id": "S" },
        "scene": { "schema": 1, "materials": { "chalk": { "diffuse": [0.8, 0.4, 0.2] } },
            "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
            "objects": [{ "name": "ball", "material": "chalk", "sphere": { "center": [0, 0, 0], "radius": 1 }, "divisions": 4 }] },
        "method": "flat", "size": [24, 18], "focus": "frame", "panels": ["image"], "parameters": [{ "divisions": "ball" }],
        "steps": [{ "at": { "kind": "Frame" }, "say": { "en": "Begin", "id": "Mulai" } }] }"#;
    let lesson = Lesson::read(
        json.as_bytes(),
        &Default::default(),
        &mut |_| unreachable!(),
    );
    lesson.unwrap()
}

#[test]
fn a_colour_keeps_its_hue_and_comes_back_from_black() {
    let clay = Rgb::new(0.8, 0.4, 0.2);
    let mut lesson = ball();
    lesson.parameters = vec![Parameter::Coefficient(0, Coefficient::Diffuse)];
    let mut session = Session::new(lesson).unwrap();
    for (value, color) in [(0.4, clay * 0.5), (0.0, Rgb::BLACK), (0.8, clay)] {
        let change = Change::Coefficient {
            material: 0,
            coefficient: Coefficient::Diffuse,
            value,
        };
        session.update(Command::Change(change)).unwrap();
        assert_eq!(session.prepared().scene.materials[0].diffuse, color);
    }
    assert!(!session.is_changed());
}

#[test]
fn a_ball_is_divided_as_finely_as_requested() {
    let mut session = Session::new(ball()).unwrap();
    let polygons = |session: &Session| session.prepared().tessellation.polygon_count();
    assert_eq!(polygons(&session), 2 * 4 * 4);
    let mut divide = |divisions| {
        let object = 0;
        let change = Change::Divisions { object, divisions };
        let done = session.update(Command::Change(change));
        done.map(|()| polygons(&session))
    };
    assert_eq!(divide(9), Ok(2 * 9 * 9));
    assert_eq!(divide(1), Err(strings::OUT_OF_RANGE.into()));
    assert_eq!(divide(u32::MAX), Err(strings::OUT_OF_RANGE.into()));
}

#[test]
fn the_eye_goes_where_there_is_a_view() {
    let mut lesson = lesson();
    lesson.parameters = vec![Parameter::Place(Movable::Eye)];
    let mut session = Session::new(lesson).unwrap();
    let mut eye = |position| {
        session.update(Command::Change(Change::Place {
            of: Movable::Eye,
            position,
        }))
    };
    assert_eq!(eye(DVec3::ZERO), Err(strings::NO_VIEW.into()));
    assert_eq!(eye(DVec3::new(0.0, 5.0, 0.0)), Err(strings::NO_VIEW.into()));
    assert_eq!(eye(DVec3::INFINITY), Err(strings::TOO_FAR.into()));
    assert_eq!(eye(DVec3::new(0.0, 5.0, 0.1)), Ok(()));
}

#[test]
fn reset_puts_the_light_back() {
    let mut session = session();
    let as_opened = picture(&mut session);
    put(&mut session, THERE);
    session.update(Command::Focus(Focus::Frame)).unwrap();
    session.update(Command::Forward(9)).unwrap();
    session.update(Command::Reset).unwrap();
    assert!(!session.is_changed() && session.follows_lesson());
    assert_eq!(session.step(), 0);
    assert!(picture(&mut session) == as_opened);
}

#[test]
fn a_light_moved_elsewhere_is_moved_in_the_lesson_too() {
    let mut session = session();
    session.update(Command::Forward(5)).unwrap();
    let own = session.focus();
    session
        .update(Command::Focus(Focus::Pixel { x: 20, y: 15 }))
        .unwrap();
    let kind = session.walk().kind(session.step());
    put(&mut session, THERE);
    assert_eq!(session.focus(), Focus::Pixel { x: 20, y: 15 });
    assert_eq!(session.walk().kind(session.step()), kind);
    session.update(Command::Focus(own)).unwrap();
    assert_eq!(session.step(), 5);
    let mut moved_there = self::session();
    put(&mut moved_there, THERE);
    let said = |session: &Session| {
        let narrated = session.open.narrated.iter();
        narrated
            .map(|said| said.text(Language::English).to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(said(&session), said(&moved_there));
    assert_ne!(said(&session), said(&self::session()));
}

#[test]
fn what_does_not_happen_any_more_is_not_narrated() {
    let json = r#"{ "schema": 1, "id": "bright", "number": 1, "topics": [],
        "title": { "en": "T", "id": "T" }, "summary": { "en": "S", "id": "S" },
        "scene": { "schema": 1, "materials": { "chalk": { "diffuse": [1, 1, 1] } },
            "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
            "objects": [{ "name": "page", "material": "chalk", "polygon": { "vertices": [[-1, -1, 0], [1, -1, 0], [0, 1, 0]] } }],
            "lights": [{ "directional": { "toward": [0, 0, -1], "color": [0.1, 0.1, 0.1] } }, { "point": { "position": [0, 0, 3] } }] },
        "method": "gouraud", "size": [24, 18], "focus": "frame", "panels": ["image"], "parameters": [{ "light": 1 }],
        "steps": [{ "at": { "kind": "VertexLit", "where": { "I_v.r": { "above": 0.5 } } }, "say": { "en": "Lit", "id": "Terang" } }] }"#;
    let lesson = Lesson::read(
        json.as_bytes(),
        &Default::default(),
        &mut |_| unreachable!(),
    );
    let mut session = Session::new(lesson.unwrap()).unwrap();
    session.update(Command::NextNarrated).unwrap();
    let step = session.step();
    let mut put = |z: f64| {
        let position = DVec3::new(0.0, 0.0, z);
        session
            .update(Command::Change(Change::Place {
                of: Movable::Light(1),
                position,
            }))
            .unwrap();
        (
            session.is_silent(),
            session.step(),
            session.narration_here().is_some(),
        )
    };
    assert_eq!(put(-3.0), (true, step, false));
    assert_eq!(put(3.5), (false, step, true));
}

#[test]
fn the_panel_that_was_chosen_stays_large_while_a_light_is_moved() {
    let mut lesson = builtin("reflection").unwrap().read().unwrap();
    lesson.parameters = vec![Parameter::Place(Movable::Light(0))];
    let mut session = Session::new(lesson).unwrap();
    session.update(Command::Questions).unwrap();
    for _ in 0..4 {
        session.update(Command::NextNarrated).unwrap();
        session.update(Command::Key(Panel::RayTree)).ok();
        assert_eq!(session.key_panel(), Some(Panel::RayTree));
        // Through the floor: other rays, and other explanations.
        put(&mut session, DVec3::new(0.0, -5.0, 0.0));
        put(&mut session, THERE);
        assert_eq!(session.key_panel(), Some(Panel::RayTree));
    }
}
