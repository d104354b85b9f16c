//! Textures on polygons.

use super::entry::{Formula, When, entry, is, only};
use super::scan_line::CUT;
use crate::algorithms::texture::Event;

vocabulary! {
    [] Event {
    };
    Event::Textured { uv, color } => "Textured" at "chart"
        {
            "u_texture" = uv.x,
            "v_texture" = uv.y,
            "texture" = color,
        }
        [
            only(
                When::Recorded("x_P"),
                "event-textured",
                CHART,
            ),
        ];
    Event::TexturedLinearly { uv, color } => "TexturedLinearly" at "chart"
        {
            "u_linear" = uv.x,
            "v_linear" = uv.y,
            "texture_linear" = color,
        }
        [
            entry(
                "event-textured-linearly",
                &[
                    is("u_linear = [x_5 − x_P; x_5 − x_4] · u_4 + [x_P − x_4; x_5 − x_4] · u_5"),
                    is("v_linear = [x_5 − x_P; x_5 − x_4] · v_4 + [x_P − x_4; x_5 − x_4] · v_5"),
                    is("{m=cells} := ⌊[u_linear; checker_scale]⌋ + ⌊[v_linear; checker_scale]⌋").when(CHECKER),
                    is(PARITY).when(CHECKER),
                    is("texture_linear = (1 − {k=parity}) · checker_even + {k=parity} · checker_odd").when(CHECKER),
                ],
            ),
        ];
    Event::TextureTaken { color, linear } => "TextureTaken" at "texture"
        {
            "T" = color,
            "linear" = linear,
        }
        [
            only(
                When::True("linear"),
                "event-texture-taken-linear",
                &[is("T = texture_linear")],
            ),
            entry("event-texture-taken-exact", &[is("T = texture")]),
        ];
    Event::TextureApplied { diffuse, textured } => "TextureApplied" at "applied"
        {
            "I_d" = diffuse,
            "I_textured" = textured,
        }
        [
            entry(
                "event-texture-applied",
                &[
                    is("{I textured=I_textured} = I_P_incremental − I_d + T · I_d")
                        .when(When::Recorded("I_P_incremental")),
                    is("{I textured=I_textured} = {I@} − I_d + T · I_d")
                        .when(When::All(&[When::Unrecorded("I_P_incremental"), When::Unrecorded("x_0")])),
                    is("{I textured=I_textured} = {I_a@} + Σ{*I_s} + T · I_d").when(SUMMED_AND_LIT),
                    is("{I textured=I_textured} = {I_a@} + T · I_d").when(SUMMED_AND_DARK),
                ],
            ),
        ];
}

/// (u, v) at P by the chart of the object, and the colour of the cell that they lie in.
pub(super) const CHART: &[Formula] = &[
    // A sphere: longitude and latitude.
    is("{d=from_center} := P − chart_center").when(SPHERE),
    is("{u=u_texture} = [atan2({d=from_center} · axis_x, {d=from_center} · axis_z); 360]")
        .when(SPHERE),
    is("{v=v_texture} = [1; 180] arccos [{d=from_center} · axis_y; |{d=from_center}|]")
        .when(SPHERE),
    // A plane: lengths.
    is("{u=u_texture} = (P − chart_point) · chart_along_u").when(PLANE),
    is("{v=v_texture} = (P − chart_point) · chart_along_v").when(PLANE),
    // A cylinder: longitude and height.
    is("{d=from_base} := P − chart_base").when(CYLINDER),
    is("{u=u_texture} = [atan2({d=from_base} · chart_across_y, {d=from_base} · chart_across_x); 360]")
        .when(CYLINDER),
    is("{v=v_texture} = max(0, min(1, [{d=from_base} · chart_axis; chart_height]))").when(CYLINDER),
    // Four corners: the (u, v) whose bilinear mix of them is P.
    is("quadrilateral_a + {u=u_texture} · (quadrilateral_b − quadrilateral_a) + {v=v_texture} · (quadrilateral_d − quadrilateral_a) + {u=u_texture} · {v=v_texture} · (quadrilateral_a − quadrilateral_b + quadrilateral_c − quadrilateral_d) = P")
        .when(When::Known("quadrilateral_a")),
    // A triangle: the mix of its corners by areas.
    is("{Δ=whole_area} := (chart_b − chart_a) × (chart_c − chart_a) · facing_axis").when(TRIANGLE),
    is("{w_B=weight_b} := [(P − chart_a) × (chart_c − chart_a) · facing_axis; {Δ=whole_area}]")
        .when(TRIANGLE),
    is("{w_C=weight_c} := [(chart_b − chart_a) × (P − chart_a) · facing_axis; {Δ=whole_area}]")
        .when(TRIANGLE),
    is("{u=u_texture} = u_a + {w_B=weight_b} · (u_b − u_a) + {w_C=weight_c} · (u_c − u_a)")
        .when(TRIANGLE),
    is("{v=v_texture} = v_a + {w_B=weight_b} · (v_b − v_a) + {w_C=weight_c} · (v_c − v_a)")
        .when(TRIANGLE),
    // More corners: shares of a rectangle around them.
    is("{u=u_texture} = [(P − rectangle_corner) · rectangle_along_u; |rectangle_along_u|^2]")
        .when(RECTANGLE),
    is("{v=v_texture} = [(P − rectangle_corner) · rectangle_along_v; |rectangle_along_v|^2]")
        .when(RECTANGLE),
    is("{m=cells} := ⌊[{u=u_texture}; checker_scale]⌋ + ⌊[{v=v_texture}; checker_scale]⌋")
        .when(CHECKER),
    is(PARITY).when(CHECKER),
    is("texture = (1 − {k=parity}) · checker_even + {k=parity} · checker_odd").when(CHECKER),
];

