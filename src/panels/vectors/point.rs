//! The vectors of the illumination model at a point of a polygon, in the plane of N and V: N is up, V leans to the right.

use super::asked;
use super::plane::{Plane, Tip};
use crate::figure::{Arrow, Labels};
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::VectorPlane;
use crate::replay::shading::CurrentPoint;
use crate::scene::Movable;
use glam::{DVec3, Vec2};

const POINT: f32 = 4.0;
const LINE: f32 = 1.5;

/// A vector as it is drawn and listed.
pub struct Named {
    pub name: String,
    pub vector: DVec3,
    pub recorded_by: &'static str,
    pub ink: Ink,
    pub tag: Tag,
    /// What holds it up, if it can be dragged.
    held: Option<(Movable, f64)>,
}

/// The vectors recorded so far: N and V, L of each light, R or H of the current light.
pub fn vectors(point: &CurrentPoint, eye: DVec3) -> Vec<Named> {
    let field = |name: &'static str, vector, recorded_by, ink| Named {
        name: name.to_owned(),
        vector,
        recorded_by,
        ink,
        tag: Tag::Field(name),
        held: None,
    };
    let mut vectors = vec![field("N", point.normal, "Illumination", Ink::Text)];
    if let Some(to_eye) = point.to_eye {
        vectors.push(Named {
            held: Some((Movable::Eye, eye.distance(point.position))),
            ..field("V", to_eye, "Viewer", Ink::Series(4))
        });
    }
    for light in &point.lights {
        let Some((to_light, _)) = light.to_light else {
            continue;
        };
        let number = light.light as usize;
        let near = light.distance.is_finite();
        vectors.push(Named {
            name: format!("L_{number}"),
            tag: Tag::Light(number),
            held: near.then_some((Movable::Light(number), light.distance)),
            ..field("L", to_light, "ToLight", Ink::Series(1))
        });
    }
    if let Some(light) = point.lights.last() {
        let halfway = light.halfway.map(|(halfway, _)| halfway);
        vectors.extend(halfway.map(|halfway| field("H", halfway, "Halfway", Ink::Series(2))));
        let mirrored = light.mirrored.map(|(mirrored, _)| mirrored);
        vectors.extend(mirrored.map(|mirrored| field("R", mirrored, "Mirrored", Ink::Series(3))));
    }
    vectors
}

fn text(size: Vec2) -> f32 {
    (0.036 * size.x.min(1.4 * size.y)).clamp(11.0, 16.0).round()
}

/// The plane of N and V at the point, and where in the panel it lies: what is left of the list.
pub(super) fn plane(point: &CurrentPoint, eye: DVec3, size: Vec2) -> Plane {
    let text = text(size);
    let (drawing, _) = areas(size);
    let to_eye = (eye - point.position).normalize_or_zero();
    let middle = Vec2::new(drawing.center().x, drawing.y + 0.8 * drawing.height);
    let room = Vec2::new(0.5 * drawing.width, 0.8 * drawing.height) - 1.8 * text;
    Plane {
        vectors: VectorPlane::new(point.position, point.normal, to_eye),
        middle,
        unit: room.min_element().max(12.0),
    }
}

/// What the pointer can take hold of.
pub(super) fn tips(point: &CurrentPoint, eye: DVec3) -> Vec<Tip> {
    let tips = vectors(point, eye).into_iter().filter_map(|named| {
        let (held, distance) = named.held?;
        Some(Tip {
            held,
            distance,
            direction: named.vector,
            length: 1.0,
        })
    });
    tips.collect()
}

fn areas(size: Vec2) -> (Rect, Rect) {
    let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-6.0);
    let width = (13.0 * text(size)).min(0.45 * whole.width);
    let drawing = Rect {
        width: whole.width - width - 8.0,
        ..whole
    };
    let list = Rect::new(drawing.right() + 8.0, whole.y, width, whole.height);
    (drawing, list)
}

/// Draws the vectors, and lists their angles with N; returns the list in words.
pub(super) fn draw(
    picture: &mut Picture,
    point: &CurrentPoint,
    eye: DVec3,
    input: &PanelInput,
    size: Vec2,
) -> String {
    let language = input.language;
    let kind = input.run.walk().kind(input.run.walk().position());
    let text = text(size);
    let plane = plane(point, eye, size);
    let (drawing, list) = areas(size);
    let middle = plane.middle;
    let ground = Rect::between((drawing.x, middle.y), (drawing.right(), drawing.bottom()));
    picture.rect(ground, Ink::Faint.fill().opacity(0.6));
    let surface = [
        Vec2::new(drawing.x, middle.y),
        Vec2::new(drawing.right(), middle.y),
    ];
    picture.line(surface[0], surface[1], Ink::Text.stroke(1.5));
    let mut labels = Labels::new(drawing);
    labels.avoid(surface[0], surface[1]);
    labels.reserve(Rect::between(middle, middle).grown(POINT));
    let vectors = vectors(point, eye);
    let below = ground.height - 1.4 * text;
    for named in &vectors {
        let arrow = Arrow {
            from: middle,
            to: plane.tip(plane.project(named.vector), below),
            stroke: named.ink.stroke(3.0),
            tag: named.tag,
            name: &named.name,
            size: 1.2 * text,
            here: named.recorded_by == kind,
        };
        arrow.draw(picture, &mut labels);
    }
    asked::draw(&input.answered, &plane, 1.2 * text, picture, &mut labels);
    let disc = Ink::Surface.fill().outlined(Ink::Text.stroke(2.0));
    picture.circle(middle, POINT, disc);

    let mut strings = Vec::new();
    let fitting = (list.height / (LINE * text)) as usize;
    for (i, named) in vectors.iter().skip(1).enumerate() {
        let cosine = point.normal.dot(named.vector).clamp(-1.0, 1.0);
        let angle = format!("{}°", language.short(cosine.acos().to_degrees(), 1));
        strings.push(format!("{} {angle}", named.name));
        if i >= fitting {
            continue;
        }
        let row = Rect::new(
            list.x,
            list.y + i as f32 * LINE * text,
            list.width,
            LINE * text,
        );
        let ink = if named.recorded_by == kind {
            Ink::This
        } else {
            Ink::Text
        };
        picture.tagged(named.tag, |picture| {
            let name = Style::LabelBold.size(text).ink(Ink::Muted);
            picture.text_in(row, format!("∠ N {}", named.name), name);
            let number = Style::Label.size(text).ink(ink).end();
            picture.text_in(row, angle, number);
        });
    }
    strings.join("; ")
}
