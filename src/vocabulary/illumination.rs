//! The illumination model at one point.

use super::entry::{When, entry, is, only};
use crate::algorithms::illumination::Event;
use crate::language::Message;

vocabulary! {
    [] Event {
    };
    Event::Illumination { position, normal } => "Illumination" at "head" scope "scope-illumination"
        {
            "P" = position,
            "N" = normal,
        }
        [
            entry(
                "event-illumination",
                &[
                    is("P = P_v").when(When::Recorded("P_v")),
                    is("P = P_m").when(When::Recorded("P_m")),
                    is("P = {P<}").when(When::Known("{P<}")),
                    is("P = eye + [z_0; focal] (middle_point − eye)").when(When::Recorded("N_0")),
                    is("N = [N_0; |N_0|]").when(When::Recorded("N_0")),
                    is("N = N_v").when(AT_VERTEX),
                    is("N = −N_v").when(AT_VERTEX_TURNED),
                    is("N = {N<}").when(AT_PIXEL),
                    is("N = −{N<}").when(AT_PIXEL_TURNED),
                    is("N = face_normal").when(OF_FACE),
                    is("N = −face_normal").when(OF_FACE_TURNED),
                    ],
            ),
        ];
    Event::Viewer { to_eye, turned } => "Viewer" at "viewer"
        {
            "V" = to_eye,
            "turned" = turned,
        }
        [
            only(When::Recorded("u"), "event-viewer-along-ray", &[is("V = −u")]),
            only(
                When::True("turned"),
                "event-viewer-turned",
                &[is("V = [eye − P; |eye − P|]"), is("N · V ≥ 0")],
            ),
            entry("event-viewer", &[is("V = [eye − P; |eye − P|]")]),
        ];
    Event::Ambient { k_a, term } => "Ambient" at "ambient"
        {
            "k_a" = k_a,
            "I_a" = term,
        }
        [
            entry("event-ambient", &[is("I_a = k_a · A")]),
        ];
    Event::Light { light, color, distance, attenuation, slide_factor } => "Light" at "light" number "light" scope "scope-light"
        {
            "light" = light,
            "I_light" = color,
            "d" = distance,
            "f_att" = attenuation,
            "slide_factor" = slide_factor,
        }
        [
            only(
                When::Finite("d"),
                "event-light",
                &[
                    is("light_position"),
                    is("d = |light_position − P|"),
                    is("f_att = [1; light_a_0 + light_a_1 · d + light_a_2 · d^2]"),
                    is("I_light"),
                    ],
            ),
            entry(
                "event-light-infinitely-far",
                &[is("f_att = 1"), is("I_light")],
            ),
        ];
    Event::ToLight { to_light, n_dot_l } => "ToLight" at "to-light"
        {
            "L" = to_light,
            "N_dot_L" = n_dot_l,
        }
        [
            entry(
                "event-to-light",
                &[
                    is("L = [light_position − P; |light_position − P|]").when(AT_DISTANCE),
                    is("L = −light_toward").when(When::Known("light_toward")),
                    is("N_dot_L = N · L"),
                    ],
            ),
        ];
    Event::Diffuse { k_d, term } => "Diffuse" at "diffuse"
        {
            "k_d" = k_d,
            "I_d" = term,
        }
        [
            entry(
                "event-diffuse",
                &[
                    is("k_d = {k_{d,material}=material_k_d} · {texture^}").when(When::All(&[TEXTURED, BY_RAY])),
                    is("k_d = {k_{d,material}=material_k_d} · {T^}").when(When::All(&[TEXTURED, When::Not(&BY_RAY)])),
                    is("I_d = k_d · I_light · f_att · max(0, N_dot_L)"),
                    is("slide_factor = [d · {cos φ=N_dot_L}; √d]").when(When::Finite("d")).noted(ON_THE_SLIDE),
                    ],
            ),
        ];
    Event::Mirrored { mirrored, r_dot_v, shininess } => "Mirrored" at "highlight"
        {
            "R" = mirrored,
            "R_dot_V" = r_dot_v,
            "n_s" = shininess,
        }
        [
            entry(
                "event-mirrored",
                &[
                    is("R = 2 (N_dot_L) N − L"),
                    is("R_dot_V = R · V"),
                    ],
            ),
        ];
    Event::Halfway { halfway, n_dot_h, shininess } => "Halfway" at "highlight"
        {
            "H" = halfway,
            "N_dot_H" = n_dot_h,
            "n_s" = shininess,
        }
        [
            entry(
                "event-halfway",
                &[
                    is("H = [L + V; |L + V|]"),
                    is("N_dot_H = N · H"),
                    ],
            ),
        ];
    Event::Specular { k_s, term } => "Specular" at "specular"
        {
            "k_s" = k_s,
            "I_s" = term,
        }
        [
            only(When::NotPositive("N_dot_L"), "event-specular-none", &[is("I_s = 0 · k_s")]),
            only(
                When::Recorded("R_dot_V"),
                "event-specular",
                &[is(
                    "I_s = k_s · I_light · f_att · max(0, R_dot_V)^{n=n_s}",
                    )],
            ),
            entry(
                "event-specular",
                &[is(
                    "I_s = k_s · I_light · f_att · max(0, N_dot_H)^{n=n_s}",
                    )],
            ),
        ];
    Event::LightAdded { term } => "LightAdded" at "light-added"
        {
            "I_added" = term,
        }
        [
            only(
                When::Unrecorded("I_d"),
                "event-light-added-blocked",
                &[is("I_added = 0 · I_light")],
            ),
            only(
                When::Unrecorded("I_s"),
                "event-light-added-matte",
                &[is("I_added = I_d")],
            ),
            only(
                When::Recorded("I_s"),
                "event-light-added",
                &[is("I_added = I_d + I_s")],
            ),
        ];
    Event::Illuminated { intensity } => "Illuminated" at "return"
        {
            "I" = intensity,
        }
        [
            only(
                When::Recorded("I_a"),
                "event-illuminated",
                &[
                    is("I = I_a + Σ{+I_added}").when(HAS_LIGHT),
                    is("I = I_a").when(When::Not(&HAS_LIGHT)),
                    ],
            ),
        ];
}

/// The scene has a light.
const HAS_LIGHT: When = When::Known("{+I_added}");
/// A texture has changed the material's k_d.
const TEXTURED: When = When::Not(&When::Same("k_d", "material_k_d"));
const BY_RAY: When = When::Recorded("u");
const AT_VERTEX: When = When::Same("N", "N_v");
const AT_VERTEX_TURNED: When = When::All(&[When::Recorded("N_v"), When::Not(&AT_VERTEX)]);
const AT_PIXEL: When = When::Same("N", "{N<}");
const AT_PIXEL_TURNED: When = When::All(&[When::Known("{N<}"), When::Not(&AT_PIXEL)]);
const OF_FACE: When = When::All(&[When::Recorded("P_m"), When::Same("N", "face_normal")]);
const OF_FACE_TURNED: When = When::All(&[When::Recorded("P_m"), When::Not(&OF_FACE)]);
/// The light does not stand at the very point.
const AT_DISTANCE: When = When::All(&[
    When::Known("light_position"),
    When::Not(&When::NotPositive("d")),
]);

/// The slide's factor in place of attenuation and cosine.
const ON_THE_SLIDE: Message = Message("note-as-on-the-slide");
