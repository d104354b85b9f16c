//! A bounding volume hierarchy: which boxes a ray passes, from front to back.
//!
//! The binary tree is built by `obvhs`: pairs of nearest clusters (Meister & Bittner 2018, "Parallel Locally-Ordered Clustering
//! for Bounding Volume Hierarchy Construction"), improved by reinsertion (Meister & Bittner 2018, "Parallel Reinsertion for
//! Bounding Volume Hierarchy Optimization"). Here eight children are drawn into a node, so that one step tests eight boxes, four
//! at once (Wald, Benthin & Boulos 2008, "Getting Rid of Packets").
//!
//! Boxes are f32, in the unit box of a [`Frame`], and conservative: a box that holds a hit of the exact test is never passed over.

use super::aim::Aim;
use super::frame::{Frame, Near};
use super::stack::Stack;
use glam::{Vec3, Vec3A, Vec4};
use obvhs::aabb::Aabb;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};
use std::ops::Range;

/// How much wider than its contents a box is on each side, in the unit frame. It covers the rounding to f32 of the box (2⁻²⁵) and of
/// the ray's origin (2⁻²³, up to 4 away), twice.
const PAD: f32 = 1.0 / (1 << 21) as f32;

/// Products of rounded differences with rounded inverses: four roundings of 2⁻²⁴ each, four times.
const WIDER: f32 = 1.0 + 1.0 / (1 << 20) as f32;

/// How many children a node has at most.
const WIDTH: usize = 8;

/// Marks a child that is a leaf.
const LEAF: u32 = 1 << 31;

/// Up to eight children.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Node {
    /// Of the boxes, by side (low, high), axis and half of the children. A child that is missing has an empty box.
    bounds: [[[Vec4; 2]; 3]; 2],
    /// Indices of nodes, or of leaves with [`LEAF`].
    children: [u32; WIDTH],
}

#[derive(Clone, Debug)]
pub(super) struct Bvh {
    nodes: Vec<Node>,
}

/// A ray in the unit frame of a hierarchy.
pub(super) struct UnitRay<'a> {
    origin: [Vec4; 3],
    aim: &'a Aim,
    frame: &'a Frame,
    near: &'a Near,
}

impl<'a> UnitRay<'a> {
    pub fn new(frame: &'a Frame, near: &'a Near, aim: &'a Aim) -> Self {
        UnitRay {
            origin: frame
                .unit_point(near.ray.origin)
                .to_array()
                .map(Vec4::splat),
            aim,
            frame,
            near,
        }
    }

    /// A distance along the ray in the unit frame, rounded up so far that nothing at this distance is passed over.
    pub fn reach(&self, distance: f64) -> f32 {
        let reach = self.frame.unit_length(self.near.reach(distance));
        (reach * WIDER + PAD) * WIDER
    }
}

impl Bvh {
    /// The memory of its nodes.
    pub fn bytes(&self) -> u64 {
        (self.nodes.len() * size_of::<Node>()) as u64
    }

    /// Over boxes in the unit frame. Also the leaves: which boxes, by index, are in each.
    pub fn new(boxes: &[[Vec3; 2]], most_in_leaf: usize) -> (Self, Leaves) {
        let aabbs: Vec<Aabb> = boxes
            .iter()
            .map(|[low, high]| {
                Aabb::new(
                    Vec3A::from(*low - Vec3::splat(PAD)),
                    Vec3A::from(*high + Vec3::splat(PAD)),
                )
            })
            .collect();
        if aabbs.is_empty() {
            return (Bvh { nodes: Vec::new() }, Leaves::default());
        }
        let indices = (0..aabbs.len() as u32).collect();
        let mut tree = PlocBuilder::with_capacity(aabbs.len()).build(
            PlocSearchDistance::Medium,
            &aabbs,
            indices,
            SortPrecision::U64,
            3,
        );
        let mut optimizer = ReinsertionOptimizer::default();
        optimizer.run(&mut tree, 0.05, None);
        collapse(&mut tree, most_in_leaf as u32, 3.0);
        optimizer.run(&mut tree, 0.1, None);

        let mut widening = Widening {
            tree: &tree.nodes,
            nodes: Vec::new(),
            leaves: Leaves {
                ranges: Vec::new(),
                boxes: tree.primitive_indices.clone(),
            },
        };
        widening.run();
        (
            Bvh {
                nodes: widening.nodes,
            },
            widening.leaves,
        )
    }

