//! The picture so far: what is drawn in full colour, what is still to come as a faint ghost, and what the step works on.
//!
//! Where the rays of one pixel are followed, the picture so far is that pixel: the finished picture is shown in full colour
//! around it, so that it can be seen what the pixel is part of. So it is where a run begins and ends.

mod marks;
mod value;

pub use value::value;

use super::horizon::{after_your_answer, hatch, hatched};
use super::strings::focus;
use super::values::{sentence, step_in_words};
use super::{PanelInput, Properties};
use crate::algorithms::focus::Focus;
use crate::color::Rgb;
use crate::figure::{Fit, joined};
use crate::language::{Language, Message};
use crate::picture::{Image, Ink, Picture, Rect, Style, Tag, ascent, elide};
use crate::replay::shading::Dot;
use crate::replay::{Canvas, Run};
use glam::Vec2;
use marks::Marks;
use std::iter;

/// How far what is not drawn yet stands out from the background, of 255.
const GHOST: i32 = 60;
/// Points a pixel from which on the pixels are told apart by a grid.
const GRID: f64 = 6.0;
/// Least part of its room that a picture with pixels of one size fills.
const FILLED: f64 = 0.9;
const CAPTION: f32 = 11.5;
const CAPTION_HEIGHT: f32 = 20.0;

const ONLY: Message = Message("image-only");
const DRAWN: Message = Message("image-drawn");

