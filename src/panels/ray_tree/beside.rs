//! The tree of the pinned pixel at the left of that of the run: both colours, what each level gave on one scale, and the first
//! difference, ringed in both.

use super::arrange::{Arrangement, arrange};
use super::drawn::ShownTree;
use super::levels::{self, Scale};
use super::node::{Describer, bracketed, color, letter, sum_symbol};
use super::pick::Rays;
use super::strings::*;
use super::view::{HeldNode, TreeView};
use crate::algorithms::ray_tree::{End, RayKind};
use crate::algorithms::visible::Intersection;
use crate::figure::elided;
use crate::language::{Language, Message};
use crate::panels::message::labelled;
use crate::panels::values::step_in_words;
use crate::panels::{PanelInput, names};
use crate::picture::{Ink, Paint, Picture, Rect, Style, Tag};
use crate::replay::rays::{Difference, Differs, Outcome, State, first_difference};
use glam::Vec2;
use std::sync::Arc;

const MARGIN: f32 = 6.0;
const HEAD: f32 = 18.0;
/// Of the line that names the first difference.
const FOOT: f32 = 20.0;
/// Smaller panels have no room for two trees.
const LEAST: Vec2 = Vec2::new(480.0, 280.0);

/// The tree to compare with, where there is another one and room for both.
pub(super) fn pinned<'a>(input: &PanelInput<'a>, size: Vec2) -> Option<&'a State> {
    let (pinned, state) = (input.pinned?, input.run.rays()?);
    let same = pinned.pixel == state.pixel && Arc::ptr_eq(&pinned.prepared, &state.prepared);
    (!same && size.cmpge(LEAST).all()).then_some(pinned)
}

/// Of one tree and what belongs to it.
struct Half {
    head: Rect,
    tree: Rect,
    levels: Rect,
}

/// The halves, and the place of the line under both.
fn halves(trees: [&State; 2], size: Vec2) -> ([Half; 2], Rect) {
    let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-MARGIN);
    let foot = Rect::new(whole.x, whole.bottom() - FOOT, whole.width, FOOT);
    let width = 0.5 * whole.width - MARGIN;
    let row = levels::height(&Scale::of(&trees), width);
    let halves = [whole.x, whole.right() - width].map(|x| {
        let head = Rect::new(x, whole.y - 2.0, width, HEAD);
        let levels = Rect::new(x, foot.y - row - 4.0, width, row);
        Half {
            head,
            tree: Rect::between((x, head.bottom()), (x + width, levels.y - 4.0)),
            levels,
        }
    });
    (halves, foot)
}

/// Where the tree of the run stands.
pub(super) fn tree_area(trees: [&State; 2], size: Vec2) -> Rect {
    let ([_, half], _) = halves(trees, size);
    half.tree
}

/// Draws the pinned tree and that of the run.
pub(super) fn draw(input: &PanelInput, trees: [&State; 2], size: Vec2) -> Picture {
    let (halves, foot) = halves(trees, size);
    let rays = trees.map(Rays::new);
    let areas = halves.each_ref().map(|half| half.tree);
    let view = followed(input.tree, trees);
    let arrangements = [
        arrange(&rays[0], &view, areas[0]),
        arrange(&rays[1], input.tree, areas[1]),
    ];
    let difference = first_difference(trees);
    let scale = Scale::of(&trees);
    let language = input.language;
    let pinned = match Arc::ptr_eq(&trees[0].prepared, &trees[1].prepared) {
        true => PINNED,
        false => BEFORE_CHANGE,
    };
    let titles = [
        Title::new(trees[0], pinned, language),
        Title::new(trees[1], HERE, language),
    ];

    let mut picture = Picture::new(size.x, size.y);
    for (side, half) in halves.iter().enumerate() {
        let describer = Describer {
            state: trees[side],
            language: input.language,
        };
        let is_now = side == 1;
        let shown = ShownTree {
            rays: &rays[side],
            arrangement: &arrangements[side],
            rising: super::rising(input, trees[side]).0.filter(|_| is_now),
            is_now,
        };
        let mut tree = Picture::new(size.x, size.y);
        shown.draw(&mut tree, &describer, half.tree);
        if let Some(difference) = difference {
            ring(
                &mut tree,
                &rays[side],
                &arrangements[side],
                difference.rays[side],
                half.tree,
            );
        }
        if !is_now {
            // Its steps are those of another run.
            tree.items.iter_mut().for_each(|item| item.tag = None);
        }
        picture.items.extend(tree.items);
        titles[side].draw(&mut picture, trees[side], half.head);
        levels::draw(&mut picture, &describer, &scale, half.levels);
    }
    let middle = 0.5 * size.x;
    let rule = Ink::Rule.stroke(1.0);
    picture.line((middle, MARGIN), (middle, foot.y - 4.0), rule);
    let said = in_words(trees, difference, input);
    let set = Style::LabelBold.size(12.0);
    elided(&mut picture, foot, &said, set);
    let [one, other] = titles.map(|title| format!("{}, {}", title.pixel, title.light));
    picture.alt = format!("{}: {one}. {other}. {said}.", step_in_words(input));
    picture
}

/// What a half shows: a pixel, and its light so far.
struct Title {
    pixel: String,
    light: String,
}

