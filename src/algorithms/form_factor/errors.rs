//! How far form factors may be off: an estimate for each row of the matrix.

use super::{FormFactors, Method};

/// A matrix of form factors, and how exact it is.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Estimated {
    /// Row-major.
    pub matrix: Vec<f64>,
    /// By row, an estimate of Σ_j |δF_ij|, δF_ij the error of an entry. It bounds the error of the row sum.
    pub row_errors: Vec<f64>,
}

/// How far the exchange of two patches may be off because something stands between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairError {
    pub i: u32,
    pub j: u32,
    /// Of A_i F_ij.
    pub exchange: f64,
}

impl FormFactors<'_> {
    /// By row, an estimate of Σ_j |δF_ij|: of a whole matrix, and of the pairs whose visibility is not exact.
    pub fn row_errors(&self, matrix: &[f64], pairs: &[PairError]) -> Vec<f64> {
        let n = self.patches.len();
        let mut errors: Vec<f64> = (0..n)
            .map(|i| self.row_error(i, &matrix[i * n..][..n]))
            .collect();
        for pair in pairs {
            for patch in [pair.i, pair.j] {
                errors[patch as usize] += pair.exchange / self.patches[patch as usize].area;
            }
        }
        errors
    }

    /// The form factors with which those of a method without an estimate of its error are compared.
    pub fn reference(&self) -> Option<Self> {
        let has_none = matches!(
            self.method,
            Method::AreaToArea { .. } | Method::ElementToPolygon { .. } | Method::Hemicube(_)
        );
        let [method, ..] = Method::ALL;
        has_none.then(|| FormFactors {
            method,
            ..self.clone()
        })
    }

    /// What the method alone leaves open in a row, visibility apart. Those with a [`Self::reference`] have no estimate.
    fn row_error(&self, i: usize, row: &[f64]) -> f64 {
        match self.method {
            Method::Auto { tolerance } => tolerance * row.iter().sum::<f64>(),
            Method::Contour { tolerance } => {
                let area = self.patches[i].area;
                let smaller = |j: usize| self.patches[j].area.min(area) / area;
                (0..row.len())
                    .filter(|&j| row[j] > 0.0)
                    .map(|j| tolerance * smaller(j))
                    .sum()
            }
            // The standard error of a share of so many rays.
            Method::MonteCarlo { rays, .. } => row
                .iter()
                .map(|&f| (f * (1.0 - f).max(0.0) / f64::from(rays)).sqrt())
                .sum(),
            Method::AreaToArea { .. } | Method::ElementToPolygon { .. } | Method::Hemicube(_) => {
                0.0
            }
        }
    }
}
