//! Radiosity: the light that diffuse patches exchange, B_i = E_i + ρ_i Σ_j F_ij B_j, or (I − ρF)B = E, a channel at a time
//! (Goral, Torrance, Greenberg & Battaile 1984). Recorded or not, each solver's result is the same to the bit.
//!
//! | file | what | source |
//! | --- | --- | --- |
//! | [`jacobi`], [`gauss_seidel`], [`over_relaxation`] | gathering: of old light, of the newest, and ω times as far | Jacobi 1845, Seidel 1874, Young 1954 |
//! | [`shooting`], [`overshooting`] | shooting unshot light, and what it will become | Cohen et al. 1988, Feda & Purgathofer 1992 |
//! | [`chebyshev`] | Chebyshev's semi-iteration | Golub & Varga 1961 |
//! | [`conjugate_gradients`] | conjugate gradients, symmetrised | Hestenes & Stiefel 1952 |
//! | [`direct`] | LU | Golub & Van Loan §3.4 |
//! | [`race`] | all of them on one system, by iteration and by time | |
//!
//! A small residual is not a small error: beside it stands the bound ‖B − B*‖_∞ ≤ ‖r‖_∞ / (1 − max_i ρ_i Σ_j F_ij), and
//! [`total_error`] where the form factors have errors too.

#[macro_use]
mod solver;

mod auto;
mod channels;
pub mod chebyshev;
pub mod conjugate_gradients;
pub mod cube;
pub mod direct;
mod event;
mod gathering;
pub mod gauss_seidel;
mod iterate;
pub mod jacobi;
mod outcome;
pub mod over_relaxation;
pub mod overshooting;
pub mod race;
mod record_filter;
pub mod shooting;
mod singularity_check;
mod stagnation;
mod system;
#[cfg(test)]
mod tests;
mod total_error;

pub use channels::{Channel, ChannelUnsolved, Known, solve_channels};
pub use chebyshev::chebyshev_on;
pub use event::{Event, SolverEvent};
pub use outcome::{Solution, Stop, Unsolved};
pub use record_filter::RecordFilter;
pub use shooting::shoot;
pub use solver::solve;
pub use system::{Matrix, Patches, Rows, System};
pub use total_error::{RowErrors, total_error};

use crate::record::Recorder;

solvers! {
    #[default]
    Auto: auto,
    Jacobi: jacobi,
    GaussSeidel: gauss_seidel,
    OverRelaxation: over_relaxation,
    Shooting: shooting,
    Overshooting: overshooting,
    Chebyshev: chebyshev,
    ConjugateGradients: conjugate_gradients,
    Direct: direct,
}
