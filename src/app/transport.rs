//! The row above the time line: buttons to walk and play, where we are, speed, loop, search.

use super::button::button;
use super::layout::TARGET;
use super::row_end::{before_end, row_end};
use super::session::{Command, Direction, Drawer, Session};
use super::window_state::Window;
use super::{strings, style};
use crate::language::Message;
use crate::panels::kind_name;
use crate::replay::query;
use egui::containers::menu::MenuConfig;
use egui::{Button, Id, Key, PopupCloseBehavior, Rect, RichText, TextEdit, Ui};

/// A row narrower than this leaves the speed to the keys.
const WIDE: f32 = 1100.0;
/// A row narrower than this has most of its buttons in a menu.
const NARROW: f32 = 960.0;
/// Room for the buttons after the search, and for one more.
const BUTTONS: f32 = 320.0;
const BUTTON: f32 = 120.0;

/// Shows the row in `rect`.
pub fn show(
    session: &mut Session,
    window: &mut Window,
    commands: &mut Vec<Command>,
    rect: Rect,
    ui: &mut Ui,
) {
    let mut ui = ui.new_child(
        egui::UiBuilder::new()
            .max_rect(rect.shrink2(egui::vec2(12.0, 4.0)))
            .layout(egui::Layout::left_to_right(egui::Align::Center)),
    );
    let ui = &mut ui;
    ui.set_clip_rect(rect.intersect(ui.clip_rect()));
    walk_buttons(session, commands, ui);
    ui.add_space(6.0);
    ui.label(style::strong(session.place(), 15.0));
    ui.add_space(6.0);
    if rect.width() > WIDE {
        speed(session, commands, ui);
        ui.add_space(6.0);
    }
    if rect.width() < NARROW {
        let more = ui.menu_button("…", |ui| {
            drawers(session, commands, ui);
            looping(session, commands, ui);
            run_to(session, commands, ui);
        });
        let name = session.localize(strings::MORE);
        let more = more.response.on_hover_text(name);
        more.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
        row_end(ui, |ui, room| search(session, window, room, commands, ui));
        return;
    }
    looping(session, commands, ui);
    run_to(session, commands, ui);
    row_end(ui, |ui, room| {
        let more = session.against().map_or(0.0, |_| BUTTON);
        search(session, window, room - BUTTONS - more, commands, ui);
        drawers(session, commands, ui);
    });
}

/// The row for fingers: what is needed most, and the rest in a menu.
pub fn show_narrow(
    session: &mut Session,
    window: &mut Window,
    commands: &mut Vec<Command>,
    rect: Rect,
    ui: &mut Ui,
) {
    let mut ui = ui.new_child(
        egui::UiBuilder::new()
            .max_rect(rect)
            .layout(egui::Layout::left_to_right(egui::Align::Center)),
    );
    let ui = &mut ui;
    ui.spacing_mut().item_spacing.x = 4.0;
    let [_, _, back, play, on, _, next] = walks(session);
    for walk in [back, play, on, next] {
        walk_button(session, walk, commands, ui);
    }
    let rest = row_end(ui, |ui, room| {
        let menu = egui::containers::menu::MenuButton::from_button(
            Button::new("…").min_size(egui::Vec2::splat(TARGET)),
        );
        // Whoever types into it goes on typing.
        let stays = PopupCloseBehavior::CloseOnClickOutside;
        let menu = menu.config(MenuConfig::new().close_behavior(stays));
        let (more, _) = menu.ui(ui, |ui| {
            search(session, window, room, commands, ui);
            let [start, before, .., after, _] = walks(session);
            ui.horizontal(|ui| {
                for walk in [start, before, after] {
                    walk_button(session, walk, commands, ui);
                }
            });
            drawers(session, commands, ui);
            looping(session, commands, ui);
            run_to(session, commands, ui);
        });
        let name = session.localize(strings::MORE);
        more.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
    });
    // There is no room for the words.
    let place = format!("{} / {}", session.step(), session.last_step());
    let label = egui::Label::new(style::strong(place, 13.0)).truncate();
    before_end(rest, ui, |ui| drop(ui.add(label)));
}

/// What opens beside the key panel.
fn drawers(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let mine = (Drawer::Against, strings::COMPARE, Command::Against);
    let mine = session.against().map(|_| mine);
    for (drawer, name, command) in mine.into_iter().chain([
        (Drawer::WhatIf, strings::WHAT_IF, Command::WhatIf),
        (Drawer::Parameters, strings::PARAMETERS, Command::Parameters),
        (Drawer::Inspector, strings::INSPECTOR, Command::Inspector),
    ]) {
        let name = session.localize(name);
        let chosen = session.look.drawer == Some(drawer);
        button(
            session,
            Button::new(name).selected(chosen),
            name,
            command,
            commands,
            ui,
        );
    }
}

