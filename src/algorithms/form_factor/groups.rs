//! Patches that stand in the way together: those of one object in one plane, or in a surface that is almost one.

use crate::scene::patches::Patches;
use crate::scene::{Mesh, Scene, Shape};
use glam::DVec3;
use std::ops::Range;

/// Patches of one object in one plane, or in a surface warped a little out of it.
#[derive(Clone, Debug)]
pub struct Group {
    pub object: u32,
    pub patches: Range<usize>,
    /// Of the one patch, where it is not planar.
    pub piece: Option<usize>,
    pub normal: DVec3,
    pub point: DVec3,
    pub low: DVec3,
    pub high: DVec3,
    /// Between which heights it lies: in its plane unless it is warped.
    pub heights: [f64; 2],
    /// The steepest slope of a warped one against its plane.
    pub slope: f64,
}

impl Group {
    pub fn height(&self, point: DVec3) -> f64 {
        self.normal.dot(point - self.point)
    }

    pub fn is_warped(&self) -> bool {
        self.heights[0] < self.heights[1]
    }
}

/// The steepest slope of patches that count as one warped group.
const STEEPEST: f64 = 0.1;

/// The patches of an object that are not planar, but almost: all of them as one group.
fn warped(patches: &Patches, range: Range<usize>) -> Option<Group> {
    let pieces = || range.clone().flat_map(|patch| patches.pieces(patch));
    if range.clone().all(|patch| patches.pieces(patch).len() == 1) {
        return None;
    }
    let normal = pieces()
        .map(|piece| piece.area * piece.normal)
        .sum::<DVec3>()
        .normalize_or_zero();
    let cosine = pieces()
        .map(|piece| piece.normal.dot(normal))
        .fold(1.0, f64::min);
    let slope = (1.0 - cosine * cosine).max(0.0).sqrt() / cosine;
    if !(cosine > 0.0 && slope <= STEEPEST) {
        return None;
    }
    let corners = || pieces().flat_map(|piece| piece.corners.iter().copied());
    let point = corners().next()?;
    let heights = || corners().map(|corner| normal.dot(corner - point));
    Some(Group {
        object: patches[range.start].object,
        patches: range.clone(),
        piece: None,
        normal,
        point,
        low: corners().fold(DVec3::INFINITY, DVec3::min),
        high: corners().fold(DVec3::NEG_INFINITY, DVec3::max),
        heights: [
            heights().fold(f64::INFINITY, f64::min),
            heights().fold(f64::NEG_INFINITY, f64::max),
        ],
        slope,
    })
}

/// Patches in one plane that follow each other; of patches that are not planar, each piece.
pub fn groups(scene: &Scene, patches: &Patches, slack: f64) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (number, patch) in patches.iter().enumerate() {
        if !scene.objects[patch.object as usize].casts_shadow {
            continue;
        }
        let surface = &patches.surfaces[patch.object as usize];
        let all = surface.first..surface.first + (surface.grid[0] * surface.grid[1]) as usize;
        if number == all.start {
            groups.extend(warped(patches, all));
        }
        if groups
            .last()
            .is_some_and(|group| group.is_warped() && group.patches.contains(&number))
        {
            continue;
        }
        let is_whole = patches.pieces(number).len() == 1;
        for (piece_number, piece) in patches.pieces(number).enumerate() {
            let corners = piece.corners.iter().copied();
            let low = corners.clone().fold(DVec3::INFINITY, DVec3::min);
            let high = corners.clone().fold(DVec3::NEG_INFINITY, DVec3::max);
            match groups.last_mut() {
                Some(group)
                    if is_whole
                        && group.piece.is_none()
                        && group.object == patch.object
                        && group.patches.end == number
                        && corners
                            .clone()
                            .all(|corner| group.height(corner).abs() <= slack) =>
                {
                    group.low = group.low.min(low);
                    group.high = group.high.max(high);
                    group.patches.end = number + 1;
                }
                _ => groups.push(Group {
                    object: patch.object,
                    patches: number..number + 1,
                    piece: (!is_whole).then_some(piece_number),
                    normal: piece.normal,
                    point: piece.corners[0],
                    low,
                    high,
                    heights: [0.0; 2],
                    slope: 0.0,
                }),
            }
        }
    }
    groups
}

/// The groups as a scene: every object a mesh of those of its patches that stand in the way.
pub fn facets(scene: &Scene, patches: &Patches, groups: &[Group]) -> Scene {
    let mut scene = scene.clone();
    let mut meshes: Vec<(Vec<DVec3>, Vec<Vec<u32>>)> =
        vec![Default::default(); scene.objects.len()];
    for group in groups {
        let (positions, faces) = &mut meshes[group.object as usize];
        let pieces = (group.patches.clone()).flat_map(|patch| patches.pieces(patch).enumerate());
        for (_, piece) in pieces.filter(|&(number, _)| group.piece.is_none_or(|one| one == number))
        {
            let first = positions.len() as u32;
            positions.extend(piece.corners);
            faces.push((first..positions.len() as u32).collect());
        }
    }
    for (object, (positions, faces)) in scene.objects.iter_mut().zip(meshes) {
        object.shape = Shape::Mesh(Mesh::new(&positions, faces, &[]));
    }
    scene
}