impl Title {
    fn new(state: &State, name: Message, language: Language) -> Self {
        let (x, y) = state.pixel.unwrap_or_default();
        let (x, y) = (x.to_string(), y.to_string());
        let pixel = Message("focus-pixel").format(language, &[("x", &x), ("y", &y)]);
        let pixel = labelled(name.text(language), &pixel, language);
        let light = color(state.light_so_far(), language);
        let light = format!("{}  {light}", sum_symbol(state.rays.get(0)));
        Title { pixel, light }
    }

    fn draw(&self, picture: &mut Picture, state: &State, area: Rect) {
        let set = Style::Label.size(11.0);
        let width = set.width(&self.light);
        let swatch = Rect::new(
            area.right() - width - 17.0,
            area.center().y - 5.5,
            11.0,
            11.0,
        );
        let paint = Ink::Rgb(state.light_so_far()).fill();
        let name = Rect::between(area.min(), (swatch.x - 6.0, area.bottom()));
        let add = |picture: &mut Picture| {
            elided(picture, name, &self.pixel, Style::LabelBold.size(11.0));
            picture.rect(swatch, paint.outlined(Ink::Muted.stroke(1.0)));
            picture.text_in(area, self.light.as_str(), set.end());
        };
        match state.pixel {
            Some((x, y)) => drop(picture.tagged(Tag::Pixel { x, y }, add)),
            None => add(picture),
        }
    }
}

/// The view of the pinned tree: as large as the other one, with the same node in its middle, and the same nodes collapsed.
fn followed(view: &TreeView, [pinned, state]: [&State; 2]) -> TreeView {
    let index = |step: usize| state.rays.iter().position(|ray| ray.step == step);
    let same = |index| counterpart(state, index, pinned).and_then(|index| pinned.rays.get(index));
    let held = match view.held {
        Some(held) => index(held.ray).map(|index| (index, held.at)),
        None => state.current.map(|index| (index, Vec2::ZERO)),
    };
    let held = held.and_then(|(index, at)| {
        let ray = same(index)?.step;
        Some(HeldNode { ray, at })
    });
    let collapsed = view.collapsed.iter().copied();
    TreeView {
        zoom: view.zoom,
        held,
        collapsed: collapsed
            .filter_map(|step| Some(same(index(step)?)?.step))
            .collect(),
    }
}

/// The ray of `to` that stands where a ray of `from` stands, or the last one on the way there.
fn counterpart(from: &State, index: usize, to: &State) -> Option<usize> {
    let Some(parent) = from.rays.get(index)?.parent else {
        return Some(0);
    };
    let above = counterpart(from, parent, to)?;
    let branches = from.rays.get(parent)?.branches;
    let outcomes = branches.map(|branch| branch.map(|branch| branch.outcome));
    let side = outcomes
        .iter()
        .position(|&outcome| outcome == Some(Outcome::Ray(index)))?;
    match to.rays.get(above)?.branches[side].map(|branch| branch.outcome) {
        Some(Outcome::Ray(child)) => Some(child),
        _ => Some(above),
    }
}

/// A second outline around the node of a ray, where it is in view.
fn ring(picture: &mut Picture, rays: &Rays, arrangement: &Arrangement, ray: usize, area: Rect) {
    let step = rays.state.rays.get(ray).map(|ray| ray.step);
    let mut nodes = arrangement.tree.nodes.iter().zip(&arrangement.rects);
    let node = nodes.find(|(node, _)| rays.ray(node).map(|ray| ray.step) == step);
    let Some((_, rect)) = node.filter(|(_, rect)| area.encloses(rect)) else {
        return;
    };
    let ring = rect.grown(4.0);
    picture.clipped(area.grown(4.0), |picture| {
        picture.rounded_rect(ring, 8.0, Paint::from(Ink::Warn.stroke(2.5)));
    });
}

/// The first difference.
fn in_words(trees: [&State; 2], difference: Option<Difference>, input: &PanelInput) -> String {
    let language = input.language;
    let Some(Difference { rays, what }) = difference else {
        return SAME.text(language).to_owned();
    };
    let describer = |side: usize| Describer {
        state: trees[side],
        language,
    };
    let met = |side: usize, met: Intersection| match met {
        Intersection::Nothing => describer(side).localize(BACKGROUND),
        Intersection::Light { light, .. } => describer(side).light(light),
        Intersection::Object(hit) => describer(side).object(hit.object).to_owned(),
    };
    let ended = |kind: RayKind, end: Option<End>| {
        let why = match end {
            Some(End::Depth) => DEPTH_REACHED,
            Some(End::NoCoefficient) => NO_COEFFICIENT,
            None => GOES_ON,
        };
        labelled(letter(kind), why.text(language), language)
    };
    let [there, here] = match what {
        Differs::Met([a, b]) => [met(0, a), met(1, b)],
        Differs::Kind(kinds) => kinds.map(|kind| names::ray_kind(kind.name(), language).0),
        Differs::Coefficient(kind, lights) => {
            lights.map(|light| format!("{} {}", letter(kind), bracketed(light, language)))
        }
        Differs::End(kind, ends) => ends.map(|end| ended(kind, end)),
    };
    let level = trees[1].rays.get(rays[1]).map_or(1, |ray| ray.level);
    DIFFERS.format(
        language,
        &[
            ("level", &level.to_string()),
            ("pinned", &there),
            ("here", &here),
        ],
    )
}

#[cfg(test)]
mod tests;
