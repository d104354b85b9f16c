//! What is said of a ray, and how its node is drawn.

use super::arrange::{Detail, LINE};
use super::strings::*;
use crate::algorithms::ray_tree::{End, RayKind};
use crate::algorithms::visible::Intersection;
use crate::color::Rgb;
use crate::figure::Cell;
use crate::language::Message;
use crate::panels::message::labelled;
use crate::panels::names;
use crate::panels::strings::Language;
use crate::picture::{Dash, Ink, Picture, Rect, Stroke, Style, Text, symbol};
use crate::replay::rays::{Outcome, RayState, State};

/// Width of the strip that shows a node's light.
const STRIP: f32 = 7.0;
/// Between a node's border and its text.
const INSET: f32 = 5.0;

/// Who says things, and of which run.
#[derive(Clone, Copy)]
pub(super) struct Describer<'a> {
    pub state: &'a State,
    pub language: Language,
}

impl Describer<'_> {
    pub fn object(&self, object: u32) -> &str {
        names::object(&self.state.prepared, object, self.language)
    }

    pub fn light(&self, light: u32) -> String {
        names::light(light, self.language)
    }

    /// What the ray met, with and without the side.
    pub fn name(&self, ray: &RayState) -> [String; 2] {
        match ray.met {
            None => [self.localize(SEARCHING), self.localize(SEARCHING)],
            Some(Intersection::Nothing) => [self.localize(BACKGROUND), self.localize(BACKGROUND)],
            Some(Intersection::Light { light, .. }) => [self.light(light), self.light(light)],
            Some(Intersection::Object(hit)) => {
                let name = self.object(hit.object).to_owned();
                let facing = ray.surface.and_then(|surface| surface.facing);
                match facing {
                    Some((.., false)) => [self.format(INSIDE, &[("object", &name)]), name],
                    _ => [name.clone(), name],
                }
            }
        }
    }

    /// With at most two decimals.
    pub fn number(&self, value: f64) -> String {
        self.language.short(value, 2)
    }

    pub fn localize(&self, message: Message) -> String {
        message.text(self.language).to_owned()
    }

    pub fn format(&self, message: Message, arguments: &[(&'static str, &str)]) -> String {
        message.format(self.language, arguments)
    }

    /// Where the ray met it, or why it has no t; and the same in short.
    fn place(&self, ray: &RayState) -> [String; 2] {
        match ray.met {
            None => [String::new(), String::new()],
            Some(Intersection::Nothing) => [self.localize(LEAVES), self.localize(LEAVES_SHORT)],
            Some(met) => [(); 2].map(|()| format!("t {}", self.number(met.t()))),
        }
    }
}

/// A colour with two decimals; one number where its channels read alike.
pub(super) fn color(value: Rgb, language: Language) -> String {
    let channels = value.channels().map(|channel| language.short(channel, 2));
    if channels.iter().all(|channel| *channel == channels[0]) {
        channels[0].clone()
    } else {
        channels.join(" ")
    }
}

/// A colour as a factor or term: three numbers in brackets, one without.
pub(super) fn bracketed(value: Rgb, language: Language) -> String {
    let text = color(value, language);
    if text.contains(' ') {
        format!("({text})")
    } else {
        text
    }
}

/// The letter of an edge.
pub(super) fn letter(kind: RayKind) -> &'static str {
    match kind {
        RayKind::Primary => "",
        RayKind::Reflected => "R",
        RayKind::Transmitted => "T",
        RayKind::TotalInternalReflection => "TIR",
    }
}

/// The line of an edge.
pub(super) fn line(kind: RayKind) -> Stroke {
    match kind {
        RayKind::Primary => Ink::Text.stroke(1.5),
        RayKind::Reflected => Ink::Series(0).stroke(2.0),
        RayKind::Transmitted => Ink::Series(2).stroke(2.0).dashed(),
        RayKind::TotalInternalReflection => Ink::Series(3).stroke(2.5).dotted(),
    }
}

/// Whether nothing passes where the ray met its surface.
pub(super) fn nothing_passes(ray: &RayState) -> bool {
    ray.refraction
        .is_some_and(|refraction| refraction.radicand < 0.0)
}

/// The branches that are missing below the last level.
pub(super) fn too_deep(ray: &RayState) -> Vec<&'static str> {
    ray.branches
        .iter()
        .flatten()
        .filter(|branch| branch.outcome == Outcome::Ended(End::Depth))
        .map(|branch| letter(branch.kind))
        .collect()
}

