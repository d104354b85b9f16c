//! Form factors, by every method.

mod lines;
mod shared;

use super::entry::{When, entry, is, only};
use crate::algorithms::form_factor::Event;
use shared::*;

vocabulary! {
    [] Event {
    };
    Event::Reference { f } => "Reference" at "form-factor"
        {
            "F_exact" = f,
        }
        [
            entry("event-reference", &[is("{F_{ij}=F_exact}")]),
        ];
    Event::FormFactor { i, j, method } => "FormFactor" at "form-factor" number "j", "method" scope "scope-form-factor"
        {
            "i" = i,
            "j" = j,
            "method" = method,
        }
        [
            entry(
                "event-form-factor",
                &[is(
                    "'F_{ij}' = [1; 'A_i'] '∫∫' ['cos θ_x cos θ_y'; π 'r^2'] 'V dA_y dA_x'",
                    ).unevaluated(INTEGRAL)],
            ),
        ];
    Event::FacesAway => "FacesAway" at "pieces"
        {
        }
        [
            entry("event-faces-away", &[]),
        ];
    Event::Pieces { corners, areas } => "Pieces" at "pieces"
        {
            "corners_i" = corners[0],
            "corners_j" = corners[1],
            "area_i" = areas[0],
            "area_j" = areas[1],
        }
        [
            entry(
                "event-pieces",
                &[
                    is("{A_i=area_i} = [|Σ{fan_of_i}|; 2]").when(WHOLE_I),
                    is("{A_i=area_i} = ['|Σ (P_k − P_0) × (P_{k+1} − P_0)|'; 2]")
                        .when(When::Not(&WHOLE_I))
                        .unevaluated(PIECE),
                    is("{A_j=area_j} = [|Σ{fan_of_j}|; 2]").when(WHOLE_J),
                    is("{A_j=area_j} = ['|Σ (P_k − P_0) × (P_{k+1} − P_0)|'; 2]")
                        .when(When::Not(&WHOLE_J))
                        .unevaluated(PIECE),
                ],
            ),
        ];
    Event::Centers { i, j } => "Centers" at "centers"
        {
            "C_i" = i,
            "C_j" = j,
        }
        [
            entry(
                "event-centers",
                &[
                    is("C_i = [Σ{corners_of_i}; {n=corners_i}]").when(WHOLE_I),
                    is("C_i = ['Σ P_k'; {n=corners_i}]").when(When::Not(&WHOLE_I)).unevaluated(PIECE),
                    is("C_j = [Σ{corners_of_j}; {n=corners_j}]").when(WHOLE_J),
                    is("C_j = ['Σ P_k'; {n=corners_j}]").when(When::Not(&WHOLE_J)).unevaluated(PIECE),
                ],
            ),
        ];
    Event::Chosen { method, distance, radii, points } => "Chosen" at "contour"
        {
            "chosen" = method,
            "distance" = distance,
            "radius_i" = radii[0],
            "radius_j" = radii[1],
            "points" = points,
        }
        [
            only(When::Is("chosen", "area_to_area"), "event-chosen-area-to-area", BY_DISTANCE),
            only(
                When::Is("chosen", "element_to_polygon"),
                "event-chosen-element-to-polygon",
                BY_DISTANCE,
            ),
            entry("event-chosen-contour", BY_DISTANCE),
        ];
    Event::Points { x, y } => "Points" at "points"
        {
            "x" = x,
            "y" = y,
        }
        [
            entry("event-points", &[is("x"), is("y")]),
        ];
    Event::Pair { cos_x, cos_y, r, weights: [w_x, w_y], term, sum } => "Pair" at "pair"
        {
            "cos_theta_x" = cos_x,
            "cos_theta_y" = cos_y,
            "r" = r,
            "w_x" = w_x,
            "w_y" = w_y,
            "term" = term,
            "sum" = sum,
        }
        [
            entry(
                "event-pair",
                &[
                    is("r = |y − x|"),
                    is("cos_theta_x = max(0, [normal_at_x · (y − x); r])"),
                    is("cos_theta_y = max(0, −[normal_at_y · (y − x); r])"),
                    is("term = w_x w_y [cos_theta_x · cos_theta_y; π r^2]"),
                    is("{A_i F_{ij}=sum} = {(A_i F_{ij})_{old}=sum<0/Pieces} + term"),
                    ],
            ),
        ];
    Event::Element { element, x, weight } => "Element" at "element" number "element" scope "scope-element"
        {
            "element" = element,
            "x" = x,
            "w" = weight,
        }
        [
            entry("event-element", &[is("x"), is("w")]),
        ];
    Event::Edge { edge, from, to, angle } => "Edge" at "edge"
        {
            "edge" = edge,
            "R_k" = from,
            "R_next" = to,
            "Gamma_k" = angle,
        }
        [
            only(
                When::Recorded("Gamma_k"),
                "event-polygon-edge",
                &[
                    is("{r_k=seen_from} := R_k − x"),
                    is("{r_{k+1}=seen_to} := R_next − x"),
                    is("{|Γ_k|=Gamma_k} = [π; 180] arccos [{r_k=seen_from} · {r_{k+1}=seen_to}; |{r_k=seen_from}| · |{r_{k+1}=seen_to}|]"),
                    ],
            ),
        ];
    Event::EdgeAdded { term, sum } => "EdgeAdded" at "edge-added"
        {
            "term" = term,
            "F_x" = sum,
        }
        [
            entry(
                "event-polygon-edge-added",
                &[
                    is("{n_k=edge_normal} := (R_next − x) × (R_k − x)"),
                    is("{Γ_k=edge_vector} := [{|Γ_k|=Gamma_k}; |{n_k=edge_normal}|] {n_k=edge_normal}").when(SPANS),
                    is("term = [normal_at_x · {Γ_k=edge_vector}; 2 π]").when(SPANS),
                    is("F_x = {F_{x,old}=F_x<0} + term"),
                    ],
            ),
        ];
    Event::ElementSeen { f, sum } => "ElementSeen" at "element-seen"
        {
            "F_x" = f,
            "sum" = sum,
        }
        [
            entry(
                "event-element-seen",
                &[
                    is("F_x = max(0, {F_x<})"),
                    is("{A_i F_{ij}=sum} = {(A_i F_{ij})_{old}=sum<<0/Pieces} + w · F_x")
                        .when(When::Not(&ADAPTIVE)),
                    is("{A_i F_{ij}=sum} = '(A_i F_{ij})_{old}' + w · F_x")
                        .when(ADAPTIVE)
                        .unevaluated(PARTS),
                ],
            ),
        ];
    Event::EdgePair { edges, cosine, way, integral, sum } => "EdgePair" at "edge-pair"
        {
            "edge_i" = edges[0],
            "edge_j" = edges[1],
            "e_dot_f" = cosine,
            "way" = way,
            "I" = integral,
            "sum" = sum,
        }
        [
            only(
                When::Is("way", "at right angles"),
                "event-edge-pair-at-right-angles",
                &[
                    is("e_dot_f"),
                    is("I = 0"),
                    is("{A_i F_{ij}=sum} = {(A_i F_{ij})_{old}=sum<0/Pieces}"),
                    ],
            ),
            only(When::Is("way", "on one line"), "event-edge-pair-on-one-line", EDGES),
            entry("event-edge-pair", EDGES),
        ];
    Event::Rays { first, last } => "Rays" at "rays" number "first", "last" scope "scope-rays"
        {
            "first" = first,
            "last" = last,
        }
        [
            entry("event-rays", &[]),
        ];
    Event::RaysCast { rays, f, error } => "RaysCast" at "rays-cast"
        {
            "rays" = rays,
            "F_mean" = f,
            "s" = error,
        }
        [
            entry(
                "event-rays-cast",
                &[
                    is("{F_{ij}=F_mean} = [{hits<}; {n=rays}]"),
                    is("s = √[{F_{ij}=F_mean} (1 − {F_{ij}=F_mean}); {n=rays}]"),
                ],
            ),
        ];
    Event::Ray { x, direction, met, hits } => "Ray" at "ray"
        {
            "x" = x,
            "direction" = direction,
            "met" = met,
            "hits" = hits,
        }
        [
            only(When::True("met"), "event-ray-met", RAY),
            only(When::Recorded("hits"), "event-ray-missed", RAY),
        ];
    Event::Hemicube { hemicube, x, resolution } => "Hemicube" at "hemicube" number "hemicube" scope "scope-hemicube"
        {
            "hemicube" = hemicube,
            "x" = x,
            "resolution" = resolution,
        }
        [
            entry("event-hemicube", &[is("x")]),
        ];
    Event::Pixel { face, x, y, delta, sum } => "Pixel" at "pixel"
        {
            "face" = face,
            "pixel_x" = x,
            "pixel_y" = y,
            "delta_F" = delta,
            "F_x" = sum,
        }
        [
            only(
                When::NotPositive("face"),
                "event-hemicube-pixel-top",
                &[
                    is(ACROSS),
                    is(ALONG),
                    is(AREA),
                    is("delta_F = [{ΔA=pixel_area}; π ({u=u_pixel}^2 + {v=v_pixel}^2 + 1)^2]"),
                    is(SUM_OF_PIXELS),
                    ],
            ),
            only(
                When::Recorded("delta_F"),
                "event-hemicube-pixel-side",
                &[
                    is(ACROSS),
                    is(ALONG),
                    is(AREA),
                    is("delta_F = [{v=v_pixel} · {ΔA=pixel_area}; π ({u=u_pixel}^2 + {v=v_pixel}^2 + 1)^2]"),
                    is(SUM_OF_PIXELS),
                    ],
            ),
        ];
    Event::HemicubeSeen { f, mean } => "HemicubeSeen" at "hemicube-seen"
        {
            "F_x" = f,
            "F_mean" = mean,
        }
        [
            entry(
                "event-hemicube-seen",
                &[
                    is("F_x = {Σ ΔF=F_x<0}"),
                    is("{F_{ij}=F_mean} = {F_{ij,old}=F_mean<<0} + [F_x; hemicube_points]"),
                    ],
            ),
        ];
    Event::Sights { first, last } => "Sights" at "sights" number "first", "last" scope "scope-sights"
        {
            "first" = first,
            "last" = last,
        }
        [
            entry("event-sights", &[]),
        ];
    Event::SightsTaken { rays, share, error } => "SightsTaken" at "sights-taken"
        {
            "rays" = rays,
            "share" = share,
            "s" = error,
        }
        [
            entry(
                "event-sights-taken",
                &[
                    is("{V_{ij}=share}"),
                    is("s = [√'Σ (v_k − V_{ij} w_k)^2'; 'Σ w_k']")
                        .unevaluated("what single points would exchange is not recorded"),
                ],
            ),
        ];
    Event::Sight { x, y, blocked, share } => "Sight" at "sight"
        {
            "x" = x,
            "y" = y,
            "blocked" = blocked,
            "share" = share,
        }
        [
            only(When::True("blocked"), "event-sight-blocked", SIGHT),
            entry("event-sight-free", SIGHT),
        ];
    Event::Seen { x, whole, visible } => "Seen" at "seen"
        {
            "x" = x,
            "F_x" = whole,
            "F_visible" = visible,
        }
        [
            only(When::NotPositive("F_visible"), "event-seen-nothing", SEEN_FROM),
            entry("event-seen", SEEN_FROM),
        ];
    Event::Visible { rays, share } => "Visible" at "visible"
        {
            "rays" = rays,
            "share" = share,
        }
        [
            entry("event-visible", &[is("{V_{ij}=share}")]),
        ];
    Event::FormFactorFound { exchange, f } => "FormFactorFound" at "found"
        {
            "A_i_F_ij" = exchange,
            "F_ij" = f,
        }
        [
            only(
                When::Is("method", "monte-carlo"),
                "event-form-factor-found-monte-carlo",
                &[is("F_ij = {F_mean<}"), is("A_i_F_ij = area_of_i · F_ij")],
            ),
            only(
                When::Is("method", "hemicube"),
                "event-form-factor-found-hemicube",
                &[is("F_ij = {F_mean<}"), is("A_i_F_ij = area_of_i · F_ij")],
            ),
            entry(
                "event-form-factor-found",
                &[
                    is("A_i_F_ij = {V_{ij}=share} Σ{A_i F_{ij}=sum/Pieces}")
                        .when(When::All(&[SUMMED, When::Recorded("share")])),
                    is("A_i_F_ij = Σ{A_i F_{ij}=sum/Pieces}")
                        .when(When::All(&[SUMMED, When::Unrecorded("share")])),
                    is("A_i_F_ij = {V_{ij}=share} 'Σ A_i F_{ij}'")
                        .when(When::All(&[ADAPTIVE, When::Recorded("share")]))
                        .unevaluated(PARTS),
                    is("A_i_F_ij = 'Σ A_i F_{ij}'")
                        .when(When::All(&[ADAPTIVE, When::Unrecorded("share")]))
                        .unevaluated(PARTS),
                    is("A_i_F_ij = 0").when(When::All(&[UNSUMMED, When::Zero("A_i_F_ij")])),
                    is("F_ij = [A_i_F_ij; area_of_i]"),
                    ],
            ),
        ];
}
