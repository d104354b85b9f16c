//! The form of a question: what it asks, the step at which the run answers, and what the answer is there.

use super::super::prose;
use super::form::Form;
use super::strings;
use crate::language::Message;
use crate::lesson::draft;
use crate::picture::Ink;
use crate::record::Fields;
use crate::scene::edit::Edit;
use egui::{DragValue, Ui, WidgetInfo};
use serde_json::{Value, json};

/// The kinds of answers that can be asked for, by their keys in the file.
const KINDS: [(&str, Message); 5] = [
    ("number", strings::NUMBER),
    ("choice", strings::CHOICE),
    ("pixel", strings::PIXEL),
    ("pick", strings::PICK),
    ("arrow", strings::ARROW),
];

pub fn show(form: &mut Form, index: usize, ui: &mut Ui) {
    let parent = format!("steps[{index}]");
    let place = format!("{parent}.question");
    ui.separator();
    form.heading(form.localize(strings::QUESTION), ui);
    if form.at(&place).is_null() {
        let refused = cannot_ask(form, index).map(|why| form.localize(why));
        if form.button(strings::ASK_HERE, refused, ui) {
            let question = about_this_step(form);
            form.set(&parent, "question", Some(question));
        }
        return;
    }
    form.text(strings::ASK, &place, "ask", 2, ui);
    let explained = form.session.explained_at(index);
    let from = explained.map_or(0, |said| said.step + 1);
    form.selector(strings::ANSWER_AT, &place, "at", from, ui);
    answer(form, index, &place, ui);
    form.text(strings::WHY, &place, "why", 2, ui);
    form.text(strings::HINT, &place, "hint", 1, ui);
    if form.button(strings::NO_QUESTION, None, ui) {
        form.set(&parent, "question", None);
    }
}

/// Why nothing can be asked about the step that is shown, if it cannot.
fn cannot_ask(form: &Form, index: usize) -> Option<Message> {
    let session = form.session;
    let asked_at = session.explained_at(index)?.step;
    if !session.follows_lesson() {
        return Some(strings::OTHER_PART);
    }
    if session.step() <= asked_at {
        return Some(strings::ASK_LATER);
    }
    let own = session.walk().own_fields(session.step());
    let none = draft::answers(&own, session.look.language).is_empty();
    none.then_some(strings::NOTHING_TO_ASK)
}

/// A question about the step that is shown.
fn about_this_step(form: &mut Form) -> Value {
    let session = form.session;
    let language = session.look.language;
    let step = session.step();
    let own = session.walk().own_fields(step);
    let (_, answer) = draft::answers(&own, language).swap_remove(0);
    let [title, why] = session.step_for_a_lesson(step, language);
    let at = form.meanings.proposed(session);
    let ask = match answer["number"]["field"].as_str() {
        Some(field) => strings::ASK_NUMBER.format(language, &[("field", field), ("step", &title)]),
        None => strings::ASK_THING.format(language, &[("step", &title)]),
    };
    draft::question(&at, language, &ask, &why, answer)
}

/// The kind of the answer, what belongs to it, and what it is in the run.
fn answer(form: &mut Form, index: usize, place: &str, ui: &mut Ui) {
    let explained = form.session.explained_at(index);
    let question = explained.and_then(|said| said.question.as_ref());
    let own = match question {
        Some(question) => form.session.walk().own_fields(question.step),
        None => Fields::default(),
    };
    kind(form, place, &own, ui);
    let parent = format!("{place}.answer");
    match kind_of(form, &parent) {
        Some("number") => {
            let names = draft::numbers(&own).into_iter().map(|(name, _)| name);
            field(form, &format!("{parent}.number"), names, ui);
            tolerance(form, &format!("{parent}.number"), ui);
        }
        Some("arrow") => {
            let names = draft::vectors(&own).into_iter();
            field(form, &format!("{parent}.arrow"), names, ui);
            tolerance(form, &format!("{parent}.arrow"), ui);
        }
        Some("pick") => {
            let known = ["object", "blocker", "i", "j"].into_iter();
            let names = known.filter(|name| own.get(name).is_some());
            field(form, &format!("{parent}.pick"), names, ui);
        }
        Some("choice") => options(form, &format!("{parent}.choice"), ui),
        Some("pixel") => tolerance(form, &format!("{parent}.pixel"), ui),
        _ => drop(ui.label(form.localize(strings::IN_THE_FILE))),
    }
    if let Some(question) = question {
        let language = form.session.look.language;
        let answer = question.answer.in_words(language);
        let said = strings::ANSWER_IS.format(language, &[("answer", &answer)]);
        ui.label(prose::prose(form.session, &said, 12.5, Ink::Muted));
    }
}

