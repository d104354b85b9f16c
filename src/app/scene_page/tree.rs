//! What a scene has, as a tree; and what can be added to it, copied and deleted.

use super::super::document::Document;
use super::super::{session::Session, strings, style};
use crate::language::Message;
use crate::picture::Ink;
use crate::scene::edit::Edit;
use egui::{Button, RichText, Ui};
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// A list of the scene: its heading, its key, and what can be added to it.
const LISTS: [(Message, &str, &[&str]); 3] = [
    (strings::SCENE_MATERIALS, "materials", &["material"]),
    (
        strings::SCENE_OBJECTS,
        "objects",
        &["sphere", "plane", "polygon", "cylinder"],
    ),
    (strings::SCENE_LIGHTS, "lights", &["point", "directional"]),
];

/// Shows the tree; a click selects. Returns what was added, copied or deleted.
pub fn show(session: &Session, document: &mut Document, ui: &mut Ui) -> Option<Edit> {
    let mut edit = None;
    row(document, "", session.localize(strings::SCENE_WHOLE), ui);
    row(
        document,
        "camera",
        session.localize(strings::SCENE_CAMERA),
        ui,
    );
    for (title, key, kinds) in LISTS {
        ui.horizontal(|ui| {
            ui.label(style::strong(session.localize(title), 13.0));
            let muted = style::color(session.look.theme, Ink::Muted);
            ui.menu_button(RichText::new("+").color(muted), |ui| {
                for kind in kinds {
                    if ui.button(*kind).clicked() {
                        edit = Some(addition(&document.value, key, kind));
                        ui.close();
                    }
                }
            })
            .response
            .widget_info(|| {
                let language = session.look.language;
                let name = strings::SCENE_ADD_TO.format(language, &[("place", key)]);
                egui::WidgetInfo::labeled(egui::Role::Button, true, name)
            });
        });
        for (place, name) in entries(&document.value, key) {
            row(document, &place, &name, ui);
        }
    }
    ui.separator();
    let is_entry = LISTS.iter().any(|(_, key, _)| {
        entries(&document.value, key)
            .iter()
            .any(|(place, _)| *place == document.selected)
    });
    ui.horizontal(|ui| {
        let copy = Button::new(session.localize(strings::SCENE_COPY));
        if ui.add_enabled(is_entry, copy).clicked() {
            edit = copied(&document.value, &document.selected);
        }
        let delete = Button::new(session.localize(strings::SCENE_DELETE));
        if ui.add_enabled(is_entry, delete).clicked() {
            edit = Some(Edit::Remove(document.selected.clone()));
        }
    });
    edit
}

fn row(document: &mut Document, place: &str, name: &str, ui: &mut Ui) {
    let chosen = document.selected == place;
    let button = Button::new(name)
        .selected(chosen)
        .frame_when_inactive(false);
    if ui.add(button.truncate()).clicked() {
        document.selected = place.to_owned();
    }
}

/// The paths and names of a list's entries.
fn entries(scene: &Value, key: &str) -> Vec<(String, String)> {
    match &scene[key] {
        Value::Object(members) => {
            let members = members.keys();
            members
                .map(|name| (format!("{key}.{name}"), name.clone()))
                .collect()
        }
        Value::Array(list) => {
            let name = |(index, entry): (usize, &Value)| {
                let kind = entry.as_object().and_then(|members| members.keys().next());
                let kind = kind.map_or("?", String::as_str);
                let name = entry["name"].as_str().map(str::to_owned);
                let name = name.unwrap_or_else(|| format!("{} {kind}", index + 1));
                (format!("{key}[{index}]"), name)
            };
            list.iter().enumerate().map(name).collect()
        }
        _ => Vec::new(),
    }
}

