//! The parts of a mesh that are bodies of their own, and may share a face.

use super::super::Mesh;
use super::closed::edges_of;

/// By face, the part that it is of: faces hold together across edges that they share with no third. Empty where all of them do.
pub(super) fn shells(mesh: &Mesh) -> Vec<u32> {
    const NONE: u32 = u32::MAX;
    let mut shells = vec![NONE; mesh.face_count()];
    let mut count = 0;
    for start in 0..shells.len() {
        if shells[start] != NONE {
            continue;
        }
        shells[start] = count;
        let mut reached = vec![start];
        while let Some(face) = reached.pop() {
            for edge in edges_of(mesh, face) {
                let [a, b] = along(mesh, edge)[..] else {
                    continue;
                };
                for neighbour in [a, b] {
                    if shells[neighbour] == NONE {
                        shells[neighbour] = count;
                        reached.push(neighbour);
                    }
                }
            }
        }
        count += 1;
    }
    if count > 1 { shells } else { Vec::new() }
}

/// The faces that run along an edge, in either sense.
fn along(mesh: &Mesh, [from, to]: [u32; 2]) -> Vec<usize> {
    let around = mesh.faces_around(from).iter().map(|&face| face as usize);
    around
        .filter(|&face| edges_of(mesh, face).any(|edge| edge == [from, to] || edge == [to, from]))
        .collect()
}
