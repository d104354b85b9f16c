//! Scan-line methods fill bands of rows. Every band walks all polygons, so they are few.

use super::Painter;
use crate::algorithms::frame::Frame;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

impl<E: Send, P: Fn(usize, usize) -> Result<(), E> + Sync> Painter<'_, P> {
    /// The picture whose bands of rows `draw` fills, one call a band. Progress is reported after each band.
    pub fn bands(self, draw: impl Fn(&mut Frame) + Sync) -> Result<Frame, E> {
        let [width, height] = self.size;
        let bands = bands(height, self.thread_pool.size());
        let (done, all) = (AtomicUsize::new(0), bands.len());
        let fill = |rows| {
            let mut frame = Frame::new(width, rows, self.background);
            draw(&mut frame);
            (self.progress)(done.fetch_add(1, Ordering::Relaxed) + 1, all)?;
            Ok(frame)
        };
        self.thread_pool.map(bands, fill).map(join)
    }
}

/// One thread fills the picture in one band. More threads share four bands each, so that none waits long for the last.
fn bands(height: u32, threads: usize) -> Vec<Range<u32>> {
    let wanted = if threads == 1 { 1 } else { 4 * threads };
    let count = wanted.min(height.max(1) as usize) as u64;
    let border = |band: u64| (band * u64::from(height) / count) as u32;
    (0..count)
        .map(|band| border(band)..border(band + 1))
        .collect()
}

/// Puts bands back together, in order.
fn join(bands: Vec<Frame>) -> Frame {
    let mut bands = bands.into_iter();
    let Some(mut frame) = bands.next() else {
        return Frame::new(0, 0..0, Default::default());
    };
    for band in bands {
        frame.rows.end = band.rows.end;
        frame.color.extend(band.color);
        frame.inverse_depth.extend(band.inverse_depth);
    }
    frame
}
