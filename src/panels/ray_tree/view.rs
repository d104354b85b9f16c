//! How much of a ray tree is looked at.

use crate::figure::View;
use std::collections::BTreeSet;

/// The part of the tree that is drawn; where no place was chosen for its middle, it follows the current ray.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeView {
    pub shown: View,
    /// Rays whose secondary rays are not drawn, by the step that opened them.
    pub collapsed: BTreeSet<usize>,
}

impl TreeView {
    /// The whole tree, nothing collapsed.
    pub const WHOLE: TreeView = TreeView {
        shown: View::WHOLE,
        collapsed: BTreeSet::new(),
    };

    /// The whole tree, for who never chooses.
    pub fn whole() -> &'static TreeView {
        static WHOLE: TreeView = TreeView::WHOLE;
        &WHOLE
    }

    /// Looked at in another way; what is collapsed stays so.
    pub fn showing(&self, shown: View) -> Self {
        TreeView {
            shown,
            collapsed: self.collapsed.clone(),
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
