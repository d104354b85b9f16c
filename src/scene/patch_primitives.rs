//! The patches of a scene as rays meet them: the facets that exchange light, where the scene itself may be round.

use super::patches::Patches;
use super::primitives::{Hit, Primitives, Ray};
use super::{Mesh, Scene, Shape, Tessellation};
use glam::DVec3;

/// The pieces of all patches, object by object.
#[derive(Clone, Debug)]
pub struct PatchPrimitives {
    primitives: Primitives,
    /// The patch of each triangle, by object.
    owners: Vec<Vec<u32>>,
}

impl PatchPrimitives {
    /// `patches` are those of the scene.
    pub fn of(scene: &Scene, patches: &Patches) -> Self {
        let mut facets = scene.clone();
        let mut meshes: Vec<(Vec<DVec3>, Vec<Vec<u32>>)> =
            vec![Default::default(); scene.objects.len()];
        let mut owners = vec![Vec::new(); scene.objects.len()];
        for (number, patch) in (0_u32..).zip(patches.iter()) {
            let (positions, faces) = &mut meshes[patch.object as usize];
            for piece in patches.pieces(number as usize) {
                let first = positions.len() as u32;
                positions.extend(piece.corners);
                faces.push((first..positions.len() as u32).collect());
                let triangles = piece.corners.len() - 2;
                owners[patch.object as usize].extend(std::iter::repeat_n(number, triangles));
            }
        }
        for (object, (positions, faces)) in facets.objects.iter_mut().zip(meshes) {
            object.shape = Shape::Mesh(Mesh::new(&positions, faces, &[]));
        }
        PatchPrimitives {
            primitives: Primitives::of(&facets, &Tessellation::of(&facets)),
            owners,
        }
    }

    /// The patch that a ray meets first, and where.
    pub fn nearest(&self, ray: &Ray) -> Option<(usize, Hit)> {
        let hit = self.primitives.nearest(ray)?;
        let patch = self.owners[hit.object as usize][hit.triangle as usize];
        Some((patch as usize, hit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Limits, read};

    #[test]
    fn a_ray_toward_the_middle_of_a_patch_meets_that_patch() {
        let json = r#"{ "schema": 1, "materials": { "m": {} }, "objects": [
            { "name": "sheet", "material": "m", "patches": [3, 2],
              "polygon": { "vertices": [[0, 0, 0], [3, 0, 0], [3, 2, 0.5], [0, 2, 0]] } },
            { "name": "ball", "material": "m", "patches": [8, 4], "sphere": { "center": [9, 0, 0], "radius": 1 } },
            { "name": "star", "material": "m",
              "polygon": { "vertices": [[20, 0, 0], [24, 0, 0], [21, 1, 0], [20, 4, 0], [20, 2, 0]] } } ] }"#;
        let scene = read(json.as_bytes(), &Limits::default(), &mut |_| unreachable!()).unwrap();
        let patches = Patches::of(&scene, 1000).unwrap();
        let primitives = PatchPrimitives::of(&scene, &patches);
        for patch in 0..patches.len() {
            for piece in patches.pieces(patch) {
                let middle = piece.corners.iter().sum::<DVec3>() / piece.corners.len() as f64;
                let ray = Ray {
                    origin: middle + 1e-3 * piece.normal,
                    direction: -piece.normal,
                };
                assert_eq!(
                    primitives.nearest(&ray).map(|(patch, _)| patch),
                    Some(patch)
                );
            }
        }
    }
}
