//! Ties what a lesson says and asks to the steps of its run.

use super::answer::{Answer, arrow, order, pick};
use super::error::{LessonError, problem};
use super::file::{AnswerFile, QuestionFile, StepFile};
use super::narrated::{Narrated, Question};
use super::template::{fill, names, types_numbers};
use super::text::Text;
use crate::language::Language;
use crate::methods::Mistake;
use crate::panels::{Hidden, Panel, named_by};
use crate::record::{Fields, Value};
use crate::replay::{Query, Run, Walk, query};
use crate::scene::document::{Keyed, Problem};

/// Finds every narrated step, in order, and fills in its texts. In a `changed` run a question may have no answer, and a step that does not
/// happen is narrated at the one before it, or at the first.
pub(super) fn narrate(
    steps: &[StepFile],
    run: &Run,
    changed: bool,
) -> Result<Vec<Narrated>, LessonError> {
    let mut search = Search {
        run,
        walk: run.walk(),
        changed,
        kinds_are_listed: false,
        problems: Vec::new(),
    };
    let mut narrated: Vec<Narrated> = Vec::new();
    let mut not_happening = Vec::new();
    let mut from = 0;
    for (index, step) in steps.iter().enumerate() {
        let before = search.problems.len();
        let found = search.narrated(index, step, from);
        let is_right = search.problems.len() == before;
        match found.filter(|_| is_right || !changed) {
            Some(mut said) => {
                from = said.step + 1;
                said.not_happening.append(&mut not_happening);
                narrated.push(said);
            }
            None if changed => {
                search.problems.truncate(before);
                let missing = step.clone();
                match narrated.last_mut() {
                    Some(said) => said.not_happening.push(missing),
                    None => not_happening.push(missing),
                }
            }
            None => {}
        }
    }
    if search.problems.is_empty() {
        Ok(narrated)
    } else {
        Err(LessonError {
            problems: search.problems,
        })
    }
}

/// Looks things up in a run, and keeps what it does not find.
struct Search<'a> {
    run: &'a Run,
    walk: &'a dyn Walk,
    changed: bool,
    /// The kinds of steps are listed in the first problem that is about them.
    kinds_are_listed: bool,
    problems: Vec<Problem>,
}

impl Search<'_> {
    /// What is said at the first step at or behind `from` that is meant; texts that cannot be filled are problems.
    fn narrated(&mut self, index: usize, step: &StepFile, from: usize) -> Option<Narrated> {
        let place = format!("steps[{index}]");
        let at = self.find(&step.at, from, &place)?;
        let slide = step.slide.as_ref();
        Some(Narrated {
            index,
            step: at,
            title: step.title.clone(),
            key: step.key.as_deref().and_then(Panel::called),
            values: names(step.say.in_language(Language::English)),
            types_numbers: types_numbers(step.say.in_language(Language::English)),
            say: self.fill(&step.say, at, &format!("{place}.say")),
            slide: slide.map(|slide| self.fill(slide, at, &format!("{place}.slide"))),
            question: step.question.as_ref().and_then(|Keyed(question)| {
                self.question(question, at, &format!("{place}.question"))
            }),
            mistake: step.mistake.as_deref().and_then(Mistake::from_name),
            not_happening: Vec::new(),
        })
    }

    /// The first step at or behind `from` that the selector means.
    fn find(&mut self, selector: &Query, from: usize, place: &str) -> Option<usize> {
        let found = query::matches(self.walk, selector, from..self.walk.len()).next();
        if found.is_none() {
            let mut message = format!("no step from {from} on is like this");
            if !std::mem::replace(&mut self.kinds_are_listed, true) {
                let kinds = query::kinds(self.walk).into_iter().map(|(kind, _)| kind);
                let kinds = kinds.collect::<Vec<_>>().join(", ");
                message += &format!("; the run has steps of the kinds {kinds}");
            }
            self.problems.push(problem(format!("{place}.at"), message));
        }
        found
    }

    /// A text in both languages, with the values of `step`.
    fn fill(&mut self, text: &Text, step: usize, place: &str) -> [String; 2] {
        self.fill_with(text, &self.walk.fields(step), place)
    }

    fn fill_with(&mut self, text: &Text, fields: &Fields, place: &str) -> [String; 2] {
        text.both().map(|(language, words)| {
            let prepared = self.run.prepared();
            let called = |field: &str, value| named_by(prepared, field, value, language);
            fill(words, fields, called, language).unwrap_or_else(|message| {
                // One text may stand for both languages.
                let place = format!("{place}.{}", text.shown_in(language).code());
                let found = problem(place, message);
                if !self.problems.contains(&found) {
                    self.problems.push(found);
                }
                String::new()
            })
        })
    }

    fn question(
        &mut self,
        question: &QuestionFile,
        asked_at: usize,
        place: &str,
    ) -> Option<Question> {
        let before = self.problems.len();
        let step = self.find(&question.at, asked_at + 1, place);
        // What is given for an answer may be recorded only where it is used: there it is read where it is not known before.
        let mut given = step.map_or_else(Fields::default, |step| self.walk.fields(step));
        given.0.extend(self.walk.fields(asked_at).0);
        let ask = self.fill_with(&question.ask, &given, &format!("{place}.ask"));
        let hint = question.hint.as_ref();
        let hint = hint.map(|hint| self.fill(hint, asked_at, &format!("{place}.hint")));
        let why = step.map(|step| self.fill(&question.why, step, &format!("{place}.why")));
        let answer = step.map(|step| read_answer(question, self.run, asked_at, step));
        if let Some(Err(message)) = &answer {
            let problem = problem(format!("{place}.answer"), message.clone());
            self.problems.push(problem);
        }
        let answer = match answer {
            Some(Ok(answer)) if self.problems.len() == before => answer,
            _ if self.changed => {
                self.problems.truncate(before);
                Answer::Undecided
            }
            _ => return None,
        };
        Some(Question {
            ask,
            why: why.unwrap_or_default(),
            hint,
            step: step.unwrap_or(asked_at),
            answer,
            hide: hidden(question),
        })
    }
}

