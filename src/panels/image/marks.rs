//! What the step works on, drawn over the picture. Nothing here has a tag: under the pointer are the picture's pixels.

use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::figure::Fit;
use crate::picture::{Ink, Picture, Rect};
use crate::replay::rays::{self, RayState};
use crate::replay::shading;
use crate::replay::wireframe;
use glam::{DVec2, Vec2};
use std::ops::Range;

/// The side below which a marked pixel is drawn larger than it is, in points.
const SMALLEST: f32 = 6.0;

/// Of more rays, only those are marked from which the current ray comes: more would cover the picture.
const MOST_HITS: usize = 24;

pub(super) struct Marks<'a> {
    pub prepared: &'a PreparedScene,
    outline: Vec<DVec2>,
    /// Where the current vertex is.
    vertex: Option<DVec2>,
    /// The current edge of the wireframe.
    edge: Option<[DVec2; 2]>,
    span: Option<Range<u32>>,
    pub polygon: Option<u32>,
    pub row: Option<u32>,
    pub pixel: Option<(u32, u32)>,
    /// Where the rays of the pixel met surfaces so far, the current one last.
    hits: Vec<DVec2>,
}

impl<'a> Marks<'a> {
    pub fn of_shading(state: &'a shading::State) -> Self {
        let prepared = &*state.prepared;
        let current = state.vertex.as_ref().map(|vertex| vertex.position);
        // The point of a pixel is marked by the pixel.
        let point = state.point.as_ref().filter(|_| state.pixel.is_none());
        let current = current.or(point.map(|point| point.position));
        Marks {
            prepared,
            outline: outline(state),
            vertex: current
                .map(|position| prepared.view.to_camera(position))
                .filter(|camera| camera.z >= prepared.view.near)
                .map(|camera| prepared.view.to_screen(camera)),
            edge: None,
            span: state.span.as_ref().map(|span| span.first..span.end),
            polygon: state.polygon.map(|polygon| polygon.polygon),
            row: state.scan_line.map(|row| row.y),
            pixel: state.pixel.as_ref().map(|pixel| (pixel.x, pixel.y)),
            hits: Vec::new(),
        }
    }

    pub fn of_wireframe(state: &'a wireframe::State) -> Self {
        Marks {
            prepared: &state.prepared,
            outline: Vec::new(),
            vertex: None,
            edge: state.line,
            span: None,
            polygon: None,
            row: None,
            pixel: state.pixel.map(|(x, y, _)| (x, y)),
            hits: Vec::new(),
        }
    }

    pub fn of_rays(state: &'a rays::State) -> Self {
        let seen = |ray: &RayState| {
            let camera = state.prepared.view.to_camera(ray.surface?.position);
            (camera.z >= state.prepared.view.near).then(|| state.prepared.view.to_screen(camera))
        };
        // The first ray meets its surface in the pixel itself.
        let secondary = state.rays.iter().skip(1).enumerate();
        let way: Vec<usize> = state.way().collect();
        let many = state.rays.len() > MOST_HITS;
        let is_shown = |index: usize| !many || way.contains(&index);
        let others = secondary.filter(|(i, _)| state.current != Some(i + 1) && is_shown(i + 1));
        let current = state.ray().filter(|ray| ray.parent.is_some());
        Marks {
            prepared: &state.prepared,
            outline: Vec::new(),
            vertex: current.and_then(seen),
            edge: None,
            span: None,
            polygon: None,
            row: None,
            pixel: state.pixel,
            hits: others.filter_map(|(_, ray)| seen(ray)).collect(),
        }
    }

