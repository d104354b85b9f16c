//! The parts of a form: texts by language, selectors with what they mean, choices. Each shows a value of the lesson's text and changes
//! it there.

use super::super::session::Session;
use super::super::{prose, style};
use super::Meanings;
use super::strings;
use crate::language::{Language, Message};
use crate::lesson::anchor::Meaning;
use crate::lesson::draft;
use crate::picture::Ink;
use crate::replay::Query;
use crate::scene::edit::Edit;
use egui::{Button, ComboBox, Response, RichText, TextEdit, Ui, WidgetInfo};
use serde_json::{Value, json};

/// A form over the text of a lesson.
pub struct Form<'a> {
    pub session: &'a Session,
    pub value: &'a Value,
    pub meanings: &'a mut Meanings,
    /// What was changed in this frame.
    pub edits: &'a mut Vec<Edit>,
}

/// Gives a text field its name.
pub fn named(response: &Response, name: &str, text: &str) {
    response.widget_info(|| WidgetInfo {
        label: Some(name.to_owned()),
        ..WidgetInfo::text_edit(true, "", text, "")
    });
}

/// The value at a path such as `steps[2].say`; empty for the whole.
pub fn at<'a>(value: &'a Value, place: &str) -> &'a Value {
    if place.is_empty() {
        return value;
    }
    let pointer = place.replace(['.', '['], "/").replace(']', "");
    value
        .pointer(&format!("/{pointer}"))
        .unwrap_or(&Value::Null)
}

/// The path of a key of the object at `parent`.
fn inside(parent: &str, key: &str) -> String {
    match parent {
        "" => key.to_owned(),
        _ => format!("{parent}.{key}"),
    }
}

