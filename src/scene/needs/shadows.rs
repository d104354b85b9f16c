//! Which lights no object can block: between the surfaces and the light lies a plane that has everything else on its other side.

use crate::color::Rgb;
use crate::scene::{Light, Object, Scene, Shape};
use glam::DVec3;

/// The most tests of one object between another and a light.
const MOST_TESTS: usize = 1 << 20;

/// By light and object: whether something that casts a shadow may stand between. All true where there are too many to test.
pub fn shadows(scene: &Scene) -> Vec<Vec<bool>> {
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
        let enclosure = 1e-9 * magnitude;
        low > to + enclosure || high < from - enclosure
    })
}
