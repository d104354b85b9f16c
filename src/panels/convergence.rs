//! Relative residual and error bound, iteration by iteration, on a logarithmic axis: two lines for every channel told so far.

use super::labels::Labels;
use super::message::{NO_PATCHES, message};
use super::values::told_in_words;
use super::{PanelInput, names};
use crate::algorithms::focus::Focus;
use crate::language::{Language, Message, power_of_ten};
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag, elide};
use crate::replay::Run;
use crate::replay::radiosity::{ChannelNow, IterationNow, State};
use glam::Vec2;

const MARGIN: f32 = 8.0;
const TEXT: f32 = 11.0;
const ROW: f32 = 18.0;
/// Between two ticks, at least, in points.
const TICKS_APART: f32 = 22.0;
const TICKS_BESIDE: f32 = 56.0;
/// With more iterations some are passed over.
const MOST_POINTS: usize = 70;
/// Points so far apart have a mark each.
const MARKED: f32 = 9.0;
/// The axis begins here at the latest, wherever the run is looked at.
const LATEST: u32 = 1 << 30;
/// Nothing smaller is shown: it is no more than rounding.
const LEAST: f64 = 1e-18;

const RESIDUAL: Message = Message("common-relative-residual");
const BOUND: Message = Message("convergence-bound");
const ITERATION: Message = Message("convergence-iteration");
const NONE_YET: Message = Message("convergence-none-yet");
/// Channels with their letter and ink.
const CHANNELS: [(&str, &str, Ink); 3] = [
    ("red", "R", Ink::Series(3)),
    ("green", "G", Ink::Series(2)),
    ("blue", "B", Ink::Series(0)),
];

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let Run::Radiosity(setup, replay) = input.run else {
        return message(NO_PATCHES, input.language, size);
    };
    let state = replay.state();
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(input, state);
    let whole = picture.bounds().grown(-MARGIN);
    legend(
        &mut picture,
        Rect {
            height: ROW,
            ..whole
        },
        input.language,
    );
    let axes = Axes::new(
        setup.settings.radiosity.stop.tolerance,
        state,
        input.focus,
        whole,
    );
    axes.draw(&mut picture, input.language);
    let mut labels = Labels::new(axes.place.grown(2.0));
    let name = axes.tolerance(
        &mut picture,
        setup.settings.radiosity.stop.tolerance,
        input.language,
    );
    if let Some(name) = name {
        labels.reserve(name);
    }
    let recorded = |channel: &ChannelNow| !channel.history.is_empty();
    if !state.channels.iter().any(recorded) {
        axes.nothing(&mut picture, name, input.language);
    }
    axes.cursor(&mut picture, state);
    for channel in &state.channels {
        let letters = letters(channel, &state.channels);
        axes.curves(&mut picture, channel, &letters, &mut labels);
    }
    axes.newest(&mut picture, state);
    picture
}

/// Of the channel, and of those that share its solution.
fn letters(channel: &ChannelNow, channels: &[ChannelNow]) -> String {
    let alike = |other: &&ChannelNow| match other.skipped {
        Some((_, like)) => like.is_some() && like == channel.channel,
        None => std::ptr::eq(*other, channel),
    };
    let letters = channels.iter().filter(alike).filter_map(|other| {
        let known = CHANNELS
            .iter()
            .find(|(name, ..)| other.channel == Some(name));
        known.map(|(_, letter, _)| *letter)
    });
    letters.collect::<Vec<_>>().join(" ")
}

/// What the two kinds of line mean.
fn legend(picture: &mut Picture, row: Rect, language: Language) {
    const SAMPLE: f32 = 22.0;
    let style = Style::Body.size(TEXT).ink(Ink::Muted);
    let mut x = row.x;
    for (strings, dashed) in [(RESIDUAL, false), (BOUND, true)] {
        let strings = strings.text(language);
        let width = SAMPLE + 5.0 + style.width(strings);
        if x + width > row.right() {
            return;
        }
        let y = row.center().y;
        picture.line((x, y), (x + SAMPLE, y), kind_of_line(Ink::Text, dashed));
        let place = Rect {
            x: x + SAMPLE + 5.0,
            ..row
        };
        picture.text_in(place, strings, style);
        x += width + 14.0;
    }
}

/// Residuals have whole lines, bounds broken ones.
fn kind_of_line(ink: Ink, dashed: bool) -> Stroke {
    match dashed {
        true => ink.stroke(1.5).dashed(),
        false => ink.stroke(2.0),
    }
}

/// Iterations to the right, powers of ten upward.
struct Axes {
    place: Rect,
    /// Iterations, the first and the last.
    first: u32,
    last: u32,
    /// Exponents, the lowest and the highest.
    low: i32,
    high: i32,
}

