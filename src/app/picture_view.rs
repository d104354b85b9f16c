//! A picture on the screen: drawn anew only when what it depends on has changed, with the pointer on it.

use super::picture_place::Place;
use super::{crosshair, style};
use crate::picture::{Ink, Picture, Tag, draw_over, rasterize};
use egui::{ColorImage, Pos2, Rect, Response, Role, TextureHandle, TextureOptions, Ui, WidgetInfo};
use glam::Vec2;
use tiny_skia::Pixmap;

/// What is kept of a picture from frame to frame; the key is all that it depends on besides its place.
pub struct PictureView<K> {
    key: Option<(Place, K)>,
    picture: Picture,
    /// Without highlights.
    pixels: Option<Pixmap>,
    highlighted: Vec<Tag>,
    texture: Option<TextureHandle>,
}

impl<K> Default for PictureView<K> {
    fn default() -> Self {
        PictureView {
            key: None,
            picture: Picture::default(),
            pixels: None,
            highlighted: Vec::new(),
            texture: None,
        }
    }
}

impl<K: PartialEq> PictureView<K> {
    /// What the picture says, in words.
    pub fn alt(&self) -> &str {
        &self.picture.alt
    }

    /// Brings the pixels up to date; `draw` takes the size in points. What shows one of the tags `lit` is outlined.
    pub fn draw(
        &mut self,
        place: Place,
        key: K,
        mut lit: Vec<Tag>,
        ui: &Ui,
        draw: impl FnOnce(Vec2) -> Picture,
    ) {
        lit.retain(|&tag| {
            self.picture.items.iter().any(|item| item.tag == Some(tag)) || is_place(tag)
        });
        let drawn = self.key.as_ref();
        let looks_alike = drawn.is_some_and(|(before, _)| before.looks_like(&place));
        let mut is_new = false;
        if !looks_alike || drawn.is_none_or(|(_, known)| *known != key) {
            let picture = draw(place.size());
            // Many a step changes nothing that this picture shows.
            is_new = !looks_alike || picture.items != self.picture.items;
            self.picture = picture;
            self.key = Some((place, key));
        }
        if is_new {
            self.pixels = rasterize(&self.picture, place.theme, place.pixels()).ok();
        } else if self.highlighted == lit {
            return;
        }
        self.upload(lit, place, ui);
    }

    fn upload(&mut self, highlighted: Vec<Tag>, place: Place, ui: &Ui) {
        let Some(pixels) = &self.pixels else { return };
        let size = [pixels.width() as usize, pixels.height() as usize];
        let items: Vec<_> = highlighted
            .iter()
            .flat_map(|&tag| self.picture.highlight(tag))
            .collect();
        let image = if items.is_empty() {
            ColorImage::from_rgba_premultiplied(size, pixels.data())
        } else {
            let mut lit = pixels.clone();
            draw_over(&mut lit, &items, place.theme, place.pixels());
            ColorImage::from_rgba_premultiplied(size, lit.data())
        };
        self.highlighted = highlighted;
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::NEAREST),
            None => {
                let texture = ui
                    .ctx()
                    .load_texture("picture", image, TextureOptions::NEAREST);
                self.texture = Some(texture);
            }
        }
    }

    /// Puts the picture on the screen under its name. Returns what lies under the pointer.
    pub fn paint(&self, place: Place, name: &str, response: &Response, ui: &Ui) -> Option<Tag> {
        let rect = place.rect;
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name));
        // Without the braces that only say how a symbol is set.
        let spoken = self.alt().replace(['{', '}'], "");
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_description(spoken));
        if let Some(texture) = &self.texture {
            let whole = Rect::from_min_max(Pos2::ZERO, Pos2::new(1.0, 1.0));
            ui.painter()
                .image(texture.id(), rect, whole, egui::Color32::WHITE);
        }
        if response.has_focus() {
            let stroke = egui::Stroke::new(2.0, style::color(place.theme, Ink::Linked));
            ui.painter()
                .rect_stroke(rect, 2.0, stroke, egui::StrokeKind::Inside);
            return crosshair::show(&self.picture, place, response, ui);
        }
        let under = self.picture.hit(place.point(response.hover_pos()?))?;
        ui.ctx().set_cursor_icon(egui::CursorIcon::PointingHand);
        Some(under)
    }
}

/// A picture with more in it than this part of its area is too large for something to stand beside it.
const LARGE: f32 = 0.3;

impl<K> PictureView<K> {
    /// Where on the screen all that shows a tag lies; none where that is nothing, or a large part of the picture.
    pub fn bounds(&self, tag: Tag, place: Place) -> Option<Rect> {
        let bounds = self.picture.tagged_bounds(tag)?;
        let [first, last] = [bounds.min(), bounds.max()].map(|point| place.on_screen(point));
        let bounds = Rect::from_min_max(first, last);
        (bounds.area() <= LARGE * place.rect.area()).then_some(bounds)
    }
}

/// Whether a tag can be found in an image's pixels, which carry no tags of their own.
fn is_place(tag: Tag) -> bool {
    matches!(tag, Tag::Pixel { .. } | Tag::ScanLine(_))
}
