//! The drawer in which a lecturer writes a lesson while walking through it: its explanations in a list, what the one that is chosen
//! says and asks, and the lesson as a whole. All of it changes the text of the lesson's file.

mod begin;
mod explanation;
mod form;
mod list;
mod question;
mod whole;

use super::author_strings as strings;
use super::document::{Document, Documents, LOOK};
use super::document_bar;
use super::layout::MARGIN;
use super::opened::Readers;
use super::prose;
use super::session::Session;
use crate::lesson::anchor::Meaning;
use crate::picture::Ink;
use crate::replay::Query;
use crate::scene::document::one_a_line;
use begin::Begin;
use egui::{Label, Rect, ScrollArea, Ui, UiBuilder};
use form::Form;

/// Of the height, at most, for the list of explanations.
const LIST: f32 = 0.34;

/// What the drawer keeps from frame to frame.
#[derive(Default)]
pub struct Author {
    pub documents: Documents,
    /// What a lesson that begins is to be called.
    begin: Begin,
    /// What selectors were found to mean.
    meanings: Meanings,
}

impl Author {
    /// Shows the drawer in `rect`. Errors: why a file cannot be read or written, or a change cannot be made.
    pub fn show(
        &mut self,
        session: &mut Session,
        readers: Readers,
        rect: Rect,
        ui: &mut Ui,
    ) -> Result<(), String> {
        let place = rect.shrink2(egui::vec2(MARGIN, 2.0));
        let mut ui = ui.new_child(UiBuilder::new().max_rect(place));
        ui.set_clip_rect(rect);
        ui.ctx().request_repaint_after(LOOK);
        let own = session.file.clone();
        let own = own.filter(|_| !session.lesson().is_free_walk());
        let Some(path) = own else {
            let unsaved = self.documents.unsaved();
            let on = go_on(session, &unsaved, &mut ui);
            let begun = self.begin.show(session, readers, &unsaved, &mut ui)?;
            if let Some(document) = on.or(begun.as_ref()) {
                // What is wrong with its text is shown once it is written on.
                let (path, right) = (document.path().to_owned(), document.right());
                let lesson = (readers.lesson)(&path, right.as_bytes());
                let lesson = lesson.map_err(|problems| one_a_line(&problems))?;
                session.open_to_write(lesson, path)?;
            }
            if let Some(document) = begun {
                self.documents.insert(document);
                self.begin = Begin::default();
            }
            return Ok(());
        };
        if !self.documents.has(&path) {
            let document = Document::open(path.clone(), readers, readers.lesson)?;
            self.documents.insert(document);
        }
        let meanings = &mut self.meanings;
        match self.documents.show(&path, session) {
            Some(document) => write(session, document, meanings, &mut ui),
            None => Ok(()),
        }
    }
}

/// The way back to lessons that are not saved; returns the one that is to be written on.
fn go_on<'a>(session: &Session, unsaved: &[&'a Document], ui: &mut Ui) -> Option<&'a Document> {
    let mut on = None;
    for &document in unsaved {
        let file = document.path().file_name().unwrap_or_default();
        let file = file.to_string_lossy();
        let name = strings::GO_ON.format(session.look.language, &[("file", &file)]);
        if ui.button(name).clicked() {
            on = Some(document);
        }
    }
    on
}

/// The lesson that is written: its file, what is wrong with it or missing, its explanations, and the form of what is chosen.
fn write(
    session: &mut Session,
    document: &mut Document,
    meanings: &mut Meanings,
    ui: &mut Ui,
) -> Result<(), String> {
    ui.spacing_mut().item_spacing.y = 5.0;
    let mut outcome = ui
        .horizontal_wrapped(|ui| document_bar::show(session, document, ui))
        .inner;
    state(session, document, ui);
    ui.separator();
    let height = LIST * ui.available_height();
    let done = list::show(session, document, meanings, height, ui);
    if outcome.is_ok() {
        outcome = done;
    }
    ui.separator();
    let selected = list::selected(document);
    let mut edits = Vec::new();
    ScrollArea::vertical()
        .id_salt(&document.selected)
        .auto_shrink(false)
        .show(ui, |ui| {
            let mut form = Form {
                session,
                value: &document.value,
                meanings,
                edits: &mut edits,
            };
            match selected {
                Some(index) => explanation::show(&mut form, index, ui),
                None => whole::show(&mut form, ui),
            }
        });
    if !edits.is_empty() {
        document.edit(&edits, session);
    }
    outcome
}

/// What is wrong with the text, or else what is missing.
fn state(session: &Session, document: &Document, ui: &mut Ui) {
    let (words, ink) = match document.problems.is_empty() {
        false => (document.in_words(), Ink::Bad),
        true => {
            let missing = &session.lesson().missing;
            let count = missing.len().to_string();
            let language = session.look.language;
            let words = match missing[..] {
                [] => return,
                [ref one] if one.place == "steps" => strings::ONE_LANGUAGE.text(language).into(),
                _ => strings::MISSING.format(language, &[("count", &count)]),
            };
            (words, Ink::Muted)
        }
    };
    let font = egui::FontId::proportional(12.5);
    let set = prose::set(session, &words, font, ink);
    let response = ui.add(Label::new(set).wrap());
    if document.problems.is_empty() {
        let notes = session.lesson().missing.iter();
        let places: Vec<&str> = notes.map(|note| note.place.as_str()).collect();
        response.on_hover_text(places.join("\n"));
    }
}

/// What selectors mean in a run, found once: it takes a look at every step.
#[derive(Default)]
struct Meanings {
    recording: u64,
    found: Vec<((String, usize), Meaning)>,
    proposed: Option<(usize, Query)>,
}

impl Meanings {
    /// What a selector means that may mean the step `from` and those behind it.
    fn of(&mut self, session: &Session, query: &Query, from: usize) -> Meaning {
        self.renew(session);
        let key = (query.to_string(), from);
        if let Some((_, meaning)) = self.found.iter().find(|(known, _)| *known == key) {
            return *meaning;
        }
        let meaning = Meaning::of(session.walk(), query, from);
        self.found.push((key, meaning));
        meaning
    }

    /// A selector for the step that is shown.
    fn proposed(&mut self, session: &Session) -> Query {
        self.renew(session);
        let step = session.step();
        match &self.proposed {
            Some((known, query)) if *known == step => query.clone(),
            _ => {
                let query = crate::lesson::anchor::selector(session.walk(), step);
                self.proposed = Some((step, query.clone()));
                query
            }
        }
    }

    fn renew(&mut self, session: &Session) {
        if self.recording != session.recording() {
            *self = Meanings {
                recording: session.recording(),
                ..Meanings::default()
            };
        }
    }
}
