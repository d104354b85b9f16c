//! Pieces of a lesson file, as the window writes them: a new lesson, a step of it, a question.

use super::resolve::Lesson;
use crate::algorithms::focus::Focus;
use crate::language::Language;
use crate::panels::Panel;
use crate::record::{Fields, Value as Recorded};
use crate::replay::Query;
use crate::scene::edit::{Edit, written};
use serde_json::{Value, json};

/// A lesson that begins.
pub struct Draft<'a> {
    pub id: &'a str,
    pub number: u32,
    /// Of its texts.
    pub language: Language,
    pub title: &'a str,
    pub summary: &'a str,
    /// From the lesson's file.
    pub scene_file: &'a str,
    /// Whose method, size and panels it has.
    pub walk: &'a Lesson,
    pub focus: Focus,
    /// Its one explanation.
    pub step: Value,
}

impl Draft<'_> {
    /// The text of its file.
    pub fn text(&self) -> String {
        let panels: Vec<&str> = self.walk.panels.iter().map(|panel| panel.name()).collect();
        let members = [
            ("id", json!(self.id)),
            ("number", json!(self.number)),
            ("title", text(self.language, self.title)),
            ("summary", text(self.language, self.summary)),
            ("topics", json!([])),
            ("scene_file", json!(self.scene_file)),
            ("method", json!(self.walk.method.name())),
            ("size", json!(self.walk.size)),
            ("focus", focus(self.focus)),
            ("panels", json!(panels)),
        ];
        let members = members.map(|(key, value)| format!("  \"{key}\": {},\n", written(&value)));
        let step = written(&self.step);
        format!(
            "{{\n  \"schema\": 1,\n{}  \"steps\": [\n    {step}\n  ]\n}}\n",
            members.concat()
        )
    }
}

/// A text in one language.
pub fn text(language: Language, text: &str) -> Value {
    json!({ language.code(): text })
}

pub fn focus(focus: Focus) -> Value {
    match focus {
        Focus::Frame => json!("frame"),
        Focus::Polygon(number) => json!({ "polygon": number }),
        Focus::ScanLine(y) => json!({ "scan_line": y }),
        Focus::Pixel { x, y } => json!({ "pixel": [x, y] }),
        Focus::Iterations { start, end } => json!({ "iterations": [start, end] }),
        Focus::Patch(number) => json!({ "patch": number }),
        Focus::FormFactor { i, j } => json!({ "form_factor": [i, j] }),
    }
}

/// An explanation in one language.
pub fn step(at: &Query, language: Language, title: &str, say: &str, key: Option<Panel>) -> Value {
    let mut step = json!({
        "at": at.to_string(),
        "title": text(language, title),
        "say": text(language, say),
    });
    if let Some(key) = key {
        step["key"] = json!(key.name());
    }
    step
}

/// A question in one language, whose answer is read at another step.
pub fn question(at: &Query, language: Language, ask: &str, why: &str, answer: Value) -> Value {
    json!({
        "ask": text(language, ask),
        "at": at.to_string(),
        "answer": answer,
        "why": text(language, why),
    })
}

/// The kinds of answers that can be asked for where a step has recorded these values, each with its first answer.
pub fn answers(own: &Fields, language: Language) -> Vec<(&'static str, Value)> {
    let mut answers = Vec::new();
    if let Some((field, value)) = numbers(own).into_iter().next() {
        let tolerance = tolerance(value);
        let answer = json!({ "number": { "field": field, "tolerance": tolerance } });
        answers.push(("number", answer));
        // To three digits.
        let bound: f64 = format!("{value:.2e}").parse().unwrap_or(value);
        let option = |sign: &str| {
            let said = format!("{field} {sign} {}", language.number(bound));
            json!({ "text": text(language, &said), "when": format!("{field}{sign}{bound}") })
        };
        answers.push(("choice", json!({ "choice": [option(">="), option("<")] })));
    }
    let has = |name: &str| own.get(name).is_some();
    if has("x") && has("y") {
        answers.push(("pixel", json!({ "pixel": { "tolerance": 0 } })));
    }
    for field in ["object", "blocker", "i", "j"] {
        if has(field) && !answers.iter().any(|(kind, _)| *kind == "pick") {
            answers.push(("pick", json!({ "pick": { "field": field } })));
        }
    }
    if let Some(field) = vectors(own).first() {
        let answer = json!({ "arrow": { "field": field, "tolerance": 8 } });
        answers.push(("arrow", answer));
    }
    answers
}

/// The names of the numbers among these values, which a question can ask for.
pub fn numbers(own: &Fields) -> Vec<(&'static str, f64)> {
    let number = |value| match value {
        Recorded::Number(number) => Some(number),
        Recorded::Rgb(color) if color.is_grey() => Some(color.r),
        _ => None,
    };
    let numbers = own
        .iter()
        .filter_map(|field| Some((field.name, number(field.value)?)));
    numbers.filter(|(_, number)| number.is_finite()).collect()
}

/// The names of the directions among them.
pub fn vectors(own: &Fields) -> Vec<&'static str> {
    let unit = own.iter().filter(|field| match field.value {
        Recorded::Vector(vector) => (vector.length() - 1.0).abs() < 1e-6,
        _ => false,
    });
    unit.map(|field| field.name).collect()
}

/// A hundredth of a value, as a power of ten.
fn tolerance(value: f64) -> f64 {
    let power = (0.01 * value.abs()).max(1e-6).log10().floor() as i32;
    format!("1e{power}").parse().unwrap_or(0.01)
}

impl Lesson {
    /// The text of its file under another id and number; none where it is from no file, or names others.
    pub fn copied(&self, id: &str, number: u32) -> Option<String> {
        let text = String::from_utf8(self.text.as_ref()?.to_vec()).ok()?;
        let value: Value = serde_json::from_str(&text).ok()?;
        let objects = value["scene"]["objects"].as_array()?;
        if objects.iter().any(|object| object["mesh"].is_object()) {
            return None;
        }
        let text = Edit::Set("id".into(), json!(id)).of(&text)?;
        Edit::Set("number".into(), json!(number)).of(&text)
    }
}
