//! How soon a lesson's scene is seen at 640×480: the first coarse picture, and the whole one, on all cores; medians with quartiles,
//! coarse and whole from the same runs.

use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::lesson::builtins;
use lightwalk::methods::Setup;
use lightwalk::render::preview;
use lightwalk::scene::View;
use lightwalk::study::timing::Timing;
use std::num::NonZeroUsize;
use std::thread::available_parallelism;
use std::time::{Duration, Instant};

const ROUNDS: usize = 15;

fn main() {
    let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
    println!("640×480, {threads} threads; milliseconds, median (quartiles)");
    for builtin in builtins() {
        let lesson = builtin.read().expect("a right lesson");
        let settings = lesson.settings;
        let camera = lesson.scene.camera.expect("a camera");
        let view = View::new(&camera, 640, 480);
        let setup = Setup::new(PreparedScene::new(lesson.scene, view), settings);
        let (mut coarse, mut whole) = (Vec::new(), Vec::new());
        for round in 0..=ROUNDS {
            let start = Instant::now();
            let mut first = None;
            let mut show = |_: &_| first = first.or(Some(start.elapsed()));
            preview(&setup, lesson.method, threads, |_, _| Ok(()), &mut show)
                .expect("it is never cancelled");
            let all = start.elapsed();
            // The first run makes the hierarchies.
            if round > 0 {
                coarse.push(first.unwrap_or(all));
                whole.push(all);
            }
        }
        let [coarse, whole] = [coarse, whole].map(|times| {
            let milliseconds = times.iter().map(|time: &Duration| 1e3 * time.as_secs_f64());
            let time = Timing::of(milliseconds.collect());
            format!(
                "{:6.1} ({:.1} to {:.1})",
                time.median, time.lower, time.upper
            )
        });
        println!(
            "  {:22} {:12} first {coarse}  whole {whole}",
            builtin.id,
            lesson.method.name()
        );
    }
}