pub const PANEL: Properties = Properties::titled(Message("app-image"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let mut picture = Picture::new(size.x, size.y);
    let marks = match input.run {
        Run::Wireframe(replay) => Marks::of_wireframe(replay.state()),
        Run::Shading(_, replay) => Marks::of_shading(replay.state()),
        Run::Rays(_, replay) => Marks::of_rays(replay.state()),
        Run::Radiosity(..) | Run::FormFactor(..) => return finished(input, size),
    };
    let (canvas, background) = (marks.canvas, marks.prepared.scene.background);
    let (width, height) = (canvas.width(), canvas.height());
    let area = Rect::new(0.0, 0.0, size.x, size.y - CAPTION_HEIGHT);
    if width == 0 || height == 0 || area.is_empty() {
        return picture;
    }
    let zoom = zoom(Vec2::new(width as f32, height as f32), area);
    let extent = Vec2::new(width as f32, height as f32) * zoom as f32;
    // On whole points, so that pixels are equally large on every screen.
    let origin = origin(Vec2::new(area.width, area.height), extent);
    let frame = Rect::between(origin, origin + extent);
    let fit = Fit::at_origin(origin, zoom);

    let hidden = input.hidden_pixels(&input.finished.picture);
    let (image, drawn) = image(input, canvas, background, hidden.as_deref());
    picture.pixels(frame, image, (0, 0));
    picture.clipped(frame, |picture| {
        if zoom >= GRID {
            grid(picture, width as u32, height as u32, &fit);
        }
        marks.draw(picture, input.focus, &fit);
        input.answered.draw(picture, |tag| match tag {
            Tag::Pixel { x, y } => Some(fit.pixels(x, x + 1, y)),
            _ => None,
        });
    });
    picture.rect(frame, Ink::Rule.stroke(1.0));
    caption(&mut picture, input, &marks, (width, height), zoom);

    let at = current(&marks, input.language).unwrap_or_else(|| focus(input.focus, input.language));
    let drawn = DRAWN.format(input.language, &[("count", &drawn.to_string())]);
    picture.alt = sentence(&step_in_words(input), &[at], input.language) + " " + &drawn;
    picture
}

/// The finished picture alone: the exchange of light between patches draws no pixels.
fn finished(input: &PanelInput, size: Vec2) -> Picture {
    let mut picture = Picture::new(size.x, size.y);
    let (width, height) = (
        input.finished.picture.width,
        input.finished.picture.rows.len() as u32,
    );
    let area = Rect::new(0.0, 0.0, size.x, size.y);
    if width == 0 || height == 0 || area.is_empty() {
        return picture;
    }
    let zoom = zoom(Vec2::new(width as f32, height as f32), area);
    let extent = Vec2::new(width as f32, height as f32) * zoom as f32;
    let origin = origin(size, extent);
    let frame = Rect::between(origin, origin + extent);
    let finished = &input.finished.picture;
    let hidden = input.hidden_pixels(finished);
    let exposure = exposure(input.run);
    let colors = finished
        .color
        .iter()
        .map(|&color| (color * exposure).to_srgb8());
    let bytes = hatched(colors, width, hidden.as_deref());
    picture.pixels(frame, Image::new(width, height, bytes), (0, 0));
    if hidden.is_some() {
        after_your_answer(&mut picture, frame, input.language);
    }
    picture.rect(frame, Ink::Rule.stroke(1.0));
    let focus = focus(input.focus, input.language);
    picture.alt = sentence(&step_in_words(input), &[focus], input.language);
    picture
}

/// As bright as the panel of the room shows the same light.
fn exposure(run: &Run) -> f64 {
    let Run::Radiosity(_, replay) = run else {
        return 1.0;
    };
    let solved = replay.state().solved.as_ref();
    solved.map_or(1.0, |solved| solved.exposure)
}

/// Where a picture of that extent begins that stands in the middle of `room`.
fn origin(room: Vec2, extent: Vec2) -> Vec2 {
    // Rounding may have made it a little larger than its room.
    (0.5 * (room - extent)).floor().max(Vec2::ZERO)
}

/// Points a pixel: the largest whole number that fits; where that leaves much of the room empty, as many as fit, since pixels that differ
/// by one point then matter less than a picture that is too small.
fn zoom(picture: Vec2, area: Rect) -> f64 {
    let fitting = f64::from((Vec2::new(area.width, area.height) / picture).min_element());
    if fitting.floor() >= FILLED * fitting {
        fitting.floor()
    } else {
        fitting
    }
}

/// The canvas, and where nothing is drawn on it yet the finished picture as a ghost, hatched where it is hidden; and how many
/// pixels are drawn.
fn image(
    input: &PanelInput,
    canvas: &Canvas<Dot>,
    background: Rgb,
    hidden: Option<&[bool]>,
) -> (Image, usize) {
    let ground = background.to_srgb8();
    let mut bytes = vec![0; 3 * canvas.width() * canvas.height()];
    let (pixels, _) = bytes.as_chunks_mut();
    let around = shows_finished(input);
    let mut both = iter::zip(pixels, &input.finished.picture.color).enumerate();
    let mut drawn = 0;
    // `for_each`, not `for`: the canvas hands out its tiles' rows much faster.
    canvas.iter().for_each(|dot| {
        // A finished picture that is smaller than the canvas leaves the rest black.
        let Some((at, (pixel, &finished))) = both.next() else {
            return;
        };
        *pixel = if dot.step.is_some() {
            drawn += 1;
            dot.color.to_srgb8()
        } else if hidden.is_some_and(|hidden| hidden[at]) {
            hatch(at % canvas.width(), at / canvas.width())
        } else if around {
            finished.to_srgb8()
        } else if finished == background {
            ground
        } else {
            ghost(finished.to_srgb8(), ground)
        };
    });
    let (width, height) = (canvas.width() as u32, canvas.height() as u32);
    (Image::new(width, height, bytes), drawn)
}

/// Whether the finished picture is seen where the run has drawn nothing.
fn shows_finished(input: &PanelInput) -> bool {
    let follows_rays = matches!(input.run, Run::Rays(..));
    follows_rays && matches!(input.focus, Focus::Pixel { .. }) || is_outermost(input)
}

/// Whether the step opens or closes the frame: a run begins and ends with the picture that it is about.
fn is_outermost(input: &PanelInput) -> bool {
    let walk = input.run.walk();
    !walk.is_empty() && walk.outline().depth(walk.position()) == 0
}

/// A colour of the finished picture, faint: nearer to the background than to itself.
fn ghost(finished: [u8; 3], background: [u8; 3]) -> [u8; 3] {
    std::array::from_fn(|channel| {
        let (to, from) = (i32::from(finished[channel]), i32::from(background[channel]));
        (from + (to - from) * GHOST / 255) as u8
    })
}

fn grid(picture: &mut Picture, width: u32, height: u32, fit: &Fit) {
    let all = (
        fit.x(0.0),
        fit.x(width.into()),
        fit.y(0.0),
        fit.y(height.into()),
    );
    let (left, right, top, bottom) = all;
    let stroke = Ink::Rule.stroke(1.0).opacity(0.25);
    for x in 1..width {
        let x = fit.x(x.into());
        picture.line((x, top), (x, bottom), stroke);
    }
    for y in 1..height {
        let y = fit.y(y.into());
        picture.line((left, y), (right, y), stroke);
    }
}

/// Size, zoom, focus and what the step works on, as far as there is room.
fn caption(
    picture: &mut Picture,
    input: &PanelInput,
    marks: &Marks,
    (width, height): (usize, usize),
    zoom: f64,
) {
    let zoom = if zoom >= 1.0 {
        format!(
            "×{}",
            input.language.fixed(zoom, usize::from(zoom.fract() != 0.0))
        )
    } else {
        format!("{:.0} %", 100.0 * zoom)
    };
    let size = format!("{width} × {height}, {zoom}");
    let focus = focus(input.focus, input.language);
    let focus = ONLY.format(input.language, &[("focus", &focus)]);
    let room = picture.width - 8.0;
    let set = Style::Body.size(CAPTION);
    let more = iter::once(focus).chain(current(marks, input.language));
    let text = joined(iter::once(size).chain(more), " · ", set, room);
    let text = elide(&text, Style::Body, CAPTION, room);
    let baseline = picture.height - 0.5 * (CAPTION_HEIGHT - ascent(Style::Body, CAPTION)) - 1.0;
    let middle = 0.5 * picture.width;
    picture.text((middle, baseline), text, set.ink(Ink::Muted).middle());
}

/// The smallest thing that the step works on, in words.
fn current(marks: &Marks, language: Language) -> Option<String> {
    if let Some((x, y)) = marks.pixel {
        return Some(focus(Focus::Pixel { x, y }, language));
    }
    if let Some(y) = marks.row {
        return Some(focus(Focus::ScanLine(y), language));
    }
    let polygon = marks.polygon? as usize;
    Some(focus(Focus::Polygon(polygon), language))
}

#[cfg(test)]
mod tests {
    use super::super::fixture::Fixture;
    use super::*;
    use crate::picture::{Shape, Tag, Theme, rasterize};
    use crate::render::Method;

    /// The frame that the picture's pixels fill.
    fn frame(picture: &Picture) -> Rect {
        let image = |item: &crate::picture::Item| match &item.shape {
            Shape::Image { rect, .. } => Some(*rect),
            _ => None,
        };
        picture.items.iter().find_map(image).unwrap()
    }

    #[test]
    fn the_centre_of_a_pixel_is_that_pixel() {
        for fixture in [
            Fixture::triangle(Method::Gouraud).go_to("SpanInterpolated", 40),
            Fixture::pyramid(Method::Flat).go_to("PixelColored", 700),
            Fixture::triangle(Method::Wireframe).go_to("PixelPlotted", 30),
        ] {
            for size in [[260.0, 180.0], [460.0, 380.0], [1400.0, 900.0]] {
                let picture = draw(&fixture.input(), Vec2::from(size));
                let (width, height) = (
                    fixture.finished.picture.width,
                    fixture.finished.picture.rows.end,
                );
                let frame = frame(&picture);
                assert!(picture.bounds().encloses(&frame));
                let pixel = Vec2::new(frame.width / width as f32, frame.height / height as f32);
                for (x, y) in [(0, 0), (width / 3, height / 2), (width - 1, height - 1)] {
                    let centre = frame.min() + pixel * (Vec2::new(x as f32, y as f32) + 0.5);
                    assert_eq!(picture.hit(centre), Some(Tag::Pixel { x, y }), "{size:?}");
                }
            }
        }
    }

    #[test]
    fn large_pixels_are_enlarged_by_a_whole_number_and_small_ones_as_far_as_they_fit() {
        let area = Rect::new(0.0, 0.0, 460.0, 380.0);
        assert_eq!(zoom(Vec2::new(48.0, 36.0), area), 9.0);
        assert_eq!(zoom(Vec2::new(184.0, 10.0), area), 2.5);
        assert!((zoom(Vec2::new(640.0, 480.0), area) - 460.0 / 640.0).abs() < 1e-6);
    }

    #[test]
    fn what_is_to_come_is_fainter_than_what_is_drawn() {
        let mut fixture = Fixture::triangle(Method::Gouraud);
        let size = Vec2::new(480.0, 380.0);
        // Within the frame, before anything is drawn, and once the whole run is over.
        let opening = draw(&fixture.input(), size);
        fixture.run.walk_mut().seek(1);
        let ghost = draw(&fixture.input(), size);
        let last = fixture.run.walk().len() - 1;
        fixture.run.walk_mut().seek(last);
        let drawn = draw(&fixture.input(), size);
        let color = |picture: &Picture, x: u32, y: u32| {
            let frame = frame(picture);
            let scale = frame.width / fixture.finished.picture.width as f32;
            let at = frame.min() + scale * (Vec2::new(x as f32, y as f32) + 0.5);
            let pixels = rasterize(picture, Theme::Light, 1.0).unwrap();
            let color = pixels.pixel(at.x as u32, at.y as u32).unwrap();
            [color.red(), color.green(), color.blue()]
        };
        let finished = fixture.finished.picture.pixel(22, 16).to_srgb8();
        assert_eq!(color(&drawn, 22, 16), finished);
        assert_eq!(color(&opening, 22, 16), finished);
        // A ghost is nearer to the background than to the finished colour, and not the background.
        let background = fixture.finished.picture.pixel(2, 33).to_srgb8();
        let faint = color(&ghost, 22, 16)[0];
        assert!(faint.abs_diff(background[0]) * 2 < faint.abs_diff(finished[0]));
        assert!(faint.abs_diff(background[0]) > 10);
        assert_eq!(color(&ghost, 2, 33), background);
        assert_eq!(color(&drawn, 2, 33), background);
    }

    #[test]
    fn the_alternative_text_says_the_step() {
        let mut fixture = Fixture::triangle(Method::Gouraud);
        fixture.go_to("PixelColored", 3);
        let alt = draw(&fixture.input(), Vec2::new(300.0, 200.0)).alt;
        assert!(
            alt.contains("Pixel coloured") && alt.contains("so far: 4."),
            "{alt}"
        );
    }
}
