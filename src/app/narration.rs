//! The left column: what this step is and why, the note on the slide, the question, pseudocode and formula.

use super::announced::announced;
use super::button::link;
use super::layout::{self, MARGIN};
use super::panel_on::panel_on;
use super::panel_view::Key;
use super::prose::prose;
use super::session::{Command, Session};
use super::window_state::Window;
use super::{panel_view, question_card, strings, style, whereabouts};
use crate::panels::{Panel, formula_height, kind_name, whole_formula_height};
use crate::picture::{Ink, Tag};
use egui::{Frame, Margin, Rect, RichText, ScrollArea, Sense, Ui, vec2};

/// Shows the column on the card `card`: three regions, none of which pushes another out. Returns what lies under the pointer.
pub fn show(
    session: &Session,
    window: &mut Window,
    card: Rect,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    style::card(session.look.theme, card, ui);
    let heights = formula_heights(session, window, card.width() - 2.0 * MARGIN);
    // A picture stands on whole pixels, which takes up to one point.
    let [first, whole] = heights.map(|height| height + 2.0 * MARGIN + 1.0);
    let said = window.said_height;
    // A finger scrolls one thing, and that from anywhere.
    let for_fingers = style::is_for_fingers(ui.ctx());
    let height = match for_fingers {
        true => layout::stacked_height(said, whole),
        false => layout::column_height(card.height(), said, first),
    };
    let mut place = ui.new_child(egui::UiBuilder::new().max_rect(card));
    let scrolled = ScrollArea::vertical()
        // What scrolls as a whole begins at the beginning of another text.
        .id_salt((
            "column",
            for_fingers.then(|| (session.recording(), session.step())),
        ))
        .show(&mut place, |ui| {
            let (_, place) = ui.allocate_space(egui::vec2(card.width(), height));
            let column = match for_fingers {
                true => layout::stacked(place, whole),
                false => layout::column(place, said, first),
            };
            regions(session, window, column, commands, ui)
        });
    scrolled.inner
}

/// The regions of the column; returns what lies under the pointer.
fn regions(
    session: &Session,
    window: &mut Window,
    column: layout::Column,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let mut said = ui.new_child(egui::UiBuilder::new().max_rect(column.said.shrink(MARGIN)));
    let mut words = |ui: &mut Ui| {
        let frame = Frame::new().inner_margin(Margin::symmetric(12, 8));
        let framed = frame.show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 8.0;
            ui.set_width(ui.available_width());
            narration(session, window, commands, ui);
            question_card::show(session, window, commands, ui);
        });
        framed.response.rect.height()
    };
    let height = match style::is_for_fingers(ui.ctx()) {
        true => words(&mut said),
        false => {
            let scrolled = ScrollArea::vertical()
                .auto_shrink(false)
                // Another text begins at its beginning.
                .id_salt((session.recording(), session.step()))
                .show(&mut said, words);
            scrolled.inner
        }
    };
    // The words' height is known once they are set.
    let height = height + 2.0 * MARGIN;
    if (height - window.said_height).abs() > 0.5 {
        window.said_height = height;
        ui.ctx()
            .request_discard("the words of this step take another height");
    }
    let width = column.formula.width() - 2.0 * MARGIN;
    // As above, for the picture that scrolls.
    let least_whole = formula_heights(session, window, width)[1] + 1.0;
    let mut under = None;
    for (panel, region) in [(Panel::Code, column.code), (Panel::Formula, column.formula)] {
        rule(session, region, ui);
        let view = window.views.entry(panel).or_default();
        let rect = region.shrink(MARGIN);
        let shown = if panel == Panel::Formula && least_whole > rect.height() {
            let size = vec2(rect.width(), least_whole);
            let mut child = ui.new_child(egui::UiBuilder::new().max_rect(rect));
            let scrolled = ScrollArea::vertical()
                .id_salt(("formula", session.recording(), session.step()))
                .show(&mut child, |ui| {
                    let (whole, _) = ui.allocate_exact_size(size, Sense::hover());
                    panel_on(session, panel, view, whole, ui)
                });
            scrolled.inner
        } else {
            panel_on(session, panel, view, rect, ui)
        };
        commands.extend(shown.command);
        under = shown.under.or(under);
    }
    under
}

/// The least heights at which the first formula of this step, and at which all of them can be read with their numbers.
fn formula_heights(session: &Session, window: &mut Window, width: f32) -> [f32; 2] {
    let key = Key::new(session, Panel::Formula);
    match &window.formula {
        Some((known, at, heights)) if *known == key && *at == width => *heights,
        _ => {
            let input = session.panel_input();
            let heights = [
                formula_height(&input, width),
                whole_formula_height(&input, width),
            ];
            window.formula = Some((key, width, heights));
            heights
        }
    }
}

/// Between a region and the one above it.
fn rule(session: &Session, region: Rect, ui: &Ui) {
    let stroke = egui::Stroke::new(1.0, style::color(session.look.theme, Ink::Rule));
    ui.painter()
        .hline(region.x_range().shrink(12.0), region.top(), stroke);
}

fn narration(session: &Session, window: &Window, commands: &mut Vec<Command>, ui: &mut Ui) {
    let language = session.look.language;
    let muted = style::color(session.look.theme, Ink::Muted);
    whereabouts::show(session, commands, ui);
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
        announced(ui.label(prose(session, said.text(language), 14.5, Ink::Text)));
        if let Some(slide) = said.slide(language) {
            slide_note(session, slide, ui);
        }
        // With it comes the whole picture, which a question may be about.
        let mistake = said.mistake.filter(|_| !session.panel_input().is_pending());
        if let Some(mistake) = mistake {
            let words = mistake.in_words(language);
            let text = strings::WHAT_IF_HERE.format(language, &[("mistake", &words)]);
            if link(text, ui) {
                commands.push(Command::Mistake(Some(mistake)));
            }
        }
        if said.types_numbers && session.is_changed() {
            let note = RichText::new(session.localize(strings::TYPED_NUMBERS));
            ui.label(note.size(12.5).color(muted));
        }
        for (title, otherwise) in session.not_happening_here() {
            let title = [("title", title.unwrap_or("…"))];
            let text = strings::NOT_HAPPENING.format(language, &title);
            announced(ui.label(prose(session, &text, 14.0, Ink::Warn)));
            if let Some(otherwise) = otherwise {
                announced(ui.label(prose(session, otherwise, 14.0, Ink::Text)));
            }
        }
        return;
    }
    if !session.walk().is_empty() {
        let kind = kind_name(session.walk().kind(session.step()), language);
        ui.label(style::strong(kind, 14.0));
    }
    announced(ui.label(prose(session, in_words(session, window), 14.5, Ink::Text)));
    if session.follows_lesson() && session.explanation().is_none() && !session.is_silent() {
        let summary = session.lesson().summary.in_language(language);
        ui.label(prose(session, summary, 14.0, Ink::Muted));
        if link(session.localize(strings::NEXT_SAID), ui) {
            commands.push(Command::NextNarrated);
        }
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
