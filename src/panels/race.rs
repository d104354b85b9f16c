//! All solvers on the same room, side by side: what is left by iteration and by time, as far as the recorded run has come. Where
//! there is room, the residual, which a solver knows, stands above the error, which it does not.

use super::message::{NO_PATCHES, labelled, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties, names};
use crate::algorithms::radiosity::Unsolved;
use crate::algorithms::radiosity::race::{Lap, Race, Racer};
use crate::figure::{Axis, LEGEND_ROW, LEGEND_SAMPLE, Labels, Plot, Scale, elided, legend};
use crate::language::{Language, Message, called};
use crate::picture::{Ink, Picture, Rect, Style};
use crate::replay::Run;
use crate::replay::radiosity::State;
use glam::Vec2;

const MARGIN: f32 = 8.0;
const TEXT: f32 = 11.0;
/// Between a name and what follows it.
const GAP: f32 = 12.0;
/// What lies farther below the tolerance stands at the lower end: of the fields, LU would take the most for nothing.
const BELOW: f64 = 1e-2;

const ITERATIONS: Message = Message("race-iterations");
const TIME: Message = Message("race-time");
const RESIDUAL: Message = Message("common-relative-residual");
const ERROR: Message = Message("race-error");
const RUNNING: Message = Message("race-running");
const NO_SOLUTION: Message = Message("race-no-solution");
const NOT_BEGUN: Message = Message("race-not-begun");
const GAVE_UP: Message = Message("race-gave-up");
const ON_THE_WAY: Message = Message("race-on-the-way");
const GAVE_UP_AFTER: Message = Message("race-gave-up-after");
const PATCHES: Message = Message("race-patches");

