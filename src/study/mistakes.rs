//! Classic mistakes in programs that render: for each the picture that the reference would be with it. A mistake is a wrong scene, a
//! wrong setting, a wrong use of the picture, or a search that errs; the textbook bodies know none of them.

use crate::algorithms::frame::Frame;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary;
use crate::algorithms::visible::{self, Blocker, Bvh, Search};
use crate::color::Rgb;
use crate::methods::{Family, Method, RayMethod, RayTracing, Setup};
use crate::record::{Recorder, Unrecorded};
use crate::render::render;
use crate::scene::primitives::{Nearest, Primitives, Ray};
use crate::scene::{Camera, Light, Scene, View};
use std::num::{NonZeroU32, NonZeroUsize};

named! {
    /// A mistake, by its name in `compare`.
    pub enum Mistake {
        /// η inside is taken for 1/η.
        EtaInverted = "eta_inverted",
        /// What lies behind a light casts a shadow too.
        ShadowIgnoresLightDistance = "shadow_ignores_light_distance",
        /// The angle of the camera is taken for its height.
        FovVertical = "fov_vertical",
        /// The angle of the camera is taken for its half.
        FovHalfAngle = "fov_half_angle",
        /// Upside down.
        FlipY = "flip_y",
        /// Left and right changed places.
        MirrorX = "mirror_x",
        /// Rays through the corners of pixels instead of their centres.
        HalfPixelOff = "half_pixel_off",
        /// Linear numbers written for the screen.
        NoSrgb = "no_srgb",
        /// Encoded for the screen twice.
        SrgbTwice = "srgb_twice",
        /// The ambient term added once a light.
        AmbientPerLight = "ambient_per_light",
        /// Lights are as bright at any distance.
        NoAttenuation = "no_attenuation",
        /// One level of the ray tree too few.
        DepthMinusOne = "depth_minus_one",
        /// One level too many.
        DepthPlusOne = "depth_plus_one",
        /// k_r is left out, so mirrors are dull.
        ReflectionForgotten = "reflection_forgotten",
    }
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
    /// The picture with the mistake, and how it is encoded where it should be `right`. None where the mistake changes nothing.
    pub fn picture(
        self,
        setup: &Setup,
        method: Method,
        reference: &Frame,
        right: Encoding,
        threads: NonZeroUsize,
    ) -> Option<(Frame, Encoding)> {
        let scene = &setup.prepared.scene;
        let view = setup.prepared.view;
        let drawn = |scene: Scene, view: View, depth: Option<i64>| {
            let mut settings = setup.settings.clone();
            if let Some(depth) = depth {
                let rays: primary::Settings = settings.get();
                let depth = u32::try_from(depth).ok().and_then(NonZeroU32::new)?;
                settings = settings.with(primary::Settings { depth, ..rays });
            }
            let setup = Setup::new(PreparedScene::new(scene, view), settings);
            setup.check_for(method).ok()?;
            Some(render(&setup, method, threads, &|_, _| {}))
        };
        let traced = method == Method::RayTracing;
        let depth = i64::from(setup.settings.get::<primary::Settings>().depth.get());
        let frame = match self {
            Mistake::EtaInverted if traced => {
                let mut scene = scene.clone();
                for material in &mut scene.materials {
                    material.ior = 1.0 / material.ior;
                }
                drawn(scene, view, None)
            }
            Mistake::ShadowIgnoresLightDistance if traced => Some(with_far_blockers(setup)),
            Mistake::FovVertical | Mistake::FovHalfAngle => {
                let camera = scene.camera?;
                let fov_x = if self == Mistake::FovHalfAngle {
                    2.0 * camera.fov_x
                } else {
                    let aspect = f64::from(view.width) / f64::from(view.height);
                    2.0 * ((0.5 * camera.fov_x).tan() * aspect).atan()
                };
                let camera = Camera { fov_x, ..camera };
                let wrong = View::new(&camera, view.width, view.height);
                (fov_x < 3.1).then(|| drawn(scene.clone(), wrong, None))?
            }
            Mistake::FlipY => Some(rearranged(reference, |x, y, [_, height]| {
                [x, height - 1 - y]
            })),
            Mistake::MirrorX => Some(rearranged(reference, |x, y, [width, _]| [width - 1 - x, y])),
            Mistake::HalfPixelOff => {
                let wider = View {
                    width: view.width + 1,
                    height: view.height + 1,
                    ..view
                };
                drawn(scene.clone(), wider, None).map(|wider| {
                    let mut frame = Frame::new(view.width, 0..view.height, Rgb::BLACK);
                    for y in 0..view.height {
                        for x in 0..view.width {
                            let index = frame.index(x, y);
                            frame.color[index] = wider.pixel(x, y);
                        }
                    }
                    frame
                })
            }
            Mistake::NoSrgb | Mistake::SrgbTwice if right == Encoding::Srgb => {
                let encoding = match self {
                    Mistake::NoSrgb => Encoding::Linear,
                    _ => Encoding::SrgbTwice,
                };
                return Some((reference.clone(), encoding));
            }
            Mistake::AmbientPerLight if scene.lights.len() > 1 => {
                let ambient = scene.ambient * scene.lights.len() as f64;
                let scene = Scene {
                    ambient,
                    ..scene.clone()
                };
                drawn(scene, view, None)
            }
            Mistake::NoAttenuation => {
                let mut scene = scene.clone();
                for light in &mut scene.lights {
                    if let Light::Point { attenuation, .. } = light {
                        *attenuation = [1.0, 0.0, 0.0];
                    }
                }
                drawn(scene, view, None)
            }
            Mistake::DepthMinusOne if traced => drawn(scene.clone(), view, Some(depth - 1)),
            Mistake::DepthPlusOne if traced => drawn(scene.clone(), view, Some(depth + 1)),
            Mistake::ReflectionForgotten if traced => {
                let mut scene = scene.clone();
                for material in &mut scene.materials {
                    material.reflection = Rgb::BLACK;
                }
                drawn(scene, view, None)
            }
            _ => None,
        }?;
        (frame.color != reference.color).then_some((frame, right))
    }

    /// Whether a program that draws by that method can make it at all.
    pub fn concerns(self, method: Method) -> bool {
        let of_rays = [
            Mistake::EtaInverted,
            Mistake::ShadowIgnoresLightDistance,
            Mistake::DepthMinusOne,
            Mistake::DepthPlusOne,
            Mistake::ReflectionForgotten,
        ];
        let of_lamps = [Mistake::AmbientPerLight, Mistake::NoAttenuation];
        match method.family() {
            Family::Exchange => !of_rays.contains(&self) && !of_lamps.contains(&self),
            _ => method == Method::RayTracing || !of_rays.contains(&self),
        }
    }
}

