//! The window of a phone: the key panel, below it what is said, and the buttons where the thumb is. Held across, what is said stands
//! beside the key panel.

use super::GAP;
use egui::{Rect, Vec2, pos2, vec2};

/// The least side of what a finger is to meet, in points.
pub const TARGET: f32 = 44.0;
/// A window is narrow below this width, and low below this height; both are laid out for fingers.
const WIDE: f32 = 700.0;
const HIGH: f32 = 480.0;
/// Parts of what the bar and the buttons leave that the key panel has: of the height, and of the width where it is held across.
const KEY_HEIGHT: f32 = 0.46;
const KEY_WIDTH: f32 = 0.54;
/// Between cards: there is little room.
const NARROW_GAP: f32 = 0.5 * GAP;

/// Whether a window is laid out for fingers; `size` in points of normal text.
pub fn is_narrow(size: Vec2) -> bool {
    size.x < WIDE || size.y < HIGH
}

/// Where everything stands below the bar, in points from the window's upper left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Narrow {
    /// The names of the panels.
    pub names: Rect,
    pub key: Rect,
    pub column: Rect,
    /// The buttons to walk.
    pub walk: Rect,
}

impl Narrow {
    pub fn new(window: Vec2) -> Self {
        let whole = Rect::from_min_max(pos2(0.0, TARGET), window.to_pos2());
        let inner = whole.shrink(NARROW_GAP);
        let across = window.x > window.y;
        let border = if across {
            inner.left() + KEY_WIDTH * inner.width()
        } else {
            inner.right()
        };
        let walk = Rect::from_min_max(
            pos2(
                if across {
                    border + NARROW_GAP
                } else {
                    inner.left()
                },
                inner.bottom() - TARGET,
            ),
            inner.max,
        );
        let names = Rect::from_min_size(inner.min, vec2(border - inner.left(), TARGET));
        let top = names.bottom() + NARROW_GAP;
        let above_walk = walk.top() - NARROW_GAP;
        let key_bottom = match across {
            true => inner.bottom(),
            false => top + KEY_HEIGHT * (above_walk - inner.top()),
        };
        let column_top = match across {
            true => inner.top(),
            false => key_bottom + NARROW_GAP,
        };
        Narrow {
            names,
            key: Rect::from_min_max(pos2(inner.left(), top), pos2(border, key_bottom)),
            column: Rect::from_min_max(
                pos2(walk.left(), column_top),
                pos2(inner.right(), above_walk),
            ),
            walk,
        }
    }

    /// All but the buttons to walk.
    pub fn above_walk(&self) -> Rect {
        self.names.union(self.key).union(self.column)
    }

    pub fn shifted(self, by: Vec2) -> Self {
        let Narrow {
            names,
            key,
            column,
            walk,
        } = self;
        let [names, key, column, walk] = [names, key, column, walk].map(|card| card.translate(by));
        Narrow {
            names,
            key,
            column,
            walk,
        }
    }
}
