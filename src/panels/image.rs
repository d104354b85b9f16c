//! The picture so far: what is drawn in full colour, what is still to come as a faint ghost, and what the step works on.
//!
//! Where the rays of one pixel are followed, the picture so far is that pixel: the finished picture is shown in full colour
//! around it, so that it can be seen what the pixel is part of. So it is where a run begins and ends; but of a room, whose light is
//! found step by step, only the light so far is shown.

mod layers;
mod light;
mod marks;
mod pin;
mod placing;
mod so_far;
mod value;
mod view;

pub(in crate::panels) use so_far::SoFar;
pub use value::value;
pub use view::{ImageView, PixelLayer};

use super::grip::Sight;
use super::horizon::{after_your_answer, srgb_bytes};
use super::strings::focus;
use super::values::{sentence, step_in_words};
use super::{PanelInput, Properties};
use crate::algorithms::focus::Focus;
use crate::figure::{elided, joined};
use crate::language::{Language, Message};
use crate::picture::{Image, Ink, Picture, Rect, Style, Tag, ascent, elide};
use crate::replay::Run;
use glam::{UVec2, Vec2};
use layers::ShownLayer;
use light::Light;
use marks::Marks;
use placing::Placing;
use std::iter;

const CAPTION: f32 = 11.5;
const CAPTION_HEIGHT: f32 = 20.0;

const ONLY: Message = Message("image-only");
const DRAWN: Message = Message("image-drawn");

pub const PANEL: Properties = Properties::titled(Message("app-image"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let mut picture = Picture::new(size.x, size.y);
    let marks = marks(input);
    let pixels = pixels(input);
    let middle = middle(input);
    let placing = Placing::new(
        pixels.as_vec2(),
        area(input, size),
        &input.image.shown,
        middle,
    );
    let Some(placing) = placing else {
        return picture;
    };
    let shown = ShownLayer::of(input);
    let hidden = input.hidden_pixels(&input.finished.picture);
    let (image, drawn) = image(input, shown.as_ref(), hidden.as_deref());
    picture.clipped(placing.frame, |picture| {
        picture.pixels(placing.whole, image, (0, 0));
        placing.grid(picture);
        if let Some(marks) = &marks {
            marks.draw(picture, input.focus, &placing.fit);
        }
        if let Some(pixel) = pin::pixel(input.pinned, pixels) {
            pin::draw(picture, pixel, &placing, input.language);
        }
        input.answered.draw(picture, |tag| match tag {
            Tag::Pixel { x, y } => Some(placing.fit.pixels(x, x + 1, y)),
            _ => None,
        });
    });
    if marks.is_none() && hidden.is_some() {
        after_your_answer(&mut picture, placing.frame, input.language);
    }
    picture.rect(placing.frame, Ink::Rule.stroke(1.0));
    placing.numbers(&mut picture, marks.as_ref().and_then(|marks| marks.pixel));
    let row = Rect::new(4.0, size.y - CAPTION_HEIGHT, size.x - 8.0, CAPTION_HEIGHT);
    match (&shown, &marks) {
        (Some(shown), _) => shown.legend(&mut picture, row, input),
        (None, Some(marks)) => caption(&mut picture, input, marks, pixels, placing.fit.scale),
        (None, None) => {
            if let Some(title) = light::title(input) {
                let set = Style::Body.size(CAPTION).ink(Ink::Muted).middle();
                elided(&mut picture, row, &title, set);
            }
        }
    }
    picture.alt = alt(input, marks.as_ref(), drawn);
    picture
}

/// What the step works on; none where the run draws no pixels, but exchanges light between patches.
fn marks<'a>(input: &PanelInput<'a>) -> Option<Marks<'a>> {
    match input.run {
        Run::Wireframe(replay) => Some(Marks::of_wireframe(replay.state())),
        Run::Shading(_, replay) => Some(Marks::of_shading(replay.state())),
        Run::Rays(_, replay) => Some(Marks::of_rays(replay.state())),
        Run::Radiosity(..) | Run::FormFactor(..) | Run::Hierarchical(..) => None,
    }
}

/// Columns and rows of the picture.
fn pixels(input: &PanelInput) -> UVec2 {
    match input.run.canvas() {
        Some(canvas) => UVec2::new(canvas.width() as u32, canvas.height() as u32),
        None => {
            let finished = &input.finished.picture;
            UVec2::new(finished.width, finished.rows.len() as u32)
        }
    }
}

