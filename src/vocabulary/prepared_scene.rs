//! The frame and its polygons.

use super::entry::{entry, is};
use crate::algorithms::prepared_scene::Event;

vocabulary! {
    [] Event {
    };
    Event::Frame { width, height, ambient } => "Frame" at "polygon" scope "scope-frame"
        {
            "width" = width,
            "height" = height,
            "A" = ambient,
        }
        [
            entry(
                "event-frame",
                &[
                    is("forward = [target − eye; |target − eye|]"),
                    is("right = [forward × camera_up; |forward × camera_up|]"),
                    is("up = right × forward"),
                    is("focal = [width; 2 tan half_fov]"),
                    is("A"),
                    ],
            ),
        ];
    Event::Polygon { object, polygon } => "Polygon" at "polygon" number "polygon" scope "scope-polygon"
        {
            "object" = object,
            "polygon" = polygon,
        }
        [
            entry("event-polygon", &[]),
        ];
    Event::PolygonDone => "PolygonDone" at "polygon"
        {
        }
        [
            entry("event-polygon-done", &[]),
        ];
    Event::FrameDone => "FrameDone" at "polygon"
        {
        }
        [
            entry("event-frame-done", &[]),
        ];
}
