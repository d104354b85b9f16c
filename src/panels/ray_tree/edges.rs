//! The edges: each by letter, line and colour, with its coefficient, and lit by the light that has come up along it.

use super::arrange::{Arrangement, Detail};
use super::node::{color, letter, line, nothing_passes, too_deep};
use super::pick::Rays;
use crate::algorithms::ray_tree::{End, RayKind};
use crate::figure::{cross, crosses, within};
use crate::language::Language;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::rays::{CurrentBranch, Outcome};
use glam::Vec2;

/// Width of the band of light under an edge.
const BAND: f32 = 5.0;

/// Draws all edges within `area`. `rising` is the ray whose light comes up at this step.
pub(super) fn draw(
    picture: &mut Picture,
    rays: &Rays,
    arrangement: &Arrangement,
    rising: Option<usize>,
    language: Language,
    area: Rect,
) {
    let mut taken: Vec<Rect> = arrangement
        .rects
        .iter()
        .map(|rect| rect.intersection(&area))
        .filter(|rect| !rect.is_empty())
        .collect();
    let mut labels = Vec::new();
    let mut lines = Vec::new();
    let nodes = arrangement.tree.nodes.iter().zip(&arrangement.rects);
    for ((node, rect), &detail) in nodes.zip(&arrangement.details) {
        let Some((parent, side)) = node.parent else {
            continue;
        };
        let above = &arrangement.tree.nodes[parent];
        let Some(branch) = rays.ray(above).and_then(|ray| ray.branches[side]) else {
            continue;
        };
        let from = arrangement.rects[parent];
        let ends = [
            Vec2::new(from.center().x, from.bottom()),
            Vec2::new(rect.center().x, rect.y),
        ];
        let Some([top, bottom]) = within(ends, area.grown(-BAND)) else {
            continue;
        };
        let ray = rays.ray(node);
        let tag = ray.map(|ray| Tag::Scope(ray.step));
        let index = match branch.outcome {
            Outcome::Ray(index) => Some(index),
            _ => None,
        };
        if let Some((light, _)) = ray.and_then(|ray| ray.returned) {
            let rises = rising.is_some() && rising == index;
            let (rim, ink) = if rises {
                (5.0, Ink::This)
            } else {
                (1.5, Ink::Muted)
            };
            let band = match detail {
                _ if rises => 1.6 * BAND,
                Detail::Dot => 0.6 * BAND,
                _ => BAND,
            };
            picture.line(top, bottom, ink.stroke(band + rim));
            picture.line(
                top,
                bottom,
                Ink::Rgb(branch.carried.unwrap_or(light)).stroke(band),
            );
        }
        let add = |picture: &mut Picture| {
            picture.line(top, bottom, line(branch.kind));
        };
        match tag {
            Some(tag) => {
                picture.tagged(tag, add);
            }
            None => add(picture),
        }
        if detail.min(arrangement.details[parent]) > Detail::Dot {
            labels.push((branch, lines.len(), arrangement.scale));
            lines.push(ends);
        }
    }
    for (branch, edge, scale) in labels {
        label(
            picture,
            &branch,
            language,
            (&lines, edge),
            scale,
            &mut taken,
            area,
        );
    }
    for (i, rect) in arrangement.rects.iter().enumerate() {
        if arrangement.details[i] > Detail::Dot {
            stubs(picture, rays, arrangement, i, *rect, area);
        }
    }
}

/// The letter with its coefficient, beside the middle of the edge on its outer side, or further along where that is taken, or on
/// the edge; where there is no room for that, the letter alone.
fn label(
    picture: &mut Picture,
    branch: &CurrentBranch,
    language: Language,
    (lines, edge): (&[[Vec2; 2]], usize),
    scale: f32,
    taken: &mut Vec<Rect>,
    area: Rect,
) {
    let set = Style::Bold.size(11.0 * scale);
    let letter = letter(branch.kind);
    let coefficient = branch
        .branch
        .map(|branch| color(branch.coefficient, language));
    let full = coefficient.map(|coefficient| format!("{letter} {coefficient}"));
    let mut others = lines.to_vec();
    let ends = others.swap_remove(edge);
    let left = branch.kind == RayKind::Reflected;
    for text in full.into_iter().chain([letter.to_owned()]) {
        let width = set.width(&text);
        let beside = beside(ends, Vec2::new(width + 2.0, 14.0 * scale), left);
        let is_clear = |place: &Rect| !others.iter().any(|&line| crosses(line, *place));
        let mut places = beside.filter(|place| is_free(*place, taken, area));
        if let Some(place) = places.find(is_clear) {
            picture.text_in(place, text, set);
            taken.push(place);
            return;
        }
        let mut on_it = upon(ends, Vec2::new(width + 4.0, 13.0 * scale));
        if let Some(place) = on_it.find(|place| is_free(*place, taken, area)) {
            picture.rounded_rect(place, 3.0, Ink::Surface);
            picture.text_in(place, text, set.middle());
            taken.push(place);
            return;
        }
    }
}

