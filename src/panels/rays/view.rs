//! A parallel projection of the scene onto a part of the panel.

use super::outline;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::figure::{Fit, Projection, within};
use crate::picture::{Rect, Text};
use crate::scene::Light;
use glam::{DVec2, DVec3, Vec2};

/// How far around the camera's target things are shown, in distances from eye to target.
const REACH: f64 = 1.2;
/// By how much a side of the view moves out for lights beyond it, in sizes of the view. There are few such places, so that the
/// view stays as it is while a light is moved a little; lights further out are not shown in their place.
const GROWTH: [f64; 5] = [0.15, 0.4, 0.7, 1.1, 1.6];

/// Height that is left free at the lower border, for names.
const NAMES: f32 = 12.0;

/// Where places of the world are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    pub projection: Projection,
    /// Nothing is drawn outside.
    pub area: Rect,
}

impl View {
    /// The direction in which the camera looks is to the right, up is up.
    pub fn from_side(prepared: &PreparedScene, area: Rect) -> Self {
        let (across, up) = axes(prepared);
        View::fitted(across, up, prepared, area)
    }

    /// The direction in which the camera looks is to the right, its left is up.
    pub fn from_above(prepared: &PreparedScene, area: Rect) -> Self {
        let (across, up) = axes(prepared);
        View::fitted(across, up.cross(across), prepared, area)
    }

    fn fitted(across: DVec3, up: DVec3, prepared: &PreparedScene, area: Rect) -> Self {
        let flat = |place: DVec3| DVec2::new(place.dot(across), -place.dot(up));
        let places = outline::extent(prepared, REACH).into_iter().map(flat);
        let (low, high) = places.fold(
            (DVec2::INFINITY, DVec2::NEG_INFINITY),
            |(low, high), place| (low.min(place), high.max(place)),
        );
        let size = (high - low).max_element();
        let (mut shown_low, mut shown_high) = (low, high);
        for light in positions(prepared).map(flat) {
            let farthest = DVec2::splat(GROWTH[GROWTH.len() - 1] * size);
            if light.cmplt(low - farthest).any() || light.cmpgt(high + farthest).any() {
                continue;
            }
            shown_low = shown_low.min(low - (low - light).map(|beyond| grown(beyond, size)));
            shown_high = shown_high.max(high + (light - high).map(|beyond| grown(beyond, size)));
        }
        let mut inner = area.grown(-(0.04 * area.width.min(area.height)).max(12.0));
        // Names stand under what stands on the ground.
        inner.height -= NAMES;
        View {
            projection: Projection {
                across,
                up,
                fit: Fit::new(shown_low, shown_high, inner),
            },
            area,
        }
    }

    /// y up.
    pub fn flat(&self, vector: DVec3) -> DVec2 {
        let Projection { across, up, .. } = self.projection;
        DVec2::new(vector.dot(across), vector.dot(up))
    }

    pub fn place(&self, place: DVec3) -> Vec2 {
        self.projection.place(place)
    }

    /// The place of the world that is drawn at `at`, as far from the viewer as `beside`.
    pub fn lift(&self, at: Vec2, beside: DVec3) -> DVec3 {
        let at = at.clamp(self.area.min(), self.area.max());
        let Projection { across, up, fit } = self.projection;
        let flat = fit.point(at);
        let toward = self.projection.toward_viewer();
        flat.x * across - flat.y * up + beside.dot(toward) * toward
    }

    /// Points a unit of length.
    pub fn scale(&self) -> f32 {
        self.projection.fit.scale as f32
    }

    /// The part of a line that lies in the view.
    pub fn line(&self, from: DVec3, to: DVec3) -> Option<[Vec2; 2]> {
        self.cut(self.place(from), self.place(to))
    }

    pub fn cut(&self, from: Vec2, to: Vec2) -> Option<[Vec2; 2]> {
        within([from, to], self.area.grown(-2.0))
            .filter(|[from, to]| from.is_finite() && to.is_finite())
    }

    /// From a place in a direction to the border of the view; longer than the view is wide.
    pub fn beyond(&self, direction: DVec3) -> f64 {
        let length = self.flat(direction).length();
        let reach = 4.0 * f64::from(self.area.width + self.area.height) / self.projection.fit.scale;
        reach / length.max(1e-3)
    }

    /// In an upper corner: the left one, unless the eye or a light is there.
    pub fn title_place(&self, prepared: &PreparedScene, style: Text, strings: &str) -> Rect {
        let left = style.bounds(self.area.min() + Vec2::new(6.0, 14.0), strings);
        let right = left.shifted(Vec2::new(self.area.width - left.width - 12.0, 0.0));
        let places = std::iter::once(prepared.view.eye).chain(positions(prepared));
        let places: Vec<Vec2> = places.map(|place| self.place(place)).collect();
        let is_free = |corner: &Rect| !places.iter().any(|&at| corner.grown(8.0).contains(at));
        [left, right].into_iter().find(is_free).unwrap_or(left)
    }

    /// Whether a place is drawn within the view, `margin` from its border.
    pub fn shows(&self, place: Vec2, margin: f32) -> bool {
        self.area.grown(-margin).contains(place)
    }
}

/// By how much a side moves out for a light so far beyond it.
fn grown(beyond: f64, size: f64) -> f64 {
    let growth = GROWTH.into_iter().map(|growth| growth * size);
    let enough = growth.into_iter().find(|&growth| growth >= beyond);
    enough.filter(|_| beyond > 0.0).unwrap_or(0.0)
}

/// The horizontal direction in which the camera looks, and up.
fn axes(prepared: &PreparedScene) -> (DVec3, DVec3) {
    let view = &prepared.view;
    let up = prepared
        .scene
        .camera
        .map_or(view.up, |camera| camera.up.normalize());
    let across = (view.forward - view.forward.dot(up) * up).try_normalize();
    (across.unwrap_or(view.up), up)
}

fn positions(prepared: &PreparedScene) -> impl Iterator<Item = DVec3> {
    prepared
        .scene
        .lights
        .iter()
        .filter_map(|light| match *light {
            Light::Point { position, .. } => Some(position),
            Light::Directional { .. } => None,
        })
}
