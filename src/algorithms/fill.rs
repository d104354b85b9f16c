//! Fills the polygons of a stage by scan conversion: plain ones with what their corners carry, textured ones with the texture besides.
//! Polygons without a texture carry no (u, v).

use super::focus::Region;
use super::frame::Frame;
use super::prepared_scene::{Polygon, PreparedScene};
use super::scan_line::{Cargo, Corner, Event, Fragment, ScanLine};
use super::texture::{AtPixel, OnPolygon, WithUv};
use crate::color::Rgb;
use crate::record::Recorder;

/// Scan converters with the memory that they use from polygon to polygon. Plain polygons carry `P`, textured ones `T`, of which `P` is a part.
pub struct Fill<'a, P, T> {
    prepared: &'a PreparedScene,
    region: &'a Region,
    plain: ScanLine<P>,
    plain_corners: Vec<Corner<P>>,
    textured: ScanLine<WithUv<T>>,
    textured_corners: Vec<Corner<WithUv<T>>>,
}

impl<'a, P: Cargo + From<T>, T: Cargo<Recorded = P::Recorded>> Fill<'a, P, T> {
    pub fn new(prepared: &'a PreparedScene, region: &'a Region) -> Self {
        Fill {
            prepared,
            region,
            plain: ScanLine::default(),
            plain_corners: Vec::new(),
            textured: ScanLine::default(),
            textured_corners: Vec::new(),
        }
    }

    /// Draws a polygon whose corners carry `values`, in their order. `plain` turns a fragment of it into a colour where it has no texture,
    /// `textured` where it has one.
    pub fn polygon<E: From<Event<P::Recorded>>, R: Recorder<E>>(
        &mut self,
        polygon: &Polygon<'a>,
        values: &[T],
        frame: &mut Frame,
        recorder: &mut R,
        plain: impl FnMut(&mut R, Fragment<P>) -> Rgb,
        mut textured: impl FnMut(&mut R, Fragment<T>, AtPixel) -> Rgb,
    ) {
        let (view, region) = (&self.prepared.view, self.region);
        let places = polygon.corners().map(|(_, place)| place.camera);
        let corners = places.zip(values.iter().copied());
        let Some(on) = OnPolygon::of(self.prepared, polygon) else {
            self.plain_corners.clear();
            self.plain_corners
                .extend(corners.map(|(position, value)| Corner {
                    position,
                    value: value.into(),
                }));
            self.plain
                .fill(&self.plain_corners, view, region, frame, recorder, plain);
            return;
        };
        self.textured_corners.clear();
        self.textured_corners
            .extend(
                corners
                    .zip(on.corners())
                    .map(|((position, value), &uv)| Corner {
                        position,
                        value: WithUv { value, uv },
                    }),
            );
        let shade = |recorder: &mut R, fragment: Fragment<WithUv<T>>| {
            let WithUv { value, uv } = fragment.value;
            let texture = AtPixel {
                on: &on,
                linear: uv,
            };
            textured(recorder, fragment.with(value), texture)
        };
        self.textured
            .fill(&self.textured_corners, view, region, frame, recorder, shade);
    }
}
