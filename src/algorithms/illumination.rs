//! The illumination model: the intensity of light that one point of a surface sends to the eye.
//!
//! I = k_a·A + Σ_lights f_att(d)·I_light·(k_d·max(0, N·L) + k_s·s), where s is max(0, R·V)^n (Phong 1975) or
//! max(0, N·H)^n with H = (L+V)/|L+V| (Blinn 1977), 0 where N·L ≤ 0; f_att(d) = 1/(a0 + a1·d + a2·d²)
//! (Foley, van Dam, Feiner, Hughes 1990, §16.1). N, L, V, R, H are unit vectors away from the surface, in world coordinates.
//!
//! The lecture's slide multiplies by (dist·cos φ)/√dist instead of f_att(d)·N·L. Read literally, that grows with the
//! distance; it is recorded for every light as `slide_factor`, for comparison only.

use super::incidence::{Incidence, slide_factor};
use super::intensity::Intensity;
use crate::color::Rgb;
use crate::numeric::{Linear, power_of_cosine};
use crate::record::{Listing, Recorder};
use crate::scene::{Highlight, Light, Material, Scene};
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "illumination",
    lines: &[
        ("head", "illumination(P, N)"),
        ("viewer", "  V ← {toward-the-eye};  {turn-n-toward-v}"),
        ("ambient", "  I ← I_a = k_a · A"),
        ("light", "  {for-each-light}"),
        (
            "to-light",
            "    L ← {toward-the-light};  f_att ← 1/(a0 + a1·d + a2·d²)",
        ),
        ("diffuse", "    I_d = k_d · I_light · f_att · max(0, N·L)"),
        ("highlight", "    R ← 2(N·L)N − L   {or}   H ← (L+V)/|L+V|"),
        (
            "specular",
            "    I_s = k_s · I_light · f_att · max(0, R·V)^n   {or}   (N·H)^n",
        ),
        ("light-added", "    I ← I + I_d + I_s"),
        ("return", "  {return} I"),
    ],
};

/// A point to be lit.
#[derive(Clone, Copy, Debug)]
pub struct SurfacePoint<'a> {
    pub position: DVec3,
    /// Unit, on either side: it is turned toward the eye.
    pub normal: DVec3,
    /// V, unit.
    pub to_eye: DVec3,
    pub material: &'a Material,
    /// k_d with the texture already applied.
    pub diffuse: Rgb,
}

impl<'a> SurfacePoint<'a> {
    /// A point without a texture.
    pub fn seen_from(eye: DVec3, position: DVec3, normal: DVec3, material: &'a Material) -> Self {
        SurfacePoint {
            position,
            normal,
            to_eye: (eye - position).normalize_or_zero(),
            material,
            diffuse: material.diffuse,
        }
    }
}

/// The light of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Lighting<'a> {
    /// A, the ambient light.
    pub ambient: Rgb,
    pub lights: &'a [Light],
    /// Whether any surface has a highlight. Without one, no cosine is raised to a power.
    pub specular: bool,
}

impl<'a> Lighting<'a> {
    pub fn of(scene: &'a Scene, specular: bool) -> Self {
        Lighting {
            ambient: scene.ambient,
            lights: &scene.lights,
            specular,
        }
    }
}

/// Intensity at `point`, unclamped. `arrives` says whether the light of a source reaches the point, and is called only where
/// N·L > 0.
pub fn illuminate<E: From<Event>, R: Recorder<E>>(
    point: &SurfacePoint,
    lighting: &Lighting,
    recorder: &mut R,
    mut arrives: impl FnMut(&Incidence, &mut R) -> bool,
) -> Intensity {
    let to_eye = point.to_eye;
    let turned = point.normal.dot(to_eye) < 0.0;
    let normal = if turned { -point.normal } else { point.normal };
    recorder.enter(|| {
        Event::Illumination {
            position: point.position,
            normal,
        }
        .into()
    });
    recorder.step(|| Event::Viewer { to_eye, turned }.into());

    let ambient = point.material.ambient * lighting.ambient;
    recorder.step(|| {
        Event::Ambient {
            k_a: point.material.ambient,
            term: ambient,
        }
        .into()
    });

    let mut intensity = Intensity {
        whole: ambient,
        diffuse: Rgb::BLACK,
    };
    for (light, source) in lighting.lights.iter().enumerate() {
        let incidence = Incidence::of(light, source, point.position);
        let added = illuminate_by(
            &incidence,
            lighting.specular,
            point,
            normal,
            recorder,
            &mut arrives,
        );
        intensity = intensity.plus(added);
    }
    recorder.leave(|| {
        Event::Illuminated {
            intensity: intensity.whole,
        }
        .into()
    });
    intensity
}

