//! A lesson with all that its panels need, for a walk through its narrated steps.

use lightwalk::algorithms::enclosure;
use lightwalk::lesson::{OpenLesson, builtin};
use lightwalk::panels::strings::Language;
use lightwalk::panels::{Panel, PanelInput, draw};
use lightwalk::picture::Picture;
use lightwalk::render::compare::compare_on;
use lightwalk::render::{Finished, render, smooth_patches};
use std::convert::Infallible;
use std::num::NonZeroUsize;

pub struct Walk {
    pub open: OpenLesson,
    pub narrated: Vec<usize>,
    finished: Finished,
}

impl Walk {
    pub fn of(lesson: &str) -> Walk {
        let open = builtin(lesson).unwrap().read().unwrap().open().unwrap();
        let picture = render(
            &open.setup,
            open.lesson.method,
            NonZeroUsize::MIN,
            &|_, _| {},
        );
        // Run times are measured by a clock that ticks each time it is read: the same on every machine.
        let mut ticks = 0.0;
        let mut clock = || {
            ticks += 1e-5;
            ticks
        };
        let mut finished = Finished::new(picture, &open.setup.prepared.scene.lights);
        if open.lesson.panels.contains(&Panel::Race) {
            let enclosure = open.setup.enclosure().unwrap();
            let matrix = enclosure.matrix().unwrap();
            let Ok(race) = enclosure.race(matrix, &mut clock, || Ok::<(), Infallible>(()));
            finished.race = Some(race);
        }
        let methods = open.lesson.compare.iter();
        finished.compared = methods
            .map(|&method| compare_on(&open.setup, method, &mut clock))
            .collect();
        let narrated = open.narrated.iter().map(|narrated| narrated.step).collect();
        Walk {
            open,
            narrated,
            finished,
        }
    }

    /// The lesson's own panels, and those that stand beside every lesson.
    pub fn panels(&self) -> Vec<Panel> {
        let mut panels = self.open.lesson.panels.clone();
        panels.extend([Panel::Code, Panel::Formula, Panel::TimeLine]);
        panels
    }

    /// A panel at a narrated step, in a usual size divided by `shrink`.
    pub fn panel(
        &mut self,
        index: usize,
        panel: Panel,
        language: Language,
        shrink: f32,
    ) -> Picture {
        self.open.run.walk_mut().seek(self.narrated[index]);
        let radiosity: enclosure::Settings = self.open.setup.settings.get();
        let input = PanelInput {
            narrated: &self.narrated,
            smooth: radiosity.smooth.then_some(smooth_patches),
            ..PanelInput::of(
                &self.open.run,
                &self.finished,
                self.open.lesson.focus,
                language,
            )
        };
        let size = if panel == Panel::TimeLine {
            (800.0 / shrink, 130.0 / shrink)
        } else {
            (380.0 / shrink, 280.0 / shrink)
        };
        draw(panel, &input, size.into())
    }
}
