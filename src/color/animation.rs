//! Animations as files: PNG with frames (APNG), and GIF. A frame is written as the rectangle that differs from the frame before, so
//! that no more than two frames are in memory.

use std::io::{self, Write};

/// Of which kind the file is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AnimationFormat {
    Png,
    /// At most 256 colours a frame.
    Gif,
}

/// A file that is being written, and begins again when it has been shown.
pub struct Animation<W: Write> {
    file: File<W>,
    width: usize,
    /// The pixels of the frame before, RGB row by row; none before the first.
    before: Vec<u8>,
}

enum File<W: Write> {
    Png(png::Writer<W>),
    Gif(gif::Encoder<W>),
}

/// From 1, fast, to 30, the best: how carefully 256 colours are chosen.
const GIF_CARE: i32 = 10;

impl<W: Write> Animation<W> {
    /// Of so many frames, one or more.
    pub fn new(
        format: AnimationFormat,
        [width, height]: [u32; 2],
        frames: u32,
        out: W,
    ) -> io::Result<Self> {
        let file = match format {
            AnimationFormat::Png => {
                let mut encoder = png::Encoder::new(out, width, height);
                encoder.set_color(png::ColorType::Rgb);
                encoder.set_depth(png::BitDepth::Eight);
                encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
                encoder.set_animated(frames, 0)?;
                encoder.validate_sequence(true);
                File::Png(encoder.write_header()?)
            }
            AnimationFormat::Gif => {
                let [width, height] = [width, height].map(saturated);
                let mut encoder = gif::Encoder::new(out, width, height, &[]).map_err(of_gif)?;
                encoder.set_repeat(gif::Repeat::Infinite).map_err(of_gif)?;
                File::Gif(encoder)
            }
        };
        Ok(Animation {
            file,
            width: width as usize,
            before: Vec::new(),
        })
    }

    /// Adds a frame of RGB pixels in sRGB, row by row, that is shown for so long.
    pub fn frame(&mut self, pixels: Vec<u8>, seconds: f64) -> io::Result<()> {
        let part = changed(&self.before, &pixels, self.width);
        let [left, top, width, height] = part;
        let bytes: Vec<u8> = pixels
            .chunks_exact(3 * self.width)
            .skip(top)
            .take(height)
            .flat_map(|row| &row[3 * left..3 * (left + width)])
            .copied()
            .collect();
        match &mut self.file {
            File::Png(writer) => {
                let [left, top, width, height] = part.map(|length| length as u32);
                writer.reset_frame_position()?;
                writer.set_frame_dimension(width, height)?;
                writer.set_frame_position(left, top)?;
                writer.set_frame_delay((1000.0 * seconds).round() as u16, 1000)?;
                writer.write_image_data(&bytes)?;
            }
            File::Gif(encoder) => {
                let [left, top, width, height] = part.map(|length| saturated(length as u32));
                let frame = gif::Frame::from_rgb_speed(width, height, &bytes, GIF_CARE);
                let frame = gif::Frame {
                    left,
                    top,
                    delay: (100.0 * seconds).round() as u16,
                    ..frame
                };
                encoder.write_frame(&frame).map_err(of_gif)?;
            }
        }
        self.before = pixels;
        Ok(())
    }

    /// Writes the end. Errors: also where frames are missing.
    pub fn finish(self) -> io::Result<()> {
        match self.file {
            File::Png(writer) => Ok(writer.finish()?),
            File::Gif(encoder) => encoder.into_inner().map(drop).map_err(of_gif),
        }
    }
}

fn of_gif(error: gif::EncodingError) -> io::Error {
    match error {
        gif::EncodingError::Io(error) => error,
        error => io::Error::other(error),
    }
}

fn saturated(length: u32) -> u16 {
    u16::try_from(length).unwrap_or(u16::MAX)
}

/// Left, top, width and height of the smallest rectangle, at least a pixel, outside of which both pictures agree; all where there is
/// none before.
fn changed(before: &[u8], pixels: &[u8], width: usize) -> [usize; 4] {
    let height = pixels.len() / (3 * width);
    if before.len() != pixels.len() {
        return [0, 0, width, height];
    }
    let mut part: Option<[usize; 4]> = None;
    let rows = before
        .chunks_exact(3 * width)
        .zip(pixels.chunks_exact(3 * width));
    for (y, (old, new)) in rows.enumerate() {
        let differs = |x: &usize| old[3 * x..3 * x + 3] != new[3 * x..3 * x + 3];
        if let (Some(first), Some(last)) = ((0..width).find(differs), (0..width).rfind(differs)) {
            let [left, top, right, _] = part.unwrap_or([first, y, last, y]);
            part = Some([left.min(first), top, right.max(last), y]);
        }
    }
    let [left, top, right, bottom] = part.unwrap_or_default();
    [left, top, right - left + 1, bottom - top + 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [u32; 2] = [3, 2];

    /// Three frames: black, with one red pixel, and the same once more.
    fn frames() -> [Vec<u8>; 3] {
        let black = vec![0; 18];
        let mut red = black.clone();
        red[15] = 255;
        [black, red.clone(), red]
    }

    fn written(format: AnimationFormat) -> Vec<u8> {
        let mut file = Vec::new();
        let mut animation = Animation::new(format, SIZE, 3, &mut file).unwrap();
        for frame in frames() {
            animation.frame(frame, 0.25).unwrap();
        }
        animation.finish().unwrap();
        file
    }

    #[test]
    fn a_png_has_its_frames_as_what_changes() {
        let file = written(AnimationFormat::Png);
        let mut reader = png::Decoder::new(io::Cursor::new(file))
            .read_info()
            .unwrap();
        let mut read = Vec::new();
        for _ in 0..3 {
            let mut bytes = vec![0; 18];
            let info = reader.next_frame(&mut bytes).unwrap();
            let control = reader.info().frame_control.unwrap();
            assert_eq!((control.delay_num, control.delay_den), (250, 1000));
            read.push((
                control.x_offset,
                control.y_offset,
                bytes[..info.buffer_size()].to_vec(),
            ));
        }
        let red = vec![255, 0, 0];
        assert_eq!(read, [(0, 0, vec![0; 18]), (2, 1, red), (0, 0, vec![0; 3])]);
        assert_eq!(reader.info().animation_control.unwrap().num_plays, 0);
    }

    #[test]
    fn a_gif_has_its_frames_as_what_changes() {
        let file = written(AnimationFormat::Gif);
        let mut options = gif::DecodeOptions::new();
        options.set_color_output(gif::ColorOutput::RGBA);
        let mut decoder = options.read_info(&file[..]).unwrap();
        assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
        let mut read = Vec::new();
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            assert_eq!(frame.delay, 25);
            read.push((frame.left, frame.top, frame.buffer[..3].to_vec()));
        }
        let [black, red] = [vec![0, 0, 0], vec![255, 0, 0]];
        assert_eq!(read, [(0, 0, black.clone()), (2, 1, red), (0, 0, black)]);
    }

    #[test]
    fn frames_that_are_missing_are_an_error() {
        let mut file = Vec::new();
        let mut animation = Animation::new(AnimationFormat::Png, SIZE, 2, &mut file).unwrap();
        animation.frame(vec![0; 18], 1.0).unwrap();
        assert!(animation.finish().is_err());
    }
}
