//! Pictures of other programs, from the bytes of their files: PNG, PPM and PFM.

use std::io::Cursor;

/// The most pixels of a picture that is read.
const MOST_PIXELS: u64 = 1 << 26;

/// A picture as it is stored, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct StoredImage {
    pub width: u32,
    pub height: u32,
    /// Of integers, shares of the largest.
    pub pixels: Vec<[f64; 3]>,
    /// Whether the numbers are floats; else they are integers, for the screen.
    pub is_float: bool,
}

/// Reads a PNG, PPM or PFM file, known by its first bytes. Errors: what is wrong with it.
pub fn read_image(bytes: &[u8]) -> Result<StoredImage, String> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => read_png(bytes),
        [b'P', b'6' | b'3', ..] => read_ppm(bytes),
        [b'P', b'F' | b'f', ..] => read_pfm(bytes),
        _ => Err("found no picture; PNG, PPM (P3, P6) and PFM files can be read".into()),
    }
}

/// How many bytes of a PPM or PFM file that can be read follow its pixels, where the pixels are bytes.
pub fn surplus(bytes: &[u8]) -> usize {
    let (numbers, of_header) = match bytes {
        [b'P', b'6', ..] => (3, 3),
        [b'P', b'F', ..] => (3, 2),
        [b'P', b'f', ..] => (1, 2),
        _ => return 0,
    };
    let mut header = Header(&bytes[2..]);
    let sides = [header.whole(), header.whole()].map(|side| side.unwrap_or(0) as usize);
    let size_of_number = match header.word() {
        _ if of_header == 2 => 4,
        Ok(most) if most.len() > 3 || most > "255" && most.len() == 3 => 2,
        _ => 1,
    };
    let needed = numbers * size_of_number * sides[0] * sides[1];
    header.after_space().len().saturating_sub(needed)
}

fn read_png(bytes: &[u8]) -> Result<StoredImage, String> {
    let wrong = |error: png::DecodingError| format!("cannot be read as a PNG file: {error}");
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(wrong)?;
    let (width, height) = (reader.info().width, reader.info().height);
    check_size(width.into(), height.into())?;
    let size = reader.output_buffer_size();
    let mut buffer = vec![0; size.ok_or("the picture is too large")?];
    let frame = reader.next_frame(&mut buffer).map_err(wrong)?;
    let samples: Vec<f64> = match frame.bit_depth {
        png::BitDepth::Sixteen => {
            let (pairs, _) = buffer.as_chunks::<2>();
            let share = |&pair: &[u8; 2]| f64::from(u16::from_be_bytes(pair)) / 65535.0;
            pairs.iter().map(share).collect()
        }
        _ => buffer.iter().map(|&byte| f64::from(byte) / 255.0).collect(),
    };
    let channels = frame.color_type.samples();
    let pixels = samples.chunks_exact(channels).map(|pixel| match channels {
        1 | 2 => [pixel[0]; 3],
        _ => [pixel[0], pixel[1], pixel[2]],
    });
    let count = width as usize * height as usize;
    Ok(StoredImage {
        width,
        height,
        pixels: pixels.take(count).collect(),
        is_float: false,
    })
}

fn read_ppm(bytes: &[u8]) -> Result<StoredImage, String> {
    let mut header = Header(bytes.get(2..).unwrap_or_default());
    let [width, height, most] = [header.whole()?, header.whole()?, header.whole()?];
    check_size(width, height)?;
    if !(1..=65535).contains(&most) {
        return Err(format!(
            "found the largest value {most}; allowed are 1 to 65535"
        ));
    }
    let count = 3 * (width * height) as usize;
    let samples: Vec<u64> = if bytes[1] == b'3' {
        (0..count)
            .map(|_| header.whole())
            .collect::<Result<_, _>>()?
    } else {
        let data = header.after_space();
        let wide = most > 255;
        let needed = if wide { 2 * count } else { count };
        if data.len() < needed {
            return Err(format!(
                "the file has {} bytes of pixels; it needs {needed}",
                data.len()
            ));
        }
        match wide {
            true => data[..needed]
                .chunks_exact(2)
                .map(|pair| u64::from(u16::from_be_bytes([pair[0], pair[1]])))
                .collect(),
            false => data[..needed].iter().map(|&byte| u64::from(byte)).collect(),
        }
    };
    if let Some(larger) = samples.iter().find(|&&sample| sample > most) {
        return Err(format!(
            "found the value {larger}; allowed are values up to {most}, the largest that its header names"
        ));
    }
    let share = |sample: u64| sample as f64 / most as f64;
    let (triples, _) = samples.as_chunks::<3>();
    Ok(StoredImage {
        width: width as u32,
        height: height as u32,
        pixels: triples.iter().map(|triple| triple.map(share)).collect(),
        is_float: false,
    })
}