/// Names that are none are refused when the file is read.
fn hidden(question: &QuestionFile) -> Vec<Hidden> {
    let names = question.hide.iter().flatten();
    names.filter_map(|name| Hidden::from_name(name)).collect()
}

fn read_answer(
    question: &QuestionFile,
    run: &Run,
    asked_at: usize,
    step: usize,
) -> Result<Answer, String> {
    let walk = run.walk();
    let fields = walk.fields(step);
    match &question.answer {
        AnswerFile::Number { field, tolerance } => {
            if !(tolerance.is_finite() && *tolerance >= 0.0) {
                return Err(format!(
                    "found the tolerance {tolerance}; allowed are numbers from 0"
                ));
            }
            let value = query::number_of(&fields, field).ok_or_else(|| {
                format!(
                    "`{field}` is no number recorded at the step of the answer, which is {}",
                    walk.kind(step)
                )
            })?;
            Ok(Answer::Number {
                value,
                tolerance: *tolerance,
            })
        }
        AnswerFile::Choice(options) => {
            let holding: Vec<usize> = (0..options.len())
                .filter(|&index| {
                    query::matches(walk, &options[index].when, step..step + 1)
                        .next()
                        .is_some()
                })
                .collect();
            let [right] = holding[..] else {
                return Err(format!(
                    "{} of the {} options hold at the step of the answer; exactly one must",
                    holding.len(),
                    options.len()
                ));
            };
            let options = options
                .iter()
                .map(|option| option.text.both().map(|(_, text)| text.to_owned()))
                .collect();
            Ok(Answer::Choice { options, right })
        }
        AnswerFile::Arrow { field, tolerance } => {
            arrow::read(run, asked_at, step, field, *tolerance)
        }
        AnswerFile::Order(items) => order::read(run, asked_at, items),
        AnswerFile::Pick { field } => pick::read(run, step, field),
        AnswerFile::Pixel { tolerance } => match (fields.get("x"), fields.get("y")) {
            (Some(Value::Integer(x)), Some(Value::Integer(y))) => {
                let whole =
                    |v: i64| u32::try_from(v).map_err(|_| format!("{v} is no place in a picture"));
                Ok(Answer::Pixel {
                    x: whole(x)?,
                    y: whole(y)?,
                    tolerance: *tolerance,
                })
            }
            _ => Err(format!(
                "the step of the answer, {}, does not record a pixel's x and y",
                walk.kind(step)
            )),
        },
    }
}
