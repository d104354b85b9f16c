//! Cosines as Taylor series over a triangle, and by differences along its spans.

use super::Declared;
use super::entry::{Formula, When, entry, is, only};
use super::scan_line::INCREMENTAL;
use crate::algorithms::fast_phong::{Event, PSEUDOCODE};
use crate::algorithms::shading;
use crate::language::Message;
use crate::record::{self, Fields, Line};

/// A polynomial in the distance from the point of expansion, on the screen.
macro_rules! polynomial {
    ($name:literal) => {
        concat!(
            $name,
            " = {T_5<<light,cosine in Illumination,Light} {x=from_middle_x}^2",
            " + {T_4<<light,cosine in Illumination,Light} {x=from_middle_x} {y=from_middle_y}",
            " + {T_3<<light,cosine in Illumination,Light} {y=from_middle_y}^2",
            " + {T_2<<light,cosine in Illumination,Light} {x=from_middle_x}",
            " + {T_1<<light,cosine in Illumination,Light} {y=from_middle_y}",
            " + {T_0<<light,cosine in Illumination,Light}",
        )
    };
}
/// The projection of a corner of the triangle, by its number.
macro_rules! placed {
    ($number:literal) => {
        &[
            is(concat!("N_", $number)),
            is(concat!(
                "z_",
                $number,
                " = (corner_position − eye) · forward"
            ))
            .when(WHOLE),
            is(concat!(
                "x_",
                $number,
                " = [width; 2] + focal · [(corner_position − eye) · right; z_",
                $number,
                "]"
            ))
            .when(WHOLE),
            is(concat!(
                "y_",
                $number,
                " = [height; 2] − focal · [(corner_position − eye) · up; z_",
                $number,
                "]"
            ))
            .when(WHOLE),
            is(concat!("z_", $number, " = 'z_h' + 's' ('z_s' − 'z_h')"))
                .when(PIECE)
                .unevaluated(PIECES),
            is(concat!(
                "x_",
                $number,
                " = [width; 2] + focal · ['x_c'; z_",
                $number,
                "]"
            ))
            .when(PIECE)
            .unevaluated(PIECES),
            is(concat!(
                "y_",
                $number,
                " = [height; 2] − focal · ['y_c'; z_",
                $number,
                "]"
            ))
            .when(PIECE)
            .unevaluated(PIECES),
        ]
    };
}

