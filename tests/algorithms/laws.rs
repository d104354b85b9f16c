//! Laws that hold for every scan-line method, on a scene with everything in it.

use crate::common::{TEAPOT, setup};
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::visible::BruteForce;
use lightwalk::methods::{Draw, RayMethod, Setup, ShadingMethod, Visitor, Wireframe};
use lightwalk::record::{Recording, RecordingLimit};
use lightwalk::render::{Cancelled, Method, preview, render};
use lightwalk::replay::{Run, Walk};
use std::num::NonZeroUsize;
use std::sync::Arc;

const ONE: NonZeroUsize = NonZeroUsize::MIN;

fn unrecorded(setup: &Setup, method: Method) -> Frame {
    render(setup, method, ONE, &|_, _| {})
}

/// The methods that draw pixels.
fn drawing() -> impl Iterator<Item = Method> {
    Method::ALL
        .into_iter()
        .filter(|method| method.draws_pixels())
}

/// The frame that a recorded run draws, one focus after the other; how many steps it kept, and whether it met its limit.
fn recorded(
    setup: &Setup,
    method: Method,
    foci: &[Focus],
    limit: RecordingLimit,
) -> (Frame, usize, bool) {
    method.visit(Recorded { setup, foci, limit })
}

struct Recorded<'a> {
    setup: &'a Setup,
    foci: &'a [Focus],
    limit: RecordingLimit,
}

impl Recorded<'_> {
    fn draw<M: Draw>(self) -> (Frame, usize, bool) {
        let mut recording = Recording::new(self.limit);
        let mut frame = self.setup.prepared.empty_frame();
        for &focus in self.foci {
            M::draw(self.setup, focus, &mut frame, BruteForce, &mut recording);
        }
        (frame, recording.len(), recording.truncated())
    }
}

impl Visitor for Recorded<'_> {
    type Output = (Frame, usize, bool);

    fn wireframe(self) -> Self::Output {
        self.draw::<Wireframe>()
    }

    fn shading<M: ShadingMethod>(self) -> Self::Output {
        self.draw::<M>()
    }

    fn rays<M: RayMethod>(self) -> Self::Output {
        self.draw::<M>()
    }

    fn radiosity(self) -> Self::Output {
        unreachable!("radiosity draws no pixels")
    }

    fn hierarchical(self) -> Self::Output {
        unreachable!("radiosity draws no pixels")
    }
}

/// A textured floor, and a textured ball, can and patch on it.
const TILES: &str = r#"{ "schema": 1, "background": [0.1, 0.2, 0.3],
  "camera": { "eye": [0.3, 2, 7], "target": [0, 0.4, 0], "up": [0, 1, 0], "fov_x_degrees": 45 },
  "materials": { "tiles": { "ambient": [0.05, 0.04, 0.03], "diffuse": [0.5, 0.4, 0.3], "specular": 0.5, "shininess": 25,
    "texture": { "checker": { "colors": [[1, 1, 1], [0.2, 0.3, 0.4]], "scale": 0.11 } } } },
  "objects": [
    { "name": "floor", "material": "tiles", "polygon": { "vertices": [[-4, -1, 6], [4, -1, 6], [4, -1, -9], [-4, -1, -9]] } },
    { "name": "ball", "material": "tiles", "sphere": { "center": [-1.5, 0, 0], "radius": 1 } },
    { "name": "can", "material": "tiles", "cylinder": { "base": [0.5, -1, 0], "axis": [0, 1, 0], "radius": 0.6, "height": 1.5, "capped": true } },
    { "name": "patch", "material": "tiles", "bezier": { "divisions": 5, "patches": [[
      [1.4, -1, 1], [1.8, -1, 0], [2.2, -1, 0], [2.6, -1, 1], [1.4, 0, 0], [1.8, 0, 1], [2.2, 0, 1], [2.6, 0, 0],
      [1.4, 1, 0], [1.8, 1, 1], [2.2, 1, 1], [2.6, 1, 0], [1.4, 2, 1], [1.8, 2, 0], [2.2, 2, 0], [2.6, 2, 1]]] } } ],
  "lights": [ { "point": { "position": [-3, 6, 5] } } ] }"#;

