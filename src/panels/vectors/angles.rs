//! The angles with the normal, and what each light's shadow ray found, as a list.

use super::super::names;
use super::met::SurfaceInSight;
use crate::color::Rgb;
use crate::figure::{Cell, Row};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Tag, elide};
use crate::replay::rays::Verdict;
use crate::scene::{Material, Scene};
use glam::DVec3;

const LINE: f32 = 1.5;
/// The least width of a column beside another one, in sizes of the text.
pub(super) const COLUMN: f32 = 13.0;
const ANGLES: Message = Message("vectors-angles");
const BLOCKED: Message = Message("common-blocked");
const BLOCKED_BY: Message = Message("common-blocked-by");
const ARRIVES: Message = Message("vectors-arrives");
const AWAY: Message = Message("vectors-away");
const LEANS: Message = Message("vectors-leans");
const TOTAL: Message = Message("common-total-internal-reflection");
const CRITICAL: Message = Message("vectors-critical");

/// A line of the list: a symbol, a number, and what is to be said of it.
struct Angle {
    symbol: String,
    value: String,
    /// From the longest to the shortest.
    notes: Vec<String>,
    ink: Ink,
    tag: Tag,
    /// The kind of step that records it.
    recorded_by: &'static str,
}

pub(super) struct Angles {
    /// Of the object.
    name: String,
    title: String,
    rows: Vec<Angle>,
    /// Of the rows, the first about a light.
    lights: usize,
}

fn degrees(radians: f64, language: Language) -> String {
    format!("{}°", language.short(radians.to_degrees(), 1))
}

fn row(
    symbol: &str,
    radians: f64,
    tag: &'static str,
    recorded_by: &'static str,
    language: Language,
) -> Angle {
    Angle {
        symbol: symbol.to_string(),
        value: degrees(radians, language),
        notes: Vec::new(),
        ink: Ink::Muted,
        tag: Tag::Field(tag),
        recorded_by,
    }
}

/// Whether anything in the scene is transparent.
pub(super) fn transmits(scene: &Scene) -> bool {
    let clear = |material: &Material| material.transmission != Rgb::BLACK;
    scene.materials.iter().any(clear)
}

/// The height of the list in a scene: a title, θ_i, two angles more where something is transparent, lights, the highlight.
pub(super) fn height(scene: &Scene, text: f32, columns: usize) -> f32 {
    let angles = if transmits(scene) { 3 } else { 1 };
    let lights = scene.lights.len() + 1;
    let rows = if columns == 1 {
        angles + lights
    } else {
        angles.max(lights)
    };
    (rows + 1) as f32 * LINE * text
}

impl Angles {
    pub fn of(surface: &SurfaceInSight, language: Language) -> Self {
        let strings = |strings: Message| strings.text(language);
        let mut rows = Vec::new();
        if let Some((_, cosine, _)) = surface.surface.facing {
            rows.push(row(
                "θ_i",
                cosine.min(1.0).acos(),
                "theta_i_degrees",
                "Faced",
                language,
            ));
        }
        if let Some(refraction) = surface.ray.refraction {
            if let Some(angle) = refraction.theta_r() {
                rows.push(row("θ_r", angle, "theta_r_degrees", "Refraction", language));
            }
            if let Some(angle) = refraction.critical_angle() {
                let note = if refraction.radicand < 0.0 {
                    strings(TOTAL)
                } else {
                    strings(CRITICAL)
                };
                rows.push(Angle {
                    notes: vec![note.to_string()],
                    ..row("θ_c", angle, "theta_c_degrees", "Refraction", language)
                });
            }
        }
        let first_light = rows.len();
        rows.extend(lights(surface, language));
        Angles {
            lights: first_light,
            name: surface.name(language).to_string(),
            title: ANGLES.format(language, &[("surface", surface.name(language))]),
            rows,
        }
    }

    /// As many rows as there is room for, from the top. In two columns, those of the lights stand in the second.
    pub fn draw(&self, picture: &mut Picture, kind: &str, text: f32, area: Rect, columns: usize) {
        let line = LINE * text;
        let room = (area.height / line) as usize;
        if room == 0 {
            return;
        }
        let bold = Style::Bold.size(text);
        let title = if bold.width(&self.title) <= area.width {
            self.title.clone()
        } else {
            elide(&self.name, Style::Bold, text, area.width)
        };
        let title_place = Rect {
            height: line,
            ..area
        };
        picture.text_in(title_place, title, bold);
        let lights = if columns == 1 {
            self.rows.len()
        } else {
            self.lights
        };
        let (left, right) = self.rows.split_at(lights.min(self.rows.len()));
        let width = area.width / columns as f32;
        for (column, rows) in [left, right].into_iter().enumerate() {
            let x = area.x + column as f32 * width;
            for (i, row) in rows.iter().enumerate().take(room - 1) {
                let y = area.y + (i + 1) as f32 * line;
                let place = Rect::new(x, y, width - 4.0, line);
                row.row(kind, text).draw(picture, place);
            }
        }
    }