/// The pixels of a picture in other places.
fn rearranged(frame: &Frame, from: impl Fn(u32, u32, [u32; 2]) -> [u32; 2]) -> Frame {
    let size = [frame.width, frame.rows.len() as u32];
    let mut moved = frame.clone();
    for y in 0..size[1] {
        for x in 0..size[0] {
            let [from_x, from_y] = from(x, y, size);
            let index = moved.index(x, y);
            moved.color[index] = frame.pixel(from_x, from_y);
        }
    }
    moved
}

/// Ray tracing whose shadow rays do not end at the light.
fn with_far_blockers(setup: &Setup) -> Frame {
    let tracer = RayTracing::tracer(setup, setup.needs(), FarBlockers(Bvh));
    let mut frame = setup.prepared.empty_frame();
    for y in frame.rows.clone() {
        for x in 0..frame.width {
            let index = frame.index(x, y);
            frame.color[index] = RayTracing::pixel(&tracer, x, y, &mut Unrecorded);
        }
    }
    frame
}

/// Finds blockers at any distance.
#[derive(Clone, Copy)]
struct FarBlockers<S>(S);

impl<S: Search> Search for FarBlockers<S> {
    fn nearest<E: From<visible::Event>>(
        self,
        scene: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        recorder: &mut impl Recorder<E>,
    ) -> Option<Nearest> {
        self.0.nearest(scene, primitives, ray, recorder)
    }

    fn blocker<E: From<visible::Event>>(
        self,
        scene: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        _: f64,
        recorder: &mut impl Recorder<E>,
    ) -> Option<Blocker> {
        self.0
            .blocker(scene, primitives, ray, f64::INFINITY, recorder)
    }
}
