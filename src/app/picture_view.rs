//! A picture on the screen: drawn anew only when what it depends on has changed, with the pointer on it.

use super::{crosshair, style};
use crate::picture::{Ink, Picture, Tag, Theme, draw_over, rasterize};
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

/// Where on the screen, and in what colours.
#[derive(Clone, Copy, PartialEq)]
pub struct Place {
    pub rect: Rect,
    /// Pixels a point.
    scale: f32,
    /// Size on the screen of a point of the picture.
    zoom: f32,
    pub theme: Theme,
}

impl Place {
    /// The whole pixels in `rect`: each of the texture's covers one of the screen's.
    pub fn on_pixels(rect: Rect, theme: Theme, ui: &Ui) -> Self {
        // Where a card cannot hold a texture of that size, the picture is a little coarser.
        let largest =
            ui.input(|input| input.max_texture_side) as f32 / rect.width().max(rect.height());
        let scale = ui.pixels_per_point().min(largest);
        let corner = (rect.min.to_vec2() * scale).round() / scale;
        let size = (rect.size() * scale).floor().max(egui::Vec2::splat(1.0));
        Place {
            rect: Rect::from_min_size(corner.to_pos2(), size / scale),
            scale,
            zoom: 1.0,
            theme,
        }
    }

    /// As a small picture of what is laid out for `least` points at least.
    pub fn laid_out_for(self, least: egui::Vec2) -> Self {
        let zoom = (self.rect.size() / least).min_elem().min(1.0);
        Place { zoom, ..self }
    }

    /// As a picture all of which is `zoom` times as large.
    pub fn enlarged(self, zoom: f32) -> Self {
        Place { zoom, ..self }
    }

    /// The size for which a picture is laid out.
    fn size(&self) -> Vec2 {
        Vec2::new(self.rect.width(), self.rect.height()) / self.zoom
    }

    /// The place on the screen of a point of the picture.
    pub fn on_screen(&self, point: Vec2) -> Pos2 {
        self.rect.min + self.zoom * egui::vec2(point.x, point.y)
    }

    /// The point of the picture at a place on the screen.
    fn point(&self, at: Pos2) -> Vec2 {
        let at = (at - self.rect.min) / self.zoom;
        Vec2::new(at.x, at.y)
    }

    /// Pixels a point of the picture.
    fn pixels(&self) -> f32 {
        self.scale * self.zoom
    }

    /// All that pixels depend on: a picture may move on the screen as it is.
    fn looks_like(&self, other: &Place) -> bool {
        let size = |place: &Place| (place.rect.size() * place.scale).round();
        let looks = |place: &Place| (place.scale, place.zoom, place.theme);
        size(self) == size(other) && looks(self) == looks(other)
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
        if drawn.is_none_or(|(before, known)| !before.looks_like(&place) || *known != key) {
            self.picture = draw(place.size());
            self.pixels = rasterize(&self.picture, place.theme, place.pixels()).ok();
            self.key = Some((place, key));
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
        // Without the braces that only tell how a symbol is set.
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

/// Whether a tag can be found in an image's pixels, which carry no tags of their own.
fn is_place(tag: Tag) -> bool {
    matches!(tag, Tag::Pixel { .. } | Tag::ScanLine(_))
}
