//! The lesson's explanations in their order: to pin the step that is shown as one more, to go to one, to move and to delete it.

use super::super::document::Document;
use super::super::session::{Command, Session};
use super::super::{prose, style};
use super::form::{at, button, in_words};
use super::{Meanings, strings};
use crate::lesson::anchor::{self, Meaning};
use crate::lesson::draft;
use crate::picture::{Ink, plain};
use crate::replay::Query;
use crate::scene::edit::Edit;
use egui::{Button, RichText, ScrollArea, Ui, WidgetInfo};
use serde_json::{Value, json};

/// The explanation that is chosen, by its index; none where the lesson as a whole is.
pub fn selected(document: &Document) -> Option<usize> {
    let index = document.selected.strip_prefix("steps[")?;
    let index = index.strip_suffix(']')?.parse().ok()?;
    (index < steps(document)).then_some(index)
}

fn place(index: usize) -> String {
    format!("steps[{index}]")
}

fn steps(document: &Document) -> usize {
    document.value["steps"].as_array().map_or(0, Vec::len)
}

/// Errors: why a change cannot be made.
pub fn show(
    session: &mut Session,
    document: &mut Document,
    meanings: &mut Meanings,
    height: f32,
    ui: &mut Ui,
) -> Result<(), String> {
    pin(session, document, meanings, ui);
    let mut go = None;
    let seen = ui.scope_id().with("seen");
    let was: Option<String> = ui.data(|data| data.get_temp(seen));
    let is_new = was.as_ref() != Some(&document.selected);
    ui.data_mut(|data| data.insert_temp(seen, document.selected.clone()));
    ScrollArea::vertical()
        .id_salt("explanations")
        .max_height(height)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            let spacing = ui.spacing_mut();
            spacing.item_spacing.y = 1.0;
            spacing.button_padding.y = 2.0;
            spacing.interact_size.y = 20.0;
            let whole = selected(document).is_none();
            let name = session.localize(strings::WHOLE);
            if row(name, [whole, false], is_new, ui) {
                document.selected = String::new();
            }
            for index in 0..steps(document) {
                let title = title(session, &document.value, index);
                let step = session.explained_at(index).map(|said| said.step);
                let is_here = session.follows_lesson() && step == Some(session.step());
                let is_chosen = selected(document) == Some(index);
                let name = format!("{}  {title}", index + 1);
                if row(&name, [is_chosen, is_here], is_new, ui) {
                    document.selected = place(index);
                    go = step;
                }
            }
        });
    if let Some(step) = go {
        go_to(session, step);
    }
    match selected(document) {
        Some(index) => actions(session, document, index, ui),
        None => Ok(()),
    }
}

/// Shows a step of the lesson.
fn go_to(session: &mut Session, step: usize) {
    let focus = session.lesson().focus;
    // Both are the lesson's own, which was run with them.
    let _ = session.update(Command::Focus(focus));
    let _ = session.update(Command::Seek(step));
}

/// A row of the list, brought into view where it was chosen elsewhere; whether it was clicked.
fn row(text: &str, [chosen, here]: [bool; 2], is_new: bool, ui: &mut Ui) -> bool {
    let shown = match here {
        true => style::strong(text, 13.0),
        false => RichText::new(text).size(13.0),
    };
    let row = Button::new(shown)
        .selected(chosen)
        .frame_when_inactive(false);
    let response = ui.add(row.truncate());
    response.widget_info(|| WidgetInfo::selected(egui::Role::Button, true, chosen, text));
    if chosen && is_new {
        response.scroll_to_me(None);
    }
    response.clicked()
}

/// What an explanation is called, or how it begins.
fn title(session: &Session, lesson: &Value, index: usize) -> String {
    let step = &lesson["steps"][index];
    let language = session.look.language;
    let texts = [&step["title"], &step["say"]].map(|text| {
        let own = text[language.code()].as_str();
        let any = text.as_object().and_then(|text| text.values().next());
        own.or(any.and_then(Value::as_str)).unwrap_or_default()
    });
    let first = texts.into_iter().find(|text| !text.is_empty());
    plain(first.unwrap_or_default()).replace('\n', " ")
}

/// The button that pins the step that is shown, and the selector that would stand for it.
fn pin(session: &mut Session, document: &mut Document, meanings: &mut Meanings, ui: &mut Ui) {
    let before = session.explained();
    let index = before.partition_point(|said| said.step < session.step());
    let from = index.checked_sub(1).map_or(0, |last| before[last].step + 1);
    let at = meanings.proposed(session);
    let meaning = meanings.of(session, &at, from);
    let refused = cannot_pin(session, document, meaning);
    ui.horizontal_wrapped(|ui| {
        let pinned = button(session, strings::PIN, refused.as_deref(), ui);
        ui.label(RichText::new(at.to_string()).monospace().size(12.0));
        if pinned {
            let edit = pinned_at(session, document, &at, index);
            document.edit(&[edit], session);
            document.selected = place(index);
        }
    });
    let words = refused.unwrap_or_else(|| in_words(meaning, session.look.language));
    ui.label(prose::prose(session, &words, 12.5, Ink::Muted));
}

