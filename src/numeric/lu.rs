//! Gaussian elimination with partial pivoting: P A = L U, and A x = b solved with it (Golub & Van Loan, "Matrix Computations",
//! §3.4.1; in blocks of columns, §3.2.11, because a large matrix is otherwise read from memory once a column).

use std::iter::zip;

/// Columns eliminated before the rest of the matrix is touched.
const BLOCK: usize = 32;

/// The factors of a square matrix: L below the diagonal, whose own is 1, and U from it on.
#[derive(Clone, Debug)]
pub struct Lu {
    n: usize,
    lu: Vec<f64>,
    /// With which row each row was exchanged, in this order.
    pivots: Vec<usize>,
}

impl Lu {
    /// Factorises `a`, `n` rows of `n` numbers. A singular matrix leaves a zero on U's diagonal, and solutions that are not finite.
    pub fn new(n: usize, mut a: Vec<f64>) -> Lu {
        assert_eq!(a.len(), n * n, "not a square matrix of {n} rows");
        let mut pivots = Vec::with_capacity(n);
        for start in (0..n).step_by(BLOCK) {
            let end = (start + BLOCK).min(n);
            for k in start..end {
                let pivot = largest_below(&a, n, k);
                exchange(&mut a, n, k, pivot);
                pivots.push(pivot);
                eliminate(&mut a, n, k, end);
            }
            // The same exchanges of the block's rows, of the columns to its right. A row of the block comes after those it needs.
            for i in start + 1..n {
                let (above, below) = a.split_at_mut(i * n);
                let (l, rest) = below[..n].split_at_mut(end);
                let rows = start..end.min(i);
                let u = |k: usize| &above[k * n + end..(k + 1) * n];
                subtract_multiples(rest, &l[rows.clone()], rows.map(u));
            }
        }
        Lu { n, lu: a, pivots }
    }

    /// x of A x = b.
    pub fn solve(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        for (k, &pivot) in self.pivots.iter().enumerate() {
            x.swap(k, pivot);
        }
        for i in 0..self.n {
            x[i] -= dot(&self.row(i)[..i], &x[..i]);
        }
        for i in (0..self.n).rev() {
            let row = self.row(i);
            x[i] = (x[i] - dot(&row[i + 1..], &x[i + 1..])) / row[i];
        }
        x
    }

    fn row(&self, i: usize) -> &[f64] {
        &self.lu[i * self.n..(i + 1) * self.n]
    }
}

/// The row from `k` down whose entry in column `k` is largest.
fn largest_below(a: &[f64], n: usize, k: usize) -> usize {
    let entry = |&i: &usize| a[i * n + k].abs();
    (k..n)
        .rev()
        .max_by(|i, j| entry(i).total_cmp(&entry(j)))
        .unwrap_or(k)
}

fn exchange(a: &mut [f64], n: usize, upper: usize, lower: usize) {
    if upper < lower {
        let (head, tail) = a.split_at_mut(lower * n);
        head[upper * n..(upper + 1) * n].swap_with_slice(&mut tail[..n]);
    }
}

/// Subtracts multiples of row `k` from the rows below it, in the columns up to `end`, so that column `k` becomes zero there;
/// the multiples take the place of the zeros.
fn eliminate(a: &mut [f64], n: usize, k: usize, end: usize) {
    let (above, below) = a.split_at_mut((k + 1) * n);
    let u = &above[k * n..][k..end];
    for row in below.chunks_exact_mut(n) {
        let row = &mut row[k..end];
        row[0] /= u[0];
        let multiple = row[0];
        for (entry, u) in zip(&mut row[1..], &u[1..]) {
            *entry -= multiple * u;
        }
    }
}

/// row ← row − Σ_k l_k u_k; four at a time, so that the row is written a quarter as often.
fn subtract_multiples<'a>(row: &mut [f64], l: &[f64], mut u: impl Iterator<Item = &'a [f64]>) {
    let fours = l.chunks_exact(4);
    let remainder = fours.remainder();
    for l in fours {
        let [Some(u0), Some(u1), Some(u2), Some(u3)] = [u.next(), u.next(), u.next(), u.next()]
        else {
            return;
        };
        for ((((entry, u0), u1), u2), u3) in zip(zip(zip(zip(&mut *row, u0), u1), u2), u3) {
            *entry -= l[0] * u0 + l[1] * u1 + l[2] * u2 + l[3] * u3;
        }
    }
    for (l, u) in zip(remainder, u) {
        for (entry, u) in zip(&mut *row, u) {
            *entry -= l * u;
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    zip(a, b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    /// [[0, 2], [3, 4]] x = (2, 11): the first pivot is zero before rows are exchanged. By hand x = (7/3, 1).
    #[test]
    fn a_zero_pivot_is_exchanged() {
        let x = Lu::new(2, vec![0.0, 2.0, 3.0, 4.0]).solve(&[2.0, 11.0]);
        assert_eq!(x, [7.0 / 3.0, 1.0]);
    }

    /// Of random matrices, of orders on both sides of a block's, |b − A x| stays at the rounding of what was added up.
    #[test]
    fn the_residual_is_rounding() {
        let mut random = Random(1);
        let mut numbers = |count| -> Vec<f64> { (0..count).map(|_| random.number()).collect() };
        for n in [1, 2, 3, 31, 32, 33, 64, 95, 130] {
            let (a, b) = (numbers(n * n), numbers(n));
            let x = Lu::new(n, a.clone()).solve(&b);
            for (row, b) in zip(a.chunks_exact(n), &b) {
                let added: f64 = zip(row, &x).map(|(a, x)| (a * x).abs()).sum();
                let residual = b - dot(row, &x);
                assert!(
                    residual.abs() <= 1e-13 * n as f64 * added,
                    "{n}: {residual}"
                );
            }
        }
    }

    #[test]
    fn a_singular_matrix_gives_nothing_finite() {
        let x = Lu::new(2, vec![1.0, 2.0, 2.0, 4.0]).solve(&[1.0, 1.0]);
        assert!(x.iter().all(|x| !x.is_finite()));
    }
}
