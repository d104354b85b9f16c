//! The normal at a vertex: the mean of the unit normals of the faces around it, of unit length again
//! (Gouraud 1971, §III): N_v = Σ N_k / |Σ N_k|, unweighted, over the faces of one object that share the place.
//!
//! At a hard edge the mean is wrong on both sides. There each face has a vertex normal of its own: the mean over the faces that it meets
//! at no more than the crease angle, its own normal, or that of the mesh file.

use crate::record::Recorder;
use crate::scene::{Mesh, VertexNormals};
use glam::DVec3;
use std::f64::consts::PI;

/// Below this length the face normals cancel out and their sum points nowhere: a rounding error of the sum itself.
pub(super) const VANISHED: f64 = 1e-12;

/// Angles that differ by less count as equal: faces of a cube meet at 90°, whatever the rounding of their normals.
const SAME_ANGLE: f64 = 1e-9;

/// A corner of a face, counted from 0 along its border.
#[derive(Clone, Copy, Debug)]
pub struct FaceCorner<'a> {
    pub mesh: &'a Mesh,
    pub face: usize,
    pub corner: usize,
}

/// The unit normal at a corner of a face, in world coordinates. Faces without area do not count. Where the sum vanishes
/// (two faces back to back, say) the normal of the first face is taken.
pub fn vertex_normal<E: From<Event>>(
    at: FaceCorner,
    normals: VertexNormals,
    recorder: &mut impl Recorder<E>,
) -> DVec3 {
    let FaceCorner { mesh, face, corner } = at;
    let vertex = mesh.face(face)[corner];
    let around = mesh.faces_around(vertex);
    let own = [face as u32];
    match normals {
        VertexNormals::Face => mean_normal(mesh, own, recorder),
        VertexNormals::File => match mesh.face_normals(face).get(corner) {
            Some(&normal) if normal != DVec3::ZERO => {
                recorder.step(|| Event::FileNormal { normal }.into());
                normal
            }
            _ => mean_normal(mesh, around.iter().copied(), recorder),
        },
        VertexNormals::Averaged { crease } if crease < PI => {
            let meets = |other: &u32| {
                let (a, b) = (mesh.normal(face), mesh.normal(*other as usize));
                a.cross(b).length().atan2(a.dot(b)) <= crease + SAME_ANGLE
            };
            mean_normal(mesh, around.iter().copied().filter(meets), recorder)
        }
        VertexNormals::Averaged { .. } => mean_normal(mesh, around.iter().copied(), recorder),
    }
}

/// The mean over `faces`.
fn mean_normal<E: From<Event>>(
    mesh: &Mesh,
    faces: impl IntoIterator<Item = u32>,
    recorder: &mut impl Recorder<E>,
) -> DVec3 {
    let (mut sum, mut first, mut faces_added) = (DVec3::ZERO, DVec3::ZERO, 0);
    for face in faces {
        let normal = mesh.normal(face as usize);
        sum += normal;
        faces_added += 1;
        if first == DVec3::ZERO {
            first = normal;
        }
        recorder.step(|| Event::FaceNormalAdded { face, normal, sum }.into());
    }
    let (faces, length) = (faces_added, sum.length());
    if length > VANISHED {
        let normal = sum / length;
        recorder.step(|| {
            Event::VertexNormal {
                faces,
                length,
                normal,
            }
            .into()
        });
        normal
    } else {
        let normal = if first == DVec3::ZERO {
            DVec3::Z
        } else {
            first
        };
        recorder.step(|| {
            Event::NormalVanished {
                faces,
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
    /// The normal that the mesh file gives the corner.
    FileNormal { normal: DVec3 },
    /// The face normals cancel out: the first one is used instead.
    NormalVanished {
        faces: u32,
        length: f64,
        normal: DVec3,
    },
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Unrecorded;

    /// A floor, a wall, and a ramp up at 30° to the floor, around the vertex at the origin; the floor's normal in the file leans.
    fn corner_of_room() -> Mesh {
        let (sin, cos) = 30_f64.to_radians().sin_cos();
        let positions = [
            DVec3::ZERO,
            DVec3::X,
            DVec3::NEG_Z,
            DVec3::Y,
            DVec3::new(-cos, sin, 0.0),
        ];
        let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 4]];
        let mut normals = [DVec3::ZERO; 9];
        normals[0] = DVec3::new(0.6, 0.8, 0.0);
        Mesh::with_normals(&positions, faces, &[], &normals)
    }

    fn normal(face: usize, normals: VertexNormals) -> DVec3 {
        let mesh = &corner_of_room();
        let at = FaceCorner {
            mesh,
            face,
            corner: 0,
        };
        vertex_normal::<Event>(at, normals, &mut Unrecorded)
    }

    fn creased(face: usize, degrees: f64) -> DVec3 {
        let crease = degrees.to_radians();
        normal(face, VertexNormals::Averaged { crease })
    }

    fn is_near(found: DVec3, sum: DVec3) {
        assert!(found.distance(sum.normalize()) < 1e-15, "{found} {sum}");
    }

    #[test]
    fn faces_beyond_the_crease_angle_do_not_count() {
        let mesh = corner_of_room();
        let [floor, wall, ramp] = [0, 1, 2].map(|face| mesh.normal(face));
        is_near(floor, DVec3::Y);
        is_near(wall, DVec3::NEG_Z);
        for face in 0..3 {
            is_near(normal(face, VertexNormals::Face), mesh.normal(face));
            is_near(creased(face, 29.0), mesh.normal(face));
            is_near(creased(face, 180.0), floor + wall + ramp);
            is_near(creased(face, 90.0), floor + wall + ramp);
        }
        // Exactly at the angle counts; the wall stays alone.
        is_near(creased(0, 30.0), floor + ramp);
        is_near(creased(2, 30.0), floor + ramp);
        is_near(creased(1, 89.0), wall);
        assert_eq!(
            VertexNormals::AVERAGED,
            VertexNormals::Averaged {
                crease: 180_f64.to_radians()
            }
        );
    }

    #[test]
    fn corners_without_a_normal_in_the_file_take_the_mean() {
        is_near(normal(0, VertexNormals::File), DVec3::new(0.6, 0.8, 0.0));
        let mean = normal(1, VertexNormals::AVERAGED);
        assert_eq!(normal(1, VertexNormals::File), mean);
    }
}
