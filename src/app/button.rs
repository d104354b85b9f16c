//! Buttons that give commands.

use super::keys;
use super::session::{Command, Session};
use egui::{Response, Ui};

/// Has what is off say why: under the pointer, and to a screen reader.
pub(super) fn off(response: Response, why: &str) -> Response {
    let node = response.id;
    response
        .ctx
        .accesskit_node_builder(node, |node| node.set_description(why));
    response.on_disabled_hover_text(why)
}

/// A button for a command: off, with the reason, where it cannot act; its hint names its key.
pub(super) fn button(
    session: &Session,
    button: egui::Button,
    name: &str,
    command: Command,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Response {
    let allowed = session.allows(&command);
    let response = ui.add_enabled(allowed.is_ok(), button);
    let enabled = allowed.is_ok();
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, enabled, name));
    let hint =
        keys::key_of(&command).map_or_else(|| name.to_owned(), |key| format!("{name}  ({key})"));
    let response = response.on_hover_text(hint);
    if let Err(refused) = allowed {
        return off(response, refused.in_language(session.look.language));
    }
    if response.clicked() {
        commands.push(command);
    }
    response
}
