//! A button for each option; a wrong one that was chosen is struck out.

use crate::app::button::{explain_disabled, for_finger};
use crate::app::prose::prose;
use crate::app::session::{Command, Session};
use crate::app::{strings, style};
use crate::lesson::Guess;
use crate::picture::Ink;
use egui::{Button, Stroke, Ui};

pub(super) fn ask(
    session: &Session,
    options: &[[String; 2]],
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    for (index, option) in options.iter().enumerate() {
        let guess = Guess::Choice(index);
        let was_chosen = session.guesses().contains(&guess);
        let ink = if was_chosen { Ink::Muted } else { Ink::Text };
        let mut text = prose(session, &option[session.look.language as usize], 13.0, ink);
        if was_chosen {
            let line = Stroke::new(1.5, style::color(session.look.theme, Ink::Bad));
            let sections = text.sections.iter_mut();
            sections.for_each(|section| section.format.strikethrough = line);
        }
        let button = for_finger(Button::new(text).wrap(), ui);
        let button = ui.add_enabled(!was_chosen, button);
        if was_chosen {
            explain_disabled(button, session.localize(strings::ALREADY_TRIED));
        } else if button.clicked() {
            commands.push(Command::Answer(guess));
        }
    }
}
