//! Scales of colours, from 0 to 1 or from −1 to 1, and the strip that says what they mean.

use crate::color::Rgb;
use crate::picture::{Image, Ink, Picture, Rect, Text};

/// Viridis at tenths of the scale, in sRGB.
const VIRIDIS: [[u8; 3]; 11] = [
    [0x44, 0x01, 0x54],
    [0x48, 0x24, 0x75],
    [0x41, 0x44, 0x87],
    [0x35, 0x5f, 0x8d],
    [0x2a, 0x78, 0x8e],
    [0x21, 0x91, 0x8c],
    [0x22, 0xa8, 0x84],
    [0x44, 0xbf, 0x70],
    [0x7a, 0xd1, 0x51],
    [0xbd, 0xdf, 0x26],
    [0xfd, 0xe7, 0x25],
];

/// Viridis (van der Walt & Smith 2015) at `share` of the scale, from 0 to 1: its lightness rises evenly, also to those who see few
/// colours.
pub fn viridis(share: f64) -> Rgb {
    let at = share.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let below = (at as usize).min(VIRIDIS.len() - 2);
    between(VIRIDIS[below], VIRIDIS[below + 1], at - below as f64)
}

/// From −1, blue, over 0, nearly white, to 1, orange: distinguished also by those who see red and green alike.
pub fn diverging(share: f64) -> Rgb {
    const ENDS: [[u8; 3]; 2] = [[0x08, 0x45, 0x94], [0xb3, 0x58, 0x06]];
    const MIDDLE: [u8; 3] = [0xf7, 0xf7, 0xf7];
    let share = share.clamp(-1.0, 1.0);
    let end = ENDS[usize::from(share > 0.0)];
    // A root, so that small differences are seen too.
    between(MIDDLE, end, share.abs().sqrt())
}

fn between(from: [u8; 3], to: [u8; 3], share: f64) -> Rgb {
    Rgb::from_srgb8(std::array::from_fn(|c| {
        let (from, to) = (f64::from(from[c]), f64::from(to[c]));
        (from + share * (to - from)).round() as u8
    }))
}

/// Colours from left to right; `color` takes shares from 0 to 1.
pub fn gradient(color: impl Fn(f64) -> Rgb) -> Image {
    const COLORS: u32 = 64;
    let last = f64::from(COLORS - 1);
    let bytes = (0..COLORS).flat_map(|step| color(f64::from(step) / last).to_srgb8());
    Image::new(COLORS, 1, bytes.collect::<Vec<u8>>())
}

/// What colours mean: a strip of them with what stands at its ends, at the left of `row`. Nothing where there is no room for it.
pub fn color_strip(
    picture: &mut Picture,
    row: Rect,
    [low, high]: [&str; 2],
    set: Text,
    color: impl Fn(f64) -> Rgb,
) {
    const GAP: f32 = 6.0;
    const LONGEST: f32 = 160.0;
    const SHORTEST: f32 = 16.0;
    let x = row.x + set.width(low) + GAP;
    let length = (row.right() - set.width(high) - GAP - x).min(LONGEST);
    if length < SHORTEST {
        return;
    }
    let strip = Rect::new(x, row.center().y - 5.0, length, 10.0);
    picture.text_in(row, low, set);
    picture.image(strip, gradient(color));
    picture.rect(strip, Ink::Rule.stroke(1.0));
    let right = Rect {
        x: strip.right() + GAP,
        ..row
    };
    picture.text_in(right, high, set);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_rises_along_the_scale() {
        let luma = |i: u32| {
            let [r, g, b] = viridis(f64::from(i) / 100.0).to_srgb8().map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!((1..=100).all(|i| luma(i) > luma(i - 1)));
        assert_eq!(viridis(-1.0).to_srgb8(), VIRIDIS[0]);
        assert_eq!(viridis(0.5).to_srgb8(), [0x21, 0x91, 0x8c]);
        assert_eq!(viridis(1.0).to_srgb8(), [0xfd, 0xe7, 0x25]);
    }
}
