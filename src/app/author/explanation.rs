//! The form of an explanation: what it says, where, in which panel, and what it asks.

use super::form::Form;
use super::{question, strings};
use egui::Ui;

/// Lines of a text.
const ROWS: usize = 4;

pub fn show(form: &mut Form, index: usize, ui: &mut Ui) {
    let place = format!("steps[{index}]");
    let last = index.checked_sub(1);
    let before = last.and_then(|last| form.session.explained_at(last));
    let from = before.map_or(0, |said| said.step + 1);
    form.text(strings::SAY, &place, "say", ROWS, ui);
    values(form, index, ui);
    form.text(strings::TITLE, &place, "title", 1, ui);
    form.selector(strings::AT, &place, "at", from, ui);
    form.choice(strings::KEY_PANEL, &place, "key", &panels(form), ui);
    form.choice(strings::MISTAKE, &place, "mistake", &mistakes(form), ui);
    question::show(form, index, ui);
    if form
        .at("parameters")
        .as_array()
        .is_some_and(|list| !list.is_empty())
    {
        form.text(strings::OTHERWISE, &place, "otherwise", 2, ui);
    }
}

/// The names of the values that the text can have in braces.
fn values(form: &Form, index: usize, ui: &mut Ui) {
    let session = form.session;
    let said = session.explained_at(index);
    let Some(said) = said.filter(|_| session.follows_lesson()) else {
        return;
    };
    let fields = session.walk().fields(said.step);
    let names: Vec<String> = fields
        .iter()
        .map(|field| format!("{{{}}}", field.name))
        .collect();
    let hint = form.localize(strings::VALUES);
    egui::CollapsingHeader::new(egui::RichText::new(hint).size(12.5))
        .id_salt("values")
        .show(ui, |ui| {
            let text = egui::RichText::new(names.join(" ")).monospace().size(12.0);
            ui.label(text);
        });
}

/// The lesson's panels by their titles; the first one need not be named.
fn panels(form: &Form) -> Vec<(Option<String>, String)> {
    let panels = &form.session.lesson().panels;
    let named = panels.iter().map(|panel| {
        (
            Some(panel.name().to_owned()),
            form.localize(panel.title()).to_owned(),
        )
    });
    let first = (None, form.localize(strings::FIRST_PANEL).to_owned());
    std::iter::once(first).chain(named).collect()
}

/// The mistakes that the lesson's method allows, by their titles.
fn mistakes(form: &Form) -> Vec<(Option<String>, String)> {
    let language = form.session.look.language;
    let possible = form.session.possible_mistakes();
    let named = possible.map(|mistake| (Some(mistake.name().into()), mistake.title(language)));
    let none = (None, form.localize(strings::NO_MISTAKE).to_owned());
    std::iter::once(none).chain(named).collect()
}
