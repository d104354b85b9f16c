//! Residual and error bound, iteration by iteration.

use super::Show;
use super::message::{NO_PATCHES, message};
use crate::picture::Picture;
use glam::Vec2;

pub fn draw(show: &Show, size: Vec2) -> Picture {
    message(NO_PATCHES, show.language, size)
}
