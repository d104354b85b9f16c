//! Lightwalk: walk through classic rendering, step by step, forward and back.

pub mod algorithms;
#[cfg(feature = "gui")]
pub mod app;
pub mod color;
pub mod commands;
pub mod lesson;
pub mod numeric;
pub mod panels;
pub mod picture;
pub mod record;
pub mod render;
pub mod replay;
pub mod scene;
