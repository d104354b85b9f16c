//! A matrix of form factors of another program against ours: the first row that differs, and what the whole looks like.

use crate::scene::what_the_parser_says;
use std::f64::consts::PI;

/// What a matrix is instead of F, for all its entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Looks {
    /// F_ji at the place of F_ij.
    Transposed,
    /// A_i F_ij, which is symmetric.
    TimesArea,
    /// F_ij/π.
    OverPi,
    /// π·F_ij.
    TimesPi,
    /// What would be without anything between the patches.
    Unblocked,
}

impl Looks {
    /// Entry (i, j) of such a matrix, made of F; of the unblocked one F is the unblocked one itself.
    fn entry(self, f: &[f64], areas: &[f64], i: usize, j: usize) -> f64 {
        let f = |i: usize, j: usize| f[i * areas.len() + j];
        match self {
            Looks::Transposed => f(j, i),
            Looks::TimesArea => areas[i] * f(i, j),
            Looks::OverPi => f(i, j) / PI,
            Looks::TimesPi => f(i, j) * PI,
            Looks::Unblocked => f(i, j),
        }
    }

    pub fn in_words(self) -> &'static str {
        match self {
            Looks::Transposed => "it is the transposed matrix: F_ji at the place of F_ij",
            Looks::TimesArea => {
                "it is A_i·F_ij, which is symmetric: divide row i by the area of patch i"
            }
            Looks::OverPi => "it is F_ij/π: π is divided by once more than in the form factor",
            Looks::TimesPi => "it is π·F_ij: the division by π is missing",
            Looks::Unblocked => "it is the matrix without anything between the patches",
        }
    }
}

/// An entry that differs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    pub row: usize,
    pub column: usize,
    pub mine: f64,
    pub reference: f64,
}

#[derive(Clone, Debug, PartialEq)]
pub struct MatrixComparison {
    /// Entries that are off by more than the tolerance.
    pub off: usize,
    /// Of the first row that differs, the entry that differs the most.
    pub first: Option<Entry>,
    pub largest: f64,
    pub looks: Option<Looks>,
    /// The rows whose sum differs from that of ours, with both sums.
    pub sums: Vec<(usize, f64, f64)>,
}

/// Compares two n×n matrices, row-major. `unblocked` gives ours without anything between the patches.
pub fn compare(
    mine: &[f64],
    reference: &[f64],
    areas: &[f64],
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
    let is = |looks: &Looks, of: &[f64]| {
        let entry = |at: usize| looks.entry(of, areas, at / n, at % n);
        (0..n * n).all(|at| (mine[at] - entry(at)).abs() <= tolerance)
    };
    let looks = (off > 0).then(|| {
        let simple = [
            Looks::Transposed,
            Looks::TimesArea,
            Looks::OverPi,
            Looks::TimesPi,
        ];
        let simple = simple.into_iter().find(|looks| is(looks, reference));
        simple.or_else(|| {
            let unblocked = unblocked()?;
            Some(Looks::Unblocked).filter(|looks| is(looks, &unblocked))
        })
    });
    let sum = |matrix: &[f64], i: usize| matrix[i * n..(i + 1) * n].iter().sum::<f64>();
    let sums = (0..n).map(|i| (i, sum(mine, i), sum(reference, i)));
    MatrixComparison {
        off,
        first,
        largest: (0..n * n).map(|at| difference(&at)).fold(0.0, f64::max),
        looks: looks.flatten(),
        sums: sums
            .filter(|(_, mine, reference)| (mine - reference).abs() > tolerance)
            .collect(),
    }
}

