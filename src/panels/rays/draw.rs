//! One view: objects, eye and picture plane, lights, rays.

use super::super::names;
use super::outline;
use super::view::View;
use crate::figure::{Arrow, Labels, cross};
use crate::language::Message;
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag};
use crate::replay::rays::{State, Target};
use crate::scene::Shape;
use glam::{DVec3, Vec2};

const EYE: Message = Message("common-eye");
const PLANE: Message = Message("rays-plane");
/// Beyond so many rays, those are drawn faintly, and without letters, from which the current ray does not come.
const MOST_RAYS: usize = 24;
/// Length of a unit vector that a question asks for, in points.
const ASKED: f32 = 56.0;
/// Where the picture plane is drawn, in distances from eye to target.
const PICTURE_PLANE: f64 = 0.16;

pub(super) struct Layout<'a> {
    pub picture: &'a mut Picture,
    pub input: &'a PanelInput<'a>,
    pub state: &'a State,
    pub view: &'a View,
    pub labels: Labels,
    pub text: f32,
    /// The object that the search has called by its name.
    called: Option<usize>,
    /// The rays from which the current ray comes, where there are many.
    pub way: Option<Vec<usize>>,
}

pub(super) fn draw(
    picture: &mut Picture,
    input: &PanelInput,
    state: &State,
    view: &View,
    strings: &str,
) {
    let frame = view.area;
    picture.rounded_rect(frame, 3.0, Ink::Rule.stroke(1.0));
    let mut labels = Labels::new(frame.grown(-3.0));
    let title_style = Style::Body.size(11.0).ink(Ink::Muted);
    let title_place = view.title_place(&state.prepared, title_style, strings);
    labels.reserve(title_place);
    let text = (0.03 * frame.width.min(1.3 * frame.height))
        .clamp(11.0, 16.0)
        .round();
    let mut layout = Layout {
        picture,
        input,
        state,
        view,
        labels,
        text,
        called: None,
        way: (state.rays.len() > MOST_RAYS).then(|| state.way().collect()),
    };
    layout.objects();
    layout.camera();
    layout.shadow_rays();
    layout.rays();
    layout.search();
    layout.lights();
    layout.asked();
    layout.names();
    picture.rect(title_place, Ink::Surface.fill().opacity(0.85));
    picture.text_in(title_place, strings, title_style);
}

