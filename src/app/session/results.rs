//! What a search in the reader's own words finds: steps, explanations and things of the scene.

use super::Session;
use crate::app::strings;
use crate::panels::{found, kind_name, said, scope_names};
use crate::picture::plain;

/// The most steps that are listed.
const MOST: usize = 100;

/// The steps that a search has found, ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    /// As it was typed.
    pub text: String,
    pub rows: Vec<Found>,
    /// Whether there are more than are listed.
    pub more: bool,
    /// The question at which the search stopped: what follows it would give answers away.
    pub question: Option<usize>,
}

/// A step with what is shown of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    pub step: usize,
    /// The explanation's title, or the name of the kind.
    pub title: String,
    pub sentence: String,
    /// The scopes around it, outermost first.
    pub scopes: String,
}

impl Session {
    pub fn results(&self) -> Option<&Results> {
        self.results.as_ref()
    }

    /// Lists what a text finds up to the next question that waits. Whether there is anything.
    pub(super) fn list_results(&mut self, text: &str) -> bool {
        let len = self.walk().len();
        let question = self.question_between(0, len);
        let end = question.map_or(len, |step| step + 1);
        let language = self.look.language;
        let wanted = text.trim().to_lowercase();
        let explained = self.open.narrated.iter().filter(|said| {
            let title = said.title.as_ref();
            let title = title.map_or("", |title| title.in_language(language));
            let texts = [title, said.text(language)].map(|text| plain(text).to_lowercase());
            !wanted.is_empty() && texts.iter().any(|text| text.contains(&wanted))
        });
        let explained = explained.map(|said| said.step).filter(|&step| step < end);
        let mut steps: Vec<usize> = match self.follows_lesson() {
            true => explained.collect(),
            false => Vec::new(),
        };
        steps.extend(found(&self.open.run, text, language, 0..end, MOST + 1));
        steps.sort_unstable();
        steps.dedup();
        let more = steps.len() > MOST;
        steps.truncate(MOST);
        let rows = steps.into_iter().map(|step| self.found(step)).collect();
        let results = Results {
            text: text.to_owned(),
            rows,
            more,
            question,
        };
        let any = !results.rows.is_empty();
        self.results = any.then_some(results);
        any
    }

    fn found(&self, step: usize) -> Found {
        let (run, language) = (&self.open.run, self.look.language);
        let explained = self.narrated.binary_search(&step).ok();
        let explained = explained.filter(|_| self.follows_lesson());
        let title = explained.and_then(|index| self.open.narrated[index].title.as_ref());
        let title = title.map(|title| plain(title.in_language(language)));
        let outline = run.walk().outline();
        let known = self.panel_input().last_known();
        let mut scopes: Vec<String> = outline
            .scopes(step)
            .map(|scope| scope_names(run, scope, known, language).swap_remove(0))
            .collect();
        scopes.reverse();
        Found {
            step,
            title: title.unwrap_or_else(|| kind_name(run.walk().kind(step), language)),
            sentence: said(run, step, language),
            scopes: scopes.join(" › "),
        }
    }

    /// How the search ended, for below the list.
    pub fn results_end(&self) -> Option<String> {
        let results = self.results.as_ref()?;
        let language = self.look.language;
        let count = results.rows.len().to_string();
        match results.question {
            _ if results.more => {
                Some(strings::FIRST_RESULTS.format(language, &[("count", &count)]))
            }
            Some(step) => {
                let step = step.to_string();
                Some(strings::RESULTS_TO_QUESTION.format(language, &[("step", &step)]))
            }
            None => None,
        }
    }
}
