//! Relative residual and error bound, iteration by iteration, on a logarithmic axis: two lines for every channel recorded so far.

use super::channels;
use super::message::{NO_PATCHES, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties, names};
use crate::algorithms::focus::Focus;
use crate::figure::{Axis, LEGEND_ROW, Labels, Plot, Scale, legend};
use crate::language::{Language, Message};
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag, Text, wrap};
use crate::replay::Run;
use crate::replay::radiosity::{ChannelNow, IterationNow, State};
use glam::Vec2;

const MARGIN: f32 = 8.0;
const TEXT: f32 = 11.0;
const LINE: f32 = 16.0;
/// Curves end beside the letters of their channels.
const ALL_LETTERS: &str = "R G B";
const BESIDE: f32 = 8.0;
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
const SO_FAR: Message = Message("convergence-so-far");
const SO_FAR_BOUNDED: Message = Message("convergence-so-far-bounded");

pub const PANEL: Properties = Properties::titled(Message("app-convergence"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let (Run::Radiosity(_, replay), Some(enclosure)) = (input.run, input.run.enclosure()) else {
        return message(NO_PATCHES, input.language, size);
    };
    let state = replay.state();
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(input, state);
    let whole = picture.bounds().grown(-MARGIN);
    let tolerance = enclosure.settings.stop.tolerance;
    let kinds = [(RESIDUAL, false), (BOUND, true)].map(|(strings, dashed)| {
        let stroke = kind_of_line(Ink::Text, dashed);
        (stroke, strings.text(input.language))
    });
    let row = Rect {
        height: LEGEND_ROW,
        ..whole
    };
    // The legend stands where the upright axis has its name.
    let below = legend(&mut picture, kinds, row, whole.x) - 0.5 * LEGEND_ROW;
    let place = Rect::between((whole.x, below), whole.max());
    let mut iterations = Iterations::new(tolerance, state, input, place);
    iterations.plot.draw(&mut picture);
    let name = iterations.tolerance(&mut picture, tolerance, input.language);
    if let Some(name) = name {
        iterations.labels.reserve(name);
    }
    let recorded = |channel: &ChannelNow| !channel.history.is_empty();
    if !state.channels.iter().any(recorded) {
        iterations.nothing(&mut picture, name, input.language);
    }
    if let Some(k) = state.iteration {
        let stroke = Ink::This.stroke(1.5);
        iterations.plot.upright(&mut picture, k.into(), stroke);
    }
    for channel in &state.channels {
        let letters = letters(channel, &state.channels);
        iterations.curves(&mut picture, channel, &letters);
    }
    iterations.newest(&mut picture, state);
    picture
}

/// Of the channel, and of those that share its solution.
fn letters(channel: &ChannelNow, channels: &[ChannelNow]) -> String {
    let alike = |other: &&ChannelNow| match other.skipped {
        Some((_, like)) => like.is_some() && like == channel.channel,
        None => std::ptr::eq(*other, channel),
    };
    let letters = channels.iter().filter(alike).filter_map(|other| {
        other
            .channel
            .and_then(channels::channel)
            .map(|known| known.letter)
    });
    letters.collect::<Vec<_>>().join(" ")
}

/// Of the letters of a channel.
fn letter() -> Text {
    Style::Bold.size(12.0)
}

/// Residuals have whole lines, bounds broken ones.
fn kind_of_line(ink: Ink, dashed: bool) -> Stroke {
    match dashed {
        true => ink.stroke(1.5).dashed(),
        false => ink.stroke(2.0),
    }
}

/// Iterations to the right, residuals and bounds upward.
struct Iterations {
    plot: Plot,
    first: u32,
    labels: Labels,
}

impl Iterations {
    /// As far as the finished solution goes, where there is one, so that the axes stay as they are from step to step; while a
    /// question waits, only as far as the run has come.
    fn new(tolerance: f64, state: &State, input: &PanelInput, whole: Rect) -> Self {
        let solved = state.solved.as_ref().filter(|_| !input.is_pending());
        let ends = solved.map_or(&[][..], |solved| &solved.ends);
        let mut values = vec![tolerance, 1.0];
        let mut last = ends.iter().map(|&(iterations, _)| iterations).max();
        last = last.map(|iterations| iterations.saturating_sub(1));
        let first = match input.focus {
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
        let values = values.into_iter().map(|value| value.max(LEAST));
        let iterations = Scale::whole(first.into(), last.max(first + 1).into());
        let plot = Plot::new(
            Axis::new(iterations, ITERATION.text(input.language), input.language),
            Axis::new(Scale::decades(values), "", input.language),
            Rect {
                width: whole.width - letter().width(ALL_LETTERS) - BESIDE,
                ..whole
            },
        );
        let field = plot.place.grown(2.0);
        Iterations {
            labels: Labels::new(Rect::between(
                (field.x, field.y),
                (whole.right(), field.bottom()),
            )),
            plot,
            first,
        }
    }

    /// Below this line the solver stops. Returns the place of its name, at the left, where no curve is that low.
    fn tolerance(&self, picture: &mut Picture, tolerance: f64, language: Language) -> Option<Rect> {
        if tolerance <= 0.0 {
            return None;
        }
        let stroke = Ink::Good.stroke(1.5).dotted();
        self.plot.level(picture, tolerance, stroke);
        let Vec2 { x, y } = self.plot.point(self.first.into(), tolerance);
        let text = format!("ε = {}", language.number(tolerance));
        let style = Style::Body.size(TEXT).ink(Ink::Good);
        let above = y - self.plot.place.y > LEGEND_ROW;
        let at = Vec2::new(x + 5.0, if above { y - 4.0 } else { y + 13.0 });
        let place = style.bounds(at, &text);
        picture.text(at, text, style);
        Some(place)
    }

    /// Says that there are no points yet, away from the name of the tolerance.
    fn nothing(&self, picture: &mut Picture, name: Option<Rect>, language: Language) {
        let style = Style::Body.size(12.0).ink(Ink::Muted).middle();
        let field = self.plot.place;
        let strings = NONE_YET.text(language);
        let high = name.is_some_and(|name| name.center().y < field.center().y);
        let half = 0.5 * field.height;
        let lines = wrap(strings, style.style, style.size, field.width - 8.0);
        let middle = field.y + if high { 1.5 * half } else { 0.5 * half };
        let top = middle - 0.5 * LINE * lines.len() as f32;
        for (at, line) in lines.into_iter().enumerate() {
            let row = Rect::new(field.x, top + LINE * at as f32, field.width, LINE);
            let width = style.width(&line) + 8.0;
            let ground = Rect::new(field.center().x - 0.5 * width, row.y, width, LINE);
            picture.rect(ground, Ink::Surface);
            picture.text_in(row, line, style);
        }
    }

    /// The point of the current iteration, once it is recorded.
    fn newest(&self, picture: &mut Picture, state: &State) {
        let Some(last) = state.channel().and_then(last_recorded) else {
            return;
        };
        if state.iteration == Some(last.k) {
            let at = self.plot.point(last.k.into(), last.residual);
            picture.tagged(Tag::Step(last.step as usize), |picture| {
                picture.circle(at, 4.0, Ink::This);
            });
        }
    }

    fn curves(&mut self, picture: &mut Picture, channel: &ChannelNow, letters: &str) {
        let known = channel.channel.and_then(channels::channel);
        let ink = known.map_or(Ink::Text, |known| known.ink);
        let recorded = few(channel);
        let place = |k: u32, value: f64| self.plot.point(k.into(), value);
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
        let second = self.plot.point(f64::from(self.first) + 1.0, 1.0);
        let apart = second.x - self.plot.place.x;
        for (points, fill) in [(&bounds, Ink::Surface), (&residuals, ink)] {
            for &(at, step) in points {
                if apart >= MARKED || points.len() == 1 {
                    picture.tagged(Tag::Step(step), |picture| {
                        picture.circle(at, 2.5, fill.fill().outlined(ink.stroke(1.25)));
                    });
                }
            }
            if let Some(&(at, _)) = points.last() {
                let toward = Vec2::new(1.0, -0.4);
                self.labels
                    .put(picture, (at, 3.0), toward, letters, letter());
            }
        }
    }
}

fn last_recorded(channel: &ChannelNow) -> Option<&IterationNow> {
    channel.history.get(channel.history.len().checked_sub(1)?)
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
    let language = input.language;
    let mut sentences = vec![step_as_sentence(input)];
    for channel in &state.channels {
        let Some(last) = last_recorded(channel) else {
            continue;
        };
        let name = names::word(channel.channel.unwrap_or_default(), language);
        let (k, residual) = (last.k.to_string(), language.number(last.residual));
        let arguments = [("channel", &*name), ("k", &k), ("residual", &residual)];
        sentences.push(match last.error_bound.map(|bound| language.number(bound)) {
            Some(bound) => {
                let [channel, k, residual] = arguments;
                SO_FAR_BOUNDED.format(language, &[channel, k, residual, ("bound", &bound)])
            }
            None => SO_FAR.format(language, &arguments),
        });
    }
    sentences.join(" ")
}

#[cfg(test)]
mod tests;
