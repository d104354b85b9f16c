//! The bar on top: which lesson this is, and how things are shown.

use super::button::button;
use super::layout::{BAR, TARGET};
use super::prose::prose;
use super::row_end::row_end;
use super::session::{Choice, Command, Drawer, Session, Sheet, StudyCommand};
use super::{author_strings, strings, style, take_away_menu};
use crate::language::{Language, Message};
use crate::methods::Method;
use crate::panels::method_name;
use crate::picture::{Ink, Theme};
use egui::containers::menu::MenuButton;
use egui::{Button, Color32, Frame, Margin, RichText, ScrollArea, Ui, Vec2};

const THEMES: [(Theme, Message); 3] = [
    (Theme::Light, strings::THEME_LIGHT),
    (Theme::Dark, strings::THEME_DARK),
    (Theme::Projector, strings::THEME_PROJECTOR),
];

/// A bar with less room than this beside the lessons' buttons has presentation and sharing in the menu alone.
const WIDE: f32 = 560.0;

pub fn height(ctx: &egui::Context) -> f32 {
    match style::is_for_fingers(ctx) {
        true => TARGET,
        false => BAR,
    }
}

pub fn show(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let margin = match style::is_for_fingers(ui.ctx()) {
        true => 4,
        false => 16,
    };
    let frame = Frame::new()
        .fill(style::BAR)
        .inner_margin(Margin::symmetric(margin, 0));
    let bar = egui::Panel::top("bar")
        .exact_size(height(ui.ctx()))
        .frame(frame)
        .show_separator_line(false);
    bar.show(ui, |ui| {
        dress(ui);
        if style::is_for_fingers(ui.ctx()) {
            return for_fingers(session, commands, ui);
        }
        ui.horizontal_centered(|ui| {
            ui.label(style::strong("Lightwalk", 17.0).color(Color32::WHITE));
            ui.add_space(4.0);
            lessons(session, commands, ui);
            let rest = row_end(ui, |ui, room| {
                at_the_right(session, room >= WIDE, commands, ui);
            });
            if !session.look.home && !session.look.mistakes {
                title(session, rest, ui);
            }
        });
    });
}

/// The way to the lessons, the title, and all else in the menu.
fn for_fingers(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let name = session.localize(strings::LESSONS);
        let home = Button::new(name).selected(session.look.home);
        button(session, home, name, Command::Home, commands, ui);
        let rest = row_end(ui, |ui, _| settings(session, commands, ui));
        if session.look.home || session.look.mistakes {
            return;
        }
        if session.lesson().is_free_walk() {
            methods(session, commands, ui);
        } else {
            title(session, rest, ui);
        }
    });
}

/// Languages, presentation, settings and keys.
fn at_the_right(session: &Session, wide: bool, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 2.0;
    languages(session, commands, ui);
    ui.spacing_mut().item_spacing.x = 8.0;
    ui.add_space(8.0);
    if wide && !session.look.home && !session.look.mistakes {
        for (name, command) in [
            (strings::PRESENT, Command::Present),
            (strings::SHARE, Command::Share),
        ] {
            let name = session.localize(name);
            button(session, Button::new(name), name, command, commands, ui);
        }
    }
    settings(session, commands, ui);
    let keys = session.localize(strings::KEYS);
    button(session, Button::new("?"), keys, Command::Keys, commands, ui);
}

fn languages(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    for language in Language::ALL {
        let chosen = session.look.language == language;
        let text = RichText::new(language.code().to_uppercase()).strong();
        if chip(text, chosen, ui).clicked() {
            commands.push(Command::Speak(language));
        }
    }
}

/// The lesson's title in what is left of the bar.
fn title(session: &Session, rest: egui::Rect, ui: &mut Ui) {
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let mut ui = ui.new_child(egui::UiBuilder::new().max_rect(rest).layout(layout));
    let title = RichText::new(session.title())
        .size(15.0)
        .color(style::BAR_TEXT);
    let summary = session.lesson().summary.in_language(session.look.language);
    ui.add(egui::Label::new(title).truncate())
        .on_hover_text(prose(session, summary, 13.0, Ink::Text));
}

/// The colours of the bar, which are the same in every theme.
fn dress(ui: &mut Ui) {
    let visuals = ui.visuals_mut();
    let fills = [
        (&mut visuals.widgets.inactive, style::BAR_BUTTON),
        (
            &mut visuals.widgets.hovered,
            style::BAR_BUTTON.gamma_multiply(1.4),
        ),
        (&mut visuals.widgets.active, style::BAR_CHOSEN),
        (&mut visuals.widgets.open, style::BAR_BUTTON),
        (&mut visuals.widgets.noninteractive, style::BAR),
    ];
    for (widget, fill) in fills {
        widget.bg_fill = fill;
        widget.weak_bg_fill = fill;
        widget.bg_stroke = egui::Stroke::NONE;
        widget.fg_stroke.color = style::BAR_TEXT;
    }
    visuals.selection.bg_fill = style::BAR_CHOSEN;
    visuals.selection.stroke = egui::Stroke::new(1.0, Color32::WHITE);
}

/// A small button that is one choice of several.
fn chip(text: RichText, chosen: bool, ui: &mut Ui) -> egui::Response {
    ui.add(Button::new(text).selected(chosen))
}

