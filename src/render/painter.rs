//! How a picture is divided into work, whatever the method is.

use super::pixels::{AT_ONCE, COARSE_FIRST};
use super::thread_pool::ThreadPool;
use crate::algorithms::frame::Frame;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::color::Rgb;
use std::num::NonZeroUsize;

/// Paints one picture: a method either fills [bands](Painter::bands) of rows, or colours each of the [pixels](Painter::pixels)
/// by itself.
///
/// Its progress is called with the parts done and the parts in all, from any thread; an error that it returns ends the work.
pub struct Painter<'a, P> {
    pub(super) size: [u32; 2],
    pub(super) background: Rgb,
    pub(super) thread_pool: ThreadPool,
    pub(super) progress: P,
    /// Sides of the blocks of each pass, in pixels: each a multiple of the next, the last one 1.
    pub(super) passes: &'static [u32],
    /// Sees what there is after each pass but the last.
    pub(super) show: Option<&'a mut dyn FnMut(&Frame)>,
}

impl<'a, P> Painter<'a, P> {
    /// Paints the whole picture of the scene's view, all at once.
    pub fn new(prepared: &PreparedScene, threads: NonZeroUsize, progress: P) -> Self {
        Painter {
            size: [prepared.view.width, prepared.view.height],
            background: prepared.scene.background,
            thread_pool: ThreadPool::new(threads),
            progress,
            passes: &AT_ONCE,
            show: None,
        }
    }

    /// Paints a coarse picture first, where the method can; `show` sees it and those between.
    pub fn coarse_first(mut self, show: &'a mut dyn FnMut(&Frame)) -> Self {
        self.passes = &COARSE_FIRST;
        self.show = Some(show);
        self
    }
}
