//! What of the panel is drawn where: the tree first, then the row of levels and the card as far as there is room.

use super::arrange::{Arrangement, Detail, arrange};
use super::levels;
use super::pick::Rays;
use super::view::TreeView;
use crate::picture::Rect;
use glam::Vec2;

const MARGIN: f32 = 6.0;
/// Of the line above the tree.
const HEAD: f32 = 18.0;
/// Lower panels have neither card nor row under the tree.
const HIGH: f32 = 300.0;
/// Narrower panels have no card beside it.
const WIDE: f32 = 560.0;

pub(super) struct Places {
    pub head: Rect,
    pub tree: Rect,
    pub levels: Option<Rect>,
    pub card: CardPlace,
}

#[derive(Clone, Copy)]
pub(super) enum CardPlace {
    /// With the line between it and the rest.
    Whole { rect: Rect, rule: [Vec2; 2] },
    /// One line.
    Line(Rect),
}

impl Places {
    /// The places in a panel of that size, and the tree in its place. The card gives way where the tree needs its
    /// room.
    pub fn new(rays: &Rays, view: &TreeView, size: Vec2) -> (Self, Arrangement) {
        let fitted = view.fitted();
        let named = |places: &Places| {
            let fits = arrange(rays, &fitted, places.tree).details;
            fits.iter().all(|&detail| detail > Detail::Dot)
        };
        let mut choices = Places::choices(rays, size);
        let best = choices.iter().position(named);
        let places = choices.swap_remove(best.unwrap_or(choices.len() - 1));
        let arrangement = arrange(rays, view, places.tree);
        (places, arrangement)
    }

    /// From the most that is said beside the tree to the least.
    fn choices(rays: &Rays, size: Vec2) -> Vec<Self> {
        let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-MARGIN);
        let head = Rect::new(whole.x, whole.y - 2.0, whole.width, HEAD);
        let body = Rect::between((whole.x, head.bottom()), whole.max());
        if body.height >= HIGH {
            let row = levels::height(&levels::Scale::of(&[rays.state]), body.width - 8.0);
            let card = if body.width >= 620.0 {
                (0.3 * body.height).clamp(124.0, 180.0)
            } else {
                (0.36 * body.height).clamp(124.0, 260.0)
            };
            return [card, HEAD]
                .map(|card| Places::below(head, body, row, card))
                .into();
        }
        let beside = (body.width >= WIDE).then(|| Places::beside(head, body));
        let line = Places::below(head, body, 0.0, HEAD);
        beside.into_iter().chain([line]).collect()
    }

    /// Row and card under the tree.
    fn below(head: Rect, body: Rect, row: f32, card: f32) -> Self {
        let whole = card > HEAD;
        let gap = if whole { 6.0 } else { 0.0 };
        let under = body.bottom() - card;
        let card = if whole {
            CardPlace::Whole {
                rect: Rect::new(body.x + 4.0, under, body.width - 8.0, card),
                rule: [
                    Vec2::new(body.x, under - gap),
                    Vec2::new(body.right(), under - gap),
                ],
            }
        } else {
            CardPlace::Line(Rect::new(body.x, under + 3.0, body.width, card))
        };
        let row_top = under - 2.0 * gap - row;
        let levels = Rect::new(body.x + 4.0, row_top, body.width - 8.0, row);
        Places {
            head,
            tree: Rect::between(
                body.min(),
                (body.right(), row_top - if row > 0.0 { 4.0 } else { 0.0 }),
            ),
            levels: Some(levels).filter(|_| row > 0.0),
            card,
        }
    }

    /// The card beside the tree.
    fn beside(head: Rect, body: Rect) -> Self {
        let width = (0.42 * body.width).clamp(250.0, 420.0);
        let tree = Rect::new(body.x, body.y, body.width - width - 16.0, body.height);
        let x = tree.right() + 7.0;
        Places {
            head,
            tree,
            levels: None,
            card: CardPlace::Whole {
                rect: Rect::new(tree.right() + 16.0, body.y, width - 2.0, body.height),
                rule: [Vec2::new(x, body.y), Vec2::new(x, body.bottom())],
            },
        }
    }
}
