//! The outline: the lesson's explanations in their order, how their questions stand, and the way to each.

use super::button::button;
use super::prose::set;
use super::session::{Command, Entry, Session, Sheet, Standing};
use super::{strings, style};
use crate::language::Message;
use crate::picture::{Ink, plain};
use egui::{
    Align, Align2, Button, FontFamily, FontId, Id, LayerId, Layout, Modal, Order, Response,
    ScrollArea, Ui, vec2,
};

/// Of the drawer.
const WIDTH: f32 = 380.0;

pub fn show(session: &Session, commands: &mut Vec<Command>, ctx: &egui::Context) {
    let id = Id::unique("outline");
    let area = Modal::default_area(id).anchor(Align2::LEFT_TOP, vec2(10.0, 10.0));
    let frame = style::card_frame(session.look.theme);
    let close = Command::Sheet(Sheet::Outline);
    let layer = LayerId::new(Order::Foreground, id);
    let opens = !ctx.memory(|memory| memory.areas().visible_last_frame(&layer));
    let modal = Modal::new(id).area(area).frame(frame).show(ctx, |ui| {
        let room = ctx.content_rect().size();
        ui.set_width(WIDTH.min(room.x - 60.0));
        ui.horizontal(|ui| {
            ui.label(style::strong(session.title(), 16.0));
        });
        ui.separator();
        let height = room.y - 140.0;
        ScrollArea::vertical()
            .min_scrolled_height(height)
            .max_height(height)
            .show(ui, |ui| list(session, opens, commands, ui));
        ui.separator();
        ui.horizontal(|ui| {
            for (name, command) in [
                (strings::START_AGAIN, Command::Reset),
                (strings::CLOSE, close.clone()),
            ] {
                let name = session.localize(name);
                button(session, Button::new(name), name, command, commands, ui);
            }
        });
    });
    if modal.should_close() && commands.is_empty() {
        commands.push(close);
    }
}

/// The lines; as the outline opens, the keyboard goes to the one where one is.
fn list(session: &Session, opens: bool, commands: &mut Vec<Command>, ui: &mut Ui) {
    let entries = session.outline();
    if entries.is_empty() {
        ui.label(session.localize(strings::UNSAID));
    }
    let at = session.explanation();
    for (index, entry) in entries.iter().enumerate() {
        let mut chosen = Vec::new();
        let current = at == Some(index);
        let response = line(session, index, entry, current, &mut chosen, ui);
        if opens && current {
            response.request_focus();
            response.scroll_to_me(Some(Align::Center));
        }
        if let Some(go) = chosen.pop() {
            commands.push(Command::Sheet(Sheet::Outline));
            if !session.follows_lesson() {
                commands.push(Command::Focus(session.lesson().focus));
            }
            commands.push(go);
        }
    }
}

/// One explanation: a mark of its question, its number and its title.
pub(super) fn line(
    session: &Session,
    index: usize,
    entry: &Entry,
    current: bool,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Response {
    let number = (index + 1).to_string();
    let title = entry.title.as_deref().unwrap_or("…");
    let (mark, standing, ink) = mark(entry.standing);
    let language = session.look.language;
    let plain_title = plain(title);
    let words = [("number", number.as_str()), ("title", &plain_title)];
    let name = match standing.map(|standing| standing.text(language)) {
        Some(stands) => {
            let [number, title] = words;
            strings::ENTRY_ASKS.format(language, &[number, title, ("stands", stands)])
        }
        None => strings::ENTRY.format(language, &words),
    };
    ui.horizontal(|ui| {
        let (_, place) = ui.allocate_space(vec2(14.0, 14.0));
        let color = style::color(session.look.theme, ink);
        let font = FontId::new(14.0, style::bold());
        let middle = Align2::CENTER_CENTER;
        ui.painter().text(place.center(), middle, mark, font, color);
        let (family, ink) = match current {
            true => (style::bold(), Ink::This),
            false => (FontFamily::Proportional, Ink::Text),
        };
        let font = FontId::new(14.0, family);
        let words = set(session, &format!("{number}  {title}"), font, ink);
        let wide = Button::new(words)
            .truncate()
            .right_text("")
            .selected(current);
        let go = Command::Seek(entry.step);
        let as_wide_as_the_row = Layout::top_down_justified(Align::Min);
        ui.with_layout(as_wide_as_the_row, |ui| {
            button(session, wide, &name, go, commands, ui)
        })
        .inner
    })
    .inner
}

/// How a question stands, as a sign and in words.
fn mark(standing: Option<Standing>) -> (&'static str, Option<Message>, Ink) {
    match standing {
        None => ("", None, Ink::Muted),
        Some(Standing::Open) => ("?", Some(strings::NOT_ANSWERED), Ink::Linked),
        Some(Standing::Right) => ("✓", Some(strings::RIGHT), Ink::Good),
        Some(Standing::Wrong) => ("✗", Some(strings::WRONG), Ink::Warn),
        Some(Standing::Skipped) => ("–", Some(strings::SKIPPED), Ink::Muted),
    }
}
