//! The keys: one table, which `pressed` obeys and the sheet of keys prints.

use super::binding::With::{Ctrl, Nothing, Shift, Sign};
use super::binding::{Binding, bind};
use super::session::{Command, Sheet, StudyCommand};
use egui::Key;

pub const BINDINGS: &[Binding] = &[
    bind(
        Key::ArrowRight,
        Nothing,
        "→",
        || Command::Forward(1),
        "keys-next-event",
    ),
    bind(
        Key::ArrowLeft,
        Nothing,
        "←",
        || Command::Back(1),
        "keys-event-before",
    ),
    bind(
        Key::ArrowRight,
        Shift,
        "Shift →",
        || Command::Forward(10),
        "keys-ten-events-on",
    ),
    bind(
        Key::ArrowLeft,
        Shift,
        "Shift ←",
        || Command::Back(10),
        "keys-ten-events-back",
    ),
    bind(
        Key::ArrowRight,
        Ctrl,
        "Ctrl →",
        || Command::NextScope,
        "keys-next-scope",
    ),
    bind(
        Key::ArrowLeft,
        Ctrl,
        "Ctrl ←",
        || Command::PreviousScope,
        "keys-previous-scope",
    ),
    bind(
        Key::ArrowDown,
        Nothing,
        "↓",
        || Command::Into,
        "keys-into-the-scope",
    ),
    bind(
        Key::ArrowUp,
        Nothing,
        "↑",
        || Command::Out,
        "keys-out-of-the-scope",
    ),
    bind(
        Key::ArrowDown,
        Ctrl,
        "Ctrl ↓",
        || Command::Over,
        "keys-over-the-scope",
    ),
    bind(
        Key::Home,
        Nothing,
        "Home",
        || Command::Start,
        "keys-first-step",
    ),
    bind(Key::End, Nothing, "End", || Command::End, "keys-last-step"),
    bind(
        Key::N,
        Nothing,
        "n",
        || Command::NextNarrated,
        "keys-next-explained-step",
    ),
    bind(
        Key::N,
        Shift,
        "Shift n",
        || Command::PreviousNarrated,
        "keys-explained-step-before",
    ),
    bind(
        Key::PageDown,
        Nothing,
        "PageDown",
        || Command::NextNarrated,
        "keys-next-explained-step",
    ),
    bind(
        Key::PageUp,
        Nothing,
        "PageUp",
        || Command::PreviousNarrated,
        "keys-explained-step-before",
    ),
    bind(
        Key::Space,
        Nothing,
        "Space",
        || Command::Play,
        "keys-play-or-pause",
    ),
    bind(
        Key::Space,
        Shift,
        "Shift Space",
        || Command::PlayBackwards,
        "keys-play-backwards",
    ),
    bind(Key::Comma, Sign, ",", || Command::Slower, "keys-slower"),
    bind(Key::Period, Sign, ".", || Command::Faster, "keys-faster"),
    bind(
        Key::OpenBracket,
        Sign,
        "[",
        || Command::LoopFrom,
        "keys-loop-from-this-step",
    ),
    bind(
        Key::CloseBracket,
        Sign,
        "]",
        || Command::LoopTo,
        "keys-loop-to-this-step",
    ),
    bind(
        Key::B,
        Nothing,
        "b",
        || Command::Breakpoint,
        "keys-breakpoint-here",
    ),
    bind(Key::Slash, Sign, "/", || Command::Search, "app-search"),
    bind(
        Key::F,
        Nothing,
        "f",
        || Command::FocusOnPointer,
        "keys-look-at-what-the-pointer",
    ),
    bind(Key::H, Nothing, "h", || Command::Home, "keys-all-lessons"),
    bind(
        Key::O,
        Nothing,
        "o",
        || Command::Sheet(Sheet::Outline),
        "app-outline",
    ),
    bind(
        Key::PageDown,
        Ctrl,
        "Ctrl PgDn",
        || Command::NextLesson,
        "app-next-lesson",
    ),
    bind(
        Key::PageUp,
        Ctrl,
        "Ctrl PgUp",
        || Command::PreviousLesson,
        "app-previous-lesson",
    ),
    bind(Key::Z, Ctrl, "Ctrl z", || Command::Undo, "app-undo"),
    bind(Key::Y, Ctrl, "Ctrl y", || Command::Redo, "app-redo"),
    bind(
        Key::R,
        Nothing,
        "r",
        || Command::Reset,
        "keys-start-the-lesson-over",
    ),
    bind(
        Key::Num1,
        Sign,
        "1",
        || Command::KeyNumber(1),
        "keys-key-panel",
    ),
    bind(
        Key::Num2,
        Sign,
        "2",
        || Command::KeyNumber(2),
        "keys-key-panel",
    ),
    bind(
        Key::Num3,
        Sign,
        "3",
        || Command::KeyNumber(3),
        "keys-key-panel",
    ),
    bind(
        Key::Num4,
        Sign,
        "4",
        || Command::KeyNumber(4),
        "keys-key-panel",
    ),
    bind(
        Key::Num5,
        Sign,
        "5",
        || Command::KeyNumber(5),
        "keys-key-panel",
    ),
    bind(
        Key::Num6,
        Sign,
        "6",
        || Command::KeyNumber(6),
        "keys-key-panel",
    ),
    bind(
        Key::Num7,
        Sign,
        "7",
        || Command::KeyNumber(7),
        "keys-key-panel",
    ),
    bind(
        Key::Num8,
        Sign,
        "8",
        || Command::KeyNumber(8),
        "keys-key-panel",
    ),
    bind(
        Key::Num9,
        Sign,
        "9",
        || Command::KeyNumber(9),
        "keys-key-panel",
    ),
    bind(
        Key::P,
        Nothing,
        "p",
        || Command::Parameters,
        "app-parameters",
    ),
    bind(
        Key::P,
        Shift,
        "Shift p",
        || Command::Pin,
        "keys-pin-the-tree",
    ),
    bind(Key::Z, Nothing, "z", || Command::Fill, "keys-fill"),
    bind(
        Key::I,
        Nothing,
        "i",
        || Command::Inspector,
        "keys-inspector",
    ),
    bind(
        Key::Q,
        Nothing,
        "q",
        || Command::Questions,
        "keys-questions-on-or-off",
    ),
    bind(
        Key::L,
        Nothing,
        "l",
        || Command::OtherLanguage,
        "keys-english-or-indonesian",
    ),
    bind(Key::U, Nothing, "u", || Command::Unshot, "keys-unshot"),
    bind(
        Key::T,
        Nothing,
        "t",
        || Command::NextTheme,
        "keys-next-theme",
    ),
    bind(
        Key::F11,
        Nothing,
        "F11",
        || Command::Present,
        "keys-presentation",
    ),
    bind(
        Key::Escape,
        Nothing,
        "Esc",
        || Command::StopPresenting,
        "keys-end-the-presentation",
    ),
    bind(
        Key::Plus,
        Ctrl,
        "Ctrl +",
        || Command::LargerText,
        "keys-larger-text",
    ),
    bind(
        Key::Equals,
        Ctrl,
        "Ctrl =",
        || Command::LargerText,
        "keys-larger-text",
    ),
    bind(
        Key::Minus,
        Ctrl,
        "Ctrl −",
        || Command::SmallerText,
        "keys-smaller-text",
    ),
    bind(
        Key::Num0,
        Ctrl,
        "Ctrl 0",
        || Command::NormalText,
        "keys-normal-text",
    ),
    bind(
        Key::C,
        Shift,
        "Shift c",
        || Command::Share,
        "keys-copy-the-command-that-opens",
    ),
    bind(
        Key::S,
        Nothing,
        "s",
        || Command::Skip,
        "keys-skip-the-question",
    ),
    bind(
        Key::A,
        Nothing,
        "a",
        || Command::Skip,
        "keys-show-the-answer",
    ),
    bind(
        Key::E,
        Nothing,
        "e",
        || Command::Study(StudyCommand::View),
        "keys-error-against-run-time",
    ),
    bind(
        Key::M,
        Nothing,
        "m",
        || Command::Mistakes,
        "keys-classic-mistakes",
    ),
    bind(Key::W, Nothing, "w", || Command::WhatIf, "keys-what-if"),
    bind(
        Key::Questionmark,
        Sign,
        "?",
        || Command::Keys,
        "keys-all-keys",
    ),
    bind(Key::F1, Nothing, "F1", || Command::Keys, "keys-all-keys"),
];

/// The key of a command, for the hint on its button.
pub fn key_of(command: &Command) -> Option<&'static str> {
    let binding = BINDINGS
        .iter()
        .find(|binding| (binding.command)() == *command);
    binding.map(|binding| binding.shown)
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::Modifiers;

    #[test]
    fn no_key_means_two_things() {
        for (index, binding) in BINDINGS.iter().enumerate() {
            for held in [Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND] {
                let others = BINDINGS[index + 1..].iter();
                let doubled = others
                    .filter(|_| binding.is_pressed(binding.key, held))
                    .filter(|other| other.is_pressed(binding.key, held));
                assert_eq!(doubled.count(), 0, "{}", binding.shown);
            }
        }
    }
}
