//! Runs an algorithm over a whole frame: unrecorded, on as many threads as are wanted, all at once or coarse first.

mod bands;
mod crew;
mod painter;
mod pixels;

use crate::algorithms::flat::flat;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::gouraud::gouraud;
use crate::algorithms::ray_casting::RayCaster;
use crate::algorithms::ray_tracing::RayTracer;
use crate::algorithms::stage::Stage;
use crate::algorithms::visible::Hierarchy;
use crate::algorithms::wireframe::wireframe;
use crate::record::Unrecorded;
use std::convert::Infallible;
use std::num::NonZeroUsize;

pub use painter::Painter;

/// A way to make a picture of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    Wireframe,
    Flat,
    Gouraud,
    RayCasting,
    RayTracing,
}

impl Method {
    pub const ALL: [Method; 5] = [
        Method::Wireframe,
        Method::Flat,
        Method::Gouraud,
        Method::RayCasting,
        Method::RayTracing,
    ];

    /// As on the command line and in lesson files.
    pub fn name(self) -> &'static str {
        match self {
            Method::Wireframe => "wireframe",
            Method::Flat => "flat",
            Method::Gouraud => "gouraud",
            Method::RayCasting => "ray-casting",
            Method::RayTracing => "ray-tracing",
        }
    }

    pub fn from_name(name: &str) -> Option<Self> {
        Method::ALL.into_iter().find(|method| method.name() == name)
    }
}

/// The longest side of a picture.
pub const MAX_SIDE: u32 = 1 << 14;

/// The most pixels of a picture: 8192×8192, for which rendering takes 2 GiB.
pub const MAX_PIXELS: u64 = 1 << 26;

/// A picture that was called off before it was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the picture was called off")]
pub struct Cancelled;

/// Draws the whole picture of `stage` on `threads` threads; without the feature `parallel`, on one.
///
/// The picture is the same, bit for bit, for any number of threads. `progress` hears how many of how many parts are done.
pub fn render(
    stage: &Stage,
    method: Method,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) + Sync),
) -> Frame {
    let progress = |done, all| {
        progress(done, all);
        Ok::<(), Infallible>(())
    };
    let Ok(frame) = draw(stage, method, Painter::new(stage, threads, progress));
    frame
}

/// Draws the picture of [`render`], and on the way lets `show` see it grow, where the method can draw a coarse one first.
///
/// `progress` is heard at least every few milliseconds where pixels are coloured one by one, else after each band of rows.
/// Errors: those of `progress`, which end the work.
pub fn preview(
    stage: &Stage,
    method: Method,
    threads: NonZeroUsize,
    progress: impl Fn(usize, usize) -> Result<(), Cancelled> + Sync,
    show: &mut dyn FnMut(&Frame),
) -> Result<Frame, Cancelled> {
    draw(
        stage,
        method,
        Painter::new(stage, threads, progress).coarse_first(show),
    )
}

fn draw<E: Send>(
    stage: &Stage,
    method: Method,
    painter: Painter<impl Fn(usize, usize) -> Result<(), E> + Sync>,
) -> Result<Frame, E> {
    match method {
        Method::Wireframe => {
            painter.bands(|band| wireframe(stage, Focus::Frame, band, &mut Unrecorded))
        }
        Method::Flat => painter.bands(|band| flat(stage, Focus::Frame, band, &mut Unrecorded)),
        Method::Gouraud => {
            painter.bands(|band| gouraud(stage, Focus::Frame, band, &mut Unrecorded))
        }
        Method::RayCasting => {
            let caster = RayCaster::new(stage, stage.needs(), Hierarchy);
            painter.pixels(|x, y| caster.pixel(x, y, &mut Unrecorded))
        }
        Method::RayTracing => {
            let tracer = RayTracer::new(stage, stage.needs(), Hierarchy);
            painter.pixels(|x, y| tracer.pixel(x, y, &mut Unrecorded))
        }
    }
}
