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
                "The object’s own chart at P, and the texture’s colour there: what a ray through the pixel finds.",
                "Peta objek itu sendiri di P, dan warna tekstur di sana: yang juga ditemukan sinar melalui piksel.",
                &[is("{u=u_texture}"), is("{v=v_texture}"), is("{texture}")],
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
                "Beside it the plain way: (u, v) of the corners, carried here linearly on the screen. Where the depth changes they are wrong.",
                "Di sampingnya cara polos: (u, v) sudut, dibawa ke sini secara linear di layar. Bila kedalaman berubah, nilainya salah.",
                &[is("{u_linear}"), is("{v_linear}"), is("{texture_linear}")],
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
                "This picture is to show the mistake: the texture of the plain (u, v) is taken. It multiplies k_d alone.",
                "Gambar ini menunjukkan kesalahannya: dipakai tekstur dari (u, v) polos. Tekstur hanya mengalikan k_d.",
                &[is("{T} = {texture_linear}")],
            ),
            entry(
                "The texture at P is taken. It multiplies k_d alone.",
                "Dipakai tekstur di P. Tekstur hanya mengalikan k_d.",
                &[is("{T} = {texture}")],
            ),
        ];
    Event::TextureApplied { diffuse, textured } => "TextureApplied" at "applied"
        {
            "I_d" = diffuse,
            "I_textured" = textured,
        }
        [
            entry(
                "The diffuse part of the intensity takes the texture; ambient and highlight stay as they are.",
                "Bagian difus dari intensitas dikalikan tekstur; ambien dan sorotan tetap.",
                &[is("{I textured=I_textured} = I − {I_d} + {T} · {I_d}")],
            ),
        ];
}
