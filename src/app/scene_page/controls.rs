//! Controls for what is selected in a scene, made from the scene's own schema: numbers, colours, places, choices, texts.

use super::super::parameter_drawer::written;
use super::super::{session::Session, strings, style};
use crate::picture::Ink;
use crate::scene::edit::Edit;
use crate::scene::scene_schema;
use egui::{Button, ComboBox, DragValue, RichText, TextEdit, Ui, WidgetInfo};
use serde_json::{Value, json};
use std::sync::LazyLock;

static SCHEMA: LazyLock<Value> = LazyLock::new(scene_schema);

/// Keys whose three numbers are a colour.
const COLORS: [&str; 10] = [
    "background",
    "ambient",
    "diffuse",
    "specular",
    "reflection",
    "transmission",
    "emission",
    "reflectance",
    "color",
    "colors",
];
/// Keys of which an entry has exactly one.
const KINDS: [&str; 8] = [
    "sphere",
    "plane",
    "polygon",
    "cylinder",
    "bezier",
    "mesh",
    "point",
    "directional",
];
/// Keys of the scene that the tree shows.
const IN_THE_TREE: [&str; 6] = [
    "camera",
    "materials",
    "objects",
    "lights",
    "schema",
    "$schema",
];
/// A longer list is edited as text.
const LONGEST: usize = 24;

/// Where in the document, under what key, and what it may be.
struct At {
    place: String,
    key: &'static str,
    schema: &'static Value,
}

/// Shows what the value at `place` has. Returns what was changed.
pub fn show(session: &Session, scene: &Value, place: &str, ui: &mut Ui) -> Option<Edit> {
    let (value, schema) = found(scene, place)?;
    let mut form = Form {
        session,
        scene,
        edit: None,
    };
    let at = At {
        place: place.into(),
        key: "",
        schema,
    };
    form.members(&at, value, ui);
    form.edit
}

/// A value that the tree shows, and its schema.
fn found<'a>(scene: &'a Value, place: &str) -> Option<(&'a Value, &'static Value)> {
    let properties = &SCHEMA["properties"];
    if place.is_empty() {
        return Some((scene, &SCHEMA));
    }
    if let Some(name) = place.strip_prefix("materials.") {
        let schema = resolved(&properties["materials"]["additionalProperties"]);
        return Some((scene["materials"].get(name)?, schema));
    }
    match place.split_once('[') {
        Some((key, index)) => {
            let index: usize = index.trim_end_matches(']').parse().ok()?;
            let schema = resolved(&properties[key]["items"]);
            Some((scene[key].get(index)?, schema))
        }
        None => Some((scene.get(place)?, resolved(&properties[place]))),
    }
}

/// What a reference refers to.
fn resolved(schema: &'static Value) -> &'static Value {
    let name = schema["$ref"]
        .as_str()
        .and_then(|path| path.rsplit('/').next());
    name.map_or(schema, |name| &SCHEMA["$defs"][name])
}

/// The least value that a schema allows, or nearly.
fn fresh(key: &str, schema: &'static Value) -> Value {
    let schema = resolved(schema);
    if let Some(Value::Array(choices)) = schema.get("enum") {
        return choices.first().cloned().unwrap_or_default();
    }
    if let Some(first) = schema["anyOf"].get(0).or(schema["oneOf"].get(0)) {
        return match first.get("const") {
            Some(constant) => constant.clone(),
            None if key == "patches" => json!(1),
            None => json!(0.5),
        };
    }
    match schema["type"].as_str() {
        Some("number") => json!(1),
        Some("integer") => json!(2),
        Some("boolean") => json!(true),
        Some("array") if key == "colors" => json!([[1, 1, 1], [0, 0, 0]]),
        Some("array") => json!([1, 0, 0]),
        Some("object") => {
            let required = schema["required"].as_array().into_iter().flatten();
            let members = required.filter_map(|name| {
                let name = name.as_str()?;
                Some((name.to_owned(), fresh(name, &schema["properties"][name])))
            });
            Value::Object(members.collect())
        }
        _ => json!(""),
    }
}

struct Form<'a> {
    session: &'a Session,
    scene: &'a Value,
    edit: Option<Edit>,
}

