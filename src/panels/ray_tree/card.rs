//! All about the current ray beside its tree: what it met, what stands before each light, and the light that comes back up.

mod entry;
pub(super) mod sections;

use super::node::{Describer, color, mark};
use crate::figure::elided;
use crate::picture::{Ink, Picture, Rect, Style, symbol};
use crate::replay::rays::RayState;
use entry::{Entry, Section};

const ROW: f32 = 17.0;

/// Draws the card. `returning` puts the light that comes back first; `rising` is the ray whose light came back last.
pub(super) fn draw(
    picture: &mut Picture,
    describer: &Describer,
    ray: &RayState,
    (rising, returning): (Option<usize>, bool),
    area: Rect,
) {
    let met = sections::surface(describer, ray);
    let lights = sections::lights(describer, ray);
    let back = sections::coming_back(describer, ray, rising);
    if area.width >= 600.0 {
        let half = 0.5 * (area.width - 16.0);
        let left = Rect::new(area.x, area.y, half, area.height);
        let right = Rect::new(left.right() + 16.0, area.y, half, area.height);
        column(picture, [Some(met), lights].into_iter().flatten(), left);
        column(picture, [back], right);
        return;
    }
    let sections = if returning {
        [Some(back), Some(met), lights]
    } else {
        [Some(met), lights, Some(back)]
    };
    column(picture, sections.into_iter().flatten(), area);
}

/// The current ray in one line.
pub(super) fn line(picture: &mut Picture, describer: &Describer, ray: &RayState, area: Rect) {
    let mut parts = vec![describer.name(ray)[0].clone()];
    let verdicts = ray.shadows.iter().map(|verdict| {
        let by = verdict.by.map(|hit| {
            format!(
                " {}, t {}",
                describer.object(hit.object),
                describer.number(hit.t)
            )
        });
        format!(
            "{} {}{}",
            describer.light(verdict.light),
            mark(!verdict.blocked),
            by.unwrap_or_default()
        )
    });
    parts.extend(verdicts);
    match (ray.returned, ray.sum) {
        (Some((returned, _)), _) => {
            parts.insert(1, format!("I {}", color(returned, describer.language)))
        }
        (None, Some(sum)) => parts.insert(
            1,
            format!("{} {}", symbol("I_sum"), color(sum, describer.language)),
        ),
        _ => {}
    }
    let set = Style::Label.size(11.0);
    elided(picture, area, &parts.join(" · "), set);
}

/// Sections from the top down, each line as far as there is room.
fn column(picture: &mut Picture, sections: impl IntoIterator<Item = Section>, area: Rect) {
    let mut y = area.y;
    for section in sections {
        // A headline alone says nothing.
        let least = if section.entries.is_empty() {
            ROW
        } else {
            2.0 * ROW
        };
        if y + least > area.bottom() {
            return;
        }
        y = write(picture, &section.title, area, y);
        for entry in &section.entries {
            y = write(picture, entry, area, y);
        }
        y += 6.0;
    }
}

/// Writes an entry on as many rows as it needs and there are; returns where the next one starts.
fn write(picture: &mut Picture, entry: &Entry, area: Rect, mut y: f32) -> f32 {
    let gap = entry.set.width(" ");
    let indent = if entry.swatch.is_some() { 16.0 } else { 0.0 };
    let mut rows: Vec<String> = Vec::new();
    for part in &entry.parts {
        let room = area.width - indent - if rows.len() > 1 { 12.0 } else { 0.0 };
        match rows.last_mut() {
            Some(row) if entry.set.width(row) + gap + entry.set.width(part) <= room => {
                row.push(' ');
                row.push_str(part);
            }
            _ => rows.push(part.clone()),
        }
    }
    for (i, row) in rows.iter().enumerate() {
        if y + ROW > area.bottom() + 0.01 {
            return y;
        }
        let further = if i > 0 { 12.0 } else { 0.0 };
        let place = Rect::new(
            area.x + indent + further,
            y,
            area.width - indent - further,
            ROW,
        );
        if let (0, Some(color)) = (i, entry.swatch) {
            let swatch = Rect::new(area.x, y + 2.5, 11.0, 11.0);
            picture.rect(
                swatch,
                Ink::Rgb(color).fill().outlined(Ink::Muted.stroke(1.0)),
            );
        }
        let add = |picture: &mut Picture| elided(picture, place, row, entry.set);
        match entry.tag {
            Some(tag) => {
                picture.tagged(tag, add);
            }
            None => add(picture),
        }
        y += ROW;
    }
    y
}
