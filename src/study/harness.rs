//! Measures a study: each ladder's settings in turn, their errors, the laws they follow, and the front.

use super::errors::Errors;
use super::fit::{Fit, Law};
use super::form::{Axes, Drawn, Operations, Reference, Request, Setting, Study, Sweep};
use super::label::Label;
use super::pareto::front;
use super::timing::{Patience, Progress, Timing, time};
use crate::figure::Series;
use crate::language::Message;
use crate::render::Cancelled;
use crate::scene::Tessellation;

/// What a study found.
pub struct Findings {
    pub study: &'static Study,
    pub parts: Vec<Part>,
}

/// What one ladder came to.
#[derive(Clone, Debug)]
pub struct Part {
    pub title: Label,
    pub axes: Axes,
    pub size: Message,
    pub quantity: Message,
    pub reference: Reference,
    pub memory: Message,
    pub lines: Vec<Line>,
    pub failed: Vec<Failed>,
}

/// A setting without a result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failed {
    pub curve: Label,
    pub setting: Label,
    pub why: String,
}

/// What one curve came to.
#[derive(Clone, Debug)]
pub struct Line {
    pub name: Label,
    pub points: Vec<Point>,
    /// Of the error, over the size; settings whose error is that of the reference itself are left out. As all laws here it is
    /// that of the larger half of the sizes, three at least: what small ones do is not yet the order.
    pub convergence: Option<Fit>,
    /// Of the time, over the size.
    pub growth: Option<Fit>,
    /// Of the memory, likewise.
    pub memory_growth: Option<Fit>,
}

/// What one setting came to.
#[derive(Clone, Debug)]
pub struct Point {
    pub setting: Label,
    pub size: f64,
    pub errors: Option<Errors>,
    pub seconds: Timing,
    pub bytes: u64,
    pub operations: Vec<Operations>,
    /// What the setting draws, if anything.
    pub drawn: Option<Drawn>,
    /// Whether no other setting of the part is as quick and as exact.
    pub on_front: bool,
}

impl Findings {
    /// Lets go of the scenes that points can show, which may be large.
    pub fn forget_pictures(&mut self) {
        let lines = self.parts.iter_mut().flat_map(|part| &mut part.lines);
        for point in lines.flat_map(|line| &mut line.points) {
            point.drawn = None;
        }
    }
}

/// Of a scene that is measured, so that a study takes no more than some GB.
const MOST_POLYGONS: u64 = 1_000_000;

/// Why a study has no findings.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Unmeasured {
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// It says nothing about the scene that was given.
    #[error("{0}")]
    Because(String),
}

impl Study {
    /// Measures every ladder, and reports each as soon as it is `done`.
    pub fn measure(
        &'static self,
        request: &Request,
        progress: &Progress,
        done: &dyn Fn(&Part),
    ) -> Result<Findings, Unmeasured> {
        let polygons = request.scene.map_or(0, Tessellation::count);
        if polygons > MOST_POLYGONS {
            return Err(Unmeasured::Because(format!(
                "the scene divides into {polygons} polygons; at most {MOST_POLYGONS} are measured, since a study holds it several times"
            )));
        }
        let sweeps = (self.sweeps)(request).map_err(Unmeasured::Because)?;
        let patience = request.either(Patience::QUICK, Patience::THOROUGH);
        let count = sweeps.len();
        let mut parts = Vec::with_capacity(count);
        for (index, sweep) in sweeps.into_iter().enumerate() {
            let progress = |done, all| progress(index * all + done, count * all);
            let part = sweep.measure(patience, &progress)?;
            done(&part);
            parts.push(part);
        }
        Ok(Findings { study: self, parts })
    }
}

impl Sweep {
    pub fn measure(self, patience: Patience, progress: &Progress) -> Result<Part, Cancelled> {
        let curves: Vec<&[Setting]> = self
            .curves
            .iter()
            .map(|curve| &*curve.sweep_settings)
            .collect();
        let mut timed = time(&curves, patience, progress)?.into_iter();
        let (mut lines, mut failed) = (Vec::new(), Vec::new());
        for curve in self.curves {
            let mut points = Vec::new();
            for (sweep_setting, timed) in curve.sweep_settings.into_iter().zip(&mut timed) {
                match timed {
                    Err(why) => failed.push(Failed {
                        curve: curve.name.clone(),
                        setting: sweep_setting.setting,
                        why,
                    }),
                    Ok((values, seconds)) => {
                        let truth = sweep_setting.truth.as_deref();
                        let errors = truth.and_then(|truth| Errors::of(&values.numbers(), truth));
                        points.push(Point {
                            setting: sweep_setting.setting,
                            size: sweep_setting.size,
                            errors,
                            seconds,
                            bytes: sweep_setting.bytes,
                            operations: sweep_setting.operations,
                            drawn: sweep_setting.drawn,
                            on_front: false,
                        });
                    }
                }
            }
            lines.push(Line::of(curve.name, points, self.law, self.reference.error));
        }
        let mut points: Vec<&mut Point> =
            lines.iter_mut().flat_map(|line| &mut line.points).collect();
        // Errors below the reference's own cannot be told apart.
        let own_error = self.reference.error;
        let error = |point: &Point| {
            let errors = point.errors;
            errors.map_or(f64::NAN, |errors| errors.rms.max(own_error))
        };
        let places: Vec<(f64, f64)> = points
            .iter()
            .map(|point| (point.seconds.median, error(point)))
            .collect();
        for (point, on_front) in points.iter_mut().zip(front(&places)) {
            point.on_front = on_front;
        }
        Ok(Part {
            title: self.title,
            axes: self.axes,
            size: self.size,
            quantity: self.quantity,
            reference: self.reference,
            memory: self.memory,
            lines,
            failed,
        })
    }
}