    /// Visits the leaves whose boxes the ray passes within `reach`, roughly from front to back. `visit` returns how far the ray
    /// reaches from then on; below 0 ends the walk. `stack` is as before afterwards, unless the walk was ended; `visit` may use it
    /// for a walk of its own.
    #[inline]
    pub fn walk(
        &self,
        ray: &UnitRay,
        mut reach: f32,
        stack: &mut Stack,
        mut visit: impl FnMut(usize, f32, &mut Stack) -> f32,
    ) {
        if self.nodes.is_empty() {
            return;
        }
        let bottom = stack.len();
        let mut current = 0;
        loop {
            if current & LEAF != 0 {
                reach = visit((current & !LEAF) as usize, reach, stack);
                if reach < 0.0 {
                    return;
                }
            } else {
                let node = &self.nodes[current as usize];
                let (near, mut hits) = node.meet(ray, reach);
                if hits != 0 {
                    let first = hits.trailing_zeros() as usize;
                    let mut nearest = (node.children[first], near[first]);
                    hits &= hits - 1;
                    let base = stack.len();
                    while hits != 0 {
                        let child = hits.trailing_zeros() as usize;
                        let mut other = (node.children[child], near[child]);
                        hits &= hits - 1;
                        if other.1 < nearest.1 {
                            std::mem::swap(&mut nearest, &mut other);
                        }
                        stack.push_below_nearer(base, other);
                    }
                    current = nearest.0;
                    continue;
                }
            }
            loop {
                match stack.pop(bottom) {
                    None => return,
                    Some((_, near)) if near > reach => {}
                    Some((next, _)) => {
                        current = next;
                        break;
                    }
                }
            }
        }
    }
}

impl Node {
    const EMPTY: Node = Node {
        bounds: [[[Vec4::INFINITY; 2]; 3], [[Vec4::NEG_INFINITY; 2]; 3]],
        children: [u32::MAX; WIDTH],
    };

    /// Where the ray enters each box, and the set of those that it passes within `reach`.
    ///
    /// An origin beyond the near side, or a box behind, makes a negative distance, which stays negative however it is rounded.
    #[inline]
    fn meet(&self, ray: &UnitRay, reach: f32) -> ([f32; WIDTH], u32) {
        let [x, y, z] = ray.aim.near_side;
        let half = |half: usize| {
            let to = |side: usize, axis: usize| {
                (self.bounds[side & 1][axis][half] - ray.origin[axis]) * ray.aim.inverse[axis]
            };
            let near = to(x, 0).max(to(y, 1)).max(to(z, 2).max(Vec4::ZERO));
            let far = to(x ^ 1, 0).min(to(y ^ 1, 1)).min(to(z ^ 1, 2));
            let far = (far * WIDER).min(Vec4::splat(reach));
            (near, near.cmple(far).bitmask())
        };
        let ((first, hits), (second, more_hits)) = (half(0), half(1));
        let mut near = [0.0; WIDTH];
        near[..4].copy_from_slice(&first.to_array());
        near[4..].copy_from_slice(&second.to_array());
        (near, hits | more_hits << 4)
    }
}

/// What is in the leaves of a hierarchy.
#[derive(Clone, Debug, Default)]
pub(super) struct Leaves {
    ranges: Vec<Range<u32>>,
    boxes: Vec<u32>,
}

impl Leaves {
    /// The indices of the boxes in each leaf.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.ranges
            .iter()
            .map(|range| &self.boxes[range.start as usize..range.end as usize])
    }
}

/// From two children a node to eight, by opening the child with the largest surface.
struct Widening<'a> {
    tree: &'a [Bvh2Node],
    nodes: Vec<Node>,
    leaves: Leaves,
}

impl Widening<'_> {
    /// The children of a binary node, and theirs, up to eight; a leaf stays as it is.
    fn below(&self, binary: u32) -> Vec<u32> {
        let node = |index: u32| &self.tree[index as usize];
        let mut below = vec![binary];
        while below.len() < WIDTH {
            let area = |&i: &usize| node(below[i]).aabb().half_area();
            let inner = (0..below.len()).filter(|&i| !node(below[i]).is_leaf());
            let Some(largest) = inner.max_by(|i, j| area(i).total_cmp(&area(j))) else {
                break;
            };
            let first = node(below.swap_remove(largest)).first_index;
            below.extend([first, first + 1]);
        }
        below
    }

    fn run(&mut self) {
        self.nodes.push(Node::EMPTY);
        let mut open = vec![(0, 0)];
        while let Some((binary, wide)) = open.pop() {
            for (i, index) in self.below(binary).into_iter().enumerate() {
                let child = &self.tree[index as usize];
                let reference = if child.is_leaf() {
                    let start = child.first_index;
                    self.leaves.ranges.push(start..start + child.prim_count);
                    LEAF | (self.leaves.ranges.len() - 1) as u32
                } else {
                    self.nodes.push(Node::EMPTY);
                    open.push((index, self.nodes.len() - 1));
                    (self.nodes.len() - 1) as u32
                };
                let node = &mut self.nodes[wide];
                node.children[i] = reference;
                for (side, corner) in [child.aabb().min, child.aabb().max].into_iter().enumerate() {
                    for axis in 0..3 {
                        node.bounds[side][axis][i / 4][i % 4] = corner[axis];
                    }
                }
            }
        }
    }
}
