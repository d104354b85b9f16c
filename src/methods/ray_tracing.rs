//! Ray tracing: shadows, reflection and refraction.

use super::{Draw, Family, Properties, RayMethod, Setup, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::ray_tracing::{self as algorithm, RayTracer, ray_tracing};
use crate::algorithms::visible::Search;
use crate::color::Rgb;
use crate::record::Recorder;
use crate::scene::{Needs, Part};

pub enum RayTracing {}

impl Properties for RayTracing {
    const NAME: &'static str = "ray-tracing";
    const FAMILY: Family = Family::Rays;
    const PANELS: &'static [&'static str] = &["image", "ray-tree", "rays"];

    fn does(part: Part) -> bool {
        !part.concerns_patches()
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.rays::<Self>()
    }
}

impl Draw for RayTracing {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        search: impl Search,
        recorder: &mut R,
    ) {
        let tracer = RayTracer::new(&setup.prepared, setup.settings.rays, setup.needs(), search);
        ray_tracing(&tracer, focus, frame, recorder);
    }
}

impl RayMethod for RayTracing {
    type Tracer<'a, S: Search + Sync + 'a> = RayTracer<'a, S>;

    fn tracer<'a, S: Search + Sync>(
        setup: &'a Setup,
        needs: &'a Needs,
        search: S,
    ) -> RayTracer<'a, S> {
        RayTracer::new(&setup.prepared, setup.settings.rays, needs, search)
    }

    fn pixel<S: Search + Sync, R: Recorder<Self::Event>>(
        tracer: &RayTracer<'_, S>,
        x: u32,
        y: u32,
        recorder: &mut R,
    ) -> Rgb {
        tracer.pixel(x, y, recorder)
    }
}
