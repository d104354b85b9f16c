//! Radiosity with a mistake in its equation, B = E + ρ·Σ F_ij·B_j, solved by gathering until nothing changes, or for a hundred rounds.

use super::Mistake;
use crate::algorithms::enclosure::Enclosure;
use crate::color::Rgb;
use std::f64::consts::PI;

const ROUNDS: u32 = 100;

/// B of every patch. `matrix` is F, row-major.
pub fn light(enclosure: &Enclosure, matrix: &[f64], mistake: Mistake) -> Vec<Rgb> {
    let mut light = enclosure.emission.clone();
    for _ in 0..ROUNDS {
        let next = gathered(Some(mistake), enclosure, matrix, &light);
        let settled = next == light;
        light = next;
        if settled {
            break;
        }
    }
    light
}

/// What every patch gives off once it has gathered `light`: E + ρ·Σ F_ij·B_j, or that with a mistake.
pub fn gathered(
    mistake: Option<Mistake>,
    enclosure: &Enclosure,
    matrix: &[f64],
    light: &[Rgb],
) -> Vec<Rgb> {
    let n = enclosure.patches.len();
    let entry = |i: usize, j: usize| match mistake {
        Some(Mistake::FormFactorTransposed) => matrix[j * n + i],
        Some(Mistake::PiTwice) => matrix[i * n + j] / PI,
        _ => matrix[i * n + j],
    };
    let reflectance = |i: usize| match mistake {
        Some(Mistake::ReflectanceForgotten) => Rgb::WHITE,
        _ => enclosure.reflectance[i],
    };
    let one = |i: usize| {
        let arriving = (0..n).fold(Rgb::BLACK, |sum, j| sum + light[j] * entry(i, j));
        enclosure.emission[i] + reflectance(i) * arriving
    };
    (0..n).map(one).collect()
}