/// The numbers of a matrix of n rows: a JSON list of lists, alone or under the key `matrix`, or rows of numbers with commas, semicolons
/// or spaces between them. Errors: what is wrong, with its row.
pub fn read(text: &str, n: usize) -> Result<Vec<f64>, String> {
    let text = text.trim_start_matches('\u{feff}');
    let rows: Vec<Vec<f64>> = if text.trim_start().starts_with(['[', '{']) {
        let json: serde_json::Value = serde_json::from_str(text).map_err(|error| {
            let (line, column) = (error.line(), error.column());
            let says = what_the_parser_says(&error, "the file");
            format!("line {line}, column {column}: {says}")
        })?;
        let rows = json.get("matrix").unwrap_or(&json).clone();
        serde_json::from_value(rows).map_err(|error| {
            let says = what_the_parser_says(&error, "the file");
            format!("{says}; a matrix is a list of rows, each a list of numbers")
        })?
    } else {
        let lines = text.lines().filter(|line| !line.trim().is_empty());
        let row = |(line, text): (usize, &str)| {
            let words = text
                .split([',', ';', ' ', '\t'])
                .filter(|word| !word.is_empty());
            let numbers = words.map(|word| {
                let number = word.trim().parse::<f64>();
                number.map_err(|_| format!("row {line}: {word:?} is not a number"))
            });
            numbers.collect::<Result<Vec<f64>, String>>()
        };
        (0..).zip(lines).map(row).collect::<Result<_, _>>()?
    };
    if rows.len() != n {
        return Err(format!(
            "it has {} rows; the scene has {n} patches",
            rows.len()
        ));
    }
    if let Some((row, numbers)) = (0..).zip(&rows).find(|(_, row)| row.len() != n) {
        return Err(format!(
            "row {row} has {} numbers; the scene has {n} patches",
            numbers.len()
        ));
    }
    match rows.iter().flatten().position(|number| !number.is_finite()) {
        Some(at) => Err(format!("row {}: a number is not finite", at / n)),
        None => Ok(rows.concat()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const F: [f64; 4] = [0.0, 0.4, 0.1, 0.2];
    const AREAS: [f64; 2] = [1.0, 4.0];

    fn found(mine: [f64; 4]) -> MatrixComparison {
        compare(&mine, &F, &AREAS, 1e-4, || Some(vec![0.0, 0.5, 0.125, 0.2]))
    }

    #[test]
    fn a_matrix_within_the_tolerance_agrees() {
        let found = found([0.00005, 0.4, 0.1, 0.2]);
        assert_eq!((found.off, found.first, found.looks), (0, None, None));
        assert!(found.sums.is_empty() && found.largest < 1e-4);
    }

    #[test]
    fn the_first_row_that_differs_is_told_with_its_worst_entry() {
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
        assert!((found.sums[0].1 - 0.55).abs() < 1e-12);
    }

    #[test]
    fn what_the_whole_looks_like_is_recognized() {
        let pi = std::f64::consts::PI;
        for (mine, looks) in [
            ([0.0, 0.1, 0.4, 0.2], Looks::Transposed),
            ([0.0, 0.4, 0.4, 0.8], Looks::TimesArea),
            (F.map(|f| f / pi), Looks::OverPi),
            (F.map(|f| f * pi), Looks::TimesPi),
            ([0.0, 0.5, 0.125, 0.2], Looks::Unblocked),
        ] {
            assert_eq!(found(mine).looks, Some(looks));
        }
    }

    #[test]
    fn matrices_are_read_from_json_and_from_rows_of_numbers() {
        let right = Ok(F.to_vec());
        assert_eq!(read("[[0, 0.4], [0.1, 0.2]]", 2), right);
        assert_eq!(
            read("{\"matrix\": [[0, 0.4], [0.1, 0.2]], \"method\": 1}", 2),
            right
        );
        assert_eq!(read("0, 0.4\n0.1, 0.2\n", 2), right);
        assert_eq!(read("\u{feff}0, 0.4\n0.1, 0.2\n", 2), right);
        assert_eq!(read("0;0.4\r\n\n0.1;0.2", 2), right);
        for (text, expected) in [
            ("0 0.4", "it has 1 rows; the scene has 2 patches"),
            ("0 0.4\n0.1", "row 1 has 1 numbers; the scene has 2 patches"),
            ("0 0.4\n0.1 x", "row 1: \"x\" is not a number"),
            ("0 0.4\n0.1 inf", "row 1: a number is not finite"),
        ] {
            assert_eq!(read(text, 2), Err(expected.to_owned()));
        }
        assert_eq!(
            read("[[0, NaN], [0, 0]]", 2).unwrap_err(),
            "line 1, column 6: expected a value: a number, text in double quotes, true, false, a list or an object (NaN and Infinity are none)"
        );
        assert!(
            read("[[0, 0.4], [0.1, 0.2]", 2)
                .unwrap_err()
                .contains("the file ends here")
        );
        assert!(
            read("{\"rows\": 1}", 2)
                .unwrap_err()
                .contains("a list of rows")
        );
    }
}
