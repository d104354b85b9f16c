//! Image files as bytes: PNG (8 bits, already sRGB-encoded) and PFM (linear 32-bit float).

use super::Rgb;

/// A PNG of `width`×`height` RGB bytes, row by row from the top.
pub fn png_rgb8(width: u32, height: u32, bytes: &[u8]) -> Vec<u8> {
    encode_png(width, height, png::ColorType::Rgb, bytes)
}

/// A PNG of `width`×`height` RGBA bytes with straight alpha, row by row from the top.
pub fn png_rgba8(width: u32, height: u32, bytes: &[u8]) -> Vec<u8> {
    encode_png(width, height, png::ColorType::Rgba, bytes)
}

fn encode_png(width: u32, height: u32, color: png::ColorType, bytes: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    // Writing to memory fails only where width × height × channels is not the length of `bytes`.
    let mut writer = encoder
        .write_header()
        .expect("a picture has a positive size");
    writer
        .write_image_data(bytes)
        .expect("a picture has as many bytes as its size says");
    writer.finish().expect("memory takes the end of a picture");
    file
}

/// A PFM of `pixels`, given row by row from the top: `PF`, scale −1 (little-endian), rows bottom to top, not clamped.
pub fn pfm(width: u32, height: u32, pixels: &[Rgb]) -> Vec<u8> {
    let mut file = format!("PF\n{width} {height}\n-1.0\n").into_bytes();
    for row in pixels.chunks_exact(width as usize).rev() {
        for channel in row.iter().flat_map(|pixel| pixel.channels()) {
            file.extend_from_slice(&(channel as f32).to_le_bytes());
        }
    }
    file
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pfm_runs_from_the_bottom_row_up() {
        let file = pfm(1, 2, &[Rgb::splat(1.0), Rgb::splat(2.5)]);
        assert!(file.starts_with(b"PF\n1 2\n-1.0\n"));
        assert_eq!(file[12..16], 2.5_f32.to_le_bytes());
        assert_eq!(file[24..28], 1.0_f32.to_le_bytes());
    }

    #[test]
    fn png_can_be_read_back() {
        let bytes = [1, 2, 3, 250, 251, 252];
        let file = png_rgb8(2, 1, &bytes);
        let mut reader = png::Decoder::new(std::io::Cursor::new(file))
            .read_info()
            .unwrap();
        let mut read = [0; 6];
        reader.next_frame(&mut read).unwrap();
        assert_eq!(read, bytes);
    }
}
