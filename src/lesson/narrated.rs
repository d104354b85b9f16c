//! What is said and asked at a step, with the values of the run filled in.

use super::file::Text;
use crate::panels::strings::Language;
use crate::panels::{Hidden, Panel};

/// What is said at a step.
#[derive(Clone, Debug)]
pub struct Narrated {
    pub step: usize,
    /// A few words for the outline, where the lesson gives them.
    pub title: Option<Text>,
    /// The panel to look at: the lesson's first unless the step gives another.
    pub key: Option<Panel>,
    /// By language, with the values of the run filled in.
    pub(super) say: [String; 2],
    pub(super) slide: Option<[String; 2]>,
    pub question: Option<Question>,
}

/// A question whose answer was read from the run.
#[derive(Clone, Debug)]
pub struct Question {
    pub(super) ask: [String; 2],
    pub(super) why: [String; 2],
    /// The step that shows the answer.
    pub step: usize,
    pub answer: Answer,
    /// What is hidden until it is answered, beside all that is ahead of the step.
    pub hide: Vec<Hidden>,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    Number {
        value: f64,
        tolerance: f64,
    },
    /// Options by language, and the index of the right one.
    Choice {
        options: Vec<[String; 2]>,
        right: usize,
    },
    Pixel {
        x: u32,
        y: u32,
        tolerance: u32,
    },
}

impl Narrated {
    pub fn say(&self, language: Language) -> &str {
        &self.say[language as usize]
    }

    /// The note on what the lecture's slide prints instead.
    pub fn slide(&self, language: Language) -> Option<&str> {
        self.slide.as_ref().map(|slide| &*slide[language as usize])
    }
}

impl Question {
    pub fn ask(&self, language: Language) -> &str {
        &self.ask[language as usize]
    }

    pub fn why(&self, language: Language) -> &str {
        &self.why[language as usize]
    }
}
