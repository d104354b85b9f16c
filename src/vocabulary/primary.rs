//! A ray through each pixel.

use super::entry::{When, entry, is, only};
use crate::algorithms::primary::Event;

vocabulary! {
    [] Event {
    };
    Event::Pixel { x, y, samples } => "Pixel" at "pixel" number "x" scope ("pixel", "piksel")
        {
            "x" = x,
            "y" = y,
            "samples" = (samples > 1).then_some(samples),
        }
        [
            only(
                When::Unrecorded("x_P"),
                "Pixel ({x}, {y}) begins: a ray finds its colour.",
                "Piksel ({x}, {y}) dimulai: sebuah sinar mencari warnanya.",
                &[],
            ),
        ];
    Event::Through { place } => "Through" at "through"
        {
            "x_P" = place.x,
            "y_P" = place.y,
        }
        [
            entry(
                "The primary ray goes through this point of the picture plane, in pixels: the centre of the pixel, or of a cell of it.",
                "Sinar primer melewati titik bidang gambar ini, dalam piksel: pusat piksel, atau pusat sel di dalamnya.",
                &[is("{x_P}"), is("{y_P}")],
            ),
        ];
    Event::PixelColored { color } => "PixelColored" at "trace"
        {
            "color" = color,
        }
        [
            only(
                When::Recorded("samples"),
                "The pixel takes the mean of what its rays brought back.",
                "Piksel mendapat rata-rata dari yang dibawa kembali sinar-sinarnya.",
                &[is("{pixel=color} = [{ΣI=+I}; {n=samples}^2]")],
            ),
            only(
                When::Recorded("y_P"),
                "The pixel takes what its ray brought back.",
                "Piksel mendapat yang dibawa kembali sinarnya.",
                &[is("{pixel=color} = {I=+I}")],
            ),
        ];
}
