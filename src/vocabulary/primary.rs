//! A ray through each pixel.

use super::entry::{When, entry, is, only};
use crate::algorithms::primary::Event;

vocabulary! {
    [] Event {
    };
    Event::Pixel { x, y, samples } => "Pixel" at "pixel" number "x", "y" scope "scope-pixel"
        {
            "x" = x,
            "y" = y,
            "samples" = (samples > 1).then_some(samples),
        }
        [
            only(When::Unrecorded("x_P"), "event-primary-pixel", &[]),
        ];
    Event::Through { place, sample } => "Through" at "through"
        {
            "sample" = sample,
            "x_P" = place.x,
            "y_P" = place.y,
        }
        [
            entry("event-through", &[is("x_P"), is("y_P")]),
        ];
    Event::PixelColored { color } => "PixelColored" at "trace"
        {
            "color" = color,
        }
        [
            only(
                When::Recorded("samples"),
                "event-pixel-colored-mean",
                &[is("{pixel=color} = [Σ{+I}; {n=samples}^2]")],
            ),
            only(
                When::Recorded("y_P"),
                "event-pixel-colored-of-ray",
                &[is("{pixel=color} = {+I}")],
            ),
        ];
}
