//! A key that gives a command.

use super::session::Command;
use crate::language::Message;
use egui::{Key, Modifiers};

/// Which of the modifier keys must be held.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum With {
    Nothing,
    Shift,
    Ctrl,
    /// Nothing or shift: signs that need it on some keyboards.
    Sign,
}

/// A key and what it does.
pub struct Binding {
    pub key: Key,
    with: With,
    pub command: fn() -> Command,
    /// As the sheet of keys writes it.
    pub shown: &'static str,
    pub strings: Message,
}

/// A line of the table; `text` is the key of the message that says what it does.
pub const fn bind(
    key: Key,
    with: With,
    shown: &'static str,
    command: fn() -> Command,
    text: &'static str,
) -> Binding {
    Binding {
        key,
        with,
        command,
        shown,
        strings: Message(text),
    }
}

impl Binding {
    /// Whether `key`, with the modifiers that are `held`, is this one.
    pub fn is_pressed(&self, key: Key, held: Modifiers) -> bool {
        let with = match self.with {
            With::Nothing => !held.shift && !held.command,
            With::Shift => held.shift && !held.command,
            With::Ctrl => held.command,
            // Some layouts write it with AltGr, which Windows reports as Ctrl and Alt.
            With::Sign => held.command == held.alt,
        };
        self.key == key && with && (!held.alt || self.with == With::Sign)
    }
}
