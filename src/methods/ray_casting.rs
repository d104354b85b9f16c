//! Ray casting: the visible surface of each pixel, lit.

use super::{Draw, Family, Properties, RayMethod, Setup, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::ray_casting::{self as algorithm, RayCaster, ray_casting};
use crate::algorithms::ray_tracing;
use crate::algorithms::ray_tree::{self, RayKind};
use crate::algorithms::visible::Search;
use crate::color::Rgb;
use crate::record::Recorder;
use crate::scene::{Needs, Part};

pub enum RayCasting {}

impl Properties for RayCasting {
    const NAME: &'static str = "ray-casting";
    const FAMILY: Family = Family::Rays;
    const PANELS: &'static [&'static str] = &["image", "ray-tree", "rays"];

    fn does(part: Part) -> bool {
        part.concerns_primary_rays()
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.rays::<Self>()
    }
}

impl Draw for RayCasting {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        search: impl Search,
        recorder: &mut R,
    ) {
        let tracer = RayCaster::new(&setup.prepared, setup.settings.rays, setup.needs(), search);
        ray_casting(&tracer, focus, frame, recorder);
    }
}

impl RayMethod for RayCasting {
    type Tracer<'a, S: Search + Sync + 'a> = RayCaster<'a, S>;

    fn tracer<'a, S: Search + Sync>(
        setup: &'a Setup,
        needs: &'a Needs,
        search: S,
    ) -> RayCaster<'a, S> {
        RayCaster::new(&setup.prepared, setup.settings.rays, needs, search)
    }

    fn pixel<S: Search + Sync, R: Recorder<Self::Event>>(
        tracer: &RayCaster<'_, S>,
        x: u32,
        y: u32,
        recorder: &mut R,
    ) -> Rgb {
        tracer.pixel(x, y, recorder)
    }
}

impl From<algorithm::Event> for ray_tracing::Event {
    fn from(event: algorithm::Event) -> Self {
        use algorithm::Event;
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
