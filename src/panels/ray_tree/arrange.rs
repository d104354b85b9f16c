//! Where the nodes of the tree lie, and in how much detail each is drawn: the most that fits the room.

use super::pick::{Rays, Room, Tree};
use super::tidy;
use super::view::TreeView;
use crate::picture::Rect;
use glam::Vec2;

/// How much a node says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Detail {
    /// A disc of its colour.
    Dot,
    /// Name and t.
    Small,
    /// And verdicts, sum and remarks.
    Brief,
    /// And normal, local term, and who blocks.
    Full,
}

impl Detail {
    /// Width, and height without the lines that only some nodes have.
    pub fn size(self) -> Vec2 {
        match self {
            Detail::Dot => Vec2::new(10.0, 10.0),
            Detail::Small => Vec2::new(78.0, 33.0),
            Detail::Brief => Vec2::new(132.0, 53.0),
            Detail::Full => Vec2::new(198.0, 85.0),
        }
    }

    /// Between two nodes of a level, and between two levels.
    fn gap(self) -> Vec2 {
        match self {
            Detail::Dot => Vec2::new(4.0, 13.0),
            Detail::Small => Vec2::new(8.0, 27.0),
            Detail::Brief => Vec2::new(14.0, 34.0),
            Detail::Full => Vec2::new(18.0, 38.0),
        }
    }
}

/// Height of a further line, in the same units.
pub(super) const LINE: f32 = 16.0;
/// Under the last level, for what hangs below a node.
const FOOT: f32 = 20.0;
/// Trees of more rays are never drawn whole.
const MOST_NODES: usize = 1500;
/// What is named of a large tree, the most first: so many levels from the root down, and so many before the ray in hand.
const NAMED: [(usize, usize); 10] = [
    (8, 64),
    (6, 64),
    (5, 64),
    (4, 64),
    (3, 64),
    (2, 64),
    (1, 64),
    (0, 64),
    (0, 3),
    (0, 0),
];
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
    tree: Tree,
    details: Vec<Detail>,
    centers: Vec<f32>,
    rows: Vec<f32>,
    gap: f32,
    /// Left and right end.
    extent: (f32, f32),
}

impl Natural {
    fn new(rays: &Rays, tree: Tree, detail: impl Fn(usize) -> Detail) -> Self {
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
        let most = details.iter().copied().max().unwrap_or(Detail::Dot);
        let least = details.iter().copied().min().unwrap_or(Detail::Dot);
        let centers = tidy::centers(&nodes, least.gap().x);
        let mut rows = Vec::new();
        let (mut left, mut right) = (0.0_f32, 0.0_f32);
        for (i, node) in tree.nodes.iter().enumerate() {
            if rows.len() <= node.level {
                rows.resize(node.level + 1, 0.0_f32);
            }
            let height = height(rays, &tree, i, details[i]);
            rows[node.level] = rows[node.level].max(height);
            left = left.min(centers[i] - 0.5 * nodes[i].width);
            right = right.max(centers[i] + 0.5 * nodes[i].width);
        }
        Natural {
            gap: most.gap().y,
            tree,
            details,
            centers,
            rows,
            extent: (left, right),
        }
    }

