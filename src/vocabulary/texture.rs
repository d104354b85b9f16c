//! Textures on polygons.

use super::entry::{When, entry, is, only};
use crate::algorithms::texture::Event;

vocabulary! {
    [] Event {
    };
    Event::Textured { uv, color } => "Textured" at "chart"
        {
            "u_texture" = uv.x,
            "v_texture" = uv.y,
            "texture" = color,
        }
        [
            only(
                When::Recorded("x_P"),
                "event-textured",
                &[is("{u=u_texture}"), is("{v=v_texture}"), is("texture")],
            ),
        ];
    Event::TexturedLinearly { uv, color } => "TexturedLinearly" at "chart"
        {
            "u_linear" = uv.x,
            "v_linear" = uv.y,
            "texture_linear" = color,
        }
        [
            entry(
                "event-textured-linearly",
                &[is("u_linear"), is("v_linear"), is("texture_linear")],
            ),
        ];
    Event::TextureTaken { color, linear } => "TextureTaken" at "texture"
        {
            "T" = color,
            "linear" = linear,
        }
        [
            only(
                When::True("linear"),
                "event-texture-taken-linear",
                &[is("T = texture_linear")],
            ),
            entry("event-texture-taken-exact", &[is("T = texture")]),
        ];
    Event::TextureApplied { diffuse, textured } => "TextureApplied" at "applied"
        {
            "I_d" = diffuse,
            "I_textured" = textured,
        }
        [
            entry(
                "event-texture-applied",
                &[
                    is("{I textured=I_textured} = I_P_incremental − I_d + T · I_d")
                        .when(When::Recorded("I_P_incremental")),
                    is("{I textured=I_textured} = {I@} − I_d + T · I_d")
                        .when(When::Unrecorded("I_P_incremental")),
                ],
            ),
        ];
}
