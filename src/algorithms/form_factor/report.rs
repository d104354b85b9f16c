//! What can be said of a matrix of form factors without knowing the right one.

/// How well a matrix keeps the laws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Report {
    /// The smallest and the largest sum of a row. Never above 1 in exact arithmetic.
    pub row_sums: [f64; 2],
    /// The largest |A_i F_ij − A_j F_ji|, as a share of the larger of the two.
    pub reciprocity_defect: f64,
    /// The largest |1 − Σ_j F_ij|: an error only where the scene is closed.
    pub closure_defect: f64,
}

impl Report {
    /// `matrix` is row-major. Rows of patches that are not seen are left out of the sums.
    pub fn of(areas: &[f64], matrix: &[f64], is_seen: &[bool]) -> Report {
        let n = areas.len();
        let (mut low, mut high, mut reciprocity) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
        for (i, row) in matrix.chunks(n.max(1)).enumerate() {
            let sum: f64 = row.iter().sum();
            if is_seen[i] {
                (low, high) = (low.min(sum), high.max(sum));
            }
            for j in 0..i {
                let there = areas[i] * row[j];
                let back = areas[j] * matrix[j * n + i];
                let most = there.max(back);
                if most > 0.0 {
                    reciprocity = reciprocity.max((there - back).abs() / most);
                }
            }
        }
        if low > high {
            (low, high) = (0.0, 0.0);
        }
        Report {
            row_sums: [low, high],
            reciprocity_defect: reciprocity,
            closure_defect: (1.0 - low).abs().max((1.0 - high).abs()),
        }
    }
}
