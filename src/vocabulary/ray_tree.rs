//! The tree of rays of a pixel.

use super::entry::{Formula, When, entry, is, only};
use crate::algorithms::incidence::divisor;
use crate::algorithms::ray_tree::{Event, RayKind};

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
            only(When::Is("ray", "reflected"), "event-ray-reflected", RAY),
            only(When::Is("ray", "transmitted"), "event-ray-transmitted", RAY),
            only(
                When::Is("ray", "total_internal_reflection"),
                "event-ray-total-internal-reflection",
                RAY,
            ),
            entry("event-ray-primary", &[is("O"), is("u = [screen_point − O; |screen_point − O|]")]),
        ];
    Event::ShadowRay { light, direction, distance } => "ShadowRay" at "shadow" number "light" scope "scope-shadow-ray"
        {
            "light" = light,
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
                    ],
            ),
            entry("event-shadow-ray-infinitely-far", &[is("L"), is("d")]),
        ];
    Event::Shadow { light, blocked, by } => "Shadow" at "shadow"
        {
            "light" = light,
            "blocked" = blocked,
            "blocker" = by.map(|hit| hit.object),
            "t" = by.map(|hit| hit.t),
        }
        [
            only(When::True("blocked"), "event-shadow-blocked", &[is("t < d")]),
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
    Event::Branched { branch } if branch.kind == RayKind::TotalInternalReflection => "TotalInternalReflection" at "refraction"
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
    Event::Ended { kind, end } => "BranchEnded" at "refraction" or "reflection" if kind == RayKind::Reflected,
        {
            "branch" = kind.name(),
            "why" = end.name(),
        }
        [
            only(When::Is("why", "depth"), "event-branch-ended-depth", &[]),
            only(When::Is("branch", "reflected"), "event-branch-ended-reflected", &[]),
            entry("event-branch-ended-transmitted", &[]),
        ];
    Event::Attenuated { kind, distance, attenuation, carried } => "Attenuated" at "transmitted" or "reflected" if kind == RayKind::Reflected,
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
                &[is("{I=I_sum} = {I_{local}=I_sum<} + k_r · {I_R=carried}")],
            ),
            entry(
                "event-branch-added-transmitted",
                &[is("{I=I_sum} = {I_{old}=I_sum<} + k_t · {I_T=carried}")],
            ),
        ];
    Event::Returned { color } => "Returned" at "returned"
        {
            "I" = color,
        }
        [
            entry("event-returned", &[is("I")]),
        ];
}

const RAY: &[Formula] = &[is("O"), is("u")];
const COSINE: &str = "cos2_theta_r = 1 − ([eta_i; eta_r])^2 (1 − (cos_theta_i)^2)";
const ANGLE: &str = "{θ_r in °=theta_r_degrees} = arccos √cos2_theta_r";
