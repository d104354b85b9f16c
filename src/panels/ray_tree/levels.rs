//! The row under the tree: how much of the pixel each level of the tree gave so far, as numbers and as bars on one scale.

use super::node::{Describer, color, sum_symbol};
use super::strings::*;
use crate::color::Rgb;
use crate::figure::elided;
use crate::panels::channels;
use crate::picture::{Ink, Picture, Rect, Style};
use crate::replay::rays::State;

const LINE: f32 = 14.0;
/// Height of a bar, with the room under it.
const BAR: f32 = 5.0;
/// Between two levels.
const GAP: f32 = 6.0;
/// The least width of a level, with its numbers one under the other.
const NARROWEST: f32 = 46.0;
/// The width from which on a level has its three numbers in one line.
const IN_LINE: f32 = 96.0;
/// Width of the row's name, in a row that is wide enough for it.
const NAME: f32 = 118.0;
const WIDE: f32 = 560.0;

/// What a level gave, and what it is called; of the last one also those below, where there is no room for each.
struct Share {
    name: String,
    light: Option<Rgb>,
}

/// What rows beside each other have in common.
pub(super) struct Scale {
    /// So many levels.
    levels: usize,
    /// What a bar of full width stands for.
    largest: f64,
    /// Whether the bars are one a channel.
    colored: bool,
}

impl Scale {
    pub fn of(states: &[&State]) -> Self {
        let levels: Vec<_> = states.iter().map(|state| state.light_by_level()).collect();
        let largest = states
            .iter()
            .map(|state| state.light_so_far().max_channel());
        Scale {
            levels: levels.iter().map(Vec::len).max().unwrap_or(0),
            largest: largest.fold(0.0, f64::max),
            colored: levels
                .iter()
                .flatten()
                .flatten()
                .any(|light| !light.is_grey()),
        }
    }

    /// So many levels and the sum have room.
    fn columns(&self, room: f32) -> usize {
        let most = ((room - name_width(room)) / NARROWEST) as usize;
        self.levels.min(most.saturating_sub(1).max(1)) + 1
    }

    fn column_width(&self, room: f32) -> f32 {
        (room - name_width(room)) / self.columns(room) as f32
    }

    fn bars(&self) -> usize {
        if self.colored {
            channels::DRAWN.len()
        } else {
            1
        }
    }

    fn lines(&self, room: f32) -> usize {
        if self.column_width(room) >= IN_LINE {
            1
        } else {
            self.bars()
        }
    }
}

fn name_width(room: f32) -> f32 {
    if room >= WIDE { NAME } else { 0.0 }
}

/// How high the row is in a panel so wide; 0 where there is one level alone, or no ray yet.
pub(super) fn height(scale: &Scale, width: f32) -> f32 {
    if scale.levels < 2 {
        return 0.0;
    }
    LINE * (1 + scale.lines(width)) as f32 + BAR * scale.bars() as f32
}

pub(super) fn draw(picture: &mut Picture, describer: &Describer, scale: &Scale, area: Rect) {
    if scale.levels < 2 {
        return;
    }
    let name = name_width(area.width);
    if name > 0.0 {
        let place = Rect::new(area.x, area.y, name - GAP, LINE);
        let muted = Style::Body.size(11.0).ink(Ink::Muted);
        elided(picture, place, FROM_LEVEL.text(describer.language), muted);
    }
    let width = scale.column_width(area.width);
    let cell = |index: usize| {
        let x = area.x + name + width * index as f32;
        Rect::new(x, area.y, width - GAP, area.height)
    };
    let lines = scale.lines(area.width);
    let last = scale.columns(area.width) - 1;
    for (index, share) in shares(describer.state, last).iter().enumerate() {
        write(picture, describer, (scale, lines), share, cell(index));
    }
    let rule = cell(last).x - 0.5 * GAP;
    picture.line((rule, area.y), (rule, area.bottom()), Ink::Rule.stroke(1.0));
    let sum = Share {
        name: format!("= {}", sum_symbol(describer.state.rays.get(0))),
        light: Some(describer.state.light_so_far()),
    };
    write(picture, describer, (scale, lines), &sum, cell(last));
}

/// The levels as at most so many shares.
fn shares(state: &State, most: usize) -> Vec<Share> {
    let lights = state.light_by_level();
    let count = lights.len().min(most);
    let share = |index: usize| {
        let below = match index + 1 < count {
            true => index + 1,
            false => lights.len(),
        };
        let name = match below - index {
            1 => below.to_string(),
            _ => format!("{}–{below}", index + 1),
        };
        let light = lights[index..below].iter().flatten().copied();
        let light = light.reduce(|a, b| a + b);
        Share { name, light }
    };
    (0..count).map(share).collect()
}

fn write(
    picture: &mut Picture,
    describer: &Describer,
    (scale, lines): (&Scale, usize),
    share: &Share,
    area: Rect,
) {
    let set = Style::Label.size(11.0);
    let line = |index: usize| Rect::new(area.x, area.y + LINE * index as f32, area.width, LINE);
    elided(picture, line(0), &share.name, Style::LabelBold.size(11.0));
    let Some(light) = share.light else {
        elided(picture, line(1), NOT_KNOWN, set.ink(Ink::Muted));
        return;
    };
    let text = color(light, describer.language);
    if lines == 1 {
        elided(picture, line(1), &text, set);
    } else {
        for (index, number) in text.split(' ').enumerate() {
            elided(picture, line(1 + index), number, set);
        }
    }
    if scale.largest <= 0.0 {
        return;
    }
    let top = area.y + LINE * (1 + lines) as f32;
    for (index, value) in light.channels().into_iter().take(scale.bars()).enumerate() {
        let ink = match scale.colored {
            true => channels::DRAWN[index].ink,
            false => Ink::Muted,
        };
        let width = area.width * (value / scale.largest) as f32;
        let bar = Rect::new(area.x, top + BAR * index as f32, width, BAR - 1.5);
        picture.rect(bar, ink);
    }
}

/// The row in words.
pub(super) fn in_words(describer: &Describer) -> Option<String> {
    let lights = describer.state.light_by_level();
    if lights.len() < 2 {
        return None;
    }
    let come = lights.iter().enumerate().filter_map(|(index, light)| {
        let light = color((*light)?, describer.language);
        Some(format!("{}: {light}", index + 1))
    });
    let come: Vec<String> = come.collect();
    let name = FROM_LEVEL.text(describer.language);
    (!come.is_empty()).then(|| format!("{name} {}", come.join("; ")))
}

#[cfg(test)]
mod tests;
