use super::super::mistakes::{ScanConverter, Tracer};
use super::*;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::Settings;
use crate::color::Rgb;
use crate::render::render;
use crate::scene::{Limits, View, read};
use std::collections::BTreeSet;
use std::convert::Infallible;
use std::num::NonZeroU32;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A glass ball and a mirror before a wall behind the lamp, which is seen by shadow rays that go on too far.
const GLASS: &str = r#"{ "schema": 1, "background": [0.1, 0.2, 0.4],
    "camera": { "eye": [0.3, 1.2, 6], "target": [0, 0.8, 0], "up": [0, 1, 0], "fov_x_degrees": 45 },
    "materials": {
        "floor": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.5, 0.4, 0.3], "reflection": 0.3 },
        "glass": { "reflection": 0.1, "transmission": 0.8, "ior": 1.5 },
        "wall": { "ambient": [0.05, 0.1, 0.05], "diffuse": [0.2, 0.5, 0.3] } },
    "objects": [
        { "name": "floor", "material": "floor", "plane": { "point": [0, 0, 0], "normal": [0, 1, 0] } },
        { "name": "ball", "material": "glass", "sphere": { "center": [-0.8, 0.8, 0.5], "radius": 0.8 } },
        { "name": "post", "material": "wall", "sphere": { "center": [1.2, 0.7, -0.5], "radius": 0.7 } },
        { "name": "shade", "material": "wall", "sphere": { "center": [-2.4, 4.4, 3], "radius": 0.5 } } ],
    "lights": [ { "point": { "position": [-2, 3.4, 2.4], "color": [2, 2, 2], "attenuation": [0.5, 0.1, 0.05] } },
        { "point": { "position": [3, 4, 2], "color": [0.5, 0.5, 0.5] } } ] }"#;

/// Backs of polygons, a bubble in glass, a lamp behind surfaces, highlights by Phong, corners of unequal faces, and a mesh of them.
const OPEN: &str = r#"{ "schema": 1, "background": [0.3, 0.2, 0.4], "ambient": [0.8, 1, 0.9],
    "camera": { "eye": [0.2, 1.5, 5], "target": [0, 0.6, 0], "up": [0, 1, 0], "fov_x_degrees": 50 },
    "materials": {
        "sail": { "ambient": [0.1, 0.1, 0.2], "diffuse": [0.5, 0.6, 0.3], "specular": 0.5, "shininess": 3, "highlight": "phong" },
        "glass": { "ambient": [0.2, 0.2, 0.2], "diffuse": [0.2, 0.2, 0.2], "specular": 0.4, "shininess": 20, "transmission": 0.9, "ior": 1.6 },
        "air": { "transmission": 1, "ior": 1 },
        "tin": { "ambient": [0.1, 0.05, 0.02], "diffuse": [0.4, 0.3, 0.2], "specular": 0.6, "shininess": 8, "reflection": 0.4 } },
    "objects": [
        { "name": "sail", "material": "sail", "polygon": { "vertices": [[-2, 0, -1], [-1.4, 2.6, -1.3], [0.2, 0.1, -1.8]] } },
        { "name": "floor", "material": "tin", "plane": { "point": [0, -0.3, 0], "normal": [0, 1, 0] } },
        { "name": "ball", "material": "glass", "sphere": { "center": [0.9, 0.7, 0.6], "radius": 0.7 } },
        { "name": "bubble", "material": "air", "sphere": { "center": [0.9, 0.7, 0.6], "radius": 0.315 } },
        { "name": "tent", "material": "tin", "mesh": { "file": "tent.obj" } } ],
    "lights": [ { "point": { "position": [2, 3, 3], "color": [1, 0.9, 0.8], "attenuation": [0.6, 0.1, 0.02] } },
        { "point": { "position": [-2, 2, -4], "color": [0.5, 0.6, 0.7] } } ] }"#;

/// Three triangles of very unequal areas.
const TENT: &str = "v -0.9 0 1\nv 0.1 0 1.2\nv -0.2 0.9 0.4\nv -2 0 0\nv 0.3 0.2 -0.6\n\
    f 1 2 3\nf 1 3 4\nf 2 5 3\n";

/// An open corner of coloured patches of unequal size.
const CORNER: &str = r#"{ "schema": 1,
    "camera": { "eye": [2.5, 2, 3], "target": [0.3, 0.4, 0.3], "up": [0, 1, 0], "fov_x_degrees": 55 },
    "materials": {
        "red": { "reflectance": [0.8, 0.2, 0.1] }, "blue": { "reflectance": [0.1, 0.3, 0.7] },
        "lamp": { "emission": [2, 1.8, 1.5], "reflectance": [0.3, 0.3, 0.3] } },
    "objects": [
        { "name": "floor", "material": "red", "polygon": { "vertices": [[0, 0, 2], [2, 0, 2], [2, 0, 0], [0, 0, 0]] }, "patches": [4, 4] },
        { "name": "back", "material": "blue", "polygon": { "vertices": [[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0]] }, "patches": [2, 1] },
        { "name": "side", "material": "lamp", "polygon": { "vertices": [[0, 0, 2], [0, 0, 0], [0, 1, 0], [0, 1, 2]] }, "patches": [1, 1] } ] }"#;

