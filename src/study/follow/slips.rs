//! What classic mistakes make of the values of a step: each a formula that a program with the mistake computes in place of the right one.

use super::{OtherValue, TraceValue};
use crate::methods::Mistake;
use crate::panels::{Slip, slipped};
use crate::record::Value;
use crate::replay::Run;
use crate::scene::primitives::Ray;
use crate::vocabulary::When;

/// A mistake, the kind of step where it shows, and the formula that errs, behind those that define names for it.
type OfKind = (Mistake, &'static str, Slip);

const fn slip(mistake: Mistake, kind: &'static str, formulas: &'static [&'static str]) -> OfKind {
    only(When::Always, mistake, kind, formulas)
}

const fn only(
    when: When,
    mistake: Mistake,
    kind: &'static str,
    formulas: &'static [&'static str],
) -> OfKind {
    (mistake, kind, Slip { when, formulas })
}

const ENTERING: When = When::True("entering");
const LEAVING: When = When::Not(&ENTERING);
const PRIMARY: When = When::Is("ray", "primary");

#[rustfmt::skip]
const SLIPS: &[OfKind] = &[
    // The ray through the pixel
    slip(Mistake::HalfPixelOff, "Through", &["x_P = x"]),
    slip(Mistake::HalfPixelOff, "Through", &["y_P = y"]),
    slip(Mistake::FlipY, "Through", &["y_P = height − y_P"]),
    slip(Mistake::MirrorX, "Through", &["x_P = width − x_P"]),
    only(PRIMARY, Mistake::HalfPixelOff, "Ray", &["{c=corner_point} := screen_point − eye − 0.5 right + 0.5 up", "u = [{c=corner_point}; |{c=corner_point}|]"]),
    only(PRIMARY, Mistake::FlipY, "Ray", &["{v=upward} := u · up", "u = u − 2 {v=upward} up"]),
    only(PRIMARY, Mistake::MirrorX, "Ray", &["{v=aside} := u · right", "u = u − 2 {v=aside} right"]),
    // The normal
    slip(Mistake::NormalNotFlipped, "Faced", &["N = N_geometric"]),
    slip(Mistake::NormalNotFlipped, "Faced", &["cos_theta_i = −cos_theta_i"]),
    slip(Mistake::NormalNotFlipped, "Illumination", &["N = N_geometric"]),
    slip(Mistake::NormalNotFlipped, "Illumination", &["N = N_v"]),
    slip(Mistake::NormalNotFlipped, "Illumination", &["N = face_normal"]),
    slip(Mistake::NormalNotFlipped, "ToLight", &["N_dot_L = N_geometric · L"]),
    slip(Mistake::NormalNotNormalized, "SurfaceMet", &["N_geometric = P − sphere_center"]),
    slip(Mistake::NormalNotNormalized, "SurfaceMet", &["N_geometric = (corner_b − corner_a) × (corner_c − corner_a)"]),
    slip(Mistake::NormalNotNormalized, "SurfaceMet", &["N_geometric = side_radius N_geometric"]),
    slip(Mistake::NormalNotNormalized, "Faced", &["N = |P − sphere_center| N"]),
    slip(Mistake::NormalNotNormalized, "Faced", &["N = |(corner_b − corner_a) × (corner_c − corner_a)| N"]),
    slip(Mistake::NormalNotNormalized, "VertexNormal", &["N_v = sum_N"]),
    slip(Mistake::NormalNotNormalized, "PixelNormal", &["N = N_P_incremental"]),
    // The illumination model
    slip(Mistake::LightToPoint, "ToLight", &["L = −L"]),
    slip(Mistake::LightToPoint, "ToLight", &["N_dot_L = −N_dot_L"]),
    slip(Mistake::LightToPoint, "ShadowRay", &["L = −L"]),
    slip(Mistake::LightToPoint, "Diffuse", &["I_d = k_d · I_light · f_att · max(0, −N_dot_L)"]),
    slip(Mistake::LightNotNormalized, "ToLight", &["L = d L"]),
    slip(Mistake::LightNotNormalized, "ToLight", &["N_dot_L = d N_dot_L"]),
    slip(Mistake::LightNotNormalized, "ShadowRay", &["L = d L"]),
    slip(Mistake::LightNotNormalized, "Diffuse", &["I_d = k_d · I_light · f_att · d · max(0, N_dot_L)"]),
    slip(Mistake::CosNotClamped, "Diffuse", &["I_d = k_d · I_light · f_att · N_dot_L"]),
    slip(Mistake::SpecularWithoutNdotl, "Specular", &["I_s = k_s · I_light · f_att · max(0, R_dot_V)^{n=n_s}"]),
    slip(Mistake::SpecularWithoutNdotl, "Specular", &["I_s = k_s · I_light · f_att · max(0, N_dot_H)^{n=n_s}"]),
    slip(Mistake::ReflectSign, "Mirrored", &["R = −L − 2 (N_dot_L) N"]),
    slip(Mistake::ReflectSign, "Mirrored", &["R = L + 2 (N_dot_L) N"]),
    slip(Mistake::ReflectSign, "Mirrored", &["R = −R"]),
    slip(Mistake::ReflectSign, "Mirrored", &["R_dot_V = −R_dot_V"]),
    // Reflection and refraction
    slip(Mistake::ReflectSign, "Reflection", &["R = u + 2 (u · N) N"]),
    slip(Mistake::ReflectSign, "TotalInternalReflection", &["R = u + 2 (u · N) N"]),
    only(ENTERING, Mistake::EtaInverted, "Refraction", &["eta_i = eta_r"]),
    only(ENTERING, Mistake::EtaInverted, "Refraction", &["eta_r = eta_i"]),
    only(ENTERING, Mistake::EtaInverted, "Refraction", &[INVERTED]),
    only(ENTERING, Mistake::EtaInverted, "Transmission", &[ROOT, BENT_WRONGLY]),
    only(LEAVING, Mistake::EtaNotSwappedOnLeaving, "Refraction", &["eta_i = eta_r"]),
    only(LEAVING, Mistake::EtaNotSwappedOnLeaving, "Refraction", &["eta_r = eta_i"]),
    only(LEAVING, Mistake::EtaNotSwappedOnLeaving, "Refraction", &[INVERTED]),
    only(LEAVING, Mistake::EtaNotSwappedOnLeaving, "Transmission", &[ROOT, BENT_WRONGLY]),
    // Scan conversion
    slip(Mistake::InclusiveScanRule, "Span", &["first = ⌊x_4⌋"]),
    slip(Mistake::InclusiveScanRule, "Span", &["end = ⌈x_5⌉ + 1"]),
    // Radiosity
    slip(Mistake::FormFactorTransposed, "Exchanged", &["F_ij = F_ij · area_of_i / area_of_j"]),
    slip(Mistake::FormFactorTransposed, "Exchanged", &["product = F_ij · B_j · area_of_i / area_of_j"]),
    slip(Mistake::FormFactorTransposed, "Received", &["F_ji = matrix_F_ij"]),
    slip(Mistake::FormFactorTransposed, "Received", &["DeltaB = rho_j · matrix_F_ij · shot"]),
    slip(Mistake::PiTwice, "Exchanged", &["F_ij = F_ij / 3.141592653589793"]),
    slip(Mistake::PiTwice, "Exchanged", &["product = product / 3.141592653589793"]),
    slip(Mistake::PiTwice, "Received", &["F_ji = F_ji / 3.141592653589793"]),
    slip(Mistake::PiTwice, "Received", &["DeltaB = DeltaB / 3.141592653589793"]),
    slip(Mistake::ReflectanceForgotten, "Gathering", &["rho_i = 1"]),
    slip(Mistake::ReflectanceForgotten, "Gathered", &["B_i = E_i + {sum<}"]),
    slip(Mistake::ReflectanceForgotten, "Received", &["rho_j = 1"]),
    slip(Mistake::ReflectanceForgotten, "Received", &["DeltaB = F_ji · shot"]),
];

/// The cosine with η the wrong way round.
const INVERTED: &str = "cos2_theta_r = 1 − ([eta_r; eta_i])^2 (1 − (cos_theta_i)^2)";
const ROOT: &str = "{w=wrong_radicand} := 1 − ([eta_r; eta_i])^2 (1 − (cos_theta_i)^2)";
const BENT_WRONGLY: &str =
    "T = [eta_r; eta_i] u − (√{w=wrong_radicand} − [eta_r; eta_i] · cos_theta_i) N";

/// The mistakes that would give their value of the step.
pub fn slips(run: &Run, other: &OtherValue, tolerance: f64) -> Vec<Mistake> {
    let of_kind = SLIPS.iter().filter(|(_, kind, _)| *kind == other.kind);
    let gives = |(mistake, _, slip): &OfKind| {
        let (name, value) = slipped(run, other.step, slip)?;
        let value = TraceValue::from(value);
        (name == other.field && other.theirs.agrees(&value, tolerance)).then_some(*mistake)
    };
    let mut found: Vec<Mistake> = of_kind.filter_map(gives).collect();
    found.extend(of_shadow(run, other));
    found.dedup();
    found
}

/// A light that is hidden in their program and not in ours: by what lies behind it, or else by the surface itself.
fn of_shadow(run: &Run, other: &OtherValue) -> Option<Mistake> {
    let hidden =
        (&other.theirs, &other.ours) == (&TraceValue::Truth(true), &Some(TraceValue::Truth(false)));
    if !hidden || other.kind != "Shadow" || other.field != "blocked" {
        return None;
    }
    let fields = run.walk().fields(other.step);
    let vector = |name| match fields.get(name) {
        Some(Value::Vector(vector)) => Some(vector),
        _ => None,
    };
    let (origin, direction) = (vector("O")?, vector("L")?);
    let beyond = run
        .prepared()
        .primitives()
        .blocked(&Ray { origin, direction }, f64::INFINITY);
    Some(match beyond {
        true => Mistake::ShadowIgnoresLightDistance,
        false => Mistake::NoShadowOffset,
    })
}