vocabulary! {
    [] Event {
        Event::Shading(event) => event,
    };
    Event::Triangle { triangle, corners: [a, b, c] } => "Triangle" at "triangle" number "triangle" scope "scope-triangle"
        {
            "triangle" = triangle,
            "a" = a,
            "b" = b,
            "c" = c,
        }
        [
            entry("event-triangle", &[]),
        ];
    Event::TriangleCorner { number, place, depth, normal } => "TriangleCorner" at "normal-series"
        {
            "corner" = number,
            "x_1" | "x_2" | "x_3" = OfCorner(number, ["x_1", "x_2", "x_3"], place.x),
            "y_1" | "y_2" | "y_3" = OfCorner(number, ["y_1", "y_2", "y_3"], place.y),
            "z_1" | "z_2" | "z_3" = OfCorner(number, ["z_1", "z_2", "z_3"], depth),
            "N_1" | "N_2" | "N_3" = OfCorner(number, ["N_1", "N_2", "N_3"], normal),
        }
        [
            only(When::Equals("corner", 0), "event-triangle-corner", placed!("1")),
            only(When::Equals("corner", 1), "event-triangle-corner", placed!("2")),
            entry("event-triangle-corner", placed!("3")),
        ];
    Event::NormalAtMiddle { middle, depth, n_0, vanished, turned, cut } => "NormalAtMiddle" at "normal-series"
        {
            "x_0" = middle.x,
            "y_0" = middle.y,
            "z_0" = depth,
            "N_0" = n_0,
            "vanished" = vanished,
            "turned" = turned,
            "cut" = cut,
        }
        [
            only(
                When::True("cut"),
                "event-normal-at-middle-of-pieces",
                &[
                    is("x_0 = ['Σ A_k x_k'; 'Σ A_k']").unevaluated(PIECES),
                    is("y_0 = ['Σ A_k y_k'; 'Σ A_k']").unevaluated(PIECES),
                    is("z_0 = ['Σ A_k'; 'Σ A_k / z_k']").unevaluated(PIECES),
                    is("N_0 = ['N_1 + N_2 + N_3'; 3] + 'Δx N_x' + 'Δy N_y'").unevaluated(PIECES),
                    ],
            ),
            entry(
                "event-normal-at-middle",
                &[
                    is("x_0 = [x_1 + x_2 + x_3; 3]"),
                    is("y_0 = [y_1 + y_2 + y_3; 3]"),
                    is("N_0 = [N_1 + N_2 + N_3; 3]").when(When::All(&[NOT_VANISHED, NOT_TURNED])),
                    is("N_0 = −[N_1 + N_2 + N_3; 3]").when(When::All(&[NOT_VANISHED, TURNED])),
                    is("N_0 = face_normal").when(When::All(&[VANISHED, NOT_TURNED])),
                    is("N_0 = −face_normal").when(When::All(&[VANISHED, TURNED])),
                    is("[1; z_0] = [1 / z_1 + 1 / z_2 + 1 / z_3; 3]"),
                    ],
            ),
        ];
    Event::NormalSlopes { n_x, n_y } => "NormalSlopes" at "normal-series"
        {
            "N_x" = n_x,
            "N_y" = n_y,
        }
        [
            entry(
                "event-normal-slopes",
                &[
                    is("{D=double_area} := (x_2 − x_1) (y_3 − y_1) − (x_3 − x_1) (y_2 − y_1)"),
                    is("N_x = [(y_3 − y_1) (N_2 − N_1) − (y_2 − y_1) (N_3 − N_1); {D=double_area}]")
                        .when(When::All(&[SLOPES, NOT_TURNED])),
                    is("N_y = [(x_2 − x_1) (N_3 − N_1) − (x_3 − x_1) (N_2 − N_1); {D=double_area}]")
                        .when(When::All(&[SLOPES, NOT_TURNED])),
                    is("N_x = −[(y_3 − y_1) (N_2 − N_1) − (y_2 − y_1) (N_3 − N_1); {D=double_area}]")
                        .when(When::All(&[SLOPES, TURNED])),
                    is("N_y = −[(x_2 − x_1) (N_3 − N_1) − (x_3 − x_1) (N_2 − N_1); {D=double_area}]")
                        .when(When::All(&[SLOPES, TURNED])),
                    is("N_x = 0 N_0").when(When::Not(&SLOPES)),
                    is("N_y = 0 N_0").when(When::Not(&SLOPES)),
                    ],
            ),
        ];
    Event::NormalSquared { squared: [q_x, q_y, q_xx, q_xy, q_yy] } => "NormalSquared" at "normal-series"
        {
            "q_x" = q_x,
            "q_y" = q_y,
            "q_xx" = q_xx,
            "q_xy" = q_xy,
            "q_yy" = q_yy,
        }
        [
            entry(
                "event-normal-squared",
                &[
                    is("q_x = [2 (N_x · N_0); N_0 · N_0]"),
                    is("q_y = [2 (N_y · N_0); N_0 · N_0]"),
                    is("q_xx = [N_x · N_x; N_0 · N_0]"),
                    is("q_xy = [2 (N_x · N_y); N_0 · N_0]"),
                    is("q_yy = [N_y · N_y; N_0 · N_0]"),
                    ],
            ),
        ];
    Event::DotProduct { cosine, along: [p_0, p_x, p_y] } => "DotProduct" at "series"
        {
            "cosine" = cosine.name(),
            "p_0" = p_0,
            "p_x" = p_x,
            "p_y" = p_y,
        }
        [
            only(When::Is("cosine", "N_dot_L"), "event-dot-product", ALONG_L),
            only(When::Is("cosine", "N_dot_H"), "event-dot-product", ALONG_H),
            entry("event-dot-product", ALONG_V),
        ];
    Event::Series { cosine, series } => "Series" at "series"
        {
            "cosine" = cosine.name(),
            "T_0" = series.0[0],
            "T_1" = series.0[1],
            "T_2" = series.0[2],
            "T_3" = series.0[3],
            "T_4" = series.0[4],
            "T_5" = series.0[5],
        }
        [
            only(When::Is("cosine", "N_dot_L"), "event-series-n-dot-l", QUOTIENT),
            only(When::Is("cosine", "N_dot_V"), "event-series-n-dot-v", QUOTIENT),
            only(
                When::Is("cosine", "R_dot_V"),
                "event-series-highlight",
                &[
                    is("T_0 = 2 {l_0=T_0@cosine:\"N_dot_L\"} {v_0=T_0@cosine:\"N_dot_V\"} − L · V"),
                    is("T_1 = 2 ({l_0=T_0@cosine:\"N_dot_L\"} {v_1=T_1@cosine:\"N_dot_V\"} + {l_1=T_1@cosine:\"N_dot_L\"} {v_0=T_0@cosine:\"N_dot_V\"})"),
                    is("T_2 = 2 ({l_0=T_0@cosine:\"N_dot_L\"} {v_2=T_2@cosine:\"N_dot_V\"} + {l_2=T_2@cosine:\"N_dot_L\"} {v_0=T_0@cosine:\"N_dot_V\"})"),
                    is("T_3 = 2 ({l_0=T_0@cosine:\"N_dot_L\"} {v_3=T_3@cosine:\"N_dot_V\"} + {l_1=T_1@cosine:\"N_dot_L\"} {v_1=T_1@cosine:\"N_dot_V\"} + {l_3=T_3@cosine:\"N_dot_L\"} {v_0=T_0@cosine:\"N_dot_V\"})"),
                    is("T_4 = 2 ({l_0=T_0@cosine:\"N_dot_L\"} {v_4=T_4@cosine:\"N_dot_V\"} + {l_1=T_1@cosine:\"N_dot_L\"} {v_2=T_2@cosine:\"N_dot_V\"} + {l_2=T_2@cosine:\"N_dot_L\"} {v_1=T_1@cosine:\"N_dot_V\"} + {l_4=T_4@cosine:\"N_dot_L\"} {v_0=T_0@cosine:\"N_dot_V\"})"),
                    is("T_5 = 2 ({l_0=T_0@cosine:\"N_dot_L\"} {v_5=T_5@cosine:\"N_dot_V\"} + {l_2=T_2@cosine:\"N_dot_L\"} {v_2=T_2@cosine:\"N_dot_V\"} + {l_5=T_5@cosine:\"N_dot_L\"} {v_0=T_0@cosine:\"N_dot_V\"})"),
                    ],
            ),
            entry("event-series-highlight", QUOTIENT),
        ];
    Event::LightExpanded => "LightExpanded" at "light"
        {
        }
        [
            entry("event-light-expanded", &[]),
        ];
    Event::Expanded => "Expanded" at "triangle"
        {
        }
        [
            entry("event-expanded", &[]),
        ];
    Event::DifferencesStarted { light, cosine, running } => "DifferencesStarted" at "differences"
        {
            "light" = light,
            "cosine" = cosine.name(),
            "c" = running.value,
            "dc" = running.first,
            "d2c" = running.second,
        }
        [
            entry(
                "event-differences-started",
                &[
                    is("{x=from_middle_x} := first + 0.5 − x_0"),
                    FROM_MIDDLE_Y,
                    is(polynomial!("c")),
                    is(FIRST_DIFFERENCE),
                    is(SECOND_DIFFERENCE),
                    ],
            ),
        ];
    Event::CosineEvaluated { light, cosine, running, direct, exact } => "CosineEvaluated" at "increments"
        {
            "light" = light,
            "cosine" = cosine.name(),
            "c" = running.value,
            "dc" = running.first,
            "d2c" = running.second,
            "c_direct" = direct,
            "c_exact" = exact,
            "difference" = running.value - direct,
            "error" = running.value - exact,
        }
        [
            only(When::Is("cosine", "N_dot_L"), "event-cosine-evaluated-n-dot-l", EVALUATED),
            entry("event-cosine-evaluated-highlight", EVALUATED),
        ];
    Event::LightSummed { power, i_d, i_s } => "LightSummed" at "sum"
        {
            "power" = power,
            "I_d" = i_d,
            "I_s" = i_s,
        }
        [
            entry(
                "event-light-summed",
                &[
                    is("I_d = material_k_d · {I_light<<light in Illumination,Light} · {f_att<<light in Illumination,Light} · {c=c@cosine:\"N_dot_L\"}"),
                    is("{c_{table}^n=power} = 'max(0, c)^n'").unevaluated(TABLE).noted(FROM_TABLE),
                    is("I_s = material_k_s · {I_light<<light in Illumination,Light} · {f_att<<light in Illumination,Light} · {c_{table}^n=power}"),
                    ],
            ),
        ];
    Event::TriangleDone => "TriangleDone" at "triangle"
        {
        }
        [
            entry("event-triangle-done", &[]),
        ];
}