    pub fn in_words(&self) -> String {
        let row = |row: &Angle| {
            let note = row.notes.first().map_or("", String::as_str);
            let note = note.replace(['✕', '✓'], "");
            format!("{} {} {}", row.symbol, row.value, note.trim())
                .trim()
                .to_string()
        };
        let rows: Vec<String> = self.rows.iter().map(row).collect();
        format!("{}: {}.", self.title, rows.join("; "))
    }
}

impl Angle {
    /// `kind` is that of the step, `text` the size of the text.
    fn row(&self, kind: &str, text: f32) -> Row {
        let here = self.recorded_by == kind;
        let set = Style::Label.size(text);
        let value = set.ink(if here { Ink::This } else { Ink::Text });
        let symbol = Style::LabelBold.size(text).ink(self.ink);
        // Without a note that fits there is none.
        let notes = self.notes.iter().map(String::as_str).chain([""]);
        let notes = notes.map(|note| (note.to_string(), set.ink(Ink::Muted)));
        let start = 2.2 * text;
        let after = start + value.width(&self.value).max(3.2 * text) + 0.6 * text;
        Row::new(self.tag)
            .cell(0.0, Cell::new(self.symbol.as_str(), symbol))
            .cell(start, Cell::new(self.value.as_str(), value))
            .cell(after, Cell::forms(notes))
    }
}

/// What blocks a light, from the longest form to the shortest.
fn blocked(surface: &SurfaceInSight, verdict: &Verdict, language: Language) -> Vec<String> {
    let Some(hit) = verdict.by else {
        return vec![BLOCKED.text(language).to_string()];
    };
    let name = names::object(&surface.state.prepared, hit.object, language);
    let t = language.short(hit.t, 2);
    vec![
        BLOCKED_BY.format(language, &[("object", name), ("t", &t)]),
        format!("{name}, t {t}"),
        name.to_string(),
    ]
}

/// Each light: the angle of L with N, N·L, what the shadow ray found; then H or R of the current light.
fn lights(surface: &SurfaceInSight, language: Language) -> Vec<Angle> {
    let strings = |strings: Message| strings.text(language);
    let lean = |vector: DVec3| match surface.lean(vector) {
        lean if lean < 0.05 => String::new(),
        lean => {
            let angle = format!("{}°", language.short(lean, 1));
            format!(", {}", LEANS.format(language, &[("angle", &angle)]))
        }
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
        let (mark, found, ink) = match verdict {
            _ if cosine <= 0.0 => ("✕", vec![strings(AWAY).to_string()], Ink::Muted),
            Some(verdict) if verdict.blocked => {
                ("✕", blocked(surface, verdict, language), Ink::Bad)
            }
            Some(_) => ("✓", vec![strings(ARRIVES).to_string()], Ink::Good),
            None => ("", Vec::new(), Ink::Muted),
        };
        let newest = surface
            .current_light()
            .is_some_and(|last| last.light == light.light);
        let n_dot_l = language.short(cosine, 3);
        let first = found.first().map_or("", String::as_str);
        let whole = format!("N·L {n_dot_l} {mark} {first}{}", lean(to_light));
        let without_lean = found
            .iter()
            .map(|found| format!("N·L {n_dot_l} {mark} {found}"));
        let shortest = [
            format!("N·L {n_dot_l} {mark}"),
            format!("{n_dot_l} {mark}"),
            mark.to_string(),
        ];
        rows.push(Angle {
            notes: std::iter::once(whole)
                .chain(without_lean)
                .chain(shortest)
                .collect(),
            ink,
            tag: Tag::Light(light.light as usize),
            ..row(
                &format!("L_{}", light.light),
                cosine.clamp(-1.0, 1.0).acos(),
                "N_dot_L",
                if newest { "ToLight" } else { "" },
                language,
            )
        });
    }
    if let Some(light) = surface.current_light() {
        if let Some((halfway, cosine)) = light.halfway {
            let n_dot_h = language.short(cosine, 3);
            rows.push(Angle {
                notes: vec![
                    format!("N·H {n_dot_h}{}", lean(halfway)),
                    format!("N·H {n_dot_h}"),
                ],
                ..row(
                    "H",
                    cosine.clamp(-1.0, 1.0).acos(),
                    "N_dot_H",
                    "Halfway",
                    language,
                )
            });
        }
        if let Some((_, cosine)) = light.mirrored {
            rows.push(Angle {
                symbol: "R_L".to_string(),
                value: String::new(),
                notes: vec![format!("R·V {}", language.short(cosine, 3))],
                ..row("R_L", 0.0, "R_dot_V", "Mirrored", language)
            });
        }
    }
    rows
}
