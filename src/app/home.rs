//! The page of all lessons: by chapters, with search, and with the way back to where one was.

use super::button::button;
use super::lesson_card;
use super::session::{Choice, Command, Listed, Session, StudyCommand, listed};
use super::thumbnails::Thumbnails;
use super::{strings, style};
use crate::lesson::Chapter;
use crate::picture::Ink;
use egui::{Button, Frame, Key, Margin, Rect, RichText, ScrollArea, TextEdit, Ui};

/// Between cards.
const GAP: f32 = 12.0;
/// A card is at least this wide, and a row has at most so many.
const CARD: f32 = 205.0;
const COLUMNS: usize = 6;

/// What the page keeps from frame to frame.
#[derive(Default)]
pub struct HomePage {
    search: String,
    thumbnails: Thumbnails,
    was_open: bool,
}

impl HomePage {
    /// What is to be done while another page is shown.
    pub fn close(&mut self) {
        self.thumbnails.pause();
        self.was_open = false;
    }
}

pub fn show(
    session: &mut Session,
    page: &mut HomePage,
    notice: Option<&str>,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    page.thumbnails.bring_on(session, ui.ctx());
    let margin = Margin::symmetric(18, 0);
    let frame = Frame::new().inner_margin(margin);
    egui::CentralPanel::no_frame().frame(frame).show(ui, |ui| {
        ui.add_space(14.0);
        let language = session.look.language;
        let is_found = head(session, page, commands, ui);
        if let Some(notice) = notice {
            let warn = style::color(session.look.theme, Ink::Warn);
            ui.label(RichText::new(notice).color(warn));
        }
        ui.add_space(4.0);
        let opened = !std::mem::replace(&mut page.was_open, true);
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            let found = |listed: &&Listed| listed.says(&page.search, language);
            if let Some((name, own)) = session.own_lessons() {
                let lessons: Vec<&Listed> = own.iter().filter(found).collect();
                if !lessons.is_empty() {
                    heading(session, None, name, commands, ui);
                    cards(session, page, &lessons, opened, commands, ui);
                }
            }
            own_scenes(session, &page.search, commands, ui);
            for (chapter, title) in strings::CHAPTERS {
                let lessons = listed().iter().filter(found);
                let lessons = lessons.filter(|listed| listed.chapter == Some(chapter));
                let lessons: Vec<&Listed> = lessons.collect();
                if !lessons.is_empty() {
                    let title = title.text(language);
                    heading(session, Some(chapter), title, commands, ui);
                    cards(session, page, &lessons, opened, commands, ui);
                }
            }
            if !is_found {
                ui.label(session.localize(strings::NO_LESSON_FOUND));
            }
            ui.add_space(GAP);
        });
    });
}

