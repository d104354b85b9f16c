//! The state of a radiosity solver at one step: what each patch has, the current exchange, and how the residual went.

mod light;
mod read;
mod solved;

pub use light::Unshot;
pub use read::used_form_factors;
pub use solved::Solved;
pub(super) use solved::exposure;

use super::Fold;
use super::cow_vec::CowVec;
use crate::algorithms::radiosity::{Event, Solver, SolverEvent};
use std::sync::Arc;

/// A patch so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PatchNow {
    pub b: f64,
    /// Its part of the residual, as last recorded: kept up by the shooting methods, by the others recorded only where watching begins.
    pub unshot: f64,
    /// The step that changed it last.
    pub step: Option<u32>,
}

/// One iteration that was recorded to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IterationNow {
    pub k: u32,
    pub residual: f64,
    pub error_bound: Option<f64>,
    pub step: u32,
}

/// A solver's work on one channel.
#[derive(Clone, Debug)]
pub struct ChannelNow {
    /// None where a channel was solved by itself, outside of a colour.
    pub channel: Option<&'static str>,
    pub solver: Solver,
    pub patches: CowVec<PatchNow>,
    /// Relative residual and bound, by recorded iteration.
    pub history: CowVec<IterationNow>,
    pub skipped: Option<(&'static str, Option<&'static str>)>,
    /// Whether it converged, once it ended.
    pub converged: Option<bool>,
}

/// What a patch does in the current iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Focused {
    /// The patch that gathers or shoots.
    pub i: u32,
    /// `Gathering`, or `Shooting`.
    pub recorded: SolverEvent,
    /// The current exchange: `Exchanged` or `Received`.
    pub exchange: Option<(u32, SolverEvent)>,
    pub step: usize,
}

/// Copies share what was not written: a checkpoint costs the chunks of patches that changed.
#[derive(Clone, Debug, Default)]
pub struct State {
    /// None where the scene has no patches.
    pub solved: Option<Arc<Solved>>,
    pub channels: Vec<ChannelNow>,
    pub iteration: Option<u32>,
    pub focused: Option<Focused>,
    /// The scalars of the current iteration: `Weighted`, `StepLengths` or `Ambient`.
    pub scalars: Option<SolverEvent>,
    /// The name of a channel that was opened, whose system is not yet.
    opened: Option<&'static str>,
}

impl State {
    /// Before the first step.
    pub fn new(solved: Option<Solved>) -> Self {
        State {
            solved: solved.map(Arc::new),
            ..State::default()
        }
    }

    /// The current channel, or the last one.
    pub fn channel(&self) -> Option<&ChannelNow> {
        self.channels.last()
    }

    fn begin(&mut self, channel: Option<&'static str>, solver: Solver) {
        self.channels.push(ChannelNow {
            channel,
            solver,
            patches: CowVec::default(),
            history: CowVec::default(),
            skipped: None,
            converged: None,
        });
        self.iteration = None;
        self.focused = None;
        self.scalars = None;
    }

    fn change(&mut self, i: u32, step: usize, change: impl FnOnce(&mut PatchNow)) {
        let channel = self.channels.last_mut();
        if let Some(patch) = channel.and_then(|channel| channel.patches.get_mut(i as usize)) {
            change(patch);
            patch.step = Some(step as u32);
        }
    }

    fn focus(&mut self, i: u32, recorded: SolverEvent, step: usize) {
        self.focused = Some(Focused {
            i,
            recorded,
            exchange: None,
            step,
        });
    }

    fn exchange(&mut self, j: u32, recorded: SolverEvent) {
        if let Some(focused) = &mut self.focused {
            focused.exchange = Some((j, recorded));
        }
    }

    fn end(&mut self, converged: bool) {
        if let Some(channel) = self.channels.last_mut() {
            channel.converged = Some(converged);
        }
        (self.iteration, self.focused, self.scalars) = (None, None, None);
    }
}

