//! A picture as text: a line an item, in four columns with tabs between them: kind, place, look, content.
//! Lengths are written to a hundredth of a point, colours and opacities as a screen shows them.

use glam::Vec2;
use lightwalk::color::Rgb;
use lightwalk::picture::{Anchor, Dash, Image, Ink, Item, Paint, Picture, Rect, Shape, Stroke};
use std::fmt::Write;

/// A curve of more points than this is written by its ends, its bounds and a hash of its points.
const MOST_POINTS: usize = 24;

pub fn lines(picture: &Picture) -> Vec<String> {
    let size = format!(
        "picture\t{} {}\t\t{:?}",
        number(picture.width),
        number(picture.height),
        picture.alt
    );
    std::iter::once(size)
        .chain(picture.items.iter().map(line))
        .collect()
}

fn line(item: &Item) -> String {
    let (kind, place, mut look, content) = match &item.shape {
        Shape::Rect {
            rect: place,
            radius,
            paint,
        } => {
            let mut look = painted(paint);
            if *radius != 0.0 {
                let _ = write!(look, " radius {}", number(*radius));
            }
            ("rect", rect(*place), look, String::new())
        }
        Shape::Polyline { points, stroke } => {
            ("line", path(points), stroked(stroke), String::new())
        }
        Shape::Polygon { points, paint } => {
            ("polygon", path(points), painted(paint), String::new())
        }
        Shape::Circle {
            center,
            radius,
            paint,
        } => (
            "circle",
            format!("{} radius {}", point(*center), number(*radius)),
            painted(paint),
            String::new(),
        ),
        Shape::Text { at, text, set } => {
            let anchor = match set.anchor {
                Anchor::Start => "",
                Anchor::Middle => " middle",
                Anchor::End => " end",
            };
            let look = format!(
                "{:?} {} {}{anchor}",
                set.style,
                number(set.size),
                ink(set.ink)
            );
            ("text", point(*at), look, format!("{text:?}"))
        }
        Shape::Image {
            rect: place,
            image,
            first_pixel,
        } => {
            let look = first_pixel.map_or(String::new(), |(x, y)| format!("from pixel {x},{y}"));
            ("image", rect(*place), look, pixels(image))
        }
    };
    if let Some(tag) = item.tag {
        let tag: String = format!("{tag:?}").split_whitespace().collect();
        let _ = write!(look, " #{tag}");
    }
    if let Some(clip) = item.clip {
        let _ = write!(look, " clip {}", rect(clip));
    }
    format!("{kind}\t{place}\t{}\t{content}", look.trim_start())
}

/// To a hundredth, without zeros that say nothing.
fn number(value: f32) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0" } else { text }.to_owned()
}

fn point(point: Vec2) -> String {
    format!("{},{}", number(point.x), number(point.y))
}

fn rect(rect: Rect) -> String {
    format!(
        "{} {}×{}",
        point(rect.min()),
        number(rect.width),
        number(rect.height)
    )
}

fn path(points: &[Vec2]) -> String {
    let all: Vec<String> = points.iter().copied().map(point).collect();
    if all.len() <= MOST_POINTS {
        return all.join(" ");
    }
    let bounds = Rect::around(points.iter().copied()).unwrap_or_default();
    format!(
        "{} … {}, {} points within {}, hash {:08x}",
        all[0],
        all[all.len() - 1],
        all.len(),
        rect(bounds),
        hash(all.join(" ").as_bytes())
    )
}

fn ink(ink: Ink) -> String {
    match ink {
        Ink::Rgb(rgb) => srgb(rgb),
        named => format!("{named:?}"),
    }
}

fn srgb(rgb: Rgb) -> String {
    let [r, g, b] = rgb.to_srgb8();
    format!("#{r:02x}{g:02x}{b:02x}")
}

fn opacity(opacity: f32) -> String {
    if opacity == 1.0 {
        return String::new();
    }
    format!("@{}", (opacity.clamp(0.0, 1.0) * 255.0).round())
}

fn painted(paint: &Paint) -> String {
    let fill = paint
        .fill
        .map(|fill| format!("{}{}", ink(fill.ink), opacity(fill.opacity)));
    let outline = paint
        .stroke
        .map(|stroke| format!("outline {}", stroked(&stroke)));
    fill.into_iter()
        .chain(outline)
        .collect::<Vec<_>>()
        .join(" ")
}

fn stroked(stroke: &Stroke) -> String {
    let dash = match stroke.dash {
        Dash::Solid => "",
        Dash::Dashed => " dashed",
        Dash::Dotted => " dotted",
    };
    format!(
        "{}{} {}{dash}",
        ink(stroke.ink),
        opacity(stroke.opacity),
        number(stroke.width)
    )
}

/// An image by its size and a hash of its pixels: they have tests of their own where they are computed.
fn pixels(image: &Image) -> String {
    let bytes: Vec<u8> = (0..image.height() as usize)
        .flat_map(|y| image.row(y).to_vec())
        .collect();
    format!(
        "{}×{} pixels, hash {:08x}",
        image.width(),
        image.height(),
        hash(&bytes)
    )
}

/// FNV-1a of 32 bits.
fn hash(bytes: &[u8]) -> u32 {
    bytes.iter().fold(0x811c_9dc5, |hash, &byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}
