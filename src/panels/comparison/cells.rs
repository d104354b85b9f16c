//! A panel divided into cells: a title, an image, and lines of text under it.

use super::super::image::middle;
use super::cursor::Cursor;
use crate::algorithms::frame::Frame;
use crate::figure::elided;
use crate::methods::Method;
use crate::panels::{Answered, PanelInput};
use crate::picture::{Image, Ink, Picture, Rect, Style, Tag, wrap};
use glam::Vec2;

/// Height of a line of text.
pub const ROW: f32 = 15.0;
const TITLE: f32 = 14.0;
/// Of the largest possible images: so large they are with lines of text under them, or they have fewer lines.
const WITH_TEXT: f32 = 0.85;
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
    /// What is seen of the picture.
    pub image: Rect,
    /// Where all of the picture lies, beyond what is seen too.
    pub whole: Rect,
    /// Pixels of the picture.
    size: Vec2,
    /// For lines of text, down to the next cell.
    pub below: Rect,
}

/// A way to divide a panel: how large the images are, in how many columns.
#[derive(Clone, Copy)]
struct Grid {
    scale: f32,
    columns: usize,
    cell: Vec2,
}

/// Cells for pictures like that, one a title, with up to so many `lines` of text each: in the grid that makes the images largest without
/// cutting a title off. All show the same part of their pictures.
pub fn cells(
    input: &PanelInput,
    like: &Frame,
    titles: &[String],
    lines: usize,
    size: Vec2,
) -> Vec<Cell> {
    let picture = Vec2::new(like.width as f32, like.rows.len() as f32);
    let style = Style::Bold.size(TEXT);
    let longest = titles.iter().map(|title| style.width(title));
    let longest = longest.fold(0.0, f32::max);
    let count = titles.len();
    let largest = |lines: usize| {
        let grids = (1..=count).map(|columns| grid([columns, count], picture, lines, size));
        let fitting = grids.filter(|grid| grid.cell.x - GAP >= longest || grid.columns == 1);
        fitting.max_by(|a, b| a.scale.total_cmp(&b.scale))
    };
    let bare = largest(0).map_or(0.0, |grid| grid.scale);
    let with_text = (0..=lines).rev().filter_map(largest);
    let mut good = with_text.filter(|grid| grid.scale >= WITH_TEXT * bare);
    let Some(Grid {
        scale,
        columns,
        cell,
    }) = good.next()
    else {
        return Vec::new();
    };
    let zoom = input.image.shown.zoom;
    (0..count)
        .map(|number| {
            let at = Vec2::new((number % columns) as f32, (number / columns) as f32) * cell;
            let at = at + Vec2::splat(EDGE);
            let width = cell.x - GAP;
            let extent = picture * scale.max(0.0);
            // Images stand at the left of their cells, under the beginning of the title.
            let image = Rect::new(at.x, at.y + TITLE, extent.x, extent.y);
            let origin = image.center() - middle(input) * extent * zoom;
            Cell {
                title: Rect::new(at.x, at.y, width, TITLE),
                image,
                whole: Rect::between(origin, origin + extent * zoom),
                size: picture,
                below: Rect::between(
                    Vec2::new(at.x, image.bottom()),
                    Vec2::new(at.x + width, at.y + cell.y - GAP),
                ),
            }
        })
        .collect()
}

fn grid([columns, count]: [usize; 2], picture: Vec2, lines: usize, size: Vec2) -> Grid {
    let rows = count.div_ceil(columns);
    let cell = Vec2::new(
        (size.x - 2.0 * EDGE + GAP) / columns as f32,
        (size.y - 2.0 * EDGE + GAP) / rows as f32,
    );
    let text = ROW * lines as f32;
    let room = Vec2::new(cell.x - GAP, cell.y - GAP - TITLE - text).max(Vec2::ZERO);
    Grid {
        scale: (room / picture).min_element(),
        columns,
        cell,
    }
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

    /// The pixels of its picture, as far as they are seen.
    pub fn pixels(&self, picture: &mut Picture, image: Image) {
        picture.clipped(self.image, |picture| {
            picture.pixels(self.whole, image, (0, 0));
        });
    }

    /// Lines under the image, the first ones first: broken where they are too long, and left out where they do not fit whole.
    pub fn lines<'a>(
        &self,
        picture: &mut Picture,
        lines: impl IntoIterator<Item = (&'a str, Ink)>,
    ) {
        let mut y = self.below.y;
        for (line, ink) in lines {
            let style = Style::Body.size(LINE);
            let fits = |word: &str| style.width(word) <= self.below.width;
            if !line.split_whitespace().all(fits) {
                continue;
            }
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
                elided(picture, place, &row, style.ink(ink));
                y += ROW;
            }
        }
    }

    /// The image's border, and on it the cursor and the answer to a question.
    pub fn frame(&self, picture: &mut Picture, cursor: &Cursor, answered: Answered) {
        let scale = self.whole.width / self.size.x;
        picture.clipped(self.image, |picture| {
            if let Some(y) = cursor.y {
                let at = self.whole.y + scale * (y as f32 + 0.5);
                let stroke = Ink::This.stroke(1.0).opacity(0.8);
                picture.line((self.image.x, at), (self.image.right(), at), stroke);
                if let Some(x) = cursor.x {
                    let at = Vec2::new(self.whole.x + scale * (x as f32 + 0.5), at);
                    let radius = (0.75 * scale).max(4.0);
                    let paint = Ink::This.stroke(1.75);
                    picture.circle(at, radius, paint);
                }
            }
            answered.draw(picture, |tag| {
                let Tag::Pixel { x, y } = tag else {
                    return None;
                };
                let at = self.whole.min() + scale * Vec2::new(x as f32, y as f32);
                Some(Rect::new(at.x, at.y, scale, scale))
            });
        });
        picture.rect(self.image, Ink::Rule.stroke(1.0));
    }
}
