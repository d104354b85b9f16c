//! Where everything stands in the window: a function of its size alone, so that what must hold can be tested without a screen.

mod narrow;

use egui::{Rect, Vec2, pos2, vec2};
pub use narrow::{Narrow, TARGET, is_narrow};

/// Between cards, and around them.
pub const GAP: f32 = 8.0;
/// Between a card's frame and what is in it.
pub const MARGIN: f32 = 4.0;
/// Height of the bar on top.
pub const BAR: f32 = 40.0;
/// Height of a card's title.
pub const TITLE: f32 = 28.0;
/// Height of the row of buttons above the time line.
pub const TRANSPORT: f32 = 36.0;
/// Largest part of the window's height for the time line, unless the user wants more of it.
const TIME_LINE_SHARE: f32 = 0.125;
/// Least part of the window that the key panel's card takes, where the column leaves it so much: with text twice as large on 1280 × 800
/// pixels that is 0.37.
const KEY_SHARE: f32 = 0.452;
/// What a panel beside the key panel is laid out for at least: no text is crowded at that size.
pub const SMALL: Vec2 = vec2(260.0, 174.0);
/// How small such a panel is shown: its text, 11 points high, is then 10.
const SMALLEST: f32 = 10.0 / 11.0;
const WIDEST_SIDE: f32 = 0.24;
/// How much more than its least width the key panel keeps where nothing stands beside it, and how much wider the column becomes there.
const ALONE: f32 = 1.1;
const WIDENED: f32 = 1.3;
pub const DRAWER: f32 = 320.0;
/// Of the drawer in which one writes.
pub const WRITING: f32 = 400.0;
/// The least width of the left column.
const LEAST_COLUMN: f32 = 230.0;

/// The least height of the pseudocode: the current line with two on either side.
const LEAST_CODE: f32 = 104.0;
/// The least height of the formula: two lines.
const LEAST_FORMULA: f32 = 64.0;
/// Parts of the column's height that code and formula have unless the words need them.
const CODE_SHARE: f32 = 0.32;
const FORMULA_SHARE: f32 = 0.3;
/// A column without this much room for the words scrolls as a whole.
const LEAST_WORDS: f32 = 110.0;
/// The least part of the column's height for the words.
const LEAST_SAID: f32 = 0.24;

/// What is to be placed.
#[derive(Clone, Copy)]
pub struct Wishes {
    /// Width of the left column, where the user has chosen one.
    pub column: Option<f32>,
    /// Height of the time line without its buttons, where the user has chosen one.
    pub time_line: Option<f32>,
    /// Between what heights it can be dragged: the usual one, and one that shows all of it.
    pub time_line_heights: [f32; 2],
    /// Panels beside the key panel.
    pub others: usize,
    /// Width of the drawer, where one is open.
    pub drawer: Option<f32>,
}

/// The cards of the window, in points from its upper left corner.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    pub column: Rect,
    pub key: Rect,
    /// A card for each other panel, as far as there is room: the names of the rest stand on the key panel's card.
    pub side: Vec<Rect>,
    /// In place of the cards at the side.
    pub drawer: Option<Rect>,
    pub time_line: Rect,
}

impl Layout {
    /// The key panel alone.
    pub fn filled(window: Vec2) -> Self {
        let none = Rect::from_min_size(egui::Pos2::ZERO, Vec2::ZERO);
        Layout {
            column: none,
            key: Rect::from_min_size(egui::Pos2::ZERO, window).shrink(GAP),
            side: Vec::new(),
            drawer: None,
            time_line: none,
        }
    }

    pub fn shifted(mut self, by: Vec2) -> Self {
        let side = self.side.iter_mut().chain(self.drawer.as_mut());
        let cards = [&mut self.column, &mut self.key, &mut self.time_line];
        for card in cards.into_iter().chain(side) {
            *card = card.translate(by);
        }
        self
    }
}

/// Between what widths the left column can be dragged.
pub fn column_widths(window: f32) -> std::ops::RangeInclusive<f32> {
    LEAST_COLUMN..=(0.45 * window).max(LEAST_COLUMN)
}

