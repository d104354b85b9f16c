//! Methods that colour each pixel by itself can show a coarse picture early: in the first pass every eighth pixel of every
//! eighth row stands for its whole block, and each later pass halves the blocks. No pixel is computed twice.

use super::Painter;
use crate::algorithms::frame::Frame;
use crate::color::Rgb;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Sides of the blocks of each pass of a preview, in pixels: each a multiple of the next.
pub const COARSE_FIRST: [u32; 4] = [8, 4, 2, 1];

/// The one pass of a picture that nobody watches grow.
pub const AT_ONCE: [u32; 1] = [1];

/// Pixels between two reports: a tenth of a millisecond where a pixel takes long.
const REPORT: usize = 16;

impl<E: Send, P: Fn(usize, usize) -> Result<(), E> + Sync> Painter<'_, P> {
    /// The picture whose pixel (x, y) has the colour `color(x, y)`. Progress is reported in pixels, a few at a time.
    pub fn pixels(mut self, color: impl Fn(u32, u32) -> Rgb + Sync) -> Result<Frame, E> {
        let [width, height] = self.size;
        let mut frame = Frame::new(width, 0..height, self.background);
        let (done, all) = (AtomicUsize::new(0), frame.color.len());
        let report =
            |pixels| (self.progress)(done.fetch_add(pixels, Ordering::Relaxed) + pixels, all);
        let mut before = None;
        for &side in self.passes {
            // The corners of the blocks of the pass before have their colour already.
            let known = |x: u32, y: u32| {
                before.is_some_and(|side: u32| x.is_multiple_of(side) && y.is_multiple_of(side))
            };
            let fill = |(y, rows): (u32, &mut [Rgb])| {
                let mut unreported = 0;
                for x in (0..width).step_by(side as usize).filter(|&x| !known(x, y)) {
                    let color = color(x, y);
                    let block = x as usize..(x + side).min(width) as usize;
                    for row in rows.chunks_mut(width as usize) {
                        row[block.clone()].fill(color);
                    }
                    unreported += 1;
                    if unreported == REPORT {
                        report(unreported)?;
                        unreported = 0;
                    }
                }
                report(unreported)
            };
            let blocks = frame.color.chunks_mut((width * side).max(1) as usize);
            let rows = (0..height).step_by(side as usize).zip(blocks).collect();
            self.thread_pool.map(rows, fill)?;
            before = Some(side);
            if let Some(show) = self.show.as_mut().filter(|_| side > 1) {
                show(&frame);
            }
        }
        Ok(frame)
    }
}

#[cfg(test)]
mod tests {
    use super::super::thread_pool::ThreadPool;
    use super::*;
    use std::convert::Infallible;
    use std::num::NonZeroUsize;
    use std::sync::Mutex;

    const SIZES: [[u32; 2]; 6] = [[1, 1], [8, 8], [13, 7], [3, 50], [65, 33], [300, 1]];

    /// A colour that is different at every pixel.
    fn color(x: u32, y: u32) -> Rgb {
        Rgb::new(f64::from(x), f64::from(y), 1.0)
    }

    fn quiet(_: usize, _: usize) -> Result<(), Infallible> {
        Ok(())
    }

    fn painter<'a, P>(size: [u32; 2], threads: usize, progress: P) -> Painter<'a, P> {
        Painter {
            size,
            background: Rgb::default(),
            thread_pool: ThreadPool::new(NonZeroUsize::new(threads).unwrap()),
            progress,
            passes: &AT_ONCE,
            show: None,
        }
    }

    #[test]
    fn a_preview_ends_as_the_plain_picture_and_computes_no_pixel_twice() {
        for (size, threads) in SIZES.into_iter().flat_map(|size| [(size, 1), (size, 3)]) {
            let Ok(plain) = painter(size, threads, quiet).pixels(color);
            let all = plain.color.len();
            assert_eq!(plain.pixel(size[0] - 1, 0), color(size[0] - 1, 0));

            let calls = Mutex::new(vec![0; all]);
            let counted = |x, y| {
                calls.lock().unwrap()[plain.index(x, y)] += 1;
                color(x, y)
            };
            let most = AtomicUsize::new(0);
            let progress = |done, of| {
                assert!(done <= all && of == all);
                most.fetch_max(done, Ordering::Relaxed);
                quiet(done, of)
            };
            let mut passes = 0;
            let mut show = |_: &Frame| passes += 1;
            let preview = painter(size, threads, progress).coarse_first(&mut show);
            let Ok(preview) = preview.pixels(counted);
            assert!(preview == plain, "{size:?} on {threads} threads");
            assert_eq!((passes, most.into_inner()), (3, all));
            assert!(calls.into_inner().unwrap().iter().all(|&calls| calls == 1));
        }
    }

    #[test]
    fn in_each_pass_the_corner_of_a_block_stands_for_all_of_it() {
        for size in SIZES {
            let mut sides = [8, 4, 2].into_iter();
            let mut show = |frame: &Frame| {
                let side = sides.next().unwrap();
                for (x, y) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))) {
                    let corner = color(x - x % side, y - y % side);
                    assert_eq!(frame.pixel(x, y), corner, "({x}, {y}) in blocks of {side}");
                }
            };
            let Ok(_) = painter(size, 2, quiet)
                .coarse_first(&mut show)
                .pixels(color);
        }
    }

    #[test]
    fn who_calls_it_off_waits_for_a_few_pixels_only() {
        for threads in [1, 4] {
            let computed = AtomicUsize::new(0);
            let counted = |x, y| {
                computed.fetch_add(1, Ordering::Relaxed);
                color(x, y)
            };
            let limit = 1000;
            let progress = |done, _| if done < limit { Ok(()) } else { Err(done) };
            let mut show = |_: &Frame| panic!("a pass was done");
            let called_off = painter([640, 480], threads, progress).coarse_first(&mut show);
            assert!(called_off.pixels(counted).is_err());
            let computed = computed.into_inner();
            assert!(
                computed < limit + 2 * threads * REPORT,
                "{computed} pixels on {threads} threads"
            );
        }
    }
}
