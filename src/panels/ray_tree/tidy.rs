//! The layout of a tidy binary tree in linear time, after Reingold and Tilford, "Tidier drawings of trees", IEEE Transactions
//! on Software Engineering 7 (1981); threads as in Buchheim, Jünger and Leipert, "Improving Walker's algorithm to run in linear
//! time" (2002), whose improvement is for more than two children.
//!
//! Two subtrees are laid out by themselves, then pushed together until nodes of the same level are a gap apart, and their
//! parent is centred over them. A child without a sibling stays on its own side. The mirrored tree has the mirrored layout.

const LEFT: usize = 0;
const RIGHT: usize = 1;

/// A node by its width and its left and right child.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    pub width: f32,
    pub children: [Option<usize>; 2],
}

/// What is known of a node's subtree. Distances are to the right, in points.
#[derive(Clone, Copy, Default)]
struct Shape {
    /// From the parent.
    offset: f32,
    /// Where an outer contour goes on below a leaf: another node of the next level, and how far it lies from this one.
    thread: [Option<(usize, f32)>; 2],
    /// The lowest node of either contour, and how far it lies from this one.
    lowest: [(usize, f32); 2],
}

/// The horizontal centre of each node, the root at 0. Nodes of one level are at least `gap` apart. `nodes[0]` is the root;
/// every child stands behind its parent.
pub fn centers(nodes: &[Node], gap: f32) -> Vec<f32> {
    let mut shapes: Vec<Shape> = (0..nodes.len())
        .map(|node| Shape {
            lowest: [(node, 0.0); 2],
            ..Shape::default()
        })
        .collect();
    // Children stand behind their parents, so backwards every subtree is finished before its parent is reached.
    for (parent, node) in nodes.iter().enumerate().rev() {
        match node.children {
            [None, None] => {}
            [Some(left), Some(right)] => {
                push_together(nodes, &mut shapes, parent, [left, right], gap)
            }
            [Some(left), None] => hang(nodes, &mut shapes, parent, left, -gap),
            [None, Some(right)] => hang(nodes, &mut shapes, parent, right, gap),
        }
    }
    let mut centers = vec![0.0; nodes.len()];
    for (parent, node) in nodes.iter().enumerate() {
        for child in node.children.into_iter().flatten() {
            centers[child] = centers[parent] + shapes[child].offset;
        }
    }
    centers
}

/// An only child, on the side of the sign of `gap`.
fn hang(nodes: &[Node], shapes: &mut [Shape], parent: usize, child: usize, gap: f32) {
    let offset = 0.25 * (nodes[child].width * gap.signum() + gap);
    shapes[child].offset = offset;
    shapes[parent].lowest = shapes[child].lowest.map(|(node, at)| (node, at + offset));
}

/// As near as the right contour of the left subtree and the left contour of the right one allow.
fn push_together(
    nodes: &[Node],
    shapes: &mut [Shape],
    parent: usize,
    [left, right]: [usize; 2],
    gap: f32,
) {
    // Both contours level by level: a node, and how far it lies from its subtree's root.
    let (mut inner_left, mut inner_right) = ((left, 0.0), (right, 0.0));
    let mut apart = 0.0_f32;
    let (rest_left, rest_right) = loop {
        let ((a, at_a), (b, at_b)) = (inner_left, inner_right);
        let needed = 0.5 * (nodes[a].width + nodes[b].width) + gap;
        apart = apart.max(at_a - at_b + needed);
        let below_a = below(nodes, shapes, inner_left, RIGHT);
        let below_b = below(nodes, shapes, inner_right, LEFT);
        match (below_a, below_b) {
            (Some(a), Some(b)) => (inner_left, inner_right) = (a, b),
            rest => break rest,
        }
    };
    let offsets = [-0.5 * apart, 0.5 * apart];
    shapes[left].offset = offsets[LEFT];
    shapes[right].offset = offsets[RIGHT];
    let mut lowest = [shapes[left].lowest[LEFT], shapes[right].lowest[RIGHT]];
    // Where one subtree is deeper, the outer contour of the other goes on in it.
    if let Some((next, at)) = rest_left {
        let (end, end_at) = lowest[RIGHT];
        shapes[end].thread[RIGHT] = Some((next, at - apart - end_at));
        lowest[RIGHT] = shifted(shapes[left].lowest[RIGHT], -apart);
    }
    if let Some((next, at)) = rest_right {
        let (end, end_at) = lowest[LEFT];
        shapes[end].thread[LEFT] = Some((next, at + apart - end_at));
        lowest[LEFT] = shifted(shapes[right].lowest[LEFT], apart);
    }
    shapes[parent].lowest = [
        shifted(lowest[LEFT], offsets[LEFT]),
        shifted(lowest[RIGHT], offsets[RIGHT]),
    ];
}

