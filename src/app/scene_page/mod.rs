//! The scene page: what a scene has as a tree, controls for what is selected, its text beside them, and its picture.

mod controls;
mod document;
mod tree;

use super::button::explain_disabled;
use super::opened::Readers;
use super::panel_view::{PanelView, Scale};
use super::session::{Command, Session};
use super::{prose, strings, style};
use crate::language::Message;
use crate::panels::Panel;
use crate::picture::Ink;
pub(super) use document::Document;
use egui::text::{LayoutJob, TextFormat};
use egui::{Button, FontId, Rect, ScrollArea, Stroke, TextEdit, Ui, UiBuilder, WidgetInfo};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use web_time::{Duration, Instant};

/// How often it is looked whether someone else has changed the file.
const LOOK: Duration = Duration::from_millis(500);
const GAP: f32 = 12.0;
const TREE: f32 = 200.0;
const CONTROLS: f32 = 380.0;
/// Of the height, for the picture.
const PICTURE: f32 = 0.42;
const TEXT: f32 = 12.5;

/// The scenes that are edited, each with what is not saved yet.
#[derive(Default)]
pub struct ScenePage {
    documents: HashMap<PathBuf, Document>,
    looked: Option<Instant>,
    view: PanelView,
}

impl ScenePage {
    /// The document of a file, read when it is edited first. Errors: why it cannot be read.
    fn document(&mut self, path: &Path, readers: Readers) -> Result<&mut Document, String> {
        if !self.documents.contains_key(path) {
            let document = Document::open(path.to_owned(), readers)?;
            self.documents.insert(path.to_owned(), document);
        }
        let document = self.documents.get_mut(path);
        document.ok_or_else(String::new)
    }

    #[cfg(test)]
    pub(super) fn only(&mut self) -> &mut Document {
        self.documents.values_mut().next().expect("a document")
    }

    /// Takes the last change of the scene back, or makes it again.
    pub fn go_back(&mut self, session: &mut Session, again: bool) {
        let path = session.file.clone();
        let document = path.and_then(|path| self.documents.get_mut(&path));
        match document {
            Some(document) if again => document.redo(session),
            Some(document) => document.undo(session),
            None => {}
        }
    }

    /// Shows the page in the rest of the window. Errors: why the file cannot be read or written.
    pub fn show(
        &mut self,
        session: &mut Session,
        readers: Readers,
        commands: &mut Vec<Command>,
        ui: &mut Ui,
    ) -> Result<(), String> {
        let Some(path) = session.file.clone() else {
            return Ok(());
        };
        let is_due = self.looked.is_none_or(|when| when.elapsed() >= LOOK);
        let is_new = !self.documents.contains_key(&path);
        let document = self.document(&path, readers)?;
        if is_new {
            document.show(session);
        } else if is_due {
            document.look(session);
        }
        let whole = ui.available_rect_before_wrap();
        let ground = ui.visuals().panel_fill;
        ui.painter().rect_filled(whole, 0.0, ground);
        let whole = whole.shrink(GAP);
        let bar = Rect::from_min_size(whole.min, egui::vec2(whole.width(), 30.0));
        let told = ui
            .scope_builder(UiBuilder::new().max_rect(bar), |ui| {
                ui.horizontal_centered(|ui| head(session, document, &path, commands, ui))
                    .inner
            })
            .inner;
        let below = Rect::from_min_max(bar.left_bottom() + egui::vec2(0.0, 6.0), whole.max);
        let (left, rest) = below.split_left_right_at_x(below.left() + TREE);
        let (middle, right) = rest.split_left_right_at_x(rest.left() + CONTROLS);
        let mut edit = None;
        within(left.with_max_x(left.right() - GAP), ui, |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                edit = tree::show(session, document, ui);
            });
        });
        let middle = middle.with_max_x(middle.right() - GAP);
        let (top, bottom) = middle.split_top_bottom_at_y(middle.top() + PICTURE * middle.height());
        within(bottom.with_min_y(bottom.top() + 8.0), ui, |ui| {
            let id = document.selected.clone();
            ScrollArea::vertical()
                .id_salt(id)
                .auto_shrink(false)
                .show(ui, |ui| {
                    let changed = controls::show(session, &document.value, &document.selected, ui);
                    edit = changed.or(edit.take());
                });
        });
        let mut typed = None;
        within(right, ui, |ui| typed = text(session, document, ui));
        if let Some(edit) = edit {
            document.edit(&edit, session);
        } else if let Some(typed) = typed {
            document.write(typed, session);
        }
        self.view.show(session, Panel::Image, top, Scale::Small, ui);
        if is_due {
            self.looked = Some(Instant::now());
        }
        ui.ctx().request_repaint_after(LOOK);
        told
    }
}