/// Lines that a node has more than others of its detail.
pub(super) fn further_lines(ray: &RayState, detail: Detail) -> usize {
    let remarks = usize::from(nothing_passes(ray)) + usize::from(!too_deep(ray).is_empty());
    match detail {
        Detail::Dot | Detail::Line | Detail::Tiny | Detail::Small => 0,
        Detail::Brief => remarks,
        Detail::Full => remarks + ray.shadows.len(),
    }
}

/// How a node stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Standing {
    Current,
    /// Its light has not come back yet.
    Open,
    Returned,
    /// Not traced yet.
    Asked,
}

/// Draws the frame of a node, and the light that it has gathered as a strip at its left.
pub(super) fn frame(
    picture: &mut Picture,
    rect: Rect,
    standing: Standing,
    ray: Option<&RayState>,
    detail: Detail,
) {
    let stroke = outline(standing);
    let fill = match standing {
        Standing::Current => Ink::ThisTint,
        _ => Ink::Surface,
    };
    let returned = ray.and_then(|ray| ray.returned);
    let light = ray.and_then(|ray| ray.returned.map(|(color, _)| color).or(ray.sum));
    if detail == Detail::Dot {
        let fill = returned.map_or(fill, |(color, _)| Ink::Rgb(color));
        let radius = 0.5 * rect.width - 1.0;
        picture.circle(rect.center(), radius, fill.fill().outlined(stroke));
        return;
    }
    picture.rounded_rect(rect, 5.0, fill.fill().outlined(stroke));
    let Some(light) = light else { return };
    // Full once the light has come back; before, as far as it was gathered.
    let inside = rect.grown(-stroke.width - 1.0);
    let height = if returned.is_some() {
        inside.height
    } else {
        0.5 * inside.height
    };
    let strip = Rect::new(inside.x, inside.bottom() - height, STRIP, height);
    let outline = match returned {
        Some(_) => Ink::Muted.stroke(1.0),
        None => Ink::Muted.stroke(1.0).dotted(),
    };
    picture.rounded_rect(strip, 2.0, Ink::Rgb(light).fill().outlined(outline));
}

fn outline(standing: Standing) -> Stroke {
    match standing {
        Standing::Current => Ink::This.stroke(2.5),
        Standing::Open => Ink::Text.stroke(2.0),
        Standing::Returned => Ink::Muted.stroke(1.0),
        Standing::Asked => Stroke {
            dash: Dash::Dashed,
            ..Ink::Muted.stroke(1.0)
        },
    }
}

/// Writes what a node says, line by line.
pub(super) fn write(
    picture: &mut Picture,
    describer: &Describer,
    rect: Rect,
    ray: Option<&RayState>,
    detail: Detail,
    scale: f32,
) {
    let (line, size) = match detail {
        Detail::Line | Detail::Tiny => (14.0, 11.0),
        _ => (LINE, 12.0),
    };
    let mut writer = Writer {
        left: rect.x + INSET + STRIP + 1.0,
        right: rect.right() - INSET,
        y: rect.y + 3.0 * scale,
        scale,
        line: line * scale,
        picture,
    };
    let bold = Style::Bold.size(size * scale);
    let body = Style::Body.size(11.0 * scale);
    let muted = body.ink(Ink::Muted);
    let Some(ray) = ray else {
        writer.line(
            &[describer.localize(NOT_TRACED), describer.localize(ASKED)],
            muted,
        );
        return;
    };
    let name = describer.name(ray);
    let place = describer.place(ray);
    let marks: Vec<bool> = ray.shadows.iter().map(|verdict| !verdict.blocked).collect();
    if detail == Detail::Line {
        writer.end(&place[1], muted);
    }
    writer.line(&name, bold);
    match detail {
        Detail::Dot | Detail::Line => {}
        Detail::Tiny => writer.line(&place, muted),
        Detail::Small => {
            writer.marks(&marks);
            writer.line(&place, body);
        }
        Detail::Brief => {
            writer.marks(&marks);
            writer.line(&place, body);
            writer.light(ray, describer.language);
            writer.remarks(describer, ray);
        }
        Detail::Full => {
            let facing = ray.surface.and_then(|surface| surface.facing);
            let cosine =
                facing.map(|(_, cosine, _)| format!("   cos θ_i {}", describer.number(cosine)));
            let place = place[0].clone() + &cosine.unwrap_or_default();
            writer.line(&[place], Style::Label.size(11.0 * scale));
            if let Some((normal, ..)) = facing {
                let normal = normal.to_array().map(|v| describer.number(v));
                writer.line(&[format!("N ({})", describer.language.list(normal))], muted);
            }
            for verdict in &ray.shadows {
                let light = describer.light(verdict.light);
                let by = verdict.by.map_or_else(String::new, |hit| {
                    format!(
                        "{}, t {}",
                        describer.object(hit.object),
                        describer.number(hit.t)
                    )
                });
                let mark = mark(!verdict.blocked);
                writer.line(
                    &[format!("{light} {mark} {by}")],
                    body.ink(ink(!verdict.blocked)),
                );
            }
            if let Some(local) = ray.local {
                writer.line(
                    &[format!(
                        "{} {}",
                        symbol("I_local"),
                        color(local, describer.language)
                    )],
                    Style::Label.size(11.0 * scale),
                );
            }
            writer.light(ray, describer.language);
            writer.remarks(describer, ray);
        }
    }
}

