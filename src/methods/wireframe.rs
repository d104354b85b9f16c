//! The edges alone: nothing is lit, so nothing of a surface matters.

use super::{Draw, Family, Properties, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::visible::Search;
use crate::algorithms::wireframe::{self as algorithm, wireframe};
use crate::record::Recorder;
use crate::scene::Part;

pub enum Wireframe {}

impl Properties for Wireframe {
    const NAME: &'static str = "wireframe";
    const FAMILY: Family = Family::Polygons;

    fn does(_: Part) -> bool {
        false
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.wireframe()
    }
}

impl Draw for Wireframe {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        prepared: &PreparedScene,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        wireframe(prepared, focus, frame, recorder);
    }
}
