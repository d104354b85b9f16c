//! Runs an algorithm over a whole frame: unrecorded, on as many threads as are wanted, all at once or coarse first.

mod bands;
pub mod compare;
pub mod falloff;
mod finished;
mod layers;
mod light;
mod painter;
mod pixels;
mod smooth;
mod tally;
mod thread_pool;

use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::patch_view::PatchView;
use crate::algorithms::primary;
use crate::algorithms::visible::Bvh;
use crate::color::Rgb;
use crate::methods::{Draw, RayMethod, Setup, ShadingMethod, Visitor, Wireframe, hierarchical};
use crate::record::Unrecorded;
use crate::scene::Needs;
use std::convert::Infallible;
use std::num::NonZeroUsize;
use tally::Totals;

pub use crate::methods::Method;
pub use finished::Finished;
pub use layers::{Layer, Layers, MetSurface, layers};
pub use light::{matrix, race, reference_errors};
pub use painter::Painter;
pub use smooth::{DrawPatches, smooth_patches};
pub use tally::RayCounts;

/// The longest side of a picture.
pub const MAX_SIDE: u32 = 1 << 14;

/// The most pixels of a picture: 8192×8192, for which rendering takes 2 GiB.
pub const MAX_PIXELS: u64 = 1 << 26;

/// A picture that was cancelled before it was done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the picture was cancelled")]
pub struct Cancelled;

/// Draws the whole picture of `setup` on `threads` threads; without the feature `parallel`, on one.
///
/// The picture is the same, bit for bit, for any number of threads. `progress` is called with the parts done and the parts in all.
pub fn render(
    setup: &Setup,
    method: Method,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) + Sync),
) -> Frame {
    let progress = |done, all| {
        progress(done, all);
        Ok::<(), Infallible>(())
    };
    let Ok(frame) = render_unless(setup, method, threads, progress);
    frame
}

/// Draws the picture of [`render`]. Errors: those of `progress`, which end the work.
pub fn render_unless<E: Send>(
    setup: &Setup,
    method: Method,
    threads: NonZeroUsize,
    progress: impl Fn(usize, usize) -> Result<(), E> + Sync,
) -> Result<Frame, E> {
    let painter = Painter::new(&setup.prepared, threads, progress);
    draw(setup, method, setup.needs(), None, painter)
}

/// Draws the picture of [`render`] with what `needs` says is needed, and counts its rays. The scan-line methods have none.
pub fn render_counted(
    setup: &Setup,
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
    let painter = Painter::new(&setup.prepared, threads, progress);
    let Ok(frame) = draw(setup, method, needs, Some(&totals), painter);
    (frame, totals.sum())
}

/// Draws the picture of [`render`], and on the way lets `show` see it grow, where the method can draw a coarse one first.
///
/// `progress` is called at least every few milliseconds where pixels are coloured one by one, else after each band of rows.
/// Errors: those of `progress`, which end the work.
pub fn preview(
    setup: &Setup,
    method: Method,
    threads: NonZeroUsize,
    progress: impl Fn(usize, usize) -> Result<(), Cancelled> + Sync,
    show: &mut dyn FnMut(&Frame),
) -> Result<Frame, Cancelled> {
    let painter = Painter::new(&setup.prepared, threads, progress).coarse_first(show);
    draw(setup, method, setup.needs(), None, painter)
}

fn draw<E: Send>(
    setup: &Setup,
    method: Method,
    needs: &Needs,
    totals: Option<&Totals>,
    painter: Painter<impl Fn(usize, usize) -> Result<(), E> + Sync>,
) -> Result<Frame, E> {
    method.visit(Paint {
        setup,
        needs,
        totals,
        painter,
    })
}

/// Paints a picture by the method that it visits.
struct Paint<'a, 'b, P> {
    setup: &'a Setup,
    needs: &'a Needs,
    totals: Option<&'a Totals>,
    painter: Painter<'b, P>,
}

impl<E: Send, P: Fn(usize, usize) -> Result<(), E> + Sync> Paint<'_, '_, P> {
    fn bands<M: Draw>(self) -> Result<Frame, E> {
        let setup = self.setup;
        self.painter
            .bands(|band| M::draw(setup, Focus::Frame, band, Bvh, &mut Unrecorded))
    }

    fn pixels<M: RayMethod>(self) -> Result<Frame, E> {
        let tracer = M::tracer(self.setup, self.needs, Bvh);
        match self.totals {
            None => self
                .painter
                .pixels(|x, y| M::pixel(&tracer, x, y, &mut Unrecorded)),
            Some(totals) => self
                .painter
                .pixels(|x, y| totals.counting(|counts| M::pixel(&tracer, x, y, counts))),
        }
    }
}

/// Patches of that radiosity as the camera sees them; black where there is none.
fn paint_patches<E: Send>(
    setup: &Setup,
    painter: Painter<impl Fn(usize, usize) -> Result<(), E> + Sync>,
    light: Option<(&Enclosure, &[Rgb])>,
) -> Result<Frame, E> {
    let Some((enclosure, radiosity)) = light else {
        return painter.pixels(|_, _| Rgb::BLACK);
    };
    let primary::Settings { samples, .. } = setup.settings.get();
    let view = PatchView::new(&setup.prepared.view, samples, enclosure, radiosity);
    painter.pixels(|x, y| view.pixel(x, y))
}

impl<E: Send, P: Fn(usize, usize) -> Result<(), E> + Sync> Visitor for Paint<'_, '_, P> {
    type Output = Result<Frame, E>;

    fn wireframe(self) -> Self::Output {
        self.bands::<Wireframe>()
    }

    fn shading<M: ShadingMethod>(self) -> Self::Output {
        self.bands::<M>()
    }

    fn rays<M: RayMethod>(self) -> Self::Output {
        self.pixels::<M>()
    }

    /// A scene that cannot be divided or solved gives off no light: `Setup::enclosure` and `Enclosure::solve` say why.
    fn radiosity(self) -> Self::Output {
        let Paint { setup, painter, .. } = self;
        let light = match setup.enclosure() {
            Ok(enclosure) => light::light(enclosure, &painter.thread_pool, &painter.progress)?
                .ok()
                .map(|light| (enclosure, light)),
            Err(_) => None,
        };
        paint_patches(
            setup,
            painter,
            light.map(|(enclosure, light)| (enclosure, &*light.radiosity)),
        )
    }

    /// As of radiosity: no light, where there is none to be found.
    fn hierarchical(self) -> Self::Output {
        let Paint { setup, painter, .. } = self;
        let rows = setup.prepared.view.height as usize;
        let go_on = || (painter.progress)(0, rows);
        let light = hierarchical::light(setup, go_on)?.ok();
        let light = light.and_then(|light| Some((setup.enclosure().ok()?, &*light.radiosity)));
        paint_patches(setup, painter, light)
    }
}
