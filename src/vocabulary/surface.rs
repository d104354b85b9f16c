//! The surface that a ray meets.

use super::entry::{When, entry, is, only};
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
    Event::LightMet { light, color } => "LightMet" at "background"
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
                    is("N_geometric"),
                    ],
            ),
        ];
    Event::Faced { normal, cos_theta_i, entering } => "Faced" at "surface"
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
            entry(
                "event-surface-textured",
                &[is("{u=u_texture}"), is("{v=v_texture}"), is("texture")],
            ),
        ];
}
