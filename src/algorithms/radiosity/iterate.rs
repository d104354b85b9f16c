//! The loop that every solver shares: iterate until the residual is small, the limit is met, or the iteration diverges.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::outcome::{Solution, Stop, Unsolved};
use super::record_filter::{Followed, RecordFilter};
use super::stagnation::Stagnation;
use super::system::Patches;
use crate::record::{Recorder, Unrecorded};

/// A residual that has grown this much over the first one does not come back.
const DIVERGED: f64 = 1e6;

/// One way to solve the system, an iteration at a time.
pub(super) trait Method {
    fn iterate<R: Recorder<SolverEvent>>(
        &mut self,
        followed: Followed,
        recorder: &mut R,
    ) -> Result<(), Unsolved>;
    fn radiosity(&self) -> &[f64];
    /// r = E − (I − ρF)B, as the method knows it.
    fn residual(&self) -> &[f64];
    /// Whether the residual is carried along from iteration to iteration, so that it departs from that of B by rounding.
    const CARRIES_RESIDUAL: bool = false;
    /// Computes the residual anew, where it is carried along.
    fn confirm(&mut self) {}
    /// max_i ρ_i Σ_j F_ij, where it is known.
    fn gain(&self) -> Option<f64>;
}

/// Marks each event with the solver that recorded it.
pub(super) struct TaggingRecorder<'r, R> {
    pub solver: Solver,
    pub recorder: &'r mut R,
}

impl<R: Recorder<Event>> Recorder<SolverEvent> for TaggingRecorder<'_, R> {
    #[inline(always)]
    fn step(&mut self, recorded: impl FnOnce() -> SolverEvent) {
        let solver = self.solver;
        self.recorder.step(|| Event {
            solver,
            recorded: recorded(),
        });
    }
    #[inline(always)]
    fn enter(&mut self, recorded: impl FnOnce() -> SolverEvent) {
        let solver = self.solver;
        self.recorder.enter(|| Event {
            solver,
            recorded: recorded(),
        });
    }
    #[inline(always)]
    fn leave(&mut self, recorded: impl FnOnce() -> SolverEvent) {
        let solver = self.solver;
        self.recorder.leave(|| Event {
            solver,
            recorded: recorded(),
        });
    }
}

/// Runs `method` to its end. Watched or not, the iterations are the same.
pub(super) fn run<M: Method, R: Recorder<SolverEvent>>(
    mut method: M,
    patches: &Patches,
    stop: Stop,
    filter: &RecordFilter,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    recorder.enter(|| SolverEvent::System {
        patches: patches.len() as u32,
        gain: method.gain(),
    });
    let emitted = norm(patches.emission);
    let relative = |method: &_| relative(method, emitted);
    let first = relative(&method);
    let (mut iterations, mut residual) = (0, first);
    let mut stagnation = Stagnation::new(first);
    let mut watched = false;
    let outcome = loop {
        // Where watching begins, the values of every patch
        if filter.takes(iterations) && !watched {
            record_values(&method, recorder);
        }
        watched = filter.takes(iterations);
        if residual <= stop.tolerance {
            method.confirm();
            residual = relative(&method);
            if residual <= stop.tolerance {
                break Ok(());
            }
            stagnation.confirmed(residual);
        }
        if residual.is_nan() || residual > DIVERGED * first.max(1.0) {
            break Err(Unsolved::Diverges {
                iterations,
                residual,
            });
        }
        if stagnation.is_reached(M::CARRIES_RESIDUAL, patches, method.radiosity()) {
            break Err(Unsolved::Stagnates {
                iterations,
                residual,
            });
        }
        if iterations >= stop.max_iterations {
            break Err(Unsolved::NotConverged {
                iterations,
                residual,
            });
        }
        let done = if watched {
            recorder.enter(|| SolverEvent::Iteration { k: iterations });
            let done = method.iterate(Followed(filter.patch), recorder);
            recorder.leave(|| SolverEvent::IterationDone {
                residual: relative(&method),
                error_bound: error_bound(&method),
            });
            done
        } else {
            method.iterate(Followed(filter.patch), &mut Unrecorded)
        };
        iterations += 1;
        residual = relative(&method);
        stagnation.iterated(residual);
        if let Err(unsolved) = done {
            break Err(unsolved);
        }
    };
    let error_bound = error_bound(&method);
    recorder.leave(|| match outcome {
        Ok(()) => SolverEvent::Converged {
            iterations,
            residual,
            error_bound,
        },
        Err(_) => SolverEvent::NotConverged {
            iterations,
            residual,
        },
    });
    outcome.map(|()| Solution {
        radiosity: method.radiosity().to_vec(),
        iterations,
        residual,
        error_bound,
    })
}

fn record_values<R: Recorder<SolverEvent>>(method: &impl Method, recorder: &mut R) {
    for (i, (&b, &unshot)) in method.radiosity().iter().zip(method.residual()).enumerate() {
        recorder.step(|| SolverEvent::Started {
            i: i as u32,
            b,
            unshot,
        });
    }
}

/// ‖r‖₂ / ‖E‖₂; 0 where E is 0.
fn relative(method: &impl Method, emitted: f64) -> f64 {
    match emitted {
        0.0 => 0.0,
        _ => norm(method.residual()) / emitted,
    }
}

/// ‖B − B*‖_∞ ≤ ‖r‖_∞ / (1 − max_i ρ_i Σ_j F_ij), where that is positive.
fn error_bound(method: &impl Method) -> Option<f64> {
    let loss = 1.0 - method.gain()?;
    let largest = method
        .residual()
        .iter()
        .fold(0.0, |most: f64, r| most.max(r.abs()));
    (loss > 0.0).then_some(largest / loss)
}

/// ‖v‖₂, scaled by the largest entry so that squares neither overflow nor vanish.
pub(super) fn norm(vector: &[f64]) -> f64 {
    let mut largest = 0.0_f64;
    for v in vector {
        if v.is_nan() {
            return f64::NAN;
        }
        largest = largest.max(v.abs());
    }
    if largest == 0.0 || largest.is_infinite() {
        return largest;
    }
    let squares: f64 = vector.iter().map(|v| (v / largest) * (v / largest)).sum();
    largest * squares.sqrt()
}
