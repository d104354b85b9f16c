//! The cost of a recorder, on whole Gouraud frames of the teapot: the body with `Unrecorded` against the same body without recorder
//! calls (goal 1.00), a recorded frame against an unrecorded one (goal 1.3), and a new focus (goal 50 ms).
//!
//! `cargo bench --bench recorded_frames`; with `-- --count unrecorded` or `-- --count no_recorder` it draws 20 frames and ends, for a
//! counter of instructions.

#[path = "../common/mod.rs"]
mod common;
mod no_recorder;
mod race;

use common::{TEAPOT, setup};
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::gouraud::{Event, gouraud};
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::shading::ShadedScene;
use lightwalk::record::{Recording, RecordingLimit, Unrecorded};
use lightwalk::render::Method;
use lightwalk::replay::Run;
use lightwalk::study::timing::Timing;
use race::{race, ratio};
use std::hint::black_box;
use std::sync::Arc;

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;

fn frame(prepared: &PreparedScene) -> Frame {
    Frame::new(WIDTH, 0..HEIGHT, prepared.scene.background)
}

fn unrecorded(prepared: &PreparedScene) -> Frame {
    let mut frame = frame(prepared);
    gouraud(
        &ShadedScene::of(prepared),
        Focus::Frame,
        &mut frame,
        &mut Unrecorded,
    );
    frame
}

fn no_recorder(prepared: &PreparedScene) -> Frame {
    let mut frame = frame(prepared);
    no_recorder::gouraud(prepared, Focus::Frame, &mut frame);
    frame
}

/// The number of events of a recorded frame.
fn recorded(prepared: &PreparedScene) -> usize {
    let mut recording = Recording::new(RecordingLimit::default());
    let mut frame = frame(prepared);
    gouraud(
        &ShadedScene::of(prepared),
        Focus::Frame,
        &mut frame,
        &mut recording,
    );
    black_box(frame);
    recording.len()
}

fn compare(what: &str, rounds: usize, a: &mut dyn FnMut(), b: &mut dyn FnMut()) {
    let seconds = race(&mut [a, b], rounds);
    let ratio = ratio(&seconds[0], &seconds[1]);
    let [a, b] = [0, 1].map(|i| 1e3 * Timing::of(seconds[i].clone()).median);
    println!(
        "{what}: {a:.2} ms against {b:.2} ms, ratio {:.3} (quartiles {:.3} to {:.3})",
        ratio.median, ratio.lower, ratio.upper
    );
}

fn main() {
    let setup = Arc::new(setup(TEAPOT, WIDTH, HEIGHT));
    let prepared = setup.prepared.clone();
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(at) = arguments.iter().position(|argument| argument == "--count") {
        let draw = match arguments.get(at + 1).map(String::as_str) {
            Some("no_recorder") => no_recorder,
            _ => unrecorded,
        };
        (0..20).for_each(|_| drop(black_box(draw(&prepared))));
        return;
    }
    assert!(
        unrecorded(&prepared) == no_recorder(&prepared),
        "both bodies draw the same picture"
    );

    compare(
        "unrecorded body against the body without recorder calls",
        200,
        &mut || drop(black_box(unrecorded(&prepared))),
        &mut || drop(black_box(no_recorder(&prepared))),
    );
    let events = recorded(&prepared);
    compare(
        "recorded frame against unrecorded frame",
        60,
        &mut || {
            black_box(recorded(&prepared));
        },
        &mut || drop(black_box(unrecorded(&prepared))),
    );
    println!("  {events} events of {} bytes", size_of::<Event>());

    for focus in [
        Focus::Pixel { x: 300, y: 240 },
        Focus::ScanLine(240),
        Focus::Polygon(155),
    ] {
        let record = || {
            Run::record(
                setup.clone(),
                Method::Gouraud,
                focus,
                RecordingLimit::default(),
            )
        };
        let steps = record().walk().len();
        compare(
            &format!("{focus:?} recorded, {steps} steps, against an unrecorded frame"),
            40,
            &mut || drop(black_box(record())),
            &mut || drop(black_box(unrecorded(&prepared))),
        );
    }
}
