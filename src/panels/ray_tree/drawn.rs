//! The tree itself: edges, then nodes with the signs under them.

use super::arrange::Arrangement;
use super::node::{Describer, Standing};
use super::pick::Rays;
use super::{edges, lines, node, sign};
use crate::picture::{Picture, Rect, Tag};

/// A tree in its place.
pub(super) struct ShownTree<'a> {
    pub rays: &'a Rays<'a>,
    pub arrangement: &'a Arrangement,
    /// The ray whose light comes up at this step.
    pub rising: Option<usize>,
    /// Whether it is the tree of the step, not one of another run.
    pub is_now: bool,
}

impl ShownTree<'_> {
    pub fn draw(&self, picture: &mut Picture, describer: &Describer, area: Rect) {
        let (rays, arrangement) = (self.rays, self.arrangement);
        edges::draw(
            picture,
            rays,
            arrangement,
            self.rising,
            describer.language,
            area,
        );
        self.nodes(picture, describer, area);
    }

    fn nodes(&self, picture: &mut Picture, describer: &Describer, area: Rect) {
        let (rays, arrangement) = (self.rays, self.arrangement);
        let current = arrangement.tree.current;
        // The current node lies on top.
        let order = (0..arrangement.rects.len()).filter(|&node| node != current);
        for index in order.chain([current]) {
            let node = &arrangement.tree.nodes[index];
            let (whole, detail) = (arrangement.rects[index], arrangement.details[index]);
            if whole.intersection(&area).is_empty() {
                continue;
            }
            let ray = rays.ray(node);
            let standing = match ray {
                _ if index == current && self.is_now => Standing::Current,
                None => Standing::Asked,
                Some(ray) if ray.returned.is_some() => Standing::Returned,
                Some(_) => Standing::Open,
            };
            let add = |picture: &mut Picture| {
                let write = |picture: &mut Picture| {
                    node::frame(picture, whole, standing, ray, detail);
                    lines::write(picture, describer, whole, ray, detail, arrangement.scale);
                };
                match area.grown(0.5).encloses(&whole) {
                    true => write(picture),
                    false => drop(picture.clipped(area, write)),
                }
            };
            match ray {
                Some(ray) => {
                    picture.tagged(Tag::Scope(ray.step), add);
                }
                None => add(picture),
            }
            if let Some(ray) = ray {
                sign::draw(picture, describer, ray, node, (whole, detail), area);
            }
        }
    }
}
