//! The frame and its polygons.

use super::entry::{entry, is};
use crate::algorithms::prepared_scene::Event;

vocabulary! {
    [] Event {
    };
    Event::Frame { width, height, ambient } => "Frame" at "polygon" scope ("frame", "gambar")
        {
            "width" = width,
            "height" = height,
            "A" = ambient,
        }
        [
            entry(
                "The frame begins: {width} × {height} pixels, lit by the ambient light A.",
                "Gambar dimulai: {width} × {height} piksel, dengan cahaya ambien A.",
                &[is("{A}")],
            ),
        ];
    Event::Polygon { object, polygon } => "Polygon" at "polygon" number "polygon" scope ("polygon", "poligon")
        {
            "object" = object,
            "polygon" = polygon,
        }
        [
            entry(
                "Polygon {polygon} begins; it belongs to object {object}.",
                "Poligon {polygon} dimulai; bagian dari objek {object}.",
                &[],
            ),
        ];
    Event::PolygonDone => "PolygonDone" at "polygon"
        {
        }
        [
            entry(
                "Polygon {polygon} is done.",
                "Poligon {polygon} selesai.",
                &[],
            ),
        ];
    Event::FrameDone => "FrameDone" at "polygon"
        {
        }
        [
            entry(
                "The frame is done.",
                "Gambar selesai.",
                &[],
            ),
        ];
}
