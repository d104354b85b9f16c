use super::super::against::tests::walk;
use super::super::{Command, Session};
use super::*;
use crate::algorithms::focus::Focus;
use crate::lesson::{builtin, builtins};
use crate::picture::Tag;
use crate::render::render;
use crate::scene::{Limits, View, read};
use crate::study::mistakes::{Encoding, Workers};

#[test]
fn every_mistake_that_the_method_allows_is_listed_with_how_much_it_changes() {
    let mut session = walk();
    session.update(Command::WhatIf).unwrap();
    session.wait_for_mistakes();
    let off = |mistake| session.what_if().off(mistake);
    assert!(session.possible_mistakes().count() > 25);
    for mistake in Mistake::ALL {
        assert_eq!(
            off(mistake).is_some(),
            mistake.concerns(Method::RayTracing),
            "{}",
            mistake.name()
        );
    }
    assert_eq!(off(Mistake::NoAttenuation), Some(0), "the lamp has none");
    assert!(off(Mistake::EtaInverted).unwrap() > 100);
    assert!(off(Mistake::FlipY).unwrap() > off(Mistake::EtaInverted).unwrap());
}

#[test]
fn a_mistake_that_is_switched_on_shows_what_a_program_with_it_would_store() {
    let mut session = walk();
    let mistake = Mistake::EtaInverted;
    session.update(Command::Mistake(Some(mistake))).unwrap();
    assert_eq!(session.look.drawer, Some(Drawer::WhatIf));
    session.wait_for_mistakes();
    let (setup, method, one) = (session.setup(), session.lesson().method, NonZeroUsize::MIN);
    let right = render(setup, method, one, &|_, _| {});
    let (wrong, _) = mistake
        .picture(setup, method, &right, Encoding::Srgb, Workers::ONE)
        .unwrap();
    let byte = |byte: u8| f64::from(byte) / 255.0;
    let stored = |frame: &Frame| -> Vec<[f64; 3]> {
        let colors = frame.color.iter();
        colors.map(|color| color.to_srgb8().map(byte)).collect()
    };
    let (mine, found) = session.what_if().made.clone().unwrap();
    assert_eq!(mine.pixels, stored(&wrong));
    assert_eq!(found.reference, stored(&right));
    assert_eq!(session.what_if().off(mistake), Some(found.off));
    let worst = &found.worst[0];
    let (x, y) = (worst.x, worst.y);
    session.update(Command::Go(Tag::Pixel { x, y })).unwrap();
    assert_eq!(session.focus(), Focus::Pixel { x, y });
    assert_eq!(session.what_if().on, Some(mistake));
    session.update(Command::Mistake(None)).unwrap();
    assert!(session.what_if().made.is_none());
}

#[test]
fn the_mistake_follows_the_method_and_ends_where_that_cannot_make_it() {
    let mut session = walk();
    for (mistake, stays) in [(Mistake::EtaInverted, false), (Mistake::FlipY, true)] {
        session.update(Command::Mistake(Some(mistake))).unwrap();
        session.wait_for_mistakes();
        let by_rays = session.what_if().made.clone().unwrap();
        let other = match session.lesson().method {
            Method::RayTracing => Method::RayCasting,
            _ => Method::RayTracing,
        };
        session.update(Command::Method(other)).unwrap();
        assert_eq!(session.what_if().on.is_some(), stays);
        session.wait_for_mistakes();
        let now = session.what_if().made.clone();
        assert_eq!(now.is_some(), stays);
        assert!(now.is_none_or(|(mine, _)| mine.pixels != by_rays.0.pixels));
    }
    let lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
    session.open_document(lesson, None).unwrap();
    assert!(session.what_if().on.is_none());
}

#[test]
fn a_mistake_that_shows_nowhere_has_no_picture() {
    let mut session = walk();
    let mistake = Mistake::NoAttenuation;
    session.update(Command::Mistake(Some(mistake))).unwrap();
    session.wait_for_mistakes();
    let what_if = session.what_if();
    assert_eq!(
        (what_if.off(mistake), what_if.made.is_none()),
        (Some(0), true)
    );
}

#[test]
fn a_pixel_of_a_room_leads_to_the_patch_that_is_seen_there() {
    let scene = include_str!("../../../../lessons/scenes/grey-room.json");
    let scene = read(
        scene.as_bytes(),
        &Limits::default(),
        &mut |_| unreachable!(),
    )
    .unwrap();
    let view = View::new(&scene.camera.unwrap(), 40, 30);
    let prepared = crate::algorithms::prepared_scene::PreparedScene::new(scene, view);
    let mut session = Session::new(crate::lesson::Lesson::of_scene("room", prepared)).unwrap();
    session.update(Command::WhatIf).unwrap();
    session.wait_for_mistakes();
    for mistake in [Mistake::ReflectanceForgotten, Mistake::PiTwice] {
        assert!(
            session.what_if().off(mistake).unwrap() > 0,
            "{}",
            mistake.name()
        );
    }
    assert_eq!(session.what_if().off(Mistake::TirBlack), None);
    let before = session.step();
    let at = Tag::Pixel { x: 20, y: 15 };
    session.update(Command::Go(at)).unwrap();
    assert_ne!(session.step(), before);
    let fields = session.walk().own_fields(session.step());
    let patch = ["patch", "i", "j"]
        .into_iter()
        .find_map(|name| fields.get(name));
    assert!(patch.is_some(), "{fields:?}");
}

#[test]
fn every_mistake_that_a_lesson_names_changes_its_picture() {
    let one = NonZeroUsize::MIN;
    let mut lessons_with_mistakes = 0;
    for builtin in builtins() {
        let session = Session::new(builtin.read().unwrap()).unwrap();
        let (setup, method) = (session.setup(), session.lesson().method);
        let named: Vec<Mistake> = session
            .explained()
            .iter()
            .filter_map(|said| said.mistake)
            .collect();
        if named.is_empty() {
            continue;
        }
        lessons_with_mistakes += 1;
        let right = render(setup, method, one, &|_, _| {});
        for mistake in named {
            let drawn = with_mistake(mistake, (setup, method), &right, TOLERANCE, Workers::ONE);
            let off = drawn.map_or(0, |(_, found)| found.off);
            assert!(off > 0, "{} in {}", mistake.name(), session.lesson().id);
        }
    }
    assert!(lessons_with_mistakes >= 12);
}
