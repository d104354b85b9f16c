//! A lesson that was run, with all that its panels show beside the steps.

use super::page::Page;
use crate::algorithms::enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::language::{Language, Message};
use crate::lesson::{Narrated, OpenLesson, Question};
use crate::panels::{
    Panel, PanelInput, draw, formula_height, kind_name, said, whole_formula_height,
};
use crate::picture::Picture;
use crate::render::compare::compare;
use crate::render::{Finished, race, render, smooth_patches};
use glam::Vec2;
use std::convert::Infallible;
use std::num::NonZeroUsize;

/// What pictures of a lesson's steps are drawn of.
pub struct ExportedLesson {
    pub open: OpenLesson,
    pub language: Language,
    /// Whether the lesson's questions wait at their steps, and hide what lies ahead.
    asks: bool,
    finished: Finished,
    /// The part of the picture that was recorded.
    focus: Focus,
    /// Ascending.
    narrated: Vec<usize>,
}

impl ExportedLesson {
    /// With what its panels show beside the steps. What is said belongs to the steps of `focus`, which was recorded.
    pub fn of(open: OpenLesson, focus: Focus, finished: Finished, language: Language) -> Self {
        ExportedLesson {
            narrated: open.narrated.iter().map(|said| said.step).collect(),
            open,
            language,
            asks: false,
            finished,
            focus,
        }
    }

    /// Renders what `panels` show beside the steps. `progress` hears how much of that is done.
    pub fn new(
        open: OpenLesson,
        panels: &[Panel],
        language: Language,
        threads: NonZeroUsize,
        progress: &(impl Fn(usize, usize) + Sync),
    ) -> Self {
        let races = panels.contains(&Panel::Race);
        let compares = panels.iter().any(|panel| panel.compares());
        let compared = &open.lesson.compare[..if compares {
            open.lesson.compare.len()
        } else {
            0
        }];
        // The picture is a part, and so is each that is compared, and the race.
        let parts = 1 + compared.len() + usize::from(races);
        let picture = render(&open.setup, open.lesson.method, threads, &|done, all| {
            progress(done, parts * all);
        });
        let mut finished = Finished::new(picture, &open.setup.prepared.scene.lights);
        for (done, &method) in compared.iter().enumerate() {
            finished.compared.push(compare(&open.setup, method));
            progress(2 + done, parts);
        }
        if races {
            let Ok(race) = race(&open.setup, || Ok::<(), Infallible>(()));
            finished.race = race;
        }
        let focus = open.lesson.focus;
        ExportedLesson::of(open, focus, finished, language)
    }

    /// As somebody sees it who has answered no question yet.
    pub fn asking(self) -> Self {
        ExportedLesson { asks: true, ..self }
    }

    /// The whole picture.
    pub fn picture(&self) -> &Frame {
        &self.finished.picture
    }

    /// The steps at which the lesson says something, ascending.
    pub fn narrated(&self) -> &[usize] {
        &self.narrated
    }

    /// A panel at a step.
    pub fn draw(&mut self, panel: Panel, step: usize, size: Vec2) -> Picture {
        self.open.run.walk_mut().seek(step);
        draw(panel, &self.input(step), size)
    }

    /// The formulas of a step, as high as they need to be; none where nothing is computed.
    pub fn formula(&mut self, step: usize, width: f32) -> Option<Picture> {
        self.open.run.walk_mut().seek(step);
        let input = self.input(step);
        let least = formula_height(&input, width);
        let height = whole_formula_height(&input, width).max(least);
        (height > 0.0).then(|| draw(Panel::Formula, &input, Vec2::new(width, height)))
    }

    /// What is narrated at a step: by the lesson, or else by the step itself.
    pub fn page(&self, step: usize) -> Page {
        let walk = self.open.run.walk();
        let language = self.language;
        let narrated = self.narrated_at(step);
        let title = narrated.and_then(|narrated| narrated.title.as_ref());
        let line = walk.line(step);
        let listing = line.listing.text(line.number, language);
        Page {
            step,
            title: match title {
                Some(title) => title.in_language(language).to_owned(),
                None => kind_name(walk.kind(step), language),
            },
            said: match narrated {
                Some(narrated) => narrated.text(language).to_owned(),
                None => said(&self.open.run, step, language),
            },
            slide: narrated.and_then(|narrated| narrated.slide(language).map(str::to_owned)),
            question: narrated.and_then(|narrated| narrated.question.clone()),
            code: listing.trim().to_owned(),
            panel: self.panel(narrated),
        }
    }

    /// The panel that an explanation is about, or in which its question is answered.
    fn panel(&self, narrated: Option<&Narrated>) -> Panel {
        let panels = &self.open.lesson.panels;
        let named = narrated.and_then(|narrated| narrated.key).into_iter();
        let question = narrated.and_then(|narrated| narrated.question.as_ref());
        let fits = question.map_or(&[][..], |question| question.answer.panels());
        let mut wished = named.chain(panels.iter().copied());
        wished
            .clone()
            .find(|panel| fits.contains(panel))
            .or_else(|| wished.next())
            .unwrap_or(Panel::Image)
    }

    fn narrated_at(&self, step: usize) -> Option<&Narrated> {
        let index = self.narrated.binary_search(&step).ok()?;
        Some(&self.open.narrated[index])
    }

    fn question(&self, step: usize) -> Option<&Question> {
        self.narrated_at(step)?
            .question
            .as_ref()
            .filter(|_| self.asks)
    }

    fn input(&self, step: usize) -> PanelInput<'_> {
        let radiosity: enclosure::Settings = self.open.setup.settings.get();
        let ahead = self.narrated.iter().filter(|&&ahead| ahead >= step);
        PanelInput {
            narrated: &self.narrated,
            smooth: radiosity.smooth.then_some(smooth_patches),
            pending: self.question(step).map(|question| &question.hide[..]),
            waiting: ahead.copied().find(|&step| self.question(step).is_some()),
            ..PanelInput::of(&self.open.run, &self.finished, self.focus, self.language)
        }
    }

    /// Where a step stands in the run: `step 12 of 340`.
    pub fn place(&self, step: usize) -> String {
        let last = self.open.run.walk().len().saturating_sub(1);
        let (step, last) = (step.to_string(), last.to_string());
        Message("app-step-of").format(self.language, &[("step", &step), ("last", &last)])
    }
}