fn kind_of(form: &Form, parent: &str) -> Option<&'static str> {
    let answer = form.at(parent);
    let mut kinds = KINDS.iter().map(|(kind, _)| *kind);
    kinds.find(|kind| !answer[*kind].is_null())
}

/// The kinds that fit what the step has recorded; another one begins anew.
fn kind(form: &mut Form, place: &str, own: &Fields, ui: &mut Ui) {
    let parent = format!("{place}.answer");
    let now = kind_of(form, &parent);
    let possible = draft::answers(own, form.session.look.language);
    ui.horizontal_wrapped(|ui| {
        for (kind, name) in KINDS {
            let fits = possible.iter().find(|(known, _)| *known == kind);
            let chosen = now == Some(kind);
            if !chosen && fits.is_none() {
                continue;
            }
            if ui.selectable_label(chosen, form.localize(name)).clicked()
                && let Some((_, answer)) = fits.filter(|_| !chosen)
            {
                form.set(place, "answer", Some(answer.clone()));
            }
        }
    });
}

fn field(form: &mut Form, parent: &str, names: impl Iterator<Item = &'static str>, ui: &mut Ui) {
    let options: Vec<_> = names
        .map(|name| (Some(name.to_owned()), name.to_owned()))
        .collect();
    form.choice(strings::VALUE, parent, "field", &options, ui);
}

fn tolerance(form: &mut Form, parent: &str, ui: &mut Ui) {
    let place = format!("{parent}.tolerance");
    let now = form.at(&place).as_f64().unwrap_or_default();
    let whole = parent.ends_with("pixel");
    let mut tolerance = now;
    let name = form.localize(strings::TOLERANCE);
    ui.horizontal(|ui| {
        ui.label(egui::RichText::new(name).size(13.0));
        let drag = DragValue::new(&mut tolerance)
            .range(0.0..=1e6)
            .speed(if whole { 0.1 } else { (0.02 * now).max(1e-4) })
            .max_decimals(if whole { 0 } else { 6 });
        let drag = super::super::parameter_drawer::written(drag, form.session.look.language);
        let response = ui.add(drag);
        response.widget_info(|| WidgetInfo::slider(true, now, name));
    });
    if tolerance != now {
        let value = match whole {
            true => json!(tolerance.round() as u64),
            false => json!(tolerance),
        };
        form.set(parent, "tolerance", Some(value));
    }
}

/// The options of a choice, each with the condition under which it is right.
fn options(form: &mut Form, parent: &str, ui: &mut Ui) {
    let count = form.at(parent).as_array().map_or(0, Vec::len);
    for index in 0..count {
        let place = format!("{parent}[{index}]");
        form.text(strings::OPTION, &place, "text", 1, ui);
        form.line(strings::WHEN, &place, "when", ui);
        let few = (count <= 2).then(|| form.localize(strings::TWO_OPTIONS));
        ui.push_id(index, |ui| {
            if form.button(strings::NO_OPTION, few, ui) {
                form.edits.push(Edit::Remove(place));
            }
        });
    }
    if form.button(strings::ONE_MORE, None, ui) {
        let language = form.session.look.language;
        let text = draft::text(language, form.localize(strings::OPTION));
        let option = json!({ "text": text, "when": "unknown=0" });
        form.edits.push(Edit::Push(parent.to_owned(), option));
    }
}
