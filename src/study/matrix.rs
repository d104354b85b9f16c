//! A matrix of form factors of another program against ours: the first row that differs, and what the whole looks like.

use super::numbers::rows;
use serde::Serialize;
use std::f64::consts::PI;

/// What a matrix is instead of F, for all its entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum MatrixForm {
    /// F_ji at the place of F_ij.
    Transposed,
    /// A_i F_ij, which is symmetric.
    TimesArea,
    /// F_ij/π.
    OverPi,
    /// π·F_ij.
    TimesPi,
    /// ρ_i·F_ij of a channel.
    TimesReflectance,
    /// I − ρF of a channel: the matrix of the system.
    System,
    /// What would be without anything between the patches.
    Unblocked,
}

impl MatrixForm {
    /// Entry (i, j) of such a matrix, made of F; of the unblocked one F is the unblocked one itself. `rho` is ρ_i.
    fn entry(self, f: &[f64], areas: &[f64], rho: f64, i: usize, j: usize) -> f64 {
        let f = |i: usize, j: usize| f[i * areas.len() + j];
        match self {
            MatrixForm::Transposed => f(j, i),
            MatrixForm::TimesArea => areas[i] * f(i, j),
            MatrixForm::OverPi => f(i, j) / PI,
            MatrixForm::TimesPi => f(i, j) * PI,
            MatrixForm::TimesReflectance => rho * f(i, j),
            MatrixForm::System => f64::from(u8::from(i == j)) - rho * f(i, j),
            MatrixForm::Unblocked => f(i, j),
        }
    }

    pub fn in_words(self) -> &'static str {
        match self {
            MatrixForm::Transposed => "it is the transposed matrix: F_ji at the place of F_ij",
            MatrixForm::TimesArea => {
                "it is A_i·F_ij, which is symmetric: divide row i by the area of patch i"
            }
            MatrixForm::OverPi => "it is F_ij/π: π is divided by once more than in the form factor",
            MatrixForm::TimesPi => "it is π·F_ij: the division by π is missing",
            MatrixForm::TimesReflectance => {
                "it is ρ_i·F_ij: a form factor knows no ρ, which belongs into the system I − ρF"
            }
            MatrixForm::System => "it is I − ρF, the matrix of the system, and not F",
            MatrixForm::Unblocked => "it is the matrix without anything between the patches",
        }
    }
}

/// An entry that differs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Entry {
    pub row: usize,
    pub column: usize,
    pub mine: f64,
    pub reference: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MatrixComparison {
    /// Entries that are off by more than the tolerance.
    pub off: usize,
    /// Of the first row that differs, the entry that differs the most.
    pub first: Option<Entry>,
    pub largest: f64,
    pub looks: Option<MatrixForm>,
    /// It is symmetric, and ours is not.
    pub is_symmetric: bool,
    /// The rows whose sum differs from that of ours.
    pub sums: Vec<RowSum>,
}

/// The sum of a row in both matrices; 1 in a closed room.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RowSum {
    pub row: usize,
    pub mine: f64,
    pub reference: f64,
}

/// Compares two n×n matrices, row-major. `rho` has ρ of every patch, channel by channel; `unblocked` gives ours without anything between the patches.
pub fn compare(
    mine: &[f64],
    reference: &[f64],
    areas: &[f64],
    rho: &[[f64; 3]],
    tolerance: f64,
    unblocked: impl FnOnce() -> Option<Vec<f64>>,
) -> MatrixComparison {
    let n = areas.len();
    let differs = |at: &usize| (mine[*at] - reference[*at]).abs() > tolerance;
    let off = (0..n * n).filter(differs).count();
    let difference = |at: &usize| (mine[*at] - reference[*at]).abs();
    let first = (0..n * n).find(differs).map(|at| {
        let row = at / n;
        let worst = (row * n..(row + 1) * n).max_by(|a, b| difference(a).total_cmp(&difference(b)));
        let worst = worst.unwrap_or(at);
        Entry {
            row,
            column: worst % n,
            mine: mine[worst],
            reference: reference[worst],
        }
    });
    let is = |looks: &MatrixForm, of: &[f64]| {
        let of_channel = |c: usize| {
            let entry = |at: usize| looks.entry(of, areas, rho[at / n][c], at / n, at % n);
            (0..n * n).all(|at| (mine[at] - entry(at)).abs() <= tolerance)
        };
        (0..3).any(of_channel)
    };
    let looks = (off > 0).then(|| {
        let simple = [
            MatrixForm::Transposed,
            MatrixForm::TimesArea,
            MatrixForm::OverPi,
            MatrixForm::TimesPi,
            MatrixForm::TimesReflectance,
            MatrixForm::System,
        ];
        let simple = simple.into_iter().find(|looks| is(looks, reference));
        simple.or_else(|| {
            let unblocked = unblocked()?;
            Some(MatrixForm::Unblocked).filter(|looks| is(looks, &unblocked))
        })
    });
    let is_symmetric = |matrix: &[f64]| {
        let pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i * n + j, j * n + i)));
        pairs
            .into_iter()
            .all(|(a, b)| (matrix[a] - matrix[b]).abs() <= tolerance)
    };
    let sum = |matrix: &[f64], i: usize| matrix[i * n..(i + 1) * n].iter().sum::<f64>();
    let sums = (0..n).map(|row| RowSum {
        row,
        mine: sum(mine, row),
        reference: sum(reference, row),
    });
    MatrixComparison {
        off,
        first,
        largest: (0..n * n).map(|at| difference(&at)).fold(0.0, f64::max),
        looks: looks.flatten(),
        is_symmetric: is_symmetric(mine) && !is_symmetric(reference),
        sums: sums
            .filter(|sum| (sum.mine - sum.reference).abs() > tolerance)
            .collect(),
    }
}

