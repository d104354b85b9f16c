//! Scan conversion: edge table, scan lines, spans and pixels, whatever is interpolated.

use super::declare::Interpolated;
use super::entry::{Formula, When, entry, is, only};
use super::texture;
use crate::algorithms::scan_line::{Event, Named};
use crate::language::Message;

vocabulary! {
    [A: Named] Event<A> {
    };
    Event::EdgeTable { corners } => "EdgeTable" at "edge-table" scope "scope-edge-table"
        {
            "corners" = corners,
        }
        [
            entry("event-edge-table", &[]),
        ];
    Event::CornerTransformed { corner, position } => "CornerTransformed" at "edge-table"
        {
            "corner" = corner,
            "x_c" = position.x,
            "y_c" = position.y,
            "z_c" = position.z,
        }
        [
            only(
                When::Known("corner_position"),
                "event-corner-transformed",
                &[
                    is("x_c = (corner_position − eye) · right"),
                    is("y_c = (corner_position − eye) · up"),
                    is("z_c = (corner_position − eye) · forward"),
                    ],
            ),
            only(
                When::Known("hidden_z"),
                "event-corner-cut",
                &[
                    is("{s=cut_share} := [near − hidden_z; seen_z − hidden_z]"),
                    is("x_c = hidden_x + {s=cut_share} (seen_x − hidden_x)"),
                    is("y_c = hidden_y + {s=cut_share} (seen_y − hidden_y)"),
                    is("z_c = near"),
                    ],
            ),
            entry(
                "event-corner-of-piece",
                &[
                    is("x_c = 'x_h' + 's' ('x_s' − 'x_h')").unevaluated(CUT),
                    is("y_c = 'y_h' + 's' ('y_s' − 'y_h')").unevaluated(CUT),
                    is("z_c = 'z_h' + 's' ('z_s' − 'z_h')").unevaluated(CUT),
                    ],
            ),
        ];
    Event::CornerPlaced { corner, x, y, z, value } => "CornerPlaced" at "edge-table"
        {
            "corner" = corner,
            "x" = x,
            "y" = y,
            "z" = z,
            "I" | "N" = Interpolated(value, |names| names.corner),
        }
        [
            entry(
                "event-corner-placed",
                &[
                    is("x = [width; 2] + focal · [x_c; z_c]"),
                    is("y = [height; 2] − focal · [y_c; z_c]"),
                    is("z = z_c"),
                    is("I").when(When::Recorded("I")),
                    is("N").when(When::Recorded("N")),
                    ],
            ),
        ];
    Event::CornerTextured { corner, uv } => "CornerTextured" at "edge-table"
        {
            "corner" = corner,
            "u_k" = uv.x,
            "v_k" = uv.y,
        }
        [
            only(When::Known("corner_position"), "event-corner-textured", texture::CORNER),
            only(When::Known("hidden_z"), "event-corner-cut", texture::CORNER_CUT),
            entry("event-corner-of-piece", texture::CORNER_OF_PIECE),
        ];
    Event::EdgeEntered { edge, upper, lower, first, end, slope, step } => "EdgeEntered" at "edge-table"
        {
            "edge" = edge,
            "upper" = upper,
            "lower" = lower,
            "first" = first,
            "end" = end,
            "dx_dy" = slope,
            "dI_dy" | "dN_dy" = Interpolated(step, |names| names.step),
        }
        [
            entry(
                "event-edge-entered",
                &[
                    is(
                    "dx_dy = [{x_2=x@corner:lower} − {x_1=x@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
                    ),
                    is(
                        "dI_dy = [{I_2=I@corner:lower} − {I_1=I@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
                    )
                    .when(When::Recorded("dI_dy")),
                    is(
                        "dN_dy = [{N_2=N@corner:lower} − {N_1=N@corner:upper}; {y_2=y@corner:lower} − {y_1=y@corner:upper}]",
                    )
                    .when(When::Recorded("dN_dy")),
                    ],
            ),
        ];
    Event::EdgeSkipped { from, to } => "EdgeSkipped" at "edge-table"
        {
            "from" = from,
            "to" = to,
        }
        [
            entry("event-edge-skipped", &[]),
        ];
    Event::EdgeTableBuilt { edges } => "EdgeTableBuilt" at "edge-table"
        {
            "edges" = edges,
        }
        [
            entry("event-edge-table-built", &[]),
        ];
    Event::ScanLine { y, y_4 } => "ScanLine" at "scan-line" number "y" scope "scope-scan-line"
        {
            "y" = y,
            "y_4" = y_4,
        }
        [
            entry("event-scan-line", &[is("y_4 = y + 0.5")]),
        ];
    Event::Edge { edge, upper, lower, y_1, y_2, x_4, z_4 } => "Edge" at "edge" number "edge" scope "scope-edge"
        {
            "edge" = edge,
            "upper" = upper,
            "lower" = lower,
            "y_1" = y_1,
            "y_2" = y_2,
            "x_4" = x_4,
            "z_4" = z_4,
        }
        [
            only(
                When::Recorded("x_4"),
                "event-edge",
                &[
                    is("x_4 = {x_1=x@corner:upper} + (y_4 − y_1) · {dx_dy@edge:edge}"),
                    is(
                        "[1; z_4] = [y_2 − y_4; y_2 − y_1] · [1; {z_1=z@corner:upper}] + [y_4 − y_1; y_2 − y_1] · [1; {z_2=z@corner:lower}]",
                    ),
                    is("y_1 = {y@corner:upper}"),
                    is("y_2 = {y@corner:lower}"),
                    ],
            ),
        ];
    Event::EdgeEnds { upper, lower } => "EdgeEnds" at "cut"
        {
            "I_1" | "N_1" = Interpolated(upper, |names| names.upper),
            "I_2" | "N_2" = Interpolated(lower, |names| names.lower),
        }
        [
            only(
                When::Recorded("N_1"),
                "event-edge-ends-normal",
                &[is("N_1 = {N@corner:upper}"), is("N_2 = {N@corner:lower}")],
            ),
            entry(
                "event-edge-ends-intensity",
                &[is("I_1 = {I@corner:upper}"), is("I_2 = {I@corner:lower}")],
            ),
        ];
    Event::EdgeTextured { upper, lower, cut } => "EdgeTextured" at "cut"
        {
            "u_1" = upper.x,
            "v_1" = upper.y,
            "u_2" = lower.x,
            "v_2" = lower.y,
            "u_4" = cut.x,
            "v_4" = cut.y,
        }
        [
            entry("event-edge-textured", texture::EDGE),
        ];
    Event::EdgeInterpolated { direct, incremental } => "EdgeInterpolated" at "cut"
        {
            "I_4" | "N_4" = Interpolated(direct, |names| names.left),
            "I_4_incremental" | "N_4_incremental" = Interpolated(incremental, |names| names.left_incremental),
            "difference" = Interpolated(incremental.minus(direct), |_| "difference"),
        }
        [
            only(
                When::Recorded("N_4"),
                "event-edge-interpolated-normal",
                &[
                    is(
                    "N_4 = [y_4 − y_2; y_1 − y_2] · N_1 + [y_1 − y_4; y_1 − y_2] · N_2",
                    ),
                    is("{ΔN=dN_dy@edge:edge} = [N_2 − N_1; y_2 − y_1]").when(NORMAL_ABOVE),
                    is("{N_4′=N_4_incremental} = {N_4=N_4_incremental<<polygon,edge,y-1} + {ΔN=dN_dy@edge:edge}")
                        .when(NORMAL_ABOVE)
                        .noted(ROW_BELOW),
                    is("{N_4′=N_4_incremental} = N_4").when(When::Not(&NORMAL_ABOVE)).noted(FIRST_ROW),
                    is("{Δ=difference} = {N_4′=N_4_incremental} − N_4").noted(INCREMENTAL),
                    ],
            ),
            entry(
                "event-edge-interpolated-intensity",
                &[
                    is(
                    "I_4 = [y_4 − y_2; y_1 − y_2] · I_1 + [y_1 − y_4; y_1 − y_2] · I_2",
                    ),
                    is("{ΔI=dI_dy@edge:edge} = [I_2 − I_1; y_2 − y_1]").when(ABOVE),
                    is("{I_4′=I_4_incremental} = {I_4=I_4_incremental<<polygon,edge,y-1} + {ΔI=dI_dy@edge:edge}")
                        .when(ABOVE)
                        .noted(ROW_BELOW),
                    is("{I_4′=I_4_incremental} = I_4").when(When::Not(&ABOVE)).noted(FIRST_ROW),
                    is("{Δ=difference} = {I_4′=I_4_incremental} − I_4").noted(INCREMENTAL),
                    ],
            ),
        ];
    Event::EdgeCut => "EdgeCut" at "cut"
        {
        }
        [
            entry("event-edge-cut", &[]),
        ];
    Event::Span { x_4, x_5, z_4, z_5, first, end } => "Span" at "span" number "first" scope "scope-span"
        {
            "x_4" = x_4,
            "x_5" = x_5,
            "z_4" = z_4,
            "z_5" = z_5,
            "first" = first,
            "end" = end,
        }
        [
            entry("event-span", &[is("x_4"), is("x_5")]),
        ];
    Event::SpanEnds { left, right } => "SpanEnds" at "span"
        {
            "I_4" | "N_4" = Interpolated(left, |names| names.left),
            "I_5" | "N_5" = Interpolated(right, |names| names.right),
        }
        [
            only(When::Recorded("N_4"), "event-span-ends-normal", &[is("N_4"), is("N_5")]),
            entry("event-span-ends-intensity", &[is("I_4"), is("I_5")]),
        ];
    Event::SpanTextured { left, right } => "SpanTextured" at "span"
        {
            "u_4" = left.x,
            "v_4" = left.y,
            "u_5" = right.x,
            "v_5" = right.y,
        }
        [
            entry("event-span-textured", &[is("u_4"), is("v_4"), is("u_5"), is("v_5")]),
        ];
    Event::Pixel { x, y, x_p } => "Pixel" at "pixel" number "x" scope "scope-pixel"
        {
            "x" = x,
            "y" = y,
            "x_P" = x_p,
        }
        [
            entry("event-pixel", &[is("x_P = x + 0.5")]),
        ];
    Event::DepthTested { z, nearest, nearer } => "DepthTested" at "depth"
        {
            "z" = z,
            "nearest" = nearest,
            "nearer" = nearer,
        }
        [
            only(When::True("nearer"), "event-depth-tested-nearer", &[is("z < nearest"), DEPTH]),
            entry("event-depth-tested-hidden", &[is("z ≥ nearest"), DEPTH]),
        ];
    Event::SpanInterpolated { direct, incremental } => "SpanInterpolated" at "interpolation"
        {
            "I_P" | "N_P" = Interpolated(direct, |names| names.pixel),
            "I_P_incremental" | "N_P_incremental" = Interpolated(incremental, |names| names.pixel_incremental),
            "difference" = Interpolated(incremental.minus(direct), |_| "difference"),
        }
        [
            only(
                When::Recorded("N_P"),
                "event-span-interpolated-normal",
                &[
                    is(
                    "N_P = [x_5 − x_P; x_5 − x_4] · N_4 + [x_P − x_4; x_5 − x_4] · N_5",
                    ),
                    is("{ΔN=span_step} := [N_5 − N_4; x_5 − x_4]").when(NORMAL_BEFORE),
                    is("{N_P′=N_P_incremental} = {N_P=N_P_incremental<<polygon,y,first,x-1} + {ΔN=span_step}")
                        .when(NORMAL_BEFORE)
                        .noted(NEXT_PIXEL),
                    is("{N_P′=N_P_incremental} = N_P").when(When::Not(&NORMAL_BEFORE)).noted(FIRST_PIXEL),
                    is("{Δ=difference} = {N_P′=N_P_incremental} − N_P").noted(INCREMENTAL),
                    ],
            ),
            entry(
                "event-span-interpolated-intensity",
                &[
                    is(
                    "I_P = [x_5 − x_P; x_5 − x_4] · I_4 + [x_P − x_4; x_5 − x_4] · I_5",
                    ),
                    is("{ΔI=span_step} := [I_5 − I_4; x_5 − x_4]").when(BEFORE),
                    is("{I_P′=I_P_incremental} = {I_P=I_P_incremental<<polygon,y,first,x-1} + {ΔI=span_step}")
                        .when(BEFORE)
                        .noted(NEXT_PIXEL),
                    is("{I_P′=I_P_incremental} = I_P").when(When::Not(&BEFORE)).noted(FIRST_PIXEL),
                    is("{Δ=difference} = {I_P′=I_P_incremental} − I_P").noted(INCREMENTAL),
                    ],
            ),
        ];
    Event::PixelColored { color } => "PixelColored" at "color"
        {
            "color" = color,
        }
        [
            only(
                When::Recorded("N_P_incremental"),
                "event-pixel-colored-own-normal",
                &[is("{pixel=color} = {I@}")],
            ),
            only(
                When::Recorded("I_textured"),
                "event-pixel-colored-textured",
                &[is("{pixel=color} = {I textured=I_textured}")],
            ),
            only(
                When::Recorded("x_0"),
                "event-pixel-colored-summed",
                &[
                    is("{pixel=color} = {I_a@} + Σ{*I_d} + Σ{*I_s}").when(LIGHT_ARRIVES),
                    is("{pixel=color} = {I_a@}").when(When::Not(&LIGHT_ARRIVES)),
                    ],
            ),
            only(
                When::Recorded("I_P_incremental"),
                "event-pixel-colored-interpolated",
                &[is("{pixel=color} = I_P_incremental")],
            ),
            entry("event-pixel-colored-of-polygon", &[is("{pixel=color} = {I@}")]),
        ];
    Event::PixelHidden => "PixelHidden" at "depth"
        {
        }
        [
            entry("event-pixel-hidden", &[]),
        ];
    Event::SpanDone => "SpanDone" at "span"
        {
        }
        [
            entry("event-span-done", &[]),
        ];
    Event::ScanLineDone => "ScanLineDone" at "scan-line"
        {
        }
        [
            entry("event-scan-line-done", &[]),
        ];
}

/// The depth of the pixel, whose inverse is linear on the screen.
const DEPTH: Formula =
    is("[1; z] = [x_5 − x_P; x_5 − x_4] · [1; z_4] + [x_P − x_4; x_5 − x_4] · [1; z_5]");
/// Whether the same edge was cut a row higher.
const ABOVE: When = When::Known("{I_4_incremental<<polygon,edge,y-1}");
const NORMAL_ABOVE: When = When::Known("{N_4_incremental<<polygon,edge,y-1}");
/// Whether the pixel to the left was coloured.
const BEFORE: When = When::Known("{I_P_incremental<<polygon,y,first,x-1}");
const NORMAL_BEFORE: When = When::Known("{N_P_incremental<<polygon,y,first,x-1}");
/// Whether any light reaches the pixel.
const LIGHT_ARRIVES: When = When::Known("{*I_d}");
pub(super) const CUT: &str = "a piece of what the near plane and the sides of the picture leave";
const ROW_BELOW: Message = Message("note-row-below");
const FIRST_ROW: Message = Message("note-first-row");
const NEXT_PIXEL: Message = Message("note-next-pixel");
const FIRST_PIXEL: Message = Message("note-first-pixel");
pub(super) const INCREMENTAL: Message = Message("note-incremental");
