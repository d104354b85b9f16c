//! Where the nodes of the tree lie, and in how much detail each is drawn: the most that fits the room.

use super::pick::{Enclosure, Rays, Tree};
use super::tidy;
use super::view::TreeView;
use crate::picture::Rect;
use glam::Vec2;

/// How much a node says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Detail {
    /// A disc of its colour.
    Dot,
    /// Name and t in one line.
    Line,
    /// Name and t in two short lines.
    Tiny,
    /// And verdicts.
    Small,
    /// And sum and remarks.
    Brief,
    /// And normal, local term, and who blocks.
    Full,
}

impl Detail {
    /// Width, and height without the lines that only some nodes have.
    pub fn size(self) -> Vec2 {
        match self {
            Detail::Dot => Vec2::new(10.0, 10.0),
            Detail::Line => Vec2::new(142.0, 20.0),
            Detail::Tiny => Vec2::new(92.0, 34.0),
            Detail::Small => Vec2::new(134.0, 38.0),
            Detail::Brief => Vec2::new(140.0, 53.0),
            Detail::Full => Vec2::new(206.0, 85.0),
        }
    }

    /// Between two nodes of a level, and between two levels.
    fn gap(self) -> Vec2 {
        match self {
            Detail::Dot => Vec2::new(4.0, 13.0),
            Detail::Line => Vec2::new(6.0, 18.0),
            Detail::Tiny => Vec2::new(8.0, 28.0),
            Detail::Small => Vec2::new(10.0, 30.0),
            Detail::Brief => Vec2::new(14.0, 32.0),
            Detail::Full => Vec2::new(18.0, 38.0),
        }
    }
}

/// Height of a further line, in the same units.
pub(super) const LINE: f32 = 16.0;
/// Under the last level, for what hangs below a node.
const FOOT: f32 = 16.0;
/// Trees of more rays are never drawn whole.
const MOST_NODES: usize = 1500;
/// How far a tree is drawn apart to fill the room, when the whole is shown.
const APART: f32 = 1.7;
/// How much larger than needed texts become.
const LARGER: f32 = 1.15;

/// A tree with the place of each node, in points of the panel.
pub(super) struct Arrangement {
    pub tree: Tree,
    pub details: Vec<Detail>,
    pub rects: Vec<Rect>,
    /// How much larger than usual everything is drawn.
    pub scale: f32,
    /// What lies in the middle of the area, as shares of the tree's box.
    pub middle: Vec2,
}

/// Before it is stretched and put in place: centres, and the top and height of each level.
struct Natural {
    details: Vec<Detail>,
    centers: Vec<f32>,
    rows: Vec<f32>,
    /// Below each row.
    gaps: Vec<f32>,
    /// Left and right end.
    extent: (f32, f32),
}

impl Natural {
    fn new(rays: &Rays, tree: &Tree, detail: impl Fn(usize) -> Detail) -> Self {
        let details: Vec<Detail> = (0..tree.nodes.len()).map(detail).collect();
        let nodes: Vec<tidy::Node> = tree
            .nodes
            .iter()
            .zip(&details)
            .map(|(node, detail)| tidy::Node {
                width: detail.size().x,
                children: node.children,
            })
            .collect();
        let least = details.iter().copied().min().unwrap_or(Detail::Dot);
        let centers = tidy::centers(&nodes, least.gap().x);
        let mut rows = Vec::new();
        let mut most = Vec::new();
        let (mut left, mut right) = (0.0_f32, 0.0_f32);
        for (i, node) in tree.nodes.iter().enumerate() {
            if rows.len() <= node.level {
                rows.resize(node.level + 1, 0.0_f32);
                most.resize(node.level + 1, Detail::Dot);
            }
            most[node.level] = most[node.level].max(details[i]);
            let height = height(rays, tree, i, details[i]);
            rows[node.level] = rows[node.level].max(height);
            left = left.min(centers[i] - 0.5 * nodes[i].width);
            right = right.max(centers[i] + 0.5 * nodes[i].width);
        }
        // Discs need no room for labels between them.
        let mut gaps: Vec<f32> = most
            .windows(2)
            .map(|pair| match pair {
                [above, Detail::Dot] if *above > Detail::Dot => Detail::Line.gap().y,
                pair => pair[0].min(pair[1]).gap().y,
            })
            .collect();
        gaps.push(FOOT);
        Natural {
            gaps,
            details,
            centers,
            rows,
            extent: (left, right),
        }
    }

    fn size(&self) -> Vec2 {
        let height = self.rows.iter().chain(&self.gaps).sum();
        Vec2::new(self.extent.1 - self.extent.0, height)
    }

    fn fits(&self, room: Vec2) -> bool {
        self.size().cmple(room).all()
    }
}

/// Height of a node, with the lines that it has more than others.
pub(super) fn height(rays: &Rays, tree: &Tree, node: usize, detail: Detail) -> f32 {
    let further = rays
        .ray(&tree.nodes[node])
        .map_or(0, |ray| super::node::further_lines(ray, detail));
    detail.size().y + LINE * further as f32
}

/// The most detail that fits `area` at the view's zoom.
pub(super) fn arrange(rays: &Rays, view: &TreeView, area: Rect) -> Arrangement {
    let size = Vec2::new(area.width, area.height);
    let room = view.shown.zoom * size;
    let (tree, natural) = whole(rays, view, room).unwrap_or_else(|| in_part(rays, view, room));
    place(rays, tree, natural, view, area)
}

