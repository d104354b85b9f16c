//! The binary ray tree of the current pixel, as far as it is traced: a node a ray with what it met, an edge a coefficient, a leaf
//! the reason why it ended; and the light that comes back up, sum by sum.

mod arrange;
mod card;
mod edges;
mod node;
mod pick;
mod strings;
mod tidy;
mod view;

#[cfg(test)]
mod tests;

pub use view::TreeView;

use super::message::message;
use super::values::step_in_words;
use super::{PanelInput, Properties};
use crate::algorithms::ray_tree::RayKind;
use crate::figure::elided;
use crate::language::Message;
use crate::methods::Method;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::rays::{Outcome, RayState, State};
use arrange::{Arrangement, Detail, arrange};
use glam::Vec2;
use node::{Describer, Standing, letter, line};
use pick::{Node, Rays};
use strings::*;

const MARGIN: f32 = 6.0;
/// Of the line above the tree.
const HEAD: f32 = 18.0;
/// Of the sign that collapses and expands.
const SIGN: f32 = 6.0;

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
    let describer = Describer {
        state,
        language: input.language,
    };
    let rays = Rays::new(state);
    let places = Places::new(size);
    let arrangement = arrange(&rays, input.tree, places.tree);
    let (rising, returning) = rising(input, state);

    let mut picture = Picture::new(size.x, size.y);
    edges::draw(
        &mut picture,
        &rays,
        &arrangement,
        rising,
        input.language,
        places.tree,
    );
    nodes(&mut picture, &describer, &rays, &arrangement, places.tree);
    let levels = input.run.method() == Method::RayTracing;
    let said = said_of_tree(&describer, &rays, &arrangement, levels);
    let branches = arrangement.tree.nodes.len() > 1;
    head(&mut picture, &said, branches, places.head);
    if let Some(place) = places.card {
        picture.line(place.rule[0], place.rule[1], Ink::Rule.stroke(1.0));
        card::draw(
            &mut picture,
            &describer,
            ray,
            (rising, returning),
            place.rect,
        );
    } else {
        card::line(&mut picture, &describer, ray, places.foot);
    }
    picture.alt = format!(
        "{}: {said}. {}.",
        step_in_words(input),
        in_words(&describer, ray)
    );
    picture
}

/// Where the middle of the tree's area lies, as shares of the tree's box; none where no tree is drawn.
pub fn middle(input: &PanelInput, size: Vec2) -> Option<Vec2> {
    let state = input.run.rays()?;
    state.ray()?;
    let arrangement = arrange(&Rays::new(state), input.tree, Places::new(size).tree);
    Some(arrangement.middle)
}

/// The part of a panel that the tree is drawn in.
pub fn area(size: Vec2) -> Rect {
    Places::new(size).tree
}

/// What is drawn where.
struct Places {
    head: Rect,
    tree: Rect,
    card: Option<CardPlace>,
    foot: Rect,
}

#[derive(Clone, Copy)]
struct CardPlace {
    rect: Rect,
    rule: [Vec2; 2],
}

impl Places {
    /// The card under the tree where the panel is high, beside it where it is wide; else one line.
    fn new(size: Vec2) -> Self {
        let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-MARGIN);
        let head = Rect::new(whole.x, whole.y - 2.0, whole.width, HEAD);
        let body = Rect::between((whole.x, head.bottom()), whole.max());
        let foot = Rect::new(body.x, body.bottom() - HEAD + 3.0, body.width, HEAD);
        if body.height >= 330.0 {
            let height = if body.width >= 620.0 {
                (0.32 * body.height).clamp(124.0, 180.0)
            } else {
                (0.4 * body.height).clamp(124.0, 260.0)
            };
            let tree = Rect::new(body.x, body.y, body.width, body.height - height - 14.0);
            let y = tree.bottom() + 4.0;
            let rect = Rect::new(
                body.x + 4.0,
                body.bottom() - height,
                body.width - 8.0,
                height,
            );
            let rule = [Vec2::new(body.x, y), Vec2::new(body.right(), y)];
            let card = Some(CardPlace { rect, rule });
            return Places {
                head,
                tree,
                card,
                foot,
            };
        }
        if body.width >= 560.0 {
            let width = (0.42 * body.width).clamp(250.0, 420.0);
            let tree = Rect::new(body.x, body.y, body.width - width - 16.0, body.height);
            let x = tree.right() + 7.0;
            let rect = Rect::new(tree.right() + 16.0, body.y, width - 2.0, body.height);
            let rule = [Vec2::new(x, body.y), Vec2::new(x, body.bottom())];
            let card = Some(CardPlace { rect, rule });
            return Places {
                head,
                tree,
                card,
                foot,
            };
        }
        let tree = Rect::new(body.x, body.y, body.width, body.height - HEAD);
        Places {
            head,
            tree,
            card: None,
            foot,
        }
    }
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