fn cannot_pin(session: &Session, document: &Document, meaning: Meaning) -> Option<String> {
    if !document.problems.is_empty() {
        return Some(session.localize(strings::MEND).to_owned());
    }
    if let Some(why) = session.cannot_explain_here() {
        return Some(session.localize(why).to_owned());
    }
    not_distinct(session, meaning)
}

/// Why a selector does not stand for the step that is shown, if it does not.
fn not_distinct(session: &Session, meaning: Meaning) -> Option<String> {
    let other = meaning.step.filter(|&step| step != session.step())?;
    let step = other.to_string();
    Some(strings::NOT_DISTINCT.format(session.look.language, &[("step", &step)]))
}

/// The step that is shown as an explanation, before the one of that index.
fn pinned_at(session: &Session, document: &Document, at: &Query, index: usize) -> Edit {
    let language = session.look.language;
    let [title, say] = session.step_for_a_lesson(session.step(), language);
    let first = session.lesson().panels.first().copied();
    let key = session.key_panel().filter(|&key| Some(key) != first);
    let step = draft::step(at, language, &title, &say, key);
    match index < steps(document) {
        true => Edit::Before(place(index), step),
        false => Edit::Push("steps".into(), step),
    }
}

/// What can be done with the explanation that is chosen.
fn actions(
    session: &mut Session,
    document: &mut Document,
    index: usize,
    ui: &mut Ui,
) -> Result<(), String> {
    let mend = (!document.problems.is_empty()).then_some(strings::MEND);
    let mend = mend.or_else(|| session.runs_otherwise());
    let mend = mend.map(|why| session.localize(why));
    let here = session.cannot_explain_here();
    let here = here.map(|why| session.localize(why));
    let only = (steps(document) == 1).then(|| session.localize(strings::LAST_ONE));
    let first = (index == 0).then(|| session.localize(strings::IS_FIRST));
    let last = (index + 1 == steps(document)).then(|| session.localize(strings::IS_LAST));
    let mut outcome = Ok(());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        if button(session, strings::EARLIER, mend.or(first), ui) {
            outcome = exchange(session, document, index - 1, index - 1);
        }
        if button(session, strings::LATER, mend.or(last), ui) {
            outcome = exchange(session, document, index, index + 1);
        }
        if button(session, strings::MOVE, mend.or(here), ui) {
            outcome = move_here(session, document, index);
        }
        if button(session, strings::DELETE, mend.or(only), ui) {
            delete(session, document, index);
        }
    });
    outcome
}

/// Lets an explanation and the next one change places, where the run goes in that order too.
fn exchange(
    session: &mut Session,
    document: &mut Document,
    first: usize,
    then: usize,
) -> Result<(), String> {
    let swap = Edit::Swap(place(first), place(first + 1));
    let tried = document.try_to_edit(&[swap], session);
    tried.map_err(|why| strings::ORDER.format(session.look.language, &[("why", &why)]))?;
    document.selected = place(then);
    Ok(())
}

/// Ties an explanation to the step that is shown, at its place among the others.
fn move_here(session: &mut Session, document: &mut Document, index: usize) -> Result<(), String> {
    let here = session.step();
    let query = anchor::selector(session.walk(), here);
    let others = session.explained().iter().enumerate();
    let before = others.filter(|(other, said)| *other != index && said.step < here);
    let (target, from) = before.fold((0, 0), |(count, _), (_, said)| (count + 1, said.step + 1));
    let meaning = Meaning::of(session.walk(), &query, from);
    if let Some(why) = not_distinct(session, meaning) {
        return Err(why);
    }
    let set = Edit::Set(format!("{}.at", place(index)), json!(query.to_string()));
    let swap = |first: usize| Edit::Swap(place(first), place(first + 1));
    let swaps: Vec<Edit> = match target > index {
        true => (index..target).map(swap).collect(),
        false => (target..index).rev().map(swap).collect(),
    };
    let edits: Vec<Edit> = std::iter::once(set).chain(swaps).collect();
    document.try_to_edit(&edits, session)?;
    document.selected = place(target);
    Ok(())
}

/// Deletes an explanation. The next one stays at its step, also where its selector would now mean an earlier one.
fn delete(session: &mut Session, document: &mut Document, index: usize) {
    let explained = session.explained();
    let from = index
        .checked_sub(1)
        .map_or(0, |last| explained[last].step + 1);
    let mut edits = Vec::new();
    if let Some(next) = explained.get(index + 1) {
        let anchor = format!("{}.at", place(index + 1));
        let query = at(&document.value, &anchor).as_str();
        let query = query.and_then(|text| text.parse::<Query>().ok());
        let meant = query.map(|query| Meaning::of(session.walk(), &query, from).step);
        if meant.is_some_and(|step| step != Some(next.step)) {
            let new = anchor::selector(session.walk(), next.step);
            edits.push(Edit::Set(anchor, json!(new.to_string())));
        }
    }
    edits.push(Edit::Remove(place(index)));
    document.edit(&edits, session);
    document.selected = place(index.min(steps(document).saturating_sub(1)));
}