/// Places of that size beside a line, the best first: on its outer side, which is the left one or the right one.
fn beside([top, bottom]: [Vec2; 2], size: Vec2, left: bool) -> impl Iterator<Item = Rect> {
    let along = bottom - top;
    let flat = along.x.abs() > 1.2 * along.y;
    let out = if left { Vec2::NEG_X } else { Vec2::X };
    let away = along.perp().normalize_or_zero();
    let away = (BAND + 3.0) * if away.dot(out) < 0.0 { -away } else { away };
    let shares = [0.5, 0.62, 0.4, 0.72, 0.82, 0.9].into_iter();
    let offsets = shares.flat_map(move |share| [(share, away), (share, -away)]);
    offsets.map(move |(share, away)| {
        // Beside a steep line in mid-height; of a flat one with the corner that is nearest.
        let corner = Vec2::new(
            if away.x < 0.0 { size.x } else { 0.0 },
            match flat {
                false => 0.5 * size.y,
                true if away.y < 0.0 => size.y,
                true => 0.0,
            },
        );
        let place = top.lerp(bottom, share) + away - corner;
        Rect::new(place.x, place.y, size.x, size.y)
    })
}

/// Places of that size on a line, the best first.
fn upon([top, bottom]: [Vec2; 2], size: Vec2) -> impl Iterator<Item = Rect> {
    let shares = [0.5, 0.6, 0.4, 0.7, 0.3, 0.8, 0.2].into_iter();
    shares.map(move |share| {
        let place = top.lerp(bottom, share) - 0.5 * size;
        Rect::new(place.x, place.y, size.x, size.y)
    })
}

fn is_free(place: Rect, taken: &[Rect], area: Rect) -> bool {
    let covers = |taken: &Rect| !taken.intersection(&place).is_empty();
    area.encloses(&place) && !taken.iter().any(covers)
}

/// Branches without a ray, as short ends: with a bar where the depth is reached, faint where there is no coefficient, and
/// crossed out where nothing passes.
fn stubs(
    picture: &mut Picture,
    rays: &Rays,
    arrangement: &Arrangement,
    node: usize,
    rect: Rect,
    area: Rect,
) {
    let Some(ray) = rays.ray(&arrangement.tree.nodes[node]) else {
        return;
    };
    let deep = !too_deep(ray).is_empty();
    for (side, branch) in ray.branches.iter().enumerate() {
        let Some(branch) = branch else { continue };
        let Outcome::Ended(end) = branch.outcome else {
            continue;
        };
        let across = if side == 0 { 0.3 } else { 0.7 };
        let lean = if side == 0 { -1.0 } else { 1.0 };
        let (length, stroke) = match end {
            End::Depth => (11.0, line(branch.kind)),
            End::NoCoefficient => (6.0, Ink::Muted.stroke(1.0)),
        };
        let start = Vec2::new(rect.x + across * rect.width, rect.bottom());
        let tip = start + length * Vec2::new(0.5 * lean, 1.0);
        let bar = Vec2::new(4.0, 0.0);
        if area.encloses(&Rect::between(start - bar, tip + bar).grown(2.0)) {
            picture.line(start, tip, stroke);
            picture.line(
                tip - bar,
                tip + bar,
                Ink::Muted.stroke(if deep { 1.5 } else { 1.0 }),
            );
        }
    }
    if nothing_passes(ray) {
        let center = Vec2::new(rect.x + 0.62 * rect.width, rect.bottom() + 9.0);
        if area.encloses(&Rect::between(center, center).grown(6.0)) {
            picture.line(
                (center.x, rect.bottom()),
                center - Vec2::Y * 4.0,
                Ink::Muted.stroke(1.0).dashed(),
            );
            cross(picture, center, 3.5, 1.5);
        }
    }
}
