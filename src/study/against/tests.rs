use super::*;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::Settings;
use crate::scene::{Limits, View, read};
use std::collections::BTreeSet;
use std::num::NonZeroU32;

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

fn setup(scene: &str, size: [u32; 2]) -> Setup {
    let scene = read(
        scene.as_bytes(),
        &Limits::default(),
        &mut |_| unreachable!(),
    )
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
const TOLERANCE: f64 = 1.0 / 255.0;

#[test]
fn every_mistake_is_the_first_that_its_own_picture_names() {
    let setup = setup(GLASS, [64, 48]);
    let method = Method::RayTracing;
    let frame = render(&setup, method, ONE, &|_, _| {});
    let mut known = BTreeSet::new();
    for mistake in Mistake::ALL {
        let (wrong, encoding) = mistake
            .picture(&setup, method, &frame, Encoding::Srgb, ONE)
            .unwrap_or_else(|| panic!("{} changes nothing", mistake.name()));
        let found = compare(
            &stored(&wrong, encoding, false),
            &setup,
            method,
            TOLERANCE,
            ONE,
        );
        let first = found.mistakes.first().map(|found| found.name);
        assert_eq!(first, Some(mistake.name()), "{:?}", found.mistakes);
        assert_eq!(found.mistakes[0].explains, found.off);
        assert!(found.mistakes[0].rms_after < 1e-9);
        known.insert(mistake.name());
    }
    assert_eq!(known.len(), Mistake::ALL.len());
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
            let found = compare(&mine, &setup, method, TOLERANCE, ONE);
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
    let found = compare(&mine, &setup, Method::RayTracing, TOLERANCE, ONE);
    assert_eq!((found.off, found.pixels), (1, 32 * 24));
    assert_eq!((found.worst[0].x, found.worst[0].y), (5, 7));
    assert!(found.mistakes.is_empty(), "{:?}", found.mistakes);
}
