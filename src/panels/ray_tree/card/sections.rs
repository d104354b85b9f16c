//! What the card says of a ray: what it met, what each shadow ray found, and the light that comes back.

use super::super::node::{Describer, bracketed, color, ink, letter, mark, nothing_passes};
use super::super::strings::*;
use super::entry::{Entry, SIZE, Section};
use crate::algorithms::ray_tree::End;
use crate::algorithms::visible::Intersection;
use crate::panels::message::labelled;
use crate::picture::{Ink, Style, Tag};
use crate::replay::rays::{Outcome, RayState, Target};

/// What the ray met, and how it goes on.
pub fn surface(describer: &Describer, ray: &RayState) -> Section {
    let mut entries = Vec::new();
    let level = describer.format(LEVEL, &[("level", &ray.level.to_string())]);
    let name = describer.name(ray)[0].clone();
    let title = Entry {
        set: Style::LabelBold.size(13.0),
        ..Entry::parts(vec![name, format!("· {level}")])
    };
    let light = ray.returned.map(|(color, _)| color).or(ray.sum);
    let mut place = Vec::new();
    if let Some(met) = ray.met.filter(|met| met.t().is_finite()) {
        place.push(format!("t {}", describer.language.short(met.t(), 3)));
    }
    if let Some((normal, cosine, _)) = ray.surface.and_then(|surface| surface.facing) {
        let normal = normal.to_array().map(|v| describer.language.short(v, 3));
        place.push(format!("  N ({})", describer.language.list(normal)));
        place.push(format!("  cos θ_i {}", describer.language.short(cosine, 3)));
    }
    match ray.met {
        None => entries.extend(search(describer)),
        Some(Intersection::Nothing) => entries.push(Entry::new(describer.localize(LEAVES))),
        Some(Intersection::Light { .. }) => {
            entries.push(Entry::new(describer.localize(LIGHT_MET)));
        }
        Some(_) => {}
    }
    if !place.is_empty() {
        entries.push(Entry::parts(place));
    }
    if let Some(refraction) = ray.refraction {
        let eta = format!(
            "η {} → {}",
            describer.number(refraction.eta_i),
            describer.number(refraction.eta_r)
        );
        let radicand = format!(
            "  cos^2 θ_r {}",
            describer.language.short(refraction.radicand, 3)
        );
        let mut parts = vec![eta, radicand];
        if nothing_passes(ray) {
            parts.push(format!("< 0: {}", describer.localize(TIR)));
        }
        entries.push(Entry::parts(parts).tag(Tag::Step(refraction.step)));
    }
    for branch in ray.branches.iter().flatten() {
        let Outcome::Ended(end) = branch.outcome else {
            continue;
        };
        let why = describer.localize(match end {
            End::Depth => DEPTH_REACHED,
            End::NoCoefficient => NO_COEFFICIENT,
        });
        let text = labelled(letter(branch.kind), &why, describer.language);
        entries.push(Entry::new(text).ink(Ink::Muted).tag(Tag::Step(branch.step)));
    }
    Section {
        title: title.swatch(light),
        entries,
    }
}

/// How the search for the nearest object stands.
fn search(describer: &Describer) -> Option<Entry> {
    let search = describer.state.search?;
    let name = |target| match target {
        Target::Object(object) => describer.object(object).to_owned(),
        Target::Light(light) => describer.light(light),
    };
    let mut parts = Vec::new();
    if let Some(tested) = search.tested {
        parts.push(tested_in_words(describer, &name(tested.target), tested.t));
    }
    if let Some(nearest) = search.nearest {
        let (thing, t) = (name(nearest.target), describer.number(nearest.t));
        let nearest = describer.format(NEAREST, &[("thing", &thing), ("t", &t)]);
        parts.push(format!("· {nearest}"));
    }
    (!parts.is_empty()).then(|| Entry::parts(parts))
}

fn tested_in_words(describer: &Describer, thing: &str, t: f64) -> String {
    match t.is_finite() {
        true => describer.format(TESTED, &[("thing", thing), ("t", &describer.number(t))]),
        false => describer.format(MISSED, &[("thing", thing)]),
    }
}

