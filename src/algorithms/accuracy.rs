//! How exact the form factors of an enclosure are, and what that means for its light.

use super::enclosure::{Enclosure, Light};
use super::exchange::Exchange;
use super::radiosity::{Matrix, Patches, RowErrors, System, total_error};
use crate::color::Rgb;
use std::iter::zip;

/// What rounding may do to the sum of a row, and to one that was corrected.
const ROUNDING: f64 = 1e-12;
const ROUNDING_CORRECTED: f64 = 1e-14;

/// The errors of form factors as they were computed.
#[derive(Clone, Debug)]
pub struct Accuracy<'a> {
    exchange: &'a Exchange,
    /// Σ_j |δF_ij| by row, as it is estimated.
    estimates: Vec<f64>,
}

/// A row that sums to more than 1 by more than its estimated error, which no scene does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Excess {
    pub patch: usize,
    pub sum: f64,
    pub estimate: f64,
}

impl<'a> Accuracy<'a> {
    /// `reference` is Σ_j |δF_ij| by row, against form factors that are known to be better; of methods with an estimate of their own, none.
    pub fn of(exchange: &'a Exchange, reference: Option<Vec<f64>>) -> Self {
        Accuracy {
            estimates: reference.unwrap_or_else(|| exchange.row_errors.clone()),
            exchange,
        }
    }

    /// The largest row sum above 1, where that is an error of the program.
    pub fn excess(&self) -> Option<Excess> {
        let rows = zip(&self.exchange.row_sums, &self.estimates).enumerate();
        let rows = rows.map(|(patch, (&sum, &estimate))| Excess {
            patch,
            sum,
            estimate,
        });
        let is_opaque = self.exchange.is_opaque;
        rows.filter(|row| is_opaque && row.sum > 1.0 + row.estimate + ROUNDING)
            .max_by(|a, b| a.sum.total_cmp(&b.sum))
    }

    /// Σ_j |δF_ij| by row: as it is estimated, and no less than what the sum of the row gives away.
    fn errors(&self) -> Vec<f64> {
        let Exchange {
            is_closed,
            is_opaque,
            row_sums,
            is_seen,
            ..
        } = self.exchange;
        let known = |sum: f64, is_seen: bool| match (*is_closed && is_seen, is_opaque) {
            (true, _) => (1.0 - sum).abs(),
            (false, true) => (sum - 1.0).max(0.0),
            (false, false) => 0.0,
        };
        let rows = zip(zip(row_sums, is_seen), &self.estimates);
        rows.map(|((&sum, &is_seen), &error)| error.max(known(sum, is_seen)))
            .collect()
    }

    /// The largest error of a row, as a share of its sum.
    pub fn largest_error(&self) -> f64 {
        let errors = self.errors();
        let rows = zip(&self.exchange.row_sums, &errors).filter(|&(_, &error)| error > 0.0);
        rows.map(|(&sum, &error)| error / sum.max(error))
            .fold(0.0, f64::max)
    }

    /// By channel, how far B may be off by the errors of the solution and of the form factors together. None where no bound is
    /// known.
    pub fn total_errors(&self, enclosure: &Enclosure, light: &Light) -> [Option<f64>; 3] {
        let computed = self.errors();
        let (entries, sums) = match &self.exchange.correction {
            Some(correction) => {
                let rows = zip(&computed, &correction.rows);
                let entries = rows.map(|(error, changed)| error + changed).collect();
                (entries, vec![ROUNDING_CORRECTED; computed.len()])
            }
            None => (computed.clone(), computed),
        };
        let errors = RowErrors {
            entries: &entries,
            sums: &sums,
        };
        let areas = &self.exchange.areas;
        std::array::from_fn(|c| {
            let of = |colors: &[Rgb]| colors.iter().map(|color| color.channels()[c]).collect();
            let (rho, emission): (Vec<f64>, Vec<f64>) =
                (of(&enclosure.reflectance), of(&enclosure.emission));
            let patches = Patches::new(areas, &rho, &emission).ok()?;
            let matrix = Matrix::new(&self.exchange.matrix, areas.len()).ok()?;
            let system = System::new(&matrix, patches).ok()?;
            total_error(&system, &light.solutions[c], &errors)
        })
    }
}
