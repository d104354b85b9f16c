//! glTF 2.0 files, binary (.glb) or JSON with embedded buffers (.gltf): the triangles of the default scene, with their normals and first
//! texture coordinates (Khronos Group 2021, "glTF 2.0 Specification", §3.5–3.7).
//!
//! Each node's mesh is placed by the transforms of the node and those above it; the turn of the triangles is kept where a transform
//! mirrors (§3.7.4).

mod accessor;
mod container;
#[cfg(test)]
mod tests;
mod unused;

use super::{MeshData, Remark};
use crate::scene::validate::{LARGEST, unit};
use accessor::Accessors;
use glam::{DAffine3, DMat3, DMat4, DQuat, DVec2, DVec3, Quat, Vec3};
use gltf::mesh::Mode;
use gltf::scene::Transform;
use gltf::{Document, Node, Primitive, Semantic};
use std::collections::HashMap;

/// Errors: what the file is instead, what is wrong in it and where, a buffer in another file, no triangles at all, or more than
/// `max_triangles`, as a sentence.
pub(super) fn read(bytes: &[u8], max_triangles: u64) -> Result<MeshData, String> {
    let container = container::open(bytes)?;
    let mut json = container.json;
    let remarks = unused::removed(&mut json)?;
    let document = container::checked(json)?;
    let buffers = container::buffers(&document, container.blob)?;
    let instances = instances(&document)?;
    let triangles = instances
        .iter()
        .map(|(_, primitive)| count_triangles(primitive))
        .fold(0_u64, u64::saturating_add);
    match triangles {
        0 => {
            return Err(
                "found no triangles in the scene of the file; a mesh needs at least one".into(),
            );
        }
        n if n > max_triangles => {
            return Err(format!(
                "found {n} triangles; at most {max_triangles} are allowed (--max-triangles)"
            ));
        }
        _ => {}
    }
    let mut reader = Reader {
        data: MeshData {
            triangles,
            remarks,
            ..MeshData::default()
        },
        accessors: Accessors::new(&buffers, max_triangles),
        unusable: 0,
        of_others: 0,
    };
    for (to_scene, primitive) in &instances {
        reader
            .take(to_scene, primitive)
            .map_err(|problem| format!("primitive {}: {problem}", primitive.index()))?;
    }
    reader.finish(&instances)
}

/// The triangles' primitives of the scene, each with the transform of its node.
fn instances(document: &Document) -> Result<Vec<(DAffine3, Primitive<'_>)>, String> {
    let scene = document
        .default_scene()
        .or_else(|| document.scenes().next());
    let roots: Vec<Node> = match scene {
        Some(scene) => scene.nodes().collect(),
        None => return Err("found no scene in the file, so nothing of it is shown".into()),
    };
    let mut visited = vec![false; document.nodes().count()];
    let mut instances = Vec::new();
    let mut open: Vec<(DAffine3, Node)> = roots
        .into_iter()
        .rev()
        .map(|node| (DAffine3::IDENTITY, node))
        .collect();
    while let Some((above, node)) = open.pop() {
        if std::mem::replace(&mut visited[node.index()], true) {
            return Err(format!(
                "nodes[{}] stands in two places of the tree; a node has one parent",
                node.index()
            ));
        }
        let to_scene = above * affine(&node.transform());
        let primitives = node.mesh().into_iter().flat_map(|mesh| mesh.primitives());
        let are_triangles = |primitive: &Primitive| count_triangles(primitive) > 0;
        instances.extend(
            primitives
                .filter(are_triangles)
                .map(|primitive| (to_scene, primitive)),
        );
        let children: Vec<Node> = node.children().collect();
        open.extend(children.into_iter().rev().map(|child| (to_scene, child)));
    }
    Ok(instances)
}

fn affine(transform: &Transform) -> DAffine3 {
    match *transform {
        Transform::Matrix { matrix } => DAffine3::from_mat4(DMat4::from_cols_array_2d(
            &matrix.map(|column| column.map(f64::from)),
        )),
        Transform::Decomposed {
            translation,
            rotation,
            scale,
        } => {
            let rotation: DQuat = Quat::from_array(rotation).as_dquat();
            DAffine3::from_scale_rotation_translation(
                Vec3::from(scale).as_dvec3(),
                rotation.normalize(),
                Vec3::from(translation).as_dvec3(),
            )
        }
    }
}

fn count_triangles(primitive: &Primitive) -> u64 {
    let corners = primitive
        .indices()
        .or_else(|| primitive.get(&Semantic::Positions))
        .map_or(0, |accessor| accessor.count() as u64);
    match primitive.mode() {
        Mode::Triangles => corners / 3,
        Mode::TriangleStrip | Mode::TriangleFan => corners.saturating_sub(2),
        Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => 0,
    }
}

/// The corners of triangle number `i` of a primitive, in the order in which it lists them.
fn corners_of(mode: Mode, i: u32) -> [u32; 3] {
    match mode {
        Mode::TriangleStrip => [i, i + 1 + i % 2, i + 2 - i % 2],
        Mode::TriangleFan => [0, i + 1, i + 2],
        _ => [3 * i, 3 * i + 1, 3 * i + 2],
    }
}

