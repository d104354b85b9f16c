//! The normal at a vertex: the mean of the unit normals of the faces around it, of unit length again
//! (Gouraud 1971, §III): N_v = Σ N_k / |Σ N_k|, unweighted, over the faces of one object that share the place.

use crate::record::Recorder;
use crate::scene::Mesh;
use glam::DVec3;

/// Below this length the face normals cancel out and their sum points nowhere: a rounding error of the sum itself.
pub(super) const VANISHED: f64 = 1e-12;

/// The unit normal at a vertex, in world coordinates. Faces without area do not count. Where the sum vanishes
/// (two faces back to back, say) the normal of the first face is taken.
pub fn vertex_normal<E: From<Event>>(
    mesh: &Mesh,
    vertex: u32,
    recorder: &mut impl Recorder<E>,
) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for &face in mesh.faces_around(vertex) {
        let normal = mesh.normal(face as usize);
        sum += normal;
        recorder.step(|| Event::FaceNormalAdded { face, normal, sum }.into());
    }
    let faces = mesh.faces_around(vertex).len();
    let length = sum.length();
    if length > VANISHED {
        let normal = sum / length;
        recorder.step(|| {
            Event::VertexNormal {
                faces: faces as u32,
                length,
                normal,
            }
            .into()
        });
        normal
    } else {
        let mut normals = mesh
            .faces_around(vertex)
            .iter()
            .map(|&face| mesh.normal(face as usize));
        let normal = normals
            .find(|&normal| normal != DVec3::ZERO)
            .unwrap_or(DVec3::Z);
        recorder.step(|| {
            Event::NormalVanished {
                faces: faces as u32,
                length,
                normal,
            }
            .into()
        });
        normal
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// `face` counts within the object; `sum` is ΣN_k so far.
    FaceNormalAdded {
        face: u32,
        normal: DVec3,
        sum: DVec3,
    },
    /// How many faces share the vertex, and |ΣN_k|.
    VertexNormal {
        faces: u32,
        length: f64,
        normal: DVec3,
    },
    /// The face normals cancel out: the first one is used instead.
    NormalVanished {
        faces: u32,
        length: f64,
        normal: DVec3,
    },
}