impl Fold<Event> for State {
    fn apply(&mut self, step: usize, event: &Event) {
        let recorded = event.recorded;
        match recorded {
            SolverEvent::Enclosure { .. } | SolverEvent::RoomDone => {}
            SolverEvent::Channel { channel } => self.opened = Some(channel),
            SolverEvent::ChannelLeftOut { channel, why, like } => {
                self.begin(Some(channel), event.solver);
                if let Some(channel) = self.channels.last_mut() {
                    channel.skipped = Some((why, like));
                }
            }
            SolverEvent::ChannelDone { .. } => self.opened = None,
            SolverEvent::System { patches, .. } => {
                self.begin(self.opened, event.solver);
                if let Some(channel) = self.channels.last_mut() {
                    (0..patches).for_each(|_| channel.patches.push(PatchNow::default()));
                }
            }
            SolverEvent::Started { i, b, unshot } => {
                self.change(i, step, |patch| (patch.b, patch.unshot) = (b, unshot));
            }
            SolverEvent::Iteration { k } => {
                self.iteration = Some(k);
                (self.focused, self.scalars) = (None, None);
            }
            SolverEvent::Weighted { .. }
            | SolverEvent::StepLengths { .. }
            | SolverEvent::Ambient { .. } => {
                self.scalars = Some(recorded);
            }
            SolverEvent::Gathering { i, .. } => self.focus(i, recorded, step),
            SolverEvent::Exchanged { j, .. } => self.exchange(j, recorded),
            SolverEvent::Gathered { i, b_new, .. } | SolverEvent::Updated { i, b_new, .. } => {
                self.change(i, step, |patch| patch.b = b_new);
            }
            SolverEvent::Shooting {
                i, unshot, shot, ..
            } => {
                self.focus(i, recorded, step);
                // The shot leaves the patch at once, and what it shoots beyond its unshot light it owes.
                self.change(i, step, |patch| {
                    patch.b += shot;
                    patch.unshot = unshot - shot;
                });
            }
            SolverEvent::Received {
                j, b_j, unshot_j, ..
            } => {
                self.exchange(j, recorded);
                self.change(j, step, |patch| (patch.b, patch.unshot) = (b_j, unshot_j));
            }
            SolverEvent::ShotDone { i, b_i, unshot } => {
                self.change(i, step, |patch| (patch.b, patch.unshot) = (b_i, unshot));
            }
            SolverEvent::IterationDone {
                residual,
                error_bound,
            } => {
                if let (Some(k), Some(channel)) = (self.iteration, self.channels.last_mut()) {
                    channel.history.push(IterationNow {
                        k,
                        residual,
                        error_bound,
                        step: step as u32,
                    });
                }
                self.focused = None;
            }
            SolverEvent::Converged { .. } => self.end(true),
            SolverEvent::NotConverged { .. } => self.end(false),
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        let empty = (CowVec::default(), CowVec::default());
        let channels = self.channels.iter().enumerate().map(|(c, channel)| {
            let (patches, history) = match before.channels.get(c) {
                Some(before) => (&before.patches, &before.history),
                None => (&empty.0, &empty.1),
            };
            size_of::<ChannelNow>()
                + channel.patches.bytes_beyond(patches)
                + channel.history.bytes_beyond(history)
        });
        size_of::<Self>() + channels.sum::<usize>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::radiosity::cube::{cube, lamp};
    use crate::algorithms::radiosity::{Matrix, Patches, RecordFilter, Stop, System, solve};
    use crate::record::{Recording, RecordingLimit};
    use crate::replay::Timeline;

    #[test]
    fn the_last_state_is_the_result_whatever_is_watched_at_the_end() {
        let (f, area) = cube(2);
        let n = area.len();
        let (rho, emission) = (vec![0.6; n], lamp(2));
        let matrix = Matrix::new(&f, n).unwrap();
        let patches = Patches::new(&area, &rho, &emission).unwrap();
        let system = System::new(&matrix, patches).unwrap();
        for solver in Solver::ALL {
            for from in [0, 3] {
                let iterations = Some(from..u32::MAX);
                let filter = RecordFilter {
                    iterations,
                    patch: None,
                };
                let mut recording = Recording::new(RecordingLimit::default());
                let stop = Stop::default();
                let found = solve(&system, solver, stop, &filter, &mut recording).unwrap();
                if found.iterations < from {
                    continue;
                }
                let timeline = Timeline::new(recording, State::default());
                let state = timeline.state_at(timeline.len() - 1);
                let channel = state.channel().unwrap();
                let b: Vec<f64> = channel.patches.iter().map(|patch| patch.b).collect();
                assert_eq!(b, found.radiosity, "{} from {from}", solver.name());
                assert_eq!(channel.history.len() as u32, found.iterations - from);
                assert_eq!(channel.converged, Some(true));
            }
        }
    }
}
