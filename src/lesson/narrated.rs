//! What is said and asked at a step, with the values of the run filled in.

use super::answer::Answer;
use super::file::StepFile;
use super::text::Text;
use crate::methods::Mistake;
use crate::panels::strings::Language;
use crate::panels::{Hidden, Panel};

/// What is said at a step.
#[derive(Clone, Debug)]
pub struct Narrated {
    /// Its place among the lesson's explanations.
    pub index: usize,
    pub step: usize,
    /// A few words for the outline, where the lesson gives them.
    pub title: Option<Text>,
    /// The panel to look at: the lesson's first unless the step gives another.
    pub key: Option<Panel>,
    /// By language, with the values of the run filled in.
    pub(super) say: [String; 2],
    pub(super) slide: Option<[String; 2]>,
    /// The values that the text shows, by their names.
    pub values: Vec<String>,
    /// Whether the text has numbers that were typed, which need not hold after a change.
    pub types_numbers: bool,
    pub question: Option<Question>,
    /// A classic mistake at this step.
    pub mistake: Option<Mistake>,
    /// Explanations of what does not happen after a change: those that would follow, and before the first those that would come before.
    pub(super) not_happening: Vec<StepFile>,
}

/// A question whose answer was read from the run.
#[derive(Clone, Debug)]
pub struct Question {
    pub(super) ask: [String; 2],
    pub(super) why: [String; 2],
    pub(super) hint: Option<[String; 2]>,
    /// The step that shows the answer.
    pub step: usize,
    pub answer: Answer,
    /// What is hidden until it is answered, beside all that is ahead of the step.
    pub hide: Vec<Hidden>,
}

impl Narrated {
    pub fn text(&self, language: Language) -> &str {
        &self.say[language as usize]
    }

    /// The titles of what does not happen after a change, each with what happens instead, where the lesson says it.
    pub fn not_happening<'a>(
        &'a self,
        language: Language,
    ) -> impl Iterator<Item = (Option<&'a str>, Option<&'a str>)> {
        self.not_happening.iter().map(move |step| {
            let title = step.title.as_ref();
            let otherwise = step.otherwise.as_ref();
            let shown = |text: Option<&'a Text>| text.map(|text| text.in_language(language));
            (shown(title), shown(otherwise))
        })
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

    /// What helps after a first wrong answer, where the lesson says it.
    pub fn hint(&self, language: Language) -> Option<&str> {
        self.hint.as_ref().map(|hint| &*hint[language as usize])
    }

    pub fn why(&self, language: Language) -> &str {
        &self.why[language as usize]
    }
}