/// The way back to the lesson, and the search; returns whether a lesson is found.
fn head(
    session: &mut Session,
    page: &mut HomePage,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> bool {
    if style::is_for_fingers(ui.ctx()) {
        resume(session, ui.available_width(), commands, ui);
        open(session, commands, ui);
        return search(session, page, ui.available_width(), commands, ui);
    }
    let (search_width, open_width) = (220.0, 130.0);
    let row = ui.horizontal(|ui| {
        let room = ui.available_width() - search_width - open_width - 30.0;
        resume(session, room.max(100.0), commands, ui);
        let layout = egui::Layout::right_to_left(egui::Align::Center);
        ui.with_layout(layout, |ui| {
            let is_found = search(session, page, search_width, commands, ui);
            open(session, commands, ui);
            is_found
        })
    });
    row.inner.inner
}

/// The way back to the lesson that was open.
fn resume(session: &Session, width: f32, commands: &mut Vec<Command>, ui: &mut Ui) {
    let theme = session.look.theme;
    let title = session.title();
    let begun = session.progress_in(&session.lesson().id).is_some();
    let message = if begun {
        strings::CONTINUE
    } else {
        strings::BEGIN
    };
    let text = message.format(session.look.language, &[("title", &title)]);
    let shown = style::strong(&text, 14.0).color(style::color(theme, Ink::Surface));
    let resume = Button::new(shown)
        .fill(style::color(theme, Ink::Linked))
        .truncate();
    ui.scope(|ui| {
        ui.set_max_width(width);
        button(session, resume, &text, Command::Home, commands, ui);
    });
}

/// A file of one's own.
fn open(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let name = session.localize(strings::OPEN_FILE);
    let choose = Command::Choose(Choice::File);
    button(session, Button::new(name), name, choose, commands, ui);
}

/// The search; returns whether a lesson is found.
fn search(
    session: &mut Session,
    page: &mut HomePage,
    width: f32,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> bool {
    let language = session.look.language;
    let name = session.localize(strings::SEARCH_LESSONS);
    let edit = TextEdit::singleline(&mut page.search)
        .desired_width(width)
        .align(egui::Align2::LEFT_CENTER)
        .hint_text(format!("/ {name}"));
    let response = ui.add(edit);
    let text = page.search.clone();
    response.widget_info(|| egui::WidgetInfo {
        label: Some(name.to_owned()),
        ..egui::WidgetInfo::text_edit(true, "", &text, "")
    });
    if std::mem::take(&mut session.search_wanted) {
        response.request_focus();
    }
    let mut found = session.all_lessons();
    let found = found.find(|listed| listed.says(&page.search, language));
    let is_found = found.is_some();
    let entered = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    if let Some(first) = found.filter(|_| entered && !text.trim().is_empty()) {
        commands.push(Command::Open(first.id.clone()));
    }
    is_found
}

fn heading(
    session: &Session,
    chapter: Option<Chapter>,
    title: &str,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    ui.add_space(10.0);
    ui.horizontal(|ui| {
        ui.label(style::strong(title, 17.0));
        if chapter == Some(Chapter::Study) {
            let name = session.localize(strings::STUDIES);
            let view = Command::Study(StudyCommand::View);
            let link = Button::new(RichText::new(name));
            button(session, link, name, view, commands, ui);
        }
    });
    ui.add_space(6.0);
}

/// The scenes of one's own that were walked through, where there are some.
fn own_scenes(session: &Session, search: &str, commands: &mut Vec<Command>, ui: &mut Ui) {
    let search = search.to_lowercase();
    let found = |name: &&str| name.to_lowercase().contains(search.trim());
    let names: Vec<&str> = session.own_scenes().filter(found).collect();
    if names.is_empty() {
        return;
    }
    heading(
        session,
        None,
        session.localize(strings::OWN_SCENES),
        commands,
        ui,
    );
    ui.horizontal_wrapped(|ui| {
        for name in names {
            let open = Command::OpenOwn(name.to_owned());
            button(session, Button::new(name), name, open, commands, ui);
            let forget = Command::ForgetOwn(name.to_owned());
            let said = strings::FORGET_SCENE.format(session.look.language, &[("name", name)]);
            button(session, Button::new("×"), &said, forget, commands, ui);
            ui.add_space(8.0);
        }
    });
}

/// The cards of a chapter, in rows. When the page is opened, the keyboard goes to the lesson that was open.
fn cards(
    session: &Session,
    page: &HomePage,
    lessons: &[&Listed],
    opened: bool,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    // The scroll bar lies over the right edge.
    let room = ui.available_width() - 8.0;
    let columns = (((room + GAP) / (CARD + GAP)) as usize).clamp(1, COLUMNS);
    let width = ((room + GAP) / columns as f32 - GAP).floor();
    let size = egui::vec2(width, lesson_card::height(width));
    for row in lessons.chunks(columns) {
        let (_, place) = ui.allocate_space(egui::vec2(room, size.y));
        for (column, listed) in row.iter().enumerate() {
            let corner = place.min + egui::vec2(column as f32 * (width + GAP), 0.0);
            let card = Rect::from_min_size(corner, size);
            let thumbnail = page.thumbnails.of(&listed.id);
            let response = lesson_card::show(session, listed, thumbnail, card, ui);
            if opened && listed.id == session.lesson().id {
                response.request_focus();
                response.scroll_to_me(None);
            }
            if response.gained_focus() {
                response.scroll_to_me(None);
            }
            if response.clicked() {
                commands.push(Command::Open(listed.id.clone()));
            }
        }
        ui.add_space(GAP - ui.spacing().item_spacing.y);
    }
}
