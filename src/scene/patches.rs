//! The surfaces of a scene divided into patches, as radiosity exchanges light between them.
//!
//! Quadrilaterals are divided bilinearly, triangles and the triangles of everything else with n steps an edge, spheres along
//! longitudes and latitudes into inscribed facets. Planes, which have no end, are refused.

use super::primitives::polygon::Polygon;
use super::{Mesh, Object, Scene, Shape, tessellation};
use glam::DVec3;
use std::ops::Range;

/// All patches of a scene, object by object.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Patches {
    /// One an object of the scene.
    pub surfaces: Vec<Surface>,
    patches: Vec<Patch>,
    pieces: Vec<PieceOutline>,
    corners: Vec<DVec3>,
}

/// An object as it is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Surface {
    /// How many patches along u and v. Cell (i, j) is patch `first + j·nu + i`.
    pub grid: [u32; 2],
    pub first: usize,
}

/// A part of a surface, taken to be of one radiosity. It radiates from its front.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Index into [`Scene::objects`].
    pub object: u32,
    /// (i, j) in the grid of the object.
    pub cell: [u32; 2],
    /// > 0
    pub area: f64,
    /// Unit, toward the front; the mean one of a cell that is not planar.
    pub normal: DVec3,
    /// The centre of gravity.
    pub center: DVec3,
    /// Of the smallest ball about the centre that holds the patch.
    pub radius: f64,
    pieces: Range<u32>,
}

/// A convex planar part of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece<'a> {
    /// Three or more, counter-clockwise seen from the front.
    pub corners: &'a [DVec3],
    /// Unit.
    pub normal: DVec3,
    pub area: f64,
}

#[derive(Clone, Debug, PartialEq)]
struct PieceOutline {
    corners: Range<u32>,
    normal: DVec3,
    area: f64,
}

/// Why a scene cannot be divided into patches.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PatchError {
    #[error(
        "objects[{object}]: found the plane {name:?}, which has no end; radiosity takes polygons in its place"
    )]
    Plane { object: usize, name: String },
    #[error("objects[{object}]: patch {cell:?} of {name:?} has no area; every patch needs one")]
    NoArea {
        object: usize,
        name: String,
        cell: [u32; 2],
    },
    #[error(
        "objects[{object}]: {name:?} makes {count} patches here and {in_all} so far; at most {most} are allowed in a scene (--max-patches)"
    )]
    TooMany {
        object: usize,
        name: String,
        count: u64,
        in_all: u64,
        most: u64,
    },
}

impl Patches {
    /// Divides every object. `most` patches are allowed; they are counted before they take memory.
    pub fn of(scene: &Scene, most: u64) -> Result<Patches, PatchError> {
        let mut patches = Patches::default();
        let mut in_all = 0_u64;
        for (number, object) in scene.objects.iter().enumerate() {
            let name = || object.name.clone();
            let division = Division::of(object).ok_or_else(|| PatchError::Plane {
                object: number,
                name: name(),
            })?;
            let count = division.count();
            in_all = in_all.saturating_add(count);
            if in_all > most.min(u32::MAX.into()) {
                return Err(PatchError::TooMany {
                    object: number,
                    name: name(),
                    count,
                    in_all,
                    most,
                });
            }
            let grid = division.grid();
            let first = patches.len();
            patches.surfaces.push(Surface { grid, first });
            for (index, corners) in (0_u32..).zip(division.cells()) {
                let cell = [index % grid[0], index / grid[0]];
                if !patches.add(number as u32, cell, &corners) {
                    return Err(PatchError::NoArea {
                        object: number,
                        name: name(),
                        cell,
                    });
                }
            }
        }
        Ok(patches)
    }

    pub fn len(&self) -> usize {
        self.patches.len()
    }

    pub fn is_empty(&self) -> bool {
        self.patches.is_empty()
    }

    pub fn iter(&self) -> impl ExactSizeIterator<Item = &Patch> {
        self.patches.iter()
    }

    pub fn areas(&self) -> Vec<f64> {
        self.iter().map(|patch| patch.area).collect()
    }