/// All of the tree in one detail, if it fits.
fn whole(rays: &Rays, view: &TreeView, room: Vec2) -> Option<(Tree, Natural)> {
    if rays.len() > MOST_NODES {
        return None;
    }
    let tree = rays.pick(&view.collapsed, Enclosure::ENDLESS);
    const LEAST_FIRST: [Detail; 5] = [
        Detail::Line,
        Detail::Tiny,
        Detail::Small,
        Detail::Brief,
        Detail::Full,
    ];
    let natural = LEAST_FIRST
        .into_iter()
        .rev()
        .map(|detail| Natural::new(rays, &tree, |_| detail))
        .find(|natural| natural.fits(room))?;
    Some((tree, natural))
}

/// What is named of a large tree.
#[derive(Clone, Copy)]
struct Named {
    /// So many levels from the root down.
    levels: usize,
    /// So many levels before the current ray, on the way to it.
    before_hand: usize,
    detail: Detail,
}

impl Named {
    /// The current ray alone.
    const LEAST: Named = Named {
        levels: 0,
        before_hand: 0,
        detail: Detail::Line,
    };

    /// All choices, the most first.
    fn choices() -> impl Iterator<Item = Named> {
        let from_root = (0..=6).rev().map(|levels| (levels, usize::MAX));
        from_root
            .chain([(0, 3), (0, 0)])
            .flat_map(|(levels, before_hand)| {
                [Detail::Tiny, Detail::Line].map(|detail| Named {
                    levels,
                    before_hand,
                    detail,
                })
            })
    }

    fn lay_out(self, rays: &Rays, tree: &Tree) -> Natural {
        let hand = tree.nodes[tree.current].level;
        Natural::new(rays, tree, |node| {
            let at = &tree.nodes[node];
            let sent_on = at.parent.is_some_and(|(parent, _)| parent == tree.current);
            let on_way = at.on_path && hand - at.level <= self.before_hand;
            if on_way || at.level < self.levels || self.levels > 0 && sent_on {
                self.detail
            } else {
                Detail::Dot
            }
        })
    }
}

/// As many rays as there is room for as discs; names along the way to the current ray and on the levels near the root, where
/// they fit.
fn in_part(rays: &Rays, view: &TreeView, room: Vec2) -> (Tree, Natural) {
    let (dot, gap) = (Detail::Dot.size(), Detail::Dot.gap());
    let levels = (room.y / (dot.y + gap.y)).max(2.0) as usize;
    let pick = |leaves| rays.pick(&view.collapsed, Enclosure { leaves, levels });
    // Subtrees reach under each other, so there may be room for more leaves than side by side.
    let (mut fitting, mut too_many) = (2, MOST_NODES.min(2 * (room.x / dot.x) as usize + 4));
    while too_many - fitting > 1 + fitting / 16 {
        let leaves = fitting.midpoint(too_many);
        if Named::LEAST.lay_out(rays, &pick(leaves)).fits(room) {
            fitting = leaves;
        } else {
            too_many = leaves;
        }
    }
    let tree = pick(fitting);
    let natural = Named::choices()
        .map(|named| named.lay_out(rays, &tree))
        .find(|natural| natural.fits(room))
        .unwrap_or_else(|| Named::LEAST.lay_out(rays, &tree));
    (tree, natural)
}

fn place(rays: &Rays, tree: Tree, natural: Natural, view: &TreeView, area: Rect) -> Arrangement {
    let size = Vec2::new(area.width, area.height);
    let room = view.shown.zoom * size;
    let needed = natural.size();
    let spare = (room / needed).min_element();
    let scale = if natural.details.contains(&Detail::Dot) {
        1.0
    } else {
        spare.clamp(1.0, LARGER * view.shown.zoom.sqrt())
    };
    let apart = (room.x / (scale * needed.x)).clamp(1.0, APART * view.shown.zoom);
    // The levels are drawn apart alike; what height is left then goes above and below.
    let between: f32 = scale * natural.gaps.iter().sum::<f32>();
    let spread = (1.0 + (room.y - scale * needed.y) / between).clamp(1.0, APART * view.shown.zoom);
    let left_over = room.y - scale * needed.y - (spread - 1.0) * between;

    let (left, right) = natural.extent;
    let center_x = 0.5 * room.x - 0.5 * scale * apart * (left + right);
    let mut tops = Vec::with_capacity(natural.rows.len());
    let mut y = (0.25 * left_over).max(0.0);
    for (row, gap) in natural.rows.iter().zip(&natural.gaps) {
        tops.push(y);
        y += scale * (row + spread * gap);
    }
    let mut rects: Vec<Rect> = tree
        .nodes
        .iter()
        .enumerate()
        .map(|(i, node)| {
            let detail = natural.details[i];
            let width = scale * detail.size().x;
            let height = scale * height(rays, &tree, i, detail);
            let x = center_x + scale * apart * natural.centers[i] - 0.5 * width;
            Rect::new(x, tops[node.level], width, height)
        })
        .collect();

    // What is in the middle: the viewer's choice, else the current ray; and nothing beyond the tree.
    let overhang = (0.5 * (scale * apart * (right - left) - room.x)).max(0.0);
    let low = Vec2::new(-overhang, 0.0) + 0.5 * size;
    let high = Vec2::new(room.x + overhang, room.y.max(y)) - 0.5 * size;
    let wanted = match view.shown.center {
        Some(center) => center * room,
        None => rects[tree.current].center(),
    };
    let middle = wanted.clamp(low, high.max(low));
    let offset = area.center() - middle;
    rects
        .iter_mut()
        .for_each(|rect| *rect = rect.shifted(offset));
    Arrangement {
        tree,
        details: natural.details,
        rects,
        scale,
        middle: middle / room,
    }
}