/// Errors this many times the reference's own are distinguished from it.
const ABOVE_REFERENCE: f64 = 3.0;

impl Line {
    pub fn of(name: Label, points: Vec<Point>, law: Law, own_error: f64) -> Line {
        let errors = points.iter().filter_map(|point| {
            let rms = point.errors?.rms;
            (rms > ABOVE_REFERENCE * own_error).then_some((point.size, rms))
        });
        let seconds = points
            .iter()
            .map(|point| (point.size, point.seconds.median));
        let bytes = points.iter().map(|point| (point.size, point.bytes as f64));
        let convergence = Fit::through(law, larger_half(errors.collect()));
        let growth = Fit::through(Law::Power, larger_half(seconds.collect()));
        let memory_growth = Fit::through(Law::Power, larger_half(bytes.collect()));
        Line {
            name,
            points,
            convergence,
            growth,
            memory_growth,
        }
    }
}

/// The points of the larger half of the sizes, three at least.
fn larger_half(mut points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let count = points.len().div_ceil(2).max(3).min(points.len());
    points.split_off(points.len() - count)
}

impl Part {
    /// How a curve looks: as its method does in all plots, or as one of several.
    pub fn series(&self, line: usize) -> Series {
        let own = self.lines[line].name.series();
        own.unwrap_or_else(|| Series::of(line))
    }

    pub fn points(&self) -> impl Iterator<Item = (&Line, &Point)> {
        let lines = self.lines.iter();
        lines.flat_map(|line| std::iter::repeat(line).zip(&line.points))
    }

    /// The quickest setting whose rms error is at most `bound`, and those that tie with it.
    pub fn pick(&self, bound: f64) -> Option<(Choice<'_>, Vec<Choice<'_>>)> {
        let exact = |(_, point): &Choice| point.errors.is_some_and(|errors| errors.rms <= bound);
        let within: Vec<Choice> = self.points().filter(exact).collect();
        let quicker =
            |a: &&Choice, b: &&Choice| f64::total_cmp(&a.1.seconds.median, &b.1.seconds.median);
        let &best = within.iter().min_by(quicker)?;
        let tied = |(_, point): &Choice| {
            !std::ptr::eq(*point, best.1) && point.seconds.ties(&best.1.seconds)
        };
        let ties = within.iter().copied().filter(tied).collect();
        Some((best, ties))
    }
}

/// A setting with the curve that it belongs to.
pub type Choice<'a> = (&'a Line, &'a Point);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::form::{Curve, Values};
    use std::rc::Rc;
    use web_time::Duration;

    /// Of order 2, in a time that is that of busy work.
    fn sweep(own_error: f64) -> Sweep {
        let truth: Rc<[f64]> = Rc::new([1.0, 2.0]);
        let sweep_settings = [1.0, 2.0, 4.0, 8.0, 16.0].map(|n: f64| Setting {
            setting: Label::Plain(format!("n = {n}")),
            size: n,
            bytes: 8 * n as u64,
            operations: Vec::new(),
            truth: None,
            drawn: None,
            run: Box::new(move || {
                let work: f64 = (0..4000 * n as u32).map(f64::from).map(f64::sqrt).sum();
                std::hint::black_box(work);
                Ok(Values::Numbers(vec![1.0 + 0.1 / (n * n), 2.0]))
            }),
        });
        Sweep {
            title: Label::of("part-steps"),
            axes: Axes::ErrorOverTime,
            size: Message("measure-samples"),
            quantity: Message("measure-samples"),
            law: Law::Power,
            reference: Reference {
                what: Label::Plain("what is right".into()),
                error: own_error,
                known_by: Label::Plain("it is made up".into()),
            },
            memory: Message("memory-rays"),
            curves: vec![Curve::against(
                &truth,
                Label::Plain("curve".into()),
                sweep_settings.into(),
            )],
        }
    }

    const PATIENCE: Patience = Patience {
        shortest: Duration::ZERO,
        longest: Duration::from_secs(60),
        whole: Duration::ZERO,
        most_rounds: 5,
    };

    #[test]
    fn a_ladder_of_order_2_is_found_to_be_one() {
        let part = sweep(1e-12).measure(PATIENCE, &|_, _| Ok(())).unwrap();
        let line = &part.lines[0];
        let rms: Vec<f64> = line.points.iter().map(|p| p.errors.unwrap().rms).collect();
        for (n, rms) in [1.0, 2.0, 4.0, 8.0, 16.0].into_iter().zip(rms) {
            assert!((rms - 0.1 / (n * n) / 2_f64.sqrt()).abs() < 1e-15, "{rms}");
        }
        let order = line.convergence.unwrap();
        assert!((order.rate + 2.0).abs() < 1e-9, "{order:?}");
        assert!((line.memory_growth.unwrap().rate - 1.0).abs() < 1e-12);
        // The most exact one is not beaten.
        assert!(line.points[4].on_front);
        let (best, _) = part.pick(1e-3).unwrap();
        assert!(best.1.size >= 8.0, "{:?}", best.1.setting);
        assert!(part.pick(1e-9).is_none());
    }

    #[test]
    fn errors_below_that_of_the_reference_are_no_better_than_it_and_follow_no_law() {
        // Only the first two settings stand clearly above it.
        let part = sweep(0.01).measure(PATIENCE, &|_, _| Ok(())).unwrap();
        let line = &part.lines[0];
        assert_eq!(line.convergence, None);
        let below = line.points.iter().filter(|point| point.size >= 4.0);
        assert_eq!(below.filter(|point| point.on_front).count(), 1);
    }
}
