use super::super::Command;
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::lesson::builtin;
use crate::methods::Mistake;
use crate::picture::Tag;
use crate::render::render;
use crate::scene::{Limits, View, read};
use crate::study::mistakes::Workers;

const GLASS: &str = r#"{ "schema": 1, "background": [0.2, 0.3, 0.5],
    "camera": { "eye": [0, 0.6, 4], "target": [0, 0.4, 0], "up": [0, 1, 0], "fov_x_degrees": 50 },
    "materials": {
        "floor": { "diffuse": [0.6, 0.5, 0.4], "texture": { "checker": { "colors": [[1, 1, 1], [0.2, 0.2, 0.2]], "scale": 0.4 } } },
        "glass": { "transmission": 0.9, "reflection": 0.1, "ior": 1.5 } },
    "objects": [
        { "name": "floor", "material": "floor", "plane": { "point": [0, -0.6, 0], "normal": [0, 1, 0] } },
        { "name": "ball", "material": "glass", "sphere": { "center": [0, 0.4, 0], "radius": 0.9 }, "casts_shadow": false } ],
    "lights": [{ "point": { "position": [3, 5, 4] } }] }"#;

pub fn walk() -> Session {
    let scene = read(
        GLASS.as_bytes(),
        &Limits::default(),
        &mut |_| unreachable!(),
    )
    .unwrap();
    let view = View::new(&scene.camera.unwrap(), 60, 40);
    Session::new(Lesson::of_scene("glass", PreparedScene::new(scene, view))).unwrap()
}

/// What a program would have stored of the session's scene in that size, right or with a mistake.
fn stored(session: &Session, size: [u32; 2], mistake: Option<Mistake>) -> StoredImage {
    use crate::study::mistakes::Encoding;
    let lesson = session.lesson().of_size(size);
    let setup = lesson.setup(lesson.scene.clone(), lesson.settings.clone());
    let (setup, one) = (setup.unwrap(), NonZeroUsize::MIN);
    let right = render(&setup, lesson.method, one, &|_, _| {});
    let frame = match mistake {
        None => right,
        Some(mistake) => {
            let made = mistake.picture(&setup, lesson.method, &right, Encoding::Srgb, Workers::ONE);
            made.unwrap().0
        }
    };
    let byte = |byte: u8| f64::from(byte) / 255.0;
    StoredImage {
        width: size[0],
        height: size[1],
        pixels: frame.color.iter().map(|c| c.to_srgb8().map(byte)).collect(),
        is_float: false,
    }
}

#[test]
fn a_picture_with_a_mistake_is_recognised_and_a_pixel_of_it_is_walked() {
    let mut session = walk();
    let size = [48, 32];
    let mine = stored(&session, size, Some(Mistake::EtaInverted));
    session.compare_with("mine.png".into(), mine).unwrap();
    // The walk has taken on the size of the picture.
    assert_eq!(session.lesson().size, size);
    assert_eq!(session.look.drawer, Some(Drawer::Against));
    session.wait_for_comparison();
    let found = session.against().unwrap().found.clone().unwrap();
    assert_eq!((found.size, found.encoding), (size, "srgb"));
    let best = &found.mistakes[0];
    assert_eq!(
        (best.mistake, best.explains),
        (Mistake::EtaInverted, found.off)
    );
    let worst = &found.worst[0];
    let at = Focus::Pixel {
        x: worst.x,
        y: worst.y,
    };
    session
        .update(Command::Go(Tag::Pixel {
            x: worst.x,
            y: worst.y,
        }))
        .unwrap();
    assert_eq!(session.focus(), at);
}

#[test]
fn the_comparison_goes_on_when_the_method_changes_and_ends_with_another_lesson() {
    let mut session = walk();
    let mine = stored(&session, [60, 40], None);
    session.compare_with("mine.png".into(), mine).unwrap();
    session.wait_for_comparison();
    assert_eq!(session.against().unwrap().found.as_ref().unwrap().off, 0);
    session.update(Command::Method(Method::RayCasting)).unwrap();
    session.wait_for_comparison();
    let found = session.against().unwrap().found.clone().unwrap();
    assert!(found.off > 0, "casting knows no glass");
    let lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
    session.open_document(lesson, None).unwrap();
    assert!(session.against().is_none() && session.look.drawer.is_none());
    assert_eq!(
        session.update(Command::Against),
        Err(strings::COMPARE_HOW.into())
    );
}

#[test]
fn a_picture_of_another_size_than_the_lessons_is_refused_with_both_sizes() {
    let lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
    let [width, height] = lesson.size;
    let mut session = Session::new(lesson).unwrap();
    let mine = StoredImage {
        width: 7,
        height: 5,
        pixels: vec![[0.0; 3]; 35],
        is_float: false,
    };
    let Err(Refused::Error(why)) = session.compare_with("mine.png".into(), mine.clone()) else {
        panic!("it is refused");
    };
    assert!(why.contains("7 × 5"), "{why}");
    assert!(why.contains(&format!("{width} × {height}")), "{why}");
    assert!(session.against().is_none());
    session.look.home = true;
    assert_eq!(
        session.compare_with("mine.png".into(), mine),
        Err(strings::COMPARE_WHERE.into())
    );
}