/// The diffuse and the specular term of one light at `point`, whose unit `normal` is on the side of the eye.
fn illuminate_by<E: From<Event>, R: Recorder<E>>(
    incidence: &Incidence,
    with_highlights: bool,
    point: &SurfacePoint,
    normal: DVec3,
    recorder: &mut R,
    arrives: &mut impl FnMut(&Incidence, &mut R) -> bool,
) -> Intensity {
    let to_eye = point.to_eye;
    let &Incidence {
        to_light,
        attenuation,
        color,
        ..
    } = incidence;
    let n_dot_l = normal.dot(to_light);
    recorder.enter(|| Event::light(incidence, n_dot_l).into());
    recorder.step(|| Event::ToLight { to_light, n_dot_l }.into());
    if n_dot_l > 0.0 && !arrives(incidence, recorder) {
        recorder.leave(|| Event::LightAdded { term: Rgb::BLACK }.into());
        return Intensity::default();
    }

    let k_d = point.diffuse;
    let diffuse = if n_dot_l > 0.0 {
        k_d * color * (attenuation * n_dot_l)
    } else {
        Rgb::BLACK
    };
    recorder.step(|| Event::Diffuse { k_d, term: diffuse }.into());

    if !with_highlights {
        recorder.leave(|| Event::LightAdded { term: diffuse }.into());
        return Intensity {
            whole: diffuse,
            diffuse,
        };
    }
    let Material {
        specular: k_s,
        shininess,
        ..
    } = *point.material;
    let cosine = match point.material.highlight {
        Highlight::Phong => {
            let mirrored = 2.0 * n_dot_l * normal - to_light;
            // A rounding error above 1 would be a power above 1.
            let r_dot_v = mirrored.dot(to_eye).min(1.0);
            recorder.step(|| {
                Event::Mirrored {
                    mirrored,
                    r_dot_v,
                    shininess,
                }
                .into()
            });
            r_dot_v
        }
        Highlight::Blinn => {
            let halfway = (to_light + to_eye).normalize_or_zero();
            let n_dot_h = normal.dot(halfway).min(1.0);
            recorder.step(|| {
                Event::Halfway {
                    halfway,
                    n_dot_h,
                    shininess,
                }
                .into()
            });
            n_dot_h
        }
    };
    let specular = if n_dot_l > 0.0 {
        k_s * color * (attenuation * power_of_cosine(cosine, shininess))
    } else {
        Rgb::BLACK
    };
    recorder.step(|| {
        Event::Specular {
            k_s,
            term: specular,
        }
        .into()
    });

    let term = diffuse + specular;
    recorder.leave(|| Event::LightAdded { term }.into());
    Intensity {
        whole: term,
        diffuse,
    }
}

/// One event a term and light, with its vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Opens the model at a point; `normal` is already on the side of the eye.
    Illumination {
        position: DVec3,
        normal: DVec3,
    },
    Viewer {
        to_eye: DVec3,
        turned: bool,
    },
    Ambient {
        k_a: Rgb,
        term: Rgb,
    },
    /// Opens the part of one light.
    Light {
        light: u32,
        color: Rgb,
        distance: f64,
        attenuation: f64,
        slide_factor: f64,
    },
    ToLight {
        to_light: DVec3,
        n_dot_l: f64,
    },
    Diffuse {
        k_d: Rgb,
        term: Rgb,
    },
    Mirrored {
        mirrored: DVec3,
        r_dot_v: f64,
        shininess: f64,
    },
    Halfway {
        halfway: DVec3,
        n_dot_h: f64,
        shininess: f64,
    },
    Specular {
        k_s: Rgb,
        term: Rgb,
    },
    /// Closes `Light`.
    LightAdded {
        term: Rgb,
    },
    /// Closes `Illumination`.
    Illuminated {
        intensity: Rgb,
    },
}

const _: () = assert!(size_of::<Event>() <= 64);

impl Event {
    pub fn light(incidence: &Incidence, n_dot_l: f64) -> Self {
        Event::Light {
            light: incidence.light as u32,
            color: incidence.color,
            distance: incidence.distance,
            attenuation: incidence.attenuation,
            slide_factor: slide_factor(incidence.distance, n_dot_l),
        }
    }
}
