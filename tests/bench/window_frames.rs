//! How long a step takes in the window: to seek, to draw the panels that changed, to lay the window out and to divide it into triangles,
//! with no screen and no driver. Every lesson is walked from end to end, over all of its explanations and steps between them. A word
//! after `--` selects the lessons whose name contains it.

use egui::{Context, Pos2, RawInput, Rect, Vec2};
use lightwalk::app::{Command, Session, Window, fonts, window};
use lightwalk::lesson::builtins;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Steps of a lesson that are walked over besides its explanations.
const STEPS: usize = 150;

/// Pixels, and how many of them are a point.
const SCREENS: [([u32; 2], f32); 2] = [([1280, 800], 1.0), ([3840, 2160], 2.0)];

fn main() {
    let selected = std::env::args().skip(1).find(|word| !word.starts_with('-'));
    for (size, scale) in SCREENS {
        println!("{}×{}, scale {scale}; milliseconds", size[0], size[1]);
        let mut all = Vec::new();
        for builtin in builtins() {
            if selected
                .as_ref()
                .is_some_and(|word| !builtin.id.contains(word))
            {
                continue;
            }
            let lesson = builtin.read().expect("a right lesson");
            let mut session = Session::new(lesson).expect("a lesson that resolves");
            session
                .update(Command::Questions)
                .expect("they can be turned off");
            let times = walk(session, size, scale);
            report(builtin.id, &times);
            all.extend(times);
        }
        report("all", &all);
    }
}

/// The steps, and how long each took.
fn walk(mut session: Session, size: [u32; 2], scale: f32) -> Vec<(usize, f64)> {
    let context = Context::default();
    context.set_fonts(fonts());
    context.set_pixels_per_point(scale);
    let mut window = Window::default();
    let points = Vec2::new(size[0] as f32, size[1] as f32) / scale;
    let mut frame = |session: &mut Session| {
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, points)),
            max_texture_side: Some(1 << 14),
            ..RawInput::default()
        };
        let mut shown = context.run_ui(input, |ui| window::ui(session, &mut window, ui));
        std::hint::black_box(context.tessellate(std::mem::take(&mut shown.shapes), scale));
    };
    // The whole picture comes first, and the window finds its sizes.
    for _ in 0..8 {
        while session.awaits_picture() {
            session.take_picture();
            sleep(Duration::from_millis(1));
        }
        frame(&mut session);
    }

    let last = session.walk().len().saturating_sub(1);
    let every = (last / STEPS).max(1);
    let mut steps: Vec<usize> = (0..=last).step_by(every).collect();
    steps.extend(session.panel_input().narrated);
    steps.sort_unstable();
    steps.dedup();
    steps
        .into_iter()
        .map(|step| {
            let start = Instant::now();
            session
                .update(Command::Seek(step))
                .expect("a step of the run");
            frame(&mut session);
            (step, 1e3 * start.elapsed().as_secs_f64())
        })
        .collect()
}

fn report(name: &str, times: &[(usize, f64)]) {
    let mut sorted = times.to_vec();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let at = |share: f64| sorted[((sorted.len() - 1) as f64 * share).round() as usize];
    let (slowest, most) = at(1.0);
    println!(
        "  {name:28} median {:6.2}  p99 {:6.2}  most {most:6.2} (step {slowest} of {} tried)",
        at(0.5).1,
        at(0.99).1,
        sorted.len(),
    );
}
