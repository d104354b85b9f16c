//! The radiosity system of one channel, (I − ρF)B = E, and how well a given B solves it.

use super::event::SolverEvent;
use super::outcome::Unsolved;
use crate::record::{Recorder, Unrecorded};
use std::iter::zip;

/// Where rows of form factors come from: a stored matrix, or whatever computes one on demand.
pub trait Rows {
    /// F_ij from patch `i` to each patch j, as many as there are patches.
    fn row(&mut self, i: usize) -> &[f64];
}

/// All form factors, stored row by row: F_ij, from i to j, is at `i * patches + j`.
#[derive(Clone, Debug)]
pub struct Matrix<'a> {
    f: &'a [f64],
    patches: usize,
    /// Σ_j |F_ij|.
    row_sums: Vec<f64>,
}

impl<'a> Matrix<'a> {
    /// Errors: an `f` that has not `patches`² entries, or one that is not finite.
    pub fn new(f: &'a [f64], patches: usize) -> Result<Self, Unsolved> {
        if patches.checked_mul(patches) != Some(f.len()) {
            return Err(Unsolved::Sizes {
                what: "form factors",
                found: f.len(),
                patches,
            });
        }
        let rows = (0..patches).map(|i| &f[i * patches..(i + 1) * patches]);
        let row_sums: Vec<f64> = rows.map(absolute_sum).collect();
        match row_sums.iter().position(|sum| !sum.is_finite()) {
            Some(patch) => Err(Unsolved::Input {
                what: "row sum of form factors",
                patch,
                value: row_sums[patch],
            }),
            None => Ok(Matrix {
                f,
                patches,
                row_sums,
            }),
        }
    }

    pub fn patches(&self) -> usize {
        self.patches
    }

    /// F_ij for every j.
    pub fn of(&self, i: usize) -> &'a [f64] {
        &self.f[i * self.patches..(i + 1) * self.patches]
    }

    /// Σ_j |F_ij| for every i.
    pub fn row_sums(&self) -> &[f64] {
        &self.row_sums
    }
}

impl Rows for &Matrix<'_> {
    fn row(&mut self, i: usize) -> &[f64] {
        self.of(i)
    }
}

/// The patches in one channel: area, reflectance and emitted radiant exitance of each.
#[derive(Clone, Copy, Debug)]
pub struct Patches<'a> {
    pub(super) area: &'a [f64],
    pub(super) rho: &'a [f64],
    pub(super) emission: &'a [f64],
    /// Whether patches that reflect nothing, B = E, gather although they need not.
    black_rows: bool,
}

impl<'a> Patches<'a> {
    /// Errors: lists of different lengths, an area that is not positive, a reflectance outside [0, 1], anything that is not finite.
    pub fn new(area: &'a [f64], rho: &'a [f64], emission: &'a [f64]) -> Result<Self, Unsolved> {
        let patches = area.len();
        for (what, list) in [("reflectances", rho), ("emissions", emission)] {
            if list.len() != patches {
                return Err(Unsolved::Sizes {
                    what,
                    found: list.len(),
                    patches,
                });
            }
        }
        refuse("area", area, |a| a > 0.0 && a.is_finite())?;
        refuse("reflectance", rho, |rho| (0.0..=1.0).contains(&rho))?;
        refuse("emission", emission, f64::is_finite)?;
        Ok(Patches {
            area,
            rho,
            emission,
            black_rows: false,
        })
    }

    /// The same, with or without the equations of patches that reflect nothing: B = E.
    pub fn with_black_rows(self, black_rows: bool) -> Self {
        Patches { black_rows, ..self }
    }

    /// Whether there is something to be found out about patch `i`.
    pub(super) fn gathers(&self, i: usize) -> bool {
        self.black_rows || self.rho[i] > 0.0
    }

    pub fn len(&self) -> usize {
        self.area.len()
    }

    pub fn is_empty(&self) -> bool {
        self.area.is_empty()
    }
}

