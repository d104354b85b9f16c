//! When a solver stops, and what comes of it. What did not converge is never a result.

use thiserror::Error;

/// When to stop: at the latest after `max_iterations` iterations, or shots of one patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// The relative residual ‖E − (I − ρF)B‖₂ / ‖E‖₂ that is small enough.
    pub tolerance: f64,
    pub max_iterations: u32,
}

impl Default for Stop {
    fn default() -> Self {
        Stop {
            tolerance: 1e-6,
            max_iterations: 1_000_000,
        }
    }
}

/// The radiosity of every patch in one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// B, in the unit of the emission.
    pub radiosity: Vec<f64>,
    /// Iterations, or shots of one patch.
    pub iterations: u32,
    /// ‖E − (I − ρF)B‖₂ / ‖E‖₂; 0 where E is 0.
    pub residual: f64,
    /// No entry of B is farther than this from the exact one. None where no bound is known: some row of ρF sums to 1 or more.
    pub error_bound: Option<f64>,
}

impl Solution {
    /// Nothing emits, so nothing is lit.
    pub(super) fn dark(patches: usize) -> Self {
        Solution {
            radiosity: vec![0.0; patches],
            iterations: 0,
            residual: 0.0,
            error_bound: Some(0.0),
        }
    }
}

/// Why there is no result.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum Unsolved {
    #[error("{found} {what} for {patches} patches")]
    Sizes {
        what: &'static str,
        found: usize,
        patches: usize,
    },
    #[error("the {what} of patch {patch} is {value}")]
    Input {
        what: &'static str,
        patch: usize,
        value: f64,
    },
    #[error(
        "no solution exists: patch {patch} lies in a closed part of the scene where every reflectance is 1 and light is emitted, \
         so that light is never lost"
    )]
    NoSolution { patch: usize },
    #[error("no solution has a meaning: more light is reflected than arrives")]
    GainsLight,
    #[error(
        "the largest ρ_i Σ_j F_ij is {gain}, so that no interval below 1 is known to hold the spectrum"
    )]
    NoInterval { gain: f64 },
    #[error("the residual is still {residual:e} after {iterations} iterations")]
    NotConverged { iterations: u32, residual: f64 },
    #[error(
        "the residual no longer falls: it is {residual:e} after {iterations} iterations, as large as the rounding of its own terms; a \
         larger tolerance can be met"
    )]
    Stagnates { iterations: u32, residual: f64 },
    #[error("the iteration diverges: the residual is {residual:e} after {iterations} iterations")]
    Diverges { iterations: u32, residual: f64 },
}