/// A way to walk: its sign, what it does, and its name.
type Walk = (&'static str, Command, Message);

fn walks(session: &Session) -> [Walk; 7] {
    let playing = session.playing();
    let play = if playing == Some(Direction::Forward) {
        "‖"
    } else {
        "▶"
    };
    let back = if playing == Some(Direction::Backward) {
        Command::PlayBackwards
    } else {
        Command::Back(1)
    };
    [
        ("|◀", Command::Start, strings::AT_THE_START_NAME),
        ("◀◀", Command::PreviousScope, strings::PREVIOUS_SCOPE),
        ("◀", back, strings::ONE_BACK),
        (play, Command::Play, strings::PLAY),
        ("▶|", Command::Forward(1), strings::ONE_ON),
        ("▶▶", Command::NextScope, strings::NEXT_SCOPE),
        ("▶‖", Command::NextNarrated, strings::NEXT_SAID),
    ]
}

fn walk_buttons(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 4.0;
    for walk in walks(session) {
        walk_button(session, walk, commands, ui);
    }
    ui.spacing_mut().item_spacing.x = 8.0;
}

fn walk_button(
    session: &Session,
    (sign, command, name): Walk,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let sign = Button::new(RichText::new(sign).size(12.0)).min_size(egui::vec2(30.0, 24.0));
    button(session, sign, session.localize(name), command, commands, ui);
}

fn speed(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 6.0;
    let slower = session.localize(strings::SLOWER);
    button(
        session,
        Button::new("−"),
        slower,
        Command::Slower,
        commands,
        ui,
    );
    let language = session.look.language;
    let speed = language.number(session.speed());
    let speed = strings::STEPS_A_SECOND.format(language, &[("speed", &speed)]);
    ui.label(RichText::new(speed).size(13.0));
    button(
        session,
        Button::new("+"),
        session.localize(strings::FASTER),
        Command::Faster,
        commands,
        ui,
    );
    ui.spacing_mut().item_spacing.x = 8.0;
}

fn looping(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let end = |step: Option<usize>| step.map_or("…".to_owned(), |step| step.to_string());
    let text = match session.loop_ends() {
        (None, None) => format!("{} ▾", session.localize(strings::LOOP_OFF)),
        (from, to) => {
            let ends = [("from", &*end(from)), ("to", &*end(to))];
            format!("{} ▾", strings::LOOP.format(session.look.language, &ends))
        }
    };
    ui.menu_button(text, |ui| {
        let choices = [
            (strings::LOOP_FROM_HERE, Command::LoopFrom),
            (strings::LOOP_TO_HERE, Command::LoopTo),
            (strings::LOOP_OFF, Command::LoopOff),
            (strings::BREAKPOINT, Command::Breakpoint),
        ];
        for (strings, command) in choices {
            let strings = session.localize(strings);
            button(
                session,
                Button::new(strings),
                strings,
                command,
                commands,
                ui,
            );
        }
    });
}

/// A menu of the kinds of steps, with how many there are of each.
fn run_to(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let strings = format!("{} ▾", session.localize(strings::RUN_TO));
    ui.menu_button(strings, |ui| {
        let walk = session.walk();
        if walk.is_empty() {
            return;
        }
        let here = walk.kind(session.step());
        let language = session.look.language;
        let name = |kind| kind_name(kind, language);
        let next = strings::NEXT_OF_THIS_KIND.format(language, &[("kind", &name(here))]);
        if ui.button(RichText::new(next).strong()).clicked() {
            commands.push(Command::Find(here.to_owned()));
        }
        ui.separator();
        egui::ScrollArea::vertical()
            .max_height(320.0)
            .show(ui, |ui| {
                for (kind, count) in query::kinds(walk) {
                    if ui.button(format!("{}  ({count})", name(kind))).clicked() {
                        commands.push(Command::Find(kind.to_owned()));
                        ui.close();
                    }
                }
            });
    });
}

fn search(
    session: &mut Session,
    window: &mut Window,
    room: f32,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let hint = format!("/ {}", session.localize(strings::SEARCH));
    let edit = TextEdit::singleline(&mut window.search)
        // It keeps the focus where the row is laid out in another way meanwhile.
        .id(Id::unique("search"))
        .desired_width((room - 24.0).clamp(40.0, 200.0))
        .align(egui::Align2::LEFT_CENTER)
        .hint_text(hint);
    let response = ui
        .add(edit)
        .on_hover_text(session.localize(strings::SEARCH_HINT));
    let (name, text) = (session.localize(strings::SEARCH), window.search.clone());
    response.widget_info(|| egui::WidgetInfo {
        label: Some(name.to_owned()),
        ..egui::WidgetInfo::text_edit(true, "", &text, "")
    });
    if std::mem::take(&mut session.search_wanted) {
        // The key that asked must not be typed into the field.
        response.request_focus();
    }
    if response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
        let text = window.search.clone();
        let back = ui.input(|input| input.modifiers.shift);
        commands.push(if back {
            Command::FindBack(text)
        } else {
            Command::SearchFor(text)
        });
        // Enter again finds the next one.
        response.request_focus();
    }
}
