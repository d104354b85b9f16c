//! How much of a ray tree is looked at.

use glam::Vec2;
use std::collections::BTreeSet;

/// The part of the tree that is drawn; where no node is held in its place, it follows the current ray.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeView {
    /// 1 where the whole fits, at most [`TreeView::LARGEST`].
    pub zoom: f32,
    pub held: Option<HeldNode>,
    /// Rays whose secondary rays are not drawn, by the step that opened them.
    pub collapsed: BTreeSet<usize>,
}

/// A node that stays where it is on the screen while the tree around it grows or shrinks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldNode {
    /// The step that opened its ray.
    pub ray: usize,
    /// Its middle, in points from the middle of the tree's area.
    pub at: Vec2,
}

impl TreeView {
    pub const LARGEST: f32 = 32.0;
    /// The whole tree, nothing collapsed.
    pub const WHOLE: TreeView = TreeView {
        zoom: 1.0,
        held: None,
        collapsed: BTreeSet::new(),
    };

    /// The whole tree, for who never chooses.
    pub fn whole() -> &'static TreeView {
        static WHOLE: TreeView = TreeView::WHOLE;
        &WHOLE
    }

    /// All of what is not collapsed.
    pub fn fitted(&self) -> Self {
        TreeView {
            collapsed: self.collapsed.clone(),
            ..TreeView::WHOLE
        }
    }

    /// `factor` times as large about `node`; a whole tree has no place to choose.
    pub fn zoomed(&self, factor: f32, node: Option<HeldNode>) -> Self {
        let zoom = (self.zoom * factor).clamp(1.0, TreeView::LARGEST);
        TreeView {
            zoom,
            held: node.filter(|_| zoom > 1.0),
            collapsed: self.collapsed.clone(),
        }
    }

    /// Dragged by so many points at `node`.
    pub fn dragged(&self, by: Vec2, node: HeldNode) -> Self {
        let held = HeldNode {
            at: node.at + by,
            ..node
        };
        TreeView {
            held: Some(held).filter(|_| self.zoom > 1.0),
            ..self.clone()
        }
    }

    /// A ray is collapsed, or expanded again.
    pub fn toggled(&self, step: usize) -> Self {
        let mut view = self.clone();
        if !view.collapsed.remove(&step) {
            view.collapsed.insert(step);
        }
        view
    }
}

#[cfg(test)]
mod tests;
