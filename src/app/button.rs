//! Buttons that give commands.

use super::layout::TARGET;
use super::session::{Command, Session};
use super::{keys, style};
use crate::language::Message;
use egui::{Button, Response, Ui, Vec2};

/// Has what is disabled say why: under the pointer, and to a screen reader.
pub(super) fn explain_disabled(response: Response, why: &str) -> Response {
    let node = response.id;
    response
        .ctx
        .accesskit_node_builder(node, |node| node.set_description(why));
    response.on_disabled_hover_text(why)
}

/// A button for a command: disabled, with the reason, where it cannot act; its hint names its key.
pub(super) fn button(
    session: &Session,
    button: Button,
    name: &str,
    command: Command,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Response {
    let allowed = session.allows(&command);
    let button = for_finger(button, ui);
    let response = ui.add_enabled(allowed.is_ok(), button);
    let enabled = allowed.is_ok();
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, enabled, name));
    let hint =
        keys::key_of(&command).map_or_else(|| name.to_owned(), |key| format!("{name}  ({key})"));
    let response = response.on_hover_text(hint);
    if let Err(refused) = allowed {
        return explain_disabled(response, refused.in_language(session.look.language));
    }
    if response.clicked() {
        commands.push(command);
    }
    response
}

/// The button, as large as a finger needs it where the window is laid out for fingers.
pub(super) fn for_finger<'a>(button: Button<'a>, ui: &Ui) -> Button<'a> {
    match style::is_for_fingers(ui.ctx()) {
        true => button.min_size(Vec2::splat(TARGET)),
        false => button,
    }
}

/// A link in running text; for fingers, a button. Returns whether it was chosen.
pub(super) fn link(text: impl Into<String>, ui: &mut Ui) -> bool {
    let text = text.into();
    match style::is_for_fingers(ui.ctx()) {
        true => ui.button(text).clicked(),
        false => ui.link(text).clicked(),
    }
}

/// A small button with a sign, for the head of a card.
pub(super) fn sign(
    session: &Session,
    sign: &str,
    name: Message,
    command: Command,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Response {
    let text = egui::RichText::new(sign).size(13.0);
    let small = Button::new(text).min_size(egui::vec2(24.0, 22.0));
    let name = session.localize(name);
    button(session, small, name, command, commands, ui)
}
