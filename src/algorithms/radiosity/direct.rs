//! Elimination: (I − ρF) is factorised once, P(I − ρF) = LU with partial pivoting, and solved for the residual; a second
//! iteration, should one be needed, refines the result (Golub & Van Loan, "Matrix Computations", §3.4 and §3.5.3).

use super::Solver;
use super::event::{Event, SolverEvent};
use super::iterate::Method;
use super::outcome::{Solution, Unsolved};
use super::record_filter::Followed;
use super::solver::{Problem, Properties};
use super::system::System;
use crate::numeric::Lu;
use crate::record::{Listing, Recorder};

pub static PSEUDOCODE: Listing = Listing {
    name: "direct",
    lines: &[
        ("start started", "P (I − ρF) = L U;  B ← E"),
        (
            "iteration",
            "{for} k = 0, 1, … {until} ‖r‖ ≤ ε‖E‖, r = E − (I − ρF)B",
        ),
        ("", "  {solve} L U d = P r"),
        ("updated", "  B ← B + d"),
    ],
};

pub(super) const SOLVER: Properties = Properties {
    multiplications: |n| n * n * n / 3.0,
    ..Properties::new("direct", "LU", &PSEUDOCODE)
};

pub(super) fn solve<R: Recorder<Event>>(
    problem: &Problem,
    recorder: &mut R,
) -> Result<Solution, Unsolved> {
    let method = Direct::new(problem.system);
    problem.run(Solver::Direct, method, recorder)
}

pub(super) struct Direct<'a> {
    system: System<'a>,
    lu: Option<Lu>,
    /// The patches whose light is unknown: of the others B = E.
    unknown: Vec<usize>,
    b: Vec<f64>,
    r: Vec<f64>,
}

impl<'a> Direct<'a> {
    pub fn new(system: System<'a>) -> Self {
        let b = system.patches.emission.to_vec();
        let mut r = vec![0.0; b.len()];
        system.residual(&b, &mut r);
        Direct {
            system,
            lu: None,
            unknown: (0..r.len())
                .filter(|&i| system.patches.gathers(i))
                .collect(),
            b,
            r,
        }
    }
}

/// LU of the rows and columns of I − ρF that belong to `unknown` patches.
fn factorise(system: &System, unknown: &[usize]) -> Lu {
    let rho = system.patches.rho;
    let mut a = Vec::with_capacity(unknown.len() * unknown.len());
    for &i in unknown {
        let f = system.matrix.of(i);
        a.extend(unknown.iter().map(|&j| {
            let diagonal = if i == j { 1.0 } else { 0.0 };
            diagonal - rho[i] * f[j]
        }));
    }
    Lu::new(unknown.len(), a)
}

impl Method for Direct<'_> {
    fn iterate<R: Recorder<SolverEvent>>(
        &mut self,
        _: Followed,
        recorder: &mut R,
    ) -> Result<(), Unsolved> {
        let lu = self
            .lu
            .get_or_insert_with(|| factorise(&self.system, &self.unknown));
        let r: Vec<f64> = self.unknown.iter().map(|&i| self.r[i]).collect();
        let d = lu.solve(&r);
        for (k, &i) in self.unknown.iter().enumerate() {
            let b_old = self.b[i];
            self.b[i] += d[k];
            recorder.step(|| SolverEvent::Updated {
                i: i as u32,
                b_old,
                b_new: self.b[i],
            });
        }
        self.system.residual(&self.b, &mut self.r);
        Ok(())
    }

    fn radiosity(&self) -> &[f64] {
        &self.b
    }

    fn residual(&self) -> &[f64] {
        &self.r
    }

    fn gain(&self) -> Option<f64> {
        Some(self.system.gain())
    }
}