/// The verdict of each light, and N·L of the current one; none where no light was tested.
pub fn lights(describer: &Describer, ray: &RayState) -> Option<Section> {
    let state = describer.state;
    let current = state.ray().is_some_and(|hand| hand.step == ray.step);
    let point = state.point.as_ref().filter(|_| current);
    let cosine = |light: u32| {
        let lights = point.map_or(&[][..], |point| &point.lights);
        let lit = lights.iter().find(|lit| lit.light == light);
        lit.and_then(|lit| lit.to_light)
            .map(|(_, cosine)| format!("  N·L {}", describer.number(cosine)))
    };
    let mut entries: Vec<Entry> = ray
        .shadows
        .iter()
        .map(|verdict| {
            let why = match (verdict.blocked, verdict.by) {
                (true, Some(hit)) => {
                    let (name, t) = (describer.object(hit.object), describer.number(hit.t));
                    describer.format(IS_BLOCKED_BY, &[("object", name), ("t", &t)])
                }
                (true, None) => describer.localize(IS_BLOCKED),
                (false, _) => {
                    let distance = describer.number(verdict.distance);
                    describer.format(IS_CLEAR, &[("distance", &distance)])
                }
            };
            let mark = mark(!verdict.blocked);
            let text = format!("{}  {mark} {why}", describer.light(verdict.light));
            let parts = [Some(text), cosine(verdict.light)];
            Entry::parts(parts.into_iter().flatten().collect())
                .ink(ink(!verdict.blocked))
                .tag(Tag::Step(verdict.step))
        })
        .collect();
    let asked = !entries.is_empty() || state.shadow.is_some() && current;
    if let (Some(shadow), true) = (&state.shadow, current) {
        let mut text = format!("{}  …", describer.light(shadow.light));
        if let Some((object, t, _)) = shadow.tested {
            let tested = tested_in_words(describer, describer.object(object), t);
            text = format!("{text} {tested}");
        }
        entries.push(Entry::new(text).ink(Ink::This).tag(Tag::Scope(shadow.step)));
    }
    if !asked && let Some(point) = point {
        for lit in &point.lights {
            let text = describer.light(lit.light) + &cosine(lit.light).unwrap_or_default();
            entries.push(Entry::new(text).tag(Tag::Scope(lit.step)));
        }
    }
    if entries.is_empty() {
        return None;
    }
    let title = if asked { SHADOW_RAYS } else { LIGHTS };
    let name = &describer.name(ray)[0];
    Some(Section {
        title: headline(describer.format(title, &[("thing", name)])),
        entries,
    })
}

fn headline(text: String) -> Entry {
    Entry {
        set: Style::LabelBold.size(SIZE),
        ..Entry::new(text)
    }
}

/// The sums on the way of the light: of the ray that returned last, of the current ray, and of those that wait for it.
pub fn coming_back(describer: &Describer, ray: &RayState, rising: Option<usize>) -> Section {
    let state = describer.state;
    let risen = rising.and_then(|index| state.rays.get(index));
    let risen = risen.filter(|risen| risen.step != ray.step);
    let above = |ray: &&RayState| state.rays.get(ray.parent?);
    let waiting = std::iter::successors(Some(ray), above);
    let rows = risen.into_iter().chain(waiting).map(|ray| {
        let returned = ray.returned.map(|(color, _)| color);
        let entry = Entry::parts(sum(describer, ray)).swatch(returned.or(ray.sum));
        let ink = if risen.is_some_and(|risen| risen.step == ray.step) {
            Ink::Linked
        } else {
            Ink::Text
        };
        entry.ink(ink).tag(Tag::Scope(ray.step))
    });
    Section {
        title: headline(describer.localize(COMING_BACK)),
        entries: rows.collect(),
    }
}

/// What a ray's light is the sum of, so far.
pub(in super::super) fn sum(describer: &Describer, ray: &RayState) -> Vec<String> {
    let name = &describer.name(ray)[0];
    let returned = ray.returned.map(|(returned, _)| returned);
    let Some(local) = ray.local else {
        let light = returned.map_or_else(
            || "…".to_owned(),
            |light| bracketed(light, describer.language),
        );
        return vec![format!("{name} → {light}")];
    };
    let mut parts = vec![format!("{name} → {}", bracketed(local, describer.language))];
    for branch in ray.branches.iter().flatten() {
        let Some(sent) = branch.branch else { continue };
        let k = bracketed(sent.coefficient, describer.language);
        let back = match branch.outcome {
            Outcome::Ray(index) => describer.state.rays.get(index).and_then(|ray| ray.returned),
            _ => None,
        };
        let light = match (branch.outcome, branch.attenuation, back, branch.carried) {
            (Outcome::Ended(_), ..) => format!("0 ({})", describer.localize(DEPTH_REACHED)),
            (_, Some((_, divisor)), Some((light, _)), _) => {
                format!(
                    "{}/{}",
                    bracketed(light, describer.language),
                    describer.number(divisor)
                )
            }
            (_, None, _, Some(light)) | (_, None, Some((light, _)), None) => {
                bracketed(light, describer.language)
            }
            _ => "…".to_owned(),
        };
        parts.push(format!("+ {k}·{light}"));
    }
    match (returned, ray.sum) {
        (Some(light), _) => parts.push(format!("= {}", bracketed(light, describer.language))),
        (None, Some(sum)) => {
            if ray.branches[1].is_none() {
                parts.push("+ …".to_owned());
            }
            let sum = color(sum, describer.language);
            let so_far = describer.format(SO_FAR, &[("light", &sum)]);
            parts.push(format!("({so_far})"));
        }
        (None, None) => {}
    }
    parts
}
