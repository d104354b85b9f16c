//! Flat shading: one intensity a polygon.

use super::{Draw, Family, Properties, ShadingMethod, Visitor};
use crate::algorithms::flat::{self as algorithm, flat};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

pub enum Flat {}

impl Properties for Flat {
    const NAME: &'static str = "flat";
    const FAMILY: Family = Family::Polygons;

    fn does(part: Part) -> bool {
        matches!(part, Part::TextureCoordinates | Part::Highlights)
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.shading::<Self>()
    }
}

impl Draw for Flat {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        prepared: &PreparedScene,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        flat(prepared, focus, frame, recorder);
    }
}

impl ShadingMethod for Flat {}
