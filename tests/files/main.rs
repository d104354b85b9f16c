//! Files of scenes and lessons, right and broken.

#[path = "../common/broken.rs"]
mod broken;
mod broken_lessons;
mod broken_scenes;
mod lessons;
mod typed_numbers;
mod typography;
mod workflow;
