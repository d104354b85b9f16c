//! What is in a lesson, as far as it is known without running it: for the list of lessons.

use super::resolve::Lesson;
use crate::language::Language;
use crate::scene::document::Keyed;

impl Lesson {
    /// How many steps are explained.
    pub fn explanations(&self) -> usize {
        self.steps.len()
    }

    pub fn questions(&self) -> usize {
        let asks = self.steps.iter().filter(|step| step.question.is_some());
        asks.count()
    }

    /// Everything that the lesson says and asks, in a language. Values of the run stand as their names in braces.
    pub fn texts(&self, language: Language) -> impl Iterator<Item = &str> {
        let steps = self.steps.iter().flat_map(|step| {
            let question = step.question.as_ref();
            let asked = question.map(|Keyed(question)| [&question.ask, &question.why]);
            let said = step.title.iter().chain([&step.say]).chain(&step.slide);
            said.chain(asked.into_iter().flatten())
        });
        let whole = [&self.title, &self.summary]
            .into_iter()
            .chain(&self.recap)
            .chain(steps);
        let texts = whole.map(move |text| text.in_language(language));
        texts.chain(self.topics.iter().map(String::as_str))
    }
}