impl Axes {
    /// As far as the finished solution goes, where there is one, so that the axes stay as they are from step to step.
    fn new(tolerance: f64, state: &State, focus: Focus, whole: Rect) -> Self {
        let ends = state.solved.as_ref().map_or(&[][..], |solved| &solved.ends);
        let mut values = vec![tolerance, 1.0];
        let mut last = ends.iter().map(|&(iterations, _)| iterations).max();
        last = last.map(|iterations| iterations.saturating_sub(1));
        let first = match focus {
            Focus::Iterations { start, end } => {
                last = last.map(|last| last.min(end.saturating_sub(1)));
                start.min(LATEST)
            }
            _ => {
                values.extend(ends.iter().map(|&(_, residual)| residual));
                0
            }
        };
        let mut last = last.unwrap_or(0).max(state.iteration.unwrap_or(0));
        for recorded in state
            .channels
            .iter()
            .flat_map(|channel| channel.history.iter())
        {
            values.push(recorded.residual);
            values.extend(recorded.error_bound);
            last = last.max(recorded.k);
        }
        let exponents = values
            .into_iter()
            .filter(|value| value.is_finite() && *value > 0.0)
            .map(|value| value.max(LEAST).log10());
        let (low, high) = exponents.fold((0.0_f64, 0.0_f64), |(low, high), exponent| {
            (low.min(exponent), high.max(exponent))
        });
        let (low, high) = (
            low.floor() as i32,
            (high.ceil() as i32).max(low.floor() as i32 + 1),
        );
        let style = Style::Body.size(TEXT);
        let names = [low, high].map(|exponent| style.width(&power_of_ten(exponent)));
        let left = names[0].max(names[1]) + 6.0;
        Axes {
            place: Rect::new(
                whole.x + left,
                whole.y + ROW + 6.0,
                whole.width - left - 4.0,
                whole.height - 2.0 * ROW - 8.0,
            ),
            first,
            last: last.max(first + 1),
            low,
            high,
        }
    }

    fn x(&self, k: u32) -> f32 {
        let share = f64::from(k.saturating_sub(self.first)) / f64::from(self.last - self.first);
        self.place.x + self.place.width * share as f32
    }

    /// What is too small to be shown, or nothing, stands at the lower end.
    fn y(&self, value: f64) -> f32 {
        let exponent = value.log10().clamp(self.low.into(), self.high.into());
        let share = (exponent - f64::from(self.low)) / f64::from(self.high - self.low);
        self.place.bottom() - self.place.height * share as f32
    }

    fn draw(&self, picture: &mut Picture, language: Language) {
        let style = Style::Body.size(TEXT).ink(Ink::Muted);
        let Rect { x, y, .. } = self.place;
        let (right, bottom) = (self.place.right(), self.place.bottom());
        let room = (self.place.height / TICKS_APART).max(1.0) as i32;
        let stride = ((self.high - self.low) / room + 1).max(1);
        for exponent in (self.low..=self.high).filter(|exponent| exponent % stride == 0) {
            let at = self.y(10_f64.powi(exponent));
            picture.line((x, at), (right, at), Ink::Rule.stroke(1.0).opacity(0.6));
            let baseline = at + style.baseline_below_middle();
            picture.text((x - 5.0, baseline), power_of_ten(exponent), style.end());
        }
        picture.line((x, y), (x, bottom), Ink::Muted.stroke(1.0));
        picture.line((x, bottom), (right, bottom), Ink::Muted.stroke(1.0));
        let row = Rect::new(x, bottom + 2.0, self.place.width, ROW);
        let title = ITERATION.text(language);
        picture.text_in(row, title, style.end());
        self.iterations(picture, row, right - style.width(title) - 8.0);
    }

    /// Numbers of iterations under the axis, as many as stand apart before `end`.
    fn iterations(&self, picture: &mut Picture, row: Rect, end: f32) {
        let style = Style::Body.size(TEXT).ink(Ink::Muted);
        let most = (self.place.width / TICKS_BESIDE).max(1.0) as u32;
        let stride = round_stride((self.last - self.first).div_ceil(most));
        let ticks = (self.first.next_multiple_of(stride)..=self.last).step_by(stride as usize);
        for k in ticks {
            let text = k.to_string();
            let width = style.width(&text);
            let left = (self.x(k) - 0.5 * width).max(row.x);
            if left + width <= end {
                let place = Rect { x: left, ..row };
                picture.text_in(place, text, style);
                let mark = Vec2::new(self.x(k), self.place.bottom());
                picture.line(mark, mark + Vec2::new(0.0, 3.0), Ink::Muted.stroke(1.0));
            }
        }
    }

    /// Below this line the solver stops. Returns the place of its name, at the left, where no curve is that low.
    fn tolerance(&self, picture: &mut Picture, tolerance: f64, language: Language) -> Option<Rect> {
        if tolerance <= 0.0 {
            return None;
        }
        let y = self.y(tolerance);
        let stroke = Ink::Good.stroke(1.5).dotted();
        picture.line((self.place.x, y), (self.place.right(), y), stroke);
        let text = format!("ε = {}", language.number(tolerance));
        let style = Style::Body.size(TEXT).ink(Ink::Good);
        let above = y - self.place.y > ROW;
        let at = Vec2::new(self.place.x + 5.0, if above { y - 4.0 } else { y + 13.0 });
        let place = style.bounds(at, &text);
        picture.text(at, text, style);
        Some(place)
    }