/// The next node down a contour.
fn below(
    nodes: &[Node],
    shapes: &[Shape],
    (node, at): (usize, f32),
    side: usize,
) -> Option<(usize, f32)> {
    let children = nodes[node].children;
    match children[side].or(children[1 - side]) {
        Some(child) => Some((child, at + shapes[child].offset)),
        None => shapes[node].thread[side].map(|next| shifted(next, at)),
    }
}

fn shifted((node, at): (usize, f32), by: f32) -> (usize, f32) {
    (node, at + by)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const GAP: f32 = 7.0;
    /// Of sums of some hundred numbers of about a thousand, in f32.
    const TOLERANCE: f32 = 0.05;

    /// Trees of any form: node by node, hung below an earlier one where there is room.
    fn trees() -> impl Strategy<Value = Vec<Node>> {
        let node = (any::<prop::sample::Index>(), any::<bool>(), 1.0_f32..90.0);
        prop::collection::vec(node, 0..300).prop_map(|hung| {
            let leaf = |width| Node {
                width,
                children: [None; 2],
            };
            let mut nodes = vec![leaf(40.0)];
            for (parent, right, width) in hung {
                let (parent, child) = (parent.index(nodes.len()), nodes.len());
                let place = &mut nodes[parent].children[usize::from(right)];
                if place.is_none() {
                    *place = Some(child);
                    nodes.push(leaf(width));
                }
            }
            nodes
        })
    }

    /// The nodes of each level, from left to right.
    fn levels(nodes: &[Node]) -> Vec<Vec<usize>> {
        let mut levels = vec![vec![0]];
        while let Some(last) = levels.last().filter(|level| !level.is_empty()) {
            let children = last.iter().flat_map(|&node| nodes[node].children);
            levels.push(children.flatten().collect());
        }
        levels
    }

    proptest! {
        #[test]
        fn nodes_of_a_level_lie_apart_in_their_order(nodes in trees()) {
            let centers = centers(&nodes, GAP);
            for level in levels(&nodes) {
                for pair in level.windows(2) {
                    let halves = 0.5 * (nodes[pair[0]].width + nodes[pair[1]].width);
                    prop_assert!(centers[pair[1]] - centers[pair[0]] >= halves + GAP - TOLERANCE);
                }
            }
        }

        #[test]
        fn parents_are_centred_and_an_only_child_stays_on_its_side(nodes in trees()) {
            let centers = centers(&nodes, GAP);
            for (node, &center) in nodes.iter().zip(&centers) {
                match node.children.map(|child| child.map(|child| centers[child] - center)) {
                    [Some(left), Some(right)] => prop_assert!((left + right).abs() < TOLERANCE),
                    [Some(left), None] => prop_assert!(left < 0.0),
                    [None, Some(right)] => prop_assert!(right > 0.0),
                    [None, None] => {}
                }
            }
        }

        #[test]
        fn a_mirrored_tree_is_laid_out_mirrored(nodes in trees()) {
            let mirrored: Vec<Node> = nodes
                .iter()
                .map(|node| Node { children: [node.children[1], node.children[0]], ..*node })
                .collect();
            for (a, b) in centers(&nodes, GAP).into_iter().zip(centers(&mirrored, GAP)) {
                prop_assert!((a + b).abs() < TOLERANCE);
            }
        }
    }

    #[test]
    fn a_full_tree_is_as_wide_as_its_leaves() {
        // Heap order: the children of i are 2i + 1 and 2i + 2.
        let nodes: Vec<Node> = (0..1023)
            .map(|i| Node {
                width: 10.0,
                children: [2 * i + 1, 2 * i + 2].map(|child| (child < 1023).then_some(child)),
            })
            .collect();
        let centers = centers(&nodes, 2.0);
        let width = centers[1022] - centers[511];
        assert!((width - 511.0 * 12.0).abs() < TOLERANCE, "{width}");
    }
}
