//! The families of methods, a file each.

mod depth;
mod form_factors;
mod growth;
mod interpolation;
mod memory;
mod patches;
mod pictures;
mod precision;
mod samples;
mod scenes;
mod search;
mod shading;
mod solvers;

use super::form::Study;

/// In the order in which the lectures come to them.
pub static ALL: [&Study; 10] = [
    &shading::STUDY,
    &interpolation::STUDY,
    &depth::STUDY,
    &samples::STUDY,
    &search::STUDY,
    &precision::STUDY,
    &form_factors::STUDY,
    &solvers::STUDY,
    &patches::STUDY,
    &growth::STUDY,
];
