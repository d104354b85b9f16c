//! Relative residual and error bound, iteration by iteration, on a logarithmic axis: two lines for every channel told so far.

use super::Show;
use super::labels::Labels;
use super::message::{NO_PATCHES, message};
use super::values::told_in_words;
use super::words::{Language, Words};
use crate::algorithms::stage::Stage;
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag, elide, number, power_of_ten};
use crate::replay::Run;
use crate::replay::radiosity::{ChannelNow, IterationNow, State};
use glam::Vec2;

const MARGIN: f32 = 8.0;
const TEXT: f32 = 11.0;
const ROW: f32 = 18.0;
/// Between two ticks, at least, in points.
const TICKS_APART: f32 = 22.0;
/// With more iterations some are passed over.
const MOST_POINTS: usize = 70;
/// Points so far apart have a mark each.
const MARKED: f32 = 9.0;
/// Nothing smaller is shown: it is no more than rounding.
const LEAST: f64 = 1e-18;

const RESIDUAL: Words = Words::new("relative residual", "residu relatif");
const BOUND: Words = Words::new("bound on the error", "batas galat");
const ITERATION: Words = Words::new("iteration k", "iterasi k");
const NONE_YET: Words = Words::new(
    "No iteration has come to its end yet.",
    "Belum ada iterasi yang selesai.",
);
/// Channels with their letter and ink.
const CHANNELS: [(&str, &str, Ink); 3] = [
    ("red", "R", Ink::Series(3)),
    ("green", "G", Ink::Series(2)),
    ("blue", "B", Ink::Series(0)),
];

pub fn draw(show: &Show, size: Vec2) -> Picture {
    let Run::Radiosity(stage, replay) = show.run else {
        return message(NO_PATCHES, show.language, size);
    };
    let state = replay.state();
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(show, state);
    let whole = picture.bounds().grown(-MARGIN);
    legend(
        &mut picture,
        Rect {
            height: ROW,
            ..whole
        },
        show.language,
    );
    let axes = Axes::new(stage, state, whole);
    axes.draw(&mut picture, show.language);
    let tolerance = stage.radiosity.stop.tolerance;
    axes.tolerance(&mut picture, tolerance);
    if state
        .channels
        .iter()
        .all(|channel| channel.history.is_empty())
    {
        let words = NONE_YET.in_language(show.language);
        let style = Style::Body.size(12.0).ink(Ink::Muted).middle();
        let words = elide(words, style.style, style.size, axes.place.width);
        picture.text_in(axes.place, words, style);
    }
    axes.cursor(&mut picture, state);
    let mut labels = Labels::new(axes.place.grown(2.0));
    for channel in &state.channels {
        axes.curves(&mut picture, channel, &mut labels);
    }
    picture
}