impl Form<'_> {
    fn set(&mut self, place: &str, value: Value) {
        self.edit = Some(Edit::Set(place.to_owned(), value));
    }

    /// The keys that an object has, and buttons for those that it could have.
    fn members(&mut self, at: &At, value: &Value, ui: &mut Ui) {
        let Some(properties) = at.schema["properties"].as_object() else {
            return;
        };
        let is_required = |key: &str| {
            let required = at.schema["required"].as_array();
            required.is_some_and(|keys| keys.iter().any(|known| known == key))
        };
        let mut missing = Vec::new();
        for (key, schema) in properties {
            if at.place.is_empty() && IN_THE_TREE.contains(&key.as_str()) {
                continue;
            }
            let Some(value) = value.get(key) else {
                if !KINDS.contains(&key.as_str()) {
                    missing.push((key, schema));
                }
                continue;
            };
            let dot = if at.place.is_empty() { "" } else { "." };
            let at = At {
                place: format!("{}{dot}{key}", at.place),
                key,
                schema: resolved(schema),
            };
            let can_go = !is_required(key) && !KINDS.contains(&key.as_str());
            self.member(&at, value, can_go, ui);
        }
        ui.horizontal_wrapped(|ui| {
            for (key, schema) in missing {
                let text = RichText::new(format!("+ {key}")).size(12.0);
                if ui.add(Button::new(text).small()).clicked() {
                    let value = fresh(key, resolved(schema));
                    self.edit = Some(Edit::Insert(at.place.clone(), key.clone(), value));
                }
            }
        });
    }
}