    /// The convex planar pieces of a patch, one or more.
    pub fn pieces(&self, patch: usize) -> impl ExactSizeIterator<Item = Piece<'_>> + Clone {
        let range = &self.patches[patch].pieces;
        self.pieces[range.start as usize..range.end as usize]
            .iter()
            .map(|piece| Piece {
                corners: &self.corners[piece.corners.start as usize..piece.corners.end as usize],
                normal: piece.normal,
                area: piece.area,
            })
    }

    /// Whether the cell had an area, and is a patch now.
    fn add(&mut self, object: u32, cell: [u32; 2], corners: &[DVec3]) -> bool {
        let first_piece = self.pieces.len() as u32;
        let first_corner = self.corners.len();
        for piece in convex_pieces(corners) {
            let vector = area_vector(&piece);
            let area = vector.length();
            if area > 0.0 {
                let start = self.corners.len() as u32;
                self.corners.extend(&piece);
                self.pieces.push(PieceOutline {
                    corners: start..self.corners.len() as u32,
                    normal: vector.normalize_or_zero(),
                    area,
                });
            }
        }
        let pieces = &self.pieces[first_piece as usize..];
        let area: f64 = pieces.iter().map(|piece| piece.area).sum();
        let facing: DVec3 = pieces.iter().map(|piece| piece.area * piece.normal).sum();
        let normal = facing.normalize_or_zero();
        if !(area > 0.0 && area.is_finite()) || normal == DVec3::ZERO {
            return false;
        }
        let center = pieces
            .iter()
            .map(|piece| {
                let corners =
                    &self.corners[piece.corners.start as usize..piece.corners.end as usize];
                piece.area / area * center_of_gravity(corners)
            })
            .sum();
        let radius = self.corners[first_corner..]
            .iter()
            .map(|corner| corner.distance(center))
            .fold(0.0, f64::max);
        self.patches.push(Patch {
            object,
            cell,
            area,
            normal,
            center,
            radius,
            pieces: first_piece..self.pieces.len() as u32,
        });
        true
    }
}

impl std::ops::Index<usize> for Patches {
    type Output = Patch;
    fn index(&self, patch: usize) -> &Patch {
        &self.patches[patch]
    }
}

/// How an object becomes patches.
enum Division<'a> {
    /// A quadrilateral into nu × nv cells.
    Bilinear {
        corners: [DVec3; 4],
        grid: [u32; 2],
    },
    /// Into longitudes × latitudes.
    Sphere {
        center: DVec3,
        radius: f64,
        grid: [u32; 2],
    },
    /// Each triangle into `steps`².
    Triangles {
        triangles: Vec<[DVec3; 3]>,
        steps: u32,
    },
    Whole(&'a [DVec3]),
}

impl Division<'_> {
    /// None of a plane.
    fn of(object: &Object) -> Option<Division<'_>> {
        let grid = object.patches;
        Some(match &object.shape {
            Shape::Plane { .. } => return None,
            &Shape::Sphere { center, radius } => Division::Sphere {
                center,
                radius,
                grid,
            },
            Shape::Polygon { vertices } if vertices.len() > 4 => Division::Whole(vertices),
            Shape::Polygon { vertices } if vertices.len() == 4 => Division::Bilinear {
                corners: std::array::from_fn(|i| vertices[i]),
                grid,
            },
            shape => Division::Triangles {
                triangles: triangles(&tessellation::mesh_of(shape, object.divisions)),
                steps: grid[0],
            },
        })
    }

    fn count(&self) -> u64 {
        let squared = |n: u32| u64::from(n) * u64::from(n);
        match self {
            Division::Bilinear { grid, .. } | Division::Sphere { grid, .. } => {
                u64::from(grid[0]) * u64::from(grid[1])
            }
            Division::Triangles { triangles, steps } => {
                (triangles.len() as u64).saturating_mul(squared(*steps))
            }
            Division::Whole(_) => 1,
        }
    }

    /// In a division that is known to be within the limit.
    fn grid(&self) -> [u32; 2] {
        match self {
            Division::Bilinear { grid, .. } | Division::Sphere { grid, .. } => *grid,
            Division::Triangles { .. } | Division::Whole(_) => [self.count() as u32, 1],
        }
    }

    /// The corners of each patch, row by row of the grid.
    fn cells(&self) -> Box<dyn Iterator<Item = Vec<DVec3>> + '_> {
        match self {
            Division::Bilinear { corners, grid } => Box::new(bilinear_cells(corners, *grid)),
            // A face whose corners have run together is missing from the mesh; the last patch is then found empty.
            &Division::Sphere {
                center,
                radius,
                grid,
            } => {
                let mesh = tessellation::sphere(center, radius, grid);
                let faces = 0..self.count() as usize;
                Box::new(faces.map(move |face| match face {
                    face if face < mesh.face_count() => corners_of(&mesh, face),
                    _ => Vec::new(),
                }))
            }
            Division::Triangles { triangles, steps } => Box::new(
                triangles
                    .iter()
                    .flat_map(move |triangle| triangle_cells(triangle, *steps)),
            ),
            Division::Whole(corners) => Box::new(std::iter::once(corners.to_vec())),
        }
    }
}

