//! Lit at every pixel with the normal of the true surface.

use super::{Draw, Family, Properties, Setup, ShadingMethod, Visitor};
use crate::algorithms::exact::{self as algorithm, exact};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

pub enum Exact {}

impl Properties for Exact {
    const NAME: &'static str = "exact";
    const FAMILY: Family = Family::Polygons;
    const PANELS: &'static [&'static str] = &["image", "scan-line", "inspector"];

    fn does(part: Part) -> bool {
        matches!(part, Part::TextureCoordinates | Part::Highlights)
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.shading::<Self>()
    }
}

impl Draw for Exact {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        exact(&setup.prepared, focus, frame, recorder);
    }
}

impl ShadingMethod for Exact {}
