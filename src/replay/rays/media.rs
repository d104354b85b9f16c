//! The transparent objects that a ray is inside of.

use super::State;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::ray_tree::RayKind;
use crate::color::Rgb;

/// Whether light passes the object at all.
fn transmits(prepared: &PreparedScene, object: u32) -> bool {
    let scene = &prepared.scene;
    let material = scene.objects[object as usize].material;
    scene.materials[material].transmission != Rgb::BLACK
}

/// Outermost first.
pub(super) fn around_eye(prepared: &PreparedScene) -> Vec<u32> {
    let mut around = prepared.primitives().around(prepared.view.eye);
    around.retain(|&object| transmits(prepared, object));
    around
}

impl State {
    pub fn transmits(&self, object: u32) -> bool {
        transmits(&self.prepared, object)
    }

    /// The transparent objects that the ray at `index` of [`State::rays`] is inside, outermost first.
    pub fn media_around(&self, index: usize) -> Vec<u32> {
        let parent = |&index: &usize| self.rays.get(index).and_then(|ray| ray.parent);
        let path: Vec<usize> = std::iter::successors(Some(index), parent).collect();
        let mut media = self.around_eye.to_vec();
        for pair in path.windows(2).rev() {
            let (Some(child), Some(parent)) = (self.rays.get(pair[0]), self.rays.get(pair[1]))
            else {
                continue;
            };
            let crossed = child.kind == RayKind::Transmitted;
            let Some(surface) = parent.surface.filter(|_| crossed) else {
                continue;
            };
            if !self
                .prepared
                .primitives()
                .is_transparent_body(surface.object)
            {
                continue;
            }
            if surface.facing.is_some_and(|(.., entering)| entering) {
                media.push(surface.object);
            } else if let Some(at) = media.iter().rposition(|&inner| inner == surface.object) {
                media.remove(at);
            }
        }
        media
    }
}
