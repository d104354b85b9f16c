//! Runs an algorithm over a whole frame: unrecorded, on as many threads as are wanted, all at once or coarse first.

mod bands;
pub mod compare;
pub mod lanes;
mod light;
mod painter;
mod pixels;
mod skipped;
mod tally;
mod thread_pool;

use crate::algorithms::exact::exact;
use crate::algorithms::fast_phong::fast_phong;
use crate::algorithms::flat::flat;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::gouraud::gouraud;
use crate::algorithms::patch_view::PatchView;
use crate::algorithms::phong::phong;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::ray_casting::RayCaster;
use crate::algorithms::ray_tracing::RayTracer;
use crate::algorithms::visible::Bvh;
use crate::algorithms::wireframe::wireframe;
use crate::color::Rgb;
use crate::record::Unrecorded;
use crate::scene::{Needs, Part};
use std::convert::Infallible;
use std::num::NonZeroUsize;
use tally::Totals;

pub use light::{matrix, race};
pub use painter::Painter;
pub use skipped::skipped;
pub use tally::RayCounts;

/// A way to make a picture of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    Wireframe,
    Flat,
    Gouraud,
    Phong,
    FastPhong,
    /// With the normals of the true surfaces.
    Exact,
    RayCasting,
    RayTracing,
    Radiosity,
}

impl Method {
    pub const ALL: [Method; 9] = [
        Method::Wireframe,
        Method::Flat,
        Method::Gouraud,
        Method::Phong,
        Method::FastPhong,
        Method::Exact,
        Method::RayCasting,
        Method::RayTracing,
        Method::Radiosity,
    ];

    /// As on the command line and in lesson files.
    pub fn name(self) -> &'static str {
        match self {
            Method::Wireframe => "wireframe",
            Method::Flat => "flat",
            Method::Gouraud => "gouraud",
            Method::Phong => "phong",
            Method::FastPhong => "fast-phong",
            Method::Exact => "exact",
            Method::RayCasting => "ray-casting",
            Method::RayTracing => "ray-tracing",
            Method::Radiosity => "radiosity",
        }
    }

    /// Whether it follows rays instead of converting polygons.
    pub fn follows_rays(self) -> bool {
        matches!(self, Method::RayCasting | Method::RayTracing)
    }

    /// Whether it converts polygons, scan line by scan line.
    pub fn converts_polygons(self) -> bool {
        !self.follows_rays() && self != Method::Radiosity
    }

    /// Whether a run of it can be told of that part.
    pub fn tells_of(self, focus: Focus) -> bool {
        match focus {
            Focus::Frame => true,
            Focus::Polygon(_) => self.converts_polygons(),
            Focus::ScanLine(_) | Focus::Pixel { .. } => self != Method::Radiosity,
            Focus::Iterations { .. } | Focus::Patch(_) | Focus::FormFactor { .. } => {
                self == Method::Radiosity
            }
        }
    }

    /// Whether it does that part of the work, where the scene needs it.
    pub fn does(self, part: Part) -> bool {
        match self {
            Method::RayCasting => part.concerns_primary_rays(),
            Method::RayTracing => !part.concerns_patches(),
            Method::Radiosity => part.concerns_patches(),
            Method::Wireframe => false,
            Method::Flat | Method::Gouraud | Method::Phong | Method::Exact => {
                matches!(part, Part::TextureCoordinates | Part::Highlights)
            }
            // Its series of the highlight goes along whatever the material.
            Method::FastPhong => part == Part::TextureCoordinates,
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

/// Draws the whole picture of `prepared` on `threads` threads; without the feature `parallel`, on one.
///
/// The picture is the same, bit for bit, for any number of threads. `progress` hears how many of how many parts are done.
pub fn render(
    prepared: &PreparedScene,
    method: Method,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) + Sync),
) -> Frame {
    let progress = |done, all| {
        progress(done, all);
        Ok::<(), Infallible>(())
    };
    let painter = Painter::new(prepared, threads, progress);
    let Ok(frame) = draw(prepared, method, prepared.needs(), None, painter);
    frame
}

