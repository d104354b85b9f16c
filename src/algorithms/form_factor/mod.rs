//! Form factors: F_ij is the share of the light that leaves patch i and arrives at patch j. A file a method.
//!
//! | file | method | source |
//! | --- | --- | --- |
//! | [`area_to_area`] | the double area integral at Gauss points | Goral et al. 1984 |
//! | [`element_to_polygon`] | exact from an element, Gauss points over i | Lambert 1760, Baum et al. 1989 |
//! | [`contour`] | the double contour integral | Sparrow 1963 |
//! | [`monte_carlo`] | rays of a cosine distribution | Malley 1988 |
//! | [`hemicube`] | a half cube of pixels | Cohen & Greenberg 1985 |
//! | [`auto`], [`far_field`] | the cheapest of the first three that is exact enough | |
//!
//! The first three and their choice compute the exchange A_i F_ij = A_j F_ji (reciprocity), once a pair, between those parts of the patches
//! that lie in front of each other. [`visibility`] says how much of it passes what stands between.

pub mod area_to_area;
pub mod auto;
mod batches;
pub mod closed;
pub mod closure;
mod coincident;
pub mod contour;
pub mod element_to_polygon;
mod errors;
mod event;
mod faces;
pub mod far_field;
pub mod gauss;
mod groups;
pub mod hemicube;
mod method;
pub mod monte_carlo;
mod occlusion;
mod parts;
pub mod polygon;
pub mod report;
pub mod sample;
pub mod sampled;
mod shaft;
mod share;
mod sheet;
mod shortcuts;
pub mod sobol;
pub mod through;
mod view;
pub mod visibility;

pub use errors::{Estimated, PairError};
pub use event::{Event, PSEUDOCODE};
pub use method::Method;
pub use report::Report;
pub use shortcuts::Shortcuts;
pub use visibility::Blockers;

use crate::record::{Recorder, Unrecorded};
use crate::scene::patches::Patches;
use far_field::Far;
use polygon::Polygon;
use std::ops::Range;

/// Gauss points each way between patches that face away from each other.
const POINTS_AWAY: usize = 4;

/// The form factors of a scene, one at a time, by the row, or by the block of rows.
#[derive(Clone, Debug)]
pub struct FormFactors<'a> {
    patches: &'a Patches,
    method: Method,
    /// None: nothing stands between patches, whatever the scene.
    blockers: Option<&'a Blockers>,
    far: Far,
    shortcuts: Shortcuts,
}

impl<'a> FormFactors<'a> {
    pub fn new(patches: &'a Patches, method: Method, blockers: Option<&'a Blockers>) -> Self {
        FormFactors {
            patches,
            method,
            blockers,
            far: Far::of(patches),
            shortcuts: Shortcuts::default(),
        }
    }

    /// The same, with those shortcuts alone.
    pub fn with_shortcuts(self, shortcuts: Shortcuts) -> Self {
        FormFactors { shortcuts, ..self }
    }

    /// Whether no light passes between two patches because one lies behind the other or in its plane, or is the same.
    pub fn face_away(&self, i: usize, j: usize) -> bool {
        if self.contact(i, j).is_some() {
            return false;
        }
        let others = self.polygons(j);
        let faces = |a: &Polygon| {
            others
                .iter()
                .any(|b| facing(a.clone(), b.clone()).is_some())
        };
        !self.polygons(i).iter().any(faces)
    }

    /// F_ij.
    pub fn pair<R: Recorder<Event>>(&self, i: usize, j: usize, recorder: &mut R) -> f64 {
        let method = self.method.name();
        recorder.enter(|| Event::FormFactor {
            i: i as u32,
            j: j as u32,
            method,
        });
        let area = self.patches[i].area;
        let contact = self.contact(i, j);
        let f = match self.method {
            _ if i == j && self.patches.pieces(i).len() == 1 => 0.0,
            _ if contact.is_some() => contact.unwrap_or_default() / area,
            Method::MonteCarlo { rays, seed } => {
                monte_carlo::form_factor(self.patches, [i, j], rays, seed, self.blockers, recorder)
            }
            Method::Hemicube(hemicubes) => {
                hemicubes.form_factor(self.patches, [i, j], self.blockers, recorder)
            }
            _ => {
                let exchange = self.unblocked(i, j, recorder);
                let [share, _] = match self.blockers {
                    Some(blockers) if exchange > 0.0 => {
                        self.passing(blockers, [i, j], exchange, recorder)
                    }
                    _ => [1.0, 0.0],
                };
                exchange * share / area
            }
        };
        recorder.leave(|| Event::FormFactorFound {
            exchange: area * f,
            f,
        });
        f
    }