fn setup(scene: &str, size: [u32; 2]) -> Setup {
    let scene = read(scene.as_bytes(), &Limits::default(), &mut |_| {
        Ok(TENT.into())
    })
    .unwrap();
    let view = View::new(&scene.camera.unwrap(), size[0], size[1]);
    // Few levels, so that one more is seen.
    let depth = NonZeroU32::new(3).unwrap();
    let settings = Settings {
        depth,
        ..Settings::default()
    };
    Setup::new(PreparedScene::new(scene, view), settings)
}

fn stored(frame: &Frame, encoding: Encoding, is_float: bool) -> StoredImage {
    StoredImage {
        width: frame.width,
        height: frame.rows.len() as u32,
        pixels: encoded(frame, encoding, is_float),
        is_float,
    }
}

const ONE: NonZeroUsize = NonZeroUsize::MIN;

fn go_on(_: usize, _: usize) -> Result<(), Infallible> {
    Ok(())
}

fn compared(mine: &StoredImage, setup: &Setup, method: Method) -> Comparison {
    let Ok(found) = compare(mine, setup, method, TOLERANCE, ONE, &go_on, |_| {});
    found
}
const TOLERANCE: f64 = 1.0 / 255.0;

/// Scenes, each drawn by a method.
fn scenes() -> [(&'static str, &'static str, Method); 12] {
    use Method::{Flat, Gouraud, Phong, Radiosity, RayCasting, RayTracing};
    let mirror = include_str!("../../../lessons/scenes/one-mirror.json");
    let grey_room = include_str!("../../../lessons/scenes/grey-room.json");
    [
        ("glass", GLASS, RayTracing),
        ("glass", GLASS, RayCasting),
        ("glass", GLASS, Phong),
        ("open", OPEN, RayTracing),
        ("open", OPEN, Gouraud),
        ("open", OPEN, Flat),
        ("open", OPEN, Phong),
        ("open", OPEN, RayCasting),
        ("mirror", mirror, RayTracing),
        ("mirror", mirror, RayCasting),
        ("grey room", grey_room, Radiosity),
        ("corner", CORNER, Radiosity),
    ]
}

#[test]
fn every_mistake_is_distinguished_from_all_others_by_its_own_picture() {
    let mut named: BTreeSet<&str> = BTreeSet::new();
    for (name, scene, method) in scenes() {
        let setup = setup(scene, [40, 30]);
        let frame = render(&setup, method, ONE, &|_, _| {});
        let reference = encoded(&frame, Encoding::Srgb, false);
        let Ok(mistaken) = mistaken(&setup, method, &frame, (Encoding::Srgb, false), ONE, &go_on);
        for (mistake, wrong) in &mistaken {
            let differs = differing(wrong, &reference, TOLERANCE);
            let differing = differs.iter().filter(|&&differs| differs).count();
            if differing == 0 {
                continue;
            }
            let mine = StoredImage {
                width: 40,
                height: 30,
                pixels: wrong.clone(),
                is_float: false,
            };
            let found = explanations(&mine, TOLERANCE, &reference, &mistaken);
            let is_right =
                |found: &&Explanation| (found.explains, found.rms_after) == (differing, 0.0);
            let right: Vec<&str> = found
                .iter()
                .take_while(is_right)
                .map(|found| found.name)
                .collect();
            assert!(
                right.contains(&mistake.name()),
                "{name}, {}: {found:?}",
                mistake.name()
            );
            if right.len() == 1 {
                named.insert(mistake.name());
            }
        }
    }
    let missing = Mistake::ALL.iter().map(|mistake| mistake.name());
    let missing: Vec<_> = missing.filter(|name| !named.contains(name)).collect();
    assert!(missing.is_empty(), "never alone: {missing:?}");
}

