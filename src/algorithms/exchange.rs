//! All form factors of an enclosure: as they were computed, and as they were corrected where they broke the law of closed scenes.

use super::form_factor::closed::is_closed;
use super::form_factor::closure::{Correction, correct};
use super::form_factor::{Blockers, Estimated, Report};
use crate::scene::patches::Patches;

/// The form factors that light is exchanged by.
#[derive(Clone, Debug)]
pub struct Exchange {
    /// F, row-major.
    pub matrix: Vec<f64>,
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
    /// Whether from every patch nothing but fronts of patches is seen, so that every row sums to 1.
    pub is_closed: bool,
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
            row_errors,
        } = computed;
        let rows = matrix.chunks(patches.len().max(1));
        let row_sums = rows.map(|row| row.iter().sum()).collect();
        let report = Report::of(patches, &matrix);
        let is_opaque = blockers.is_some_and(Blockers::all_block);
        let is_closed = is_opaque && is_closed(patches);
        let correction = match is_closed && closure {
            true => correct(&patches.areas(), &mut matrix),
            false => None,
        };
        Exchange {
            matrix,
            correction,
            report,
            row_sums,
            row_errors,
            is_opaque,
            is_closed,
        }
    }
}
