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
            entry("event-vertex", VERTEX),
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

/// Where a vertex of a divided object is; of a polygon and a mesh the scene states it.
const VERTEX: &[Formula] = &[
    is("{θ=polar_angle} := [180 latitude_step; latitude_steps]").when(SPHERE),
    is("{φ=longitude} := [180 longitude_step; latitude_steps]").when(SPHERE),
    is("P_v = true_center + true_radius · (sin {θ=polar_angle} sin {φ=longitude} axis_x + cos {θ=polar_angle} axis_y + sin {θ=polar_angle} cos {φ=longitude} axis_z)")
        .when(SPHERE),
    is("{φ=longitude} := [360 ring_step; ring_steps]").when(RING),
    is("P_v = ring_base + ring_height ring_axis + ring_radius · (cos {φ=longitude} ring_across_x + sin {φ=longitude} ring_across_y)")
        .when(RING),
    // A Bézier patch: along each row of control points, then across the rows.
    is("{u=patch_u} := [patch_column; patch_steps]").when(PATCH_VERTEX),
    is("{v=patch_v} := [patch_row; patch_steps]").when(PATCH_VERTEX),
    is("{Q_0=row_0} := (1 − {u=patch_u})^3 control_00 + 3 {u=patch_u} (1 − {u=patch_u})^2 control_01 + 3 {u=patch_u}^2 (1 − {u=patch_u}) control_02 + {u=patch_u}^3 control_03")
        .when(PATCH_VERTEX),
    is("{Q_1=row_1} := (1 − {u=patch_u})^3 control_10 + 3 {u=patch_u} (1 − {u=patch_u})^2 control_11 + 3 {u=patch_u}^2 (1 − {u=patch_u}) control_12 + {u=patch_u}^3 control_13")
        .when(PATCH_VERTEX),
    is("{Q_2=row_2} := (1 − {u=patch_u})^3 control_20 + 3 {u=patch_u} (1 − {u=patch_u})^2 control_21 + 3 {u=patch_u}^2 (1 − {u=patch_u}) control_22 + {u=patch_u}^3 control_23")
        .when(PATCH_VERTEX),
    is("{Q_3=row_3} := (1 − {u=patch_u})^3 control_30 + 3 {u=patch_u} (1 − {u=patch_u})^2 control_31 + 3 {u=patch_u}^2 (1 − {u=patch_u}) control_32 + {u=patch_u}^3 control_33")
        .when(PATCH_VERTEX),
    is("P_v = (1 − {v=patch_v})^3 {Q_0=row_0} + 3 {v=patch_v} (1 − {v=patch_v})^2 {Q_1=row_1} + 3 {v=patch_v}^2 (1 − {v=patch_v}) {Q_2=row_2} + {v=patch_v}^3 {Q_3=row_3}")
        .when(PATCH_VERTEX),
    is("P_v").when(STATED),
];

const RING: When = When::Known("ring_base");
const PATCH_VERTEX: When = When::Known("patch_row");
const STATED: When = When::All(&[
    When::Not(&SPHERE),
    When::Not(&RING),
    When::Not(&PATCH_VERTEX),
]);
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
