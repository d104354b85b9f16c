//! A light as seen from a point: its direction, its distance, and how much of it arrives.

use crate::color::Rgb;
use crate::scene::Light;
use glam::DVec3;

#[derive(Clone, Copy, Debug)]
pub struct Incidence {
    /// Index of the light.
    pub light: usize,
    /// L, unit; zero where the light stands at the very point.
    pub to_light: DVec3,
    /// Infinite for a directional light.
    pub distance: f64,
    /// f_att
    pub attenuation: f64,
    pub color: Rgb,
}

impl Incidence {
    /// Light number `light` as seen from `position`.
    pub fn of(light: usize, source: &Light, position: DVec3) -> Self {
        match *source {
            Light::Point {
                position: source,
                color,
                attenuation: coefficients,
                ..
            } => {
                let distance = source.distance(position);
                Incidence {
                    light,
                    to_light: (source - position).normalize_or_zero(),
                    distance,
                    attenuation: attenuation(coefficients, distance),
                    color,
                }
            }
            Light::Directional { toward, color } => Incidence {
                light,
                to_light: -toward,
                distance: f64::INFINITY,
                attenuation: 1.0,
                color,
            },
        }
    }
}

/// f_att at a distance.
pub fn attenuation(coefficients: [f64; 3], distance: f64) -> f64 {
    1.0 / divisor(coefficients, distance)
}

/// a0 + a1·d + a2·d², which light from the distance d is divided by. Not all coefficients are zero, but a1·d and a2·d² may
/// underflow: it is at least the smallest normal number.
pub fn divisor([a0, a1, a2]: [f64; 3], d: f64) -> f64 {
    (a0 + d * (a1 + a2 * d)).max(f64::MIN_POSITIVE)
}

/// What the slide prints in place of f_att(d)·N·L. It is not defined at an infinite distance: 0.
pub fn slide_factor(distance: f64, cos_phi: f64) -> f64 {
    if distance.is_finite() && distance > 0.0 {
        distance * cos_phi / distance.sqrt()
    } else {
        0.0
    }
}
