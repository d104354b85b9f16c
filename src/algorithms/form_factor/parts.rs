//! The parts of patches that light comes to.

use super::closed::{self, Closed};
use super::polygon::{Polygon, polygons};
use super::visibility::Blockers;
use crate::scene::patches::Patches;
use glam::DVec3;

impl Blockers {
    /// What can be said of the patches where they close the scene in, found on first use.
    pub fn closed(&self, patches: &Patches) -> Option<&Closed> {
        let find = || {
            // Walls given twice count once; but where blocks pass through each other, each has the whole of a face that both have.
            let mut sheets = self.sheets.iter().filter(|_| self.all_block());
            sheets.find_map(|sheets| closed::closed(patches, &self.exposed, sheets, self.slack))
        };
        self.closed.get_or_init(find).as_ref()
    }

    /// A_i F_ij of patches that lie on each other face to face in a closed scene.
    pub fn contact(&self, patches: &Patches, i: usize, j: usize) -> Option<f64> {
        self.closed(patches)?.contact(i, j)
    }

    /// The parts of a patch that light comes to: that no other one lies on, and in a closed scene, that lie in the room. None where that is all
    /// of it.
    fn parts(&self, patches: &Patches, patch: usize) -> Option<&Vec<Polygon<'static>>> {
        let lit = self.closed(patches).and_then(|closed| closed.lit(patch));
        lit.or(self.exposed[patch].as_ref())
    }

    /// The convex parts of a patch that light comes to.
    pub fn polygons<'a>(&'a self, patches: &'a Patches, patch: usize) -> Vec<Polygon<'a>> {
        match self.parts(patches, patch) {
            Some(parts) => parts.clone(),
            None => polygons(patches, patch).collect(),
        }
    }

    /// Whether light comes to all of a patch.
    pub fn is_bare(&self, patches: &Patches, patch: usize) -> bool {
        self.parts(patches, patch).is_none()
    }

    /// Whether light comes to a point of a patch.
    pub fn is_exposed(&self, patches: &Patches, patch: usize, point: DVec3) -> bool {
        let Some(parts) = self.parts(patches, patch) else {
            return true;
        };
        parts.iter().any(|part| {
            part.edges()
                .all(|[from, to]| (to - from).cross(point - from).dot(part.normal) >= 0.0)
        })
    }
}
