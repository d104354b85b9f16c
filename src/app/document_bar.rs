//! What stands over a file that is edited: its name, undo and redo, saving, and what to do where someone else has changed the file.

use super::button::explain_disabled;
use super::document::Document;
use super::session::Session;
use super::{strings, style};
use crate::language::Message;
use crate::picture::Ink;
use egui::{Button, Ui};

/// Errors: why it cannot be written.
pub fn show(session: &mut Session, document: &mut Document, ui: &mut Ui) -> Result<(), String> {
    let name = document.path().file_name().unwrap_or_default();
    let name = name.to_string_lossy();
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
    let mut outcome = Ok(());
    let nothing = unless(!document.is_saved(), strings::SCENE_IS_SAVED);
    let nothing = nothing.filter(|_| !document.in_conflict);
    if action(strings::SCENE_SAVE, nothing, session, ui) {
        outcome = document.save(false).map(drop);
    }
    if document.in_conflict {
        let warn = style::color(session.look.theme, Ink::Warn);
        let said = session.localize(strings::SCENE_CONFLICT);
        ui.label(egui::RichText::new(said).color(warn));
        if action(strings::SCENE_TAKE_THEIRS, None, session, ui) {
            document.take_theirs(session);
        }
        if action(strings::SCENE_SAVE_MINE, None, session, ui) {
            outcome = document.save(true).map(drop);
        }
    }
    outcome
}
