//! A raster in tiles that copies share until one of them writes: so that a checkpoint keeps only what changed.

use std::iter;
use std::ops::Range;
use std::sync::Arc;

/// Pixels along the side of a tile.
const TILE: usize = 16;

type Tile<T> = [T; TILE * TILE];

/// The longest side of a canvas, in pixels.
pub const MAX_SIDE: usize = 1 << 16;

/// `width` × `height` values, (0, 0) top left, x to the right, y down.
///
/// A copy costs a pointer a tile (1200 at 640×480); the first write to a tile that is shared copies its 256 values.
/// Tiles never written share one, so an empty canvas costs no more than its pointers.
#[derive(Clone, Debug)]
pub struct Canvas<T> {
    width: usize,
    height: usize,
    /// Row by row. What lies beyond the right and lower side of the canvas keeps the fill.
    tiles: Vec<Arc<Tile<T>>>,
}

impl<T: Copy> Canvas<T> {
    /// All pixels are `fill`. Neither side may exceed [`MAX_SIDE`]; either may be 0.
    pub fn new(width: usize, height: usize, fill: T) -> Self {
        assert!(
            width <= MAX_SIDE && height <= MAX_SIDE,
            "a canvas of {width}×{height}: the longest side is {MAX_SIDE}"
        );
        let empty = Arc::new([fill; TILE * TILE]);
        Canvas {
            width,
            height,
            tiles: vec![empty; width.div_ceil(TILE) * height.div_ceil(TILE)],
        }
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn height(&self) -> usize {
        self.height
    }

    /// Writes a pixel, which must lie on the canvas.
    pub fn set(&mut self, x: usize, y: usize, value: T) {
        let (tile, place) = self.locate(x, y);
        Arc::make_mut(&mut self.tiles[tile])[place] = value;
    }

    /// The value of a pixel; none outside of the canvas.
    pub fn get(&self, x: usize, y: usize) -> Option<T> {
        let (tile, place) = (x < self.width && y < self.height).then(|| self.locate(x, y))?;
        Some(self.tiles[tile][place])
    }

    /// All values, row by row from the top.
    pub fn iter(&self) -> impl Iterator<Item = &T> {
        self.runs().flatten()
    }

    /// The parts that `self` does not share with `before`, all of them where that has another size or there is none: tiles, by
    /// their columns and rows.
    pub fn parts_beyond(&self, before: Option<&Self>) -> Vec<[Range<usize>; 2]> {
        let is_like = |other: &&Self| (other.width, other.height) == (self.width, self.height);
        let before = before.filter(is_like);
        let columns = self.width.div_ceil(TILE);
        let changed = self.tiles.iter().enumerate().filter(|(number, tile)| {
            before.is_none_or(|before| !Arc::ptr_eq(tile, &before.tiles[*number]))
        });
        let part = |tile: usize, side: usize| tile * TILE..((tile + 1) * TILE).min(side);
        let parts = changed.map(|(number, _)| {
            [
                part(number % columns, self.width),
                part(number / columns, self.height),
            ]
        });
        parts.collect()
    }

    /// Bytes of the tiles, and pointers to them, that `self` does not share with `before`, a canvas of the same size.
    pub fn bytes_beyond(&self, before: &Self) -> usize {
        let own = iter::zip(&self.tiles, &before.tiles)
            .filter(|(tile, other)| !Arc::ptr_eq(tile, other))
            .count();
        own * size_of::<Tile<T>>() + self.tiles.len() * size_of::<Arc<Tile<T>>>()
    }

    /// The pixels in reading order, in runs that each lie in one tile.
    fn runs(&self) -> impl Iterator<Item = &[T]> {
        let columns = self.width.div_ceil(TILE);
        (0..self.height).flat_map(move |y| {
            (0..columns).map(move |column| {
                let start = y % TILE * TILE;
                let length = TILE.min(self.width - column * TILE);
                &self.tiles[y / TILE * columns + column][start..start + length]
            })
        })
    }

    /// The tile that a pixel lies in, and its place there.
    fn locate(&self, x: usize, y: usize) -> (usize, usize) {
        assert!(
            x < self.width && y < self.height,
            "pixel ({x}, {y}) lies outside {}×{}",
            self.width,
            self.height
        );
        (
            y / TILE * self.width.div_ceil(TILE) + x / TILE,
            y % TILE * TILE + x % TILE,
        )
    }
}

/// Equal when all pixels are, whatever they were filled with.
impl<T: Copy + PartialEq> PartialEq for Canvas<T> {
    fn eq(&self, other: &Self) -> bool {
        (self.width, self.height) == (other.width, other.height) && self.iter().eq(other.iter())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_canvas_is_a_plain_raster_and_old_copies_keep_their_values(
            (width, height) in (1_usize..70, 1_usize..70),
            writes in prop::collection::vec((any::<prop::sample::Index>(), any::<u16>(), prop::bool::weighted(0.1)), 0..200),
        ) {
            let mut canvas = Canvas::new(width, height, 7_u16);
            let mut plain = vec![7_u16; width * height];
            let mut copies = vec![(canvas.clone(), plain.clone())];
            for (place, value, copy) in writes {
                let place = place.index(width * height);
                canvas.set(place % width, place / width, value);
                plain[place] = value;
                if copy {
                    copies.push((canvas.clone(), plain.clone()));
                }
            }
            copies.push((canvas, plain));
            for (canvas, plain) in &copies {
                prop_assert!(canvas.iter().eq(plain));
            }
        }
    }

    #[test]
    fn a_part_that_was_written_is_shared_no_longer() {
        let before = Canvas::new(40, 20, 0_u8);
        let mut after = before.clone();
        assert!(after.parts_beyond(Some(&before)).is_empty());
        after.set(39, 17, 1);
        assert_eq!(after.parts_beyond(Some(&before)), [[32..40, 16..20]]);
        let all = after.parts_beyond(None);
        assert_eq!(after.parts_beyond(Some(&Canvas::new(20, 40, 0))), all);
        let pixels = all.iter().map(|[columns, rows]| columns.len() * rows.len());
        assert_eq!(pixels.sum::<usize>(), 40 * 20);
    }

    #[test]
    fn a_copy_pays_for_the_tiles_it_writes() {
        let empty = Canvas::new(640, 480, 0_u64);
        let pointers = 40 * 30 * size_of::<usize>();
        assert_eq!(empty.clone().bytes_beyond(&empty), pointers);
        let mut copy = empty.clone();
        copy.set(0, 0, 1);
        copy.set(15, 15, 1);
        copy.set(16, 15, 1);
        assert_eq!(copy.bytes_beyond(&empty), pointers + 2 * 256 * 8);
    }

    #[test]
    fn equality_is_of_pixels_not_of_what_lies_beyond() {
        let mut canvas = Canvas::new(3, 1, 0);
        (0..3).for_each(|x| canvas.set(x, 0, 5));
        assert_eq!(canvas, Canvas::new(3, 1, 5));
        assert_ne!(canvas, Canvas::new(1, 3, 5));
        assert_eq!(Canvas::new(0, 9, 1).iter().count(), 0);
    }

    #[test]
    #[should_panic(expected = "pixel (3, 0) lies outside 3×1")]
    fn a_pixel_beyond_the_side_is_refused_although_its_tile_has_room() {
        Canvas::new(3, 1, 0).set(3, 0, 1);
    }
}