/// What the two kinds of line mean.
fn legend(picture: &mut Picture, row: Rect, language: Language) {
    const SAMPLE: f32 = 22.0;
    let style = Style::Body.size(TEXT).ink(Ink::Muted);
    let mut x = row.x;
    for (words, dashed) in [(RESIDUAL, false), (BOUND, true)] {
        let words = words.in_language(language);
        let width = SAMPLE + 5.0 + style.width(words);
        if x + width > row.right() {
            return;
        }
        let y = row.center().y;
        picture.line((x, y), (x + SAMPLE, y), kind_of_line(Ink::Text, dashed));
        let place = Rect {
            x: x + SAMPLE + 5.0,
            ..row
        };
        picture.text_in(place, words, style);
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
    fn new(stage: &Stage, state: &State, whole: Rect) -> Self {
        let mut values = vec![stage.radiosity.stop.tolerance, 1.0];
        let (mut first, mut last) = (u32::MAX, 1);
        for told in state
            .channels
            .iter()
            .flat_map(|channel| channel.history.iter())
        {
            values.push(told.residual);
            values.extend(told.error_bound);
            (first, last) = (first.min(told.k), last.max(told.k));
        }
        if let Some(k) = state.iteration {
            (first, last) = (first.min(k), last.max(k));
        }
        let room = stage.room().ok();
        let light = room.and_then(|room| room.light(room.matrix()?).ok());
        for solution in light.iter().flat_map(|light| &light.solutions) {
            values.push(solution.residual);
            last = last.max(solution.iterations.saturating_sub(1));
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
            first: if first == u32::MAX {
                0
            } else {
                first.min(last - 1)
            },
            last,
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
        let ends = [number(self.first.into()), number(self.last.into())];
        let title = ITERATION.in_language(language);
        let [first, last] = ends;
        let free = row.width - 2.0 * style.width(&last).max(style.width(&first)) - 16.0;
        picture.text_in(row, first, style);
        picture.text_in(row, last, style.end());
        if style.width(title) <= free {
            picture.text_in(row, title, style.middle());
        }
    }

    /// Below this line the solver stops. Its name stands at the left, where no curve is that low.
    fn tolerance(&self, picture: &mut Picture, tolerance: f64) {
        if tolerance <= 0.0 {
            return;
        }
        let y = self.y(tolerance);
        let stroke = Ink::Good.stroke(1.5).dotted();
        picture.line((self.place.x, y), (self.place.right(), y), stroke);
        let text = format!("ε = {}", number(tolerance));
        let style = Style::Body.size(TEXT).ink(Ink::Good);
        picture.text((self.place.x + 5.0, y - 4.0), text, style);
    }

    /// The iteration in hand.
    fn cursor(&self, picture: &mut Picture, state: &State) {
        if let Some(k) = state.iteration {
            let x = self.x(k);
            let stroke = Ink::This.stroke(1.5);
            picture.line((x, self.place.y), (x, self.place.bottom()), stroke);
        }
    }

    fn curves(&self, picture: &mut Picture, channel: &ChannelNow, labels: &mut Labels) {
        let known = CHANNELS
            .iter()
            .find(|(name, ..)| channel.channel == Some(name));
        let &(_, letter, ink) = known.unwrap_or(&("", "", Ink::Text));
        let told = few(channel);
        let apart = self.x(self.first + 1) - self.place.x;
        let bound = |told: &IterationNow| told.error_bound;
        let residual = |told: &IterationNow| Some(told.residual);
        let lines: [(&dyn Fn(&IterationNow) -> Option<f64>, bool); 2] =
            [(&bound, true), (&residual, false)];
        for (value, dashed) in lines {
            let points: Vec<(Vec2, u32)> = told
                .iter()
                .filter_map(|told| {
                    Some((Vec2::new(self.x(told.k), self.y(value(told)?)), told.step))
                })
                .collect();
            for pair in points.windows(2) {
                let [(from, _), (to, step)] = [pair[0], pair[1]];
                picture.tagged(Tag::Step(step as usize), |picture| {
                    picture.line(from, to, kind_of_line(ink, dashed));
                });
            }
            for &(at, step) in points
                .iter()
                .filter(|_| apart >= MARKED || points.len() == 1)
            {
                let paint = if dashed { Ink::Surface } else { ink };
                picture.tagged(Tag::Step(step as usize), |picture| {
                    picture.circle(at, 2.5, paint.fill().outlined(ink.stroke(1.25)));
                });
            }
            if let Some(&(at, _)) = points.last() {
                let style = Style::Bold.size(12.0).ink(Ink::Text);
                labels.put(picture, (at, 3.0), Vec2::new(1.0, -0.4), letter, style);
            }
        }
    }
}

/// The iterations of a channel that are drawn: not more than there is room for, and always the last.
fn few(channel: &ChannelNow) -> Vec<IterationNow> {
    let count = channel.history.len();
    let stride = count.div_ceil(MOST_POINTS).max(1);
    let told = channel.history.iter().enumerate();
    told.filter(|(n, _)| (count - 1 - n) % stride == 0 || *n == 0)
        .map(|(_, told)| *told)
        .collect()
}

fn in_words(show: &Show, state: &State) -> String {
    let say = |words: Words| words.in_language(show.language);
    let mut words = told_in_words(show);
    for channel in &state.channels {
        let Some(last) = channel
            .history
            .len()
            .checked_sub(1)
            .and_then(|last| channel.history.get(last))
        else {
            continue;
        };
        let name = channel.channel.unwrap_or_default();
        words = format!(
            "{words} {name}: {} {}, {} {}",
            say(ITERATION),
            last.k,
            say(RESIDUAL),
            number(last.residual)
        );
        if let Some(bound) = last.error_bound {
            words = format!("{words}, {} {}", say(BOUND), number(bound));
        }
        words.push('.');
    }
    words
}
