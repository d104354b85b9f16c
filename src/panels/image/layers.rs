//! What is shown of the pixels in place of their colours, and what its colours mean.

use super::super::message::labelled;
use super::super::names::object as object_name;
use super::PixelLayer;
use crate::color::Rgb;
use crate::figure::{color_strip, viridis};
use crate::language::{Language, Message};
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Style, Theme, elide};
use crate::render::{Layer, Layers};
use crate::replay::Run;
use glam::DVec3;

/// Where a ray meets no object.
const NOTHING: [u8; 3] = [0x38, 0x38, 0x38];
const LEGEND: f32 = 11.5;
/// Of a legend's patch of colour.
const CHIP: f32 = 10.0;

const NORMAL_COLORS: Message = Message("image-normal-colors");
const NO_OBJECT: Message = Message("image-no-object");

/// The layer that is shown, with the least and the largest of its values.
pub(super) struct ShownLayer<'a> {
    layer: PixelLayer,
    layers: &'a Layers,
    low: f64,
    high: f64,
}

impl<'a> ShownLayer<'a> {
    /// None where the picture is shown in its colours: they are wanted, a question waits, or the layer is not found yet.
    pub fn of(input: &PanelInput<'a>) -> Option<Self> {
        let layer = input.image.layer;
        let layers = input.finished.layers.as_ref()?;
        if layer == PixelLayer::Color || input.is_pending() {
            return None;
        }
        let mut shown = ShownLayer {
            layer,
            layers,
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
        };
        for (index, pixel) in layers.pixels.iter().enumerate() {
            let (x, y) = (index as u32 % layers.width, index as u32 / layers.width);
            if let Some(value) = shown.value(input, pixel, x, y) {
                shown.low = shown.low.min(value);
                shown.high = shown.high.max(value);
            }
        }
        Some(shown)
    }

    /// The number that a colour stands for; none where there is none.
    fn value(&self, input: &PanelInput, pixel: &Layer, x: u32, y: u32) -> Option<f64> {
        match self.layer {
            PixelLayer::Depth => depth(input, pixel, x, y),
            PixelLayer::Rays => Some(pixel.rays as f64),
            PixelLayer::Color | PixelLayer::Object | PixelLayer::Normal => None,
        }
    }

    /// Of pixel (x, y), as bytes.
    pub fn color(&self, input: &PanelInput, x: u32, y: u32) -> [u8; 3] {
        let Some(pixel) = self.layers.get(x, y) else {
            return NOTHING;
        };
        let shown = match self.layer {
            PixelLayer::Object => pixel.surface.map(|met| object_color(met.object)),
            PixelLayer::Normal => pixel.surface.map(|met| normal_color(met.normal)),
            _ => self
                .value(input, pixel, x, y)
                .map(|value| self.scale(self.share(value)).to_srgb8()),
        };
        shown.unwrap_or(NOTHING)
    }

    fn share(&self, value: f64) -> f64 {
        match self.high > self.low {
            true => (value - self.low) / (self.high - self.low),
            false => 0.0,
        }
    }

    /// What is near is bright; so are pixels of many rays.
    fn scale(&self, share: f64) -> Rgb {
        match self.layer {
            PixelLayer::Depth => viridis(1.0 - share),
            _ => viridis(share),
        }
    }

    /// What the colours mean.
    pub fn legend(&self, picture: &mut Picture, row: Rect, input: &PanelInput) {
        let language = input.language;
        let set = Style::Body.size(LEGEND).ink(Ink::Muted);
        let title = self.layer.title().text(language);
        picture.text_in(row, title, set.ink(Ink::Text));
        let left = set.width(title) + 14.0;
        let row = Rect::between((row.x + left, row.y), (row.right(), row.bottom()));
        match self.layer {
            PixelLayer::Depth | PixelLayer::Rays if self.high >= self.low => {
                let ends = [self.low, self.high].map(|value| language.short(value, 3));
                let color = |share| self.scale(share);
                color_strip(picture, row, [&ends[0], &ends[1]], set, color);
            }
            PixelLayer::Normal => {
                let text = NORMAL_COLORS.text(language);
                picture.text_in(row, elide(text, Style::Body, LEGEND, row.width), set);
            }
            PixelLayer::Object => self.objects(picture, row, input),
            _ => {}
        }
    }