fn read_pfm(bytes: &[u8]) -> Result<StoredImage, String> {
    let channels = if bytes[1] == b'F' { 3 } else { 1 };
    let mut header = Header(bytes.get(2..).unwrap_or_default());
    let [width, height] = [header.whole()?, header.whole()?];
    check_size(width, height)?;
    let scale: f64 = header
        .word()?
        .parse()
        .map_err(|_| "its scale is no number")?;
    if !scale.is_finite() || scale == 0.0 {
        return Err(format!(
            "found the scale {scale}; allowed are numbers below 0 (little-endian) and above 0 (big-endian)"
        ));
    }
    let data = header.after_space();
    let needed = 4 * channels * (width * height) as usize;
    if data.len() < needed {
        return Err(format!(
            "the file has {} bytes of pixels; it needs {needed}",
            data.len()
        ));
    }
    let (words, _) = data[..needed].as_chunks::<4>();
    let number = |&word: &[u8; 4]| match scale < 0.0 {
        true => f64::from(f32::from_le_bytes(word)),
        false => f64::from(f32::from_be_bytes(word)),
    };
    let samples: Vec<f64> = words.iter().map(number).collect();
    if samples.iter().any(|sample| !sample.is_finite()) {
        return Err("found a pixel that is not finite".into());
    }
    let pixels: Vec<[f64; 3]> = samples
        .chunks_exact(channels)
        .map(|pixel| [pixel[0], pixel[channels / 2], pixel[channels - 1]])
        .collect();
    // Rows are stored from the bottom up.
    let rows = pixels.chunks_exact(width as usize).rev();
    Ok(StoredImage {
        width: width as u32,
        height: height as u32,
        pixels: rows.flatten().copied().collect(),
        is_float: true,
    })
}

/// Before memory is taken.
fn check_size(width: u64, height: u64) -> Result<(), String> {
    let fits = width > 0 && height > 0 && width.saturating_mul(height) <= MOST_PIXELS;
    fits.then_some(()).ok_or_else(|| {
        format!("found a picture of {width}×{height}; at most {MOST_PIXELS} pixels are read")
    })
}

/// The words of a header, with comments between them.
struct Header<'a>(&'a [u8]);

impl<'a> Header<'a> {
    fn word(&mut self) -> Result<&'a str, String> {
        loop {
            self.0 = self.0.trim_ascii_start();
            match self.0.first() {
                Some(b'#') => {
                    let end = self.0.iter().position(|&byte| byte == b'\n');
                    self.0 = &self.0[end.unwrap_or(self.0.len())..];
                }
                Some(_) => break,
                None => return Err("the file ends within its numbers".into()),
            }
        }
        let end = self.0.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = self.0.split_at(end.unwrap_or(self.0.len()));
        self.0 = rest;
        std::str::from_utf8(word).map_err(|_| "its header is no text".to_owned())
    }

    fn whole(&mut self) -> Result<u64, String> {
        let word = self.word()?;
        word.parse()
            .map_err(|_| format!("found “{word}” in place of a whole number"))
    }

    /// What follows the one space after the header.
    fn after_space(&self) -> &'a [u8] {
        self.0.get(1..).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Rgb, pfm, png_rgb8};
    use super::*;

    #[test]
    fn each_format_is_read_as_it_is_written() {
        let png = read_image(&png_rgb8(2, 1, &[0, 51, 255, 255, 0, 0])).unwrap();
        assert_eq!(png.pixels, [[0.0, 0.2, 1.0], [1.0, 0.0, 0.0]]);
        assert!(!png.is_float);
        let pixels = [Rgb::new(0.5, 2.0, -1.0), Rgb::splat(0.25)];
        let pfm = read_image(&pfm(1, 2, &pixels)).unwrap();
        assert_eq!(pfm.pixels, [[0.5, 2.0, -1.0], [0.25; 3]]);
        assert!(pfm.is_float);
        let ppm = read_image(b"P6 # mine\n1 2\n255\n\x00\x33\xff\xff\x00\x00").unwrap();
        assert_eq!(ppm.pixels, png.pixels);
        let text = read_image(b"P3\n1 2 255\n0 51 255  255 0 0\n").unwrap();
        assert_eq!(text, ppm);
        let grey = read_image(b"Pf\n1 1\n1.0\n\x3f\x00\x00\x00").unwrap();
        assert_eq!(grey.pixels, [[0.5; 3]]);
    }

    #[test]
    fn bytes_behind_the_pixels_are_counted() {
        for (bytes, count) in [
            (&b"P6 1 1 255\n\x00\x33\xff"[..], 0),
            (b"P6 1 1 255\n\x00\x33\xff\n\n", 2),
            (b"P6 1 1 256\n\x00\x33\x00\x00\x00\x00\x07", 1),
            (b"Pf 1 1 1\n\x3f\x00\x00\x00\x00\x00\x00", 3),
            (b"P3 1 1 255 1 2 3  ", 0),
        ] {
            assert_eq!(surplus(bytes), count);
        }
    }

    #[test]
    fn what_is_no_picture_is_refused_with_the_reason() {
        for (bytes, reason) in [
            (&b"GIF89a"[..], "PNG, PPM"),
            (b"P6 9", "ends within"),
            (b"P6 99999 99999 255\n", "at most"),
            (b"P6 0 4 255\n", "at most"),
            (
                b"P3 1 1 255 0 300 0",
                "found the value 300; allowed are values up to 255",
            ),
            (b"P6 1 1 9\n\x00\x0a\x00", "found the value 10"),
            (
                b"PF 1 1 0\n\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00",
                "found the scale 0",
            ),
            (b"Pf 1 1 NaN\n\x00\x00\x00\x00", "found the scale NaN"),
            (b"P6 2 2 255\n\x00", "needs 12"),
            (b"PF 2 x -1\n", "whole number"),
            (
                b"PF 1 1 -1\n\x00\x00\xc0\x7f\x00\x00\x00\x00\x00\x00\x00\x00",
                "not finite",
            ),
            (b"\x89PNG\r\n", "PNG"),
        ] {
            let error = read_image(bytes).unwrap_err();
            assert!(error.contains(reason), "{error}");
        }
    }
}