/// Cell (i, j) with u along v0→v1 and v along v0→v3.
fn bilinear_cells(
    &[a, b, c, d]: &[DVec3; 4],
    [nu, nv]: [u32; 2],
) -> impl Iterator<Item = Vec<DVec3>> {
    let at = move |i: u32, j: u32| {
        let (u, v) = (f64::from(i) / f64::from(nu), f64::from(j) / f64::from(nv));
        // Exact at the corners, and the same point from both sides of an inner edge.
        (1.0 - v) * ((1.0 - u) * a + u * b) + v * ((1.0 - u) * d + u * c)
    };
    (0..nv).flat_map(move |j| {
        (0..nu).map(move |i| vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)])
    })
}

/// The n² triangles of a triangle whose edges have n steps: row by row from the first edge, each row alternating between
/// triangles that stand on their base and on their tip.
fn triangle_cells(&[a, b, c]: &[DVec3; 3], n: u32) -> impl Iterator<Item = Vec<DVec3>> {
    let at = move |i: u32, j: u32| {
        (f64::from(n - i - j) * a + f64::from(i) * b + f64::from(j) * c) / f64::from(n)
    };
    (0..n).flat_map(move |j| {
        (0..2 * (n - j) - 1).map(move |k| {
            let i = k / 2;
            if k % 2 == 0 {
                vec![at(i, j), at(i + 1, j), at(i, j + 1)]
            } else {
                vec![at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
            }
        })
    })
}

fn corners_of(mesh: &Mesh, face: usize) -> Vec<DVec3> {
    mesh.face(face)
        .iter()
        .map(|&vertex| mesh.position(vertex))
        .collect()
}

/// The triangles of a mesh, face by face, as rays meet them.
fn triangles(mesh: &Mesh) -> Vec<[DVec3; 3]> {
    (0..mesh.face_count())
        .flat_map(|face| {
            let corners = corners_of(mesh, face);
            Polygon::of_face(mesh, face)
                .triangles()
                .into_iter()
                .map(move |triangle| triangle.map(|corner| corners[corner as usize]))
        })
        .collect()
}

/// The planar convex faces of a polygon as they are, any others as triangles.
fn convex_pieces(corners: &[DVec3]) -> Vec<Vec<DVec3>> {
    let mesh = tessellation::polygon(corners);
    let mut pieces = Vec::new();
    for face in 0..mesh.face_count() {
        let polygon = Polygon::of_face(&mesh, face);
        let corners = corners_of(&mesh, face);
        if polygon.is_planar() && polygon.is_convex() {
            pieces.push(corners);
        } else {
            let triangles = polygon.triangles().into_iter();
            pieces.extend(triangles.map(|triangle| triangle.map(|i| corners[i as usize]).to_vec()));
        }
    }
    pieces
}

/// Of a planar polygon: its area along its normal, taken from the first corner, so that it stays exact far from the origin.
fn area_vector(corners: &[DVec3]) -> DVec3 {
    let from_first = corners[1..].windows(2);
    let twice: DVec3 = from_first
        .map(|pair| (pair[0] - corners[0]).cross(pair[1] - corners[0]))
        .sum();
    0.5 * twice
}

/// Of a convex planar polygon with an area.
fn center_of_gravity(corners: &[DVec3]) -> DVec3 {
    let first = corners[0];
    let (mut sum, mut area) = (DVec3::ZERO, 0.0);
    for pair in corners[1..].windows(2) {
        let (b, c) = (pair[0] - first, pair[1] - first);
        let weight = b.cross(c).length();
        sum += weight / 3.0 * (b + c);
        area += weight;
    }
    first + sum / area
}

#[cfg(test)]
mod tests;