#[test]
fn two_mistakes_at_once_are_named_first_where_they_touch_different_pixels() {
    let setup = setup(OPEN, [40, 30]);
    let frame = render(&setup, Method::RayTracing, ONE, &|_, _| {});
    let reference = encoded(&frame, Encoding::Srgb, false);
    let encoding = (Encoding::Srgb, false);
    let Ok(mistaken) = mistaken(&setup, Method::RayTracing, &frame, encoding, ONE, &go_on);
    let (one, other) = (Mistake::ReflectionForgotten, Mistake::EtaInverted);
    let both = one.wrong_input(&setup).unwrap();
    let both = other.wrong_input(&both).unwrap();
    let both = render(&both, Method::RayTracing, ONE, &|_, _| {});
    let mine = stored(&both, Encoding::Srgb, false);
    let found = explanations(&mine, TOLERANCE, &reference, &mistaken);
    let first: Vec<&str> = found.iter().take(2).map(|found| found.name).collect();
    assert_eq!(first, [one.name(), other.name()], "{found:?}");
}

#[test]
fn the_small_programs_without_a_mistake_draw_the_reference() {
    for (name, scene, method) in scenes() {
        let setup = setup(scene, [40, 30]);
        let frame = render(&setup, method, ONE, &|_, _| {});
        let only_casts = method == Method::RayCasting;
        let own = match method {
            Method::Radiosity => continue,
            Method::RayCasting | Method::RayTracing => Tracer::new(&setup, only_casts, None)
                .picture(Workers::ONE)
                .unwrap(),
            _ => ScanConverter::new(&setup, method, None).picture(),
        };
        let distance_of = |(a, b): (&Rgb, &Rgb)| distance(a.channels(), b.channels());
        let largest = frame
            .color
            .iter()
            .zip(&own.color)
            .map(distance_of)
            .fold(0.0, f64::max);
        assert!(largest < 1e-12, "{name} by {}: {largest:e}", method.name());
    }
}

#[test]
fn a_right_picture_names_no_mistake_in_any_encoding_of_its_format() {
    let setup = setup(GLASS, [32, 24]);
    for method in [Method::RayTracing, Method::RayCasting, Method::Phong] {
        let frame = render(&setup, method, ONE, &|_, _| {});
        for is_float in [false, true] {
            let encoding = if is_float {
                Encoding::Linear
            } else {
                Encoding::Srgb
            };
            let mine = stored(&frame, encoding, is_float);
            let found = compared(&mine, &setup, method);
            assert_eq!((found.off, found.largest), (0, 0.0));
            assert_eq!(found.encoding, encoding.name());
            assert!(found.mistakes.is_empty() && found.worst.is_empty());
        }
    }
}

#[test]
fn one_wrong_pixel_is_the_worst_and_no_mistake_explains_it() {
    let setup = setup(GLASS, [32, 24]);
    let frame = render(&setup, Method::RayTracing, ONE, &|_, _| {});
    let mut mine = stored(&frame, Encoding::Srgb, false);
    mine.pixels[5 + 32 * 7] = [1.0, 0.0, 1.0];
    let found = compared(&mine, &setup, Method::RayTracing);
    assert_eq!((found.off, found.pixels), (1, 32 * 24));
    assert_eq!((found.worst[0].x, found.worst[0].y), (5, 7));
    assert!(found.mistakes.is_empty(), "{:?}", found.mistakes);
}

/// What a program could draw that makes none of the mistakes.
#[test]
fn a_picture_that_is_wrong_in_another_way_names_no_mistake_that_makes_it_worse() {
    for (name, scene, method) in scenes() {
        let setup = setup(scene, [40, 30]);
        let frame = render(&setup, method, ONE, &|_, _| {});
        let right = stored(&frame, Encoding::Srgb, false);
        let changed = |change: &dyn Fn(usize, [f64; 3]) -> [f64; 3]| StoredImage {
            pixels: (0..)
                .zip(&right.pixels)
                .map(|(at, &pixel)| change(at, pixel))
                .collect(),
            ..right.clone()
        };
        let grey = |pixel: [f64; 3]| [pixel.iter().sum::<f64>() / 3.0; 3];
        let wrongs = [
            changed(&|_, _| [0.0; 3]),
            changed(&|_, pixel| grey(pixel)),
            changed(&|at, pixel| if at % 7 < 2 { [0.0; 3] } else { pixel }),
            changed(&|at, pixel| {
                if at % 40 > 24 {
                    pixel.map(|c| 0.3 * c)
                } else {
                    pixel
                }
            }),
        ];
        let encoding = (Encoding::Srgb, false);
        let Ok(mistaken) = mistaken(&setup, method, &frame, encoding, ONE, &go_on);
        for (number, mine) in wrongs.iter().enumerate() {
            let before = rms(&mine.pixels, &right.pixels);
            for found in explanations(mine, TOLERANCE, &right.pixels, &mistaken) {
                let place = format!("{name} by {}, {number}: {found:?}", method.name());
                assert!(found.rms_after < 0.96 * before, "{place}");
            }
        }
    }
}

