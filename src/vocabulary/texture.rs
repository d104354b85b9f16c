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
                        .when(When::All(&[When::Unrecorded("I_P_incremental"), When::Unrecorded("x_0")])),
                    is("{I textured=I_textured} = {I_a@} + Σ{*I_s} + T · I_d").when(SUMMED_AND_LIT),
                    is("{I textured=I_textured} = {I_a@} + T · I_d").when(SUMMED_AND_DARK),
                ],
            ),
        ];
}

/// Fast Phong sums up the terms of its lights, of which any may reach the pixel.
const SUMMED_AND_LIT: When = When::All(&[When::Recorded("x_0"), When::Known("{*I_s}")]);
const SUMMED_AND_DARK: When =
    When::All(&[When::Recorded("x_0"), When::Not(&When::Known("{*I_s}"))]);