pub(super) fn mark(clear: bool) -> &'static str {
    if clear { "✓" } else { "✕" }
}

pub(super) fn ink(clear: bool) -> Ink {
    if clear { Ink::Good } else { Ink::Bad }
}

/// Lines of text from the top of a node down.
struct Writer<'a> {
    picture: &'a mut Picture,
    left: f32,
    right: f32,
    y: f32,
    line: f32,
    scale: f32,
}

impl Writer<'_> {
    /// The first of several wordings that fits, else the last, shortened.
    fn line(&mut self, wordings: &[String], set: Text) {
        let place = Rect::new(self.left, self.y, self.right - self.left, self.line);
        let forms = wordings.iter().map(|text| (text.clone(), set));
        Cell::forms(forms).draw(self.picture, place);
        self.y += self.line;
    }

    /// At the right end of the line to come, which becomes so much shorter.
    fn end(&mut self, text: &str, set: Text) {
        let place = Rect::new(self.left, self.y, self.right - self.left, self.line);
        self.picture.text_in(place, text, set.end());
        self.right -= set.width(text) + 5.0;
    }

    /// Verdicts at the right end of the line to come.
    fn marks(&mut self, marks: &[bool]) {
        const MOST: usize = 4;
        let set = Style::Bold.size(12.0 * self.scale);
        let mut right = self.right;
        let counted: Vec<(String, bool)> = if marks.len() <= MOST {
            marks
                .iter()
                .map(|&clear| (mark(clear).to_owned(), clear))
                .collect()
        } else {
            let count = |clear| marks.iter().filter(|&&mark| mark == clear).count();
            [true, false]
                .map(|clear| (format!("{}{}", mark(clear), count(clear)), clear))
                .into()
        };
        for (text, clear) in counted.into_iter().rev() {
            let place = Rect::new(self.left, self.y, right - self.left, self.line);
            right -= set.width(&text) + 2.0;
            self.picture.text_in(place, text, set.ink(ink(clear)).end());
        }
    }

    /// What came back, or what was gathered so far.
    fn light(&mut self, ray: &RayState, language: Language) {
        let set = Style::Label.size(11.0 * self.scale);
        match (ray.returned, ray.sum) {
            (Some((returned, _)), _) => {
                self.line(
                    &[
                        format!("I  {}", color(returned, language)),
                        color(returned, language),
                    ],
                    set,
                );
            }
            (None, Some(sum)) => self.line(
                &[
                    format!("{}  {}", symbol("I_sum"), color(sum, language)),
                    color(sum, language),
                ],
                set,
            ),
            (None, None) => {}
        }
    }

    fn remarks(&mut self, describer: &Describer, ray: &RayState) {
        let set = Style::Body.size(11.0 * self.scale).ink(Ink::Muted);
        if nothing_passes(ray) {
            self.line(&[describer.localize(NO_TRANSMITTED)], set.ink(Ink::Warn));
        }
        let missing = too_deep(ray);
        if !missing.is_empty() {
            let depth = describer.localize(DEPTH_REACHED);
            let missing = labelled(&missing.join(", "), &depth, describer.language);
            self.line(&[missing, depth], set);
        }
    }
}
