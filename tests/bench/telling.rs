//! What it costs to be watchable, on whole Gouraud frames of the teapot:
//! the body with `Unrecorded` against the same body without recorder calls (goal 1.00), a recorded frame against an
//! unrecorded one (goal 1.3), and a new focus (goal 50 ms).
//!
//! `cargo bench --bench telling`; with `-- --count recorded` or `-- --count untold` it draws 20 frames and ends, for a counter of instructions.

#[path = "../common/mod.rs"]
mod common;
mod untold;

use common::{TEAPOT, prepared};
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::gouraud::gouraud;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::record::{Recording, RecordingLimit, Unrecorded};
use lightwalk::render::Method;
use lightwalk::replay::Run;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;

fn frame(prepared: &PreparedScene) -> Frame {
    Frame::new(WIDTH, 0..HEIGHT, prepared.scene.background)
}

fn recorded(prepared: &PreparedScene) -> Frame {
    let mut frame = frame(prepared);
    gouraud(prepared, Focus::Frame, &mut frame, &mut Unrecorded);
    frame
}

fn untold(prepared: &PreparedScene) -> Frame {
    let mut frame = frame(prepared);
    untold::gouraud(prepared, Focus::Frame, &mut frame);
    frame
}

/// Milliseconds of each, taken in turn so that a drifting machine drifts for both: medians and quartiles.
fn compare(rounds: usize, mut a: impl FnMut(), mut b: impl FnMut()) -> [[f64; 3]; 3] {
    let mut times = [Vec::new(), Vec::new(), Vec::new()];
    for round in 0..=rounds {
        let start = Instant::now();
        a();
        let middle = Instant::now();
        b();
        let (a, b) = (
            (middle - start).as_secs_f64(),
            middle.elapsed().as_secs_f64(),
        );
        // The first round warms up.
        if round > 0 {
            times[0].push(1e3 * a);
            times[1].push(1e3 * b);
            times[2].push(a / b);
        }
    }
    times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        [0.25, 0.5, 0.75].map(|share| times[(share * (times.len() - 1) as f64) as usize])
    })
}

fn report(what: &str, [a, b, ratio]: [[f64; 3]; 3]) {
    println!(
        "{what}: {:.2} ms against {:.2} ms, ratio {:.3} (quartiles {:.3} to {:.3})",
        a[1], b[1], ratio[1], ratio[0], ratio[2]
    );
}

fn main() {
    let prepared = Arc::new(prepared(TEAPOT, WIDTH, HEIGHT));
    let arguments: Vec<String> = std::env::args().collect();
    if let Some(at) = arguments.iter().position(|argument| argument == "--count") {
        let draw = if arguments.get(at + 1).is_some_and(|which| which == "untold") {
            untold
        } else {
            recorded
        };
        (0..20).for_each(|_| drop(black_box(draw(&prepared))));
        return;
    }
    assert!(
        recorded(&prepared) == untold(&prepared),
        "both bodies draw the same picture"
    );

    let unrecorded = compare(
        200,
        || drop(black_box(recorded(&prepared))),
        || drop(black_box(untold(&prepared))),
    );
    report(
        "unrecorded body against the body without recorder calls",
        unrecorded,
    );

    let mut recording = Recording::new(RecordingLimit::default());
    let mut record = || {
        recording.restart(RecordingLimit::default());
        let mut frame = frame(&prepared);
        gouraud(&prepared, Focus::Frame, &mut frame, &mut recording);
        black_box(frame);
        recording.len()
    };
    let events = record();
    report(
        "recorded frame against unrecorded frame",
        compare(
            60,
            || {
                black_box(record());
            },
            || drop(black_box(recorded(&prepared))),
        ),
    );
    println!(
        "  {events} events of {} bytes",
        size_of::<lightwalk::algorithms::gouraud::Event>()
    );

    for focus in [
        Focus::Pixel { x: 300, y: 240 },
        Focus::ScanLine(240),
        Focus::Polygon(155),
    ] {
        let mut steps = 0;
        let times = compare(
            40,
            || {
                let run = Run::record(
                    prepared.clone(),
                    Method::Gouraud,
                    focus,
                    RecordingLimit::default(),
                );
                steps = run.walk().len();
            },
            || drop(black_box(recorded(&prepared))),
        );
        report(
            &format!("{focus:?} recorded, {steps} steps, against an unrecorded frame"),
            times,
        );
    }
}
