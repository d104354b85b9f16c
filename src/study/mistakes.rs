//! Classic mistakes in programs that render: for each the picture that the reference would be with it. A mistake is a wrong scene, a
//! wrong setting, a wrong use of the picture, or a small program that errs; the textbook bodies know none of them.

mod example;
mod inclusive;
mod input;
mod model;
mod normals;
mod room;
mod scan_line;
mod tracer;

use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::frame::Frame;
use crate::algorithms::patch_view::PatchView;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary;
use crate::color::Rgb;
use crate::methods::{Family, Method, Mistake, Settings, Setup};
use crate::render::{Cancelled, render_unless};
use crate::scene::{Scene, View};
use std::num::NonZeroUsize;

pub(super) use room::gathered as gathered_with;
pub(super) use scan_line::ScanConverter;
pub(super) use tracer::Tracer;

/// What draws a picture: so many threads, for as long as they are to go on.
#[derive(Clone, Copy)]
pub struct Workers<'a> {
    pub threads: NonZeroUsize,
    pub go_on: &'a (dyn Fn() -> Result<(), Cancelled> + Sync),
}

impl Workers<'_> {
    /// A picture that nobody calls off, on one thread.
    #[cfg(test)]
    pub const ONE: Workers<'static> = Workers {
        threads: NonZeroUsize::MIN,
        go_on: &|| Ok(()),
    };
}

/// How the channels of a picture became numbers of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    Linear,
    Srgb,
    /// sRGB of sRGB.
    SrgbTwice,
}

impl Encoding {
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Linear => "linear",
            Encoding::Srgb => "srgb",
            Encoding::SrgbTwice => "srgb_twice",
        }
    }
}

impl Mistake {
    /// The picture with the mistake, and how it is encoded where it should be `right`. None where the mistake changes nothing, or
    /// the picture is called off.
    pub fn picture(
        self,
        setup: &Setup,
        method: Method,
        reference: &Frame,
        right: Encoding,
        workers: Workers,
    ) -> Option<(Frame, Encoding)> {
        let view = setup.prepared.view;
        let frame = match self {
            Mistake::FlipY => rearranged(reference, |x, y, [_, height]| [x, height - 1 - y]),
            Mistake::MirrorX => rearranged(reference, |x, y, [width, _]| [width - 1 - x, y]),
            Mistake::ColumnsFirst => rearranged(reference, |x, y, [width, height]| {
                let number = y * width + x;
                [number / height, number % height]
            }),
            Mistake::SidesSwapped => {
                let scene = setup.prepared.scene.clone();
                let turned = View::new(&scene.camera?, view.height, view.width);
                let turned = with(setup, scene, turned, setup.settings.clone());
                // The same pixels in the same order, in other rows
                Frame {
                    width: view.width,
                    rows: 0..view.height,
                    ..drawn(&turned, setup, method, workers)?
                }
            }
            Mistake::ChannelsSwapped => {
                let mut swapped = reference.clone();
                let colors = swapped.color.iter_mut();
                colors.for_each(|color| *color = Rgb::new(color.b, color.g, color.r));
                swapped
            }
            Mistake::HalfPixelOff => {
                // The middle of a picture that is wider and higher by one pixel is half a pixel away.
                let wider = View {
                    width: view.width + 1,
                    height: view.height + 1,
                    ..view
                };
                let scene = setup.prepared.scene.clone();
                let wider = with(setup, scene, wider, setup.settings.clone());
                let wider = drawn(&wider, setup, method, workers)?;
                filled([view.width, view.height], |x, y| wider.pixel(x, y))
            }
            Mistake::NoSrgb | Mistake::SrgbTwice => {
                let encoding = match (self, right) {
                    (Mistake::NoSrgb, Encoding::Srgb) => Encoding::Linear,
                    (Mistake::SrgbTwice, Encoding::Srgb) => Encoding::SrgbTwice,
                    (Mistake::SrgbTwice, Encoding::Linear) => Encoding::Srgb,
                    _ => return None,
                };
                return Some((reference.clone(), encoding));
            }
            Mistake::FormFactorTransposed | Mistake::ReflectanceForgotten | Mistake::PiTwice => {
                let enclosure = setup.enclosure().ok()?;
                let light = room::light(enclosure, enclosure.matrix()?, self);
                seen(setup, &view, enclosure, &light)
            }
            Mistake::EtaNotSwappedOnLeaving
            | Mistake::ShadowIgnoresLightDistance
            | Mistake::NoShadowOffset
            | Mistake::TirBlack
            | Mistake::NormalNotFlipped
            | Mistake::NormalNotNormalized
            | Mistake::CosNotClamped
            | Mistake::SpecularWithoutNdotl
            | Mistake::ReflectSign
            | Mistake::LightToPoint
            | Mistake::LightNotNormalized
            | Mistake::InclusiveScanRule => match method {
                Method::RayCasting | Method::RayTracing => {
                    let only_casts = method == Method::RayCasting;
                    Tracer::new(setup, only_casts, Some(self)).picture(workers)?
                }
                _ => ScanConverter::new(setup, method, Some(self)).picture(),
            },
            Mistake::EtaInverted
            | Mistake::FovVertical
            | Mistake::FovHalfAngle
            | Mistake::AmbientPerLight
            | Mistake::NoAttenuation
            | Mistake::DepthMinusOne
            | Mistake::DepthPlusOne
            | Mistake::ReflectionForgotten
            | Mistake::AmbientForgotten
            | Mistake::ExponentForgotten
            | Mistake::HighlightSwapped
            | Mistake::NoShadows
            | Mistake::VertexNormalsByArea => {
                drawn(&self.wrong_input(setup)?, setup, method, workers)?
            }
        };
        (frame.color != reference.color).then_some((frame, right))
    }
}

fn with(setup: &Setup, scene: Scene, view: View, settings: Settings) -> Setup {
    Setup::new(PreparedScene::new(scene, view), settings).with_forced(setup.forced())
}

/// What the method draws of other input than that of `setup`. The light of a room stays as it is, whoever looks at it.
fn drawn(wrong: &Setup, setup: &Setup, method: Method, workers: Workers) -> Option<Frame> {
    if method.family() == Family::Exchange {
        let enclosure = setup.enclosure().ok()?;
        let light = enclosure.light(enclosure.matrix()?).ok()?;
        return Some(seen(
            setup,
            &wrong.prepared.view,
            enclosure,
            &light.radiosity,
        ));
    }
    let Workers { threads, go_on } = workers;
    render_unless(wrong, method, threads, |_, _| go_on()).ok()
}

/// The picture of patches that give off `light`.
fn seen(setup: &Setup, view: &View, enclosure: &Enclosure, light: &[Rgb]) -> Frame {
    let primary::Settings { samples, .. } = setup.settings.get();
    let patches = PatchView::new(view, samples, enclosure, light);
    filled([view.width, view.height], |x, y| patches.pixel(x, y))
}

/// The pixels of a picture in other places.
fn rearranged(frame: &Frame, from: impl Fn(u32, u32, [u32; 2]) -> [u32; 2]) -> Frame {
    let size = [frame.width, frame.rows.len() as u32];
    filled(size, |x, y| {
        let [from_x, from_y] = from(x, y, size);
        frame.pixel(from_x, from_y)
    })
}

fn filled([width, height]: [u32; 2], color: impl Fn(u32, u32) -> Rgb) -> Frame {
    let mut frame = Frame::new(width, 0..height, Rgb::BLACK);
    for y in 0..height {
        for x in 0..width {
            let index = frame.index(x, y);
            frame.color[index] = color(x, y);
        }
    }
    frame
}