struct Reader<'a> {
    data: MeshData,
    accessors: Accessors<'a>,
    /// Normals and texture coordinates that are no numbers, or without a direction.
    unusable: u64,
    /// Lists of them that are not as long as that of the positions.
    of_others: u64,
}

impl Reader<'_> {
    fn take(&mut self, to_scene: &DAffine3, primitive: &Primitive) -> Result<(), String> {
        let positions = primitive
            .get(&Semantic::Positions)
            .ok_or("found no positions")?;
        let positions = self.accessors.vectors::<3>(&positions)?;
        let mut attribute = |semantic| {
            let accessor = primitive.get(&semantic)?;
            let is_right = accessor.count() == positions.len();
            self.of_others += u64::from(!is_right);
            is_right.then_some(accessor)
        };
        let (normals, uvs) = (
            attribute(Semantic::Normals),
            attribute(Semantic::TexCoords(0)),
        );
        let normals = normals
            .map(|list| self.accessors.vectors::<3>(&list))
            .transpose()?;
        let uvs = uvs
            .map(|list| self.accessors.vectors::<2>(&list))
            .transpose()?;
        let indices = primitive.indices();
        let indices = indices
            .map(|list| self.accessors.vectors::<1>(&list))
            .transpose()?;

        let normals_to_scene = to_scene.matrix3.inverse().transpose();
        let mirrors = to_scene.matrix3.determinant() < 0.0;
        let mut taken: HashMap<u32, [u32; 3]> = HashMap::new();
        for triangle in 0..count_triangles(primitive) as u32 {
            let mut corners = corners_of(primitive.mode(), triangle);
            if mirrors {
                corners.swap(1, 2);
            }
            for corner in corners {
                let index = match &indices {
                    Some(indices) => indices[corner as usize][0] as u32,
                    None => corner,
                };
                let numbers = match taken.get(&index) {
                    Some(&numbers) => numbers,
                    None => {
                        let position = positions.get(index as usize).ok_or_else(|| {
                            format!(
                                "found the index {index}; it has {} positions",
                                positions.len()
                            )
                        })?;
                        let position = to_scene.transform_point3(DVec3::from(*position));
                        let is_right = position.abs().max_element() <= LARGEST;
                        if !is_right {
                            return Err(format!(
                                "found {position} as a position; allowed are finite numbers up to {LARGEST:?} in magnitude"
                            ));
                        }
                        let uv = uvs.as_ref().map(|uvs| DVec2::from(uvs[index as usize]));
                        let normal = normals
                            .as_ref()
                            .map(|normals| DVec3::from(normals[index as usize]));
                        let normal = normal.map(|normal| turned(normals_to_scene, normal));
                        let numbers = [self.position(position), self.uv(uv), self.normal(normal)];
                        taken.insert(index, numbers);
                        numbers
                    }
                };
                self.data.corners.push(numbers);
            }
            self.data.starts.push(self.data.corners.len() as u32);
        }
        Ok(())
    }

    fn position(&mut self, position: DVec3) -> u32 {
        self.data.positions.push(position);
        self.data.positions.len() as u32 - 1
    }

    /// 0, the number of (0, 0), where there is none.
    fn uv(&mut self, uv: Option<DVec2>) -> u32 {
        match uv {
            Some(uv) if uv.abs().max_element() <= LARGEST => {
                self.data.uvs.push(uv);
                self.data.uvs.len() as u32 - 1
            }
            uv => {
                self.unusable += u64::from(uv.is_some());
                0
            }
        }
    }

    /// 0, the number of no normal, where there is none.
    fn normal(&mut self, normal: Option<Option<DVec3>>) -> u32 {
        match normal {
            Some(Some(normal)) => {
                self.data.normals.push(normal);
                self.data.normals.len() as u32 - 1
            }
            normal => {
                self.unusable += u64::from(normal.is_some());
                0
            }
        }
    }

    fn finish(mut self, instances: &[(DAffine3, Primitive)]) -> Result<MeshData, String> {
        let left_over = |(_, primitive): &&(DAffine3, Primitive)| {
            let indices = primitive.indices();
            let list = indices.or_else(|| primitive.get(&Semantic::Positions));
            primitive.mode() == Mode::Triangles && list.is_some_and(|list| list.count() % 3 != 0)
        };
        let left_over = instances.iter().filter(left_over).count() as u64;
        for (count, what, why) in [
            (
                self.unusable,
                "normals or texture coordinates that are no numbers",
                "those corners have none",
            ),
            (
                self.of_others,
                "lists of normals or texture coordinates that do not fit the positions",
                "left out",
            ),
            (
                left_over,
                "lists of triangles with one or two corners more",
                "those corners are left out",
            ),
        ] {
            if count > 0 {
                self.data
                    .remarks
                    .push(Remark::new(format!("{count} {what}"), why));
            }
        }
        Ok(self.data)
    }
}

/// A normal in the scene, of unit length; none of what has no direction there.
fn turned(normals_to_scene: DMat3, normal: DVec3) -> Option<DVec3> {
    Some(normals_to_scene * normal)
        .filter(|normal| normal.is_finite())
        .and_then(unit)
}
