//! How a ray is described, and the frame of its node.

use super::arrange::Detail;
use super::strings::*;
use crate::algorithms::ray_tree::{End, RayKind};
use crate::algorithms::visible::Intersection;
use crate::color::Rgb;
use crate::language::Message;
use crate::panels::names;
use crate::panels::strings::Language;
use crate::picture::{Dash, Ink, Picture, Rect, Stroke, Style, symbol};
use crate::replay::rays::{Outcome, RayState, State};

/// Width of the strip that shows a node's light.
pub(super) const STRIP: f32 = 7.0;
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

    /// Where the ray met it; of the background, that it does not.
    pub fn place(&self, ray: &RayState) -> String {
        match ray.met {
            None => String::new(),
            Some(met) if met.t().is_finite() => format!("t {}", self.number(met.t())),
            Some(_) => "t ∞".to_owned(),
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

/// The local term of a surface; of what is none, why the ray ends there.
pub(super) fn own_light(describer: &Describer, ray: &RayState) -> Vec<String> {
    match (ray.met, ray.local) {
        (Some(Intersection::Nothing), _) => {
            vec![describer.localize(LEAVES), describer.localize(LEAVES_SHORT)]
        }
        (Some(Intersection::Light { .. }), _) => vec![describer.localize(LIGHT_MET)],
        (_, Some(local)) => valued("I_local", color(local, describer.language)),
        (_, None) => valued("I_local", NOT_KNOWN.to_owned()),
    }
}

/// What came back along the ray, once it has.
pub(super) fn sum(describer: &Describer, ray: &RayState) -> Vec<String> {
    let returned = ray
        .returned
        .map(|(light, _)| color(light, describer.language));
    valued("I", returned.unwrap_or_else(|| NOT_KNOWN.to_owned()))
}

fn valued(name: &str, value: String) -> Vec<String> {
    vec![format!("{}  {value}", symbol(name)), value]
}

/// What a ray's sum is called: once it has come back, and before.
pub(super) fn sum_symbol(ray: Option<&RayState>) -> String {
    symbol(match ray.is_some_and(|ray| ray.returned.is_some()) {
        true => "I",
        false => "I_sum",
    })
}

/// How wide the widest light of the rays is in a node: it is as wide in every language. Of very many, three channels of two decimals.
pub(super) fn widest_light(state: &State) -> f32 {
    const MOST: usize = 1500;
    const USUAL: &str = "0.00 0.00 0.00";
    let set = Style::Label.size(11.0);
    if state.rays.len() > MOST {
        return set.width(USUAL);
    }
    let lights = state.rays.iter().flat_map(|ray| {
        let returned = ray.returned.map(|(light, _)| light);
        [ray.local, returned].into_iter().flatten()
    });
    let texts = lights.map(|light| color(light, Language::English));
    let longest = texts.max_by_key(String::len);
    longest.map_or(0.0, |text| set.width(&text))
}

pub(super) fn mark(clear: bool) -> &'static str {
    if clear { "✓" } else { "✕" }
}

pub(super) fn ink(clear: bool) -> Ink {
    if clear { Ink::Good } else { Ink::Bad }
}

#[cfg(test)]
mod tests;
