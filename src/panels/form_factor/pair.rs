//! The two patches, and between them what was sampled so far.

use super::Layout;
use super::view::view;
use crate::figure::{Labels, Projection, cross, elided, within};
use crate::picture::{Ink, Paint, Picture, Rect, Stroke, Style, Tag};
use crate::record::Value;
use crate::replay::form_factor::{Segment, Way};
use glam::{DVec3, Vec2};

/// Segments that are drawn, the latest; the older one is, the fainter, so that what stands between the patches stays visible.
const SEGMENTS: usize = 120;
/// Up to so many points are drawn large.
const MOST_LARGE_POINTS: f32 = 200.0;
/// Of the oldest segment.
const FAINTEST: f32 = 0.05;
/// Outlines of the scene that are drawn around the two.
const MOST_POLYGONS: usize = 1500;
const TITLE: f32 = 18.0;
const TEXT: f32 = 12.0;

pub fn draw(picture: &mut Picture, layout: &Layout, area: Rect) {
    picture.rounded_rect(area, 3.0, Ink::Rule.stroke(1.0));
    let inner = Rect::between([area.x, area.y + TITLE], [area.right(), area.bottom()]).grown(-2.0);
    let (title, room) = (layout.title(), area.width - 12.0);
    let set = Style::Body.size(11.0).ink(Ink::Muted);
    let place = Rect::new(area.x + 6.0, area.y + 1.0, room, TITLE);
    elided(picture, place, &title, set);

    let camera = layout.prepared.scene.camera;
    let up = camera.map_or(layout.prepared.view.up, |camera| camera.up.normalize());
    let pair = Pair {
        layout,
        view: view(&layout.room.patches, [layout.i, layout.j], up, inner),
        area: inner,
    };
    let mut labels = Labels::new(inner.grown(-1.0));
    picture.clipped(inner, |picture| {
        pair.patch(picture, layout.i, Ink::This, Ink::ThisTint);
        pair.patch(picture, layout.j, Ink::Linked, Ink::LinkedTint);
        let newest = pair.segments(picture);
        pair.around(picture);
        if let Some(newest) = newest {
            pair.segment(picture, newest, None);
        }
        pair.open_ends(picture);
        pair.points(picture, &mut labels);
        pair.edges(picture);
        pair.letters(picture, &mut labels);
    });
}

struct Pair<'a> {
    layout: &'a Layout<'a>,
    view: Projection,
    area: Rect,
}

