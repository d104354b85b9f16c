//! The drawing: the surface, the media, the vectors and the arcs of their angles.

use super::asked;
use super::met::SurfaceInSight;
use super::plane::Plane;
use crate::algorithms::ray_tree::RayKind;
use crate::figure::{Arrow, Labels, cross};
use crate::language::{Language, Message};
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag};
use crate::replay::rays::{CurrentBranch, Outcome};
use glam::{DVec3, Vec2};

const NO_T: Message = Message("vectors-no-t");
const POINT: f32 = 4.0;
/// Of V, which lies beside u, as a share of it.
pub(super) const V_LENGTH: f32 = 0.62;

struct Drawing<'a> {
    picture: &'a mut Picture,
    labels: Labels,
    plane: Plane,
    text: f32,
}

/// What an arrow is called, whether this step records it, and what it shows.
struct Named<'a> {
    name: &'a str,
    here: bool,
    tag: Tag,
}

/// The part of the height that lies above the surface. Where nothing passes, what lies below needs less room.
fn share(clear: bool) -> f32 {
    if clear { 0.5 } else { 0.78 }
}

/// Length of the arrows in `area`, with labels of size `text` at their tips, at a transparent or an opaque surface.
pub(super) fn unit(area: Rect, text: f32, clear: bool) -> f32 {
    // Media with their η stand beside the arrows.
    let aside = if clear { 2.4 } else { 1.4 };
    let room = Vec2::new(
        0.5 * area.width - aside * text,
        share(clear) * area.height - 1.4 * text,
    );
    room.min_element().max(12.0)
}

/// The plane of incidence as it lies in `area`.
pub(super) fn plane(surface: &SurfaceInSight, text: f32, area: Rect) -> Plane {
    let clear = surface.is_transparent();
    let middle = Vec2::new(area.center().x, area.y + share(clear) * area.height);
    Plane {
        vectors: surface.plane,
        middle,
        unit: unit(area, text, clear),
    }
}

pub(super) fn draw(
    picture: &mut Picture,
    surface: &SurfaceInSight,
    input: &PanelInput,
    text: f32,
    area: Rect,
) {
    let language = input.language;
    let kind = input.run.walk().kind(input.run.walk().position());
    let plane = plane(surface, text, area);
    let middle = plane.middle;
    let below = Rect::new(area.x, middle.y, area.width, area.bottom() - middle.y);
    picture.rect(below, Ink::Faint.fill().opacity(0.6));
    picture.line(
        (area.x, middle.y),
        (area.right(), middle.y),
        Ink::Text.stroke(1.5),
    );
    let mut drawing = Drawing {
        picture,
        labels: Labels::new(area),
        plane,
        text,
    };
    let left = Vec2::new(area.x, middle.y);
    drawing
        .labels
        .avoid(left, Vec2::new(area.right(), middle.y));
    drawing
        .labels
        .reserve(Rect::between(middle, middle).grown(POINT));

    drawing.rays(surface, kind, language);
    drawing.lights(surface, kind);
    drawing.arcs(surface);
    asked::draw(
        &input.answered,
        &plane,
        text,
        drawing.picture,
        &mut drawing.labels,
    );
    drawing.media(surface.media(language), area);
    let disc = Ink::Surface.fill().outlined(Ink::Text.stroke(2.0));
    drawing.picture.circle(middle, POINT, disc);
}

