//! The angles with the normal, and what each light's shadow ray found, as a list.

use super::super::names;
use super::super::values::short;
use super::super::words::{Language, Words};
use super::met::SurfaceInSight;
use crate::picture::{Ink, Picture, Rect, Style, Tag, elide};
use crate::record::Value;
use glam::DVec3;

const LINE: f32 = 1.45;
const ANGLES: Words = Words::new("angle with N", "sudut dengan N");
const BLOCKED: Words = Words::new("blocked by", "terhalang");
const ARRIVES: Words = Words::new("arrives", "sampai");
const AWAY: Words = Words::new("behind the surface", "di balik permukaan");
const LEANS: Words = Words::new("out of the plane", "keluar bidang");
const TOTAL: Words = Words::new("total internal reflection", "pantulan internal total");
const CRITICAL: Words = Words::new("critical", "kritis");

/// A line of the list: a symbol, a number, and what is to be said of it.
struct Row {
    symbol: String,
    value: String,
    note: String,
    ink: Ink,
    tag: Tag,
    /// The kind of step that tells it.
    told_by: &'static str,
}

pub(super) struct Angles {
    title: String,
    rows: Vec<Row>,
}

fn degrees(radians: f64) -> String {
    format!("{}°", short(Value::Number(radians.to_degrees()), 1))
}

fn row(symbol: &str, radians: f64, tag: &'static str, told_by: &'static str) -> Row {
    Row {
        symbol: symbol.to_string(),
        value: degrees(radians),
        note: String::new(),
        ink: Ink::Muted,
        tag: Tag::Field(tag),
        told_by,
    }
}

impl Angles {
    pub fn of(surface: &SurfaceInSight, language: Language) -> Self {
        let words = |words: Words| words.in_language(language);
        let mut rows = Vec::new();
        if let Some((_, cosine, _)) = surface.surface.facing {
            rows.push(row(
                "θ_i",
                cosine.min(1.0).acos(),
                "theta_i_degrees",
                "Faced",
            ));
        }
        if let Some(refraction) = surface.ray.refraction {
            if refraction.radicand >= 0.0 {
                let angle = refraction.radicand.sqrt().min(1.0).acos();
                rows.push(row("θ_r", angle, "theta_r_degrees", "Refraction"));
            }
            if refraction.eta_i > refraction.eta_r {
                let angle = (refraction.eta_r / refraction.eta_i).asin();
                let note = if refraction.radicand < 0.0 {
                    words(TOTAL)
                } else {
                    words(CRITICAL)
                };
                rows.push(Row {
                    note: note.to_string(),
                    ..row("θ_c", angle, "theta_c_degrees", "Refraction")
                });
            }
        }
        rows.extend(lights(surface, language));
        Angles {
            title: format!("{} · {}", surface.name(), words(ANGLES)),
            rows,
        }
    }

    pub fn width(&self, text: f32) -> f32 {
        let style = Style::Label.size(text);
        let row = |row: &Row| 6.2 * text + style.width(&row.note);
        let rows = self.rows.iter().map(row).fold(0.0, f32::max);
        rows.max(Style::Bold.size(text).width(&self.title)) + 4.0
    }

    pub fn height(&self, text: f32) -> f32 {
        (self.rows.len() + 1) as f32 * LINE * text
    }

    /// As many rows as there is room for, from the top.
    pub fn draw(&self, picture: &mut Picture, kind: &str, text: f32, area: Rect) {
        let line = LINE * text;
        let room = (area.height / line) as usize;
        let count = (self.rows.len() + 1).min(room);
        let top = area.y + 0.5 * (area.height - count as f32 * line);
        let place = |i: usize| Rect::new(area.x, top + i as f32 * line, area.width, line);
        if room == 0 {
            return;
        }
        let title = elide(&self.title, Style::Bold, text, area.width);
        picture.text_in(place(0), title, Style::Bold.size(text));
        for (i, row) in self.rows.iter().enumerate().take(count - 1) {
            let place = place(i + 1);
            let here = row.told_by.split(' ').any(|told_by| told_by == kind);
            let ink = if here { Ink::This } else { Ink::Text };
            picture.tagged(row.tag, |picture| {
                let symbol = Style::LabelBold.size(text).ink(row.ink);
                picture.text_in(place, row.symbol.as_str(), symbol);
                let value = Rect {
                    x: place.x + 2.2 * text,
                    ..place
                };
                let style = Style::Label.size(text).ink(ink);
                picture.text_in(value, row.value.as_str(), style);
                let x = value.x + style.width(&row.value).max(3.2 * text) + 0.6 * text;
                let note = elide(&row.note, Style::Label, text, area.right() - x);
                if !note.is_empty() {
                    let style = Style::Label.size(text).ink(Ink::Muted);
                    picture.text_in(Rect { x, ..place }, note, style);
                }
            });
        }
    }

    pub fn in_words(&self) -> String {
        let row = |row: &Row| {
            let note = row.note.replace(['✕', '✓'], "");
            format!("{} {} {}", row.symbol, row.value, note.trim())
                .trim()
                .to_string()
        };
        let rows: Vec<String> = self.rows.iter().map(row).collect();
        format!("{}: {}.", self.title, rows.join("; "))
    }
}

/// Each light: the angle of L with N, N·L, what the shadow ray found; then H or R of the light in hand.
fn lights(surface: &SurfaceInSight, language: Language) -> Vec<Row> {
    let words = |words: Words| words.in_language(language);
    let lean = |vector: DVec3| match surface.lean(vector) {
        lean if lean < 0.05 => String::new(),
        lean => format!(", {}° {}", short(Value::Number(lean), 1), words(LEANS)),
    };
    let Some(lit) = surface.lit() else {
        return Vec::new();
    };
    let mut rows = Vec::new();
    for light in &lit.lights {
        let Some((to_light, cosine)) = light.to_light else {
            continue;
        };
        let verdict = surface.verdict(light.light);
        let (found, ink) = match verdict {
            _ if cosine <= 0.0 => (format!("✕ {}", words(AWAY)), Ink::Muted),
            Some(verdict) if verdict.blocked => {
                let by = verdict.by.map(|hit| {
                    let name = names::object(&surface.state.stage, hit.object);
                    format!(" {name}, t {}", short(Value::Number(hit.t), 2))
                });
                let by = by.unwrap_or_default();
                (format!("✕ {}{by}", words(BLOCKED)), Ink::Bad)
            }
            Some(_) => (format!("✓ {}", words(ARRIVES)), Ink::Good),
            None => (String::new(), Ink::Muted),
        };
        let n_dot_l = short(Value::Number(cosine), 3);
        rows.push(Row {
            note: format!("N·L {n_dot_l} {found}{}", lean(to_light)),
            ink,
            tag: Tag::Light(light.light as usize),
            ..row(
                &format!("L_{}", light.light),
                cosine.clamp(-1.0, 1.0).acos(),
                "N_dot_L",
                "",
            )
        });
    }
    if let Some(light) = surface.light_in_hand() {
        if let Some((halfway, cosine)) = light.halfway {
            let n_dot_h = short(Value::Number(cosine), 3);
            rows.push(Row {
                note: format!("N·H {n_dot_h}{}", lean(halfway)),
                ..row("H", cosine.clamp(-1.0, 1.0).acos(), "N_dot_H", "Halfway")
            });
        }
        if let Some((_, cosine)) = light.mirrored {
            rows.push(Row {
                symbol: "R_L".to_string(),
                value: String::new(),
                note: format!("R·V {}", short(Value::Number(cosine), 3)),
                ..row("R_L", 0.0, "R_dot_V", "Mirrored")
            });
        }
    }
    rows
}
