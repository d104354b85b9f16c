//! Where the nodes of the tree lie, and in how much detail each is drawn: the most that fits the room.

use super::pick::{Enclosure, Of, Rays, Tree};
use super::tidy;
use super::view::TreeView;
use crate::picture::Rect;
use glam::Vec2;

/// How much a node says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Detail {
    /// A disc of its colour.
    Dot,
    /// Name and t in one line, local term and sum in the next.
    Short,
    /// Name and t, local term, and sum, each in a line.
    Stacked,
    /// And verdicts, in larger letters.
    Brief,
    /// And normal, and who blocks.
    Full,
}

impl Detail {
    /// From the most to the least that names its rays.
    const NAMED: [Detail; 4] = [Detail::Full, Detail::Brief, Detail::Stacked, Detail::Short];

    /// Width, and height without the lines that only some nodes have, where the widest light is so wide.
    pub fn size(self, light: f32) -> Vec2 {
        match self {
            Detail::Dot => Vec2::new(10.0, 10.0),
            Detail::Short => Vec2::new((76.0 + 2.0 * light).max(146.0), 34.0),
            Detail::Stacked => Vec2::new((54.0 + light).max(126.0), 48.0),
            Detail::Brief => Vec2::new((54.0 + light).max(146.0), 69.0),
            Detail::Full => Vec2::new((54.0 + light).max(206.0), 85.0),
        }
    }

    /// Between two nodes of a level, and between two levels.
    fn gap(self) -> Vec2 {
        match self {
            Detail::Dot => Vec2::new(4.0, 13.0),
            Detail::Short => Vec2::new(8.0, 24.0),
            Detail::Stacked => Vec2::new(10.0, 28.0),
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
/// How far a tree is drawn apart at most to fill the room.
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
                width: detail.size(rays.widest).x,
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
                [above, Detail::Dot] if *above > Detail::Dot => Detail::Short.gap().y,
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

    /// Width and height that the largest nodes have.
    fn largest(&self, rays: &Rays, tree: &Tree) -> Vec2 {
        let sizes = self.details.iter().enumerate().map(|(node, &detail)| {
            Vec2::new(detail.size(rays.widest).x, height(rays, tree, node, detail))
        });
        sizes.fold(Vec2::ONE, Vec2::max)
    }
}

/// Height of a node, with the lines that it has more than others.
pub(super) fn height(rays: &Rays, tree: &Tree, node: usize, detail: Detail) -> f32 {
    let further = rays
        .ray(&tree.nodes[node])
        .map_or(0, |ray| super::lines::further_lines(ray, detail));
    detail.size(rays.widest).y + LINE * further as f32
}

/// The most detail that fits `area` at the view's zoom.
pub(super) fn arrange(rays: &Rays, view: &TreeView, area: Rect) -> Arrangement {
    let size = Vec2::new(area.width, area.height);
    let room = view.zoom * size;
    let (tree, natural) = whole(rays, view, room).unwrap_or_else(|| in_part(rays, view, room));
    place(rays, tree, natural, view, area)
}

/// All of the tree in one detail, if it fits.
fn whole(rays: &Rays, view: &TreeView, room: Vec2) -> Option<(Tree, Natural)> {
    if rays.len() > MOST_NODES {
        return None;
    }
    let tree = rays.pick(&view.collapsed, Enclosure::ENDLESS);
    let natural = Detail::NAMED
        .into_iter()
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
        detail: Detail::Short,
    };

    /// All choices, the most first.
    fn choices() -> impl Iterator<Item = Named> {
        let from_root = (0..=6).rev().map(|levels| (levels, usize::MAX));
        from_root
            .chain([(0, 3), (0, 0)])
            .flat_map(|(levels, before_hand)| {
                [Detail::Stacked, Detail::Short].map(|detail| Named {
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
    let (dot, gap) = (Detail::Dot.size(rays.widest), Detail::Dot.gap());
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
    let needed = natural.size();
    let spare = (view.zoom * size / needed).min_element();
    let scale = if natural.details.contains(&Detail::Dot) {
        1.0
    } else {
        // No node outgrows the area.
        let one = natural.largest(rays, &tree);
        let most = (size / one).min_element().max(1.0);
        spare.clamp(1.0, LARGER * view.zoom.sqrt()).min(most)
    };
    // Branches and levels are drawn apart to fill the area, but not as far as the viewer zooms: no void opens between them.
    let apart = (view.zoom * size.x / (scale * needed.x)).clamp(1.0, APART);
    let between: f32 = scale * natural.gaps.iter().sum::<f32>();
    let spread = (1.0 + (size.y - scale * needed.y) / between).clamp(1.0, APART);
    let left_over = size.y - scale * needed.y - (spread - 1.0) * between;

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
            let width = scale * detail.size(rays.widest).x;
            let height = scale * height(rays, &tree, i, detail);
            let x = scale * apart * natural.centers[i] - 0.5 * width;
            Rect::new(x, tops[node.level], width, height)
        })
        .collect();
    let (left, right) = natural.extent;
    let whole = Rect::between(
        (scale * apart * left, 0.0),
        (scale * apart * right, y.max(size.y)),
    );
    let offset = offset(rays, &tree, &rects, whole, view, area);
    rects
        .iter_mut()
        .for_each(|rect| *rect = rect.shifted(offset));
    Arrangement {
        tree,
        details: natural.details,
        rects,
        scale,
    }
}

/// How far the tree, whose box is `whole`, is moved into its area: to where the viewer holds a node, else to the current ray; and
/// never so far that the area shows what is beyond the tree, or no node.
fn offset(
    rays: &Rays,
    tree: &Tree,
    rects: &[Rect],
    whole: Rect,
    view: &TreeView,
    area: Rect,
) -> Vec2 {
    let (node, at) = match view.held {
        Some(held) => (drawn(rays, tree, held.ray), held.at),
        None => (tree.current, Vec2::ZERO),
    };
    let wanted = area.center() + at - rects[node].center();
    let within = |wanted: f32, low: f32, length: f32, start: f32, room: f32| {
        let (first, last) = (start - low, start + room - low - length);
        match length <= room {
            true => start + 0.5 * (room - length) - low,
            false => wanted.clamp(last, first),
        }
    };
    let offset = Vec2::new(
        within(wanted.x, whole.x, whole.width, area.x, area.width),
        within(wanted.y, whole.y, whole.height, area.y, area.height),
    );
    // From each node the way into the area; where one is there already, none.
    let ways = rects.iter().map(|rect| {
        let rect = rect.shifted(offset);
        let (low, high) = (area.min() - rect.min(), area.max() - rect.max());
        Vec2::ZERO.clamp(low.min(high), high.max(low))
    });
    let shortest = ways.min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    offset + shortest.unwrap_or_default()
}

/// The node of the ray that a step opened, or the one that it is collapsed into.
fn drawn(rays: &Rays, tree: &Tree, step: usize) -> usize {
    let index = rays.state.rays.iter().position(|ray| ray.step == step);
    let parent = |&index: &usize| rays.state.rays.get(index).and_then(|ray| ray.parent);
    let way = std::iter::successors(index, parent);
    let node = |index| {
        let nodes = &mut tree.nodes.iter();
        nodes.position(|node| node.of == Of::Ray(index))
    };
    way.into_iter().find_map(node).unwrap_or(tree.current)
}
