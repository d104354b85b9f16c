//! Gouraud shading: intensity interpolated from the vertices.

use super::{Draw, Family, Properties, Setup, ShadingMethod, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::gouraud::{self as algorithm, gouraud};
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

pub enum Gouraud {}

impl Properties for Gouraud {
    const NAME: &'static str = "gouraud";
    const FAMILY: Family = Family::Polygons;
    const PANELS: &'static [&'static str] = &["image", "scan-line", "inspector"];

    fn does(part: Part) -> bool {
        matches!(part, Part::TextureCoordinates | Part::Highlights)
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.shading::<Self>()
    }
}

impl Draw for Gouraud {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        gouraud(&setup.prepared, focus, frame, recorder);
    }
}

impl ShadingMethod for Gouraud {}
