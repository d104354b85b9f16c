//! A ray through each pixel.

use super::entry::{Formula, When, entry, is, only};
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
            only(
                When::Recorded("sample"),
                "event-through",
                &[
                    is("{i=sample_row} := ⌊sample / {n=samples}⌋"),
                    is("{j=sample_column} := sample − {i=sample_row} · {n=samples}"),
                    is("x_P = x + [{j=sample_column} + 0.5; {n=samples}]"),
                    is("y_P = y + [{i=sample_row} + 0.5; {n=samples}]"),
                    SCREEN_POINT,
                    ],
            ),
            entry(
                "event-through",
                &[is("x_P = x + 0.5"), is("y_P = y + 0.5"), SCREEN_POINT],
            ),
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

/// The point of the projection plane that stands at (x_P, y_P).
pub(super) const SCREEN_POINT: Formula = is(
    "screen_point = eye + (x_P − [width; 2]) · right + ([height; 2] − y_P) · up + focal · forward",
);
