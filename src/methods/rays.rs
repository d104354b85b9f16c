//! Ray casting: the visible surface of each pixel, lit. Ray tracing: shadows, reflection and refraction.

use super::{Draw, Family, Properties, RayMethod, Setup, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::ray_tree::{self, RayKind};
use crate::algorithms::visible::Search;
use crate::algorithms::{ray_casting, ray_tracing};
use crate::color::Rgb;
use crate::record::Recorder;
use crate::scene::{Needs, Part};

macro_rules! ray_methods {
    ($($name:ident $text:literal: $module:ident::$tracer:ident, $parts:expr;)*) => {$(
        pub enum $name {}

        impl Properties for $name {
            const NAME: &'static str = $text;
            const FAMILY: Family = Family::Rays;
            const PARTS: &'static [Part] = $parts;

            fn visit<V: Visitor>(visitor: V) -> V::Output {
                visitor.rays::<Self>()
            }
        }

        impl Draw for $name {
            type Event = $module::Event;

            fn draw<R: Recorder<Self::Event>>(
                setup: &Setup,
                focus: Focus,
                frame: &mut Frame,
                search: impl Search,
                recorder: &mut R,
            ) {
                let settings = setup.settings.get();
                let tracer = $module::$tracer::new(&setup.prepared, settings, setup.needs(), search);
                $module::$module(&tracer, focus, frame, recorder);
            }
        }

        impl RayMethod for $name {
            type Tracer<'a, S: Search + Sync + 'a> = $module::$tracer<'a, S>;

            fn tracer<'a, S: Search + Sync>(
                setup: &'a Setup,
                needs: &'a Needs,
                search: S,
            ) -> $module::$tracer<'a, S> {
                $module::$tracer::new(&setup.prepared, setup.settings.get(), needs, search)
            }

            fn pixel<S: Search + Sync, R: Recorder<Self::Event>>(
                tracer: &$module::$tracer<'_, S>,
                x: u32,
                y: u32,
                recorder: &mut R,
            ) -> Rgb {
                tracer.pixel(x, y, recorder)
            }
        }
    )*};
}

ray_methods! {
    RayCasting "ray-casting": ray_casting::RayCaster, &[
        Part::TextureCoordinates,
        Part::Highlights,
        Part::LightBalls,
    ];
    RayTracing "ray-tracing": ray_tracing::RayTracer, &[
        Part::ReflectedRays,
        Part::TransmittedRays,
        Part::TextureCoordinates,
        Part::Highlights,
        Part::LightBalls,
        Part::PathAttenuation,
        Part::ShadowRays,
    ];
}

impl From<ray_casting::Event> for ray_tracing::Event {
    fn from(event: ray_casting::Event) -> Self {
        use ray_casting::Event;
        match event {
            Event::PreparedScene(event) => event.into(),
            Event::Primary(event) => event.into(),
            Event::Ray { ray } => {
                let (kind, level) = (RayKind::Primary, 1);
                ray_tree::Event::Ray { kind, level, ray }.into()
            }
            Event::Visible(event) => event.into(),
            Event::Surface(event) => event.into(),
            Event::Illumination(event) => event.into(),
            Event::Local { emission, local } => ray_tree::Event::Local { emission, local }.into(),
            Event::Returned { color } => ray_tree::Event::Returned { color }.into(),
        }
    }
}
