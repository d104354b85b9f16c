//! What it saves to leave out what a scene does not need: the same picture, or the same light of a room, with each part left out and with
//! it done all the same, timed in turn and compared bit by bit.

use super::form::{Setting, Values};
use super::label::Label;
use super::timing::{Patience, Timing, time};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::radiosity::RecordFilter;
use crate::methods::Setup;
use crate::record::Unrecorded;
use crate::render::{Cancelled, Method, render};
use crate::scene::{Part, Parts};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// How far results of the exchange of light may differ where rounding goes another way, as a share of the largest: a thousandth of the
/// tolerance to which form factors and solutions are found.
pub const TOLERANCE: f64 = 1e-9;

/// What is saved by leaving out all that is not needed, and what by each part of it.
pub struct Ablations {
    /// With all of it left out.
    pub time: Timing,
    pub steps: Steps,
    /// With it done all the same: part by part, and last everything at once.
    pub parts: Vec<Ablation>,
}

/// A run in which something is done although it is not needed.
pub struct Ablation {
    /// None: everything.
    pub part: Option<Part>,
    /// Errors: why it was not run to its end.
    pub measured: Result<Measured, String>,
}

pub struct Measured {
    pub time: Timing,
    pub steps: Steps,
    pub sameness: Sameness,
}

/// The events that a recording of the whole run has, and the memory that they take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Steps {
    pub count: u64,
    pub bytes: u64,
}

/// How the result compares with the one that leaves all out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sameness {
    /// Bit by bit.
    Same,
    /// Within [`TOLERANCE`]: the largest difference, as a share of the largest value.
    Within(f64),
    Differs(f64),
}

impl Sameness {
    fn of(one: &[f64], other: &[f64]) -> Sameness {
        let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        if bits(one) == bits(other) {
            return Sameness::Same;
        }
        let largest = one.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let differences = one.iter().zip(other).map(|(a, b)| (a - b).abs() / largest);
        let difference = differences.fold(0.0, f64::max);
        match one.len() == other.len() && difference <= TOLERANCE {
            true => Sameness::Within(difference),
            false => Sameness::Differs(difference),
        }
    }
}

/// Measures every part that the scene does not need. Errors: why there is nothing to measure against.
pub fn ablations(
    setup: &Setup,
    method: Method,
    patience: Patience,
    progress: &dyn Fn(usize, usize),
) -> Result<Ablations, String> {
    // What no run need make again.
    let setup = setup.with_forced(Parts::NONE);
    setup.prepared.primitives();
    let skipped = setup.skipped(method);
    let is_left_out = |&part: &Part| skipped.iter().any(|skipped| skipped.part == part);
    let parts = Part::ALL.into_iter().filter(is_left_out);
    let mut runs: Vec<Option<Part>> = parts.map(Some).collect();
    if runs.len() > 1 {
        runs.push(None);
    }
    let forced = |run: &Option<Part>| run.map_or(Parts::ALL, Parts::from);
    let stages = std::iter::once(Parts::NONE).chain(runs.iter().map(forced));
    let stages: Vec<Arc<Setup>> = stages
        .map(|parts| Arc::new(setup.with_forced(parts)))
        .collect();
    let sweep_settings: Vec<Setting> = stages
        .iter()
        .map(|setup| sweep_setting(setup.clone(), method))
        .collect();
    let curves: Vec<&[Setting]> = sweep_settings.iter().map(std::slice::from_ref).collect();
    let heard = |done, all| {
        progress(done, all);
        Ok(())
    };
    let timed = time(&curves, patience, &heard).map_err(|called_off| called_off.to_string())?;
    let mut timed = timed.into_iter();
    let (values, time) = timed.next().ok_or("nothing was run")??;
    let without = values.numbers();
    let measured = |setup: &Setup, (values, time): (Values, Timing)| Measured {
        time,
        steps: steps(setup, method),
        sameness: Sameness::of(&without, &values.numbers()),
    };
    let parts = runs.into_iter().zip(&stages[1..]).zip(timed);
    let ablation = |((part, setup), timed): ((Option<Part>, &Arc<Setup>), _)| Ablation {
        part,
        measured: Result::map(timed, |timed| measured(setup, timed)),
    };
    Ok(Ablations {
        time,
        steps: steps(&stages[0], method),
        parts: parts.map(ablation).collect(),
    })
}

/// What the run takes with all left out that the scene does not need, and with what this stage does all the same. Errors: those of
/// `go_on`, which is asked before each run; inside, why one of the two is not timed.
pub fn both(
    setup: &Setup,
    method: Method,
    patience: Patience,
    go_on: &dyn Fn() -> Result<(), Cancelled>,
) -> Result<Result<[Timing; 2], String>, Cancelled> {
    setup.prepared.primitives();
    let sweep_settings = [Parts::NONE, setup.forced()]
        .map(|parts| sweep_setting(Arc::new(setup.with_forced(parts)), method));
    let curves = sweep_settings.each_ref().map(std::slice::from_ref);
    let mut timed = time(&curves, patience, &|_, _| go_on())?.into_iter();
    let mut next = || -> Result<Timing, String> {
        let (_, timing) = timed.next().ok_or("nothing was run")??;
        Ok(timing)
    };
    Ok(next().and_then(|first| Ok([first, next()?])))
}

fn sweep_setting(setup: Arc<Setup>, method: Method) -> Setting {
    Setting {
        setting: Label::Plain(String::new()),
        size: 1.0,
        bytes: 0,
        operations: Vec::new(),
        drawn: None,
        truth: None,
        run: Box::new(move || match method {
            Method::Radiosity => light(setup.enclosure().map_err(|error| error.to_string())?),
            _ => {
                // What belongs to the scene alone is found once.
                setup.needs();
                let frame = render(&setup, method, NonZeroUsize::MIN, &|_, _| {});
                Ok(Values::Picture(frame))
            }
        }),
    }
}

/// Form factors and solution, made anew.
fn light(enclosure: &Enclosure) -> Result<Values, String> {
    let matrix = enclosure.form_factors().matrix();
    let light = enclosure.solve(&matrix, &RecordFilter::default(), &mut Unrecorded);
    let light = light.map_err(|why| why.to_string())?;
    let radiosity = light.radiosity.iter();
    Ok(Values::Numbers(
        radiosity.flat_map(|b| b.channels()).collect(),
    ))
}

/// Counts the steps of the whole run.
fn steps(setup: &Setup, method: Method) -> Steps {
    let counted = method.count(setup);
    let count = counted.events.all();
    Steps {
        count,
        bytes: count * counted.event_size as u64,
    }
}