/// The page of all lessons, and the neighbours of this one.
fn lessons(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let name = session.localize(strings::LESSONS);
    let home = Button::new(name).selected(session.look.home);
    button(session, home, name, Command::Home, commands, ui);
    if session.look.home || session.look.mistakes {
        let name = session.localize(strings::MISTAKES);
        let page = Button::new(name).selected(session.look.mistakes);
        button(session, page, name, Command::Mistakes, commands, ui);
        return;
    }
    if session.lesson().is_free_walk() {
        methods(session, commands, ui);
        let name = session.localize(strings::EDIT);
        let edit = Button::new(name).selected(session.look.editing);
        button(session, edit, name, Command::EditScene, commands, ui);
        return write(session, commands, ui);
    }
    neighbours(session, commands, ui);
}

fn neighbours(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    for (sign, name, command) in [
        ("◀", strings::PREVIOUS_LESSON, Command::PreviousLesson),
        ("▶", strings::NEXT_LESSON, Command::NextLesson),
    ] {
        let name = session.localize(name);
        let sign = RichText::new(sign).size(11.0);
        button(session, Button::new(sign), name, command, commands, ui);
    }
    if session.file.is_some() {
        write(session, commands, ui);
    }
}

/// The drawer in which a lesson is written.
fn write(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let name = session.localize(author_strings::WRITE);
    let write = Button::new(name).selected(session.look.drawer == Some(Drawer::Author));
    button(session, write, name, Command::Author, commands, ui);
}

/// The methods by which a scene can be walked through.
fn methods(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let language = session.look.language;
    let now = method_name(session.lesson().method, language);
    let menu = MenuButton::new(format!("{now} ▾"));
    let (response, _) = menu.ui(ui, |ui| {
        undress(ui);
        for method in Method::ALL {
            let name = method_name(method, language);
            let choose = Command::Method(method);
            button(session, Button::new(&name), &name, choose, commands, ui);
        }
    });
    let name = session.localize(strings::METHOD);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
    response.on_hover_text(name);
}

/// Files and folders of one's own. A page has no folders.
fn open(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    for (name, choice) in [
        (strings::OPEN_FILE, Choice::File),
        (strings::OPEN_FOLDER, Choice::Folder),
    ] {
        if choice == Choice::File || !cfg!(target_arch = "wasm32") {
            let name = session.localize(name);
            let choose = Command::Choose(choice);
            button(session, Button::new(name), name, choose, commands, ui);
        }
    }
}

/// Files, themes, text size, questions; what a narrow bar has no room for is in here too.
fn settings(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let for_fingers = style::is_for_fingers(ui.ctx());
    let menu = match for_fingers {
        true => MenuButton::from_button(Button::new("☰").min_size(Vec2::splat(TARGET))),
        false => MenuButton::new("☰"),
    };
    let around = if for_fingers { 2.0 * TARGET } else { 16.0 };
    let room = ui.ctx().content_rect().height() - around;
    let mut entries = |ui: &mut Ui| {
        undress(ui);
        ui.set_min_width(200.0);
        if for_fingers {
            ui.horizontal(|ui| {
                languages(session, commands, ui);
                if !session.is_on_page() && !session.lesson().is_free_walk() {
                    neighbours(session, commands, ui);
                }
            });
            ui.separator();
        }
        open(session, commands, ui);
        ui.separator();
        ui.label(style::strong(session.localize(strings::THEME), 13.0));
        for (theme, name) in THEMES {
            if ui
                .add(Button::new(session.localize(name)).selected(session.look.theme == theme))
                .clicked()
            {
                commands.push(Command::Theme(theme));
            }
        }
        ui.separator();
        ui.label(style::strong(session.localize(strings::TEXT_SIZE), 13.0));
        ui.horizontal(|ui| {
            for (sign, command) in [
                ("−", Command::SmallerText),
                ("100 %", Command::NormalText),
                ("+", Command::LargerText),
            ] {
                let name = strings::TEXT_SIZE_TO.format(session.look.language, &[("size", sign)]);
                button(session, Button::new(sign), &name, command, commands, ui);
            }
        });
        ui.separator();
        let mut asks = session.look.questions;
        if ui
            .checkbox(&mut asks, session.localize(strings::QUESTIONS))
            .clicked()
        {
            commands.push(Command::Questions);
        }
        ui.separator();
        if !session.is_on_page() {
            take_away_menu::show(session, commands, ui);
            ui.separator();
        }
        let studies = session.localize(strings::STUDIES);
        let view = Command::Study(StudyCommand::View);
        button(session, Button::new(studies), studies, view, commands, ui);
        for (strings, command) in [
            (strings::PRESENT, Command::Present),
            (strings::SHARE, Command::Share),
            (author_strings::WRITE, Command::Author),
            (strings::LEFT_OUT, Command::Skipped),
            (strings::MISTAKES, Command::Mistakes),
            (strings::COMPARE, Command::Against),
            (strings::SAVE_PROGRESS, Command::SaveProgress),
            (strings::LOAD_PROGRESS, Command::Choose(Choice::File)),
            (strings::FORGET, Command::Sheet(Sheet::Forget)),
        ] {
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
    };
    let (response, _) = menu.ui(ui, |ui| {
        style::beside_scroll_bar(ui);
        let scrolls = ScrollArea::vertical().max_height(room);
        scrolls.show(ui, |ui| entries(ui)).inner
    });
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Button, true, session.localize(strings::MENU))
    });
    response.on_hover_text(session.localize(strings::MENU));
}

/// Menus look as the rest of the window does.
fn undress(ui: &mut Ui) {
    let style = ui.ctx().global_style();
    ui.set_style(style);
}
