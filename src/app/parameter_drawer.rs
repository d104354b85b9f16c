//! The parameters that the lesson lets be changed, each with a slider and its value.

mod rail;

use super::button::button;
use super::layout::TARGET;
use super::session::{Command, Session};
use super::{arrow_focus, prose, strings, style};
use crate::language::{Language, Message};
use crate::lesson::{ByPath, Change, Kind, Parameter, PathValue, read_number};
use crate::panels::object_name;
use crate::picture::Ink;
use crate::scene::Movable;
use egui::{Button, DragValue, FontId, Rect, Response, RichText, Slider, Ui, WidgetInfo};
use glam::DVec3;
use rail::{Rail, distance};

const ROW: f32 = 28.0;
const MARGIN: f32 = 12.0;
/// Width of a parameter's name, of its number, and at least of its slider.
const NAME: f32 = 112.0;
const NUMBER: f32 = 72.0;
const RAIL: f32 = 60.0;

/// One place on the card.
#[derive(Clone, Copy)]
enum Cell {
    /// A slider.
    Value(Parameter),
    /// x, y and z.
    Place(Movable),
    /// One of several values.
    Choice(usize),
}

fn cells(session: &Session) -> Vec<Cell> {
    let parameters = session.lesson().parameters.iter();
    parameters
        .flat_map(|&parameter| {
            let place = match parameter {
                Parameter::Place(of) => Some(Cell::Place(of)),
                _ => None,
            };
            let first = match parameter {
                // Their distance from what the camera looks at says little.
                Parameter::Place(Movable::Object(_) | Movable::Vertex { .. }) => None,
                Parameter::ByPath(index) if options(session, index).is_some() => {
                    Some(Cell::Choice(index))
                }
                _ => Some(Cell::Value(parameter)),
            };
            first.into_iter().chain(place)
        })
        .collect()
}

/// Shows the parameters in `rect`, below each other, and the ways back to earlier values.
pub fn show(session: &Session, commands: &mut Vec<Command>, rect: Rect, ui: &mut Ui) {
    let mut ui =
        ui.new_child(egui::UiBuilder::new().max_rect(rect.shrink2(egui::vec2(MARGIN, 4.0))));
    let mut on_slider = false;
    let for_fingers = style::is_for_fingers(ui.ctx());
    let row = if for_fingers { TARGET } else { ROW };
    egui::ScrollArea::vertical().show(&mut ui, |ui| {
        ui.spacing_mut().item_spacing.y = 4.0;
        for (index, cell) in cells(session).into_iter().enumerate() {
            if let Cell::Place(of) = cell {
                ui.label(RichText::new(place_name(session, of)).size(13.0));
            }
            let (_, place) = ui.allocate_space(egui::vec2(ui.available_width(), row));
            let mut ui = ui.new_child(inside(place).id_salt(index));
            let change = match cell {
                Cell::Value(parameter) => value(session, parameter, &mut on_slider, &mut ui),
                Cell::Place(of) => coordinates(session, of, &mut ui),
                Cell::Choice(index) => choice(session, index, &mut ui),
            };
            commands.extend(change.map(Command::Change));
        }
        ui.horizontal_wrapped(|ui| {
            for (name, command) in [
                (strings::UNDO, Command::Undo),
                (strings::REDO, Command::Redo),
                (strings::LESSONS_VALUES, Command::LessonsValues),
            ] {
                let name = session.localize(name);
                let shown = Button::new(RichText::new(name).size(13.0));
                button(session, shown, name, command, commands, ui);
            }
        });
    });
    if on_slider {
        arrow_focus::claim(ui.ctx());
    }
}

fn inside(rect: Rect) -> egui::UiBuilder {
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    egui::UiBuilder::new().max_rect(rect).layout(layout)
}

