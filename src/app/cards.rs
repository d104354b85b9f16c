//! The lesson's panels as cards: the key panel large, the others live beside it, and what opens in their place.

use super::button::button;
use super::layout::{Layout, MARGIN, TARGET, TITLE};
use super::panel_on::{entered, panel_on};
use super::panel_view::{self, PanelView, Scale};
use super::row_end::{before_end, row_end};
use super::session::{Command, Drawer, Session};
use super::{
    against_drawer, author_strings, image_controls, inspector_drawer, parameter_drawer,
    results_drawer, room_controls, space_controls, strings, style, tree_controls, what_if_drawer,
};
use crate::language::Message;
use crate::panels::Panel;
use crate::picture::{self, Ink, Tag};
use egui::{Button, Rect, Response, RichText, Sense, Ui};
use std::collections::HashMap;

/// Size of the names of panels.
const NAME: f32 = 13.0;
/// Room for what stands at the end of the key panel's row.
const CONTROLS: f32 = 130.0;
/// Room for the way to what is selected.
const WAY: f32 = 180.0;
/// How much wider buttons for fingers are.
const FOR_FINGERS: f32 = 1.6;
/// A card narrower than this has a title and nothing beside it.
const WIDE: f32 = 360.0;

/// Shows the key panel, the others, and the drawer; returns what lies under the pointer.
pub fn show(
    session: &Session,
    views: &mut HashMap<Panel, PanelView>,
    layout: &Layout,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let mut under = None;
    let key = session.key_panel();
    let others = session.other_panels();
    if let Some(key) = key {
        // A drawer stands in place of the others.
        let names = match layout.drawer {
            Some(_) => &[],
            None => &others[layout.side.len().min(others.len())..],
        };
        under = card(session, views, key, names, layout.key, commands, ui);
    }
    for (&panel, &rect) in others.iter().zip(&layout.side) {
        under = small_card(session, views, panel, rect, commands, ui).or(under);
    }
    if let (Some(drawer), Some(rect)) = (session.look.drawer, layout.drawer) {
        under = show_drawer(session, views, drawer, rect, commands, ui).or(under);
    }
    under
}

/// The key panel, with the names of other panels that have no card.
fn card(
    session: &Session,
    views: &mut HashMap<Panel, PanelView>,
    panel: Panel,
    names: &[Panel],
    rect: Rect,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let (title, mut row) = head(session, panel.title(), rect, ui);
    // A sense without the focus: the button at the right does the same.
    let title = title.interact(Sense::CLICK);
    let title = title.on_hover_text(session.localize(strings::FILL));
    if title.double_clicked() {
        commands.push(Command::Fill);
    }
    let titles = names.iter().map(|&other| {
        let title = numbered(session, other);
        picture::Style::Bold.size(NAME).width(&title) + 2.0 * NAME
    });
    let fit = titles.sum::<f32>() <= row.available_width() - CONTROLS;
    for &other in names {
        name_button(session, other, fit, commands, &mut row);
    }
    let (sign, name) = match session.is_filled() {
        true => ("×", strings::UNFILL),
        false => ("□", strings::FILL),
    };
    let wide = rect.width() >= WIDE;
    let has_room = row.available_width() >= CONTROLS + WAY;
    let scale = match style::is_for_fingers(ui.ctx()) {
        true => FOR_FINGERS,
        false => 1.0,
    };
    let has_controls = row.available_width() >= scale * controls_width(panel);
    let fill = (sign, name, Command::Fill);
    let rest = at_end(session, fill, commands, &mut row, |ui, commands| {
        if wide {
            if has_room {
                way_to_selected(session, commands, ui);
            }
            if has_controls {
                controls(session, panel, commands, ui);
            }
        }
    });
    if wide {
        let muted = style::color(session.look.theme, Ink::Muted);
        let caption = RichText::new(panel_view::caption(session, panel))
            .size(13.0)
            .color(muted);
        let caption = egui::Label::new(caption).truncate().selectable(false);
        before_end(rest, &mut row, |ui| drop(ui.add(caption)));
    }
    let view = views.entry(panel).or_default();
    let shown = panel_on(session, panel, view, inside(rect, ui), ui);
    if shown.filled {
        commands.push(Command::Fill);
    }
    commands.extend(shown.command);
    shown.under
}

/// Another panel, small, whose title makes it the key panel.
fn small_card(
    session: &Session,
    views: &mut HashMap<Panel, PanelView>,
    panel: Panel,
    rect: Rect,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    style::card(session.look.theme, rect, ui);
    name_button(session, panel, true, commands, &mut title_row(rect, ui));
    let view = views.entry(panel).or_default();
    let (response, under) = view.show(session, panel, inside(rect, ui), Scale::Small, ui);
    if response.double_clicked() {
        commands.push(Command::Key(panel));
    } else if response.clicked() {
        let command = match entered(&response, ui) {
            true => Command::Go,
            false => Command::Click,
        };
        commands.extend(under.map(command));
    }
    under
}

/// A card with its title; returns that, and the rest of its row.
fn head(session: &Session, title: Message, rect: Rect, ui: &mut Ui) -> (Response, Ui) {
    style::card(session.look.theme, rect, ui);
    let mut row = title_row(rect, ui);
    let title = style::strong(session.localize(title), 14.0);
    let title = row.add(egui::Label::new(title).selectable(false));
    (title, row)
}

/// At the end of a card's row a button with a sign, and what `more` adds before it. Returns what is left of the row.
fn at_end(
    session: &Session,
    (sign, name, command): (&str, Message, Command),
    commands: &mut Vec<Command>,
    row: &mut Ui,
    more: impl FnOnce(&mut Ui, &mut Vec<Command>),
) -> Rect {
    row_end(row, |ui, _| {
        more(ui, commands);
        let sign = Button::new(RichText::new(sign).size(13.0)).min_size(egui::vec2(24.0, 20.0));
        button(session, sign, session.localize(name), command, commands, ui);
    })
}

