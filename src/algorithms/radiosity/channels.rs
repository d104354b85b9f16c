//! All channels of a colour: each by itself, but none that is dark, and equal ones once.

use super::Solver;
use super::event::{Event, SolverEvent};
use super::iterate::TaggingRecorder;
use super::outcome::{Solution, Unsolved};
use super::system::Patches;
use crate::record::Recorder;
use crate::scene::{Part, Parts};
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

/// The first channel before channel `c` that is as it is.
pub fn equal_before(channels: &[Channel], c: usize) -> Option<usize> {
    let Channel { rho, emission, .. } = channels[c];
    let mut before = channels[..c].iter();
    before.position(|other| (other.rho, other.emission) == (rho, emission))
}

/// Solves each channel by itself, in their order, with `solve`, and leaves out what is dark or equal but for `forced`. Errors: those of the first channel that has no result.
pub fn solve_channels<const N: usize, R: Recorder<Event>>(
    area: &[f64],
    channels: [Channel; N],
    solver: Solver,
    forced: Parts,
    recorder: &mut R,
    mut solve: impl FnMut(&Patches, &mut R) -> Result<Solution, Unsolved>,
) -> Result<[Solution; N], ChannelUnsolved> {
    let mut solutions: [Solution; N] = std::array::from_fn(|_| Solution::dark(area.len()));
    for (c, channel) in channels.iter().enumerate() {
        let name = channel.name;
        let because = |why| ChannelUnsolved { channel: name, why };
        let patches = Patches::new(area, channel.rho, channel.emission)
            .map_err(because)?
            .with_black_rows(forced.has(Part::BlackRows));
        let mut by = TaggingRecorder { solver, recorder };
        let equal = equal_before(&channels, c).filter(|_| !forced.has(Part::EqualChannels));
        if patches.are_dark() && !forced.has(Part::DarkChannels) {
            by.step(|| SolverEvent::ChannelLeftOut {
                channel: name,
                why: "nothing emits",
                like: None,
            });
        } else if let Some(equal) = equal {
            by.step(|| SolverEvent::ChannelLeftOut {
                channel: name,
                why: "equal channel",
                like: Some(channels[equal].name),
            });
            solutions[c] = solutions[equal].clone();
        } else {
            by.enter(|| SolverEvent::Channel { channel: name });
            let solution = solve(&patches, by.recorder);
            let mut by = TaggingRecorder { solver, recorder };
            by.leave(|| SolverEvent::ChannelDone { channel: name });
            solutions[c] = solution.map_err(because)?;
        }
    }
    Ok(solutions)
}
