//! The left column: what this step is and why, the note on the slide, the question, pseudocode and formula.

use super::prose::prose;
use super::session::{Command, Session};
use super::tiles::panel_on;
use super::window_state::Window;
use super::{panel_view, question_card, strings, style};
use crate::panels::{Panel, kind_name};
use crate::picture::{Ink, Tag};
use egui::{Frame, Margin, Rect, RichText, ScrollArea, Ui};

/// The least heights at which pseudocode and formula can be read, and what is between them.
const CODE: f32 = 190.0;
const FORMULA: f32 = 132.0;
const RULE: f32 = 1.0;
/// Between the card's frame and what is in it.
const MARGIN: f32 = 4.0;

/// Shows the column; returns what lies under the pointer.
pub fn show(
    session: &Session,
    window: &mut Window,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let card = ui.max_rect();
    ui.set_min_size(card.size());
    style::card(session.look.theme, card, ui);
    let mut under = None;
    let mut ui = ui.new_child(egui::UiBuilder::new().max_rect(card.shrink(MARGIN)));
    ScrollArea::vertical()
        .auto_shrink(false)
        .show(&mut ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let said = Frame::new()
                .inner_margin(Margin::symmetric(14, 12))
                .show(ui, |ui| {
                    ui.spacing_mut().item_spacing.y = 8.0;
                    ui.set_width(ui.available_width());
                    localize(session, window, commands, ui);
                    question_card::show(session, window, commands, ui);
                });
            // Pseudocode and formula share what the words leave, as far as is known from the frame before.
            let height = said.response.rect.height();
            if (height - window.said_height).abs() > 0.5 {
                window.said_height = height;
                ui.ctx()
                    .request_discard("the words of this step take another height");
            }
            let left = (card.height() - 2.0 * MARGIN - window.said_height - 2.0 * RULE)
                .max(CODE + FORMULA);
            let code = (0.64 * left).clamp(CODE, left - FORMULA);
            for (panel, height) in [(Panel::Code, code), (Panel::Formula, left - code)] {
                rule(session, ui);
                let (_, rect) = ui.allocate_space(egui::vec2(ui.available_width(), height.floor()));
                let view = window.views.entry(panel).or_default();
                let shown = panel_on(session, panel, view, rect, ui);
                commands.extend(shown.command);
                under = shown.under.or(under);
            }
        });
    under
}

fn rule(session: &Session, ui: &mut Ui) {
    let (_, rect) = ui.allocate_space(egui::vec2(ui.available_width(), RULE));
    let line = Rect::from_x_y_ranges(rect.x_range().shrink(12.0), rect.y_range());
    ui.painter()
        .rect_filled(line, 0.0, style::color(session.look.theme, Ink::Rule));
}

fn localize(session: &Session, window: &Window, commands: &mut Vec<Command>, ui: &mut Ui) {
    let language = session.look.language;
    let muted = style::color(session.look.theme, Ink::Muted);
    if !session.follows_lesson() {
        ui.label(style::strong(panel_view::focus_words(session), 14.0));
        ui.label(RichText::new(session.localize(strings::OTHER_FOCUS)).color(muted));
        if ui
            .button(session.localize(strings::BACK_TO_LESSON))
            .clicked()
        {
            commands.push(Command::Focus(session.lesson().focus));
        }
    }
    if session.is_silent() {
        let [why, again] = match session.setup().forced().is_empty() {
            true => [strings::UNSAID, strings::PUT_BACK],
            false => [strings::UNSAID_ANYWAY, strings::LEAVE_OUT_AGAIN],
        };
        ui.label(RichText::new(session.localize(why)).color(muted));
        if ui.button(session.localize(again)).clicked() {
            commands.push(Command::Reset);
        }
    }
    if let Some(said) = session.narration_here() {
        ui.label(prose(session, said.say(language), 15.0, Ink::Text));
        if let Some(slide) = said.slide(language) {
            slide_note(session, slide, ui);
        }
        return;
    }
    if !session.walk().is_empty() {
        let kind = kind_name(session.walk().kind(session.step()), language);
        ui.label(style::strong(kind, 14.0));
    }
    ui.label(prose(session, in_words(session, window), 15.0, Ink::Text));
    if session.follows_lesson() && session.last_narration().is_none() && !session.is_silent() {
        let summary = session.lesson().summary.in_language(language);
        ui.label(prose(session, summary, 14.0, Ink::Muted));
        if ui.link(session.localize(strings::NEXT_SAID)).clicked() {
            commands.push(Command::NextNarrated);
        }
    }
    if let Some(said) = session.last_narration() {
        let link = strings::LAST_SAID.format(language, &[("step", &said.step.to_string())]);
        if ui.link(RichText::new(link).size(12.0)).clicked() {
            commands.push(Command::Seek(said.step));
        }
        ui.label(prose(session, said.say(language), 13.0, Ink::Muted));
    }
}

/// This step in words, as the panels say it for those who cannot see them.
fn in_words<'a>(session: &Session, window: &'a Window) -> &'a str {
    let panels = [Panel::Formula, Panel::Code]
        .into_iter()
        .chain(session.panels());
    let mut alts = panels
        .filter_map(|panel| window.views.get(&panel))
        .map(|view| view.alt());
    alts.find(|alt| !alt.is_empty()).unwrap_or_default()
}

fn slide_note(session: &Session, text: &str, ui: &mut Ui) {
    let theme = session.look.theme;
    let frame = Frame::new()
        .fill(style::color(theme, Ink::LinkedTint))
        .corner_radius(4)
        .inner_margin(Margin::symmetric(10, 8));
    frame.show(ui, |ui| {
        ui.set_width(ui.available_width());
        ui.spacing_mut().item_spacing.y = 3.0;
        ui.label(style::strong(session.localize(strings::SLIDE), 13.0));
        ui.label(prose(session, text, 13.0, Ink::Text));
    });
}