    pub fn draw(&self, picture: &mut Picture, focus: Focus, fit: &Fit) {
        self.draw_focus(picture, focus, fit);
        if let Some(y) = self.row {
            let width = self.prepared.view.width;
            let band = at_least(fit.pixels(0, width, y), 2.0);
            // The pixels of the span keep their colours.
            let free = match &self.span {
                Some(span) => [0..span.start, span.end..width],
                None => [0..width, width..width],
            };
            for part in free {
                let part = at_least(fit.pixels(part.start, part.end, y), 2.0);
                picture.rect(part, Ink::This.fill().opacity(0.3));
            }
            if fit.scale >= 4.0 {
                picture.rect(band, Ink::This.stroke(1.0));
            }
        }
        let points = self.outline.iter().map(|&corner| fit.place(corner));
        if !self.outline.is_empty() {
            picture.polygon(points, Ink::Linked.stroke(2.0));
        }
        if let (Some(y), Some(span)) = (self.row, &self.span) {
            let span = fit.pixels(span.start, span.end, y);
            picture.rect(at_least(span, 3.0), Ink::This.stroke(1.5));
        }
        if let Some([start, end]) = self.edge {
            picture.line(fit.place(start), fit.place(end), Ink::This.stroke(2.0));
        }
        for &hit in &self.hits {
            let paint = Ink::Surface.fill().outlined(Ink::Linked.stroke(1.5));
            picture.circle(fit.place(hit), 3.5, paint);
        }
        if let Some(vertex) = self.vertex {
            let paint = Ink::Surface.fill().outlined(Ink::This.stroke(2.5));
            picture.circle(fit.place(vertex), 5.0, paint);
        }
        if let Some((x, y)) = self.pixel {
            let square = at_least(fit.pixels(x, x + 1, y), SMALLEST);
            if matches!(focus, Focus::Pixel { .. }) {
                cross_hair(
                    picture,
                    square,
                    fit.pixels(0, self.prepared.view.width, 0).width,
                );
            }
            picture.rect(square.grown(1.0), Ink::Surface.stroke(1.0));
            picture.rect(square, Ink::This.stroke(2.0));
        }
    }

    /// What the run recorded, where the whole picture was not.
    fn draw_focus(&self, picture: &mut Picture, focus: Focus, fit: &Fit) {
        let stroke = Ink::Linked.stroke(1.5).dotted();
        match focus {
            Focus::Frame
            | Focus::Iterations { .. }
            | Focus::Patch(_)
            | Focus::FormFactor { .. } => {}
            Focus::Polygon(number) => {
                let corners = on_screen(self.prepared, number);
                picture.polygon(corners.into_iter().map(|corner| fit.place(corner)), stroke);
            }
            Focus::ScanLine(y) => {
                let row = fit.pixels(0, self.prepared.view.width, y);
                picture.rect(at_least(row, SMALLEST), stroke);
            }
            Focus::Pixel { x, y } => {
                let square = fit.pixels(x, x.saturating_add(1), y);
                picture.rect(at_least(square, SMALLEST + 4.0), stroke);
            }
        }
    }
}

/// Four arms around a pixel, which can be found on any ground, in a picture `width` points wide.
fn cross_hair(picture: &mut Picture, pixel: Rect, width: f32) {
    let (middle, arm) = (pixel.center(), (0.06 * width).clamp(14.0, 48.0));
    for toward in [Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y] {
        let start = middle + (0.5 * pixel.width + 3.0) * toward;
        let end = start + arm * toward;
        picture.line(start - toward, end + toward, Ink::Surface.stroke(4.0));
        picture.line(start, end, Ink::This.stroke(2.0));
    }
}

/// The rectangle, grown about its centre where a side is shorter than `side`.
fn at_least(rect: Rect, side: f32) -> Rect {
    let (width, height) = (rect.width.max(side), rect.height.max(side));
    let center = rect.center();
    Rect::new(
        center.x - 0.5 * width,
        center.y - 0.5 * height,
        width,
        height,
    )
}

/// The corners of the current polygon on the screen: as they were recorded, and before that as the scene has them.
fn outline(state: &shading::State) -> Vec<DVec2> {
    if !state.edges.is_empty() {
        let corners = state.corners.iter();
        return corners
            .map(|corner| DVec2::new(corner.x, corner.y))
            .collect();
    }
    state.polygon.map_or_else(Vec::new, |polygon| {
        on_screen(&state.prepared, polygon.polygon as usize)
    })
}

/// The corners of a polygon of the scene, on the screen; those before the near plane have no place there.
fn on_screen(prepared: &PreparedScene, polygon: usize) -> Vec<DVec2> {
    prepared.polygon(polygon).map_or_else(Vec::new, |polygon| {
        let corners = polygon.corners().map(|(_, vertex)| vertex);
        corners
            .filter(|vertex| vertex.camera.z >= prepared.view.near)
            .map(|vertex| vertex.screen)
            .collect()
    })
}
