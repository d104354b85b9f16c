//! The form that every study has: ladders of settings, each beside a reference that is trusted.

use super::fit::Law;
use super::label::Label;
use crate::algorithms::frame::Frame;
use crate::language::{Language, Message, called_with};
use crate::methods::Setup;
use crate::render::Method;
use crate::scene::Scene;
use std::rc::Rc;
use std::sync::Arc;

/// A question about the algorithms that measuring answers.
pub struct Study {
    /// As on the command line, and in the names of files.
    pub name: &'static str,
    pub title: Message,
    /// What it asks, in a sentence.
    pub about: Message,
    /// Its ladders. Errors: why it says nothing about the scene that was given.
    pub sweeps: fn(&Request) -> Result<Vec<Sweep>, String>,
}

/// What is asked of a study.
#[derive(Clone, Copy, Debug, Default)]
pub struct Request<'a> {
    /// The user's own scene. Without one, a study brings what suits it.
    pub scene: Option<&'a Scene>,
    /// Whether few and small settings are enough.
    pub quick: bool,
}

impl Request<'_> {
    /// One of two sizes of the work.
    pub fn either<T>(&self, quick: T, thorough: T) -> T {
        if self.quick { quick } else { thorough }
    }
}

/// What the axes of a ladder's plot are, both logarithmic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Error over run time: work and precision.
    ErrorOverTime,
    /// Error over the size of the setting, where settings cost the same.
    ErrorOverSize,
    /// Run time over the size of the work.
    TimeOverSize,
}

/// Settings that are compared with each other, curve by curve.
pub struct Sweep {
    pub title: Label,
    pub axes: Axes,
    /// What the size of a setting counts: `longitudes`.
    pub size: Message,
    /// What the errors are errors of: `intensity`.
    pub quantity: Message,
    /// How errors fall with the size.
    pub law: Law,
    pub reference: Reference,
    /// What counts as memory, and how it was counted.
    pub memory: Message,
    pub curves: Vec<Curve>,
}

/// What errors are measured against.
#[derive(Clone, Debug)]
pub struct Reference {
    pub what: Label,
    /// How far it may be off itself (rms), and how that is known.
    pub error: f64,
    pub known_by: Label,
}

impl Reference {
    /// Where only time is measured.
    pub fn none() -> Self {
        Reference {
            what: Label::of("reference-none"),
            error: 0.0,
            known_by: Label::Plain(String::new()),
        }
    }
}

/// The settings of one method, from coarse to fine.
pub struct Curve {
    pub name: Label,
    pub sweep_settings: Vec<Setting>,
}

impl Curve {
    /// Settings that are all meant to find the same.
    pub fn against(truth: &Rc<[f64]>, name: Label, sweep_settings: Vec<Setting>) -> Self {
        let mut curve = Curve {
            name,
            sweep_settings,
        };
        for sweep_setting in &mut curve.sweep_settings {
            sweep_setting.truth = Some(truth.clone());
        }
        curve
    }
}

/// One setting.
pub struct Setting {
    pub setting: Label,
    /// As far as orders of convergence and growth refer to it.
    pub size: f64,
    pub bytes: u64,
    pub operations: Vec<Operations>,
    /// What is right; a NaN stands where nothing is compared. Without one there is no error.
    pub truth: Option<Rc<[f64]>>,
    /// What it draws, if anything.
    pub drawn: Option<Drawn>,
    /// The work that is timed. Errors: why there is no result.
    pub run: Box<Run>,
}

/// A picture that a setting draws, so that it can be walked through.
#[derive(Clone, Debug)]
pub struct Drawn {
    pub setup: Arc<Setup>,
    pub method: Method,
}

pub type Run = dyn Fn() -> Result<Values, String>;

/// How often something was done: `rays`, as files have it and the catalogues call it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operations {
    pub of: &'static str,
    pub count: u64,
}

impl Operations {
    /// `30000 pixels`
    pub fn text(&self, language: Language) -> String {
        let count = self.count.to_string();
        called_with("operations", self.of, &[("count", &count)], language)
            .unwrap_or_else(|| format!("{count} {}", self.of))
    }
}

/// What a run brings forth.
pub enum Values {
    Picture(Frame),
    Numbers(Vec<f64>),
}

impl Values {
    /// As numbers: of a picture the channels of its pixels.
    pub fn numbers(self) -> Vec<f64> {
        match self {
            Values::Picture(frame) => {
                let colors = frame.color.iter();
                colors.flat_map(|color| color.channels()).collect()
            }
            Values::Numbers(numbers) => numbers,
        }
    }
}
