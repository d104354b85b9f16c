//! Classic mistakes in the picture that is shown: a list of them, and of the one that is switched on its picture beside ours.

use super::button::button;
use super::compared_pictures::{self, Compared, Names, pictures, worst};
use super::prose::{prose, set};
use super::session::{Command, Session};
use super::{strings, style};
use crate::methods::Mistake;
use crate::picture::Ink;
use egui::{Align, Button, FontId, Layout, Rect, RichText, ScrollArea, Ui, UiBuilder};

const TEXT: f32 = 13.0;

const NAMES: Names = Names {
    mine: strings::WHAT_IF_WRONG,
    reference: strings::WHAT_IF_RIGHT,
    difference: strings::WHAT_IF_DIFFERENCE,
    pixel: strings::WHAT_IF_PIXEL,
};

/// Shows the drawer in `rect`.
pub fn show(session: &Session, commands: &mut Vec<Command>, rect: Rect, ui: &mut Ui) {
    let mut ui = ui.new_child(UiBuilder::new().max_rect(rect.shrink2(egui::vec2(8.0, 2.0))));
    let on = session.what_if().on;
    // The list and each mistake begin at their top.
    ScrollArea::vertical()
        .id_salt(("what-if", on))
        .auto_shrink(false)
        .show(&mut ui, |ui| {
            ui.spacing_mut().item_spacing.y = 4.0;
            if session.panel_input().is_pending() {
                ui.label(session.localize(strings::AFTER_YOUR_ANSWER));
                return;
            }
            match on {
                None => list(session, commands, ui),
                Some(mistake) => one(session, mistake, commands, ui),
            }
        });
}

/// All mistakes that the method allows; those that change nothing at the end.
fn list(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let how = session.localize(strings::WHAT_IF_HOW);
    ui.label(prose(session, how, TEXT, Ink::Text));
    let what_if = session.what_if();
    let changes = |mistake: &Mistake| what_if.off(*mistake) != Some(0);
    let (shown, idle): (Vec<Mistake>, Vec<Mistake>) =
        session.possible_mistakes().partition(changes);
    for mistake in shown {
        let share = what_if.off(mistake).map(|off| share(session, off));
        let share = RichText::new(share.unwrap_or_else(|| "…".into())).size(12.0);
        let name = mistake.title(session.look.language);
        let row = Button::new(prose(session, &name, TEXT, Ink::Linked))
            .right_text(share)
            .wrap();
        let command = Command::Mistake(Some(mistake));
        let as_wide_as_the_drawer = Layout::top_down_justified(Align::Min);
        ui.with_layout(as_wide_as_the_drawer, |ui| {
            button(session, row, &name, command, commands, ui);
        });
    }
    if !idle.is_empty() {
        ui.add_space(6.0);
        ui.label(session.localize(strings::WHAT_IF_UNCHANGED));
    }
    for mistake in idle {
        let name = mistake.title(session.look.language);
        ui.label(prose(session, &name, TEXT, Ink::Muted));
    }
}

/// How much of the picture that is, in percent.
fn share(session: &Session, off: usize) -> String {
    let [width, height] = session.lesson().size.map(|side| side as usize);
    let language = session.look.language;
    let percent = compared_pictures::percent(off, width * height, language);
    strings::WHAT_IF_SHARE.format(language, &[("share", &percent)])
}

/// One mistake: what is wrong, what to look for, and its picture beside ours.
fn one(session: &Session, mistake: Mistake, commands: &mut Vec<Command>, ui: &mut Ui) {
    let language = session.look.language;
    ui.horizontal(|ui| others(session, mistake, commands, ui));
    let name = mistake.title(language);
    let bold = FontId::new(15.0, style::bold());
    ui.label(set(session, &name, bold, Ink::Text));
    ui.label(prose(session, &mistake.about(language), TEXT, Ink::Text));
    let what_if = session.what_if();
    let Some((mine, found)) = &what_if.made else {
        let said = match what_if.off(mistake) {
            None => strings::WHAT_IF_DRAWING,
            Some(_) => strings::WHAT_IF_NO_DIFFERENCE,
        };
        ui.label(prose(session, session.localize(said), TEXT, Ink::This));
        return;
    };
    let figures = compared_pictures::figures(found, language);
    ui.label(prose(session, &figures, TEXT, Ink::This));
    let compared = Compared {
        mine,
        found,
        version: what_if.version,
        names: &NAMES,
    };
    pictures(session, compared, commands, ui);
    worst(session, compared, commands, ui);
}

/// The ways to the list and to the mistakes beside this one that change the picture.
fn others(session: &Session, mistake: Mistake, commands: &mut Vec<Command>, ui: &mut Ui) {
    let what_if = session.what_if();
    let is_one = |other: &Mistake| *other == mistake || what_if.off(*other) != Some(0);
    let all: Vec<Mistake> = session.possible_mistakes().filter(is_one).collect();
    let here = all.iter().position(|other| *other == mistake).unwrap_or(0);
    let beside = |step: usize| Some(all[(here + step) % all.len()]);
    let list = session.localize(strings::WHAT_IF_ALL);
    for (sign, name, to) in [
        ("‹", strings::WHAT_IF_PREVIOUS, beside(all.len() - 1)),
        ("›", strings::WHAT_IF_NEXT, beside(1)),
        (list, strings::WHAT_IF_ALL, None),
    ] {
        let name = session.localize(name);
        let command = Command::Mistake(to);
        button(session, Button::new(sign), name, command, commands, ui);
    }
}
