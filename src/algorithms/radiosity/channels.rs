//! All channels of a colour: each by itself, but none whose light is known.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::iterate::TaggingRecorder;
use super::outcome::{Solution, Unsolved};
use super::system::Patches;
use crate::record::Recorder;
use thiserror::Error;

/// One channel of the patches' colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Channel<'a> {
    /// `red`.
    pub name: &'static str,
    pub rho: &'a [f64],
    pub emission: &'a [f64],
}

/// What is known of the light of a channel before anything is solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// Nothing emits: B = 0.
    Dark,
    /// It is that of this channel, which stands before it, and reflects and emits as much.
    EqualTo(usize),
}

/// A channel without a result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{channel}: {why}")]
pub struct ChannelUnsolved {
    pub channel: &'static str,
    pub why: Unsolved,
}

/// Solves each channel of which nothing is known by itself, in their order, with `solve`. Errors: those of the first channel that
/// has no result.
pub fn solve_channels<const N: usize, R: Recorder<Event>>(
    area: &[f64],
    channels: [Channel; N],
    known: [Option<Known>; N],
    solver: Solver,
    recorder: &mut R,
    mut solve: impl FnMut(&Patches, &mut R) -> Result<Solution, Unsolved>,
) -> Result<[Solution; N], ChannelUnsolved> {
    let mut solutions: [Solution; N] = std::array::from_fn(|_| Solution::dark(area.len()));
    for (c, channel) in channels.iter().enumerate() {
        let name = channel.name;
        let because = |why| ChannelUnsolved { channel: name, why };
        let patches = Patches::new(area, channel.rho, channel.emission).map_err(because)?;
        let mut by = TaggingRecorder { solver, recorder };
        match known[c] {
            Some(Known::Dark) => by.step(|| SolverEvent::ChannelLeftOut {
                channel: name,
                why: "nothing emits",
                like: None,
            }),
            Some(Known::EqualTo(equal)) => {
                by.step(|| SolverEvent::ChannelLeftOut {
                    channel: name,
                    why: "equal channel",
                    like: Some(channels[equal].name),
                });
                solutions[c] = solutions[equal].clone();
            }
            None => {
                by.enter(|| SolverEvent::Channel { channel: name });
                let solution = solve(&patches, by.recorder);
                let mut by = TaggingRecorder { solver, recorder };
                by.leave(|| SolverEvent::ChannelDone { channel: name });
                solutions[c] = solution.map_err(because)?;
            }
        }
    }
    Ok(solutions)
}
