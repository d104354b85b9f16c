//! From the keys pressed in a frame to their commands.

use super::arrow_focus;
use super::keys::BINDINGS;
use super::session::{Command, Session, StudyCommand};
use egui::{Event, Key, Popup};

/// The commands of the keys pressed in this frame.
///
/// Keys are the user's own while text is edited, where a focused button waits for its space, and where a slider, a picture, a sheet or the page
/// of all lessons waits for arrows. A key that acts closes an open menu; escape does nothing else there.
pub fn pressed(session: &Session, ctx: &egui::Context) -> Vec<Command> {
    let claimed = arrow_focus::take(ctx);
    if ctx.text_edit_focused() {
        return Vec::new();
    }
    let menu = Popup::is_any_open(ctx);
    let focused = ctx.memory(|memory| memory.focused().is_some());
    let claimed = focused && claimed;
    let mut arrow = false;
    let commands: Vec<Command> = ctx.input(|input| {
        let keys = input.events.iter().filter_map(|event| match *event {
            Event::Key {
                key,
                pressed: true,
                modifiers,
                ..
            } => Some((key, modifiers)),
            _ => None,
        });
        let bound = keys.filter_map(|(key, held)| {
            BINDINGS
                .iter()
                .find(|binding| binding.is_pressed(key, held))
        });
        let ours = bound.filter(|binding| match binding.key {
            Key::Space => !focused,
            Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown => {
                !claimed
                    && !session.look.home
                    && !session.look.mistakes
                    && session.look.sheet.is_none()
            }
            Key::Escape => !menu,
            _ => true,
        });
        let commands = ours.map(|binding| {
            arrow |= matches!(
                binding.key,
                Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown
            );
            (binding.command)()
        });
        // Over the sheet of keys, only what closes it.
        commands
            .filter(|command| !session.look.keys || *command == Command::Keys)
            .filter(|command| match session.look.sheet {
                Some(sheet) => *command == Command::Sheet(sheet),
                None => true,
            })
            .filter_map(|command| match session.look.home {
                true => over_page(command, Command::Home),
                false if session.look.mistakes => over_page(command, Command::Mistakes),
                false if session.studying().is_open => {
                    over_page(command, Command::Study(StudyCommand::View))
                }
                false => Some(command),
            })
            .collect()
    });
    if !commands.is_empty() {
        Popup::close_all(ctx);
    }
    if arrow {
        // Arrows walk through the run; without this they would also move the focus to a neighbouring button.
        ctx.memory_mut(|memory| memory.move_focus(egui::FocusDirection::None));
    }
    commands
}

/// Over a page in place of the lesson, a key means what it says of the whole window; escape closes the page.
fn over_page(command: Command, close: Command) -> Option<Command> {
    match command {
        Command::StopPresenting => Some(close),
        Command::Search if close == Command::Home => Some(command),
        Command::Study(_)
        | Command::Home
        | Command::Mistakes
        | Command::Keys
        | Command::OtherLanguage
        | Command::NextTheme
        | Command::Present
        | Command::LargerText
        | Command::SmallerText
        | Command::NormalText => Some(command),
        _ => None,
    }
}
