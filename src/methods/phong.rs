//! Phong shading: the normal interpolated from the vertices, lit at every pixel.

use super::{Draw, Family, Properties, ShadingMethod, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::phong::{self as algorithm, phong};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

pub enum Phong {}

impl Properties for Phong {
    const NAME: &'static str = "phong";
    const FAMILY: Family = Family::Polygons;

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
        prepared: &PreparedScene,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        phong(prepared, focus, frame, recorder);
    }
}

impl ShadingMethod for Phong {}