    /// Says that there are no points yet, away from the name of the tolerance.
    fn nothing(&self, picture: &mut Picture, name: Option<Rect>, language: Language) {
        let style = Style::Body.size(12.0).ink(Ink::Muted).middle();
        let strings = NONE_YET.text(language);
        let strings = elide(strings, style.style, style.size, self.place.width);
        let high = name.is_some_and(|name| name.center().y < self.place.center().y);
        let height = 0.5 * self.place.height;
        let upper = Rect {
            height,
            ..self.place
        };
        let down = if high { height } else { 0.0 };
        picture.text_in(upper.shifted(Vec2::new(0.0, down)), strings, style);
    }

    /// The iteration in hand.
    fn cursor(&self, picture: &mut Picture, state: &State) {
        if let Some(k) = state.iteration {
            let x = self.x(k);
            let stroke = Ink::This.stroke(1.5);
            picture.line((x, self.place.y), (x, self.place.bottom()), stroke);
        }
    }

    /// The point of the iteration in hand, once it is told.
    fn newest(&self, picture: &mut Picture, state: &State) {
        let Some(last) = state.channel().and_then(last_told) else {
            return;
        };
        if state.iteration == Some(last.k) {
            let at = Vec2::new(self.x(last.k), self.y(last.residual));
            picture.tagged(Tag::Step(last.step as usize), |picture| {
                picture.circle(at, 4.0, Ink::This);
            });
        }
    }

    fn curves(
        &self,
        picture: &mut Picture,
        channel: &ChannelNow,
        letters: &str,
        labels: &mut Labels,
    ) {
        let known = CHANNELS
            .iter()
            .find(|(name, ..)| channel.channel == Some(name));
        let ink = known.map_or(Ink::Text, |&(_, _, ink)| ink);
        let recorded = few(channel);
        let place = |k: u32, value: f64| Vec2::new(self.x(k), self.y(value));
        let bounds = recorded.iter().filter_map(|recorded| {
            Some((
                place(recorded.k, recorded.error_bound?),
                recorded.step as usize,
            ))
        });
        let bounds: Vec<(Vec2, usize)> = bounds.collect();
        let residuals = recorded
            .iter()
            .map(|recorded| (place(recorded.k, recorded.residual), recorded.step as usize));
        let residuals: Vec<(Vec2, usize)> = residuals.collect();

        // Dashes of short pieces would run together, so the broken line is one.
        if bounds.len() > 1 {
            let points = bounds.iter().map(|&(at, _)| at);
            picture.polyline(points, kind_of_line(ink, true));
        }
        for pair in residuals.windows(2) {
            let [(from, _), (to, step)] = [pair[0], pair[1]];
            picture.tagged(Tag::Step(step), |picture| {
                picture.line(from, to, kind_of_line(ink, false));
            });
        }
        let apart = self.x(self.first + 1) - self.place.x;
        for (points, fill) in [(&bounds, Ink::Surface), (&residuals, ink)] {
            for &(at, step) in points {
                if apart >= MARKED || points.len() == 1 {
                    picture.tagged(Tag::Step(step), |picture| {
                        picture.circle(at, 2.5, fill.fill().outlined(ink.stroke(1.25)));
                    });
                }
            }
            if let Some(&(at, _)) = points.last() {
                let style = Style::Bold.size(12.0);
                labels.put(picture, (at, 3.0), Vec2::new(1.0, -0.4), letters, style);
            }
        }
    }
}

fn last_told(channel: &ChannelNow) -> Option<&IterationNow> {
    channel.history.get(channel.history.len().checked_sub(1)?)
}

/// The least of 1, 2, 5, 10, 20, … that is not less than `least`.
fn round_stride(least: u32) -> u32 {
    let steps = (0..9).flat_map(|exponent| [1, 2, 5].map(|digit| digit * 10_u32.pow(exponent)));
    steps
        .into_iter()
        .find(|&step| step >= least)
        .unwrap_or(1_000_000_000)
}

/// The iterations of a channel that are drawn: not more than there is room for, and always the last.
fn few(channel: &ChannelNow) -> Vec<IterationNow> {
    let count = channel.history.len();
    let stride = count.div_ceil(MOST_POINTS).max(1);
    let recorded = channel.history.iter().enumerate();
    recorded
        .filter(|(n, _)| (count - 1 - n).is_multiple_of(stride) || *n == 0)
        .map(|(_, recorded)| *recorded)
        .collect()
}

fn in_words(input: &PanelInput, state: &State) -> String {
    let localize = |strings: Message| strings.text(input.language);
    let mut strings = told_in_words(input);
    for channel in &state.channels {
        let Some(last) = last_told(channel) else {
            continue;
        };
        let name = names::word(channel.channel.unwrap_or_default(), input.language);
        strings = format!(
            "{strings} {name}: {} {}, {} {}",
            localize(ITERATION),
            last.k,
            localize(RESIDUAL),
            input.language.number(last.residual)
        );
        if let Some(bound) = last.error_bound {
            strings = format!(
                "{strings}, {} {}",
                localize(BOUND),
                input.language.number(bound)
            );
        }
        strings.push('.');
    }
    strings
}

#[cfg(test)]
mod tests;
