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

/// The levels as they fit, and the sum.
struct Levels {
    shares: Vec<Share>,
    sum: Rgb,
    /// Of a level.
    width: f32,
    /// Whether the bars are one a channel.
    colored: bool,
}

impl Levels {
    /// None where there is one level alone, or no ray yet.
    fn new(state: &State, room: f32) -> Option<Self> {
        let lights = state.light_by_level();
        if lights.len() < 2 {
            return None;
        }
        let room = room - name_width(room);
        let most = ((room / NARROWEST) as usize).saturating_sub(1).max(1);
        let count = lights.len().min(most);
        let shares = (0..count).map(|index| {
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
        });
        Some(Levels {
            shares: shares.collect(),
            sum: lights.iter().flatten().copied().sum(),
            width: room / (count + 1) as f32,
            colored: lights.iter().flatten().any(|light| !light.is_grey()),
        })
    }

    fn bars(&self) -> usize {
        if self.colored {
            channels::DRAWN.len()
        } else {
            1
        }
    }

    fn lines(&self) -> usize {
        if self.width >= IN_LINE {
            1
        } else {
            self.bars()
        }
    }
}

fn name_width(room: f32) -> f32 {
    if room >= WIDE { NAME } else { 0.0 }
}

/// How high the row is in a panel so wide; 0 where there is none.
pub(super) fn height(state: &State, width: f32) -> f32 {
    Levels::new(state, width).map_or(0.0, |levels| {
        LINE * (1 + levels.lines()) as f32 + BAR * levels.bars() as f32
    })
}

pub(super) fn draw(picture: &mut Picture, describer: &Describer, area: Rect) {
    let Some(levels) = Levels::new(describer.state, area.width) else {
        return;
    };
    let name = name_width(area.width);
    let place = Rect::new(area.x, area.y, name - GAP, LINE);
    if name > 0.0 {
        let muted = Style::Body.size(11.0).ink(Ink::Muted);
        elided(picture, place, FROM_LEVEL.text(describer.language), muted);
    }
    let cell = |index: usize| {
        let x = area.x + name + levels.width * index as f32;
        Rect::new(x, area.y, levels.width - GAP, area.height)
    };
    for (index, share) in levels.shares.iter().enumerate() {
        write(picture, describer, &levels, share, cell(index));
    }
    let last = cell(levels.shares.len());
    let rule = last.x - 0.5 * GAP;
    picture.line((rule, last.y), (rule, last.bottom()), Ink::Rule.stroke(1.0));
    let sum = Share {
        name: format!("= {}", sum_symbol(describer.state.rays.get(0))),
        light: Some(levels.sum),
    };
    write(picture, describer, &levels, &sum, last);
}

fn write(picture: &mut Picture, describer: &Describer, levels: &Levels, share: &Share, area: Rect) {
    let set = Style::Label.size(11.0);
    let line = |index: usize| Rect::new(area.x, area.y + LINE * index as f32, area.width, LINE);
    elided(picture, line(0), &share.name, Style::LabelBold.size(11.0));
    let Some(light) = share.light else {
        elided(picture, line(1), NOT_KNOWN, set.ink(Ink::Muted));
        return;
    };
    let values: Vec<f64> = light.channels().into_iter().take(levels.bars()).collect();
    let text = color(light, describer.language);
    if levels.lines() == 1 {
        elided(picture, line(1), &text, set);
    } else {
        for (index, number) in text.split(' ').enumerate() {
            elided(picture, line(1 + index), number, set);
        }
    }
    let largest = levels.sum.max_channel();
    let top = area.y + LINE * (1 + levels.lines()) as f32;
    for (index, value) in values.into_iter().enumerate() {
        let ink = match levels.colored {
            true => channels::DRAWN[index].ink,
            false => Ink::Muted,
        };
        let width = match largest > 0.0 {
            true => area.width * (value / largest) as f32,
            false => 0.0,
        };
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
