//! What several panels have in common.

pub mod answered;
pub mod channels;
pub mod finding;
#[cfg(test)]
pub mod fixture;
#[cfg(test)]
pub mod fixtures;
pub mod grip;
pub mod horizon;
pub mod message;
pub mod names;
pub mod patches;
pub mod reused;
pub mod strings;
pub mod values;