impl Drawing<'_> {
    /// u, N, and the rays that the surface sends on.
    fn rays(&mut self, surface: &SurfaceInSight, kind: &str, language: Language) {
        let u = surface.project(surface.ray.ray.direction);
        let incoming = kind == "Ray"
            && surface
                .state
                .ray()
                .is_some_and(|ray| ray.step == surface.ray.step);
        self.picture
            .tagged(Tag::Scope(surface.ray.step), |picture| {
                let stroke = if incoming { Ink::This } else { Ink::Linked }.stroke(3.0);
                let tip = self.plane.middle - POINT * u;
                picture.arrow(self.plane.middle - self.plane.unit * u, tip, stroke);
            });
        let start = self.plane.middle - self.plane.unit * u;
        self.labels
            .avoid_arrow(start, self.plane.middle - POINT * u, 3.0);
        let normal = match surface.surface.facing {
            Some((normal, ..)) => ("N", normal, kind == "Faced"),
            None => ("N_g", surface.surface.geometric, kind == "SurfaceMet"),
        };
        let (name, direction, here) = normal;
        let named = Named {
            name,
            here,
            tag: Tag::Field("N"),
        };
        let direction = surface.project(direction);
        self.arrow(direction, Ink::Text.stroke(3.5), &named);
        let style = self.style(incoming);
        self.labels.put(self.picture, (start, 3.0), -u, "u", style);

        for branch in surface.ray.branches.iter().flatten() {
            self.branch(surface, branch, kind);
        }
        let blocked = surface
            .ray
            .refraction
            .filter(|refraction| refraction.radicand < 0.0);
        if let Some(refraction) = blocked {
            let end = self.plane.middle + 0.75 * self.plane.unit * u;
            self.picture.tagged(Tag::Step(refraction.step), |picture| {
                picture.line(self.plane.middle, end, Ink::Muted.stroke(2.5).dashed());
            });
            self.labels.avoid(self.plane.middle, end);
            let style = self.style(kind == "Refraction");
            let name = NO_T.text(language);
            self.labels.put(self.picture, (end, 3.0), u, name, style);
        }
    }

    fn branch(&mut self, surface: &SurfaceInSight, branch: &CurrentBranch, kind: &str) {
        let Some(sent) = branch.branch else { return };
        let (name, stroke, recorded_by) = match branch.kind {
            RayKind::Primary | RayKind::Reflected => {
                ("R", Ink::Series(0).stroke(3.0), "Reflection")
            }
            RayKind::Transmitted => ("T", Ink::Series(2).stroke(3.0), "Transmission"),
            RayKind::TotalInternalReflection => (
                "TIR",
                Ink::Series(3).stroke(3.0).dashed(),
                "TotalInternalReflection",
            ),
        };
        // The branch goes on as a ray of its own, once it is traced.
        let (tag, current) = match branch.outcome {
            Outcome::Ray(ray) => {
                let step = surface
                    .state
                    .rays
                    .get(ray)
                    .map_or(branch.step, |ray| ray.step);
                (Tag::Scope(step), surface.state.current == Some(ray))
            }
            Outcome::Open | Outcome::Ended(_) => (Tag::Step(branch.step), false),
        };
        let here = kind == recorded_by || current;
        self.arrow(
            surface.project(sent.direction),
            stroke,
            &Named { name, here, tag },
        );
    }

    /// L of each light, and V, H and R of the current light.
    fn lights(&mut self, surface: &SurfaceInSight, kind: &str) {
        let Some(lit) = surface.lit() else { return };
        let current = surface.current_light();
        for light in &lit.lights {
            let Some((to_light, _)) = light.to_light else {
                continue;
            };
            let newest = current.is_some_and(|last| last.light == light.light);
            let here =
                newest && matches!(kind, "ToLight" | "ShadowRay" | "Shadow" | "BetweenTested");
            let name = format!("L_{}", light.light);
            let stroke = Ink::Series(1).stroke(if newest { 3.0 } else { 2.0 });
            let named = Named {
                name: &name,
                here,
                tag: Tag::Light(light.light as usize),
            };
            let tip = self.arrow(surface.project(to_light), stroke, &named);
            if surface
                .verdict(light.light)
                .is_some_and(|verdict| verdict.blocked)
            {
                let half = self.plane.middle.lerp(tip, 0.55);
                cross(self.picture, half, 5.0, 2.5);
            }
        }
        if lit.intensity.is_some() {
            return;
        }
        let halfway = current.and_then(|light| light.halfway);
        let mirrored = current.and_then(|light| light.mirrored);
        let vectors: [(&str, Option<DVec3>, &str, Ink); 3] = [
            ("V", lit.to_eye, "Viewer", Ink::Series(4)),
            ("H", halfway.map(|(v, _)| v), "Halfway", Ink::Series(2)),
            ("R_L", mirrored.map(|(v, _)| v), "Mirrored", Ink::Series(3)),
        ];
        for (name, vector, recorded_by, ink) in vectors {
            let Some(vector) = vector else { continue };
            let here = kind == recorded_by;
            let field = match name {
                "V" => "V",
                "H" => "H",
                _ => "R",
            };
            let along = surface.project(vector);
            // V lies on the line of u: it is drawn beside it, and shorter.
            let (aside, length) = if name == "V" {
                (5.0 * along.perp(), V_LENGTH)
            } else {
                (Vec2::ZERO, 0.9)
            };
            self.arrow_from(
                aside,
                length * along,
                ink.stroke(2.0),
                &Named {
                    name,
                    here,
                    tag: Tag::Field(field),
                },
            );
        }
    }

    /// θ_i, θ_r and the critical angle.
    fn arcs(&mut self, surface: &SurfaceInSight) {
        let Some((normal, cos_theta_i, _)) = surface.surface.facing else {
            return;
        };
        let (up, u) = (
            surface.project(normal),
            surface.project(surface.ray.ray.direction),
        );
        let theta_i = cos_theta_i.min(1.0).acos() as f32;
        // From N toward where the ray comes from.
        let turn = up.perp_dot(-u).signum();
        self.arc(up, turn * theta_i, 0.45, "θ_i");
        let Some(refraction) = surface.ray.refraction else {
            return;
        };
        if let Some(theta_r) = refraction.theta_r() {
            self.arc(-up, turn * theta_r as f32, 0.45, "θ_r");
        }
        if let Some(critical) = refraction.critical_angle() {
            let toward = Vec2::from_angle(turn * critical as f32).rotate(up);
            let end = self.plane.middle + 0.8 * self.plane.unit * toward;
            self.picture
                .line(self.plane.middle, end, Ink::Muted.stroke(1.25).dotted());
            self.labels.avoid(self.plane.middle, end);
            let style = Style::Label.size(self.text).ink(Ink::Muted);
            self.labels
                .put(self.picture, (end, 2.0), toward, "θ_c", style);
        }
    }

    fn arc(&mut self, from: Vec2, angle: f32, radius: f32, name: &str) {
        const PARTS: usize = 24;
        if angle.abs() < 0.02 {
            return;
        }
        let radius = radius * self.plane.unit;
        let point =
            |part: f32| self.plane.middle + radius * Vec2::from_angle(part * angle).rotate(from);
        let points = (0..=PARTS).map(|i| point(i as f32 / PARTS as f32));
        self.picture.polyline(points, Ink::Muted.stroke(1.5));
        let style = Style::Label.size(self.text);
        let middle = point(0.5);
        let toward = middle - self.plane.middle;
        self.labels
            .put(self.picture, (middle, 1.0), toward, name, style);
    }

    fn media(&mut self, [above, below]: [String; 2], area: Rect) {
        for (name, up) in [(above, true), (below, false)] {
            // On its own side of the surface, rather where it covers no arrow; smaller where there is little room.
            let sizes = [(self.text - 1.0).max(11.0), 11.0];
            let tries = sizes.map(|size| [false, true].map(|crossing| (size, crossing)));
            for (size, crossing) in tries.into_iter().flatten() {
                if self.medium(&name, up, size, crossing, area) {
                    break;
                }
            }
        }
    }

    /// Writes the name of a medium in one of its places, if one is free.
    fn medium(&mut self, name: &str, up: bool, size: f32, crossing: bool, area: Rect) -> bool {
        let style = Style::Label.size(size).ink(Ink::Muted);
        let height = style.bounds(Vec2::ZERO, "").height;
        let (first, step) = if up {
            (-3.0 - height, -height)
        } else {
            (3.0, height)
        };
        let ends = [area.x + 3.0, area.right() - 3.0 - style.width(name)];
        let mut places = (0..4).flat_map(|row| {
            let y = self.plane.middle.y + first + row as f32 * step;
            ends.map(|x| Vec2::new(x, y))
        });
        places.any(|at| self.labels.put_at(self.picture, at, name, style, crossing))
    }

    fn style(&self, here: bool) -> crate::picture::Text {
        let ink = if here { Ink::This } else { Ink::Text };
        Style::LabelBold.size(self.text).ink(ink)
    }

    fn arrow(&mut self, along: Vec2, stroke: Stroke, named: &Named) -> Vec2 {
        self.arrow_from(Vec2::ZERO, along, stroke, named)
    }

    /// From the point, moved aside, along a vector; returns the tip.
    fn arrow_from(&mut self, aside: Vec2, along: Vec2, stroke: Stroke, named: &Named) -> Vec2 {
        let start = self.plane.middle + aside;
        let below = self.labels.area().bottom() - self.plane.middle.y - 1.4 * self.text;
        let tip = self.plane.tip(along, below) + aside;
        let arrow = Arrow {
            from: start,
            to: tip,
            stroke,
            tag: named.tag,
            name: named.name,
            size: self.text,
            here: named.here,
        };
        arrow.draw(self.picture, &mut self.labels);
        tip
    }
}
