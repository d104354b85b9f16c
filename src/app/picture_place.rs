//! The place of a picture on the screen.

use crate::picture::Theme;
use egui::{Pos2, Rect, Ui};
use glam::Vec2;

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
    pub fn size(&self) -> Vec2 {
        Vec2::new(self.rect.width(), self.rect.height()) / self.zoom
    }

    /// The place on the screen of a point of the picture.
    pub fn on_screen(&self, point: Vec2) -> Pos2 {
        self.rect.min + self.zoom * egui::vec2(point.x, point.y)
    }

    /// The point of the picture at a place on the screen.
    pub fn point(&self, at: Pos2) -> Vec2 {
        let at = (at - self.rect.min) / self.zoom;
        Vec2::new(at.x, at.y)
    }

    /// Pixels a point of the picture.
    pub fn pixels(&self) -> f32 {
        self.scale * self.zoom
    }

    /// All that pixels depend on: a picture may move on the screen as it is.
    pub fn looks_like(&self, other: &Place) -> bool {
        let size = |place: &Place| (place.rect.size() * place.scale).round();
        let looks = |place: &Place| (place.scale, place.zoom, place.theme);
        size(self) == size(other) && looks(self) == looks(other)
    }
}
