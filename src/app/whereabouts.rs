//! The row over the narration: which explanation of how many this is, the way back to the beginning, and the ways to its neighbours.

use super::button::button;
use super::session::{Command, Session, Sheet};
use super::{strings, style};
use egui::{Button, RichText, Ui};

/// The least room for the words and the button that goes on.
const WORDS: f32 = 262.0;

pub fn show(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let place = place(session);
    // A walk through a scene has one explanation, and no end.
    let narrates =
        session.follows_lesson() && !session.is_silent() && !session.lesson().is_free_walk();
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = egui::vec2(4.0, 4.0);
        ui.spacing_mut().button_padding.x = 7.0;
        let small = |text: &str| Button::new(RichText::new(text).size(12.0));
        let again = session.localize(strings::START_AGAIN);
        button(session, small("↺"), again, Command::Reset, commands, ui);
        if narrates {
            let previous = session.localize(strings::PREVIOUS_SAID);
            let back = Command::PreviousNarrated;
            button(session, small("◀"), previous, back, commands, ui);
        }
        let name = strings::OUTLINE_AT.format(session.look.language, &[("place", &place)]);
        let open = Command::Sheet(Sheet::Outline);
        // In a narrow column the numbers alone; the name that is spoken says what they count.
        let numbers = session
            .explanation()
            .filter(|_| ui.available_width() < WORDS);
        let shown = match numbers {
            Some(index) => format!("{} / {}", index + 1, session.explanations()),
            None => place,
        };
        let outline = Button::new(style::strong(shown, 12.0));
        button(session, outline, &name, open, commands, ui);
        if narrates {
            let last = session.is_last_explanation();
            let name = match last {
                true => session.localize(strings::FINISH),
                false => session.localize(strings::NEXT_SAID),
            };
            let shown = if last { name } else { "▶" };
            let next = Command::NextNarrated;
            button(session, small(shown), name, next, commands, ui);
        }
    });
}

/// Which explanation of how many, in words; between two, the one before.
fn place(session: &Session) -> String {
    let language = session.look.language;
    let count = session.explanations().to_string();
    match session.explanation() {
        Some(index) => {
            let number = (index + 1).to_string();
            let words = [("number", number.as_str()), ("count", &count)];
            strings::EXPLANATION_OF.format(language, &words)
        }
        None if count == "0" => session.localize(strings::OUTLINE).to_owned(),
        None => strings::EXPLANATIONS.format(language, &[("count", &count)]),
    }
}