    /// The names of the objects that are seen, as many as there is room for.
    fn objects(&self, picture: &mut Picture, row: Rect, input: &PanelInput) {
        let set = Style::Body.size(LEGEND).ink(Ink::Muted);
        let mut seen: Vec<u32> = self
            .layers
            .pixels
            .iter()
            .filter_map(|pixel| Some(pixel.surface?.object))
            .collect();
        seen.sort_unstable();
        seen.dedup();
        let mut x = row.x;
        for object in seen {
            let name = object_name(input.run.prepared(), object, input.language);
            let end = x + CHIP + 4.0 + set.width(name);
            if end > row.right() {
                picture.text_in(Rect { x, ..row }, "…", set);
                return;
            }
            let chip = Rect::new(x, row.center().y - 0.5 * CHIP, CHIP, CHIP);
            let color = Ink::Rgb(Rgb::from_srgb8(object_color(object)));
            picture.rect(chip, color.fill().outlined(Ink::Rule.stroke(1.0)));
            let place = Rect {
                x: x + CHIP + 4.0,
                ..row
            };
            picture.text_in(place, name, set);
            x = end + 12.0;
        }
    }
}

/// Of what the run has drawn at a pixel, and where it has drawn nothing, of what a ray meets there.
fn depth(input: &PanelInput, pixel: &Layer, x: u32, y: u32) -> Option<f64> {
    let dot = input
        .run
        .canvas()
        .and_then(|canvas| canvas.get(x as usize, y as usize));
    let drawn = dot.filter(|dot| dot.step.is_some() && dot.depth.is_finite());
    let converts = matches!(input.run, Run::Shading(..));
    let of_ray = pixel.surface.map(|met| met.depth);
    match drawn {
        Some(dot) => Some(dot.depth),
        // The depth buffer is filled step by step.
        None if converts && !super::so_far::shows_finished(input) => None,
        None => of_ray,
    }
}

fn object_color(object: u32) -> [u8; 3] {
    Theme::Light.color(Ink::Series((object % 7) as u8))
}

/// Each coordinate from −1 to 1 as a channel from 0 to 255.
fn normal_color(normal: DVec3) -> [u8; 3] {
    normal
        .to_array()
        .map(|side| (127.5 * (side + 1.0)).round() as u8)
}

/// What a layer says of pixel (x, y), in words; none of the colours.
pub(super) fn said(input: &PanelInput, x: u32, y: u32) -> Option<String> {
    let shown = ShownLayer::of(input)?;
    let pixel = shown.layers.get(x, y)?;
    let language = input.language;
    let value = match shown.layer {
        PixelLayer::Color => return None,
        PixelLayer::Rays => pixel.rays.to_string(),
        PixelLayer::Depth => match depth(input, pixel, x, y) {
            Some(depth) => language.short(depth, 4),
            None => NO_OBJECT.text(language).to_string(),
        },
        PixelLayer::Object => match pixel.surface {
            Some(met) => object_name(input.run.prepared(), met.object, language).to_string(),
            None => NO_OBJECT.text(language).to_string(),
        },
        PixelLayer::Normal => match pixel.surface {
            Some(met) => vector(met.normal, language),
            None => NO_OBJECT.text(language).to_string(),
        },
    };
    let title = shown.layer.title().text(language);
    Some(labelled(title, &value, language))
}

fn vector(vector: DVec3, language: Language) -> String {
    let sides = vector.to_array().map(|side| language.short(side, 3));
    format!("({})", language.list(sides))
}
