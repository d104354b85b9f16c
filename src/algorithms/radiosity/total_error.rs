//! How far the radiosity of a solution may be from the right one, where both the solution and the form factors have errors.
//!
//! Let B̂ be the solution with F̂ = F + δF and the residual r = E − (I − ρF̂)B̂. Then (I − ρF)(B̂ − B) = ρ δF B̂ − r, and since F is not
//! negative, ‖(I − ρF)⁻¹‖_∞ ≤ 1 / (1 − max_i ρ_i Σ_j F_ij) (Neumann's series). With c in the middle of the values of B̂, and d half
//! of their range,
//!
//! |Σ_j δF_ij B̂_j| ≤ |Σ_j δF_ij| |c| + Σ_j |δF_ij| d.
//!
//! So where rows are known to sum to 1, a uniform light has no error at all, however little of it is lost.

use super::outcome::Solution;
use super::system::System;

/// What is known of the errors of form factors, by row.
#[derive(Clone, Copy, Debug)]
pub struct RowErrors<'a> {
    /// Σ_j |δF_ij| is at most this.
    pub entries: &'a [f64],
    /// |Σ_j δF_ij| is at most this.
    pub sums: &'a [f64],
}

/// A bound of ‖B̂ − B‖_∞. None where no bound is known, since light may never be lost.
pub fn total_error(system: &System, solution: &Solution, errors: &RowErrors) -> Option<f64> {
    let b = &solution.radiosity;
    let rho = system.patches.rho;
    // What sees nothing is seen by nothing.
    let sees = |&i: &usize| system.matrix.row_sums()[i] > 0.0 || errors.entries[i] > 0.0;
    let seen = || (0..b.len()).filter(sees).map(|i| b[i]);
    let low = seen().fold(f64::INFINITY, f64::min);
    let high = seen().fold(f64::NEG_INFINITY, f64::max);
    let (middle, half) = match low <= high {
        true => (0.5 * (low + high), 0.5 * (high - low)),
        false => (0.0, 0.0),
    };
    let mut residual = vec![0.0; b.len()];
    system.residual(b, &mut residual);
    let (mut largest, mut gain) = (0.0_f64, 0.0_f64);
    for i in 0..b.len() {
        let received = errors.sums[i] * middle.abs() + errors.entries[i] * half;
        largest = largest.max(residual[i].abs() + rho[i] * received);
        // No right row sums to more than 1.
        gain = gain.max(rho[i] * (system.matrix.row_sums()[i] + errors.sums[i]).min(1.0));
    }
    if largest == 0.0 {
        return Some(0.0);
    }
    let bound = largest / (1.0 - gain);
    let is_known = gain < 1.0 && bound.is_finite();
    is_known.then(|| bound.max(solution.error_bound.unwrap_or(0.0)))
}
