//! The scene page: what a scene has as a tree, controls for what is selected, its text beside them, and its picture.

mod controls;
mod tree;

use super::document::{Document, Documents, LOOK};
use super::document_bar;
use super::opened::Readers;
use super::panel_view::{PanelView, Scale};
use super::session::{Command, Session};
use super::{prose, strings, style};
use crate::panels::Panel;
use crate::picture::Ink;
use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Rect, ScrollArea, Stroke, TextEdit, Ui, UiBuilder, WidgetInfo};

const GAP: f32 = 12.0;
const TREE: f32 = 200.0;
const CONTROLS: f32 = 380.0;
/// Of the height, for the picture.
const PICTURE: f32 = 0.42;
const TEXT: f32 = 12.5;

#[derive(Default)]
pub struct ScenePage {
    pub documents: Documents,
    view: PanelView,
}

impl ScenePage {
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
        if !self.documents.has(&path) {
            let mut document = Document::open(path.clone(), readers, readers.scene)?;
            document.selected = "camera".into();
            self.documents.insert(document);
        }
        let Some(document) = self.documents.show(&path, session) else {
            return Ok(());
        };
        let whole = ui.available_rect_before_wrap();
        let ground = ui.visuals().panel_fill;
        ui.painter().rect_filled(whole, 0.0, ground);
        let whole = whole.shrink(GAP);
        let bar = Rect::from_min_size(whole.min, egui::vec2(whole.width(), 30.0));
        let outcome = ui
            .scope_builder(UiBuilder::new().max_rect(bar), |ui| {
                ui.horizontal_centered(|ui| {
                    let outcome = document_bar::show(session, document, ui);
                    if ui.button(session.localize(strings::SCENE_BACK)).clicked() {
                        commands.push(Command::EditScene);
                    }
                    outcome
                })
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
            document.edit(&[edit], session);
        } else if let Some(typed) = typed {
            document.write(typed, session);
        }
        self.view.show(session, Panel::Image, top, Scale::Small, ui);
        ui.ctx().request_repaint_after(LOOK);
        outcome
    }
}

fn within(rect: Rect, ui: &mut Ui, contents: impl FnOnce(&mut Ui)) {
    let id = (rect.min.x as i32, rect.min.y as i32);
    let mut part = ui.new_child(UiBuilder::new().id_salt(id).max_rect(rect));
    part.set_clip_rect(rect);
    contents(&mut part);
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