/// A slider with its name, and what it changes.
fn value(
    session: &Session,
    parameter: Parameter,
    on_slider: &mut bool,
    ui: &mut Ui,
) -> Option<Change> {
    let rail = Rail::of(session, parameter)?;
    let name = name(session, parameter);
    let (_, place) = ui.allocate_space(egui::vec2(NAME, ROW));
    let text = prose::set(session, &name, FontId::proportional(13.0), Ink::Text);
    let label = egui::Label::new(text).truncate().selectable(false);
    ui.new_child(inside(place)).add(label);
    ui.spacing_mut().slider_width = (ui.available_width() - NUMBER).max(RAIL);
    let mut value = rail.value;
    let mut slider = Slider::new(&mut value, rail.range.clone())
        .logarithmic(rail.logarithmic)
        .clamping(egui::SliderClamping::Edits)
        .show_value(false);
    if rail.whole {
        slider = slider.step_by(1.0);
    }
    let response = ui.add(slider);
    let range = rail.in_words(session.look.language);
    named(&response, &name, rail.value, &range);
    *on_slider |= response.has_focus();
    if matches!(parameter, Parameter::Place(_)) {
        response.on_hover_text(session.localize(strings::FROM_THE_TARGET));
    }
    let speed = (0.01 * value).max(0.01);
    let number = DragValue::new(&mut value)
        .speed(if rail.whole { 0.1 } else { speed })
        .range(rail.range.clone())
        .clamp_existing_to_range(false)
        .max_decimals(if rail.whole { 0 } else { 3 });
    let response = ui.add(written(number, session.look.language));
    let as_number = strings::AS_A_NUMBER.format(session.look.language, &[("name", &name)]);
    named(&response, &as_number, rail.value, &range);
    let moved = value != rail.value;
    let change = moved.then(|| change_to(session, parameter, value));
    change.flatten()
}

fn by_path(session: &Session, index: usize) -> Option<&ByPath> {
    session.lesson().by_path.get(index)
}

/// The values that a parameter can have; none where it is a number.
fn options(session: &Session, index: usize) -> Option<impl Iterator<Item = &str>> {
    let language = session.look.language;
    match &by_path(session, index)?.kind {
        Kind::Choice(options) => Some(
            options
                .iter()
                .map(move |(_, name)| name.in_language(language)),
        ),
        Kind::Number { .. } => None,
    }
}

/// A list of the values that a parameter can have.
fn choice(session: &Session, parameter: usize, ui: &mut Ui) -> Option<Change> {
    let Some(Change::ByPath {
        value: PathValue::Option(now),
        ..
    }) = session.value(Parameter::ByPath(parameter))
    else {
        return None;
    };
    let name = name(session, Parameter::ByPath(parameter));
    let (_, place) = ui.allocate_space(egui::vec2(NAME, ROW));
    let label = egui::Label::new(RichText::new(&name).size(13.0));
    ui.new_child(inside(place))
        .add(label.truncate().selectable(false));
    let names: Vec<&str> = options(session, parameter)?.collect();
    let mut chosen = now;
    let list = egui::ComboBox::from_id_salt(parameter)
        .width((ui.available_width() - 8.0).max(RAIL))
        .truncate()
        .selected_text(names[now]);
    let response = list.show_ui(ui, |ui| {
        for (index, &name) in names.iter().enumerate() {
            ui.selectable_value(&mut chosen, index, name);
        }
    });
    let shown = names[now];
    response.response.widget_info(|| WidgetInfo {
        current_text_value: Some(shown.to_owned()),
        ..WidgetInfo::labeled(egui::Role::ComboBox, true, &name)
    });
    let value = PathValue::Option(chosen);
    (chosen != now).then_some(Change::ByPath { parameter, value })
}

/// What a screen reader says of it: its name, its value, and between what it moves in which unit.
fn named(response: &Response, name: &str, value: f64, range: &str) {
    response.widget_info(|| WidgetInfo::slider(true, value, name));
    let node = response.id;
    response
        .ctx
        .accesskit_node_builder(node, |node| node.set_description(range));
}