/// Where the picture stands, in a panel of that size.
fn area(input: &PanelInput, size: Vec2) -> Rect {
    let is_said = input.run.canvas().is_some() || light::title(input).is_some();
    let has_row = is_said || ShownLayer::of(input).is_some();
    let row = if has_row { CAPTION_HEIGHT } else { 0.0 };
    Rect::new(0.0, 0.0, size.x, size.y - row)
}

/// Where the whole picture stands in a panel of that size: what zooming and dragging are reckoned by.
pub fn place(input: &PanelInput, size: Vec2) -> Rect {
    let is_part = input.image.shown.zoom > 1.0;
    Placing::of_whole(pixels(input).as_vec2(), area(input, size), is_part)
}

/// How the world is seen in a panel of that size; none where there is no room.
pub fn sight(input: &PanelInput, size: Vec2) -> Option<Sight> {
    let pixels = pixels(input).as_vec2();
    let placing = Placing::new(pixels, area(input, size), &input.image.shown, middle(input))?;
    Some(Sight::Camera {
        view: input.run.prepared().view,
        fit: placing.fit,
        area: placing.frame,
    })
}

/// What is in the middle, in shares of the picture: what was chosen, or the current pixel.
pub fn middle(input: &PanelInput) -> Vec2 {
    let view = &input.image.shown;
    let followed = || {
        let (x, y) = marks(input)?.pixel.or(match input.focus {
            Focus::Pixel { x, y } => Some((x, y)),
            _ => None,
        })?;
        let middle = (Vec2::new(x as f32, y as f32) + 0.5) / pixels(input).as_vec2();
        let half = Vec2::splat(0.5 / view.zoom);
        Some(middle.clamp(half, 1.0 - half))
    };
    let chosen = view.center.or_else(followed);
    chosen.unwrap_or(view.middle())
}

/// The step in words, and where it is; where pixels are drawn, how many so far.
fn alt(input: &PanelInput, marks: Option<&Marks>, drawn: usize) -> String {
    let step = step_in_words(input);
    let at = marks.and_then(|marks| current(marks, input.language));
    let at = at.unwrap_or_else(|| focus(input.focus, input.language));
    let pinned = pin::pixel(input.pinned, pixels(input));
    let pinned = pinned.map(|pixel| pin::in_words(pixel, input.language));
    let places: Vec<String> = iter::once(at).chain(pinned).collect();
    let alt = sentence(&step, &places, input.language);
    match marks {
        Some(_) => alt + " " + &DRAWN.format(input.language, &[("count", &drawn.to_string())]),
        None => alt,
    }
}

/// The picture so far, or a layer of its pixels; and how many pixels are drawn.
fn image(
    input: &PanelInput,
    shown: Option<&ShownLayer>,
    hidden: Option<&[bool]>,
) -> (Image, usize) {
    let size = pixels(input);
    let (image, drawn) = match input.run.canvas() {
        Some(canvas) => so_far::image(input, canvas, hidden),
        None => {
            let light = Light::of(input).map(|light| light.image());
            (light.unwrap_or_else(|| finished(input, hidden)), 0)
        }
    };
    let Some(shown) = shown else {
        return (image, drawn);
    };
    let places = (0..size.y).flat_map(|y| (0..size.x).map(move |x| (x, y)));
    let bytes = places.flat_map(|(x, y)| shown.color(input, x, y));
    (
        Image::new(size.x, size.y, bytes.collect::<Vec<u8>>()),
        drawn,
    )
}

/// The finished picture alone: a form factor draws no pixels.
fn finished(input: &PanelInput, hidden: Option<&[bool]>) -> Image {
    let finished = &input.finished.picture;
    let bytes = srgb_bytes(finished, hidden);
    Image::new(finished.width, finished.rows.len() as u32, bytes)
}

/// Size, zoom, focus and what the step works on, as far as there is room.
fn caption(picture: &mut Picture, input: &PanelInput, marks: &Marks, pixels: UVec2, zoom: f64) {
    let zoom = if zoom >= 1.0 {
        format!(
            "×{}",
            input.language.fixed(zoom, usize::from(zoom.fract() != 0.0))
        )
    } else {
        format!("{:.0} %", 100.0 * zoom)
    };
    let size = format!("{} × {}, {zoom}", pixels.x, pixels.y);
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
mod tests;
