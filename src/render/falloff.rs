//! How the light of a lamp falls off with the distance, by the standard model and as the slide prints it.

use crate::algorithms::incidence::{attenuation, slide_factor};
use crate::scene::Light;

/// Samples lie between these distances, at equal ratios.
const NEAREST: f64 = 0.1;
const FARTHEST: f64 = 100.0;
const PARTS: u32 = 60;

/// By distance, ascending; empty for a directional light, which does not fall off.
#[derive(Clone, Debug, PartialEq)]
pub struct Falloff(pub Vec<Sample>);

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    pub distance: f64,
    /// f_att(d).
    pub standard: f64,
    /// The slide's factor for light that arrives along the normal.
    pub slide: f64,
}

impl Falloff {
    pub fn of(light: &Light) -> Self {
        let Light::Point {
            attenuation: coefficients,
            ..
        } = *light
        else {
            return Falloff(Vec::new());
        };
        let distances = (0..=PARTS)
            .map(|part| NEAREST * (FARTHEST / NEAREST).powf(f64::from(part) / f64::from(PARTS)));
        let samples = distances.map(|distance| Sample {
            distance,
            standard: attenuation(coefficients, distance),
            slide: slide_factor(distance, 1.0),
        });
        Falloff(samples.collect())
    }
}