impl Form<'_> {
    /// A key with its control, and a way to leave it out where that is allowed.
    fn member(&mut self, at: &At, value: &Value, can_go: bool, ui: &mut Ui) {
        if at.schema["type"] == "object" {
            ui.horizontal(|ui| {
                ui.label(style::strong(at.key, 13.0));
                self.removal(at, can_go, ui);
            });
            ui.indent(&at.place, |ui| self.members(at, value, ui));
            return;
        }
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.label(RichText::new(at.key).size(13.0));
            self.control(at, value, ui);
            self.removal(at, can_go, ui);
        });
        if let Some(rows) = rows(value) {
            self.rows(at, rows, ui);
        }
    }

    fn removal(&mut self, at: &At, can_go: bool, ui: &mut Ui) {
        if !can_go {
            return;
        }
        let response = ui.add(Button::new(RichText::new("×").size(12.0)).small());
        let name = self.session.localize(strings::SCENE_LEAVE_OUT);
        let name = format!("{name}: {}", at.place);
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &name));
        if response.on_hover_text(&name).clicked() {
            self.edit = Some(Edit::Remove(at.place.clone()));
        }
    }

    fn control(&mut self, at: &At, value: &Value, ui: &mut Ui) {
        if let Some(numbers) = triple(value) {
            return self.numbers(&at.place, at.key, &numbers, false, ui);
        }
        match value {
            Value::Number(number) => {
                let whole = at.schema["type"] == "integer" || at.key == "patches";
                let number = [number.as_f64().unwrap_or(0.0)];
                self.numbers(&at.place, at.key, &number, whole, ui);
            }
            Value::Bool(now) => {
                let mut now = *now;
                let response = ui.checkbox(&mut now, "");
                response.widget_info(|| {
                    WidgetInfo::selected(egui::Role::CheckBox, true, now, &at.place)
                });
                if response.changed() {
                    self.set(&at.place, json!(now));
                }
            }
            Value::String(now) => self.text(at, now, ui),
            Value::Array(list) if rows(value).is_none() => {
                let counts: Option<Vec<f64>> = list.iter().map(Value::as_f64).collect();
                match counts {
                    Some(counts) if counts.len() <= 3 => {
                        self.numbers(&at.place, at.key, &counts, true, ui);
                    }
                    _ => drop(ui.label(self.session.localize(strings::SCENE_AS_TEXT))),
                }
            }
            _ => {}
        }
    }

    /// One number, or several as a list; a colour has a swatch too.
    fn numbers(&mut self, place: &str, key: &str, now: &[f64], whole: bool, ui: &mut Ui) {
        let mut numbers = now.to_vec();
        if let ([r, g, b], true) = (&mut numbers[..], COLORS.contains(&key)) {
            let mut color = [*r as f32, *g as f32, *b as f32];
            let response = ui.color_edit_button_rgb(&mut color);
            let language = self.session.look.language;
            let name = strings::SCENE_COLOR.format(language, &[("place", place)]);
            response.widget_info(|| WidgetInfo::labeled(egui::Role::ColorWell, true, &name));
            if response.changed() {
                // Three digits are as many as a swatch can be aimed at.
                let digits = |x: f32| f64::from((1000.0 * x).round()) / 1000.0;
                [*r, *g, *b] = color.map(digits);
            }
        }
        let count = numbers.len();
        for (index, number) in numbers.iter_mut().enumerate() {
            let speed = if whole {
                0.1
            } else {
                (0.01 * number.abs()).max(0.01)
            };
            let mut drag = DragValue::new(number).speed(speed);
            if whole {
                drag = drag.max_decimals(0);
            }
            let response = ui.add(written(drag, self.session.look.language));
            let name = match count {
                1 => place.to_owned(),
                _ => format!("{place}[{index}]"),
            };
            let value = now[index];
            response.widget_info(|| WidgetInfo::slider(true, value, &name));
        }
        if numbers != now {
            let list = |number: &f64| match whole {
                true => json!(number.round().max(0.0) as u64),
                false => json!(number),
            };
            let list: Vec<Value> = numbers.iter().map(list).collect();
            // A list of one is written as a number.
            let single = now.len() == 1;
            self.set(place, if single { list[0].clone() } else { json!(list) });
        }
    }

    fn text(&mut self, at: &At, now: &str, ui: &mut Ui) {
        let choices: Vec<&str> = match at.key {
            "material" => {
                let materials = self.scene["materials"].as_object();
                materials
                    .into_iter()
                    .flatten()
                    .map(|(name, _)| name.as_str())
                    .collect()
            }
            _ => choices(at.schema),
        };
        let mut chosen = now.to_owned();
        if choices.is_empty() {
            let edit = TextEdit::singleline(&mut chosen).desired_width(150.0);
            let response = ui.add(edit);
            let name = at.place.clone();
            let text = chosen.clone();
            response.widget_info(|| WidgetInfo {
                label: Some(name.clone()),
                ..WidgetInfo::text_edit(true, &text, &text, "")
            });
        } else {
            let list = ComboBox::from_id_salt(&at.place).selected_text(now);
            let response = list.show_ui(ui, |ui| {
                for choice in choices {
                    ui.selectable_value(&mut chosen, choice.to_owned(), choice);
                }
            });
            response.response.widget_info(|| WidgetInfo {
                current_text_value: Some(now.to_owned()),
                ..WidgetInfo::labeled(egui::Role::ComboBox, true, &at.place)
            });
        }
        if chosen != now {
            self.set(&at.place, json!(chosen));
        }
    }

    /// A list of places or colours, a row each.
    fn rows(&mut self, at: &At, rows: Vec<[f64; 3]>, ui: &mut Ui) {
        let count = rows.len();
        for (index, row) in rows.iter().enumerate() {
            ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 4.0;
                let muted = style::color(self.session.look.theme, Ink::Muted);
                ui.label(RichText::new(index.to_string()).size(12.0).color(muted));
                let place = format!("{}[{index}]", at.place);
                self.numbers(&place, at.key, row, false, ui);
                let row = At { place, ..*at };
                self.removal(&row, count > 2, ui);
            });
        }
        let response = ui.add(Button::new("+").small());
        let language = self.session.look.language;
        let name = strings::SCENE_ADD_TO.format(language, &[("place", &at.place)]);
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &name));
        if response.clicked() {
            let last = rows.last().copied().unwrap_or_default();
            self.edit = Some(Edit::Push(at.place.clone(), json!(last)));
        }
    }
}

fn triple(value: &Value) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    numbers?.try_into().ok()
}

/// A list of places or colours that is not too long.
fn rows(value: &Value) -> Option<Vec<[f64; 3]>> {
    let list = value
        .as_array()
        .filter(|list| (1..=LONGEST).contains(&list.len()))?;
    list.iter().map(triple).collect()
}

/// The texts that a schema allows; empty where it allows any.
fn choices(schema: &'static Value) -> Vec<&'static str> {
    let constants = schema["oneOf"].as_array().or(schema["anyOf"].as_array());
    let constants = constants
        .into_iter()
        .flatten()
        .filter_map(|one| one["const"].as_str());
    let listed = schema["enum"]
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_str);
    listed.chain(constants).collect()
}
