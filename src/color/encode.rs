//! 8-bit sRGB by tables: the rounded transfer function and its inverse without their powers, for pictures of many pixels.

use super::{srgb_decode, srgb_encode};
use std::sync::LazyLock;

/// Buckets of [0, 1). The transfer function is steepest at 0, 12.92·255 codes a unit: fewer than one a bucket, so that a
/// bucket meets at most one border between codes.
const BUCKETS: usize = 4096;

struct Table {
    /// The code at the lower end of each bucket, and of 1.
    codes: [u8; BUCKETS + 1],
    /// The least linear value of the next code, by code.
    borders: [f64; 256],
}

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    let mut borders = [f64::INFINITY; 256];
    for (code, border) in borders[..255].iter_mut().enumerate() {
        *border = least_beyond(code as u8);
    }
    let mut codes = [0; BUCKETS + 1];
    for (bucket, code) in codes.iter_mut().enumerate() {
        *code = rounded(bucket as f64 / BUCKETS as f64);
    }
    Table { codes, borders }
});

/// Each channel clamped to [0, 1], encoded, rounded to nearest; NaN becomes 0.
pub(super) fn srgb8(channels: [f64; 3]) -> [u8; 3] {
    let table = &*TABLE;
    channels.map(|linear| {
        let linear = linear.clamp(0.0, 1.0);
        // A cast from float takes NaN to 0.
        let bucket = (linear * BUCKETS as f64) as usize;
        let code = table.codes[bucket];
        code + u8::from(linear >= table.borders[usize::from(code)])
    })
}

static LINEAR: LazyLock<[f64; 256]> =
    LazyLock::new(|| std::array::from_fn(|code| srgb_decode(code as f64 / 255.0)));

/// The linear values of codes.
pub(super) fn linear(codes: [u8; 3]) -> [f64; 3] {
    let table = &*LINEAR;
    codes.map(|code| table[usize::from(code)])
}

/// The definition that the table is made of.
fn rounded(linear: f64) -> u8 {
    (srgb_encode(linear) * 255.0).round() as u8
}

/// The least value in [0, 1] whose code is larger than `code`, which is below 255. Positive floats are ordered as their bits.
fn least_beyond(code: u8) -> f64 {
    let (mut low, mut high) = (0, 1.0_f64.to_bits());
    while high - low > 1 {
        let middle = low + (high - low) / 2;
        if rounded(f64::from_bits(middle)) > code {
            high = middle;
        } else {
            low = middle;
        }
    }
    f64::from_bits(high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_rounds_as_the_definition_does() {
        let borders = TABLE.borders[..255]
            .iter()
            .flat_map(|&border| [border.next_down(), border, border.next_up()]);
        let buckets = (0..=BUCKETS).flat_map(|bucket| {
            let start = bucket as f64 / BUCKETS as f64;
            [start.next_down(), start, start.next_up()]
        });
        let spread = (0..100_000).map(|i| f64::from(i) * 1.000_1e-5);
        let odd = [
            -1.0,
            -0.0,
            7.0,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NAN,
            f64::MIN_POSITIVE,
        ];
        for linear in borders.chain(buckets).chain(spread).chain(odd) {
            assert_eq!(srgb8([linear; 3]), [rounded(linear); 3], "{linear:e}");
        }
    }
}