impl Layout<'_> {
    fn objects(&mut self) {
        let prepared = &self.state.prepared;
        for object in 0..prepared.scene.objects.len() {
            if let Shape::Sphere { center, radius } = prepared.scene.objects[object].shape {
                let (at, radius) = (self.view.place(center), radius as f32 * self.view.scale());
                if self.view.shows(at, radius) {
                    self.picture
                        .circle(at, radius, Ink::Faint.fill().opacity(0.7));
                    self.labels.avoid_disc(at, radius);
                }
            }
            let outline = outline::outline(prepared, object, self.view);
            for &[from, to] in &outline {
                self.picture.line(from, to, Ink::Muted.stroke(1.25));
            }
            // The line of a plane strikes through a whole name.
            match outline[..] {
                [[from, to]] => self.labels.avoid_stroke(from, to, 3.0),
                _ => self.labels.avoid_outline(outline),
            }
        }
    }

    /// Whether rays drawn in full meet the object, where there are many.
    fn is_met(&self, object: usize) -> bool {
        let meets = |&ray: &usize| {
            let surface = self.state.rays.get(ray).and_then(|ray| ray.surface);
            surface.is_some_and(|surface| surface.object as usize == object)
        };
        self.way.as_ref().is_none_or(|way| way.iter().any(meets))
    }

    /// Names of objects last: rays and lights matter more.
    fn names(&mut self) {
        let prepared = &self.state.prepared;
        let style = Style::Label
            .size((self.text - 1.0).max(11.0))
            .ink(Ink::Muted);
        for (number, object) in prepared.scene.objects.iter().enumerate() {
            if self.called == Some(number) || !self.is_met(number) {
                continue;
            }
            let (at, toward) = match &object.shape {
                Shape::Sphere { center, radius } => {
                    let toward = Vec2::new(0.5, 1.0).normalize();
                    (
                        self.view.place(*center) + *radius as f32 * self.view.scale() * toward,
                        toward,
                    )
                }
                Shape::Plane { .. } => {
                    let lines = outline::outline(prepared, number, self.view);
                    let Some([from, to]) = lines.first() else {
                        continue;
                    };
                    (from.lerp(*to, 0.88), Vec2::Y)
                }
                _ => {
                    let mesh = &prepared.tessellation.meshes[number];
                    let count = mesh.vertex_count();
                    if count == 0 {
                        continue;
                    }
                    let places =
                        (0..count as u32).map(|vertex| self.view.place(mesh.position(vertex)));
                    let lowest = places.max_by(|a, b| a.y.total_cmp(&b.y));
                    (lowest.unwrap_or_default(), Vec2::Y)
                }
            };
            if self.view.shows(at, 4.0) {
                let name = prepared.scene.called(&object.name, self.input.language);
                self.labels
                    .put(self.picture, (at, 0.0), toward, name, style);
            }
        }
    }

    /// The eye, the picture plane with the pixel in it, and the borders of what the eye sees.
    fn camera(&mut self) {
        let prepared = &self.state.prepared;
        let (camera, scene) = (&prepared.view, &prepared.scene);
        let distance = scene
            .camera
            .map_or(1.0, |scene| scene.eye.distance(scene.target));
        let away = PICTURE_PLANE * distance;
        let middle = camera.eye + away * camera.forward;
        let size = away / camera.focal;
        let (width, height) = (f64::from(camera.width), f64::from(camera.height));
        let corner = |x: f64, y: f64| {
            middle + 0.5 * size * (x * width * camera.right + y * height * camera.up)
        };
        // Of the plane's four edges the two that are seen as ends.
        let [low, high] =
            if self.view.flat(camera.up).length() > self.view.flat(camera.right).length() {
                [corner(0.0, -1.0), corner(0.0, 1.0)]
            } else {
                [corner(-1.0, 0.0), corner(1.0, 0.0)]
            };
        for end in [low, high] {
            if let Some([from, to]) = self.view.line(camera.eye, end) {
                self.picture
                    .line(from, to, Ink::Muted.stroke(0.75).dotted());
                self.labels.avoid(from, to);
            }
        }
        if let Some([from, to]) = self.view.line(low, high) {
            self.picture.line(from, to, Ink::Text.stroke(2.5));
            self.labels.avoid(from, to);
        }
        let (eye, ends) = (
            self.view.place(camera.eye),
            [low, high].map(|end| self.view.place(end)),
        );
        if !self.view.shows(eye, 8.0) {
            return;
        }
        self.picture.circle(
            eye,
            5.0,
            Ink::Surface.fill().outlined(Ink::Text.stroke(2.0)),
        );
        self.picture.circle(eye, 2.0, Ink::Text);
        let language = self.input.language;
        let style = Style::Label.size(self.text);
        self.labels.reserve(Rect::between(eye, eye).grown(6.0));
        self.labels.put(
            self.picture,
            (eye, 5.0),
            Vec2::NEG_X,
            EYE.text(language),
            style,
        );
        let top = if ends[0].y < ends[1].y {
            ends[0]
        } else {
            ends[1]
        };
        if self.view.area.width >= 320.0 && self.view.shows(top, 4.0) {
            let style = Style::Label.size(11.0).ink(Ink::Muted);
            self.labels.put(
                self.picture,
                (top, 2.0),
                Vec2::NEG_Y,
                PLANE.text(language),
                style,
            );
        }
    }

    /// What the search has found so far: the object tested last, and the nearest.
    fn search(&mut self) {
        let (Some(search), Some(ray)) = (self.state.search, self.state.ray()) else {
            return;
        };
        for (tested, nearest) in [(search.tested, false), (search.nearest, true)] {
            let Some(tested) = tested.filter(|tested| tested.t.is_finite()) else {
                continue;
            };
            let at = self.view.place(ray.ray.at(tested.t));
            if !self.view.shows(at, 6.0) {
                continue;
            }
            let paint = if nearest { Ink::This } else { Ink::Surface }.fill();
            self.picture
                .circle(at, 4.5, paint.outlined(Ink::This.stroke(2.0)));
            if nearest {
                let name = match tested.target {
                    Target::Object(object) => {
                        self.called = Some(object as usize);
                        names::object(&self.state.prepared, object, self.input.language).to_string()
                    }
                    Target::Light(light) => names::light(light, self.input.language),
                };
                let style = Style::LabelBold.size(self.text).ink(Ink::This);
                self.labels
                    .put(self.picture, (at, 5.0), Vec2::new(0.3, 1.0), &name, style);
            }
        }
    }

    /// The arrow that a question asks for, where its view is not along it.
    fn asked(&mut self) {
        for arrow in self.input.answered.arrows() {
            let from = self.view.place(arrow.point);
            let along = self.view.flat(arrow.direction).as_vec2();
            if !self.view.shows(from, 4.0) || along.length() < 0.1 {
                continue;
            }
            let shown = Arrow {
                from,
                to: from + ASKED * Vec2::new(along.x, -along.y),
                stroke: arrow.ink.stroke(3.0),
                tag: Tag::Field(arrow.field),
                name: &arrow.name,
                size: self.text,
                here: false,
            };
            shown.draw(self.picture, &mut self.labels);
        }
    }

    /// From the current surface to the lights: clear, or crossed out where something blocks.
    fn shadow_rays(&mut self) {
        let Some(ray) = self.state.ray() else { return };
        let Some(surface) = ray.surface else { return };
        let start = surface.position;
        for verdict in &ray.shadows {
            let length = verdict.distance.min(self.view.beyond(verdict.direction));
            let end = start + length * verdict.direction;
            let blocker = verdict.by.map(|hit| start + hit.t * verdict.direction);
            let stroke = if verdict.blocked {
                Ink::Muted
            } else {
                Ink::Good
            }
            .stroke(1.5)
            .dashed();
            self.shadow_ray([start, end], stroke, Tag::Step(verdict.step));
            if let Some(blocker) = blocker {
                self.cross(blocker);
            }
        }
        if let Some(shadow) = &self.state.shadow {
            let length = shadow.distance.min(self.view.beyond(shadow.direction));
            let end = start + length * shadow.direction;
            self.shadow_ray(
                [start, end],
                Ink::This.stroke(2.0).dashed(),
                Tag::Scope(shadow.step),
            );
            if let Some((_, t, true)) = shadow.tested {
                self.cross(start + t * shadow.direction);
            }
        }
    }

    fn shadow_ray(&mut self, [start, end]: [DVec3; 2], stroke: Stroke, tag: Tag) {
        let Some([from, to]) = self.view.line(start, end) else {
            return;
        };
        self.picture.tagged(tag, |picture| {
            picture.line(from, to, stroke);
        });
        self.labels.avoid(from, to);
    }

    fn cross(&mut self, at: DVec3) {
        let at = self.view.place(at);
        if self.view.shows(at, 8.0) {
            cross(self.picture, at, 5.0, 2.5);
        }
    }
}
