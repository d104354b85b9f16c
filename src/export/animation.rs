//! Steps of a lesson as an animated picture.

use super::making::Making;
use super::{ExportedLesson, card, reading_seconds};
use crate::color::{Animation, AnimationFormat};
use crate::panels::Panel;
use crate::picture::{Picture, Theme, rasterize, to_rgb8};
use glam::Vec2;
use std::io::{self, Write};
use std::mem;
use std::sync::{Arc, Mutex, PoisonError};

/// Frames a second where nothing is read.
const FPS: f64 = 5.0;
/// How long the last frame is shown at least, in seconds, before the first comes again.
const LAST: f64 = 2.0;

/// What frames show.
#[derive(Clone, Copy, Debug)]
pub struct Film {
    /// Unless given, the one that is explained, or the lesson's first.
    pub panel: Option<Panel>,
    /// Pixels, width and height.
    pub size: [u32; 2],
    pub theme: Theme,
    /// How long a frame is shown; unless given, as long as its words take to read, or a moment where there are none.
    pub seconds: Option<f64>,
    /// Whether frames have the words of their steps.
    pub explains: bool,
}

/// As PNG (APNG) or GIF, a frame a step.
pub fn animation(
    mut shown: ExportedLesson,
    steps: Vec<usize>,
    film: Film,
    ending: &str,
) -> io::Result<Making<'static>> {
    let format = match ending {
        "gif" => AnimationFormat::Gif,
        _ => AnimationFormat::Png,
    };
    let written = Written::default();
    let frames = steps.len() as u32;
    let mut animation = Some(Animation::new(format, film.size, frames, written.clone())?);
    Ok(Making::new(steps.len() + 1, move |part, out| {
        if let Some(&step) = steps.get(part) {
            let (picture, seconds) = film.frame(&mut shown, step, [part, steps.len()]);
            let scale = film.theme.text_scale();
            let pixmap = rasterize(&picture, film.theme, scale).map_err(io::Error::other)?;
            if let Some(animation) = &mut animation {
                animation.frame(to_rgb8(&pixmap), seconds)?;
            }
        } else if let Some(animation) = animation.take() {
            animation.finish()?;
        }
        out.write_all(&written.take())
    }))
}

impl Film {
    /// The picture of a step, the one with the number `place` of so many, and how long it is shown.
    fn frame(&self, shown: &mut ExportedLesson, step: usize, place: [usize; 2]) -> (Picture, f64) {
        let size = Vec2::from(self.size.map(|side| side as f32)) / self.theme.text_scale();
        let (picture, seconds) = match self.explains {
            true => {
                let mut page = shown.page(step);
                page.panel = self.panel.unwrap_or(page.panel);
                (card(shown, &page, place, size), reading_seconds(&page))
            }
            false => {
                let first = || shown.open.lesson.panels.first().copied();
                let panel = self.panel.or_else(first).unwrap_or(Panel::Image);
                (shown.draw(panel, step, size), 1.0 / FPS)
            }
        };
        let seconds = self.seconds.unwrap_or(seconds);
        match place[0] + 1 == place[1] {
            true => (picture, seconds.max(LAST)),
            false => (picture, seconds),
        }
    }
}

/// What the encoder has written and the file has not got yet.
#[derive(Clone, Default)]
struct Written(Arc<Mutex<Vec<u8>>>);

impl Written {
    fn take(&self) -> Vec<u8> {
        mem::take(&mut *self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Write for Written {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut written = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        written.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