impl Pair<'_> {
    /// The part of a line that lies in the view.
    fn line(&self, picture: &mut Picture, from: Vec2, to: Vec2, stroke: Stroke) {
        if let Some([from, to]) = within([from, to], self.area.grown(-2.0))
            && from.is_finite()
            && to.is_finite()
        {
            picture.line(from, to, stroke);
        }
    }

    fn dot(&self, picture: &mut Picture, at: Vec2, radius: f32, paint: impl Into<Paint>) {
        if self.area.grown(-radius).contains(at) {
            picture.circle(at, radius, paint);
        }
    }

    /// The scene around the two, over old segments.
    fn around(&self, picture: &mut Picture) {
        let prepared = self.layout.prepared;
        for number in 0..prepared.tessellation.polygon_count().min(MOST_POLYGONS) {
            let Some(polygon) = prepared.polygon(number) else {
                continue;
            };
            let corners: Vec<Vec2> = polygon
                .corners()
                .map(|(vertex, _)| self.view.place(polygon.mesh.position(vertex)))
                .collect();
            for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
                self.line(picture, *from, *to, Ink::Muted.stroke(1.0));
            }
        }
    }

    fn patch(&self, picture: &mut Picture, patch: usize, ink: Ink, tint: Ink) {
        picture.tagged(Tag::Patch(patch), |picture| {
            for piece in self.layout.room.patches.pieces(patch) {
                let corners = piece.corners.iter().map(|&corner| self.view.place(corner));
                let paint = tint.fill().opacity(0.8).outlined(ink.stroke(1.75));
                picture.polygon(corners, paint);
            }
        });
    }

    /// Segments so far, and the newest of them where the step is about it, which is left to be drawn over what follows.
    fn segments(&self, picture: &mut Picture) -> Option<&Segment> {
        let segments = &self.layout.state.segments;
        let step = self.layout.input.run.walk().position();
        let count = segments.len();
        // What was recorded at an earlier step is no longer current where another part of the work has begun.
        let newest = segments.get(count.wrapping_sub(1));
        let newest = newest.filter(|segment| segment.step == step);
        let old = count - usize::from(newest.is_some());
        for at in old.saturating_sub(SEGMENTS)..old {
            if let Some(segment) = segments.get(at) {
                let age = (old - at) as f32 / SEGMENTS as f32;
                self.segment(picture, segment, Some(age));
            }
        }
        newest
    }

    fn open_ends(&self, picture: &mut Picture) {
        let step = self.layout.input.run.walk().position();
        if let Some([x, y]) = self.open(step) {
            let [from, to] = [x, y].map(|end| self.view.place(end));
            self.line(picture, from, to, Ink::This.stroke(1.5).dashed());
            self.dot(picture, from, 3.5, Ink::This);
            self.dot(picture, to, 3.5, Ink::This);
        }
    }

    /// The two points of the step, where it is a pair that has no term yet.
    fn open(&self, step: usize) -> Option<[DVec3; 2]> {
        let walk = self.layout.input.run.walk();
        let fields = walk.own_fields(step);
        match (walk.kind(step), fields.get("x"), fields.get("y")) {
            ("Points", Some(Value::Vector(x)), Some(Value::Vector(y))) => Some([x, y]),
            _ => None,
        }
    }

    /// In the accent, and with its ends; an old one by its age, from 0 to 1, faint.
    fn segment(&self, picture: &mut Picture, segment: &Segment, age: Option<f32>) {
        picture.tagged(Tag::Step(segment.step), |picture| {
            self.draw_segment(picture, segment, age);
        });
    }

    fn draw_segment(&self, picture: &mut Picture, segment: &Segment, age: Option<f32>) {
        let newest = age.is_none();
        let left = age.map_or(1.0, |age| (1.0 - age).powi(2).max(FAINTEST));
        let from = self.view.place(segment.from);
        let (to, reaches) = match segment.way {
            Way::To(to) => (to, true),
            Way::Sight { to, blocked } => (to, !blocked),
            Way::Ray { direction, met } => (self.end(segment.from, direction, met), met),
        };
        let to = self.view.place(to);
        let ink = if newest { Ink::This } else { Ink::Muted };
        let stroke = match (newest, reaches) {
            (true, _) => ink.stroke(2.25),
            (false, true) => ink.stroke(1.0).opacity(0.6 * left),
            (false, false) => ink.stroke(0.9).opacity(0.45 * left),
        };
        let is_ray = matches!(segment.way, Way::Ray { .. });
        let stroke = match (reaches, is_ray) {
            (true, _) => stroke,
            (false, true) => stroke.dotted(),
            (false, false) => stroke.dashed(),
        };
        self.line(picture, from, to, stroke);
        let radius = if newest { 3.5 } else { 1.75 };
        let paint = ink.fill().opacity(left);
        self.dot(picture, from, radius, paint);
        match (reaches, is_ray) {
            (true, _) => self.dot(picture, to, radius, paint),
            (false, false) if newest || left > 0.5 => {
                self.barred(picture, 0.5 * (from + to), newest);
            }
            (false, false) => {}
            (false, true) => {}
        }
    }

    /// A cross on a line of sight that something blocks.
    fn barred(&self, picture: &mut Picture, at: Vec2, newest: bool) {
        let (reach, width) = if newest { (5.0, 2.25) } else { (2.5, 1.0) };
        if self.area.grown(-reach - 2.0).contains(at) {
            cross(picture, at, reach, width);
        }
    }

    /// Where a ray ends: on j, or after a fifth of the way there.
    fn end(&self, from: DVec3, direction: DVec3, met: bool) -> DVec3 {
        let patches = &self.layout.room.patches;
        let (i, j) = (&patches[self.layout.i], &patches[self.layout.j]);
        let t = j.normal.dot(j.center - from) / j.normal.dot(direction);
        if met && t.is_finite() && t > 0.0 {
            from + t * direction
        } else {
            from + 0.2 * (i.center.distance(j.center) + i.radius) * direction
        }
    }

    /// Points of elements and hemicubes, and what the newest sees of the current edge of the polygon.
    fn points(&self, picture: &mut Picture, labels: &mut Labels) {
        let state = self.layout.state;
        let last = state.points.len();
        // So that the patch is not hidden by the thousands that a pair with something in between takes.
        let crowded = (MOST_LARGE_POINTS / last.max(1) as f32)
            .sqrt()
            .clamp(0.3, 1.0);
        for (&(point, step), number) in state.points.iter().zip(1..) {
            let newest = number == last && state.found.is_none();
            let at = self.view.place(point);
            if let (true, Some((edge, edge_step))) = (newest, state.edge) {
                picture.tagged(Tag::Step(edge_step), |picture| {
                    self.edge_seen(picture, point, edge, labels);
                });
            }
            picture.tagged(Tag::Step(step), |picture| {
                let (radius, ink) = if newest {
                    (4.0, Ink::This)
                } else {
                    (2.25 * crowded, Ink::Muted)
                };
                self.dot(picture, at, radius, ink);
            });
        }
    }

    /// The triangle of the point with an edge of the polygon that it sees.
    fn edge_seen(
        &self,
        picture: &mut Picture,
        point: DVec3,
        [from, to]: [DVec3; 2],
        labels: &mut Labels,
    ) {
        let [x, r, next] = [point, from, to].map(|end| self.view.place(end));
        let paint = Ink::This.fill().opacity(0.18);
        if [x, r, next].iter().all(|&at| self.area.contains(at)) {
            picture.polygon([x, r, next], paint);
        }
        self.line(picture, x, next, Ink::This.stroke(1.25).dashed());
        self.line(picture, r, next, Ink::This.stroke(3.0));
        labels.avoid(x, next);
        labels.avoid(r, next);
        self.line(picture, x, r, Ink::This.stroke(1.75));
        labels.avoid(x, r);
        self.dot(picture, r, 3.5, Ink::This);
        let set = Style::LabelBold.size(TEXT).ink(Ink::This);
        labels.put(picture, (r, 4.0), r - x, "R_k", set);
    }

    /// The current pair of edges of the double contour integral, where neither patch was clipped.
    fn edges(&self, picture: &mut Picture) {
        let walk = self.layout.input.run.walk();
        let step = walk.position();
        if walk.kind(step) != "EdgePair" {
            return;
        }
        let fields = walk.fields(step);
        let number = |name: &str| match fields.get(name) {
            Some(Value::Integer(number)) => usize::try_from(number).ok(),
            _ => None,
        };
        let area = |name: &str| match fields.get(name) {
            Some(Value::Number(area)) => area,
            _ => f64::NAN,
        };
        let (area_i, area_j) = (area("area_i"), area("area_j"));
        // The automatic choice takes the smaller patch first.
        let swapped = self.layout.state.chosen.is_some() && area_j < area_i;
        let (first, second) = if swapped {
            ("edge_j", "edge_i")
        } else {
            ("edge_i", "edge_j")
        };
        for (patch, area, edge) in [
            (self.layout.i, area_i, first),
            (self.layout.j, area_j, second),
        ] {
            let mut pieces = self.layout.room.patches.pieces(patch);
            let (Some(piece), None, Some(edge)) = (pieces.next(), pieces.next(), number(edge))
            else {
                continue;
            };
            if (piece.area - area).abs() > 1e-9 * piece.area || edge >= piece.corners.len() {
                continue;
            }
            let [from, to] = [edge, (edge + 1) % piece.corners.len()]
                .map(|corner| self.view.place(piece.corners[corner]));
            if let Some([from, to]) = within([from, to], self.area.grown(-3.0)) {
                picture.tagged(Tag::Step(step), |picture| {
                    picture.arrow(from, to, Ink::This.stroke(3.0));
                });
            }
        }
    }

    /// i and j, beside the corners that are farthest out.
    fn letters(&self, picture: &mut Picture, labels: &mut Labels) {
        let center = |patch: usize| self.view.place(self.layout.room.patches[patch].center);
        let (i, j) = (self.layout.i, self.layout.j);
        let apart = center(i) - center(j);
        for (patch, letter, ink, toward) in
            [(i, "i", Ink::This, apart), (j, "j", Ink::Linked, -apart)]
        {
            let pieces = self.layout.room.patches.pieces(patch);
            let corners = pieces.flat_map(|piece| piece.corners.iter().copied());
            let outmost = corners
                .map(|corner| self.view.place(corner))
                .max_by(|a, b| a.dot(toward).total_cmp(&b.dot(toward)));
            if let Some(at) = outmost {
                let set = Style::Formula.size(15.0).ink(ink);
                labels.put(picture, (at, 1.0), toward, letter, set);
            }
        }
    }
}
