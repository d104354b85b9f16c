//! What rays need of a scene, read once, and what can be left out without changing a bit of the picture: each with its place in
//! the scene and the reason.

use super::{Light, Material, Object, Scene, Shape};
use crate::color::Rgb;
use glam::DVec3;

/// What ray tracing has to do in a scene. What is false is left out, and the picture stays the same, bit for bit.
#[derive(Clone, Debug, PartialEq)]
pub struct Needs {
    /// Some surface reflects: mirrored rays.
    pub reflection: bool,
    /// Some surface transmits: refracted rays, and the media that they are in.
    pub transmission: bool,
    /// Some surface has a texture: (u, v) at the hit.
    pub textures: bool,
    /// Some surface has a highlight: a cosine raised to the shininess.
    pub specular: bool,
    /// Some light is a ball that rays see.
    pub light_balls: bool,
    /// Secondary rays lose light on their way.
    pub path_attenuation: bool,
    /// By light, then by object: whether anything may stand between a lit point of the object and the light.
    shadows: Vec<Vec<bool>>,
    pub left_out: Vec<LeftOut>,
}

/// Something that is not done for a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    pub part: Part,
    /// Where in the scene file the reason stands: `materials`, `lights[1]`.
    pub place: String,
    /// How many of how many it concerns, where it does not concern all: shadow rays of so many objects.
    pub share: Option<[usize; 2]>,
}

/// A part of the work that a scene may not need.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    ReflectedRays,
    TransmittedRays,
    TextureCoordinates,
    Highlights,
    LightBalls,
    PathAttenuation,
    ShadowRays,
}

impl Part {
    pub const ALL: [Part; 7] = [
        Part::ReflectedRays,
        Part::TransmittedRays,
        Part::TextureCoordinates,
        Part::Highlights,
        Part::LightBalls,
        Part::PathAttenuation,
        Part::ShadowRays,
    ];

    /// As in the results of `needs` and `render --stats`.
    pub fn name(self) -> &'static str {
        match self {
            Part::ReflectedRays => "reflected_rays",
            Part::TransmittedRays => "transmitted_rays",
            Part::TextureCoordinates => "texture_coordinates",
            Part::Highlights => "highlights",
            Part::LightBalls => "light_balls",
            Part::PathAttenuation => "path_attenuation",
            Part::ShadowRays => "shadow_rays",
        }
    }

    pub fn why(self) -> &'static str {
        match self {
            Part::ReflectedRays => "no surface has a `reflection` other than 0",
            Part::TransmittedRays => "no surface has a `transmission` other than 0",
            Part::TextureCoordinates => "no surface has a `texture`",
            Part::Highlights => "no surface has a `specular` other than 0",
            Part::LightBalls => "no point light has a `radius` other than 0",
            Part::PathAttenuation => "secondary rays lose nothing on their way: [1, 0, 0]",
            Part::ShadowRays => "nothing that casts a shadow can stand before this light",
        }
    }

    /// Whether ray casting, which follows primary rays only, would have done it.
    pub fn concerns_primary_rays(self) -> bool {
        matches!(
            self,
            Part::TextureCoordinates | Part::Highlights | Part::LightBalls
        )
    }
}

/// The most tests of one object between another and a light.
const MOST_TESTS: usize = 1 << 20;

impl Needs {
    pub fn of(scene: &Scene) -> Self {
        let used = || {
            scene
                .objects
                .iter()
                .map(|object| &scene.materials[object.material])
        };
        let any = |has: fn(&Material) -> bool| used().any(has);
        let mut needs = Needs {
            reflection: any(|material| material.reflection != Rgb::BLACK),
            transmission: any(|material| material.transmission != Rgb::BLACK),
            textures: any(|material| material.texture.is_some()),
            specular: any(|material| material.specular != Rgb::BLACK),
            light_balls: scene
                .lights
                .iter()
                .any(|light| matches!(light, Light::Point { radius, .. } if *radius > 0.0)),
            path_attenuation: scene.path_attenuation != [1.0, 0.0, 0.0],
            shadows: shadows(scene),
            left_out: Vec::new(),
        };
        needs.left_out = needs.list();
        needs
    }

    /// All parts, needed or not: the picture that leaving out is measured against.
    pub fn everything(scene: &Scene) -> Self {
        Needs {
            reflection: true,
            transmission: true,
            textures: true,
            specular: true,
            light_balls: true,
            path_attenuation: true,
            shadows: vec![vec![true; scene.objects.len()]; scene.lights.len()],
            left_out: Vec::new(),
        }
    }

    /// Whether a shadow ray is needed from `object` to `light`.
    pub fn shadow(&self, light: usize, object: usize) -> bool {
        self.shadows[light][object]
    }

    fn list(&self) -> Vec<LeftOut> {
        let parts = [
            (self.reflection, Part::ReflectedRays, "materials"),
            (self.transmission, Part::TransmittedRays, "materials"),
            (self.textures, Part::TextureCoordinates, "materials"),
            (self.specular, Part::Highlights, "materials"),
            (self.light_balls, Part::LightBalls, "lights"),
            (
                self.path_attenuation,
                Part::PathAttenuation,
                "path_attenuation",
            ),
        ];
        let mut left_out: Vec<LeftOut> = parts
            .into_iter()
            .filter(|(needed, ..)| !needed)
            .map(|(_, part, place)| LeftOut {
                part,
                place: place.into(),
                share: None,
            })
            .collect();
        for (light, objects) in self.shadows.iter().enumerate() {
            let clear = objects.iter().filter(|&&shadowed| !shadowed).count();
            if clear > 0 {
                left_out.push(LeftOut {
                    part: Part::ShadowRays,
                    place: format!("lights[{light}]"),
                    share: (clear < objects.len()).then_some([clear, objects.len()]),
                });
            }
        }
        left_out
    }
}

