//! The share of what two patches would exchange that nothing blocks: by exact clipping, or where that takes too long, by rays.

use super::occlusion::{self, Passing};
use super::polygon::Polygon;
use super::sample::Sample;
use super::view::{Blocker, Seen, View};
use super::visibility::{Between, Blockers};
use super::{Event, facing, sampled, shaft};
use crate::record::Recorder;
use crate::scene::patches::Patches;

/// Above so many faces between two patches, rays are cheaper than exact clipping. Measured on a ball in a cube with one patch a wall: 512
/// facets take 4 s exactly, with rows within 3e-5 of 1; 2048 facets take 26 s, or 1.4 s by rays with rows within 8e-3.
const MOST_FACES: usize = 512;

/// How many points each way a glimpse is taken from.
const POINTS: usize = 2;

impl Blockers {
    /// The share of what i and j would exchange that nothing blocks, and an estimate of its error. `f` is the larger of their form factors if
    /// nothing did. With `forced`, it is looked for where nothing can, too.
    pub fn share<R: Recorder<Event>>(
        &self,
        patches: &Patches,
        [i, j]: [usize; 2],
        f: f64,
        forced: bool,
        recorder: &mut R,
    ) -> [f64; 2] {
        let faces = match self.between(i, j) {
            Between::Nothing if forced => Vec::new(),
            Between::Nothing => return [1.0, 0.0],
            Between::Everything => {
                recorder.step(|| Event::Visible {
                    rays: 0,
                    share: 0.0,
                });
                return [0.0, 0.0];
            }
            Between::Faces(faces) => faces,
            Between::TooMany => return sampled::share(self, patches, [i, j], f, recorder),
        };
        let mut pairs = Vec::new();
        for piece_i in self.polygons(patches, i) {
            for piece_j in self.polygons(patches, j) {
                if let Some([a, b]) = facing(piece_i.clone(), piece_j) {
                    let blockers = self.in_front(&a, &b, &faces);
                    pairs.push((a, b, blockers));
                }
            }
        }
        let most = pairs.iter().map(|(.., blockers)| blockers.len()).max();
        match most.unwrap_or(0) {
            0 if !forced => return [1.0, 0.0],
            n if n > MOST_FACES => return sampled::share(self, patches, [i, j], f, recorder),
            _ => {}
        }
        let mut sum = Passing::default();
        for (a, b, blockers) in pairs {
            let passing = self.passing(a, b, &blockers, recorder);
            sum.whole += passing.whole;
            sum.visible += passing.visible;
            sum.error += passing.error;
            sum.points += passing.points;
        }
        let [share, error] = match sum.whole > 0.0 {
            true => [sum.visible / sum.whole, sum.error / sum.whole],
            false => [0.0, 0.0],
        };
        recorder.step(|| Event::Visible {
            rays: sum.points,
            share,
        });
        [share, error]
    }

    /// The share of what two polygons in front of each other would exchange that nothing blocks, as a few points see it. None where one face
    /// hides all of the one from all of the other.
    pub fn glimpse(&self, a: &Polygon, b: &Polygon) -> Option<f64> {
        let (receiver, source) = if a.area <= b.area { (a, b) } else { (b, a) };
        let mut sum = Seen::default();
        match self.between_polygons(a, b) {
            Between::Nothing => return Some(1.0),
            Between::Everything => return None,
            Between::Faces(faces) => {
                let blockers = self.in_front(a, b, &faces);
                let mut view = View::default();
                receiver.points(POINTS, |x, weight| {
                    let seen = view.of(x, receiver.normal, &source.corners, &blockers, self.slack);
                    sum.whole += weight * seen.whole;
                    sum.visible += weight * seen.visible;
                });
            }
            Between::TooMany => receiver.points(POINTS, |x, weight_x| {
                source.points(POINTS, |y, weight_y| {
                    let [x, y] = [(x, receiver.normal), (y, source.normal)]
                        .map(|(point, normal)| Sample { point, normal });
                    sum.whole += weight_x * weight_y;
                    if !self.stand_between(&x, &y) {
                        sum.visible += weight_x * weight_y;
                    }
                });
            }),
        }
        Some(if sum.whole > 0.0 {
            sum.visible / sum.whole
        } else {
            0.0
        })
    }

    /// What of the faces lies in front of two polygons that lie in front of each other.
    fn in_front(&self, a: &Polygon, b: &Polygon, faces: &[usize]) -> Vec<Blocker> {
        let part = |&face: &usize| {
            let Blocker { corners, normal } = &self.faces[face].outline;
            let whole = Polygon::new(corners.into(), *normal)?;
            let part = whole
                .in_front_of(a, self.slack)?
                .in_front_of(b, self.slack)?;
            Some(Blocker {
                corners: part.corners.into_owned(),
                normal: *normal,
            })
        };
        let mut blockers: Vec<Blocker> = faces.iter().filter_map(part).collect();
        // What stands between the centres hides the most. It comes first, so that little is left to be divided.
        blockers.sort_by_key(|blocker| !blocker.is_met(a.center, b.center));
        blockers
    }

    /// What passes between two polygons that lie in front of each other, the blockers in front of both.
    fn passing<R: Recorder<Event>>(
        &self,
        a: Polygon,
        b: Polygon,
        blockers: &[Blocker],
        recorder: &mut R,
    ) -> Passing {
        let spreads = shaft::spreads(&a, &b, blockers);
        let (receiver, source, spread) = match spreads[0] >= spreads[1] {
            true => (a, b, spreads[0]),
            false => (b, a, spreads[1]),
        };
        // Through the gaps of a grating, what is seen jumps about as often as there are bars.
        let bars = shaft::most_in_a_plane(blockers, self.slack);
        let cells = if bars > 2 { bars as f64 } else { 1.0 };
        let grid = (1.0 / spread).max(cells).clamp(1.0, 6.0).ceil() as u32;
        let parts = shaft::divided(receiver, blockers, self.slack);
        occlusion::passing(&parts, &source, blockers, grid, self.slack, recorder)
    }
}
