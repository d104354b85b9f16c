//! Every text of a lesson file: none is empty, and those that are in one language are reported.

use super::error::problem;
use super::file::{AnswerFile, LessonFile};
use super::parameters::ParameterFile;
use super::text::Text;
use crate::language::Language;
use crate::scene::Note;
use crate::scene::document::{ByName, Keyed, Problem};

/// Calls `look` with every text of a lesson and its place.
fn each(file: &LessonFile, look: &mut dyn FnMut(String, &Text)) {
    look("title".into(), &file.title);
    look("summary".into(), &file.summary);
    if let Some(text) = &file.recap {
        look("recap".into(), text);
    }
    for (name, Keyed(text)) in file.names.iter().flat_map(|ByName(names)| names) {
        look(format!("names.{name}"), text);
    }
    for (index, parameter) in file.parameters.iter().flatten().enumerate() {
        each_of_parameter(&format!("parameters[{index}]"), parameter, look);
    }
    for (index, Keyed(step)) in file.steps.iter().enumerate() {
        let place = format!("steps[{index}]");
        look(format!("{place}.say"), &step.say);
        for (key, text) in [
            ("title", &step.title),
            ("slide", &step.slide),
            ("otherwise", &step.otherwise),
        ] {
            if let Some(text) = text {
                look(format!("{place}.{key}"), text);
            }
        }
        let Some(Keyed(question)) = &step.question else {
            continue;
        };
        let place = format!("{place}.question");
        look(format!("{place}.ask"), &question.ask);
        look(format!("{place}.why"), &question.why);
        if let Some(hint) = &question.hint {
            look(format!("{place}.hint"), hint);
        }
        let of_answer: Vec<&Text> = match &question.answer {
            AnswerFile::Choice(options) => options.iter().map(|option| &option.text).collect(),
            AnswerFile::Order(items) => items.iter().map(|item| &item.text).collect(),
            _ => Vec::new(),
        };
        let kind = match question.answer {
            AnswerFile::Order(_) => "order",
            _ => "choice",
        };
        for (index, text) in of_answer.into_iter().enumerate() {
            look(format!("{place}.answer.{kind}[{index}].text"), text);
        }
    }
}

fn each_of_parameter(place: &str, file: &ParameterFile, look: &mut dyn FnMut(String, &Text)) {
    match file {
        ParameterFile::Number(Keyed(number)) => {
            look(format!("{place}.number.name"), &number.name);
            if let Some(unit) = &number.unit {
                look(format!("{place}.number.unit"), unit);
            }
        }
        ParameterFile::Choice(Keyed(choice)) => {
            look(format!("{place}.choice.name"), &choice.name);
            for (index, Keyed(option)) in choice.options.iter().enumerate() {
                look(
                    format!("{place}.choice.options[{index}].name"),
                    &option.name,
                );
            }
        }
        _ => {}
    }
}

/// Refuses empty texts, and says which are not in both languages.
pub fn check(file: &LessonFile, problems: &mut Vec<Problem>) -> Vec<Note> {
    let mut missing: [Vec<String>; 2] = Default::default();
    let mut count = 0;
    each(file, &mut |place, text| {
        count += 1;
        let own = Language::ALL.map(|language| text.own(language));
        if own == [None; 2] {
            let message = "found no text; it needs the key `en`, `id` or both";
            problems.push(problem(place, message));
            return;
        }
        for (language, own) in Language::ALL.into_iter().zip(own) {
            match own {
                Some(own) if own.trim().is_empty() => {
                    let place = format!("{place}.{}", language.code());
                    problems.push(problem(place, "found an empty text"));
                }
                Some(_) => {}
                None => missing[language as usize].push(place.clone()),
            }
        }
    });
    let notes = Language::ALL.into_iter().zip(missing);
    notes
        .flat_map(|(language, places)| notes_of(language, places, count))
        .collect()
}

/// A lesson that is written in one language is reported once.
fn notes_of(language: Language, places: Vec<String>, texts: usize) -> Vec<Note> {
    let [name, other] = match language {
        Language::Indonesian => ["Indonesian", "English"],
        _ => ["English", "Indonesian"],
    };
    if places.len() == texts {
        let what = format!("no text of the lesson is in {name}");
        return vec![Note::new("steps", what, format!("it is shown in {other}"))];
    }
    let note = |place| {
        let why = format!("the one in {other} is shown");
        Note::new(place, format!("the text in {name} is missing"), why)
    };
    places.into_iter().map(note).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::{Lesson, builtin, builtins};
    use crate::scene::Limits;

    #[test]
    fn the_lessons_of_the_program_have_every_text_in_both_languages() {
        for builtin in builtins() {
            assert_eq!(builtin.read().unwrap().missing, [], "{}", builtin.id);
        }
    }

    /// Every text of lesson 4 but its titles, without one of its languages.
    #[test]
    fn each_text_that_is_missing_is_named_and_a_whole_language_once() {
        let whole = include_str!("../../lessons/04-gouraud-triangle.json");
        let read = |text: &str| {
            Lesson::read(text.as_bytes(), &Limits::default(), &mut |_| unreachable!()).unwrap()
        };
        let without = |keep: &str| {
            let mut document: serde_json::Value = serde_json::from_str(whole).unwrap();
            drop_indonesian(&mut document, keep);
            read(&document.to_string()).missing
        };
        let notes = without("say");
        let says = builtin("gouraud-triangle").unwrap().read().unwrap();
        let in_place = |place: &str| notes.iter().any(|note| note.place == place);
        assert!(in_place("title") && in_place("steps[0].title") && !in_place("steps[0].say"));
        assert!(notes.len() > says.explanations());
        let whole = without("nothing");
        assert_eq!(
            whole.iter().map(Note::to_string).collect::<Vec<_>>(),
            ["steps: no text of the lesson is in Indonesian: it is shown in English"]
        );
    }

    fn drop_indonesian(value: &mut serde_json::Value, keep: &str) {
        match value {
            serde_json::Value::Array(list) => {
                list.iter_mut().for_each(|one| drop_indonesian(one, keep));
            }
            serde_json::Value::Object(members) => {
                if members.contains_key("en") {
                    members.remove("id");
                }
                let others = members.iter_mut().filter(|(key, _)| *key != keep);
                others.for_each(|(_, one)| drop_indonesian(one, keep));
            }
            _ => {}
        }
    }
}
