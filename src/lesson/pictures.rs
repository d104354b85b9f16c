//! Pictures of a lesson's panels for tests, and that there is one at any size.

use super::OpenLesson;
use crate::language::Language;
use crate::panels::{Panel, PanelInput, draw};
use crate::picture::Picture;
use crate::render::compare::compare_on;
use crate::render::{Finished, render};
use glam::Vec2;
use std::convert::Infallible;
use std::num::NonZeroUsize;

/// What the panels of a lesson show beside its steps, with nothing left to be made. Every reading of the clock takes a microsecond.
pub(super) fn finished(open: &OpenLesson) -> Finished {
    let draw_all = |method| render(&open.setup, method, NonZeroUsize::MIN, &|_, _| {});
    let lights = &open.setup.prepared.scene.lights;
    let mut finished = Finished::new(draw_all(open.lesson.method), lights);
    let mut ticks = 0.0;
    let mut clock = || {
        ticks += 1e-6;
        ticks
    };
    let methods = open.lesson.compare.iter();
    finished.compared = methods
        .map(|&method| compare_on(&open.setup, method, &mut clock))
        .collect();
    if open.lesson.panels.contains(&Panel::Race) {
        let enclosure = open.setup.enclosure().unwrap();
        let matrix = enclosure.matrix().unwrap();
        let Ok(race) = enclosure.race(matrix, &mut clock, || Ok::<(), Infallible>(()));
        finished.race = Some(race);
    }
    finished
}

/// The panels of a lesson, and those that every lesson has.
pub(super) fn panels(open: &OpenLesson) -> Vec<Panel> {
    let mut panels = open.lesson.panels.clone();
    for panel in [
        Panel::Code,
        Panel::Formula,
        Panel::TimeLine,
        Panel::Inspector,
    ] {
        if !panels.contains(&panel) {
            panels.push(panel);
        }
    }
    panels
}

/// What a panel shows at the run's step, with no question open.
pub(super) fn input<'a>(
    open: &'a OpenLesson,
    finished: &'a Finished,
    narrated: &'a [usize],
    language: Language,
) -> PanelInput<'a> {
    PanelInput {
        narrated,
        ..PanelInput::of(&open.run, finished, open.lesson.focus, language)
    }
}

/// Shows `look` the panels of a lesson at four of its explanations, in sizes from `size`.
pub(super) fn each_picture(
    open: &mut OpenLesson,
    language: Language,
    size: &mut dyn FnMut() -> Vec2,
    look: &mut dyn FnMut(Panel, Vec2, &Picture),
) {
    let (finished, panels) = (finished(open), panels(open));
    let steps: Vec<usize> = open.narrated.iter().map(|narrated| narrated.step).collect();
    for &step in steps.iter().step_by(steps.len().div_ceil(4).max(1)) {
        open.run.walk_mut().seek(step);
        for &panel in &panels {
            let input = input(open, &finished, &steps, language);
            let size = size();
            look(panel, size, &draw(panel, &input, size));
        }
    }
}

mod any_size {
    use super::super::builtin;
    use super::*;
    use crate::numeric::Random;
    use crate::picture::{Theme, rasterize};
    use std::collections::BTreeSet;

    /// These have every panel between them.
    const LESSONS: [&str; 7] = [
        "illumination-model",
        "gouraud-teapot",
        "side-by-side",
        "ray-tree",
        "form-factors",
        "gathering",
        "hierarchical-radiosity",
    ];

    #[test]
    fn every_panel_has_a_picture_of_any_size() {
        let mut random = Random(12);
        // From one pixel to some hundred, small ones most often
        let mut length = move || (250.0 * random.number().powi(2)).ceil().max(1.0) as f32;
        let mut drawn = BTreeSet::new();
        for (number, lesson) in LESSONS.into_iter().enumerate() {
            let mut open = builtin(lesson).unwrap().read().unwrap().open().unwrap();
            let language = Language::ALL[number % Language::ALL.len()];
            for _ in 0..6 {
                let mut size = || Vec2::new(length(), length());
                each_picture(
                    &mut open,
                    language,
                    &mut size,
                    &mut |panel, size, picture| {
                        let pixmap = rasterize(picture, Theme::Light, 1.0).unwrap();
                        let found = [pixmap.width(), pixmap.height()].map(|side| side as f32);
                        assert_eq!(found, size.to_array(), "{}", panel.name());
                        drawn.insert(panel.name());
                    },
                );
            }
        }
        let all: BTreeSet<&str> = Panel::ALL.into_iter().map(Panel::name).collect();
        assert_eq!(drawn, all);
    }
}
