//! Where light is never lost: a closed part of the scene in which every reflectance is 1. If any light gets in, no solution exists.

use super::outcome::Unsolved;
use super::system::System;

/// A reflectance this close below 1 is 1, up to rounding.
const PERFECT: f64 = 1.0 - 1e-14;

/// A row whose sum is this close below 1 is closed, up to the error of form factors.
const CLOSED: f64 = 1.0 - 1e-6;

/// Errors: light that is emitted where none is ever lost.
pub(super) fn refuse_endless_light(system: &System) -> Result<(), Unsolved> {
    let (patches, sums) = (&system.patches, system.matrix.row_sums());
    let n = patches.len();
    let mut singularity_check: Vec<bool> = (0..n)
        .map(|i| patches.rho[i] >= PERFECT && sums[i] >= CLOSED)
        .collect();
    if !singularity_check.contains(&true) {
        return Ok(());
    }
    // Light is lost wherever it can go on to a patch where it is lost.
    let mut lossy: Vec<usize> = (0..n).filter(|&i| !singularity_check[i]).collect();
    while let Some(j) = lossy.pop() {
        for (i, singularity_check) in singularity_check.iter_mut().enumerate() {
            if *singularity_check && (system.matrix.of(i)[j] > 0.0 || system.matrix.of(j)[i] > 0.0)
            {
                *singularity_check = false;
                lossy.push(i);
            }
        }
    }
    match (0..n).find(|&i| singularity_check[i] && patches.emission[i] != 0.0) {
        Some(patch) => Err(Unsolved::NoSolution { patch }),
        None => Ok(()),
    }
}