/// (u, v) at a corner of a polygon by the chart of the object; the file of a mesh, and a triangle, state them.
pub(super) const CORNER: &[Formula] = &[
    is("{d=from_center} := corner_position − chart_center").when(SPHERE),
    is("u_k = [atan2({d=from_center} · axis_x, {d=from_center} · axis_z); 360] − corner_turns")
        .when(BESIDE_POLE),
    // Every meridian meets a pole: it takes the one of the middle of its face.
    is("{m=from_center_to_middle} := [Σ{polygon_corners}; corner_count] − chart_center").when(POLE),
    is("u_k = [atan2({m=from_center_to_middle} · axis_x, {m=from_center_to_middle} · axis_z); 360]")
        .when(POLE),
    is("v_k = [1; 180] arccos [{d=from_center} · axis_y; |{d=from_center}|]").when(SPHERE),
    is("quadrilateral_a + u_k · (quadrilateral_b − quadrilateral_a) + v_k · (quadrilateral_d − quadrilateral_a) + u_k · v_k · (quadrilateral_a − quadrilateral_b + quadrilateral_c − quadrilateral_d) = corner_position")
        .when(When::Known("quadrilateral_a")),
    is("u_k = [(corner_position − rectangle_corner) · rectangle_along_u; |rectangle_along_u|^2]")
        .when(RECTANGLE),
    is("v_k = [(corner_position − rectangle_corner) · rectangle_along_v; |rectangle_along_v|^2]")
        .when(RECTANGLE),
    is("u_k").when(TRIANGLE),
    is("v_k").when(TRIANGLE),
];

/// At a corner where the near plane cuts an edge.
pub(super) const CORNER_CUT: &[Formula] = &[
    is("{s=cut_share} := [near − hidden_z; seen_z − hidden_z]"),
    is("u_k = hidden_u + {s=cut_share} (seen_u − hidden_u)"),
    is("v_k = hidden_v + {s=cut_share} (seen_v − hidden_v)"),
];
pub(super) const CORNER_OF_PIECE: &[Formula] = &[
    is("u_k = 'u_h' + 's' ('u_s' − 'u_h')").unevaluated(CUT),
    is("v_k = 'v_h' + 's' ('v_s' − 'v_h')").unevaluated(CUT),
];
/// Where the scan line cuts an edge.
pub(super) const EDGE: &[Formula] = &[
    is("u_4 = [y_4 − y_2; y_1 − y_2] · u_1 + [y_1 − y_4; y_1 − y_2] · u_2"),
    is("v_4 = [y_4 − y_2; y_1 − y_2] · v_1 + [y_1 − y_4; y_1 − y_2] · v_2"),
    is("u_1 = {u_k@corner:upper}"),
    is("v_1 = {v_k@corner:upper}"),
    is("u_2 = {u_k@corner:lower}"),
    is("v_2 = {v_k@corner:lower}"),
];

const POLE: When = When::True("corner_is_pole");
const BESIDE_POLE: When = When::All(&[SPHERE, When::Not(&POLE)]);
const SPHERE: When = When::Known("chart_center");
const PLANE: When = When::Known("chart_point");
const CYLINDER: When = When::Known("chart_base");
const TRIANGLE: When = When::Known("chart_a");
const RECTANGLE: When = When::Known("rectangle_corner");
const CHECKER: When = When::Known("checker_scale");
const PARITY: &str = "{k=parity} := {m=cells} − 2 · ⌊[{m=cells}; 2]⌋";

/// Fast Phong sums up the terms of its lights, of which any may reach the pixel.
const SUMMED_AND_LIT: When = When::All(&[When::Recorded("x_0"), When::Known("{*I_s}")]);
const SUMMED_AND_DARK: When =
    When::All(&[When::Recorded("x_0"), When::Not(&When::Known("{*I_s}"))]);