const FROM_MIDDLE_Y: Formula = is("{y=from_middle_y} := y_4 − y_0");
const FIRST_DIFFERENCE: &str = "dc = {T_5<<light,cosine in Illumination,Light} (2 {x=from_middle_x} + 1) + {T_4<<light,cosine in Illumination,Light} {y=from_middle_y} + {T_2<<light,cosine in Illumination,Light}";
const SECOND_DIFFERENCE: &str = "d2c = 2 {T_5<<light,cosine in Illumination,Light}";
const EVALUATED: &[Formula] = &[
    is("c = {c_{old}=c<<light,cosine,x_0,y,x-1} + {Δc_{old}=dc<<light,cosine,x_0,y,x-1}").when(GOES_ON),
    is("dc = {Δc_{old}=dc<<light,cosine,x_0,y,x-1} + d2c").when(GOES_ON),
    is("{x=from_middle_x} := x_P − x_0"),
    FROM_MIDDLE_Y,
    is("c = c_direct").when(STARTS),
    is(FIRST_DIFFERENCE).when(STARTS),
    is(SECOND_DIFFERENCE).when(STARTS),
    is(polynomial!("c_direct")),
    is("{Δ=difference} = c − c_direct").noted(INCREMENTAL),
    is("d2c = {Δ^2c=d2c<<light,cosine,x_0,y,x-1}").when(GOES_ON),
    is("{N=linear_normal} := N_0 + {x=from_middle_x} N_x + {y=from_middle_y} N_y"),
    is("c_exact = [{N=linear_normal} · {L<<light in Illumination,Light}; |{N=linear_normal}|]")
        .when(When::Is("cosine", "N_dot_L")),
    is("c_exact = [{N=linear_normal} · {H<<light in Illumination,Light}; |{N=linear_normal}|]")
        .when(When::Is("cosine", "N_dot_H")),
    is("c_exact = [2 ({N=linear_normal} · {L<<light in Illumination,Light}) ({N=linear_normal} · {V@}); |{N=linear_normal}|^2] − {L<<light in Illumination,Light} · {V@}")
        .when(When::Is("cosine", "R_dot_V")),
    is("error = c − c_exact").noted(APPROXIMATE),
];
/// The pixel to the left was evaluated too.
const GOES_ON: When = When::Known("{c<<light,cosine,x_0,y,x-1}");
const STARTS: When = When::Not(&GOES_ON);
const QUOTIENT: &[Formula] = &[
    is("T_0 = p_0"),
    is("T_1 = p_y − [p_0 q_y; 2]"),
    is("T_2 = p_x − [p_0 q_x; 2]"),
    is("T_3 = [3 p_0 q_y^2 − 4 p_0 q_yy − 4 p_y q_y; 8]"),
    is("T_4 = [3 p_0 q_x q_y − 2 p_0 q_xy − 2 p_y q_x − 2 p_x q_y; 4]"),
    is("T_5 = [3 p_0 q_x^2 − 4 p_0 q_xx − 4 p_x q_x; 8]"),
];