#[test]
fn absolute_cosines_and_added_shadows_are_not_taken_for_a_mistake_that_spoils_the_rest() {
    let matte = GLASS
        .replace("\"reflection\": 0.3", "\"reflection\": 0")
        .replace("0.8, \"ior\"", "0, \"ior\"");
    let setup = setup(
        &matte.replace("\"reflection\": 0.1", "\"reflection\": 0"),
        [40, 30],
    );
    let lit = stored(
        &render(&setup, Method::RayCasting, ONE, &|_, _| {}),
        Encoding::Srgb,
        false,
    );
    let from_behind = Tracer::new(&setup, true, Some(Mistake::LightToPoint))
        .picture(Workers::ONE)
        .unwrap();
    let from_behind = stored(&from_behind, Encoding::Srgb, false);
    let pairs = lit.pixels.iter().zip(&from_behind.pixels);
    let brighter = |(a, b): (&[f64; 3], &[f64; 3])| std::array::from_fn(|c| a[c].max(b[c]));
    let absolute = StoredImage {
        pixels: pairs.map(brighter).collect(),
        ..lit
    };
    let shadows = stored(
        &render(&setup, Method::RayTracing, ONE, &|_, _| {}),
        Encoding::Srgb,
        false,
    );
    for mine in [absolute, shadows] {
        let found = compared(&mine, &setup, Method::RayCasting);
        assert!(found.off > 10, "{}", found.off);
        let names: Vec<_> = found.mistakes.iter().map(|found| found.name).collect();
        assert_eq!(names, [""; 0]);
    }
}

#[test]
fn nothing_follows_a_mistake_that_explains_everything_but_what_gives_the_same_picture() {
    let setup = setup(OPEN, [40, 30]);
    let frame = render(&setup, Method::RayTracing, ONE, &|_, _| {});
    let encoding = (Encoding::Srgb, false);
    let Ok(mistaken) = mistaken(&setup, Method::RayTracing, &frame, encoding, ONE, &go_on);
    let reference = encoded(&frame, Encoding::Srgb, false);
    let (_, wrong) = mistaken
        .iter()
        .find(|(mistake, _)| *mistake == Mistake::FlipY)
        .unwrap();
    let mut mine = stored(&frame, Encoding::Srgb, false);
    mine.pixels.clone_from(wrong);
    let found = explanations(&mine, TOLERANCE, &reference, &mistaken);
    assert_eq!(found.len(), 1, "{found:?}");
}

#[test]
fn the_encoding_is_that_of_the_format_unless_a_mistake_of_it_explains_most() {
    let setup = setup(GLASS, [32, 24]);
    let frame = render(&setup, Method::RayTracing, ONE, &|_, _| {});
    for (is_float, encoding, said, mistake) in [
        (false, Encoding::Linear, "linear", "no_srgb"),
        (false, Encoding::SrgbTwice, "srgb", "srgb_twice"),
        (true, Encoding::Srgb, "srgb", "srgb_twice"),
    ] {
        let mine = stored(&frame, encoding, is_float);
        let found = compared(&mine, &setup, Method::RayTracing);
        let first = found.mistakes.first().map(|found| found.name);
        assert_eq!((found.encoding, first), (said, Some(mistake)));
    }
}

#[test]
fn a_comparison_asks_at_every_row_whether_to_go_on_and_stops_where_it_is_not_to() {
    let lesson = crate::lesson::builtin("refraction")
        .unwrap()
        .read()
        .unwrap();
    let [width, height] = [30, 20];
    let prepared = PreparedScene::of_size(lesson.scene.clone(), [width, height]).unwrap();
    let setup = Setup::new(prepared, lesson.settings.clone());
    let mine = StoredImage {
        width,
        height,
        pixels: vec![[0.5; 3]; (width * height) as usize],
        is_float: false,
    };
    // How often it asks where it is called off at the n-th time.
    let asked = |n: usize| {
        let asked = AtomicUsize::new(0);
        let go_on = |_, _| match asked.fetch_add(1, Ordering::Relaxed) + 1 < n {
            true => Ok(()),
            false => Err(()),
        };
        let one = NonZeroUsize::MIN;
        let found = compare(&mine, &setup, lesson.method, 0.0, one, &go_on, |_| {});
        (found.is_ok(), asked.into_inner())
    };
    let (is_whole, all) = asked(usize::MAX);
    let mistakes = Mistake::ALL.into_iter();
    let drawn = mistakes.filter(|mistake| mistake.concerns(lesson.method));
    assert!(
        is_whole && all >= height as usize * drawn.count() / 2,
        "{all}"
    );
    for n in [1, 2, 21, all / 3, all / 2, all] {
        let (is_whole, asked) = asked(n);
        // Once more behind the picture that ends.
        assert!(!is_whole && asked <= n + 1, "{asked} times at {n}");
    }
}