/// Draws the picture of [`render`] with what `needs` says is needed, and counts its rays. The scan-line methods have none.
pub fn render_counted(
    prepared: &PreparedScene,
    method: Method,
    needs: &Needs,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) + Sync),
) -> (Frame, RayCounts) {
    let progress = |done, all| {
        progress(done, all);
        Ok::<(), Infallible>(())
    };
    let totals = Totals::default();
    let painter = Painter::new(prepared, threads, progress);
    let Ok(frame) = draw(prepared, method, needs, Some(&totals), painter);
    (frame, totals.sum())
}

/// Draws the picture of [`render`], and on the way lets `show` see it grow, where the method can draw a coarse one first.
///
/// `progress` is heard at least every few milliseconds where pixels are coloured one by one, else after each band of rows.
/// Errors: those of `progress`, which end the work.
pub fn preview(
    prepared: &PreparedScene,
    method: Method,
    threads: NonZeroUsize,
    progress: impl Fn(usize, usize) -> Result<(), Cancelled> + Sync,
    show: &mut dyn FnMut(&Frame),
) -> Result<Frame, Cancelled> {
    let painter = Painter::new(prepared, threads, progress).coarse_first(show);
    draw(prepared, method, prepared.needs(), None, painter)
}

fn draw<E: Send>(
    prepared: &PreparedScene,
    method: Method,
    needs: &Needs,
    totals: Option<&Totals>,
    painter: Painter<impl Fn(usize, usize) -> Result<(), E> + Sync>,
) -> Result<Frame, E> {
    match method {
        Method::Wireframe => {
            painter.bands(|band| wireframe(prepared, Focus::Frame, band, &mut Unrecorded))
        }
        Method::Flat => painter.bands(|band| flat(prepared, Focus::Frame, band, &mut Unrecorded)),
        Method::Gouraud => {
            painter.bands(|band| gouraud(prepared, Focus::Frame, band, &mut Unrecorded))
        }
        Method::Exact => painter.bands(|band| exact(prepared, Focus::Frame, band, &mut Unrecorded)),
        Method::Phong => painter.bands(|band| phong(prepared, Focus::Frame, band, &mut Unrecorded)),
        Method::FastPhong => {
            painter.bands(|band| fast_phong(prepared, Focus::Frame, band, &mut Unrecorded))
        }
        Method::RayCasting => {
            let caster = RayCaster::new(prepared, needs, Bvh);
            match totals {
                None => painter.pixels(|x, y| caster.pixel(x, y, &mut Unrecorded)),
                Some(totals) => {
                    painter.pixels(|x, y| totals.counting(|counts| caster.pixel(x, y, counts)))
                }
            }
        }
        Method::RayTracing => {
            let tracer = RayTracer::new(prepared, needs, Bvh);
            match totals {
                None => painter.pixels(|x, y| tracer.pixel(x, y, &mut Unrecorded)),
                Some(totals) => {
                    painter.pixels(|x, y| totals.counting(|counts| tracer.pixel(x, y, counts)))
                }
            }
        }
        // A room that cannot be divided or solved gives off no light: `PreparedScene::enclosure` and `Enclosure::solve` say why.
        Method::Radiosity => {
            let light = match prepared.enclosure() {
                Ok(enclosure) => light::light(enclosure, &painter.thread_pool, &painter.progress)?
                    .ok()
                    .map(|light| (enclosure, light)),
                Err(_) => None,
            };
            match &light {
                Some((enclosure, light)) => {
                    let view = PatchView::new(prepared, enclosure, &light.radiosity);
                    painter.pixels(|x, y| view.pixel(x, y))
                }
                None => painter.pixels(|_, _| Rgb::BLACK),
            }
        }
    }
}