/// The numbers of a matrix of n rows. Errors: what is wrong, with its row.
pub fn read(bytes: &[u8], n: usize) -> Result<Vec<f64>, String> {
    let rows = rows(bytes, "matrix")?;
    if rows.len() != n {
        let found = rows.len();
        return Err(format!("it has {found} rows; the scene has {n} patches"));
    }
    match (0..).zip(&rows).find(|(_, row)| row.len() != n) {
        Some((row, numbers)) => Err(format!(
            "row {row} has {} numbers; the scene has {n} patches",
            numbers.len()
        )),
        None => Ok(rows.concat()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const F: [f64; 4] = [0.0, 0.4, 0.1, 0.2];
    const AREAS: [f64; 2] = [1.0, 4.0];
    const RHO: [[f64; 3]; 2] = [[0.5, 0.2, 0.9], [0.25, 0.6, 0.9]];

    fn found(mine: [f64; 4]) -> MatrixComparison {
        compare(&mine, &F, &AREAS, &RHO, 1e-4, || {
            Some(vec![0.0, 0.5, 0.125, 0.2])
        })
    }

    #[test]
    fn a_matrix_within_the_tolerance_agrees() {
        let found = found([0.00005, 0.4, 0.1, 0.2]);
        assert_eq!((found.off, found.first, found.looks), (0, None, None));
        assert!(found.sums.is_empty() && found.largest < 1e-4);
    }

    #[test]
    fn the_first_row_that_differs_is_reported_with_its_worst_entry() {
        let found = found([0.0, 0.4, 0.3, 0.25]);
        let entry = Entry {
            row: 1,
            column: 0,
            mine: 0.3,
            reference: 0.1,
        };
        assert_eq!(
            (found.off, found.first, found.looks),
            (2, Some(entry), None)
        );
        assert_eq!(found.sums.len(), 1);
        assert!((found.sums[0].mine - 0.55).abs() < 1e-12);
        assert!((found.sums[0].reference - 0.3).abs() < 1e-12);
    }

    #[test]
    fn what_the_whole_looks_like_is_recognized() {
        let pi = std::f64::consts::PI;
        for (mine, looks) in [
            ([0.0, 0.1, 0.4, 0.2], MatrixForm::Transposed),
            ([0.0, 0.4, 0.4, 0.8], MatrixForm::TimesArea),
            (F.map(|f| f / pi), MatrixForm::OverPi),
            (F.map(|f| f * pi), MatrixForm::TimesPi),
            ([0.0, 0.08, 0.06, 0.12], MatrixForm::TimesReflectance),
            ([1.0, -0.2, -0.025, 0.95], MatrixForm::System),
            ([0.0, 0.5, 0.125, 0.2], MatrixForm::Unblocked),
        ] {
            assert_eq!(found(mine).looks, Some(looks));
        }
    }

    #[test]
    fn a_matrix_is_called_symmetric_where_ours_is_not() {
        assert!(found([0.0, 0.3, 0.3, 0.2]).is_symmetric);
        assert!(!found([0.0, 0.3, 0.1, 0.2]).is_symmetric);
    }

    #[test]
    fn a_matrix_of_another_size_is_refused_with_both_sizes() {
        let read = |text: &str| read(text.as_bytes(), 2);
        assert_eq!(read("0 0.4\n0.1 0.2"), Ok(F.to_vec()));
        for (text, expected) in [
            ("0 0.4", "it has 1 rows; the scene has 2 patches"),
            ("0 0.4\n0.1", "row 1 has 1 numbers; the scene has 2 patches"),
        ] {
            assert_eq!(read(text), Err(expected.to_owned()));
        }
    }
}
