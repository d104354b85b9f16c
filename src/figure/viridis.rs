//! Viridis (van der Walt & Smith 2015): a scale of colours whose lightness rises evenly, also to those who see few colours.

/// sRGB at tenths of the scale.
const COLORS: [[u8; 3]; 11] = [
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

/// The colour at `share` of the scale, from 0 to 1.
pub fn viridis(share: f64) -> [u8; 3] {
    let at = share.clamp(0.0, 1.0) * (COLORS.len() - 1) as f64;
    let below = (at as usize).min(COLORS.len() - 2);
    let (from, to) = (COLORS[below], COLORS[below + 1]);
    let between = at - below as f64;
    std::array::from_fn(|c| {
        let (from, to) = (f64::from(from[c]), f64::from(to[c]));
        (from + between * (to - from)).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_rises_along_the_scale() {
        let luma = |i: u32| {
            let [r, g, b] = viridis(f64::from(i) / 100.0).map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!((1..=100).all(|i| luma(i) > luma(i - 1)));
        assert_eq!(viridis(f64::NAN.max(0.0)), COLORS[0]);
        assert_eq!(viridis(0.5), [0x21, 0x91, 0x8c]);
        assert_eq!(viridis(1.0), [0xfd, 0xe7, 0x25]);
    }
}
