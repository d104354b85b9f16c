//! How t of a ray and an object is found: by the quadratic of a sphere or of a cylinder's side, or by the plane of a triangle. An
//! object that the ray misses shows where that comes from.

use super::entry::{Formula, When, is};

/// The formulas of a test along the direction of that name, after a comparison.
macro_rules! tested {
    ($u:literal $(, $comparison:literal)?) => {
        &[
            $(is($comparison),)?
            is("t = 0").when(TOUCHES),
            // A sphere
            is(concat!("{a=quadratic_a} := ", $u, " · ", $u)).when(SPHERE),
            is(concat!("{b=quadratic_b} := 2 (", $u, " · (O − sphere_center))")).when(SPHERE),
            is("{c=quadratic_c} := |O − sphere_center|^2 − sphere_radius^2").when(SPHERE),
            // The side of a cylinder: the same, across its axis
            is("{o=across_origin} := (O − side_base) − ((O − side_base) · side_axis) side_axis").when(SIDE),
            is(concat!("{v=across_direction} := ", $u, " − (", $u, " · side_axis) side_axis")).when(SIDE),
            is("{a=quadratic_a} := {v=across_direction} · {v=across_direction}").when(SIDE),
            is("{b=quadratic_b} := 2 ({v=across_direction} · {o=across_origin})").when(SIDE),
            is("{c=quadratic_c} := |{o=across_origin}|^2 − side_radius^2").when(SIDE),
            is("{D=discriminant} := {b=quadratic_b}^2 − 4 · {a=quadratic_a} · {c=quadratic_c}").when(ROUND),
            is("{D=discriminant} < 0").when(When::Negative("discriminant")),
            is("{t_1=first_root} := [−{b=quadratic_b} − √{D=discriminant}; 2 · {a=quadratic_a}]").when(HAS_ROOTS),
            is("{t_2=second_root} := [−{b=quadratic_b} + √{D=discriminant}; 2 · {a=quadratic_a}]").when(HAS_ROOTS),
            is("{t_2=second_root} < 0").when(When::Negative("second_root")),
            is("t = {t_1=first_root}").when(When::All(&[MET, HAS_ROOTS, When::Not(&SECOND)])),
            is("t = {t_2=second_root}").when(When::All(&[MET, HAS_ROOTS, SECOND])),
            // The end of a cylinder
            is(concat!("t = [end_height − (O − end_base) · end_axis; ", $u, " · end_axis]")).when(END),
            // A plane
            is(concat!("{n·u=slant} := plane_normal · ", $u)).when(PLANE),
            is("{t_n=plane_t} := [plane_normal · (plane_point − O); {n·u=slant}]").when(ASLANT),
            // The plane of a triangle, and the weights of its corners there
            is("{n=triangle_normal} := (corner_b − corner_a) × (corner_c − corner_a)").when(TRIANGLE),
            is(concat!("{n·u=slant} := {n=triangle_normal} · ", $u)).when(TRIANGLE),
            is("{t_n=plane_t} := [{n=triangle_normal} · (corner_a − O); {n·u=slant}]").when(ASLANT_TRIANGLE),
            is("{t_n=plane_t} < 0").when(When::Negative("plane_t")),
            is("t = {t_n=plane_t}").when(When::All(&[MET, When::Known("plane_t")])),
            is(concat!("{Q=plane_place} := O + {t_n=plane_t} · ", $u)).when(ASLANT_TRIANGLE),
            is("{w_B=weight_b} := [({Q=plane_place} − corner_a) × (corner_c − corner_a) · {n=triangle_normal}; |{n=triangle_normal}|^2]")
                .when(ASLANT_TRIANGLE),
            is("{w_C=weight_c} := [(corner_b − corner_a) × ({Q=plane_place} − corner_a) · {n=triangle_normal}; |{n=triangle_normal}|^2]")
                .when(ASLANT_TRIANGLE),
            is("{w_A=weight_a} := 1 − {w_B=weight_b} − {w_C=weight_c}").when(ASLANT_TRIANGLE),
            is("{w_A=weight_a} < 0").when(When::All(&[MISSES, When::Negative("weight_a")])),
            is("{w_B=weight_b} < 0").when(When::All(&[MISSES, When::Negative("weight_b")])),
            is("{w_C=weight_c} < 0").when(When::All(&[MISSES, When::Negative("weight_c")])),
        ]
    };
}

pub(super) const MET_NEARER: &[Formula] = tested!("u", "t < NearestT");
pub(super) const MET_BEHIND: &[Formula] = tested!("u", "t ≥ NearestT");
pub(super) const MISSED: &[Formula] = tested!("u");
pub(super) const BLOCKS: &[Formula] = tested!("L", "t < d");
pub(super) const BEHIND_LIGHT: &[Formula] = tested!("L", "t ≥ d");
pub(super) const MISSED_ON_THE_WAY: &[Formula] = tested!("L");

/// The surface lies at the place where the ray starts.
const TOUCHES: When = When::Zero("t");
const MET: When = When::All(&[When::Finite("t"), When::Not(&TOUCHES)]);
const MISSES: When = When::Not(&When::Finite("t"));
const SPHERE: When = When::Known("sphere_radius");
const SIDE: When = When::Known("side_radius");
const ROUND: When = When::Known("quadratic_c");
/// A ray along the axis of a cylinder stays as far from it as it is.
const HAS_ROOTS: When = When::All(&[
    When::Known("discriminant"),
    When::Not(&When::Negative("discriminant")),
    When::Not(&When::Zero("quadratic_a")),
]);
/// The ray starts inside, so that the first root is behind it.
const SECOND: When = When::True("meets_second_root");
const END: When = When::Known("end_height");
const PLANE: When = When::Known("plane_normal");
const TRIANGLE: When = When::Known("corner_a");
const ASLANT: When = When::All(&[PLANE, When::Not(&When::Zero("slant"))]);
const ASLANT_TRIANGLE: When = When::All(&[TRIANGLE, When::Not(&When::Zero("slant"))]);
