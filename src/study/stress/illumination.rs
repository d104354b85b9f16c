//! The illumination model: sharp highlights, light in the surface, very long and very short ways.

use super::case::{Case, Measured, Ran, degrades, holds};
use crate::algorithms::illumination::{Event, Lighting, SurfacePoint, illuminate};
use crate::color::Rgb;
use crate::numeric::Random;
use crate::numeric::{power_of_chord, power_of_cosine};
use crate::record::Unrecorded;
use crate::scene::{Highlight, Light, Material};
use glam::DVec3;

/// The angle between N and H of the sharp highlights, and their shininess.
const ANGLE: f64 = 1e-3;
const SHARP: f64 = 1e6;

pub const CASES: &[Case] = &[
    Case {
        name: "illumination/sharp-by-cosine",
        asks: "(N·H)^n by powf of the cosine, N·H = cos 1 mrad, n = 10⁶: in f64 the whole model, in f32 its power",
        expects: "exp(n ln cos θ) = 0.60653… to the last digits",
        because: "ln cos θ = −θ²/2 − θ⁴/12 − θ⁶/45 …; a power is n times as ill-conditioned as its base, and cos θ has lost θ²/2",
        run: || {
            let (sin, cos) = (2.0 * ANGLE).sin_cos();
            let light = from(DVec3::new(sin, cos, 0.0));
            let found = lit(Highlight::Blinn, SHARP, DVec3::Y, &[light]).r;
            let single = power_of_cosine(ANGLE.cos() as f32, SHARP as f32);
            Ok(Ran::from(Measured::relative(found, sharp()))
                .and_f32(Measured::relative(single.into(), sharp()))
                .conditioned(SHARP))
        },
        recorded: degrades(4e-16, SHARP * 4e-16).f32_degrades(4e-7, SHARP * 1.2e-7),
    },
    Case {
        name: "illumination/sharp-by-chord",
        asks: "the same power as exp(n log1p(−2 sin²(θ/2)))",
        expects: "exp(n ln cos θ) = 0.60653… to the last digits",
        because: "the exponent, −1/2, is known to a few roundings, and so is its exponential",
        run: || {
            let chord = 2.0 * (0.5 * ANGLE).sin();
            let single = power_of_chord(chord as f32, SHARP as f32);
            Ok(
                Ran::from(Measured::relative(power_of_chord(chord, SHARP), sharp()))
                    .and_f32(Measured::relative(single.into(), sharp())),
            )
        },
        recorded: holds(4e-16).f32_holds(4e-7),
    },
    Case {
        name: "illumination/shininess-0",
        asks: "a highlight of n = 0, the light 60° aside",
        expects: "k_s, as anything to the power of 0 is 1",
        because: "the model itself; N·L > 0",
        run: || {
            let light = from(DVec3::new(0.75_f64.sqrt(), 0.5, 0.0));
            let found = lit(Highlight::Blinn, 0.0, DVec3::Y, &[light]).r;
            Ok(Measured::ulps(found, 1.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "illumination/shininess-1e300",
        asks: "n = 10³⁰⁰: a light in the mirror direction, and one 60° aside",
        expects: "k_s + 0: 1 to any power, and a cosine below 1 to a power without bounds",
        because: "the limit of cosⁿ",
        run: || {
            let lights = [from(DVec3::Y), from(DVec3::new(0.75_f64.sqrt(), 0.5, 0.0))];
            let found = lit(Highlight::Phong, 1e300, DVec3::Y, &lights).r;
            Ok(Measured::ulps(found, 1.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "illumination/never-above-1",
        asks: "the brightest of 2000 highlights with R exactly V, n = 10⁶",
        expects: "no more than 1, since a cosine is not",
        because: "R·V of rounded unit vectors may be 1 + 2⁻⁵², and its power 1 + 2·10⁻¹⁰",
        run: || {
            let mut random = Random(1);
            let most = (0..2000).fold(0.0_f64, |most, _| {
                let normal = random.direction();
                let to_eye = normal.cross(random.direction()).normalize() * 0.6 + normal * 0.8;
                let mirrored = 2.0 * normal.dot(to_eye) * normal - to_eye;
                let light = [from(mirrored)];
                most.max(lit_toward(Highlight::Phong, SHARP, normal, to_eye, &light).r)
            });
            Ok(Measured::absolute(most, 1.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "illumination/light-in-surface",
        asks: "a point light in the plane of the surface, N·L = 0, and a sharp highlight",
        expects: "the ambient term alone, exactly",
        because: "diffuse and specular terms need N·L > 0",
        run: || {
            let light = at(DVec3::X, Rgb::WHITE, [1.0, 0.0, 0.0]);
            let found = lit(Highlight::Blinn, 0.0, DVec3::Y, &[light]).b;
            Ok(Measured::ulps(found, AMBIENT).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "illumination/light-in-point",
        asks: "a point light in the very point that is lit, f_att = 1/d²",
        expects: "the ambient term alone, exactly: such a light has no direction",
        because: "L is 0, and so is N·L",
        run: || {
            let light = at(DVec3::ZERO, Rgb::WHITE, [0.0, 0.0, 1.0]);
            let found = lit(Highlight::Blinn, 1.0, DVec3::Y, &[light]).b;
            Ok(Measured::ulps(found, AMBIENT).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "illumination/distance-1e75",
        asks: "the diffuse term of a light of 10¹⁵⁰ from 10⁷⁵ away, f_att = 1/d²",
        expects: "1",
        because: "10¹⁵⁰ / (10⁷⁵)²; 10⁷⁵ is the largest coordinate that scenes may have",
        run: || distance(1e75),
        recorded: holds(8.0),
    },
    Case {
        name: "illumination/distance-1e-75",
        asks: "the diffuse term of a light of 10⁻¹⁵⁰ from 10⁻⁷⁵ away, f_att = 1/d²",
        expects: "1",
        because: "10⁻¹⁵⁰ / (10⁻⁷⁵)²; the squares of such lengths are still numbers",
        run: || distance(1e-75),
        recorded: holds(8.0),
    },
    Case {
        name: "illumination/two-sided",
        asks: "2000 points lit with N and with −N",
        expects: "the same bits",
        because: "N is turned toward the eye before anything else",
        run: || {
            let mut random = Random(2);
            let wrong = (0..2000).filter(|_| {
                let [normal, to_eye, toward] = [(); 3].map(|()| random.direction());
                let light = [from(toward)];
                let [one, other] = [normal, -normal]
                    .map(|normal| lit_toward(Highlight::Blinn, 20.0, normal, to_eye, &light));
                one != other
            });
            Ok(Measured::share(wrong.count(), 2000).into())
        },
        recorded: holds(0.0),
    },
];

/// k_a·A: in the blue channel.
const AMBIENT: f64 = 0.1;

/// cosⁿ of the sharp highlight, by the series of ln cos.
fn sharp() -> f64 {
    let t = ANGLE * ANGLE;
    (-SHARP * t * (0.5 + t * (1.0 / 12.0 + t / 45.0))).exp()
}

/// A light of one colour, far away toward `direction`.
fn from(direction: DVec3) -> Light {
    Light::Directional {
        toward: -direction,
        color: Rgb::WHITE,
    }
}

fn at(position: DVec3, color: Rgb, attenuation: [f64; 3]) -> Light {
    Light::Point {
        position,
        color,
        attenuation,
        radius: 0.0,
    }
}

/// At the origin, seen along the normal: the specular term in red, the diffuse one in green, ambient light in blue (with the others).
fn lit(highlight: Highlight, shininess: f64, normal: DVec3, lights: &[Light]) -> Rgb {
    lit_toward(highlight, shininess, normal, normal, lights)
}

fn lit_toward(
    highlight: Highlight,
    shininess: f64,
    normal: DVec3,
    to_eye: DVec3,
    lights: &[Light],
) -> Rgb {
    let (specular, diffuse) = (Rgb::new(1.0, 0.0, 1.0), Rgb::new(0.0, 1.0, 1.0));
    let material = Material {
        ambient: Rgb::new(0.0, 0.0, AMBIENT),
        diffuse,
        specular,
        shininess,
        highlight,
        ..Material::default()
    };
    let point = SurfacePoint {
        position: DVec3::ZERO,
        normal,
        to_eye,
        material: &material,
        diffuse,
    };
    let lighting = Lighting {
        ambient: Rgb::WHITE,
        lights,
        specular: true,
    };
    illuminate::<Event, _>(&point, &lighting, &mut Unrecorded, |_, _| true).whole
}

/// The diffuse term at a distance whose square the light's colour makes up for.
fn distance(d: f64) -> Result<Ran, String> {
    let light = at(d * DVec3::Y, Rgb::splat(d * d), [0.0, 0.0, 1.0]);
    let found = lit(Highlight::Blinn, 1.0, DVec3::Y, &[light]).g;
    Ok(Measured::ulps(found, 1.0).into())
}