fn within(rect: Rect, ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    let id = (rect.min.x as i32, rect.min.y as i32);
    let mut part = ui.new_child(UiBuilder::new().id_salt(id).max_rect(rect));
    part.set_clip_rect(rect);
    contents(&mut part);
}

/// The file, undo and redo, saving, and what to do where the file was changed by someone else.
fn head(
    session: &mut Session,
    document: &mut Document,
    path: &Path,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Result<(), String> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let star = if document.is_saved() { "" } else { " *" };
    ui.label(style::strong(format!("{name}{star}"), 16.0));
    ui.add_space(8.0);
    let action = |message: Message, refused: Option<Message>, session: &Session, ui: &mut Ui| {
        let name = session.localize(message);
        let response = ui.add_enabled(refused.is_none(), Button::new(name));
        match refused {
            Some(why) => {
                explain_disabled(response, session.localize(why));
                false
            }
            None => response.clicked(),
        }
    };
    let unless = |can: bool, why: Message| (!can).then_some(why);
    let nothing = unless(document.can_undo(), strings::NOTHING_TO_UNDO);
    if action(strings::UNDO, nothing, session, ui) {
        document.undo(session);
    }
    let nothing = unless(document.can_redo(), strings::NOTHING_TO_REDO);
    if action(strings::REDO, nothing, session, ui) {
        document.redo(session);
    }
    let mut told = Ok(());
    let nothing = unless(!document.is_saved(), strings::SCENE_IS_SAVED);
    let nothing = nothing.filter(|_| !document.in_conflict);
    if action(strings::SCENE_SAVE, nothing, session, ui) {
        told = document.save(false).map(drop);
    }
    if action(strings::SCENE_BACK, None, session, ui) {
        commands.push(Command::EditScene);
    }
    if document.in_conflict {
        let warn = style::color(session.look.theme, Ink::Warn);
        let said = session.localize(strings::SCENE_CONFLICT);
        ui.label(egui::RichText::new(said).color(warn));
        if action(strings::SCENE_TAKE_THEIRS, None, session, ui) {
            document.take_theirs(session);
        }
        if action(strings::SCENE_SAVE_MINE, None, session, ui) {
            told = document.save(true).map(drop);
        }
    }
    told
}

/// The text with its mistakes underlined, and what they are. Returns the text where it was changed.
fn text(session: &Session, document: &Document, ui: &mut Ui) -> Option<String> {
    let problems = document.in_words();
    let mut height = ui.available_height();
    if !problems.is_empty() {
        let wrong = prose::set(session, &problems, FontId::proportional(13.0), Ink::Bad);
        let said = ui.add(egui::Label::new(wrong).wrap());
        height -= said.rect.height() + 8.0;
    }
    let mut text = document.text().to_owned();
    let ink = style::color(session.look.theme, Ink::Text);
    let bad = style::color(session.look.theme, Ink::Bad);
    let places: Vec<[usize; 2]> = document
        .problems
        .iter()
        .filter_map(|problem| Some([problem.line?, problem.column?]))
        .collect();
    let mut layouter = |ui: &Ui, text: &dyn egui::TextBuffer, width: f32| {
        let mut job = LayoutJob::default();
        job.wrap.max_width = width;
        let plain = TextFormat::simple(FontId::monospace(TEXT), ink);
        let wrong = TextFormat {
            underline: Stroke::new(2.0, bad),
            ..plain.clone()
        };
        for (number, line) in text.as_str().split_inclusive('\n').enumerate() {
            let columns = places.iter().filter(|[at, _]| *at == number + 1);
            let columns = columns.map(|[_, column]| column - 1);
            let from = columns
                .min()
                .map_or(line.len(), |from| from.min(line.len()));
            let from = (0..=from)
                .rfind(|&at| line.is_char_boundary(at))
                .unwrap_or(0);
            job.append(&line[..from], 0.0, plain.clone());
            job.append(&line[from..], 0.0, wrong.clone());
        }
        ui.fonts_mut(|fonts| fonts.layout_job(job))
    };
    ScrollArea::vertical()
        .id_salt("text")
        .max_height(height)
        .auto_shrink(false)
        .show(ui, |ui| {
            let edit = TextEdit::multiline(&mut text)
                .code_editor()
                .desired_width(f32::INFINITY)
                .desired_rows((height / 16.0) as usize)
                .layouter(&mut layouter);
            let response = ui.add(edit);
            let name = session.localize(strings::SCENE_TEXT);
            response.widget_info(|| WidgetInfo {
                label: Some(name.to_owned()),
                ..WidgetInfo::text_edit(true, "", document.text(), "")
            });
        });
    (text != document.text()).then_some(text)
}
