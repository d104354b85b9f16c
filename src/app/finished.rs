//! The end of a lesson: what was learned, how the questions were answered, and where to go from here.

use super::button::button;
use super::prose::prose;
use super::session::{Command, Entry, Session, Sheet, Standing};
use super::{outline, strings, style};
use crate::picture::Ink;
use egui::{Button, Id, Modal, ScrollArea, Ui};

pub fn show(session: &Session, commands: &mut Vec<Command>, ctx: &egui::Context) {
    let frame = style::card_frame(session.look.theme);
    let close = Command::Sheet(Sheet::Finished);
    let modal = Modal::new(Id::unique("finished"))
        .frame(frame)
        .show(ctx, |ui| {
            let room = ctx.content_rect().size();
            ui.set_width((room.x - 80.0).min(620.0));
            let title = session.title();
            let heading = strings::FINISHED.format(session.look.language, &[("title", &title)]);
            ui.label(style::strong(heading, 18.0));
            ui.separator();
            ScrollArea::vertical()
                .max_height(room.y - 190.0)
                .show(ui, |ui| {
                    learned(session, ui);
                    score(session, commands, ui);
                });
            ui.separator();
            ways_on(session, commands, ui);
        });
    if modal.should_close() && commands.is_empty() {
        commands.push(close);
    }
}

fn learned(session: &Session, ui: &mut Ui) {
    if let Some(recap) = &session.lesson().recap {
        let recap = recap.in_language(session.look.language);
        ui.label(style::strong(session.localize(strings::LEARNED), 14.0));
        ui.label(prose(session, recap, 15.0, Ink::Text));
        ui.add_space(8.0);
    }
}

/// How many questions were answered right, and those that were not.
fn score(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let entries = session.outline();
    let asked = || {
        entries
            .iter()
            .enumerate()
            .filter(|(_, entry)| entry.standing.is_some())
    };
    let right = |entry: &Entry| entry.standing == Some(Standing::Right);
    let count = asked().count();
    if count == 0 {
        return;
    }
    let rights = asked().filter(|(_, entry)| right(entry)).count();
    let [rights, count] = [rights, count].map(|count| count.to_string());
    let words = [("right", rights.as_str()), ("count", count.as_str())];
    let said = strings::QUESTIONS_RIGHT.format(session.look.language, &words);
    ui.label(style::strong(said, 15.0));
    let missed: Vec<(usize, &Entry)> = asked().filter(|(_, entry)| !right(entry)).collect();
    if !missed.is_empty() {
        ui.label(session.localize(strings::LOOK_AGAIN));
    }
    for (index, entry) in missed {
        let mut chosen = Vec::new();
        outline::line(session, index, entry, false, &mut chosen, ui);
        if let Some(go) = chosen.pop() {
            commands.extend([Command::Sheet(Sheet::Finished), go]);
        }
    }
}

fn ways_on(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.horizontal_wrapped(|ui| {
        let theme = session.look.theme;
        let language = session.look.language;
        if let Some(next) = session.next_lesson() {
            let title = &next.title[language as usize];
            let text = strings::NEXT_LESSON_IS.format(language, &[("title", title)]);
            let shown = style::strong(&text, 13.0).color(style::color(theme, Ink::Surface));
            let primary = Button::new(shown).fill(style::color(theme, Ink::Linked));
            button(session, primary, &text, Command::NextLesson, commands, ui);
        }
        for (name, command) in [
            (strings::LESSONS, Command::Home),
            (strings::START_AGAIN, Command::Reset),
            (strings::CLOSE, Command::Sheet(Sheet::Finished)),
        ] {
            let name = session.localize(name);
            button(session, Button::new(name), name, command, commands, ui);
        }
    });
}
