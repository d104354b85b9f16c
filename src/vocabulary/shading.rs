//! What the scan-line methods that light surfaces have in common.

use super::Declared;
use super::entry::{Formula, When, entry, is};
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
            entry(
                "event-true-point",
                &[
                    is("{u=sight} := [{P_0=P<} − eye; |{P_0=P<} − eye|]").when(ROUND),
                    // A sphere
                    is("{a=true_a} := {u=sight} · {u=sight}").when(SPHERE),
                    is("{b=true_b} := {u=sight} · (eye − true_center)").when(SPHERE),
                    is("{c=true_c} := |eye − true_center|^2 − true_radius^2").when(SPHERE),
                    // The side of a cylinder: the same, across its axis
                    is("{o=across_eye} := (eye − true_base) − ((eye − true_base) · true_axis) true_axis").when(SIDE),
                    is("{v=across_sight} := {u=sight} − ({u=sight} · true_axis) true_axis").when(SIDE),
                    is("{a=true_a} := {v=across_sight} · {v=across_sight}").when(SIDE),
                    is("{b=true_b} := {v=across_sight} · {o=across_eye}").when(SIDE),
                    is("{c=true_c} := |{o=across_eye}|^2 − true_side_radius^2").when(SIDE),
                    is("{D=true_discriminant} := {b=true_b}^2 − {a=true_a} · {c=true_c}").when(ROUND),
                    is("{t=true_t} := [−{b=true_b} − √{D=true_discriminant}; {a=true_a}]").when(NEAR),
                    is("{t=true_t} := [−{b=true_b} + √{D=true_discriminant}; {a=true_a}]").when(FAR),
                    is("{n=from_center} := eye + {t=true_t} · {u=sight} − true_center").when(SPHERE),
                    is("{q=from_base} := eye + {t=true_t} · {u=sight} − true_base").when(SIDE),
                    is("{n=from_center} := {q=from_base} − ({q=from_base} · true_axis) true_axis").when(SIDE),
                    is("N = [{n=from_center}; |{n=from_center}|]").when(ROUND),
                    is("P = true_center + true_radius · N").when(SPHERE),
                    is("P = true_base + ({q=from_base} · true_axis) true_axis + true_side_radius · N").when(SIDE),
                    // An end of a cylinder is flat, as its polygon is
                    is("P = {P_0=P<}").when(END),
                    is("N = true_end_normal").when(END),
                    // A patch S, met by Newton's iteration
                    is("P = 'S(u, v)'").when(PATCH).unevaluated(NEWTON),
                    is("N = ['S_u × S_v'; '|S_u × S_v|']").when(PATCH).unevaluated(NEWTON),
                ],
            ),
        ];
}

const SPHERE: When = When::Known("true_center");
const SIDE: When = When::Known("true_base");
const END: When = When::Known("true_end_normal");
const PATCH: When = When::Known("true_patches");
const ROUND: When = When::All(&[When::Not(&END), When::Not(&PATCH)]);
/// Of the two places where the ray meets the surface, the one on the side of the polygon that is seen.
const NEAR: When = When::All(&[ROUND, When::True("sees_front")]);
const FAR: When = When::All(&[ROUND, When::Not(&When::True("sees_front"))]);
const NEWTON: &str = "the steps of Newton’s iteration for u and v are not recorded";

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
