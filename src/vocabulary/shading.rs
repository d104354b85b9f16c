//! What the scan-line methods that light surfaces have in common.

use super::Declared;
use super::entry::{Formula, entry, is};
use crate::algorithms::shading::{Event, Shading};
use crate::algorithms::texture;
use crate::record::{self, Fields, Line};

vocabulary! {
    [M: Shading] Event<M> {
        Event::PreparedScene(event) => event,
        Event::Normal(event) => event,
        Event::Illumination(event) => event,
        Event::ScanLine(event) => event,
        Event::Texture(event) => event,
    };
    Event::Middle { position } => "Middle" at "middle"
        {
            "P_m" = position,
        }
        [
            entry("event-middle", &[is("P_m = [Σ{polygon_corners}; corner_count]")]),
        ];
    Event::Vertex { vertex, position } => "Vertex" at "vertex" number "vertex" scope "scope-vertex"
        {
            "vertex" = vertex,
            "P_v" = position,
        }
        [
            entry("event-vertex", &[is("P_v")]),
        ];
    Event::VertexLit { vertex, intensity } => "VertexLit" at "vertex-lit"
        {
            "vertex" = vertex,
            "I_v" = intensity,
        }
        [
            entry("event-vertex-lit", &[is("I_v = {illumination(P_v, N_v)=I@}")]),
        ];
    Event::VertexReady { vertex } => "VertexReady" at "vertex-normal"
        {
            "vertex" = vertex,
        }
        [
            entry("event-vertex-ready", &[]),
        ];
    Event::PixelPoint { position } => "PixelPoint" at "point"
        {
            "P" = position,
        }
        [
            entry("event-pixel-point", &[PIXEL_POINT, is("P = eye + [z; focal] (screen_point − eye)")]),
        ];
    Event::PixelNormal { length, normal } => "PixelNormal" at "normal"
        {
            "length" = length,
            "N" = normal,
        }
        [
            entry(
                "event-pixel-normal",
                &[
                    is("{|N_P|=length} = |N_P_incremental|"),
                    is("N = [N_P_incremental; {|N_P|=length}]"),
                    ],
            ),
        ];
    Event::PixelNormalLost { length, normal } => "PixelNormalLost" at "normal"
        {
            "length" = length,
            "N" = normal,
        }
        [
            entry("event-pixel-normal-lost", &[is("{|N_P|=length} = |N_P_incremental|"), is("N = face_normal")]),
        ];
    Event::TruePoint { position, normal } => "TruePoint" at "normal"
        {
            "P" = position,
            "N" = normal,
        }
        [
            entry("event-true-point", &[is("P"), is("N")]),
        ];
}

/// The point of the projection plane at the centre of the pixel.
const PIXEL_POINT: Formula = is(
    "screen_point = eye + (x_P − [width; 2]) · right + ([height; 2] − (y + 0.5)) · up + focal · forward",
);

impl<M: Shading> record::Event for Event<M> {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        match self {
            Event::Illumination(event) => {
                crate::algorithms::illumination::PSEUDOCODE.line(event.label())
            }
            Event::Texture(event) => texture::PSEUDOCODE.line(event.label()),
            // A method that needs P for its texture alone finds it there.
            Event::PixelPoint { .. } => {
                let own = M::LISTING.labelled(self.label());
                own.unwrap_or_else(|| texture::PSEUDOCODE.line(self.label()))
            }
            _ => M::LISTING.line(self.label()),
        }
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
