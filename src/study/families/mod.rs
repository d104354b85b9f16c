//! The families of methods, a file each.

mod memory;
mod scenes;
mod shading;

use super::form::Study;

/// In the order in which the lectures come to them.
pub static ALL: [&Study; 1] = [&shading::STUDY];

/// The study of that name.
pub fn named(name: &str) -> Option<&'static Study> {
    ALL.into_iter().find(|study| study.name == name)
}
