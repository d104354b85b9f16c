//! What scenes do not need is left out, and nothing changes by it but the time.

use crate::common::{TEAPOT, setup};
use lightwalk::algorithms::enclosure::Settings;
use lightwalk::algorithms::radiosity::Solver;
use lightwalk::methods::{Method, Setup};
use lightwalk::render::render;
use lightwalk::scene::{Part, Parts};
use lightwalk::study::ablation::{Ablations, Sameness, ablations};
use lightwalk::study::timing::Patience;
use std::num::NonZeroUsize;
use std::process::Command;
use std::time::Duration;

fn lesson_scene(name: &str) -> Setup {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/scenes/");
    let json = std::fs::read_to_string(format!("{folder}{name}.json")).unwrap();
    setup(&json, 48, 36)
}

/// Each part once, and for how many of how many where it does not concern all.
fn recorded(setup: &Setup, method: Method) -> Vec<(Part, Option<[usize; 2]>)> {
    let skipped = setup.skipped(method);
    let mut recorded: Vec<_> = skipped.iter().map(|one| (one.part, one.share)).collect();
    recorded.dedup();
    recorded
}

#[test]
fn the_scenes_of_the_lesson_need_what_they_say() {
    use Part::*;
    let plain = [LightBalls, PathAttenuation].map(|part| (part, None));
    let ray_traced = [
        (
            "all-diffuse",
            vec![
                ReflectedRays,
                TransmittedRays,
                TextureCoordinates,
                Highlights,
            ],
            None,
        ),
        (
            "one-mirror",
            vec![TransmittedRays, TextureCoordinates],
            None,
        ),
        (
            "open-scene",
            vec![ReflectedRays, TransmittedRays, TextureCoordinates],
            Some((ShadowRays, Some([3, 4]))),
        ),
    ];
    for (name, materials, shadows) in ray_traced {
        let materials = materials.into_iter().map(|part| (part, None));
        let expected: Vec<_> = materials.chain(plain).chain(shadows).collect();
        assert_eq!(
            recorded(&lesson_scene(name), Method::RayTracing),
            expected,
            "{name}"
        );
    }
    // 16 patches a wall: of the pairs, those in one wall face away; in a convex room nothing parts the others.
    let pairs = [
        (FacingAway, Some([6 * 16 * 15 / 2, 96 * 95 / 2])),
        (SightTests, Some([15 * 16 * 16, 15 * 16 * 16])),
    ];
    for (name, channels) in [
        ("closed-room", (BlackRows, Some([16, 96]))),
        ("grey-room", (EqualChannels, None)),
        ("no-light", (DarkChannels, None)),
    ] {
        let expected: Vec<_> = [channels].into_iter().chain(pairs).collect();
        assert_eq!(
            recorded(&lesson_scene(name), Method::Radiosity),
            expected,
            "{name}"
        );
    }
}

fn measured(setup: &Setup, method: Method) -> Ablations {
    let hasty = Patience {
        shortest: Duration::ZERO,
        longest: Duration::from_secs(3600),
        whole: Duration::ZERO,
        most_rounds: 5,
    };
    ablations(setup, method, hasty, &|_, _| {}).expect("a run")
}

/// That every part, done all the same, gives the same bits, or the same to the tolerance for `rounded` ones.
fn assert_same(setup: &Setup, method: Method, rounded: &[Part]) {
    let ablations = measured(setup, method);
    assert!(!ablations.parts.is_empty(), "{}", method.name());
    for ablation in &ablations.parts {
        let measured = ablation.measured.as_ref().expect("a run");
        let may_round =
            ablation.part.is_none_or(|part| rounded.contains(&part)) && !rounded.is_empty();
        let same = match measured.sameness {
            Sameness::Same => true,
            Sameness::Within(_) => may_round,
            Sameness::Differs(_) => false,
        };
        assert!(
            same,
            "{} {:?}: {:?}",
            method.name(),
            ablation.part,
            measured.sameness
        );
        assert!(measured.steps.count >= ablations.steps.count);
    }
}

