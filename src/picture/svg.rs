//! Pictures as SVG, for print and for the web: the same display list, in shapes that stay sharp at any size.
//!
//! Text stays text, glyph by glyph at the places that the rasteriser gives them, so that a reader without the bundled fonts sees
//! the same layout. Coordinates are the picture's, in points.

use super::font::{Face, glyphs};
use super::ink::{Fill, Ink, Paint, Stroke};
use super::rect::Rect;
use super::shape::{Image, Item, Shape};
use super::text::{Text, place};
use super::{Picture, Theme};
use crate::color::{png_rgb8, png_rgba8};
use glam::Vec2;
use std::fmt::{self, Write};

/// The picture as a whole SVG file of that title, in the colours of `theme` and as large as the theme wants it.
pub fn to_svg(picture: &Picture, title: &str, theme: Theme) -> String {
    let namespace = r#" xmlns="http://www.w3.org/2000/svg""#;
    svg(picture, title, theme, namespace, "c") + "\n"
}

/// The same as an element of an HTML page, in which no other id begins with `id`.
pub fn svg_element(picture: &Picture, title: &str, theme: Theme, id: &str) -> String {
    svg(picture, title, theme, "", id)
}

fn svg(picture: &Picture, title: &str, theme: Theme, namespace: &str, id: &str) -> String {
    let mut svg = Svg {
        theme,
        id,
        body: String::new(),
        clips: Vec::new(),
    };
    for item in &picture.items {
        svg.item(item);
    }
    let mut clips = String::new();
    for (number, clip) in svg.clips.iter().enumerate() {
        let frame = frame(*clip);
        let _ = write!(
            clips,
            r#"<clipPath id="{id}{number}"><rect {frame}/></clipPath>"#
        );
    }
    let size = [picture.width, picture.height];
    let [width, height] = size.map(|side| Number(side * theme.text_scale()));
    let [inner_width, inner_height] = size.map(Number);
    let [title, alt] = [title, &picture.alt].map(escaped);
    let surface = svg.color(Ink::Surface);
    let body = svg.body;
    format!(
        r#"<svg{namespace} width="{width}" height="{height}" viewBox="0 0 {inner_width} {inner_height}" role="img" stroke-linejoin="round"><title>{title}</title><desc>{alt}</desc><defs>{clips}</defs><path d="M0 0h{inner_width}v{inner_height}H0z" fill="{surface}"/>
{body}</svg>"#
    )
}

struct Svg<'a> {
    theme: Theme,
    /// What ids begin with.
    id: &'a str,
    body: String,
    clips: Vec<Rect>,
}