    /// F_ij for every j. `row` has one entry a patch.
    pub fn row(&self, i: usize, row: &mut [f64]) {
        match self.method {
            Method::Hemicube(hemicubes) => {
                hemicubes.row(self.patches, i, self.blockers, row);
                for (j, f) in row.iter_mut().enumerate() {
                    if let Some(contact) = self.contact(i, j) {
                        *f = contact / self.patches[i].area;
                    }
                }
            }
            Method::MonteCarlo { .. } => {
                for (j, f) in row.iter_mut().enumerate() {
                    *f = self.pair(i, j, &mut Unrecorded);
                }
            }
            _ => {
                self.exchanges(i, 0, row, &mut Vec::new());
                let area = self.patches[i].area;
                row.iter_mut().for_each(|f| *f /= area);
            }
        }
    }

    /// Rows of the matrix, row-major in `block`. Of reciprocal methods only F_ij with j ≥ i: [`Self::complete`] makes the rest of it.
    /// Returns the pairs whose visibility is not exact, for [`Self::row_errors`].
    pub fn block(&self, rows: Range<usize>, block: &mut [f64]) -> Vec<PairError> {
        let n = self.patches.len();
        let mut errors = Vec::new();
        for (i, row) in rows.zip(block.chunks_mut(n.max(1))) {
            if self.method.is_reciprocal() {
                self.exchanges(i, i, &mut row[i..], &mut errors);
                let area = self.patches[i].area;
                row[i..].iter_mut().for_each(|f| *f /= area);
            } else {
                self.row(i, row);
            }
        }
        errors
    }

    /// F_ji = F_ij A_i / A_j below the diagonal of a whole matrix whose blocks are there.
    pub fn complete(&self, matrix: &mut [f64]) {
        let n = self.patches.len();
        if !self.method.is_reciprocal() {
            return;
        }
        // In tiles that fit the cache, since one side of the copy runs down the columns.
        const TILE: usize = 32;
        for top in (0..n).step_by(TILE) {
            for left in (0..=top).step_by(TILE) {
                for j in top..n.min(top + TILE) {
                    for i in left..j.min(left + TILE) {
                        let share = self.patches[i].area / self.patches[j].area;
                        matrix[j * n + i] = matrix[i * n + j] * share;
                    }
                }
            }
        }
    }

    /// The whole matrix, row-major.
    pub fn matrix(&self) -> Vec<f64> {
        self.estimated().matrix
    }

    /// The whole matrix, with an estimate of its error.
    pub fn estimated(&self) -> Estimated {
        let n = self.patches.len();
        let mut matrix = vec![0.0; n * n];
        let errors = self.block(0..n, &mut matrix);
        self.complete(&mut matrix);
        let row_errors = self.row_errors(&matrix, &errors);
        Estimated { matrix, row_errors }
    }

    /// A_i F_ij for j from `first` on. `errors` takes the pairs whose visibility is not exact.
    fn exchanges(&self, i: usize, first: usize, row: &mut [f64], errors: &mut Vec<PairError>) {
        let end = first + row.len();
        match self.method {
            Method::Auto { tolerance } => self.far.row(i, first..end, tolerance, row),
            _ => row.fill(f64::NAN),
        }
        for (j, exchange) in (first..end).zip(row) {
            if let Some(contact) = self.contact(i, j) {
                *exchange = contact;
                continue;
            }
            let is_away = *exchange == 0.0;
            // What lies on a patch makes it another polygon.
            let is_bare = |blockers: &Blockers| {
                [i, j]
                    .iter()
                    .all(|&patch| blockers.is_bare(self.patches, patch))
            };
            let is_whole = is_away || self.blockers.is_none_or(is_bare);
            if exchange.is_nan() || !is_whole || is_away && !self.shortcuts.facing_away {
                *exchange = self.unblocked(i, j, &mut Unrecorded);
            }
            if let Some(blockers) = self.blockers
                && *exchange > 0.0
            {
                let [share, error] = self.passing(blockers, [i, j], *exchange, &mut Unrecorded);
                if error > 0.0 {
                    errors.push(PairError {
                        i: i as u32,
                        j: j as u32,
                        exchange: error * *exchange,
                    });
                }
                *exchange *= share;
            }
        }
    }

