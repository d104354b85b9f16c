//! A panel divided into cells: a title, an image, and lines of text under it.

use super::cursor::Cursor;
use crate::algorithms::frame::Frame;
use crate::figure::elided;
use crate::methods::Method;
use crate::panels::Answered;
use crate::picture::{Ink, Picture, Rect, Style, Tag, wrap};
use glam::Vec2;

/// Height of a line of text.
pub const ROW: f32 = 15.0;
const TITLE: f32 = 18.0;
/// Width of a cell that has room for its text.
const NARROWEST: f32 = 115.0;
/// Of the largest possible images.
const MUCH_SMALLER: f32 = 0.7;
/// Around all cells, and between two.
const EDGE: f32 = 2.0;
const GAP: f32 = 3.0;
const TEXT: f32 = 12.0;
/// Of a method's line beside its name.
const SAMPLE: f32 = 16.0;
/// Size of a line of text.
const LINE: f32 = 11.0;

/// One of several alike.
pub struct Cell {
    title: Rect,
    /// In the shape of the picture.
    pub image: Rect,
    /// Pixels of the picture.
    size: Vec2,
    /// For lines of text, down to the next cell.
    pub below: Rect,
}

/// `count` cells for pictures like that, each with `lines` lines of text, in as many columns as make the images largest.
pub fn cells(like: &Frame, count: usize, lines: usize, size: Vec2) -> Vec<Cell> {
    let picture = Vec2::new(like.width as f32, like.rows.len() as f32);
    let text = ROW * lines as f32;
    let arranged = (1..=count).map(|columns| {
        let rows = count.div_ceil(columns);
        let cell = Vec2::new(
            (size.x - 2.0 * EDGE + GAP) / columns as f32,
            (size.y - 2.0 * EDGE + GAP) / rows as f32,
        );
        let room = Vec2::new(cell.x - GAP, cell.y - GAP - TITLE - text).max(Vec2::ZERO);
        ((room / picture).min_element(), columns, cell)
    });
    // Narrow cells cut off their text: they are chosen where wide ones would make the images much smaller.
    let arranged: Vec<_> = arranged.collect();
    let largest = |narrow: bool| {
        let arranged = arranged
            .iter()
            .filter(|(_, columns, cell)| narrow || cell.x >= NARROWEST || *columns == 1);
        arranged.max_by(|a, b| a.0.total_cmp(&b.0)).copied()
    };
    let best = largest(true).unwrap_or((0.0, 1, size));
    let wide = largest(false).filter(|wide| wide.0 >= MUCH_SMALLER * best.0);
    let (scale, columns, cell) = wide.unwrap_or(best);
    (0..count)
        .map(|number| {
            let at = Vec2::new((number % columns) as f32, (number / columns) as f32) * cell;
            let at = at + Vec2::splat(EDGE);
            let width = cell.x - GAP;
            let extent = picture * scale;
            // Images stand at the left of their cells, under the beginning of the title.
            let image = Rect::new(at.x, at.y + TITLE, extent.x, extent.y);
            Cell {
                title: Rect::new(at.x, at.y, width, TITLE),
                image,
                size: picture,
                below: Rect::between(
                    Vec2::new(at.x, image.bottom()),
                    Vec2::new(at.x + width, at.y + cell.y - GAP),
                ),
            }
        })
        .collect()
}

impl Cell {
    /// The method's name with its line in plots; that of the run that is walked through stands out.
    pub fn title(&self, picture: &mut Picture, name: &str, (method, walked): (Method, Method)) {
        let ink = match method == walked {
            true => Ink::This,
            false => Ink::Text,
        };
        let style = Style::Bold.size(TEXT).ink(ink);
        let mut place = self.title;
        let beside = SAMPLE + 4.0;
        // In a narrow cell the name matters more.
        if beside + style.width(name) <= place.width {
            let (x, middle) = (place.x, place.center().y);
            let stroke = method.series().stroke;
            picture.line((x, middle), (x + SAMPLE, middle), stroke);
            place.x += beside;
            place.width -= beside;
        }
        elided(picture, place, name, style);
    }

    /// Lines under the image, the first ones first: broken where they are too long, and left out where they do not fit whole.
    pub fn lines<'a>(
        &self,
        picture: &mut Picture,
        lines: impl IntoIterator<Item = (&'a str, Ink)>,
    ) {
        let mut y = self.below.y;
        for (line, ink) in lines {
            let rows = wrap(line, Style::Body, LINE, self.below.width);
            if y + ROW * rows.len() as f32 > self.below.bottom() + 0.01 {
                continue;
            }
            for row in rows {
                let place = Rect {
                    y,
                    height: ROW,
                    ..self.below
                };
                elided(picture, place, &row, Style::Body.size(LINE).ink(ink));
                y += ROW;
            }
        }
    }

    /// The image's border, and on it the cursor and the answer to a question.
    pub fn frame(&self, picture: &mut Picture, cursor: &Cursor, answered: Answered) {
        let scale = self.image.width / self.size.x;
        picture.clipped(self.image, |picture| {
            if let Some(y) = cursor.y {
                let at = self.image.y + scale * (y as f32 + 0.5);
                let stroke = Ink::This.stroke(1.0).opacity(0.8);
                picture.line((self.image.x, at), (self.image.right(), at), stroke);
                if let Some(x) = cursor.x {
                    let at = Vec2::new(self.image.x + scale * (x as f32 + 0.5), at);
                    let radius = (0.75 * scale).max(4.0);
                    let paint = Ink::This.stroke(1.75);
                    picture.circle(at, radius, paint);
                }
            }
            answered.draw(picture, |tag| {
                let Tag::Pixel { x, y } = tag else {
                    return None;
                };
                let at = self.image.min() + scale * Vec2::new(x as f32, y as f32);
                Some(Rect::new(at.x, at.y, scale, scale))
            });
        });
        picture.rect(self.image, Ink::Rule.stroke(1.0));
    }
}
