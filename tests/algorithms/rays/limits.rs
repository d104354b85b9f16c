//! Deep trees, many rays, and light without bounds.

use super::{blank, picture, settings};
use crate::common::prepared;
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::ray_tracing::{Event, RayTracer, ray_tracing};
use lightwalk::algorithms::visible::BruteForce;
use lightwalk::methods::Setup;
use lightwalk::record::{self, Recorder, Recording, RecordingLimit};

/// Glass balls that reflect and transmit: two rays at every hit.
const TREE: &str = r#"{ "schema": 1, "background": [0.2, 0.3, 0.5],
  "camera": { "eye": [0, 0, -4], "target": [0.1, 0.07, 0], "up": [0, 1, 0], "fov_x_degrees": 30 },
  "materials": { "glass": { "ambient": [0.01, 0.01, 0.01], "reflection": 0.4, "transmission": 0.6, "ior": 1.5 } },
  "objects": [
    { "name": "a", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 1 } },
    { "name": "room", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 20 } } ] }"#;

#[test]
fn depth_64_stays_far_from_the_end_of_the_stack() {
    // A closed room of mirrors, and a stack of an eighth of what the program's threads have
    let json = r#"{ "schema": 1, "camera": { "eye": [0, 0, 0], "target": [0.3, 0.2, 1], "up": [0, 1, 0], "fov_x_degrees": 60 },
      "materials": { "mirror": { "emission": [0.01, 0.01, 0.01], "reflection": 0.98 } },
      "objects": [ { "name": "room", "material": "mirror", "sphere": { "center": [0.1, 0, 0], "radius": 3 } } ] }"#;
    let run = || {
        let setup = Setup::new(prepared(json, 4, 4), settings(64, 1));
        let frame = picture(&setup);
        let mut recorded = blank(&setup);
        let mut recording = Recording::new(RecordingLimit::default());
        let tracer = RayTracer::new(
            &setup.prepared,
            setup.settings.get(),
            setup.needs(),
            BruteForce,
        );
        ray_tracing(&tracer, Focus::Frame, &mut recorded, &mut recording);
        assert!(frame == recorded && !recording.truncated());
        let series: f64 = (0..64).map(|i| 0.01 * 0.98_f64.powi(i)).sum();
        for color in frame.color {
            assert!((color.r - series).abs() < 1e-12);
        }
    };
    let thread = std::thread::Builder::new().stack_size(256 << 10).spawn(run);
    assert!(thread.expect("a thread").join().is_ok());
}

#[test]
fn a_tree_of_a_million_rays_is_recorded_within_its_limit() {
    let setup = Setup::new(prepared(TREE, 9, 9), settings(28, 1));
    let focus = Focus::Pixel { x: 4, y: 4 };
    let tracer = RayTracer::new(
        &setup.prepared,
        setup.settings.get(),
        setup.needs(),
        BruteForce,
    );
    let mut expected = blank(&setup);
    let mut rays = Rays(0);
    ray_tracing(&tracer, focus, &mut expected, &mut rays);
    assert!(rays.0 > 1_000_000, "{} rays", rays.0);

    let limit = RecordingLimit(64 << 20);
    let mut recording = Recording::new(limit);
    let mut frame = blank(&setup);
    ray_tracing(&tracer, focus, &mut frame, &mut recording);
    assert!(frame == expected);
    assert!(recording.truncated() && recording.len() * 64 <= 64 << 20);
}

/// Counts the rays of a tree.
struct Rays(usize);

impl Recorder<Event> for Rays {
    fn step(&mut self, _: impl FnOnce() -> Event) {}
    fn enter(&mut self, event: impl FnOnce() -> Event) {
        self.0 += usize::from(record::Event::kind(&event()) == "Ray");
    }
    fn leave(&mut self, _: impl FnOnce() -> Event) {}
}

#[test]
fn light_without_bounds_stays_a_number() {
    let setup = Setup::new(
        prepared(
            &TREE
                .replace("\"reflection\": 0.4", "\"reflection\": [1e300, 0, 1e-300]")
                .replace("[0.2, 0.3, 0.5]", "[1e300, 1e300, 1e300]"),
            8,
            8,
        ),
        settings(8, 1),
    );
    for color in picture(&setup).color {
        assert!(color.channels().iter().all(|c| c.is_finite()), "{color:?}");
    }
}
