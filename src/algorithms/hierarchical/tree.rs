//! Elements: each surface as a quadtree over the grid of its patches.
//!
//! The root is the whole surface, the smallest elements are its patches. What is not a plane quadrilateral has no whole that could stand
//! for its patches: there every patch is a root, and is never divided.

use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::form_factor::polygon::{Polygon, polygons};
use crate::color::Rgb;
use crate::scene::patches::{Patches, Surface};
use glam::DVec3;
use std::ops::Range;

/// A part of a surface: a rectangle of its patches.
#[derive(Clone, Debug)]
pub struct Element {
    /// Index into the scene's objects.
    pub object: u32,
    /// How often its surface was divided for it: 0 of a root.
    pub level: u32,
    /// Columns and rows of the grid of its surface: from, and up to but without.
    pub block: [[u32; 2]; 2],
    /// > 0
    pub area: f64,
    /// The share of the area that nothing lies on.
    pub exposed: f64,
    /// ρ and E.
    pub rho: Rgb,
    pub emission: Rgb,
    /// None until it is divided.
    pub children: Option<[u32; 2]>,
}

impl Element {
    pub fn children(&self) -> Range<u32> {
        let [from, to] = self.children.unwrap_or_default();
        from..to
    }

    fn is_patch(&self) -> bool {
        self.block.iter().all(|[from, to]| to - from == 1)
    }

    /// By the block, the numbers of its patches.
    pub fn patches(&self, surface: &Surface) -> impl Iterator<Item = usize> + use<> {
        let [columns, [from, to]] = self.block;
        let (first, width) = (surface.first, surface.grid[0] as usize);
        (from..to).flat_map(move |row| {
            let start = first + row as usize * width;
            start + columns[0] as usize..start + columns[1] as usize
        })
    }

    /// Its halves along each side that has more than one patch, and is not much shorter than the other.
    fn parts(&self) -> Vec<[[u32; 2]; 2]> {
        let [width, height] = self.block.map(|[from, to]| to - from);
        let halves = |[from, to]: [u32; 2], other: u32| match to - from {
            1 => vec![[from, to]],
            length if 2 * length <= other => vec![[from, to]],
            length => vec![[from, from + length / 2], [from + length / 2, to]],
        };
        let [columns, rows] = [halves(self.block[0], height), halves(self.block[1], width)];
        let row = |row: [u32; 2]| columns.iter().map(move |&column| [column, row]);
        rows.into_iter().flat_map(row).collect()
    }
}

/// The elements of an enclosure, roots first.
#[derive(Clone, Debug)]
pub struct Tree {
    pub elements: Vec<Element>,
    pub roots: u32,
}

impl Tree {
    pub fn of(enclosure: &Enclosure) -> Tree {
        let mut tree = Tree {
            elements: Vec::new(),
            roots: 0,
        };
        for (object, surface) in (0..).zip(&enclosure.patches.surfaces) {
            let [width, height] = surface.grid;
            let blocks: Vec<_> = match is_plane(&enclosure.patches, surface) {
                true => vec![[[0, width], [0, height]]],
                false => (0..height)
                    .flat_map(|row| {
                        (0..width).map(move |column| [[column, column + 1], [row, row + 1]])
                    })
                    .collect(),
            };
            for block in blocks {
                tree.add(enclosure, object, 0, block);
            }
        }
        tree.roots = tree.elements.len() as u32;
        tree
    }

    fn add(&mut self, enclosure: &Enclosure, object: u32, level: u32, block: [[u32; 2]; 2]) {
        let surface = &enclosure.patches.surfaces[object as usize];
        let mut element = Element {
            object,
            level,
            block,
            area: 0.0,
            exposed: 1.0,
            rho: Rgb::BLACK,
            emission: Rgb::BLACK,
            children: None,
        };
        let mut open = 0.0;
        for patch in element.patches(surface) {
            let area = enclosure.patches[patch].area;
            element.area += area;
            open += match enclosure.visibility() {
                Some(blockers) if !blockers.is_bare(&enclosure.patches, patch) => {
                    let parts = blockers.polygons(&enclosure.patches, patch);
                    parts.iter().map(|part| part.area).sum()
                }
                _ => area,
            };
            // One material a surface.
            element.rho = enclosure.reflectance[patch];
            element.emission = enclosure.emission[patch];
        }
        element.exposed = open / element.area;
        self.elements.push(element);
    }