    fn size(&self) -> Vec2 {
        let gaps = self.gap * (self.rows.len() as f32 - 1.0);
        let height = self.rows.iter().sum::<f32>() + gaps + FOOT;
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
    let room = view.zoom * size;
    let natural = whole(rays, view, room).unwrap_or_else(|| in_part(rays, view, room));
    place(rays, natural, view, area)
}

/// All of the tree in one detail, if it fits.
fn whole(rays: &Rays, view: &TreeView, room: Vec2) -> Option<Natural> {
    if rays.len() > MOST_NODES {
        return None;
    }
    let tree = rays.pick(&view.collapsed, Room::ENDLESS);
    [Detail::Full, Detail::Brief, Detail::Small]
        .into_iter()
        .map(|detail| Natural::new(rays, tree.clone(), |_| detail))
        .find(|natural| natural.fits(room))
}

/// Names along the way to the ray in hand and, where they fit, on the levels near the root; discs elsewhere; and no more of
/// those than there is room for.
fn in_part(rays: &Rays, view: &TreeView, room: Vec2) -> Natural {
    let (dot, gap) = (Detail::Dot.size(), Detail::Dot.gap());
    let mut leaves = (room.x / (dot.x + gap.x)).max(2.0) as usize;
    let mut last = None;
    for _ in 0..12 {
        let levels = (room.y / (dot.y + gap.y)).max(2.0) as usize;
        let within = Room {
            leaves: leaves.min(MOST_NODES),
            levels,
        };
        let tree = rays.pick(&view.collapsed, within);
        let hand = tree.nodes[tree.in_hand].level;
        for (named, before_hand) in NAMED {
            let natural = Natural::new(rays, tree.clone(), |node| {
                let at = &tree.nodes[node];
                let sent_on = at.parent.is_some_and(|(parent, _)| parent == tree.in_hand);
                let on_way = at.on_path && at.level + before_hand >= hand;
                if on_way || at.level < named || named > 0 && sent_on {
                    Detail::Small
                } else {
                    Detail::Dot
                }
            });
            if natural.fits(room) {
                return natural;
            }
            last = Some(natural);
        }
        if leaves <= 2 {
            break;
        }
        leaves = (leaves * 2 / 3).max(2);
    }
    last.unwrap_or_else(|| {
        Natural::new(rays, rays.pick(&view.collapsed, Room::ENDLESS), |_| {
            Detail::Dot
        })
    })
}

fn place(rays: &Rays, natural: Natural, view: &TreeView, area: Rect) -> Arrangement {
    let size = Vec2::new(area.width, area.height);
    let room = view.zoom * size;
    let needed = natural.size();
    let spare = (room / needed).min_element();
    let scale = if natural.details.contains(&Detail::Dot) {
        1.0
    } else {
        spare.clamp(1.0, LARGER * view.zoom.sqrt())
    };
    let apart = (room.x / (scale * needed.x)).clamp(1.0, APART * view.zoom);
    let gaps = (natural.rows.len() as f32 - 1.0).max(1.0);
    let more = (room.y - scale * needed.y).max(0.0) / gaps;
    let gap = scale * natural.gap + more.min(APART * view.zoom * natural.gap);

    let (left, right) = natural.extent;
    let center_x = 0.5 * room.x - 0.5 * scale * apart * (left + right);
    let mut tops = Vec::with_capacity(natural.rows.len());
    let mut y = 0.0;
    for row in &natural.rows {
        tops.push(y);
        y += scale * row + gap;
    }
    let mut rects: Vec<Rect> = natural
        .tree
        .nodes
        .iter()
        .enumerate()
        .map(|(i, node)| {
            let detail = natural.details[i];
            let width = scale * detail.size().x;
            let height = scale * height(rays, &natural.tree, i, detail);
            let x = center_x + scale * apart * natural.centers[i] - 0.5 * width;
            Rect::new(x, tops[node.level], width, height)
        })
        .collect();

    // What is in the middle: the viewer's choice, else the ray in hand; and nothing beyond the tree.
    let overhang = (0.5 * (scale * apart * (right - left) - room.x)).max(0.0);
    let low = Vec2::new(-overhang, 0.0) + 0.5 * size;
    let high = Vec2::new(room.x + overhang, room.y.max(y - gap + FOOT)) - 0.5 * size;
    let wanted = match view.center {
        Some(center) => center * room,
        None => rects[natural.tree.in_hand].center(),
    };
    let middle = wanted.clamp(low, high.max(low));
    let offset = area.center() - middle;
    rects
        .iter_mut()
        .for_each(|rect| *rect = rect.shifted(offset));
    Arrangement {
        tree: natural.tree,
        details: natural.details,
        rects,
        scale,
        middle: middle / room,
    }
}
