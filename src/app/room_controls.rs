//! What a room lets be chosen: smooth or patch by patch, its light or what is unshot, and the form factor of two patches.

use super::button::button;
use super::session::{Command, Session};
use super::strings;
use egui::{Button, RichText, Ui};

/// Smooth, and unshot.
pub fn switches(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    for (text, name, is_on, command) in [
        (
            strings::SMOOTH,
            strings::SMOOTH_ROOM,
            session.look.smooth,
            Command::Smooth,
        ),
        (
            strings::UNSHOT,
            strings::UNSHOT_ROOM,
            session.look.unshot,
            Command::Unshot,
        ),
    ] {
        let text = RichText::new(session.localize(text)).size(13.0);
        let switch = Button::new(text).selected(is_on);
        button(
            session,
            switch,
            session.localize(name),
            command,
            commands,
            ui,
        );
    }
}

/// To the steps that find the form factor between the two patches that are selected.
pub fn step_by_step(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let (Some(command), Some([i, j])) = (session.step_by_step(), session.pair()) else {
        return;
    };
    let text = RichText::new(session.localize(strings::STEP_BY_STEP)).size(13.0);
    let [i, j] = [i, j].map(|patch| patch.to_string());
    let name = strings::FORM_FACTOR_BY_STEPS.format(session.look.language, &[("i", &i), ("j", &j)]);
    button(session, Button::new(text), &name, command, commands, ui);
}
