//! Two patches, and the form factor between them as it is found: what was sampled so far, and the value as it runs against the
//! reference.

mod cross;
mod curve;
mod pair;
mod view;

use super::horizon::UNKNOWN;
use super::message::{NO_PATCHES, NO_STEPS, labelled, message};
use super::names;
use super::values::step_as_sentence;
use super::{PanelInput, Properties};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::figure::elided;
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Style, Text};
use crate::replay::Run;
use crate::replay::form_factor::{Running, State, Way};
use glam::Vec2;

const LINE: f32 = 15.0;
const NO_PAIR: Message = Message("form-factor-no-pair");
const EXACT: Message = Message("form-factor-exact");
const ERROR: Message = Message("common-error");
const HITS: Message = Message("form-factor-hits");
const FREE: Message = Message("form-factor-free");
const STANDARD_ERROR: Message = Message("form-factor-standard-error");

/// All that is drawn.
struct Layout<'a> {
    input: &'a PanelInput<'a>,
    prepared: &'a PreparedScene,
    room: &'a Enclosure,
    state: &'a State,
    i: usize,
    j: usize,
}

pub const PANEL: Properties = Properties::titled(Message("app-form-factor"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let (setup, replay) = match input.run {
        Run::FormFactor(setup, replay) => (setup, replay),
        Run::Radiosity(..) | Run::Hierarchical(..) => {
            return message(NO_PAIR, input.language, size);
        }
        _ => return message(NO_PATCHES, input.language, size),
    };
    if input.run.walk().is_empty() {
        return message(NO_STEPS, input.language, size);
    }
    let (Focus::FormFactor { i, j }, Some(room)) = (input.focus, input.run.enclosure()) else {
        return message(NO_PATCHES, input.language, size);
    };
    let layout = Layout {
        input,
        prepared: &setup.prepared,
        room,
        state: replay.state(),
        i: i as usize,
        j: j as usize,
    };
    let mut picture = Picture::new(size.x, size.y);
    layout.draw(&mut picture);
    let said: Vec<String> = layout.lines().into_iter().map(|(text, _)| text).collect();
    picture.alt = format!(
        "{} {}: {}.",
        step_as_sentence(input),
        layout.title(),
        said.join(", ")
    );
    picture
}

impl Layout<'_> {
    /// The patches beside the curve, above it, or alone above the words where there is room for no more.
    fn draw(&self, picture: &mut Picture) {
        let whole = picture.bounds().grown(-4.0);
        let is_wide = whole.width >= 330.0;
        let mut lines = self.lines();
        let share = if is_wide { 1.0 } else { 0.4 };
        lines.truncate((share * whole.height / LINE) as usize);
        let strings = LINE * lines.len() as f32;
        let (view, beside) = if is_wide {
            let width = (0.6 * whole.width).floor();
            let beside = Rect::new(
                whole.x + width + 8.0,
                whole.y,
                whole.width - width - 8.0,
                whole.height,
            );
            (Rect { width, ..whole }, beside)
        } else {
            let share = if whole.height >= 300.0 { 0.55 } else { 1.0 };
            let height = (share * whole.height)
                .min(whole.height - strings - 4.0)
                .floor();
            let beside = Rect::new(
                whole.x,
                whole.y + height + 4.0,
                whole.width,
                whole.height - height - 4.0,
            );
            (Rect { height, ..whole }, beside)
        };
        pair::draw(picture, self, view);

        let mut top = beside.bottom() - strings;
        for (at, (text, set)) in lines.into_iter().enumerate() {
            let y = top + at as f32 * LINE;
            let place = Rect::new(beside.x, y, beside.width, LINE);
            elided(picture, place, &text, set);
        }
        let free = |top: f32| top - beside.y - 6.0;
        if self.state.resolution.is_some() && free(top) >= 60.0 {
            let side = (0.5 * free(top)).clamp(60.0, 180.0).min(beside.width);
            let x = beside.x + 0.5 * (beside.width - side);
            cross::draw(picture, self, Rect::new(x, top - side - 4.0, side, side));
            top -= side + 8.0;
        }
        if free(top) >= 48.0 {
            let place = Rect::new(beside.x, beside.y, beside.width, free(top));
            curve::draw(picture, self, place);
        }
    }

    /// F_ij so far, with the step of each value.
    fn running(&self) -> Vec<(f64, usize)> {
        self.state.running_values(self.room.patches[self.i].area)
    }

    /// What is drawn as it settles, with its symbol: the share that nothing blocks, where lines of sight are tested, and F_ij.
    fn settling(&self) -> (Vec<(f64, usize)>, &'static str) {
        match self.state.shares.is_empty() {
            true => (self.running(), "F_i_j"),
            false => (self.state.shares.iter().copied().collect(), "V_i_j"),
        }
    }

    /// What the value runs against; it would give away where the value ends, and is hidden while a question waits.
    fn reference(&self) -> Option<f64> {
        let reference = self.state.reference.filter(|_| !self.input.is_pending());
        reference.map(|(f, _)| f)
    }

    fn title(&self) -> String {
        let name = |patch| names::patch(self.prepared, self.room, patch, self.input.language);
        let (i, j) = (self.i, self.j);
        format!("i = {i}: {} → j = {j}: {}", name(i), name(j))
    }

    /// The value, the reference, how far they are apart, how many rays met, and what nothing blocks.
    fn lines(&self) -> Vec<(String, Text)> {
        let language = self.input.language;
        let localize = |strings: Message| strings.text(language);
        let strong = Style::LabelBold.size(12.0).ink(Ink::This);
        let quiet = Style::Label.size(11.0).ink(Ink::Muted);
        let counted = |message: Message, part: usize, all: usize| {
            let [part, all] = [part, all].map(|count| count.to_string());
            let text = message.format(language, &[("part", &part), ("all", &all)]);
            (text, quiet)
        };
        let mut lines = Vec::new();
        let last = self.running().last().map(|&(f, _)| f);
        match (self.state.found, last) {
            (Some((f, _)), _) => lines.push((format!("F_i_j = {}", language.number(f)), strong)),
            (None, Some(f)) => lines.push((format!("F_i_j ← {}", language.number(f)), strong)),
            (None, None) => {}
        }
        if self.input.is_pending() && self.state.reference.is_some() {
            let text = labelled(localize(EXACT), UNKNOWN, language);
            lines.push((text, quiet.ink(Ink::Text)));
        }
        if let Some(exact) = self.reference() {
            let text = labelled(localize(EXACT), &language.number(exact), language);
            lines.push((text, quiet.ink(Ink::Text)));
            let found = self.state.found.map(|(f, _)| f);
            let whole = found.or(last.filter(|_| self.state.runs_as_mean()));
            if let Some(f) = whole.filter(|_| exact > 0.0) {
                let error = percent((f - exact) / exact, language);
                lines.push((labelled(localize(ERROR), &error, language), quiet));
            }
        }
        if let Some(batch) = self.state.batches.iter().last() {
            let count = batch.samples.to_string();
            let named = STANDARD_ERROR.format(language, &[("count", &count)]);
            let error = language.significant(batch.error, 3);
            let formula = match self.state.shares.is_empty() {
                true => "√(F (1 − F) / n) = ",
                false => "",
            };
            lines.push((named, quiet));
            lines.push((format!("s = {formula}{error}"), quiet));
        }
        let rays = self.state.running.len();
        if let Some((Running::Hits(hits), _)) = self.state.running.iter().last() {
            lines.push(counted(HITS, *hits as usize, rays));
        }
        let sights = self
            .state
            .segments
            .iter()
            .filter_map(|segment| match segment.way {
                Way::Sight { blocked, .. } => Some(!blocked),
                _ => None,
            });
        let (free, all) = sights.fold((0, 0), |(free, all), is_free| {
            (free + usize::from(is_free), all + 1)
        });
        if all > 0 {
            lines.push(counted(FREE, free, all));
        }
        if let Some((share, _)) = self.state.visible {
            lines.push((format!("V_i_j = {}", language.number(share)), quiet));
        }
        lines
    }
}

fn percent(share: f64, language: Language) -> String {
    format!("{} %", language.significant(100.0 * share, 2))
}

#[cfg(test)]
mod tests;
