//! Phong shading: the normal interpolated from the vertices, lit at every pixel.

use super::{Draw, Family, Properties, Setup, ShadingMethod, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::phong::{self as algorithm, phong};
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

pub enum Phong {}

impl Properties for Phong {
    const NAME: &'static str = "phong";
    const FAMILY: Family = Family::Polygons;
    const PANELS: &'static [&'static str] = &["image", "scan-line", "inspector"];

    fn does(part: Part) -> bool {
        matches!(part, Part::TextureCoordinates | Part::Highlights)
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.shading::<Self>()
    }
}

impl Draw for Phong {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        phong(&setup.prepared, focus, frame, recorder);
    }
}

impl ShadingMethod for Phong {}
