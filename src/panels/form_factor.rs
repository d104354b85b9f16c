//! Two patches, and the form factor between them as it is found.

use super::Show;
use super::message::{NO_PATCHES, message};
use crate::picture::Picture;
use glam::Vec2;

pub fn draw(show: &Show, size: Vec2) -> Picture {
    message(NO_PATCHES, show.language, size)
}
