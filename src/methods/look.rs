//! How methods and solvers look wherever several are told apart: each has one colour, dash and mark in every lesson, panel and study.

use super::Method;
use crate::algorithms::radiosity::Solver;
use crate::figure::Series;

impl Method {
    pub fn series(self) -> Series {
        Series::of(self as usize)
    }
}

impl Solver {
    pub fn series(self) -> Series {
        Series::of(self as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All that can stand in one plot: wireframe shades nothing, radiosity is compared with no method that draws pixels, and the automatic
    /// choice is one of the others.
    #[test]
    fn what_stands_in_one_plot_has_colours_of_its_own() {
        let methods = Method::ALL.into_iter();
        let methods =
            methods.filter(|&method| method.draws_pixels() && method != Method::Wireframe);
        let solvers = Solver::ALL.into_iter();
        let solvers = solvers.filter(|&solver| solver != Solver::Auto);
        let looks: [Vec<Series>; 2] = [
            methods.map(Method::series).collect(),
            solvers.map(Solver::series).collect(),
        ];
        for looks in looks {
            for (i, look) in looks.iter().enumerate() {
                let alike = |other: &&Series| other.ink == look.ink;
                assert_eq!(looks[..i].iter().find(alike).map(|other| other.mark), None);
            }
        }
    }
}
