//! Lit at every pixel with the normal of the true surface.

use super::{Draw, Family, Properties, ShadingMethod, Visitor};
use crate::algorithms::exact::{self as algorithm, exact};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

pub enum Exact {}

impl Properties for Exact {
    const NAME: &'static str = "exact";
    const FAMILY: Family = Family::Polygons;

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
        prepared: &PreparedScene,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        exact(prepared, focus, frame, recorder);
    }
}

impl ShadingMethod for Exact {}