fn nodes(
    picture: &mut Picture,
    describer: &Describer,
    rays: &Rays,
    arrangement: &Arrangement,
    area: Rect,
) {
    let current = arrangement.tree.current;
    // The current node lies on top.
    let order = (0..arrangement.rects.len()).filter(|&node| node != current);
    for index in order.chain([current]) {
        let node = &arrangement.tree.nodes[index];
        let (whole, detail) = (arrangement.rects[index], arrangement.details[index]);
        let rect = whole.intersection(&area);
        if rect.is_empty() {
            continue;
        }
        let ray = rays.ray(node);
        let standing = match ray {
            _ if index == current => Standing::Current,
            None => Standing::Asked,
            Some(ray) if ray.returned.is_some() => Standing::Returned,
            Some(_) => Standing::Open,
        };
        let add = |picture: &mut Picture| {
            let seen_whole = area.grown(0.5).encloses(&whole);
            if detail > Detail::Dot || seen_whole {
                node::frame(picture, rect, standing, ray, detail);
            }
            if seen_whole && detail > Detail::Dot {
                node::write(picture, describer, whole, ray, detail, arrangement.scale);
            }
        };
        match ray {
            Some(ray) => {
                picture.tagged(Tag::Scope(ray.step), add);
            }
            None => add(picture),
        }
        if let Some(ray) = ray {
            sign(picture, ray, node, (whole, detail), area);
        }
    }
}

/// Under a node what collapses it, or how many rays are hidden below.
fn sign(
    picture: &mut Picture,
    ray: &RayState,
    node: &Node,
    (rect, detail): (Rect, Detail),
    area: Rect,
) {
    let bottom = Vec2::new(rect.center().x, rect.bottom());
    let center = bottom + Vec2::Y * (SIGN - 1.0);
    if node.hidden > 0 && detail == Detail::Dot {
        let tip = bottom + Vec2::new(0.0, 5.0);
        let points = [bottom - Vec2::X * 4.0, bottom + Vec2::X * 4.0, tip];
        if area.encloses(&Rect::between(points[0], tip)) {
            picture.polygon(points, Ink::Muted);
        }
        return;
    }
    if node.hidden > 0 {
        let set = Style::Bold.size(11.0).middle();
        let text = format!("+{}", node.hidden);
        let width = set.width(&text) + 12.0;
        let pill = Rect::new(bottom.x - 0.5 * width, bottom.y + 2.0, width, 16.0);
        if !area.encloses(&pill) {
            return;
        }
        // What the viewer collapsed can be expanded; what there is no room for is gone to.
        let tag = if node.collapsed {
            Tag::Fold(ray.step)
        } else {
            Tag::Scope(ray.step)
        };
        picture.tagged(tag, |picture| {
            let paint = Ink::LinkedTint.fill().outlined(Ink::Linked.stroke(1.0));
            picture.rounded_rect(pill, 8.0, paint);
        });
        picture.text_in(pill, text, set);
        return;
    }
    if node.children == [None; 2] || detail == Detail::Dot {
        return;
    }
    if !area.encloses(&Rect::between(center, center).grown(SIGN + 1.0)) {
        return;
    }
    picture.tagged(Tag::Fold(ray.step), |picture| {
        let paint = Ink::Surface.fill().outlined(Ink::Muted.stroke(1.0));
        picture.circle(center, SIGN, paint);
    });
    let arm = Vec2::X * (SIGN - 3.0);
    picture.line(center - arm, center + arm, Ink::Text.stroke(1.5));
}

/// How large the tree is.
fn said_of_tree(
    describer: &Describer,
    rays: &Rays,
    arrangement: &Arrangement,
    levels: bool,
) -> String {
    let counted =
        |message, count: usize| describer.format(message, &[("count", &count.to_string())]);
    let mut text = counted(RAYS, rays.len());
    if arrangement.tree.hidden > 0 {
        text += ", ";
        text += &counted(HIDDEN, arrangement.tree.hidden);
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
