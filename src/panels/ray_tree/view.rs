//! How much of a ray tree is looked at: a choice of the viewer, which changes nothing of the run.

use glam::Vec2;
use std::collections::BTreeSet;

/// The part of the tree that is drawn, and how large.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeView {
    /// 1 where the whole tree fits the panel, at most [`TreeView::LARGEST`].
    pub zoom: f32,
    /// The place in the middle of the panel, as shares of the tree's width and height; none follows the ray in hand.
    pub center: Option<Vec2>,
    /// Rays whose secondary rays are not drawn, by the step that opened them.
    pub collapsed: BTreeSet<usize>,
}

impl TreeView {
    pub const LARGEST: f32 = 32.0;
    /// The whole tree, nothing collapsed.
    pub const WHOLE: TreeView = TreeView {
        zoom: 1.0,
        center: None,
        collapsed: BTreeSet::new(),
    };

    /// The whole tree, for who never chooses.
    pub fn whole() -> &'static TreeView {
        static WHOLE: TreeView = TreeView::WHOLE;
        &WHOLE
    }

    /// The whole tree again; what is collapsed stays so.
    pub fn fit(&self) -> Self {
        TreeView {
            collapsed: self.collapsed.clone(),
            ..TreeView::WHOLE
        }
    }

    /// `factor` times as large about its middle.
    pub fn zoomed(&self, factor: f32) -> Self {
        let zoom = (self.zoom * factor).clamp(1.0, TreeView::LARGEST);
        TreeView {
            zoom,
            center: self
                .center
                .filter(|_| zoom > 1.0)
                .map(|center| within(center, zoom)),
            collapsed: self.collapsed.clone(),
        }
    }

    /// `factor` times as large about a place, where `middle` is in the middle now. The place is `from_middle` points from the
    /// middle of an area `size` points large.
    pub fn zoomed_about(&self, factor: f32, middle: Vec2, from_middle: Vec2, size: Vec2) -> Self {
        let zoomed = self.zoomed(factor);
        if zoomed.zoom == 1.0 {
            return zoomed;
        }
        let kept = middle + from_middle / (self.zoom * size);
        let center = kept - from_middle / (zoomed.zoom * size);
        TreeView {
            center: Some(within(center, zoomed.zoom)),
            ..zoomed
        }
    }

    /// Dragged by so many points.
    pub fn dragged(&self, by: Vec2, middle: Vec2, size: Vec2) -> Self {
        let center = within(middle - by / (self.zoom * size), self.zoom);
        TreeView {
            center: Some(center).filter(|_| self.zoom > 1.0),
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

/// The nearest middle that shows nothing beyond the tree.
fn within(center: Vec2, zoom: f32) -> Vec2 {
    let half = 0.5 / zoom;
    center.clamp(Vec2::splat(half), Vec2::splat(1.0 - half))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_under_the_pointer_stays_there() {
        let (size, from_middle) = (Vec2::new(400.0, 300.0), Vec2::new(60.0, -40.0));
        let view = TreeView::WHOLE.zoomed(4.0);
        let middle = Vec2::new(0.5, 0.4);
        let place = middle + from_middle / (view.zoom * size);
        let nearer = view.zoomed_about(1.5, middle, from_middle, size);
        let after = nearer.center.unwrap() + from_middle / (nearer.zoom * size);
        assert!(place.distance(after) < 1e-6);
    }

    #[test]
    fn nothing_beyond_the_tree_is_shown_and_the_whole_follows_again() {
        let size = Vec2::new(400.0, 300.0);
        let view = TreeView::WHOLE
            .zoomed(2.0)
            .dragged(Vec2::splat(1e6), Vec2::splat(0.5), size);
        assert_eq!(view.center, Some(Vec2::splat(0.25)));
        assert_eq!(view.zoomed(0.1), TreeView::WHOLE);
        assert_eq!(
            TreeView::WHOLE
                .dragged(Vec2::X, Vec2::splat(0.5), size)
                .center,
            None
        );
        assert_eq!(view.toggled(7).toggled(7), view);
        assert!(view.toggled(7).fit().collapsed.contains(&7));
    }
}