/// Places the cards in a window of that size.
pub fn layout(window: Vec2, wishes: Wishes) -> Layout {
    let bottom = window.y - GAP;
    let [usual, most] = wishes.time_line_heights;
    let usual = usual.min(TIME_LINE_SHARE * window.y);
    let rows = wishes.time_line.unwrap_or(usual).clamp(usual, most);
    let time_line = Rect::from_min_max(
        pos2(GAP, bottom - TRANSPORT - rows),
        pos2(window.x - GAP, bottom),
    );
    let (top, bottom) = (BAR + GAP, time_line.top() - GAP);
    let height = (bottom - top).max(0.0);
    let card =
        |left: f32, width: f32| Rect::from_min_size(pos2(left, top), vec2(width.max(0.0), height));

    // What is not the column and, where there is room for it, not the strip at the side, is the key panel's.
    let least_key = (KEY_SHARE * window.x * window.y / height.max(1.0)).ceil();
    let least_side = SMALLEST * SMALL + vec2(2.0 * MARGIN, TITLE + MARGIN);
    let count = ((height + GAP) / (least_side.y + GAP)) as usize;
    let count = count.min(wishes.others);
    let strip = |column: f32| {
        let room = window.x - 2.0 * GAP - column - GAP;
        let width = (room - least_key - GAP).min(WIDEST_SIDE * window.x);
        (count > 0 && width >= least_side.x).then_some(width)
    };
    let mut usual = (0.232 * window.x).clamp(LEAST_COLUMN, 440.0);
    // The column gives way to the strip as far as it can be read.
    let beside_strip = window.x - 4.0 * GAP - least_key - least_side.x.ceil();
    if count > 0 && beside_strip >= LEAST_COLUMN {
        usual = usual.min(beside_strip);
    }
    let width = wishes.column.unwrap_or(match strip(usual) {
        Some(_) => usual,
        None => (window.x - 3.0 * GAP - ALONE * least_key).clamp(usual, WIDENED * usual),
    });
    let widths = column_widths(window.x);
    let column = card(GAP, width.clamp(*widths.start(), *widths.end()));

    let left = column.right() + GAP;
    let room = window.x - GAP - left;
    let side = match wishes.drawer {
        Some(drawer) => drawer.min(0.5 * room),
        None => strip(column.width()).unwrap_or(-GAP),
    };
    let key = card(left, room - side - GAP);
    let beside = card(key.right() + GAP, side);
    Layout {
        column,
        key,
        side: if wishes.drawer.is_some() || side <= 0.0 {
            Vec::new()
        } else {
            cards(beside, count)
        },
        drawer: wishes.drawer.map(|_| beside),
        time_line,
    }
}

/// `count` cards of equal height below each other.
fn cards(strip: Rect, count: usize) -> Vec<Rect> {
    let height = (strip.height() + GAP) / count.max(1) as f32 - GAP;
    let row = |i: usize| {
        let top = strip.top() + i as f32 * (height + GAP);
        Rect::from_min_size(pos2(strip.left(), top), vec2(strip.width(), height))
    };
    (0..count).map(row).collect()
}

/// The regions of the left column, below each other; none takes from another what that needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Narration and question; scrolls by itself.
    pub said: Rect,
    pub code: Rect,
    pub formula: Rect,
}

/// The height of all regions of the column: that of its card, or of what scrolls in a lower one.
pub fn column_height(card: f32, said: f32, formula: f32) -> f32 {
    let rest = LEAST_CODE + formula.max(LEAST_FORMULA);
    match rest + LEAST_WORDS <= card {
        true => card,
        false => rest + said.max(LEAST_WORDS),
    }
}

/// Divides the column, which has its whole height. `said` is the height that the words take, `formula` the least one that shows a formula
/// with its numbers.
pub fn column(card: Rect, said: f32, formula: f32) -> Column {
    let height = card.height();
    let least_formula = formula.max(LEAST_FORMULA).min(0.5 * height);
    let usual_formula = (FORMULA_SHARE * height).max(least_formula);
    let usual_code = (CODE_SHARE * height).max(LEAST_CODE);
    // Long words take first what the formula does not need, then what the code does not.
    let formula = (height - usual_code - said).clamp(least_formula, usual_formula);
    let code = (height - formula - said).clamp(LEAST_CODE, usual_code);
    let least_said = LEAST_SAID * height;
    let code = code.min(height - formula - least_said);
    let said = height - formula - code;
    let part = |from: f32, height: f32| {
        Rect::from_min_size(
            pos2(card.left(), card.top() + from),
            vec2(card.width(), height),
        )
    };
    Column {
        said: part(0.0, said),
        code: part(said, code),
        formula: part(said + code, formula),
    }
}

/// The height of the regions of a column that scrolls as a whole: nothing in it scrolls by itself.
pub fn stacked_height(said: f32, formula: f32) -> f32 {
    said.max(LEAST_WORDS) + formula.max(LEAST_FORMULA) + LEAST_CODE
}

/// Divides such a column: what is said, the formulas, which are `formula` high, and the code.
pub fn stacked(column: Rect, formula: f32) -> Column {
    let formula = formula.max(LEAST_FORMULA);
    let code = column.bottom() - LEAST_CODE;
    let part = |top: f32, bottom: f32| {
        Rect::from_min_max(pos2(column.left(), top), pos2(column.right(), bottom))
    };
    Column {
        said: part(column.top(), code - formula),
        formula: part(code - formula, code),
        code: part(code, column.bottom()),
    }
}

#[cfg(test)]
mod tests;