/// `name`, or where that is taken, with a number behind it.
fn free_name(scene: &Value, key: &str, name: &str) -> String {
    let taken: BTreeSet<String> = entries(scene, key)
        .into_iter()
        .map(|(_, name)| name)
        .collect();
    let numbered = (2..).map(|number| format!("{name}-{number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    names.find(|name| !taken.contains(name)).unwrap_or_default()
}

/// A new entry, an object where the camera looks.
fn addition(scene: &Value, key: &str, kind: &str) -> Edit {
    let target = scene["camera"]["target"].clone();
    let target = if target.is_array() {
        target
    } else {
        json!([0, 0, 0])
    };
    if key == "materials" {
        let name = free_name(scene, key, kind);
        let new = json!({ "diffuse": [0.6, 0.6, 0.6] });
        return match scene[key].is_object() {
            true => Edit::Insert(key.into(), name, new),
            false => Edit::Insert(String::new(), key.into(), json!({ name: new })),
        };
    }
    let of_kind = match kind {
        "sphere" => json!({ "center": target, "radius": 0.5 }),
        "plane" => json!({ "point": target, "normal": [0, 1, 0] }),
        "cylinder" => json!({ "base": target, "axis": [0, 1, 0], "radius": 0.5, "height": 1 }),
        "polygon" => {
            let at = |x: f64, y: f64| {
                let place: Vec<f64> = (0..3).map(|i| target[i].as_f64().unwrap_or(0.0)).collect();
                json!([place[0] + x, place[1] + y, place[2]])
            };
            json!({ "vertices": [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)] })
        }
        "point" => {
            json!({ "position": scene["camera"]["eye"].as_array().map_or(json!([0, 5, 5]), |eye| json!(eye)) })
        }
        _ => json!({ "toward": [0, -1, 0] }),
    };
    let new = match key {
        "objects" => {
            let material = entries(scene, "materials").into_iter().next();
            let material = material.map_or(String::new(), |(_, name)| name);
            json!({ "name": free_name(scene, key, kind), "material": material, kind: of_kind })
        }
        _ => json!({ kind: of_kind }),
    };
    match scene[key].is_array() {
        true => Edit::Push(key.into(), new),
        false => Edit::Insert(String::new(), key.into(), json!([new])),
    }
}

/// The entry once more, under a name of its own.
fn copied(scene: &Value, place: &str) -> Option<Edit> {
    if let Some(name) = place.strip_prefix("materials.") {
        let new = free_name(scene, "materials", name);
        return Some(Edit::Insert(
            "materials".into(),
            new,
            scene["materials"][name].clone(),
        ));
    }
    let (key, index) = place.strip_suffix(']')?.split_once('[')?;
    let mut new = scene[key][index.parse::<usize>().ok()?].clone();
    if let Some(name) = new["name"].as_str() {
        new["name"] = free_name(scene, key, name).into();
    }
    Some(Edit::Push(key.into(), new))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_has_a_name_of_its_own() {
        let scene = json!({ "materials": { "red": {}, "red-2": {} },
            "objects": [{ "name": "ball", "sphere": {} }], "lights": [{ "point": {} }] });
        for (place, expected) in [
            (
                "materials.red",
                Edit::Insert("materials".into(), "red-3".into(), json!({})),
            ),
            (
                "objects[0]",
                Edit::Push("objects".into(), json!({ "name": "ball-2", "sphere": {} })),
            ),
            (
                "lights[0]",
                Edit::Push("lights".into(), json!({ "point": {} })),
            ),
        ] {
            assert_eq!(copied(&scene, place), Some(expected));
        }
        assert_eq!(copied(&scene, "camera"), None);
    }

    /// Whatever can be added to the least of scenes is right.
    #[test]
    fn every_addition_is_a_right_scene() {
        let least = r#"{ "schema": 1, "materials": { "red": {} }, "objects": [] }"#;
        for (_, key, kinds) in LISTS {
            for kind in kinds {
                let scene = serde_json::from_str(least).unwrap();
                let text = addition(&scene, key, kind).of(least).expect("a place");
                let limits = crate::scene::Limits::default();
                let read = crate::scene::read(text.as_bytes(), &limits, &mut |_| unreachable!());
                assert!(read.is_ok(), "{text}: {read:?}");
            }
        }
    }
}
