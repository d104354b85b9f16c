//! The surface that a ray meets.

use super::entry::{When, entry, is, only};
use super::texture::CHART;
use crate::algorithms::surface::Event;

vocabulary! {
    [] Event {
    };
    Event::Background { color } => "Background" at "background"
        {
            "color" = color,
        }
        [
            entry("event-background", &[is("{I_{background}=color}")]),
        ];
    Event::LightMet { light, color } => "LightMet" at "light-met"
        {
            "light" = light,
            "color" = color,
        }
        [
            entry("event-light-met", &[is("{I_{light}=color}")]),
        ];
    Event::SurfaceMet { object, position, normal } => "SurfaceMet" at "surface"
        {
            "object" = object,
            "P" = position,
            "N_geometric" = normal,
        }
        [
            entry(
                "event-surface-met",
                &[
                    is("P = O + {t=NearestT} · u"),
                    is("N_geometric = [P − sphere_center; sphere_radius]").when(When::Known("sphere_radius")),
                    is("N_geometric = plane_normal").when(When::Known("plane_normal")),
                    is("{n=triangle_normal} := (corner_b − corner_a) × (corner_c − corner_a)").when(OF_CORNERS),
                    is("N_geometric = [{n=triangle_normal}; |{n=triangle_normal}|]").when(OF_CORNERS),
                    is("N_geometric = whole_face_normal").when(When::Known("whole_face_normal")),
                    is("N_geometric = [(P − side_base) − ((P − side_base) · side_axis) side_axis; side_radius]").when(When::Known("side_axis")),
                    is("N_geometric = end_normal").when(When::Known("end_normal")),
                    ],
            ),
        ];
    Event::Faced { normal, cos_theta_i, entering } => "Faced" at "turned"
        {
            "N" = normal,
            "cos_theta_i" = cos_theta_i,
            "theta_i_degrees" = cos_theta_i.min(1.0).acos().to_degrees(),
            "entering" = entering,
        }
        [
            only(
                When::True("entering"),
                "event-faced-entering",
                &[
                    is("N = N_geometric"),
                    is("cos_theta_i = −(u · N)"),
                    is("{θ_i in °=theta_i_degrees} = arccos cos_theta_i"),
                    ],
            ),
            entry(
                "event-faced-leaving",
                &[
                    is("u · N_geometric ≥ 0"),
                    is("N = −N_geometric"),
                    is("cos_theta_i = −(u · N)"),
                    is("{θ_i in °=theta_i_degrees} = arccos cos_theta_i"),
                    ],
            ),
        ];
    Event::Textured { uv, color } => "Textured" at "surface"
        {
            "u_texture" = uv.x,
            "v_texture" = uv.y,
            "texture" = color,
        }
        [
            entry("event-surface-textured", CHART),
        ];
}

/// A triangle whose normal is its own.
const OF_CORNERS: When = When::All(&[
    When::Known("corner_a"),
    When::Not(&When::Known("whole_face_normal")),
]);