    /// Divides an element into its parts, unless it was divided before. Returns whether it was not.
    pub fn divide(&mut self, enclosure: &Enclosure, number: u32) -> bool {
        let element = &self.elements[number as usize];
        if element.children.is_some() {
            return false;
        }
        let (object, level) = (element.object, element.level + 1);
        let first = self.elements.len() as u32;
        for block in element.parts() {
            self.add(enclosure, object, level, block);
        }
        let children = Some([first, self.elements.len() as u32]);
        self.elements[number as usize].children = children;
        true
    }

    /// Subdiv(p, A_ε): whether an element may be divided.
    pub fn is_divisible(&self, number: u32, smallest_area: f64) -> bool {
        let element = &self.elements[number as usize];
        !element.is_patch() && element.area > smallest_area
    }

    /// The elements that are not divided.
    pub fn leaves(&self) -> impl Iterator<Item = u32> {
        let numbered = (0..).zip(&self.elements);
        numbered
            .filter(|(_, element)| element.children.is_none())
            .map(|(number, _)| number)
    }

    /// By patch, the value of the leaf that it lies in.
    pub fn by_patch<T: Copy>(
        &self,
        patches: &Patches,
        of_nothing: T,
        of: impl Fn(u32) -> T,
    ) -> Vec<T> {
        let mut values = vec![of_nothing; patches.len()];
        for leaf in self.leaves() {
            let element = &self.elements[leaf as usize];
            let value = of(leaf);
            for patch in element.patches(&patches.surfaces[element.object as usize]) {
                values[patch] = value;
            }
        }
        values
    }

    /// The convex planar polygons that an element is made of: one, unless it is a patch of several.
    pub fn polygons<'a>(&self, patches: &'a Patches, number: u32) -> Vec<Polygon<'a>> {
        let element = &self.elements[number as usize];
        let surface = &patches.surfaces[element.object as usize];
        if element.is_patch() {
            return element
                .patches(surface)
                .flat_map(|patch| polygons(patches, patch))
                .collect();
        }
        let corners = corners(patches, surface, element.block).to_vec();
        let normal = patches[surface.first].normal;
        Polygon::new(corners.into(), normal).into_iter().collect()
    }
}

/// The corners of a rectangle of quadrilateral patches.
pub fn corners(patches: &Patches, surface: &Surface, [columns, rows]: [[u32; 2]; 2]) -> [DVec3; 4] {
    let [left, right] = [columns[0], columns[1] - 1];
    let [bottom, top] = [rows[0], rows[1] - 1];
    let at = |column: u32, row: u32, corner: usize| {
        let patch = surface.first + (row * surface.grid[0] + column) as usize;
        let mut pieces = patches.pieces(patch);
        pieces
            .next()
            .map_or(DVec3::ZERO, |piece| piece.corners[corner])
    };
    [
        at(left, bottom, 0),
        at(right, bottom, 1),
        at(right, top, 2),
        at(left, top, 3),
    ]
}

/// Whether a surface has patches, all of them quadrilaterals in one plane.
fn is_plane(patches: &Patches, surface: &Surface) -> bool {
    let [width, height] = surface.grid;
    let count = width as usize * height as usize;
    // What is too thin for any polygon.
    if count == 0 {
        return false;
    }
    let normal = patches[surface.first].normal;
    (surface.first..surface.first + count).all(|patch| {
        let mut pieces = patches.pieces(patch);
        pieces.len() == 1
            && pieces.all(|piece| piece.corners.len() == 4)
            && patches[patch].normal.distance(normal) < 1e-9
    })
}