impl Svg<'_> {
    fn item(&mut self, item: &Item) {
        if let Some(clip) = item.clip {
            let known = self.clips.iter().position(|other| *other == clip);
            let number = known.unwrap_or_else(|| {
                self.clips.push(clip);
                self.clips.len() - 1
            });
            let id = self.id;
            self.put(format_args!(r#"<g clip-path="url(#{id}{number})">"#));
        }
        self.shape(&item.shape);
        let end = if item.clip.is_some() { "</g>\n" } else { "\n" };
        self.body += end;
    }

    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Rect {
                rect,
                radius,
                paint,
            } => {
                // An outline lies inside the edges.
                let inset = paint.stroke.map_or(0.0, |stroke| 0.5 * stroke.width);
                let frame = frame(rect.grown(-inset));
                let round = match (radius - inset).max(0.0) {
                    0.0 => String::new(),
                    radius => format!(r#" rx="{}""#, Number(radius)),
                };
                let paint = self.paint(*paint);
                self.put(format_args!("<rect {frame}{round} {paint}/>"));
            }
            Shape::Polyline { points, stroke } => {
                let (points, stroke) = (list(points), self.stroke(*stroke));
                self.put(format_args!(
                    r#"<polyline points="{points}" fill="none" {stroke}/>"#
                ));
            }
            Shape::Polygon { points, paint } => {
                let (points, paint) = (list(points), self.paint(*paint));
                self.put(format_args!(r#"<polygon points="{points}" {paint}/>"#));
            }
            Shape::Circle {
                center,
                radius,
                paint,
            } => {
                let paint = self.paint(*paint);
                let [x, y, radius] = [center.x, center.y, *radius].map(Number);
                self.put(format_args!(
                    r#"<circle cx="{x}" cy="{y}" r="{radius}" {paint}/>"#
                ));
            }
            Shape::Text { at, text, set } => self.text(*at, text, *set),
            Shape::Image { rect, image, .. } => {
                // Pixels are seen as such where they are enlarged.
                let hard = match rect.width >= image.width() as f32 {
                    true => r#" style="image-rendering:pixelated""#,
                    false => "",
                };
                let (frame, data) = (frame(*rect), base64(&png(image)));
                self.put(format_args!(
                    r#"<image {frame} preserveAspectRatio="none"{hard} href="data:image/png;base64,{data}"/>"#
                ));
            }
        }
    }

    /// One `text` with a `tspan` for each run of glyphs of one face, size and height. A space at the start or behind another has no
    /// place: readers leave it out, and would give its place to the next glyph.
    fn text(&mut self, at: Vec2, text: &str, set: Text) {
        let start = set.bounds(at, text).x;
        let mut runs: Vec<(Face, f32, f32, String, String)> = Vec::new();
        let mut behind_space = true;
        place(&mut glyphs(), text, set.style, set.size, |placed| {
            let is_space = placed.character.is_ascii_whitespace();
            if std::mem::replace(&mut behind_space, is_space) && is_space {
                return;
            }
            let (face, size, y) = (placed.glyph.face, placed.size, at.y - placed.rise);
            let x = Number(start + placed.x);
            match runs.last_mut() {
                Some((same, of, level, xs, text)) if (*same, *of, *level) == (face, size, y) => {
                    let _ = write!(xs, " {x}");
                    text.push(placed.character);
                }
                _ => runs.push((face, size, y, x.to_string(), placed.character.into())),
            }
        });
        let fill = self.color(set.ink);
        self.put(format_args!(r#"<text fill="{fill}">"#));
        for (face, size, y, xs, text) in runs {
            let (family, text) = (family(face), escaped(&text));
            let [y, size] = [y, size].map(Number);
            self.put(format_args!(
                r#"<tspan x="{xs}" y="{y}" font-size="{size}" {family}>{text}</tspan>"#
            ));
        }
        self.body += "</text>";
    }

    fn paint(&self, paint: Paint) -> String {
        let fill = match paint.fill {
            Some(Fill { ink, opacity }) => {
                let opacity = share("fill-opacity", opacity);
                format!(r#"fill="{}"{opacity}"#, self.color(ink))
            }
            None => r#"fill="none""#.into(),
        };
        match paint.stroke {
            Some(stroke) => format!("{fill} {}", self.stroke(stroke)),
            None => fill,
        }
    }

    fn stroke(&self, stroke: Stroke) -> String {
        let dash = stroke.dash.lengths().map_or(String::new(), |[on, off]| {
            format!(r#" stroke-dasharray="{on} {off}""#)
        });
        let (color, width) = (self.color(stroke.ink), Number(stroke.width));
        let opacity = share("stroke-opacity", stroke.opacity);
        format!(r#"stroke="{color}" stroke-width="{width}"{opacity}{dash}"#)
    }

    fn color(&self, ink: Ink) -> String {
        let [r, g, b] = self.theme.color(ink);
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    fn put(&mut self, text: std::fmt::Arguments) {
        // Writing to memory does not fail.
        let _ = self.body.write_fmt(text);
    }
}

/// A coordinate, to a hundredth of a point.
struct Number(f32);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let text = format!("{:.2}", self.0);
        let short = text.trim_end_matches('0').trim_end_matches('.');
        f.write_str(if short == "-0" { "0" } else { short })
    }
}

/// An attribute that is 1 where it is not given.
fn share(name: &str, share: f32) -> String {
    match share {
        1.0 => String::new(),
        share => format!(r#" {name}="{}""#, Number(share)),
    }
}

fn frame(rect: Rect) -> String {
    let [x, y, width, height] = [rect.x, rect.y, rect.width, rect.height].map(Number);
    format!(r#"x="{x}" y="{y}" width="{width}" height="{height}""#)
}

/// Points that are not finite are nowhere.
fn list(points: &[Vec2]) -> String {
    let finite = points.iter().filter(|point| point.is_finite());
    let points = finite.map(|point| format!("{},{}", Number(point.x), Number(point.y)));
    points.collect::<Vec<_>>().join(" ")
}

fn family(face: Face) -> &'static str {
    match face {
        Face::Sans => r#"font-family="DejaVu Sans, Verdana, sans-serif""#,
        Face::Bold => r#"font-family="DejaVu Sans, Verdana, sans-serif" font-weight="bold""#,
        Face::Mono => r#"font-family="DejaVu Sans Mono, monospace""#,
        Face::MonoBold => r#"font-family="DejaVu Sans Mono, monospace" font-weight="bold""#,
        Face::SerifItalic => r#"font-family="DejaVu Serif, serif" font-style="italic""#,
    }
}

fn png(image: &Image) -> Vec<u8> {
    let bytes: Vec<u8> = (0..image.height() as usize)
        .flat_map(|y| image.row(y).iter().copied())
        .collect();
    match image.channels() {
        4 => png_rgba8(image.width(), image.height(), &bytes),
        _ => png_rgb8(image.width(), image.height(), &bytes),
    }
}

/// What XML cannot hold as it is.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '>' => escaped += "&gt;",
            c if c.is_control() => escaped.push(' '),
            c => escaped.push(c),
        }
    }
    escaped
}

/// RFC 4648, §4.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |i: usize| u32::from(group.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for digit in 0..4 {
            let index = (bits >> (18 - 6 * digit) & 63) as usize;
            let padded = digit > group.len();
            text.push(if padded { '=' } else { DIGITS[index].into() });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Style;

    #[test]
    fn base64_is_that_of_the_rfc() {
        for (text, encoded) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(text.as_bytes()), encoded);
        }
    }

    #[test]
    fn every_shape_is_written_and_every_element_is_closed() {
        let mut picture = Picture::new(100.0, 50.0);
        picture.alt = "a < b & c".into();
        picture.clipped(Rect::new(0.0, 0.0, 60.0, 40.0), |picture| {
            picture.rect(Rect::new(1.0, 2.0, 30.0, 20.0), Ink::Text.stroke(2.0));
            picture.circle((5.0, 6.0), 3.0, Ink::This);
        });
        picture.line((0.0, 0.0), (9.0, 9.0), Ink::This.stroke(1.0).dashed());
        picture.polygon([(0.0, 0.0), (9.0, 0.0), (9.0, 9.0)], Ink::Good);
        picture.image(Rect::new(0.0, 0.0, 4.0, 4.0), Image::new(1, 1, [1, 2, 3]));
        picture.text((50.0, 20.0), "I_4 < 1", Style::Label.size(12.0).end());
        let svg = to_svg(&picture, "A <panel>", Theme::Light);
        for part in [
            "<title>A &lt;panel&gt;</title><desc>a &lt; b &amp; c</desc>",
            r#"<rect x="2" y="3" width="28" height="18""#,
            r#"stroke-dasharray="5 4""#,
            "data:image/png;base64,iVBOR",
            r#"clip-path="url(#c0)""#,
        ] {
            assert!(svg.contains(part), "{part} is not in {svg}");
        }
        assert_eq!(svg.matches("<clipPath").count(), 1);
        for element in ["g", "text", "tspan", "svg", "title", "desc", "defs"] {
            let opened = svg.matches(&format!("<{element}")).count();
            assert_eq!(
                opened,
                svg.matches(&format!("</{element}>")).count(),
                "{element}"
            );
        }
    }

    #[test]
    fn text_ends_where_it_is_anchored() {
        let mut picture = Picture::new(100.0, 50.0);
        let set = Style::Mono.size(10.0).end();
        picture.text((50.0, 20.0), "ab", set);
        let svg = to_svg(&picture, "A <panel>", Theme::Light);
        let advance = set.width("a");
        let (a, b) = (50.0 - 2.0 * advance, 50.0 - advance);
        assert!(
            svg.contains(&format!(r#"x="{} {}" y="20""#, Number(a), Number(b))),
            "{svg}"
        );
    }

    #[test]
    fn spaces_that_readers_leave_out_have_no_place() {
        let mut picture = Picture::new(100.0, 50.0);
        let set = Style::Mono.size(10.0);
        picture.text((0.0, 20.0), " a  b", set);
        let svg = to_svg(&picture, "", Theme::Light);
        let advance = set.width("a");
        let [a, space, b] = [1.0, 2.0, 4.0].map(|glyphs| Number(glyphs * advance));
        assert!(svg.contains(&format!(r#"x="{a} {space} {b}""#)), "{svg}");
        assert!(svg.contains(">a b</tspan>"), "{svg}");
    }

    #[test]
    fn a_file_has_the_ground_and_the_size_of_its_theme() {
        let picture = Picture::new(80.0, 40.0);
        let svg = to_svg(&picture, "", Theme::Projector);
        assert!(svg.contains(r#"width="100" height="50" viewBox="0 0 80 40""#));
        assert!(svg.contains(r##"<path d="M0 0h80v40H0z" fill="#ffffff"/>"##));
    }

    #[test]
    fn an_element_of_a_page_has_ids_of_its_own_and_no_address() {
        let mut picture = Picture::new(80.0, 40.0);
        picture.clipped(Rect::new(0.0, 0.0, 9.0, 9.0), |picture| {
            picture.circle((5.0, 6.0), 3.0, Ink::This);
        });
        let svg = svg_element(&picture, "", Theme::Light, "p7-");
        assert!(svg.contains(r#"<clipPath id="p7-0">"#) && svg.contains("url(#p7-0)"));
        assert!(!svg.contains("://"), "{svg}");
    }
}