pub const PANEL: Properties = Properties::titled(Message("app-race"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let Run::Radiosity(_, replay) = input.run else {
        return message(NO_PATCHES, input.language, size);
    };
    let race = match &input.finished.race {
        None => return message(RUNNING, input.language, size),
        Some(Err(_)) => return message(NO_SOLUTION, input.language, size),
        Some(Ok(race)) => race,
    };
    let state = replay.state();
    let Some(now) = Now::of(state, race) else {
        return message(NOT_BEGUN, input.language, size);
    };
    let mut picture = Picture::new(size.x, size.y);
    picture.alt = in_words(input, race, now);
    let whole = picture.bounds().grown(-MARGIN);
    let below = standings(&mut picture, race, now, whole, input.language);
    for (plot, place) in plots(Rect {
        height: below - whole.y,
        ..whole
    }) {
        plot.draw(&mut picture, race, now, place, input.language);
    }
    picture
}

/// How far the race is shown: as far as the run that is walked through has come.
#[derive(Clone, Copy)]
struct Now {
    sweeps: f64,
    seconds: f64,
}

impl Now {
    /// None before the first iteration is done. Once a channel is solved, to the end.
    fn of(state: &State, race: &Race) -> Option<Now> {
        const END: Now = Now {
            sweeps: f64::INFINITY,
            seconds: f64::INFINITY,
        };
        let first = state.channels.first()?;
        let channel = state.channel()?;
        if first.converged.is_some() || first.skipped.is_some() {
            return Some(END);
        }
        let last = channel.history.get(channel.history.len().checked_sub(1)?)?;
        let named = |solver| race.racers.iter().find(|racer| racer.solver == solver);
        let Some(racer) = named(channel.solver) else {
            return Some(END);
        };
        let done = f64::from(last.k) + 1.0;
        let by_count = |lap: &Lap| f64::from(lap.iterations);
        let seconds = racer.at(done, by_count).map_or(0.0, |lap| lap.seconds);
        let shots = if racer.solver.shoots() {
            race.patches as f64
        } else {
            1.0
        };
        Some(Now {
            sweeps: done / shots,
            seconds,
        })
    }
}

/// One field: what goes upward, and what to the right.
#[derive(Clone, Copy)]
struct Quantities {
    error: bool,
    time: bool,
}

/// Four fields where there is room for them, else two: the residual by iteration and the error by time; in a narrow panel the latter
/// alone.
fn plots(whole: Rect) -> Vec<(Quantities, Rect)> {
    if whole.width < 330.0 {
        let plot = Quantities {
            error: true,
            time: true,
        };
        return vec![(plot, whole)];
    }
    let half = Rect {
        width: 0.5 * whole.width,
        ..whole
    };
    let right = half.shifted(Vec2::new(half.width, 0.0));
    if whole.height < 270.0 {
        let plot = |both| Quantities {
            error: both,
            time: both,
        };
        return vec![(plot(false), half), (plot(true), right)];
    }
    let mut plots = Vec::new();
    for (row, error) in [false, true].into_iter().enumerate() {
        for (place, time) in [(half, false), (right, true)] {
            let height = 0.5 * whole.height;
            let place = Rect { height, ..place };
            let down = Vec2::new(0.0, height * row as f32);
            plots.push((Quantities { error, time }, place.shifted(down)));
        }
    }
    plots
}

impl Quantities {
    fn across(self, race: &Race, racer: &Racer, lap: &Lap) -> f64 {
        match self.time {
            true => lap.seconds,
            false => racer.sweeps(lap, race.patches),
        }
    }

    fn up(self, race: &Race, lap: &Lap) -> f64 {
        let left = if self.error { lap.error } else { lap.residual };
        left.max(BELOW * race.tolerance)
    }

    fn draw(self, picture: &mut Picture, race: &Race, now: Now, place: Rect, language: Language) {
        let laps = || {
            let racers = race.racers.iter();
            racers.flat_map(|racer| racer.laps.iter().map(move |lap| (racer, lap)))
        };
        let across = Scale::decades(laps().map(|(racer, lap)| self.across(race, racer, lap)));
        let up = laps().map(|(_, lap)| self.up(race, lap));
        let up = Scale::decades(up.chain([1.0, BELOW * race.tolerance]));
        let right = if self.time { TIME } else { ITERATIONS };
        let above = if self.error { ERROR } else { RESIDUAL };
        let plot = Plot::new(
            Axis::new(across, right.text(language), language),
            Axis::new(up, above.text(language), language),
            place,
        );
        plot.draw(picture);
        if !self.error {
            plot.level(picture, race.tolerance, Ink::Good.stroke(1.5).dotted());
        }
        let mut labels = Labels::new(plot.place.grown(2.0));
        let mut heads = Vec::new();
        for racer in &race.racers {
            let until = if self.time { now.seconds } else { now.sweeps };
            let shown = racer
                .laps
                .iter()
                .map(|lap| (self.across(race, racer, lap), self.up(race, lap)))
                .take_while(|&(across, _)| across <= until);
            let points: Vec<Vec2> = shown.map(|(x, y)| plot.point(x, y)).collect();
            let Some(&head) = points.last() else { continue };
            let series = racer.solver.series();
            labels.avoid_path(&points);
            if points.len() > 1 {
                picture.polyline(points, series.stroke);
            }
            picture.circle(head, 3.0, series.ink);
            heads.push((head, racer.solver));
        }
        for &(head, _) in &heads {
            labels.reserve(Rect::between(head, head).grown(3.0));
        }
        for (head, solver) in heads {
            let style = Style::Bold.size(TEXT);
            let toward = Vec2::new(1.0, -0.4);
            labels.put(picture, (head, 3.0), toward, solver.symbol(), style);
        }
    }
}

/// Under the fields, each solver with its line, its letters, its name and how far it has come; the latter only where all of it takes
/// no more than a third of the room. Returns where they begin.
fn standings(picture: &mut Picture, race: &Race, now: Now, whole: Rect, language: Language) -> f32 {
    let racers = race.racers.iter();
    let entries = racers.map(|racer| {
        let name = [racer.solver.symbol(), &short_name(racer, language)].join("  ");
        (racer.solver.series().stroke, name)
    });
    let entries: Vec<_> = entries.collect();
    let racers = race.racers.iter();
    let standings: Vec<_> = racers.map(|racer| standing(racer, now, language)).collect();
    let style = Style::Body.size(TEXT).ink(Ink::Muted);
    let widest = |texts: &mut dyn Iterator<Item = &String>| {
        texts.fold(0.0, |most: f32, text| most.max(style.width(text)))
    };
    let names = LEGEND_SAMPLE + widest(&mut entries.iter().map(|(_, name)| name)) + GAP;
    let cell = names + widest(&mut standings.iter()) + GAP;
    let columns = ((whole.width / cell) as usize).min(4);
    let rows = race.racers.len().div_ceil(columns.max(1));
    let top = whole.bottom() - LEGEND_ROW * rows as f32;
    if columns > 0 && top >= whole.y + 0.66 * whole.height {
        let width = whole.width / columns as f32;
        for (index, ((stroke, name), standing)) in entries.iter().zip(&standings).enumerate() {
            let (row, column) = (index % rows, index / rows);
            let x = whole.x + width * column as f32;
            let y = top + LEGEND_ROW * row as f32;
            legend(
                picture,
                [(*stroke, name.as_str())],
                Rect::new(x, y, width, LEGEND_ROW),
                x,
            );
            let text = Rect::new(x + names, y, width - names, LEGEND_ROW);
            elided(picture, text, standing, style);
        }
        return top - 4.0;
    }
    let entries = || {
        entries
            .iter()
            .map(|(stroke, name)| (*stroke, name.as_str()))
    };
    let place = |top| Rect { y: top, ..whole };
    let height = legend(&mut Picture::default(), entries(), place(0.0), whole.x);
    let top = whole.bottom() - height;
    legend(picture, entries(), place(top), whole.x);
    top - 4.0
}

/// Iterations and time to its end, or that it is not there yet.
fn standing(racer: &Racer, now: Now, language: Language) -> String {
    let localize = |strings: Message| strings.text(language);
    let Some(last) = racer.laps.last() else {
        return localize(ON_THE_WAY).to_owned();
    };
    if last.seconds > now.seconds {
        return localize(ON_THE_WAY).to_owned();
    }
    let (unit, many) = if last.seconds < 1e-3 {
        ("µs", 1e6)
    } else {
        ("ms", 1e3)
    };
    let effort = format!(
        "{} · {} {unit}",
        last.iterations,
        // No clock is good for more than three digits.
        language.significant(many * last.seconds, 3)
    );
    match racer.unsolved {
        None => effort,
        Some(Unsolved::NotConverged { .. }) => {
            GAVE_UP_AFTER.format(language, &[("effort", &effort)])
        }
        Some(_) => localize(GAVE_UP).to_owned(),
    }
}

fn in_words(input: &PanelInput, race: &Race, now: Now) -> String {
    let language = input.language;
    let patches = PATCHES.format(language, &[("count", &race.patches.to_string())]);
    let mut text = format!("{} {patches}.", step_as_sentence(input));
    for racer in &race.racers {
        let standing = standing(racer, now, language);
        let standing = labelled(&name(racer, language), &standing, language);
        text = format!("{text} {standing}.");
    }
    text
}

fn name(racer: &Racer, language: Language) -> String {
    names::word(racer.solver.name(), language)
}

/// The same where there is little room.
fn short_name(racer: &Racer, language: Language) -> String {
    let short = called("racer", racer.solver.name(), language);
    short.unwrap_or_else(|| name(racer, language))
}

#[cfg(test)]
mod tests {
    use super::super::fixture::Fixture;
    use super::super::fixtures::{self, assert_steps_are_legible, views_in_turn};
    use super::*;
    use crate::algorithms::focus::Focus;
    use crate::algorithms::radiosity::Solver;
    use crate::picture::Shape;
    use crate::render::Method;
    use std::convert::Infallible;

    /// The sample room whose race was run on a clock that ticks.
    fn fixture(solver: Solver, focus: Focus) -> Fixture {
        let mut fixture = Fixture::room(solver, focus);
        let room = fixture.run.enclosure().unwrap();
        let mut ticks = 0.0;
        let clock = || {
            ticks += 1e-6;
            ticks
        };
        let matrix = room.matrix().unwrap();
        let Ok(race) = room.race(matrix, clock, || Ok::<(), Infallible>(()));
        fixture.finished.race = Some(race);
        fixture
    }

    #[test]
    fn every_step_is_legible_at_every_size() {
        for mut fixture in [
            fixture(Solver::GaussSeidel, Focus::Frame),
            fixture(Solver::Shooting, Focus::Iterations { start: 5, end: 9 }),
            fixture(Solver::Auto, Focus::Patch(3)),
            Fixture::room(Solver::Auto, Focus::Frame),
            fixtures::fixtures(Method::Gouraud),
        ] {
            assert_steps_are_legible(&mut fixture, 9973, &views_in_turn(), draw);
        }
    }

    #[test]
    fn nobody_is_ahead_of_the_run_that_is_walked_through() {
        let mut fixture = fixture(Solver::GaussSeidel, Focus::Frame);
        let heads = |fixture: &Fixture| {
            let picture = draw(&fixture.input(), Vec2::new(640.0, 460.0));
            let circles = picture.items.iter().filter_map(|item| match item.shape {
                Shape::Circle { center, .. } => Some(center.x),
                _ => None,
            });
            circles.collect::<Vec<f32>>()
        };
        fixture.go_to("IterationDone", 0);
        let early = heads(&fixture);
        fixture.go_to("RoomDone", 0);
        let late = heads(&fixture);
        assert_eq!(late.len(), 4 * (Solver::ALL.len() - 1));
        assert!(early.len() < late.len());
        // The first field counts iterations: all who have done one stand at the first, and shots before it.
        let first = &early[..early.len() / 4];
        let most = first.iter().fold(0.0_f32, |most, &x| most.max(x));
        let last = late[..late.len() / 4]
            .iter()
            .fold(0.0_f32, |most, &x| most.max(x));
        assert!(most < last);
    }
}
