//! The card that asks before the answer is seen: what all questions have, and a file for each kind that has more.

mod arrow;
mod choice;
mod number;
mod order;
mod pick;

use super::announced::announced;
use super::button::{for_finger, link};
use super::prose::{prose, set};
use super::session::{Command, Session, Standing};
use super::window_state::Window;
use super::{strings, style};
use crate::lesson::{Answer, Question};
use crate::picture::Ink;
use egui::{Button, FontId, Frame, Margin, RichText, Stroke, Ui};

pub fn show(session: &Session, window: &mut Window, commands: &mut Vec<Command>, ui: &mut Ui) {
    let Some((question, standing)) = session.question() else {
        window.asked = None;
        return;
    };
    let theme = session.look.theme;
    let waits = session.question_at(session.step());
    let tried = (session.recording(), session.step(), session.guesses().len());
    let here = |asked: (u64, usize, usize)| (asked.0, asked.1) == (tried.0, tried.1);
    let opens = window.asked != Some(tried) && (waits || window.asked.is_some_and(here));
    window.asked = Some(tried);
    let (fill, line) = match waits {
        true => (Ink::WarnTint, Ink::Warn),
        false => (Ink::Surface, Ink::Rule),
    };
    let frame = Frame::new()
        .fill(style::color(theme, fill))
        .stroke(Stroke::new(1.0, style::color(theme, line)))
        .corner_radius(5)
        .inner_margin(Margin::symmetric(12, 10));
    let card = frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.horizontal_wrapped(|ui| {
            ui.label(style::strong(
                session.localize(strings::BEFORE_YOU_GO_ON),
                14.0,
            ));
            if waits {
                skip(session, commands, ui);
            }
        });
        ui.label(prose(
            session,
            question.ask(session.look.language),
            14.0,
            Ink::Text,
        ));
        if standing == Standing::Open || question.answer == Answer::Undecided {
            ask(session, question, opens, window, commands, ui);
        } else {
            verdict(session, question, standing, commands, ui);
        }
    });
    if opens {
        card.response.scroll_to_me(None);
    }
}

/// What is asked for, and after a first wrong answer what helps.
fn ask(
    session: &Session,
    question: &Question,
    opens: bool,
    window: &mut Window,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let language = session.look.language;
    let waits = session.question_at(session.step());
    if let Some(guess) = session.guesses().last().filter(|_| waits) {
        let mut hint = question.answer.hint(guess, language);
        if let Some(own) = question.hint(language) {
            hint = format!("{hint} {own}");
        }
        let hint = strings::ONCE_MORE.format(language, &[("hint", &hint)]);
        ui.label(prose(session, &hint, 14.0, Ink::Warn));
    }
    match &question.answer {
        Answer::Number { .. } => number::ask(session, opens, window, commands, ui),
        Answer::Choice { options, .. } => choice::ask(session, options, commands, ui),
        Answer::Pick { thing, names, .. } => pick::ask(session, *thing, names, commands, ui),
        Answer::Arrow { name, .. } => arrow::ask(session, name, opens, commands, ui),
        Answer::Order { items, .. } => order::ask(session, items, window, commands, ui),
        Answer::Pixel { .. } => {
            ui.label(RichText::new(session.localize(strings::CLICK_A_PIXEL)).strong());
        }
        Answer::Undecided => undecided(session, commands, ui),
    }
}

/// Offers the values with which the lesson asks.
fn undecided(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.label(prose(
        session,
        session.localize(strings::UNDECIDED),
        14.0,
        Ink::Muted,
    ));
    if ui
        .button(session.localize(strings::LESSONS_VALUES))
        .clicked()
    {
        commands.push(Command::LessonsValues);
    }
}

fn skip(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let skip = Button::new(session.localize(strings::SKIP)).frame(false);
    if ui.add(for_finger(skip, ui)).clicked() {
        commands.push(Command::Skip);
    }
}

/// The one button of a card that is meant to be pressed.
fn primary(session: &Session, text: &str) -> Button<'static> {
    let theme = session.look.theme;
    let text = style::strong(text, 13.0).color(style::color(theme, Ink::Surface));
    Button::new(text).fill(style::color(theme, Ink::Linked))
}

fn verdict(
    session: &Session,
    question: &Question,
    standing: Standing,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let (strings, ink) = match standing {
        Standing::Right => (strings::RIGHT, Ink::Good),
        Standing::Wrong => (strings::WRONG, Ink::Warn),
        Standing::Open | Standing::Skipped => (strings::SKIPPED, Ink::Muted),
    };
    let language = session.look.language;
    let answer = within_sentence(&question.answer.in_words(language));
    let sign = if standing == Standing::Right {
        "✓ "
    } else {
        ""
    };
    let (strings, is) = (
        session.localize(strings),
        session.localize(strings::THE_ANSWER_IS),
    );
    // After a change the answer may be another one than the one that was judged.
    let is_right = standing == Standing::Right;
    let mut last = session.guesses().last().into_iter();
    let recorded = match last.any(|guess| question.answer.judge(guess) != Ok(is_right)) {
        true => strings::ANSWER_NOW.format(language, &[("answer", &answer)]),
        false => format!("{sign}{strings} {is} {answer}."),
    };
    announced(ui.label(set(
        session,
        &recorded,
        FontId::new(14.0, style::bold()),
        ink,
    )));
    if let Some(guess) = session
        .guesses()
        .last()
        .filter(|_| standing != Standing::Right)
    {
        let own = within_sentence(&question.answer.guess_in_words(guess, language));
        let own = strings::YOU_ANSWERED.format(language, &[("answer", &own)]);
        ui.label(prose(session, &own, 14.0, Ink::Muted));
    }
    ui.label(prose(
        session,
        question.why(session.look.language),
        14.0,
        Ink::Text,
    ));
    let step = question.step.to_string();
    let text = strings::SHOW_THE_STEP.format(session.look.language, &[("step", &step)]);
    if link(text, ui) {
        commands.push(Command::Seek(question.step));
    }
}

/// An answer as it ends a sentence: without a full stop of its own, and a list on lines of its own.
fn within_sentence(answer: &str) -> String {
    let start = if answer.contains('\n') { "\n" } else { "" };
    format!("{start}{}", answer.trim_end_matches('.'))
}