#[test]
fn a_recorded_frame_is_the_unrecorded_one_bit_for_bit() {
    for setup in [setup(TEAPOT, 160, 120), setup(TILES, 160, 120)] {
        for method in drawing() {
            let (frame, steps, truncated) =
                recorded(&setup, method, &[Focus::Frame], RecordingLimit::default());
            assert!(frame == unrecorded(&setup, method), "{}", method.name());
            assert!(steps > 2_000 && !truncated);
        }
    }
}

#[test]
fn a_truncated_recording_still_draws_the_right_picture() {
    let setup = setup(TEAPOT, 160, 120);
    for method in drawing() {
        let (frame, steps, truncated) =
            recorded(&setup, method, &[Focus::Frame], RecordingLimit(100_000));
        assert!(frame == unrecorded(&setup, method), "{}", method.name());
        assert!(truncated && steps <= 100_000 / 32);
    }
}

#[test]
fn any_number_of_threads_draws_the_same_picture() {
    let setup = setup(TEAPOT, 97, 61);
    for method in drawing() {
        let one = unrecorded(&setup, method);
        for threads in [2, 3, 16] {
            let many = render(
                &setup,
                method,
                NonZeroUsize::new(threads).unwrap(),
                &|_, _| {},
            );
            assert!(many == one, "{} on {threads} threads", method.name());
            let threads = NonZeroUsize::new(threads).unwrap();
            let grown = preview(&setup, method, threads, |_, _| Ok(()), &mut |_| {});
            assert!(grown == Ok(one.clone()), "preview: {}", method.name());
            let called_off = |_, _| Err(Cancelled);
            let nothing = preview(&setup, method, threads, called_off, &mut |_| {});
            assert_eq!(nothing, Err(Cancelled));
        }
    }
}

#[test]
fn a_focus_draws_its_part_of_the_frame_and_nothing_else() {
    let setup = setup(TEAPOT, 120, 90);
    for method in drawing() {
        let whole = unrecorded(&setup, method);
        for y in [0, 20, 45, 46, 89] {
            let (frame, ..) = recorded(
                &setup,
                method,
                &[Focus::ScanLine(y)],
                RecordingLimit::default(),
            );
            for row in 0..90 {
                for x in 0..120 {
                    let expected = if row == y {
                        whole.pixel(x, row)
                    } else {
                        setup.prepared.scene.background
                    };
                    assert_eq!(
                        frame.pixel(x, row),
                        expected,
                        "{}: ({x}, {row}) in focus {y}",
                        method.name()
                    );
                }
            }
        }
        for (x, y) in [(0, 0), (60, 45), (61, 45), (30, 60), (119, 89), (80, 10)] {
            let (frame, ..) = recorded(
                &setup,
                method,
                &[Focus::Pixel { x, y }],
                RecordingLimit::default(),
            );
            assert_eq!(
                frame.pixel(x, y),
                whole.pixel(x, y),
                "{}: ({x}, {y})",
                method.name()
            );
            let others = frame
                .color
                .iter()
                .filter(|&&color| color != setup.prepared.scene.background)
                .count();
            assert!(
                others <= 1,
                "{}: a pixel's run drew {others} pixels",
                method.name()
            );
        }
    }
}

#[test]
fn the_polygons_drawn_one_by_one_make_the_frame() {
    let setup = setup(TEAPOT, 64, 48);
    // The wireframe draws edges, each once for the polygons that share it.
    let fills = |&method: &Method| method.converts_polygons() && method != Method::Wireframe;
    for method in drawing().filter(fills) {
        let polygons = 0..setup.prepared.tessellation.polygon_count();
        let foci: Vec<Focus> = polygons.map(Focus::Polygon).collect();
        let (frame, ..) = recorded(&setup, method, &foci, RecordingLimit::default());
        assert!(frame == unrecorded(&setup, method), "{}", method.name());
    }
}