/// Height of a card's title, with what stands beside it.
fn title_height(ui: &Ui) -> f32 {
    match style::is_for_fingers(ui.ctx()) {
        true => TARGET,
        false => TITLE,
    }
}

fn title_row(rect: Rect, ui: &mut Ui) -> Ui {
    let for_fingers = style::is_for_fingers(ui.ctx());
    let row = Rect::from_min_size(rect.min, egui::vec2(rect.width(), title_height(ui)));
    let above_and_below = if for_fingers { 0.0 } else { 3.0 };
    let mut row = ui.new_child(
        egui::UiBuilder::new()
            .id_salt((rect.min.x as i32, rect.min.y as i32))
            .max_rect(row.shrink2(egui::vec2(10.0, above_and_below)))
            .layout(egui::Layout::left_to_right(egui::Align::Center)),
    );
    row.spacing_mut().item_spacing.x = 6.0;
    if !for_fingers {
        row.spacing_mut().button_padding = egui::vec2(6.0, 2.0);
        row.spacing_mut().interact_size.y = 20.0;
    }
    row
}

pub(super) fn inside(card: Rect, ui: &Ui) -> Rect {
    let mut inside = card.shrink(MARGIN);
    inside.min.y = card.min.y + title_height(ui);
    inside
}

/// The name of a panel after its number.
pub(super) fn numbered(session: &Session, panel: Panel) -> String {
    let title = session.localize(panel.title());
    let number = session.panels().iter().position(|&known| known == panel);
    match number {
        Some(number) => format!("{}  {title}", number + 1),
        None => title.to_owned(),
    }
}

/// The number of a panel and, where it is to be `whole`, its name; pressed, it becomes the key panel.
fn name_button(
    session: &Session,
    panel: Panel,
    whole: bool,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let title = session.localize(panel.title());
    let text = numbered(session, panel);
    let shown = match whole {
        true => text.as_str(),
        false => text.split(' ').next().unwrap_or_default(),
    };
    let text = style::strong(shown, NAME);
    let enlarge = strings::ENLARGE.format(session.look.language, &[("panel", title)]);
    let frameless = Button::new(text).frame_when_inactive(false).truncate();
    button(
        session,
        frameless,
        &enlarge,
        Command::Key(panel),
        commands,
        ui,
    );
}

/// To the step that is about what is selected.
fn way_to_selected(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let here = session.step();
    let Some(step) = session.selected_step().filter(|&step| step != here) else {
        return;
    };
    let number = step.to_string();
    let text = strings::SHOW_THE_STEP.format(session.look.language, &[("step", &number)]);
    let go = Button::new(RichText::new(&text).size(13.0));
    button(session, go, &text, Command::Seek(step), commands, ui);
}

/// What a panel lets be changed.
fn controls(session: &Session, panel: Panel, commands: &mut Vec<Command>, ui: &mut Ui) {
    if matches!(panel, Panel::Image | Panel::Comparison | Panel::Difference) {
        image_controls::buttons(session, commands, ui);
    }
    if panel == Panel::Image {
        image_controls::menu(session, commands, ui);
    }
    if panel == Panel::Space {
        space_controls::buttons(session, commands, ui);
    }
    if panel == Panel::RayTree {
        tree_controls::buttons(session, commands, ui);
    }
    if panel == Panel::Radiosity {
        room_controls::switches(session, commands, ui);
    }
    if matches!(panel, Panel::Radiosity | Panel::Space | Panel::Matrix) {
        room_controls::step_by_step(session, commands, ui);
    }
}

/// Room for what a panel lets be changed, and the button after it; where there is less, the keys and the pointer do the same.
fn controls_width(panel: Panel) -> f32 {
    match panel {
        Panel::Image => 270.0,
        Panel::Space => 320.0,
        Panel::Radiosity => 250.0,
        Panel::RayTree | Panel::Matrix => 150.0,
        _ => 0.0,
    }
}

pub(super) fn show_drawer(
    session: &Session,
    views: &mut HashMap<Panel, PanelView>,
    drawer: Drawer,
    rect: Rect,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let (title, command) = match drawer {
        Drawer::Inspector => (strings::INSPECTOR, Command::Inspector),
        Drawer::Parameters => (strings::PARAMETERS, Command::Parameters),
        Drawer::Against => (strings::COMPARISON, Command::Against),
        Drawer::WhatIf => (strings::WHAT_IF, Command::WhatIf),
        Drawer::Results => (strings::RESULTS, Command::Results),
        Drawer::Author => (author_strings::WRITE, Command::Author),
    };
    let (_, mut row) = head(session, title, rect, ui);
    let close = ("×", strings::CLOSE, command);
    at_end(session, close, commands, &mut row, |_, _| {});
    let rect = inside(rect, ui);
    match drawer {
        // What is written is with the window, which has the files.
        Drawer::Author => None,
        Drawer::Parameters => {
            parameter_drawer::show(session, commands, rect, ui);
            None
        }
        Drawer::Against => {
            against_drawer::show(session, commands, rect, ui);
            None
        }
        Drawer::WhatIf => {
            what_if_drawer::show(session, commands, rect, ui);
            None
        }
        Drawer::Results => {
            results_drawer::show(session, commands, rect, ui);
            None
        }
        Drawer::Inspector => {
            let view = views.entry(Panel::Inspector).or_default();
            let shown = inspector_drawer::show(session, view, commands, rect, ui);
            commands.extend(shown.command);
            shown.under
        }
    }
}
