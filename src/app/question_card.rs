//! The card that asks before the answer is seen.

use super::prose::{prose, set};
use super::session::{Command, Guess, Session, Standing, read_number};
use super::window_state::Window;
use super::{strings, style};
use crate::lesson::{Answer, Question};
use crate::picture::Ink;
use egui::{Button, FontId, Frame, Key, Margin, RichText, Stroke, TextEdit, Ui};

pub fn show(session: &Session, window: &mut Window, commands: &mut Vec<Command>, ui: &mut Ui) {
    let Some((question, standing)) = session.question() else {
        return;
    };
    let theme = session.look.theme;
    let (fill, line) = match standing {
        Standing::Open => (Ink::WarnTint, Ink::Warn),
        _ => (Ink::Surface, Ink::Rule),
    };
    let frame = Frame::new()
        .fill(style::color(theme, fill))
        .stroke(Stroke::new(1.0, style::color(theme, line)))
        .corner_radius(5)
        .inner_margin(Margin::symmetric(12, 10));
    frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.horizontal(|ui| {
            ui.label(style::strong(
                session.localize(strings::BEFORE_YOU_GO_ON),
                14.0,
            ));
            if standing == Standing::Open {
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    skip(session, commands, ui);
                });
            }
        });
        ui.label(prose(
            session,
            question.ask(session.look.language),
            14.0,
            Ink::Text,
        ));
        if standing == Standing::Open {
            ask(session, &question.answer, window, commands, ui);
        } else {
            verdict(session, question, standing, commands, ui);
        }
    });
}

fn ask(
    session: &Session,
    answer: &Answer,
    window: &mut Window,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    match answer {
        Answer::Number { .. } => {
            ui.horizontal_wrapped(|ui| {
                let edit = TextEdit::singleline(&mut window.answer)
                    .desired_width(96.0)
                    .hint_text("…");
                let response = ui.add(edit);
                if response.changed() {
                    window.misread = false;
                }
                let (name, text) = (
                    session.localize(strings::YOUR_ANSWER),
                    window.answer.clone(),
                );
                response.widget_info(|| egui::WidgetInfo {
                    label: Some(name.to_owned()),
                    ..egui::WidgetInfo::text_edit(true, "", &text, "")
                });
                let entered =
                    response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
                if ui
                    .add(primary(session, session.localize(strings::CHECK)))
                    .clicked()
                    || entered
                {
                    window.misread = read_number(&window.answer).is_none();
                    if window.misread {
                        // What is typed next must correct the answer, not act as keys.
                        response.request_focus();
                    } else {
                        commands.push(Command::Answer(Guess::Number(window.answer.clone())));
                    }
                }
            });
            if window.misread {
                let ink = style::color(session.look.theme, Ink::Bad);
                ui.label(RichText::new(session.localize(strings::NOT_A_NUMBER)).color(ink));
            }
        }
        Answer::Choice { options, .. } => {
            for (index, option) in options.iter().enumerate() {
                let text = &option[session.look.language as usize];
                if ui
                    .add(Button::new(prose(session, text, 13.0, Ink::Text)).wrap())
                    .clicked()
                {
                    commands.push(Command::Answer(Guess::Choice(index)));
                }
            }
        }
        Answer::Pixel { .. } => {
            ui.label(RichText::new(session.localize(strings::CLICK_A_PIXEL)).strong());
        }
    }
}

fn skip(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    if ui
        .add(Button::new(session.localize(strings::SKIP)).frame(false))
        .clicked()
    {
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
    let answer = match &question.answer {
        Answer::Number { value, tolerance } => {
            session.look.language.number(rounded(*value, *tolerance))
        }
        Answer::Choice { options, right } => {
            options[*right][session.look.language as usize].clone()
        }
        Answer::Pixel { x, y, .. } => format!("({x}, {y})"),
    };
    let sign = if standing == Standing::Right {
        "✓ "
    } else {
        ""
    };
    let (strings, is) = (
        session.localize(strings),
        session.localize(strings::THE_ANSWER_IS),
    );
    let recorded = format!("{sign}{strings} {is} {}.", answer.trim_end_matches('.'));
    ui.label(set(
        session,
        &recorded,
        FontId::new(14.0, style::bold()),
        ink,
    ));
    ui.label(prose(
        session,
        question.why(session.look.language),
        14.0,
        Ink::Text,
    ));
    if ui
        .link(strings::SHOW_THE_STEP.format(
            session.look.language,
            &[("step", &question.step.to_string())],
        ))
        .clicked()
    {
        commands.push(Command::Seek(question.step));
    }
}

/// To the decimal place that still counts under `tolerance`, as it would be answered.
pub fn rounded(value: f64, tolerance: f64) -> f64 {
    if tolerance <= 0.0 {
        return value;
    }
    let places = 10f64.powf(-tolerance.log10().floor());
    (value * places).round() / places
}