/// By light and object: whether something that casts a shadow may stand between. All true where there are too many to test.
fn shadows(scene: &Scene) -> Vec<Vec<bool>> {
    let objects = &scene.objects;
    let tests = scene.lights.len() * objects.len() * objects.len();
    if tests > MOST_TESTS {
        return vec![vec![true; objects.len()]; scene.lights.len()];
    }
    let extents: Vec<Extent> = objects
        .iter()
        .map(|object| Extent::of(&object.shape))
        .collect();
    let eye = scene.camera.as_ref().map(|camera| camera.eye);
    let may_block = |light: &Light, lit: usize, blocker: usize| {
        let shadowless = !objects[blocker].casts_shadow;
        let itself = lit == blocker && cannot_shadow_itself(scene, &objects[lit], eye);
        !(shadowless || itself || lit != blocker && apart(light, &extents[lit], &extents[blocker]))
    };
    let shadowed =
        |light: &Light, lit| (0..objects.len()).any(|blocker| may_block(light, lit, blocker));
    let of_light = |light| (0..objects.len()).map(|lit| shadowed(light, lit)).collect();
    scene.lights.iter().map(of_light).collect()
}

/// Flat ones cannot; nor can spheres that are seen from outside only.
fn cannot_shadow_itself(scene: &Scene, object: &Object, eye: Option<DVec3>) -> bool {
    match &object.shape {
        Shape::Plane { .. } => true,
        Shape::Polygon { vertices } => vertices.len() == 3,
        Shape::Sphere { center, radius } => {
            let opaque = scene.materials[object.material].transmission == Rgb::BLACK;
            let outside = |eye: DVec3| eye.distance(*center) > radius * (1.0 + 1e-9);
            opaque && eye.is_some_and(outside)
        }
        Shape::Cylinder { .. } | Shape::Bezier { .. } | Shape::Mesh(_) => false,
    }
}

/// Where an object lies: between two corners of a box, or in an infinite plane.
enum Extent {
    Box { low: DVec3, high: DVec3 },
    Plane { point: DVec3, normal: DVec3 },
}

impl Extent {
    fn of(shape: &Shape) -> Self {
        let around = |points: &mut dyn Iterator<Item = DVec3>, margin: f64| {
            let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
            let (low, high) = points.fold(empty, |(low, high), p| (low.min(p), high.max(p)));
            Extent::Box {
                low: low - margin,
                high: high + margin,
            }
        };
        match shape {
            Shape::Plane { point, normal } => Extent::Plane {
                point: *point,
                normal: *normal,
            },
            Shape::Sphere { center, radius } => around(&mut [*center].into_iter(), *radius),
            Shape::Polygon { vertices } => around(&mut vertices.iter().copied(), 0.0),
            Shape::Cylinder {
                base,
                axis,
                radius,
                height,
                ..
            } => around(&mut [*base, *base + *height * *axis].into_iter(), *radius),
            // A Bézier patch lies within the convex hull of its control points.
            Shape::Bezier { patches, .. } => around(&mut patches.iter().flatten().copied(), 0.0),
            Shape::Mesh(mesh) => around(
                &mut (0..mesh.vertex_count() as u32).map(|v| mesh.position(v)),
                0.0,
            ),
        }
    }

    /// The interval that the object takes along an axis.
    fn along(&self, axis: DVec3) -> [f64; 2] {
        match *self {
            Extent::Box { low, high } => {
                let (center, half) = (0.5 * (low + high), 0.5 * (high - low));
                let reach = half.dot(axis.abs());
                [center.dot(axis) - reach, center.dot(axis) + reach]
            }
            Extent::Plane { point, normal } if normal.cross(axis) == DVec3::ZERO => {
                [point.dot(axis); 2]
            }
            Extent::Plane { .. } => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }
}

/// Whether some plane has the blocker on one side, and the lit object and the light on the other, with room for rounding.
fn apart(light: &Light, lit: &Extent, blocker: &Extent) -> bool {
    let normals = [lit, blocker]
        .into_iter()
        .filter_map(|extent| match extent {
            Extent::Plane { normal, .. } => Some(*normal),
            Extent::Box { .. } => None,
        });
    DVec3::AXES.into_iter().chain(normals).any(|axis| {
        let [mut low, mut high] = lit.along(axis);
        match *light {
            Light::Point { position, .. } => {
                low = low.min(position.dot(axis));
                high = high.max(position.dot(axis));
            }
            Light::Directional { toward, .. } => match toward.dot(axis) {
                along if along > 0.0 => low = f64::NEG_INFINITY,
                along if along < 0.0 => high = f64::INFINITY,
                _ => {}
            },
        }
        let [from, to] = blocker.along(axis);
        let magnitude = [low, high, from, to]
            .into_iter()
            .filter(|end| end.is_finite())
            .fold(0.0, |largest: f64, end| largest.max(end.abs()));
        let room = 1e-9 * magnitude;
        low > to + room || high < from - room
    })
}