#[test]
fn rays_left_out_change_no_bit() {
    for name in ["all-diffuse", "one-mirror", "open-scene"] {
        for method in [Method::RayCasting, Method::RayTracing] {
            assert_same(&lesson_scene(name), method, &[]);
        }
    }
}

#[test]
fn polygons_without_textures_and_highlights_stay_the_same() {
    let matt = TEAPOT
        .replace("\"specular\": 0.5, ", "")
        .replace("\"specular\": 0.1, ", "");
    let setup = setup(&matt, 48, 36);
    assert_eq!(
        recorded(&setup, Method::Phong),
        [(Part::TextureCoordinates, None), (Part::Highlights, None)]
    );
    // A texture takes the diffuse part of an interpolated intensity out and puts it back in.
    let rounded = [Part::TextureCoordinates];
    assert_same(&setup, Method::Flat, &rounded);
    assert_same(&setup, Method::Gouraud, &rounded);
    assert_same(&setup, Method::Phong, &[]);
    assert_same(&setup, Method::FastPhong, &rounded);
}

#[test]
fn the_light_of_a_room_stays_the_same() {
    let others = [Solver::GaussSeidel, Solver::OverRelaxation, Solver::Direct];
    let all = ["closed-room", "grey-room", "no-light"].map(|name| (name, Solver::Auto));
    for (name, solver) in all
        .into_iter()
        .chain(others.map(|solver| ("closed-room", solver)))
    {
        let settings = Settings {
            solver,
            ..Settings::default()
        };
        let setup = Setup::new(lesson_scene(name).prepared, settings);
        // What is in a plane is so but for rounding; LU and over-relaxation of fewer unknowns round otherwise.
        let rounded = [Part::FacingAway, Part::BlackRows];
        assert_same(&setup, Method::Radiosity, &rounded);
    }
}

#[test]
fn rays_between_patches_that_nothing_can_part_are_never_blocked() {
    let setup = lesson_scene("cornell-box");
    let matrix = |parts| {
        let setup = setup.with_forced(parts);
        let enclosure = setup.enclosure().expect("patches");
        enclosure.form_factors().matrix()
    };
    assert!(matrix(Parts::NONE) == matrix(Parts::from(Part::SightTests)));
}

#[test]
fn a_scene_drawn_with_everything_forced_is_the_same_picture() {
    let setup = lesson_scene("open-scene");
    let picture = |setup: &Setup| render(setup, Method::RayTracing, NonZeroUsize::MIN, &|_, _| {});
    let everything = setup.with_forced(Parts::ALL);
    assert_eq!(everything.forced(), Parts::ALL);
    assert!(picture(&setup) == picture(&everything));
    let leaves_out = everything.with_forced(Parts::NONE);
    assert_eq!(leaves_out.needs(), setup.needs());
}

#[test]
fn a_build_without_the_app_has_no_window_system() {
    let tree = |features: &[&str]| {
        let tree = Command::new(env!("CARGO"))
            .args([
                "tree",
                "--offline",
                "--locked",
                "--edges",
                "normal",
                "--prefix",
                "none",
            ])
            .args(features)
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .output()
            .expect("cargo");
        assert!(
            tree.status.success(),
            "{}",
            String::from_utf8_lossy(&tree.stderr)
        );
        let text = String::from_utf8(tree.stdout).unwrap();
        let names = text.lines().filter_map(|line| line.split(' ').next());
        names.map(str::to_owned).collect::<Vec<_>>()
    };
    let windows = |name: &String| {
        let families = [
            "winit",
            "egui",
            "eframe",
            "glutin",
            "glow",
            "wgpu",
            "wayland",
            "x11",
            "smithay",
            "accesskit",
            "arboard",
        ];
        families.iter().any(|family| name.starts_with(family))
    };
    assert!(tree(&[]).iter().any(windows), "the app has one");
    let without = tree(&["--no-default-features"]);
    assert!(
        without.contains(&"clap".to_owned()),
        "the command line is there"
    );
    let found: Vec<_> = without.into_iter().filter(windows).collect();
    assert!(found.is_empty(), "{found:?}");
}
