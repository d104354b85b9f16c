//! Filling a polygon without recording any interpolation.

use super::corner::Corner;
use super::edge_table::EdgeTable;
use super::event::Event;
use super::span::Pixel;
use super::varying::Varying;
use crate::algorithms::frame::Frame;
use crate::color::Rgb;
use crate::record::Recorder;

impl<V: Varying> EdgeTable<'_, V> {
    /// Draws a polygon into `frame`. `color` gives the colour of a pixel with the value interpolated there.
    pub fn fill<E: From<Event<V::Recorded>>, R: Recorder<E>>(
        &mut self,
        polygon: impl IntoIterator<Item = Corner<V>>,
        frame: &mut Frame,
        recorder: &mut R,
        mut color: impl FnMut(&mut R, Pixel, V) -> Rgb,
    ) {
        self.build(polygon, recorder);
        while let Some(line) = self.next_scan_line() {
            recorder.enter(|| line.entered().into());
            for edge in self.active_edges() {
                recorder.enter(|| edge.entered().into());
                if let Some(textured) = edge.textured() {
                    recorder.step(|| textured.into());
                }
                recorder.leave(|| Event::EdgeCut.into());
            }
            for span in self.spans(line) {
                recorder.enter(|| span.entered().into());
                if let Some(textured) = span.textured() {
                    recorder.step(|| textured.into());
                }
                let mut value = span.ramp(span.left, span.right);
                for pixel in span.pixels() {
                    if pixel.passes_depth_test(frame, recorder) {
                        let color = color(recorder, pixel, value.value);
                        pixel.draw(color, frame, recorder);
                    }
                    value.advance();
                }
                recorder.leave(|| Event::SpanDone.into());
            }
            recorder.leave(|| Event::ScanLineDone.into());
        }
    }
}
