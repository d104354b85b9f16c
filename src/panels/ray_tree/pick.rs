//! Which rays of the tree are drawn: all where there is room, else those on the way to the current ray, then level by level.

use super::node;
use crate::replay::rays::{Outcome, RayState, State};
use std::collections::{BTreeSet, VecDeque};

/// What a node stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Of {
    /// A ray, by its index in the state.
    Ray(usize),
    /// A ray that is not traced yet.
    Asked,
}

#[derive(Clone, Debug)]
pub(super) struct Node {
    pub of: Of,
    /// Its parent, and on which of its sides it hangs.
    pub parent: Option<(usize, usize)>,
    pub children: [Option<usize>; 2],
    /// 0 at the root.
    pub level: usize,
    /// Whether the current ray is this one or below it.
    pub on_path: bool,
    /// Rays below that are not drawn, and whether the viewer collapsed them.
    pub hidden: usize,
    pub collapsed: bool,
}

/// The drawn part of a tree; children stand behind their parents.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    pub nodes: Vec<Node>,
    /// The node of the current ray, or the collapsed one that contains it.
    pub current: usize,
    /// Rays that are not drawn.
    pub hidden: usize,
}

/// The rays of a state, with how many lie below each.
pub(super) struct Rays<'a> {
    pub state: &'a State,
    /// How wide the widest light is that a node writes.
    pub widest: f32,
    below: Vec<u32>,
    path: Vec<usize>,
}

/// How much there is room for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Enclosure {
    pub leaves: usize,
    pub levels: usize,
}

impl Enclosure {
    pub const ENDLESS: Enclosure = Enclosure {
        leaves: usize::MAX,
        levels: usize::MAX,
    };
}

impl<'a> Rays<'a> {
    pub fn new(state: &'a State) -> Self {
        let mut below = vec![0_u32; state.rays.len()];
        // Rays stand behind their parents.
        for (index, ray) in (0..below.len())
            .rev()
            .filter_map(|i| Some((i, state.rays.get(i)?)))
        {
            if let Some(parent) = ray.parent {
                below[parent] += below[index] + 1;
            }
        }
        let parent = |&index: &usize| state.rays.get(index).and_then(|ray| ray.parent);
        let path = std::iter::successors(state.current, parent).collect();
        Rays {
            state,
            widest: node::widest_light(state),
            below,
            path,
        }
    }

    pub fn len(&self) -> usize {
        self.below.len()
    }

    pub fn ray(&self, node: &Node) -> Option<&'a RayState> {
        match node.of {
            Of::Ray(index) => self.state.rays.get(index),
            Of::Asked => None,
        }
    }

    /// The tree as far as there is room; the way to the current ray is always drawn.
    pub fn pick(&self, collapsed: &BTreeSet<usize>, room: Enclosure) -> Tree {
        let mut tree = Tree {
            nodes: Vec::new(),
            current: 0,
            hidden: 0,
        };
        let mut leaves = 1;
        let (mut path, mut rest) = (VecDeque::new(), VecDeque::new());
        self.push(&mut tree, Of::Ray(0), None);
        path.push_back(0);
        while let Some(node) = path.pop_front().or_else(|| rest.pop_front()) {
            let Some(ray) = self.ray(&tree.nodes[node]) else {
                continue;
            };
            let children = ray.branches.map(|branch| match branch?.outcome {
                Outcome::Ray(index) => Some(Of::Ray(index)),
                Outcome::Open => Some(Of::Asked),
                Outcome::Ended(_) => None,
            });
            let count = children.iter().flatten().count();
            let Node { level, on_path, .. } = tree.nodes[node];
            let folded = collapsed.contains(&ray.step);
            let fits = leaves + count.saturating_sub(1) <= room.leaves && level + 1 < room.levels;
            // The current ray itself is on the path, but its branches need not fit.
            let toward_hand = on_path && self.is_above_hand(tree.nodes[node].of);
            if count > 0 && (folded || !(fits || toward_hand)) {
                let hidden = self.below(tree.nodes[node].of);
                tree.nodes[node].hidden = hidden;
                tree.nodes[node].collapsed = folded;
                tree.hidden += hidden;
                continue;
            }
            leaves += count.saturating_sub(1);
            for (side, child) in children.into_iter().enumerate() {
                let Some(child) = child else { continue };
                let index = self.push(&mut tree, child, Some((node, side)));
                let queue = if tree.nodes[index].on_path {
                    &mut path
                } else {
                    &mut rest
                };
                queue.push_back(index);
            }
        }
        tree
    }

    fn push(&self, tree: &mut Tree, of: Of, parent: Option<(usize, usize)>) -> usize {
        let index = tree.nodes.len();
        let on_path = matches!(of, Of::Ray(ray) if self.path.contains(&ray));
        if on_path {
            tree.current = index;
        }
        let level = parent.map_or(0, |(parent, _)| tree.nodes[parent].level + 1);
        if let Some((parent, side)) = parent {
            tree.nodes[parent].children[side] = Some(index);
        }
        tree.nodes.push(Node {
            of,
            parent,
            children: [None; 2],
            level,
            on_path,
            hidden: 0,
            collapsed: false,
        });
        index
    }

    fn below(&self, of: Of) -> usize {
        match of {
            Of::Ray(index) => self.below[index] as usize,
            Of::Asked => 0,
        }
    }

    fn is_above_hand(&self, of: Of) -> bool {
        matches!(of, Of::Ray(index) if self.state.current != Some(index))
    }
}
