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
            entry(
                "The ray leaves the scene: it takes the background colour.",
                "Sinar keluar dari adegan: mendapat warna latar belakang.",
                &[is("{I_{background}=color}")],
            ),
        ];
    Event::LightMet { light, color } => "LightMet" at "background"
        {
            "light" = light,
            "color" = color,
        }
        [
            entry(
                "The ray ends at light {light}: it takes the light's colour.",
                "Sinar berakhir di cahaya {light}: mendapat warna cahaya itu.",
                &[is("{I_{light}=color}")],
            ),
        ];
    Event::SurfaceMet { object, position, normal } => "SurfaceMet" at "surface"
        {
            "object" = object,
            "P" = position,
            "N_geometric" = normal,
        }
        [
            entry(
                "The point where the ray meets object {object}, and the normal that points out of it.",
                "Titik tempat sinar mengenai objek {object}, dan normal yang mengarah ke luar.",
                &[
                    is("{P} = {O} + {t=NearestT} · {u}"),
                    is("{N_{geometric}=N_geometric}"),
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
                "The ray comes from outside, u · N < 0: the normal faces it already. θ_i is the angle of incidence.",
                "Sinar datang dari luar, u · N < 0: normal sudah menghadapnya. θ_i adalah sudut datang.",
                &[
                    is("{N} = {N_{geometric}=N_geometric}"),
                    is("{cos_theta_i} = −({u} · {N})"),
                    is("{θ_i in °=theta_i_degrees} = arccos {cos_theta_i}"),
                    ],
            ),
            entry(
                "The ray comes from inside or from the back: the normal is turned toward it. θ_i is the angle of incidence.",
                "Sinar datang dari dalam atau dari belakang: normal dibalik ke arahnya. θ_i adalah sudut datang.",
                &[
                    is("{N} = −{N_{geometric}=N_geometric}"),
                    is("{cos_theta_i} = −({u} · {N})"),
                    is("{θ_i in °=theta_i_degrees} = arccos {cos_theta_i}"),
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
                "The texture at this place; it multiplies k_d.",
                "Tekstur di tempat ini; dikalikan dengan k_d.",
                &[is("{u=u_texture}"), is("{v=v_texture}"), is("{texture}")],
            ),
        ];
}
