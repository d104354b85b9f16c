//! The edges alone: nothing is lit, so nothing of a surface matters.

use super::{Draw, Family, Properties, Setup, Visitor};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::visible::Search;
use crate::algorithms::wireframe::{self as algorithm, wireframe};
use crate::record::Recorder;
use crate::scene::Part;

pub enum Wireframe {}

impl Properties for Wireframe {
    const NAME: &'static str = "wireframe";
    const FAMILY: Family = Family::Polygons;
    const PARTS: &'static [Part] = &[];

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.wireframe()
    }
}

impl Draw for Wireframe {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        wireframe(&setup.prepared, focus, frame, recorder);
    }
}
