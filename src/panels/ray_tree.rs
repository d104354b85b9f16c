//! The binary ray tree of the current pixel, as far as it is traced: a node a ray with what it met, an edge a coefficient, a leaf
//! the reason why it ended; and the light that comes back up, sum by sum.

mod arrange;
mod beside;
mod card;
mod drawn;
mod edges;
mod levels;
mod lines;
mod node;
mod pick;
mod places;
mod sign;
mod strings;
mod tidy;
mod view;

#[cfg(test)]
mod tests;

pub use view::{HeldNode, TreeView};

use super::message::message;
use super::values::step_in_words;
use super::{PanelInput, Properties};
use crate::algorithms::ray_tree::RayKind;
use crate::figure::elided;
use crate::language::Message;
use crate::methods::Method;
use crate::picture::{Ink, Picture, Rect, Style};
use crate::replay::rays::{Outcome, RayState, State};
use arrange::{Arrangement, arrange};
use drawn::ShownTree;
use glam::Vec2;
use node::{Describer, letter, line};
use pick::Rays;
use places::{CardPlace, Places};
use strings::*;

pub const PANEL: Properties = Properties::titled(Message("app-ray-tree"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let state = match input.run.rays() {
        Some(state) => state,
        None => return message(NO_RAYS, input.language, size),
    };
    let Some(ray) = state.ray() else {
        let mut picture = message(NO_RAY, input.language, size);
        picture.alt = format!("{}. {}", step_in_words(input), picture.alt);
        return picture;
    };
    if let Some(pinned) = beside::pinned(input, size) {
        return beside::draw(input, [pinned, state], size);
    }
    let describer = Describer {
        state,
        language: input.language,
    };
    let rays = Rays::new(state);
    let (places, arrangement) = Places::new(&rays, input.tree, size);
    let (rising, returning) = rising(input, state);

    let mut picture = Picture::new(size.x, size.y);
    let shown = ShownTree {
        rays: &rays,
        arrangement: &arrangement,
        rising,
        is_now: true,
    };
    shown.draw(&mut picture, &describer, places.tree);
    let levels = input.run.method() == Method::RayTracing;
    let said = said_of_tree(&describer, &rays, &arrangement, levels);
    let branches = arrangement.tree.nodes.len() > 1;
    head(&mut picture, &said, branches, places.head);
    if let Some(row) = places.levels {
        levels::draw(&mut picture, &describer, &levels::Scale::of(&[state]), row);
    }
    match places.card {
        CardPlace::Whole { rect, rule } => {
            picture.line(rule[0], rule[1], Ink::Rule.stroke(1.0));
            let light = (rising, returning);
            card::draw(&mut picture, &describer, ray, light, rect);
        }
        CardPlace::Line(place) => card::line(&mut picture, &describer, ray, place),
    }
    let sentences = [
        Some(format!("{}: {said}", step_in_words(input))),
        Some(in_words(&describer, ray)),
        levels::in_words(&describer),
    ];
    let sentences: Vec<String> = sentences.into_iter().flatten().collect();
    picture.alt = sentences.join(". ") + ".";
    picture
}

/// The node nearest to a place of a panel of that size, as it stands now; none where no tree is drawn.
pub fn node_near(input: &PanelInput, size: Vec2, at: Vec2) -> Option<HeldNode> {
    let state = input.run.rays()?;
    state.ray()?;
    let rays = Rays::new(state);
    let (area, arrangement) = match beside::pinned(input, size) {
        Some(pinned) => {
            let area = beside::tree_area([pinned, state], size);
            (area, arrange(&rays, input.tree, area))
        }
        None => {
            let (places, arrangement) = Places::new(&rays, input.tree, size);
            (places.tree, arrangement)
        }
    };
    let nodes = arrangement.tree.nodes.iter().zip(&arrangement.rects);
    let distance = |rect: &Rect| rect.center().distance_squared(at);
    let (node, rect) = nodes
        .filter(|(node, _)| rays.ray(node).is_some())
        .min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)))?;
    Some(HeldNode {
        ray: rays.ray(node)?.step,
        at: rect.center() - area.center(),
    })
}

