//! The tree of rays of a pixel.

use super::entry::{Formula, When, entry, is, only};
use crate::algorithms::incidence::divisor;
use crate::algorithms::ray_tree::{End, Event, RayKind};
use crate::language::Message;

vocabulary! {
    [] Event {
    };
    Event::Ray { kind, level, ray } => "Ray" at "ray" number "level" scope "scope-ray"
        {
            "ray" = kind.name(),
            "level" = level,
            "O" = ray.origin,
            "u" = ray.direction,
        }
        [
            only(When::Is("ray", "reflected"), "event-ray-reflected", MIRRORED),
            only(When::Is("ray", "transmitted"), "event-ray-transmitted", REFRACTED),
            only(
                When::Is("ray", "total_internal_reflection"),
                "event-ray-total-internal-reflection",
                MIRRORED,
            ),
            entry("event-ray-primary", &[is("O = eye"), is("u = [screen_point − O; |screen_point − O|]")]),
        ];
    Event::ShadowRay { light, origin, direction, distance } => "ShadowRay" at "shadow" number "light" scope "scope-shadow-ray"
        {
            "light" = light,
            "O" = origin,
            "L" = direction,
            "d" = distance,
        }
        [
            only(
                When::Finite("d"),
                "event-shadow-ray",
                &[
                    is("L = [light_position − P; |light_position − P|]"),
                    is("d = |light_position − P|"),
                    SHADOW_OFFSET,
                    SHADOW_ORIGIN,
                    ],
            ),
            entry(
                "event-shadow-ray-infinitely-far",
                &[is("L = −light_toward"), SHADOW_OFFSET, SHADOW_ORIGIN],
            ),
        ];
    Event::Shadow { light, blocked, by } => "Shadow" at "shadow"
        {
            "light" = light,
            "blocked" = blocked,
            "blocker" = by.map(|hit| hit.object),
            "t" = by.map(|hit| hit.t),
        }
        [
            only(When::True("blocked"), "event-shadow-blocked", &[is("t = {t<}"), is("t < d")]),
            entry("event-shadow-none", &[]),
        ];
    Event::Local { emission, local } => "Local" at "local"
        {
            "emission" = emission,
            "I_local" = local,
            "I_sum" = local,
        }
        [
            entry("event-local", &[is("I_local = I + emission")]),
        ];
    Event::Refraction { eta_i, eta_r, cos_theta_i, radicand } => "Refraction" at "refraction"
        {
            "eta_i" = eta_i,
            "eta_r" = eta_r,
            "cos_theta_i" = cos_theta_i,
            "cos2_theta_r" = radicand,
            "theta_r_degrees" = Event::angles(eta_i, eta_r, radicand)[0],
            "theta_c_degrees" = Event::angles(eta_i, eta_r, radicand)[1],
        }
        [
            only(
                When::Negative("cos2_theta_r"),
                "event-refraction-total-reflection",
                &[
                    is(COSINE),
                    is("{θ_c in °=theta_c_degrees} = arcsin [eta_r; eta_i]"),
                    ],
            ),
            only(
                When::Recorded("theta_c_degrees"),
                "event-refraction-critical-angle",
                &[
                    is(COSINE),
                    is(ANGLE),
                    is("{θ_c in °=theta_c_degrees} = arcsin [eta_r; eta_i]"),
                    ],
            ),
            entry("event-refraction", &[is(COSINE), is(ANGLE)]),
        ];
    Event::Branched { branch } if branch.kind == RayKind::Transmitted => "Transmission" at "refraction"
        {
            "branch" = branch.kind.name(),
            "k_t" = branch.coefficient,
            "T" = branch.direction,
        }
        [
            entry(
                "event-transmission",
                &[
                    is(
                    "T = [eta_i; eta_r] u − (√cos2_theta_r − [eta_i; eta_r] · cos_theta_i) N",
                    ),
                    is("k_t"),
                    ],
            ),
        ];
    Event::Branched { branch } if branch.kind == RayKind::TotalInternalReflection => "TotalInternalReflection" at "total"
        {
            "branch" = branch.kind.name(),
            "k_t" = branch.coefficient,
            "R" = branch.direction,
        }
        [
            entry(
                "event-total-internal-reflection",
                &[
                    is("cos2_theta_r < 0"),
                    is("R = u − 2 (u · N) N"),
                    is("k_t"),
                    ],
            ),
        ];
    Event::Branched { branch } => "Reflection" at "reflection"
        {
            "branch" = branch.kind.name(),
            "k_r" = branch.coefficient,
            "R" = branch.direction,
        }
        [
            entry("event-reflection", &[is("R = u − 2 (u · N) N"), is("k_r")]),
        ];
    Event::Ended { kind, end } => "BranchEnded" at "refraction"
        or "reflected-too-deep" if end == End::Depth && kind == RayKind::Reflected,
        or "transmitted-too-deep" if end == End::Depth,
        or "reflection" if kind == RayKind::Reflected,
        {
            "branch" = kind.name(),
            "why" = end.name(),
        }
        [
            only(When::Is("why", "depth"), "event-branch-ended-depth", &[]),
            only(When::Is("branch", "reflected"), "event-branch-ended-reflected", &[]),
            entry("event-branch-ended-transmitted", &[]),
        ];
    Event::Attenuated { kind, distance, attenuation, carried } => "Attenuated" at "transmitted-attenuated" or "reflected-attenuated" if kind == RayKind::Reflected,
        {
            "branch" = kind.name(),
            "d" = distance,
            "a_0" = attenuation[0],
            "a_1" = attenuation[1],
            "a_2" = attenuation[2],
            "divisor" = divisor(attenuation, distance),
            "carried" = carried,
        }
        [
            entry(
                "event-attenuated",
                &[
                    is("{a=divisor} = a_0 + a_1 · d + a_2 · d^2"),
                    is("{I_{att}=carried} = [{I<}; {a=divisor}]"),
                    ],
            ),
        ];
    Event::Added { kind, carried, sum } => "BranchAdded" at "transmitted" or "reflected" if kind == RayKind::Reflected,
        {
            "branch" = kind.name(),
            "carried" = carried,
            "I_sum" = sum,
        }
        [
            only(
                When::Is("branch", "reflected"),
                "event-branch-added-reflected",
                &[
                    is("{I=I_sum} = {I_{local}=I_sum<} + k_r · {I_R=carried}"),
                    is("{I_R=carried} = {I<}").when(AS_RETURNED),
                    is("{I_R=carried} = {I_{att}=carried<}").when(When::Not(&AS_RETURNED)),
                    ],
            ),
            entry(
                "event-branch-added-transmitted",
                &[
                    is("{I=I_sum} = {I_{old}=I_sum<} + k_t · {I_T=carried}"),
                    is("{I_T=carried} = {I<}").when(AS_RETURNED),
                    is("{I_T=carried} = {I_{att}=carried<}").when(When::Not(&AS_RETURNED)),
                    ],
            ),
        ];
    Event::Returned { color } => "Returned" at "returned"
        {
            "I" = color,
        }
        [
            entry(
                "event-returned",
                &[
                    is("I = {I_sum<}").when(When::Known("{I_sum<}")),
                    is("I = {color<}").when(When::Not(&When::Known("{I_sum<}"))),
                    ],
            ),
        ];
}

const MIRRORED: &[Formula] = &[is("u = {R<}"), RAY_OFFSET, RAY_ORIGIN];
const REFRACTED: &[Formula] = &[is("u = {T<}"), RAY_OFFSET, RAY_ORIGIN];
/// A ray starts a little off the surface, so that it does not meet it where it stands.
const RAY_OFFSET: Formula = is("{ε=offset} := O − {P<}");
const RAY_ORIGIN: Formula = is("O = {P<} + {ε=offset}").noted(Message("note-offset"));
const SHADOW_OFFSET: Formula = is("{ε=offset} := O − P");
const SHADOW_ORIGIN: Formula = is("O = P + {ε=offset}").noted(Message("note-offset"));
/// The light of the ray as it came back, not attenuated.
const AS_RETURNED: When = When::Same("carried", "{I<}");
const COSINE: &str = "cos2_theta_r = 1 − ([eta_i; eta_r])^2 (1 − (cos_theta_i)^2)";
const ANGLE: &str = "{θ_r in °=theta_r_degrees} = arccos √cos2_theta_r";
