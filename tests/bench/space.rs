//! How long a frame of the scene in space takes at 1280×800 while it is turned, for every lesson: its display list and its pixels,
//! at steps from all over the run; milliseconds. The goal is 16 in the worst case.

use glam::Vec2;
use lightwalk::lesson::builtins;
use lightwalk::panels::strings::Language;
use lightwalk::panels::{Panel, PanelInput, SpaceView, draw};
use lightwalk::picture::{Theme, rasterize};
use lightwalk::render::{Finished, render};
use lightwalk::study::timing::Timing;
use std::num::NonZeroUsize;
use std::time::Instant;

const FRAMES: usize = 40;
const SIZE: Vec2 = Vec2::new(1280.0, 800.0);

fn main() {
    println!("a frame at 1280×800 in ms: median (quartiles), worst; the display list alone, worst");
    for builtin in builtins() {
        let lesson = builtin.read().and_then(|lesson| lesson.open());
        let mut open = lesson.expect("a right lesson");
        let picture = render(
            &open.setup,
            open.lesson.method,
            NonZeroUsize::MIN,
            &|_, _| {},
        );
        let finished = Finished::new(picture, &open.setup.prepared.scene.lights);
        let steps = open.run.walk().len();
        let (mut whole, mut lists) = (Vec::new(), Vec::new());
        let mut space = SpaceView::default();
        for frame in 0..=FRAMES {
            open.run
                .walk_mut()
                .seek(frame * steps.saturating_sub(1) / FRAMES);
            space.orbit = space.orbit.turned(Vec2::new(0.15, 0.02));
            let input = PanelInput {
                space,
                ..PanelInput::of(&open.run, &finished, open.lesson.focus, Language::English)
            };
            let start = Instant::now();
            let picture = draw(Panel::Space, &input, SIZE);
            let list = 1e3 * start.elapsed().as_secs_f64();
            rasterize(&picture, Theme::Light, 1.0).expect("a picture");
            // The first makes what is kept.
            if frame > 0 {
                whole.push(1e3 * start.elapsed().as_secs_f64());
                lists.push(list);
            }
        }
        let worst = |times: &[f64]| times.iter().copied().fold(0.0, f64::max);
        let (worst_whole, worst_list) = (worst(&whole), worst(&lists));
        let time = Timing::of(whole);
        println!(
            "  {:22} {:5.1} ({:.1} to {:.1}), worst {worst_whole:.1}; {worst_list:.1}",
            builtin.id, time.median, time.lower, time.upper
        );
    }
}
