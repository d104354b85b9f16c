//! Lightwalk: walk through classic rendering, step by step, forward and back.

pub mod color;
pub mod record;
pub mod replay;
pub mod scene;