    /// A_i F_ij of patches that lie on each other face to face.
    fn contact(&self, i: usize, j: usize) -> Option<f64> {
        self.blockers?.contact(self.patches, i, j)
    }

    /// The share of an exchange that nothing blocks, and an estimate of the share's error.
    fn passing<R: Recorder<Event>>(
        &self,
        blockers: &Blockers,
        [i, j]: [usize; 2],
        exchange: f64,
        recorder: &mut R,
    ) -> [f64; 2] {
        // The larger of F_ij and F_ji.
        let f = exchange / self.patches[i].area.min(self.patches[j].area);
        blockers.share(
            self.patches,
            [i, j],
            f,
            !self.shortcuts.sight_tests,
            recorder,
        )
    }

    /// The convex parts of a patch, as far as nothing lies on them.
    fn polygons(&self, patch: usize) -> Vec<Polygon<'_>> {
        match self.blockers {
            Some(blockers) => blockers.polygons(self.patches, patch),
            None => polygon::polygons(self.patches, patch).collect(),
        }
    }

    /// A_i F_ij where nothing stands between.
    fn unblocked<R: Recorder<Event>>(&self, i: usize, j: usize, recorder: &mut R) -> f64 {
        let mut sum = 0.0;
        let others = self.polygons(j);
        let mut elements = 0;
        for piece_i in self.polygons(i) {
            for piece_j in &others {
                let Some([a, b]) = facing(piece_i.clone(), piece_j.clone()) else {
                    recorder.step(|| Event::FacesAway);
                    if !self.shortcuts.facing_away {
                        // At every pair of points one of the cosines is 0.
                        let points = [POINTS_AWAY; 2];
                        sum += area_to_area::exchange(&piece_i, piece_j, points, recorder);
                    }
                    continue;
                };
                recorder.step(|| Event::Pieces {
                    corners: [a.corners.len() as u32, b.corners.len() as u32],
                    areas: [a.area, b.area],
                });
                sum += self.exchange(&a, &b, &mut elements, recorder);
            }
        }
        sum
    }

    fn exchange<R: Recorder<Event>>(
        &self,
        a: &Polygon,
        b: &Polygon,
        elements: &mut u32,
        recorder: &mut R,
    ) -> f64 {
        let (small, large) = if a.area <= b.area { (a, b) } else { (b, a) };
        match self.method {
            Method::AreaToArea { points } => {
                area_to_area::exchange(a, b, [points, points], recorder)
            }
            Method::ElementToPolygon { points } => {
                element_to_polygon::exchange(small, large, points, elements, recorder)
            }
            Method::Contour { tolerance } => {
                contour::exchange(a, b, tolerance * small.area, recorder)
            }
            Method::Auto { tolerance } => auto::exchange(a, b, tolerance, elements, recorder),
            Method::MonteCarlo { .. } | Method::Hemicube(_) => 0.0,
        }
    }
}

/// The parts of two polygons that lie in front of each other. None where nothing passes between them.
pub fn facing<'a>(i: Polygon<'a>, j: Polygon<'a>) -> Option<[Polygon<'a>; 2]> {
    let reach = |polygon: &Polygon| polygon.center.abs().max_element() + polygon.radius;
    // As far as rounding may have moved a corner off a plane.
    let slack = 16.0 * f64::EPSILON * reach(&i).max(reach(&j));
    let front_of_i = j.clone().in_front_of(&i, slack)?;
    let front_of_j = i.in_front_of(&j, slack)?;
    Some([front_of_j, front_of_i])
}

#[cfg(test)]
mod tests;
