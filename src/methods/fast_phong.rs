//! Fast Phong shading: the cosines as Taylor series over a triangle.

use super::{Draw, Family, Properties, Setup, ShadingEvent, ShadingMethod, Visitor};
use crate::algorithms::fast_phong::{self as algorithm, fast_phong};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::shading;
use crate::algorithms::visible::Search;
use crate::record::Recorder;
use crate::scene::Part;

pub enum FastPhong {}

impl Properties for FastPhong {
    const NAME: &'static str = "fast-phong";
    const FAMILY: Family = Family::Polygons;
    const PANELS: &'static [&'static str] = &["image", "scan-line", "inspector"];

    /// Its series includes the highlight, whatever the material.
    fn does(part: Part) -> bool {
        part == Part::TextureCoordinates
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.shading::<Self>()
    }
}

impl Draw for FastPhong {
    type Event = algorithm::Event;

    fn draw<R: Recorder<Self::Event>>(
        setup: &Setup,
        focus: Focus,
        frame: &mut Frame,
        _: impl Search,
        recorder: &mut R,
    ) {
        fast_phong(&setup.prepared, focus, frame, recorder);
    }
}

impl ShadingMethod for FastPhong {}

impl ShadingEvent for algorithm::Event {
    type Shading = algorithm::FastPhong;

    /// All but the series.
    fn shading(&self) -> Option<&shading::Event<algorithm::FastPhong>> {
        match self {
            algorithm::Event::Shading(event) => Some(event),
            _ => None,
        }
    }
}