impl<'a> Form<'a> {
    pub fn localize(&self, message: Message) -> &'static str {
        self.session.localize(message)
    }

    pub fn at(&self, place: &str) -> &'a Value {
        at(self.value, place)
    }

    pub fn words(&self, place: &str) -> String {
        self.at(place).as_str().unwrap_or_default().to_owned()
    }

    pub fn heading(&self, label: &str, ui: &mut Ui) -> Response {
        ui.label(style::strong(label, 13.0))
    }

    /// Gives a key a value, whether or not it has one; none takes the key away.
    pub fn set(&mut self, parent: &str, key: &str, value: Option<Value>) {
        let place = inside(parent, key);
        let edit = match (self.at(&place).is_null(), value) {
            (false, Some(value)) => Edit::Set(place, value),
            (false, None) => Edit::Remove(place),
            (true, Some(value)) => Edit::Insert(parent.to_owned(), key.to_owned(), value),
            (true, None) => return,
        };
        self.edits.push(edit);
    }

    /// A text in both languages, that of the window first.
    pub fn text(&mut self, label: Message, parent: &str, key: &str, rows: usize, ui: &mut Ui) {
        let name = self.localize(label);
        self.heading(name, ui);
        let place = inside(parent, key);
        let first = self.session.look.language;
        let others = Language::ALL.into_iter().filter(|&other| other != first);
        for language in std::iter::once(first).chain(others) {
            let code = language.code();
            let own = inside(&place, code);
            let mut words = self.words(&own);
            let shown = code.to_uppercase();
            let edit = match rows {
                1 => TextEdit::singleline(&mut words),
                _ => TextEdit::multiline(&mut words).desired_rows(rows),
            };
            let edit = edit.desired_width(f32::INFINITY).hint_text(&shown);
            let response = ui.add(edit.id_salt(&own));
            named(&response, &format!("{name}, {shown}"), &words);
            if response.changed() {
                self.write(parent, key, language, words);
            }
        }
    }

    /// Writes a text in one language. An empty one is none; a text in neither language is taken away where it need not be there.
    fn write(&mut self, parent: &str, key: &str, language: Language, words: String) {
        let place = inside(parent, key);
        let now = self.at(&place);
        let code = language.code();
        if now.is_null() {
            return self.set(parent, key, Some(draft::text(language, &words)));
        }
        let others = now.as_object().map_or(0, |members| members.len());
        let is_only = others == 1 && !now[code].is_null();
        let is_needed = matches!(key, "say" | "ask" | "why" | "summary" | "text")
            || parent.is_empty() && key == "title";
        match (words.is_empty(), is_only) {
            (false, _) => self.set(&place, code, Some(json!(words))),
            (true, false) => self.set(&place, code, None),
            // It is refused as long as it is empty.
            (true, true) if is_needed => self.set(&place, code, Some(json!(""))),
            (true, true) => self.set(parent, key, None),
        }
    }

    /// A short text that is no sentence.
    pub fn line(&mut self, label: Message, parent: &str, key: &str, ui: &mut Ui) {
        let place = inside(parent, key);
        let mut words = self.words(&place);
        let name = self.localize(label);
        ui.horizontal(|ui| {
            ui.label(RichText::new(name).size(13.0));
            let edit = TextEdit::singleline(&mut words).desired_width(f32::INFINITY);
            let response = ui.add(edit.id_salt(&place));
            named(&response, name, &words);
            if response.changed() {
                self.set(parent, key, Some(json!(words)));
            }
        });
    }

    /// A selector, with what it means behind the step before `from`.
    pub fn selector(&mut self, label: Message, parent: &str, key: &str, from: usize, ui: &mut Ui) {
        self.line(label, parent, key, ui);
        if let Ok(query) = self.words(&inside(parent, key)).parse::<Query>() {
            let meaning = self.meanings.of(self.session, &query, from);
            let ink = match meaning.step {
                Some(_) => Ink::Muted,
                None => Ink::Bad,
            };
            let words = in_words(meaning, self.session.look.language);
            ui.label(prose::prose(self.session, &words, 12.5, ink));
        }
    }

    /// One of several values, each with its name; none for a key that is not there.
    pub fn choice(
        &mut self,
        label: Message,
        parent: &str,
        key: &str,
        options: &[(Option<String>, String)],
        ui: &mut Ui,
    ) {
        let place = inside(parent, key);
        let now = self.at(&place).as_str().map(str::to_owned);
        let mut chosen = now.clone();
        let shown = options.iter().find(|(value, _)| *value == now);
        let shown = shown.map_or(now.clone().unwrap_or_default(), |(_, name)| name.clone());
        let name = self.localize(label);
        ui.horizontal(|ui| {
            ui.label(RichText::new(name).size(13.0));
            let list = ComboBox::from_id_salt(&place).selected_text(&shown);
            let response = list.show_ui(ui, |ui| {
                for (value, name) in options {
                    ui.selectable_value(&mut chosen, value.clone(), name);
                }
            });
            response.response.widget_info(|| WidgetInfo {
                current_text_value: Some(shown.clone()),
                ..WidgetInfo::labeled(egui::Role::ComboBox, true, name)
            });
        });
        if chosen != now {
            self.set(parent, key, chosen.map(Value::from));
        }
    }

    /// A button, off with the reason where there is one.
    pub fn button(&self, name: Message, refused: Option<&str>, ui: &mut Ui) -> bool {
        button(self.session, name, refused, ui)
    }
}

/// A button, off with the reason where there is one.
pub fn button(session: &Session, name: Message, refused: Option<&str>, ui: &mut Ui) -> bool {
    let name = session.localize(name);
    let response = ui.add_enabled(refused.is_none(), Button::new(name));
    match refused {
        Some(why) => {
            super::super::button::explain_disabled(response, why);
            false
        }
        None => response.clicked(),
    }
}

/// What a selector means.
pub fn in_words(meaning: Meaning, language: Language) -> String {
    let count = meaning.ahead.to_string();
    match meaning {
        Meaning { step: None, .. } => strings::MEANS_NONE.text(language).to_owned(),
        Meaning { steps: 1, .. } => strings::MEANS_ONE.text(language).to_owned(),
        Meaning { ahead: 1, .. } => strings::MEANS_LAST.text(language).to_owned(),
        _ => strings::MEANS_FIRST.format(language, &[("count", &count)]),
    }
}