/// The ray whose light came back last, if it is this step that it rises or is added at; and whether light comes back at all.
fn rising(input: &PanelInput, state: &State) -> (Option<usize>, bool) {
    let walk = input.run.walk();
    let step = walk.position();
    let added = matches!(walk.kind(step), "Attenuated" | "BranchAdded");
    let current = state.current;
    let branches = state.ray().map_or([None; 2], |ray| ray.branches);
    let children = branches
        .iter()
        .flatten()
        .filter_map(|branch| match branch.outcome {
            Outcome::Ray(index) => Some(index),
            _ => None,
        });
    let returned = |&index: &usize| state.rays.get(index).and_then(|ray| ray.returned);
    // The child that returned last, or the current ray itself once all have returned.
    let last = children
        .filter(|index| returned(index).is_some())
        .max_by_key(|index| returned(index).map(|(_, step)| step));
    let now = last.filter(|index| added || returned(index).is_some_and(|(_, at)| at == step));
    let over = current.filter(|index| returned(index).is_some());
    (now, now.is_some() || over.is_some())
}

/// How large the tree is.
fn said_of_tree(
    describer: &Describer,
    rays: &Rays,
    arrangement: &Arrangement,
    levels: bool,
) -> String {
    let mut text = sign::counted_rays(describer, rays.len());
    if arrangement.tree.hidden > 0 {
        let count = arrangement.tree.hidden.to_string();
        text += ", ";
        text += &describer.format(HIDDEN, &[("count", &count)]);
    }
    if !levels {
        return text;
    }
    let level = describer.state.ray().map_or(0, |ray| ray.level).to_string();
    let deepest = describer.state.depth.to_string();
    let level = describer.format(LEVEL_OF, &[("level", &level), ("deepest", &deepest)]);
    format!("{text} · {level}")
}

/// What is said of the tree, and at the right the lines of its edges.
fn head(picture: &mut Picture, said: &str, legend: bool, area: Rect) {
    let set = Style::Body.size(11.0).ink(Ink::Muted);
    let kinds = [
        RayKind::Reflected,
        RayKind::Transmitted,
        RayKind::TotalInternalReflection,
    ];
    let letters = Style::Bold.size(11.0);
    let width: f32 = kinds
        .iter()
        .map(|&kind| letters.width(letter(kind)) + 42.0)
        .sum();
    let room = set.width(said) + 16.0 + width <= area.width;
    elided(picture, area, said, set);
    if !(legend && room) {
        return;
    }
    let mut x = area.right() - width;
    for kind in kinds {
        let y = area.center().y;
        picture.line((x, y), (x + 22.0, y), line(kind));
        let place = Rect::new(x + 26.0, area.y, letters.width(letter(kind)), area.height);
        picture.text_in(place, letter(kind), letters.ink(Ink::Muted));
        x = place.right() + 16.0;
    }
}

/// The current ray in a sentence.
fn in_words(describer: &Describer, ray: &RayState) -> String {
    let mut met = vec![describer.name(ray)[0].clone()];
    if let Some(hit) = ray.met.filter(|met| met.t().is_finite()) {
        met.push(format!("t {}", describer.number(hit.t())));
    }
    if node::nothing_passes(ray) {
        met.push(describer.localize(TIR));
    }
    let mut parts = vec![met.join(", ")];
    for verdict in &ray.shadows {
        let light = describer.light(verdict.light);
        let by = verdict.by.map(|hit| describer.object(hit.object));
        let light = ("light", &*light);
        parts.push(match (verdict.blocked, by) {
            (true, Some(by)) => describer.format(BLOCKED_BY, &[light, ("object", by)]),
            (true, None) => describer.format(BLOCKED, &[light]),
            (false, _) => describer.format(CLEAR, &[light]),
        });
    }
    match (ray.returned, ray.sum) {
        (Some((light, _)), _) => {
            parts.push(format!("I = {}", node::color(light, describer.language)));
        }
        (None, Some(sum)) => {
            parts.push(format!("I_sum = {}", node::color(sum, describer.language)));
        }
        (None, None) => {}
    }
    parts.join("; ")
}
