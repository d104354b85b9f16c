//! All form factors of an enclosure: as they were computed, and as they were corrected where they broke the law of closed scenes.

use super::form_factor::closed::Closed;
use super::form_factor::closure::{Correction, correct};
use super::form_factor::{Blockers, Estimated, Report};
use crate::scene::patches::Patches;

/// The form factors that light is exchanged by.
#[derive(Clone, Debug)]
pub struct Exchange {
    /// F, row-major. Where it was corrected, from the part of each patch that light comes to.
    pub matrix: Vec<f64>,
    /// Of the patches, or of those parts.
    pub areas: Vec<f64>,
    /// None where nothing was corrected.
    pub correction: Option<Correction>,
    /// Of the form factors as they were computed.
    pub report: Report,
    /// Σ_j F_ij by row, as they were computed.
    pub row_sums: Vec<f64>,
    /// Σ_j |δF_ij| by row, as their method estimates it; 0 where it has no estimate.
    pub row_errors: Vec<f64>,
    /// Whether nothing is seen through, so that no row sums to more than 1.
    pub is_opaque: bool,
    /// Whether nothing but fronts of patches is seen wherever light comes to, so that rows sum to 1.
    pub is_closed: bool,
    /// By patch, whether light comes to any part of it; else its row is 0.
    pub is_seen: Vec<bool>,
}

impl Exchange {
    /// `blockers` are none where nothing is to block. With `closure`, what was computed is corrected where the scene is closed.
    pub fn of(
        patches: &Patches,
        blockers: Option<&Blockers>,
        closure: bool,
        computed: Estimated,
    ) -> Self {
        let Estimated {
            mut matrix,
            mut row_errors,
        } = computed;
        let n = patches.len();
        let sum = |row: &[f64]| row.iter().sum::<f64>();
        let closed = blockers.and_then(|blockers| blockers.closed(patches));
        let mut areas = patches.areas();
        let mut is_seen = vec![true; n];
        if let Some(Closed { shares, .. }) = closed {
            is_seen = shares.iter().map(|&share| share > 0.0).collect();
            for (i, &share) in shares.iter().enumerate() {
                if closure && 0.0 < share && share < 1.0 {
                    areas[i] *= share;
                    matrix[i * n..][..n].iter_mut().for_each(|f| *f /= share);
                    row_errors[i] /= share;
                }
            }
        }
        let row_sums = matrix.chunks(n.max(1)).map(sum).collect();
        let report = Report::of(&areas, &matrix, &is_seen);
        let is_closed = closed.is_some();
        let correction = match is_closed && closure {
            true => correct(&areas, &is_seen, &mut matrix),
            false => None,
        };
        Exchange {
            matrix,
            areas,
            correction,
            report,
            row_sums,
            row_errors,
            is_opaque: blockers.is_some_and(Blockers::all_block),
            is_closed,
            is_seen,
        }
    }
}