/// The coefficients of the dot product of N with the direction of that name.
macro_rules! along {
    ($toward:literal) => {
        &[
            is(concat!("p_0 = [N_0 · ", $toward, "; |N_0|]")),
            is(concat!("p_x = [N_x · ", $toward, "; |N_0|]")),
            is(concat!("p_y = [N_y · ", $toward, "; |N_0|]")),
        ]
    };
}
const ALONG_L: &[Formula] = along!("L");
const ALONG_H: &[Formula] = along!("H");
const ALONG_V: &[Formula] = along!("V");

/// The triangle was not cut.
const WHOLE: When = When::Known("corner_position");
const PIECE: When = When::Not(&WHOLE);
const TURNED: When = When::True("turned");
const NOT_TURNED: When = When::Not(&TURNED);
/// The normals of the corners cancel out.
const VANISHED: When = When::True("vanished");
const NOT_VANISHED: When = When::Not(&VANISHED);
/// The triangle has an area, and its normals do not cancel out.
const SLOPES: When = When::All(&[NOT_VANISHED, When::Not(&When::Zero("double_area"))]);
const PIECES: &str = "a triangle that reaches behind the eye is cut to pieces";
const TABLE: &str = "a table gives the power";
const FROM_TABLE: Message = Message("note-power-table");

/// A value of one of the three corners of a triangle, under the name that its number gives it.
struct OfCorner<T>(u32, [&'static str; 3], T);

impl<T: super::declare::Recorded> super::declare::Recorded for OfCorner<T> {
    fn push(self, _: &'static str, fields: &mut Fields) {
        self.2.push(self.1[self.0 as usize], fields);
    }
}

const APPROXIMATE: Message = Message("note-approximate");

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        match self {
            // The directions have lines of their own here, for they are found once a triangle.
            Event::Shading(shading::Event::Illumination(event)) => PSEUDOCODE
                .labelled(event.label())
                .unwrap_or_else(|| PSEUDOCODE.line("expansion")),
            Event::Shading(event) => event.line(),
            _ => PSEUDOCODE.line(self.label()),
        }
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