fn canvas_of(run: &Run) -> Vec<lightwalk::color::Rgb> {
    let canvas = run.canvas().expect("its run draws pixels");
    canvas.iter().map(|dot| dot.color).collect()
}

#[test]
fn the_replayed_picture_is_the_rendered_one() {
    let setup = Arc::new(setup(TEAPOT, 96, 72));
    for method in drawing() {
        let mut run = Run::record(
            setup.clone(),
            method,
            Focus::Frame,
            RecordingLimit::default(),
        );
        let last = run.walk().len() - 1;
        run.walk_mut().seek(last);
        assert!(
            canvas_of(&run) == unrecorded(&setup, method).color,
            "{}",
            method.name()
        );
        // Back to the beginning: nothing is drawn.
        run.walk_mut().seek(0);
        assert!(
            canvas_of(&run)
                .iter()
                .all(|&color| color == setup.prepared.scene.background)
        );
    }
}

#[test]
fn how_far_away_the_target_is_changes_nothing() {
    let near = unrecorded(&setup(TEAPOT, 64, 48), Method::Gouraud);
    // The same direction of view: eye (14, 20, 44), target a hundred million times as far behind (0, −0.6, 0)
    let far = TEAPOT.replace(
        "\"target\": [0, -0.6, 0]",
        "\"target\": [-1399999986, -2059999980, -4399999956]",
    );
    assert_ne!(far, TEAPOT);
    let far = unrecorded(&setup(&far, 64, 48), Method::Gouraud);
    let differing = near
        .color
        .iter()
        .zip(&far.color)
        .filter(|(a, b)| (a.r - b.r).abs() > 1e-6)
        .count();
    assert!(
        differing <= 3,
        "{differing} pixels differ; a few may, where an edge meets a pixel's centre"
    );
}

#[test]
fn every_scope_closes_and_every_step_has_a_line() {
    let setup = Arc::new(setup(TEAPOT, 32, 24));
    for method in drawing() {
        let run = Run::record(
            setup.clone(),
            method,
            Focus::Frame,
            RecordingLimit::default(),
        );
        let walk: &dyn Walk = run.walk();
        assert_eq!(
            walk.outline().last(0),
            walk.len() - 1,
            "the frame is the outermost scope"
        );
        for step in 0..walk.len() {
            let line = walk.line(step);
            assert!(
                line.number < line.listing.lines.len(),
                "{} at step {step}",
                walk.kind(step)
            );
        }
    }
}

#[test]
fn gourauds_values_are_called_as_on_the_slide() {
    let setup = Arc::new(setup(TEAPOT, 64, 48));
    let run = Run::record(
        setup,
        Method::Gouraud,
        Focus::Pixel { x: 32, y: 24 },
        RecordingLimit::default(),
    );
    let walk = run.walk();
    let at = |kind: &str| {
        (0..walk.len())
            .find(|&step| walk.kind(step) == kind)
            .map(|step| walk.fields(step))
            .unwrap()
    };
    let edge = at("EdgeInterpolated");
    for name in [
        "y_1",
        "y_2",
        "y_4",
        "I_1",
        "I_2",
        "I_4",
        "x_4",
        "I_4_incremental",
        "difference",
    ] {
        assert!(edge.get(name).is_some(), "{name}");
    }
    let pixel = at("SpanInterpolated");
    for name in [
        "x_4",
        "x_5",
        "x_P",
        "I_4",
        "I_5",
        "I_P",
        "I_P_incremental",
        "difference",
        "y_4",
    ] {
        assert!(pixel.get(name).is_some(), "{name}");
    }
}