/// The parameter with the value of its slider. A light or the eye moves straight to or from what the camera looks at.
fn change_to(session: &Session, parameter: Parameter, value: f64) -> Option<Change> {
    let camera = session.lesson().scene.camera?;
    let along = |position: DVec3| {
        let away = (position - camera.target).try_normalize();
        camera.target + value * away.unwrap_or(camera.up.normalize_or_zero())
    };
    Some(match session.value(parameter)? {
        Change::ByPath { parameter, .. } => Change::ByPath {
            parameter,
            value: PathValue::Number(value),
        },
        Change::Place { of, position } => Change::Place {
            of,
            position: along(position),
        },
        Change::Coefficient {
            material,
            coefficient,
            ..
        } => Change::Coefficient {
            material,
            coefficient,
            value,
        },
        Change::Divisions { object, .. } => Change::Divisions {
            object,
            divisions: value.round() as u32,
        },
    })
}

/// x, y and z, to be dragged or typed.
fn coordinates(session: &Session, of: Movable, ui: &mut Ui) -> Option<Change> {
    let Change::Place { position, .. } = session.value(Parameter::Place(of))? else {
        return None;
    };
    let speed = 0.01 * distance(&session.lesson().scene, position).max(0.1);
    let who = place_name(session, of);
    let mut place = position;
    ui.spacing_mut().item_spacing.x = 4.0;
    for (axis, x) in ["x", "y", "z"].into_iter().zip(place.as_mut()) {
        let before = *x;
        ui.label(RichText::new(axis).size(13.0));
        let response = ui.add(written(
            DragValue::new(x).speed(speed).max_decimals(3),
            session.look.language,
        ));
        let unit = session.localize(strings::LENGTHS);
        named(&response, &format!("{who}, {axis}"), before, unit);
    }
    (place != position).then_some(Change::Place {
        of,
        position: place,
    })
}

/// Shows and reads the number as the language writes it.
pub(super) fn written(number: DragValue<'_>, language: Language) -> DragValue<'_> {
    number
        .custom_formatter(move |value, decimals| {
            language.typeset(&egui::emath::format_with_decimals_in_range(value, decimals))
        })
        .custom_parser(read_number)
}

/// What a parameter is called.
fn name(session: &Session, parameter: Parameter) -> String {
    let scene = &session.prepared().scene;
    let language = session.look.language;
    let distance = |thing: &str| strings::DISTANCE.format(language, &[("thing", thing)]);
    match parameter {
        Parameter::Place(of) => distance(&place_name(session, of)),
        Parameter::ByPath(index) => by_path(session, index).map_or_else(String::new, |parameter| {
            parameter.name.in_language(language).to_owned()
        }),
        Parameter::Coefficient(material, coefficient) => {
            format!(
                "{} {}",
                coefficient.symbol(),
                scene.called(&scene.materials[material].name, language)
            )
        }
        Parameter::Divisions(object) => {
            let object = scene.called(&scene.objects[object].name, language);
            strings::DIVISIONS.format(language, &[("object", object)])
        }
    }
}

/// What stands somewhere.
pub fn place_name(session: &Session, of: Movable) -> String {
    let language = session.look.language;
    let object = |object| object_name(session.prepared(), object as u32, language);
    match of {
        Movable::Eye => session.localize(strings::EYE).to_owned(),
        Movable::Light(_) if session.prepared().scene.lights.len() == 1 => {
            session.localize(strings::LIGHT).to_owned()
        }
        Movable::Light(light) => {
            Message("names-light").format(language, &[("number", &light.to_string())])
        }
        Movable::Object(number) => object(number).to_owned(),
        Movable::Vertex {
            object: number,
            vertex,
        } => {
            // As all that people read, counted from 1.
            let vertex = (vertex + 1).to_string();
            let names = [("vertex", &*vertex), ("object", object(number))];
            strings::VERTEX_OF.format(language, &names)
        }
    }
}
