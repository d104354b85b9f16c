//! All channels of a colour: each by itself, but none that is dark, and equal ones once.

use super::Solver;
use super::event::{Event, Told};
use super::iterate::By;
use super::outcome::{Solution, Stop, Unsolved};
use super::solver::solve;
use super::system::{Matrix, Patches, System};
use super::watch::Watch;
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

/// A channel without a result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("{channel}: {why}")]
pub struct ChannelUnsolved {
    pub channel: &'static str,
    pub why: Unsolved,
}

/// Solves each channel by itself, in their order. Errors: those of the first channel that has no result.
pub fn solve_channels<R: Recorder<Event>>(
    matrix: &Matrix,
    area: &[f64],
    channels: &[Channel],
    solver: Solver,
    stop: Stop,
    watch: &Watch,
    recorder: &mut R,
) -> Result<Vec<Solution>, ChannelUnsolved> {
    let mut solutions: Vec<Solution> = Vec::new();
    for (c, channel) in channels.iter().enumerate() {
        let name = channel.name;
        let because = |why| ChannelUnsolved { channel: name, why };
        let patches = Patches::new(area, channel.rho, channel.emission).map_err(because)?;
        let mut by = By { solver, recorder };
        let equal = channels[..c]
            .iter()
            .position(|other| (other.rho, other.emission) == (channel.rho, channel.emission));
        if patches.are_dark() {
            by.step(|| Told::ChannelLeftOut {
                channel: name,
                why: "nothing emits",
                like: None,
            });
            solutions.push(Solution::dark(patches.len()));
        } else if let Some(equal) = equal {
            by.step(|| Told::ChannelLeftOut {
                channel: name,
                why: "equal channel",
                like: Some(channels[equal].name),
            });
            solutions.push(solutions[equal].clone());
        } else {
            let system = System::new(matrix, patches).map_err(because)?;
            by.enter(|| Told::Channel { channel: name });
            let solution = solve(&system, solver, stop, watch, by.recorder);
            by.leave(|| Told::ChannelDone { channel: name });
            solutions.push(solution.map_err(because)?);
        }
    }
    Ok(solutions)
}
