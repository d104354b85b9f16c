//! The form of the lesson as a whole: what it is called, its panels, its part of the run, and what a student may change.

use super::form::Form;
use super::strings;
use crate::language::Message;
use crate::lesson::draft;
use crate::panels::Panel;
use crate::scene::Movable;
use crate::scene::edit::Edit;
use egui::{RichText, Ui};
use serde_json::{Value, json};

pub fn show(form: &mut Form, ui: &mut Ui) {
    form.text(strings::TITLE, "", "title", 1, ui);
    form.text(strings::SUMMARY, "", "summary", 2, ui);
    form.text(strings::RECAP, "", "recap", 3, ui);
    form.line(strings::ID, "", "id", ui);
    chapter(form, ui);
    topics(form, ui);
    part(form, ui);
    panels(form, ui);
    parameters(form, ui);
}

fn chapter(form: &mut Form, ui: &mut Ui) {
    let none = (None, form.localize(strings::NO_CHAPTER).to_owned());
    let named = super::super::strings::CHAPTERS.map(|(chapter, title)| {
        (
            Some(chapter.name().to_owned()),
            form.localize(title).to_owned(),
        )
    });
    let options: Vec<_> = std::iter::once(none).chain(named).collect();
    form.choice(strings::CHAPTER, "", "chapter", &options, ui);
}

/// Search words, with commas between them.
fn topics(form: &mut Form, ui: &mut Ui) {
    let list = form.at("topics").as_array();
    let topics: Vec<&str> = list
        .into_iter()
        .flatten()
        .filter_map(Value::as_str)
        .collect();
    let now = topics.join(", ");
    let mut typed = now.clone();
    let name = form.localize(strings::TOPICS);
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).size(13.0));
        let edit = egui::TextEdit::singleline(&mut typed).desired_width(f32::INFINITY);
        super::form::named(&ui.add(edit), name, &now);
    });
    if typed != now {
        let topics: Vec<&str> = typed.split(',').map(str::trim_start).collect();
        form.set("", "topics", Some(json!(topics)));
    }
}

/// The part that is recorded, and the one that is shown in its place.
fn part(form: &mut Form, ui: &mut Ui) {
    let session = form.session;
    form.heading(form.localize(strings::PART), ui);
    let now = session.focus_in_words(session.lesson().focus);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(now).size(13.0));
        let same = session.follows_lesson();
        let refused = same.then(|| form.localize(strings::PART_AS_IT_IS));
        if form.button(strings::TAKE_PART, refused, ui) {
            form.set("", "focus", Some(draft::focus(session.focus())));
        }
    });
}

fn panels(form: &mut Form, ui: &mut Ui) {
    form.heading(form.localize(strings::PANELS), ui);
    let list = form.at("panels").as_array();
    let now: Vec<String> = list
        .into_iter()
        .flatten()
        .filter_map(|name| name.as_str().map(str::to_owned))
        .collect();
    let offered = Panel::ALL
        .into_iter()
        .filter(|panel| !panel.compares() && !BESIDE.contains(&panel.name()));
    ui.horizontal_wrapped(|ui| {
        for panel in offered {
            let mut shown = now.iter().any(|name| name == panel.name());
            let was = shown;
            ui.checkbox(&mut shown, form.localize(panel.title()));
            let mut panels = now.clone();
            match (was, shown) {
                (false, true) => panels.push(panel.name().to_owned()),
                (true, false) => panels.retain(|name| name != panel.name()),
                _ => continue,
            }
            form.set("", "panels", Some(json!(panels)));
        }
    });
}

/// What stands in the window anyway.
const BESIDE: [&str; 4] = ["code", "formula", "time-line", "inspector"];

/// What a student may change, and what more could be.
fn parameters(form: &mut Form, ui: &mut Ui) {
    form.heading(form.localize(strings::PARAMETERS), ui);
    let list = form.at("parameters").as_array();
    let now: Vec<Value> = list.into_iter().flatten().cloned().collect();
    for (index, parameter) in now.iter().enumerate() {
        ui.horizontal(|ui| {
            ui.label(RichText::new(called(form, parameter)).size(13.0));
            ui.push_id(index, |ui| {
                if form.button(strings::NO_PARAMETER, None, ui) {
                    form.edits
                        .push(Edit::Remove(format!("parameters[{index}]")));
                }
            });
        });
    }
    let offered: Vec<Value> = possible(form)
        .into_iter()
        .filter(|parameter| !now.contains(parameter))
        .collect();
    ui.menu_button(form.localize(strings::ONE_MORE), |ui| {
        for parameter in offered {
            if ui.button(called(form, &parameter)).clicked() {
                match form.at("parameters").is_null() {
                    true => form.set("", "parameters", Some(json!([parameter]))),
                    false => form.edits.push(Edit::Push("parameters".into(), parameter)),
                }
                ui.close();
            }
        }
    });
}

/// Everything of the scene that a lesson can let be changed by its name.
fn possible(form: &Form) -> Vec<Value> {
    let scene = &form.session.lesson().scene;
    let mut found = vec![json!("eye")];
    for light in 0..scene.lights.len() {
        if Movable::Light(light).position(scene).is_some() {
            found.push(json!({ "light": light }));
        }
    }
    for (index, object) in scene.objects.iter().enumerate() {
        if Movable::Object(index).position(scene).is_some() {
            found.push(json!({ "object": object.name }));
        }
    }
    for material in &scene.materials {
        for coefficient in ["ambient", "diffuse", "specular", "shininess"] {
            found.push(json!({ coefficient: material.name }));
        }
    }
    found
}

/// A parameter in words.
fn called(form: &Form, parameter: &Value) -> String {
    let language = form.session.look.language;
    let members = parameter
        .as_object()
        .and_then(|members| members.iter().next());
    let Some((kind, of)) = members else {
        return form.localize(strings::EYE).to_owned();
    };
    let named = |message: Message| {
        let of = of.as_str().map_or_else(|| of.to_string(), str::to_owned);
        message.format(language, &[("of", &of)])
    };
    match kind.as_str() {
        "light" => named(strings::LIGHT),
        "object" => named(strings::OBJECT),
        "ambient" => named(strings::AMBIENT),
        "diffuse" => named(strings::DIFFUSE),
        "specular" => named(strings::SPECULAR),
        "shininess" => named(strings::SHININESS),
        _ => {
            let name = of["name"][language.code()].as_str();
            name.unwrap_or(kind).to_owned()
        }
    }
}