/// Refuses the first value that is not `right`.
fn refuse(what: &'static str, values: &[f64], right: impl Fn(f64) -> bool) -> Result<(), Unsolved> {
    match values.iter().position(|&value| !right(value)) {
        Some(patch) => Err(Unsolved::Input {
            what,
            patch,
            value: values[patch],
        }),
        None => Ok(()),
    }
}

/// (I − ρF)B = E.
#[derive(Clone, Copy, Debug)]
pub struct System<'a> {
    pub(super) matrix: &'a Matrix<'a>,
    pub(super) patches: Patches<'a>,
}

impl<'a> System<'a> {
    /// Errors: a matrix for another number of patches.
    pub fn new(matrix: &'a Matrix<'a>, patches: Patches<'a>) -> Result<Self, Unsolved> {
        if matrix.patches() != patches.len() {
            return Err(Unsolved::Sizes {
                what: "rows of form factors",
                found: matrix.patches(),
                patches: patches.len(),
            });
        }
        Ok(System { matrix, patches })
    }

    pub fn patches(&self) -> &Patches<'a> {
        &self.patches
    }

    pub fn matrix(&self) -> &'a Matrix<'a> {
        self.matrix
    }

    /// max_i ρ_i Σ_j F_ij: a bound on the spectral radius of ρF, and on what one more reflection leaves.
    pub fn gain(&self) -> f64 {
        gain(self.patches.rho, self.matrix.row_sums())
    }

    /// r = E − (I − ρF)B, written to `r`.
    pub(super) fn residual(&self, b: &[f64], r: &mut [f64]) {
        residual(&mut { self.matrix }, &self.patches, b, r);
    }
}

/// max_i ρ_i Σ_j F_ij.
pub(super) fn gain(rho: &[f64], row_sums: &[f64]) -> f64 {
    zip(rho, row_sums)
        .map(|(rho, sum)| rho * sum)
        .fold(0.0, f64::max)
}

/// r = E − (I − ρF)B, written to `r`. The row of a patch that reflects nothing is not computed.
pub(super) fn residual(rows: &mut impl Rows, patches: &Patches, b: &[f64], r: &mut [f64]) {
    for i in 0..b.len() {
        let reflected = match patches.gathers(i) {
            false => 0.0,
            true => patches.rho[i] * gather(rows.row(i), b, &mut Unrecorded),
        };
        r[i] = patches.emission[i] + reflected - b[i];
    }
}

/// Partial sums that a processor keeps side by side.
const LANES: usize = 8;

/// Σ_j F_ij B_j, in eight sums side by side, of which the running total is recorded. Recorded or not, the order is the same.
#[inline(always)]
pub(super) fn gather<R: Recorder<SolverEvent>>(row: &[f64], b: &[f64], recorder: &mut R) -> f64 {
    let mut sums = [0.0; LANES];
    let (rows, row_rest) = row.as_chunks::<LANES>();
    let (bs, b_rest) = b.as_chunks::<LANES>();
    let mut exchange = |sums: &mut [f64; LANES], j: usize, f_ij: f64, b_j: f64| {
        let product = f_ij * b_j;
        sums[j % LANES] += product;
        recorder.step(|| SolverEvent::Exchanged {
            j: j as u32,
            f_ij,
            b_j,
            product,
            sum: total(sums),
        });
    };
    for (chunk, (f, b)) in zip(rows, bs).enumerate() {
        for lane in 0..LANES {
            exchange(&mut sums, chunk * LANES + lane, f[lane], b[lane]);
        }
    }
    for (lane, (&f, &b)) in zip(row_rest, b_rest).enumerate() {
        exchange(&mut sums, rows.len() * LANES + lane, f, b);
    }
    total(&sums)
}

fn absolute_sum(row: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (chunks, rest) = row.as_chunks::<LANES>();
    for chunk in chunks {
        for lane in 0..LANES {
            sums[lane] += chunk[lane].abs();
        }
    }
    total(&sums) + rest.iter().map(|f| f.abs()).sum::<f64>()
}

#[inline(always)]
fn total([a, b, c, d, e, f, g, h]: &[f64; LANES]) -> f64 {
    ((a + b) + (c + d)) + ((e + f) + (g + h))
}
