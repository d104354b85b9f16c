//! Runs an algorithm over a whole frame: unrecorded, in bands of rows, on as many threads as are wanted.

use crate::algorithms::flat::flat;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::gouraud::gouraud;
use crate::algorithms::ray_casting::{RayCaster, ray_casting};
use crate::algorithms::ray_tracing::{RayTracer, ray_tracing};
use crate::algorithms::stage::Stage;
use crate::algorithms::visible::Hierarchy;
use crate::algorithms::wireframe::wireframe;
use crate::record::Unrecorded;
use std::num::NonZeroUsize;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

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

/// Draws the whole picture of `stage` on `threads` threads; without the feature `parallel`, on one.
///
/// The picture is the same, bit for bit, for any number of threads. `progress` hears how many of how many bands are done.
pub fn render(
    stage: &Stage,
    method: Method,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) + Sync),
) -> Frame {
    let bands = bands(stage.view.height, threads);
    let done = AtomicUsize::new(0);
    let draw = |rows: &Range<u32>| {
        let mut frame = Frame::new(stage.view.width, rows.clone(), stage.scene.background);
        match method {
            Method::Wireframe => wireframe(stage, Focus::Frame, &mut frame, &mut Unrecorded),
            Method::Flat => flat(stage, Focus::Frame, &mut frame, &mut Unrecorded),
            Method::Gouraud => gouraud(stage, Focus::Frame, &mut frame, &mut Unrecorded),
            Method::RayCasting => ray_casting(
                &RayCaster::new(stage, stage.needs(), Hierarchy),
                Focus::Frame,
                &mut frame,
                &mut Unrecorded,
            ),
            Method::RayTracing => ray_tracing(
                &RayTracer::new(stage, stage.needs(), Hierarchy),
                Focus::Frame,
                &mut frame,
                &mut Unrecorded,
            ),
        }
        progress(done.fetch_add(1, Ordering::Relaxed) + 1, bands.len());
        frame
    };
    join(map_bands(&bands, threads, draw))
}

#[cfg(feature = "parallel")]
fn map_bands(
    bands: &[Range<u32>],
    threads: NonZeroUsize,
    draw: impl Fn(&Range<u32>) -> Frame + Sync,
) -> Vec<Frame> {
    use rayon::prelude::*;
    if threads.get() > 1
        && let Ok(pool) = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.get())
            .build()
    {
        return pool.install(|| bands.par_iter().map(&draw).collect());
    }
    bands.iter().map(draw).collect()
}

#[cfg(not(feature = "parallel"))]
fn map_bands(
    bands: &[Range<u32>],
    _: NonZeroUsize,
    draw: impl Fn(&Range<u32>) -> Frame,
) -> Vec<Frame> {
    bands.iter().map(draw).collect()
}

/// A picture is rendered in one band by one thread. More threads share four bands each, so that none waits long for the last.
fn bands(height: u32, threads: NonZeroUsize) -> Vec<Range<u32>> {
    let wanted = if threads.get() == 1 || !cfg!(feature = "parallel") {
        1
    } else {
        4 * threads.get()
    };
    let count = wanted.min(height.max(1) as usize) as u64;
    let border = |band: u64| (band * u64::from(height) / count) as u32;
    (0..count)
        .map(|band| border(band)..border(band + 1))
        .collect()
}

/// Puts bands back together, in order.
fn join(bands: Vec<Frame>) -> Frame {
    let mut bands = bands.into_iter();
    let Some(mut frame) = bands.next() else {
        return Frame::new(0, 0..0, Default::default());
    };
    for band in bands {
        frame.rows.end = band.rows.end;
        frame.color.extend(band.color);
        frame.inverse_depth.extend(band.inverse_depth);
    }
    frame
}
