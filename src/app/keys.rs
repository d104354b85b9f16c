//! The keys: one table, which the handler obeys and the sheet of keys prints.

use super::parameter_card;
use super::session::{Command, Session, StudyCommand};
use crate::panels::strings::Words;
use egui::{Event, Key, Modifiers, Popup};

/// Which of the modifier keys must be held.
#[derive(Clone, Copy, PartialEq, Eq)]
enum With {
    Nothing,
    Shift,
    Ctrl,
    /// Nothing or shift: signs that need it on some keyboards.
    Sign,
}

/// A key and what it does.
pub struct Binding {
    key: Key,
    with: With,
    pub command: fn() -> Command,
    /// As the sheet of keys writes it.
    pub shown: &'static str,
    pub strings: Words,
}

const fn bind(
    key: Key,
    with: With,
    shown: &'static str,
    command: fn() -> Command,
    en: &'static str,
    id: &'static str,
) -> Binding {
    Binding {
        key,
        with,
        command,
        shown,
        strings: Words::new(en, id),
    }
}

use With::{Ctrl, Nothing, Shift, Sign};

pub const BINDINGS: [Binding; 38] = [
    bind(
        Key::ArrowRight,
        Nothing,
        "→",
        || Command::Forward(1),
        "next event",
        "kejadian berikutnya",
    ),
    bind(
        Key::ArrowLeft,
        Nothing,
        "←",
        || Command::Back(1),
        "event before",
        "kejadian sebelumnya",
    ),
    bind(
        Key::ArrowRight,
        Shift,
        "Shift →",
        || Command::Forward(10),
        "ten events on",
        "sepuluh kejadian maju",
    ),
    bind(
        Key::ArrowLeft,
        Shift,
        "Shift ←",
        || Command::Back(10),
        "ten events back",
        "sepuluh kejadian mundur",
    ),
    bind(
        Key::ArrowRight,
        Ctrl,
        "Ctrl →",
        || Command::NextScope,
        "next scope",
        "lingkup berikutnya",
    ),
    bind(
        Key::ArrowLeft,
        Ctrl,
        "Ctrl ←",
        || Command::PreviousScope,
        "previous scope",
        "lingkup sebelumnya",
    ),
    bind(
        Key::ArrowDown,
        Nothing,
        "↓",
        || Command::Into,
        "into the scope",
        "masuk ke lingkup",
    ),
    bind(
        Key::ArrowUp,
        Nothing,
        "↑",
        || Command::Out,
        "out of the scope",
        "keluar dari lingkup",
    ),
    bind(
        Key::ArrowDown,
        Ctrl,
        "Ctrl ↓",
        || Command::Over,
        "over the scope",
        "lewati lingkup",
    ),
    bind(
        Key::Home,
        Nothing,
        "Home",
        || Command::Start,
        "first step",
        "langkah pertama",
    ),
    bind(
        Key::End,
        Nothing,
        "End",
        || Command::End,
        "last step",
        "langkah terakhir",
    ),
    bind(
        Key::N,
        Nothing,
        "n",
        || Command::NextNarrated,
        "next explained step",
        "langkah berikut yang dijelaskan",
    ),
    bind(
        Key::N,
        Shift,
        "Shift n",
        || Command::PreviousNarrated,
        "explained step before",
        "langkah dijelaskan sebelumnya",
    ),
    bind(
        Key::Space,
        Nothing,
        "Space",
        || Command::Play,
        "play or pause",
        "putar atau jeda",
    ),
    bind(
        Key::Space,
        Shift,
        "Shift Space",
        || Command::PlayBackwards,
        "play backwards",
        "putar mundur",
    ),
    bind(
        Key::Comma,
        Nothing,
        ",",
        || Command::Slower,
        "slower",
        "lebih lambat",
    ),
    bind(
        Key::Period,
        Nothing,
        ".",
        || Command::Faster,
        "faster",
        "lebih cepat",
    ),
    bind(
        Key::OpenBracket,
        Sign,
        "[",
        || Command::LoopFrom,
        "loop from this step",
        "ulang dari langkah ini",
    ),
    bind(
        Key::CloseBracket,
        Sign,
        "]",
        || Command::LoopTo,
        "loop to this step",
        "ulang sampai langkah ini",
    ),
    bind(
        Key::B,
        Nothing,
        "b",
        || Command::Breakpoint,
        "breakpoint here",
        "titik henti di sini",
    ),
    bind(Key::Slash, Sign, "/", || Command::Search, "search", "cari"),
    bind(
        Key::F,
        Nothing,
        "f",
        || Command::FocusOnPointer,
        "look at what the pointer is over",
        "lihat yang ditunjuk",
    ),
    bind(
        Key::R,
        Nothing,
        "r",
        || Command::Reset,
        "start the lesson over",
        "ulangi pelajaran dari awal",
    ),
    bind(
        Key::I,
        Nothing,
        "i",
        || Command::Inspector,
        "inspector",
        "inspektur",
    ),
    bind(
        Key::Q,
        Nothing,
        "q",
        || Command::Questions,
        "questions on or off",
        "pertanyaan aktif atau tidak",
    ),
    bind(
        Key::L,
        Nothing,
        "l",
        || Command::OtherLanguage,
        "English or Indonesian",
        "bahasa Inggris atau Indonesia",
    ),
    bind(
        Key::T,
        Nothing,
        "t",
        || Command::NextTheme,
        "next theme",
        "tema berikutnya",
    ),
    bind(
        Key::F11,
        Nothing,
        "F11",
        || Command::Present,
        "presentation",
        "presentasi",
    ),
    bind(
        Key::Escape,
        Nothing,
        "Esc",
        || Command::StopPresenting,
        "end the presentation",
        "akhiri presentasi",
    ),
    bind(
        Key::Plus,
        Ctrl,
        "Ctrl +",
        || Command::LargerText,
        "larger text",
        "teks lebih besar",
    ),
    bind(
        Key::Equals,
        Ctrl,
        "Ctrl =",
        || Command::LargerText,
        "larger text",
        "teks lebih besar",
    ),
    bind(
        Key::Minus,
        Ctrl,
        "Ctrl −",
        || Command::SmallerText,
        "smaller text",
        "teks lebih kecil",
    ),
    bind(
        Key::Num0,
        Ctrl,
        "Ctrl 0",
        || Command::NormalText,
        "normal text",
        "teks normal",
    ),
    bind(
        Key::C,
        Shift,
        "Shift c",
        || Command::Share,
        "copy the command that opens this step",
        "salin perintah pembuka langkah ini",
    ),
    bind(
        Key::S,
        Nothing,
        "s",
        || Command::Skip,
        "skip the question",
        "lewati pertanyaan",
    ),
    bind(
        Key::E,
        Nothing,
        "e",
        || Command::Study(StudyCommand::View),
        "error against run time",
        "galat terhadap waktu jalan",
    ),
    bind(
        Key::Questionmark,
        Sign,
        "?",
        || Command::Keys,
        "all keys",
        "semua tombol",
    ),
    bind(
        Key::F1,
        Nothing,
        "F1",
        || Command::Keys,
        "all keys",
        "semua tombol",
    ),
];

impl Binding {
    fn is_pressed(&self, key: Key, held: Modifiers) -> bool {
        let with = match self.with {
            With::Nothing => !held.shift && !held.command,
            With::Shift => held.shift && !held.command,
            With::Ctrl => held.command,
            With::Sign => !held.command,
        };
        self.key == key && with && !held.alt
    }
}

/// The commands of the keys pressed in this frame.
///
/// Keys are the user's own while text is edited, and where a focused button waits for its space or a slider for arrows. A key that acts closes
/// an open menu; escape does nothing else there.
pub fn pressed(session: &Session, ctx: &egui::Context) -> Vec<Command> {
    if ctx.text_edit_focused() {
        return Vec::new();
    }
    let menu = Popup::is_any_open(ctx);
    let focused = ctx.memory(|memory| memory.focused().is_some());
    let on_slider = focused && parameter_card::keeps_arrows(ctx);
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
            Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown => !on_slider,
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
            .filter_map(|command| match session.studying().is_open {
                true => over_study(command),
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

/// Over a study, a key means what it says of the whole window; escape closes the study.
fn over_study(command: Command) -> Option<Command> {
    match command {
        Command::StopPresenting => Some(Command::Study(StudyCommand::View)),
        Command::Study(_)
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
