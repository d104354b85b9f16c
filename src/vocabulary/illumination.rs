//! The illumination model at one point.

use super::entry::{Formula, When, entry, is, only};
use crate::algorithms::illumination::Event;

vocabulary! {
    [] Event {
    };
    Event::Illumination { position, normal } => "Illumination" at "head" scope ("illumination", "pencahayaan")
        {
            "P" = position,
            "N" = normal,
        }
        [
            entry(
                "The illumination model at the point P with the unit normal N.",
                "Model pencahayaan di titik P dengan normal satuan N.",
                &[is("{P}"), is("{N}")],
            ),
        ];
    Event::Viewer { to_eye, turned } => "Viewer" at "viewer"
        {
            "V" = to_eye,
            "turned" = turned,
        }
        [
            only(
                When::Recorded("u"),
                "The way back along the ray stands for the direction to the eye.",
                "Arah balik sepanjang sinar menggantikan arah ke mata.",
                &[is("{V} = −{u}")],
            ),
            only(
                When::True("turned"),
                "The eye sees the other side: N was turned toward it.",
                "Mata melihat sisi sebaliknya: N dibalik ke arahnya.",
                &[is("{V} = [eye − P; |eye − P|]"), is("{N}")],
            ),
            entry(
                "The unit vector from the point to the eye; N is on its side already.",
                "Vektor satuan dari titik ke mata; N sudah di sisi yang sama.",
                &[is("{V} = [eye − P; |eye − P|]")],
            ),
        ];
    Event::Ambient { k_a, term } => "Ambient" at "ambient"
        {
            "k_a" = k_a,
            "I_a" = term,
        }
        [
            entry(
                "The ambient term: light from all around.",
                "Suku ambien: cahaya dari segala arah.",
                &[is("{I_a} = {k_a} · {A}")],
            ),
        ];
    Event::Light { light, color, distance, attenuation, slide_factor } => "Light" at "light" number "light" scope ("light", "cahaya")
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
                "Light {light} at the distance d, weakened by the attenuation f_{att}.",
                "Cahaya {light} pada jarak d, dilemahkan oleh atenuasi f_{att}.",
                &[
                    is("{d} = |light − P|"),
                    is("{f_{att}=f_att} = [1; a_0 + a_1·d + a_2·d^2]"),
                    is("{I_{light}=I_light}"),
                    ],
            ),
            entry(
                "Light {light} is infinitely far: nothing weakens it.",
                "Cahaya {light} jauh tak berhingga: tidak ada pelemahan.",
                &[is("{f_{att}=f_att}"), is("{I_{light}=I_light}")],
            ),
        ];
    Event::ToLight { to_light, n_dot_l } => "ToLight" at "to-light"
        {
            "L" = to_light,
            "N_dot_L" = n_dot_l,
        }
        [
            entry(
                "The unit vector to the light, and its cosine with the normal.",
                "Vektor satuan ke cahaya, dan kosinusnya dengan normal.",
                &[is("{L}"), is("{N_dot_L} = {N} · {L}")],
            ),
        ];
    Event::Diffuse { k_d, term } => "Diffuse" at "diffuse"
        {
            "k_d" = k_d,
            "I_d" = term,
        }
        [
            entry(
                "The diffuse term: proportional to the cosine between normal and light.",
                "Suku difus: sebanding dengan kosinus antara normal dan cahaya.",
                &[
                    is("{I_d} = {k_d} · {I_{light}=I_light} · {f_{att}=f_att} · max(0, {N_dot_L})"),
                    Formula {
                    template: "{slide factor=slide_factor} = [{d} · {cos φ=N_dot_L}; √{d}]",
                    when: When::Finite("d"),
                    note: Some(ON_THE_SLIDE),
                    },
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
                "The light's direction mirrored at the normal, and its cosine with the direction of the eye (Phong).",
                "Arah cahaya dicerminkan pada normal, dan kosinusnya dengan arah mata (Phong).",
                &[
                    is("{R} = 2 ({N_dot_L}) {N} − {L}"),
                    is("{R_dot_V} = {R} · {V}"),
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
                "Half-way between light and eye, and its cosine with the normal (Blinn).",
                "Tengah antara cahaya dan mata, dan kosinusnya dengan normal (Blinn).",
                &[
                    is("{H} = [{L} + {V}; |{L} + {V}|]"),
                    is("{N_dot_H} = {N} · {H}"),
                    ],
            ),
        ];
    Event::Specular { k_s, term } => "Specular" at "specular"
        {
            "k_s" = k_s,
            "I_s" = term,
        }
        [
            only(
                When::NotPositive("N_dot_L"),
                "No highlight: the light is behind the surface, N·L ≤ 0.",
                "Tanpa sorotan: cahaya di balik permukaan, N·L ≤ 0.",
                &[is("{I_s}")],
            ),
            only(
                When::Recorded("R_dot_V"),
                "The specular term: the highlight, narrower the larger n is.",
                "Suku spekular: sorotan, makin sempit bila n makin besar.",
                &[is(
                    "{I_s} = {k_s} · {I_{light}=I_light} · {f_{att}=f_att} · max(0, {R_dot_V})^{n=n_s}",
                    )],
            ),
            entry(
                "The specular term: the highlight, narrower the larger n is.",
                "Suku spekular: sorotan, makin sempit bila n makin besar.",
                &[is(
                    "{I_s} = {k_s} · {I_{light}=I_light} · {f_{att}=f_att} · max(0, {N_dot_H})^{n=n_s}",
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
                "The light is blocked: it adds nothing.",
                "Cahaya terhalang: tidak menambah apa pun.",
                &[is("{I_d + I_s=I_added}")],
            ),
            only(
                When::Unrecorded("I_s"),
                "What light {light} adds; no surface of this scene has a highlight.",
                "Yang ditambahkan cahaya {light}; tidak ada permukaan dengan sorotan di adegan ini.",
                &[is("{I_d + I_s=I_added} = {I_d}")],
            ),
            only(
                When::Recorded("I_s"),
                "What light {light} adds to the intensity.",
                "Yang ditambahkan cahaya {light} pada intensitas.",
                &[is("{I_d + I_s=I_added} = {I_d} + {I_s}")],
            ),
        ];
    Event::Illuminated { intensity } => "Illuminated" at "return"
        {
            "I" = intensity,
        }
        [
            only(
                When::Recorded("I_a"),
                "The intensity of the point: the ambient term and what each light adds.",
                "Intensitas titik: suku ambien dan yang ditambahkan tiap cahaya.",
                &[is("{I} = {I_a} + {Σ(I_d + I_s)=+I_added}")],
            ),
        ];
}

/// The slide's factor in place of attenuation and cosine.
const ON_THE_SLIDE: super::Sentence = super::entry::says(
    "As on the slide, in place of f_{att} · (N·L); it grows with the distance:",
    "Seperti pada slide, sebagai ganti f_{att} · (N·L); nilainya membesar dengan jarak:",
);
