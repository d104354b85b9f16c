//! What rays meet: the objects of a scene, exactly in f64, found through f32 hierarchies that pass over nothing.
//!
//! Two levels: each divided object (mesh, polygon, Bézier surface) has a hierarchy over its triangles, and one stands over the
//! boxes of all finite objects. Infinite planes are tested apart. A run that tests object by object with [`Primitives::meet`] gets
//! the same bits as [`Primitives::nearest`].

mod aim;
mod chart;
mod chart_part;
mod closed;
mod contact;
mod cylinder;
mod error;
mod face_chart;
mod faces;
mod frame;
mod hierarchy;
mod packet;
mod part;
mod plane;
pub(super) mod polygon;
mod ray;
mod shells;
mod solid;
mod sphere;
mod stack;
#[cfg(test)]
mod tests;
mod triangle;
mod true_surface;

pub use chart_part::ChartPart;
pub use contact::{Between, Contact, Nearest};
pub use face_chart::FaceChart;
pub use part::Part;
pub use polygon::triangles;
pub use ray::{Ray, leaving, short_of};
pub use sphere::meet_ball;
pub use true_surface::{TruePoint, is_end, true_point};

use super::{Scene, Tessellation};
use crate::color::Rgb;
use aim::Aim;
pub use closed::Winding;
use frame::{Frame, Near};
use glam::{DVec2, DVec3, Vec3};
use hierarchy::{Bvh, UnitRay};
use solid::Solid;
use stack::Stack;

/// Where a ray meets an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Along the ray, > 0: a distance.
    pub t: f64,
    pub object: u32,
    /// Of the object's triangles, counted from 0 face by face; 0 on spheres and planes; on cylinders 0 is the mantle, 1 and 2 are the ends.
    pub triangle: u32,
}

impl Hit {
    /// Nearer, or equally near and of a lower object, then triangle.
    fn is_before(&self, other: &Hit) -> bool {
        let number = |hit: &Hit| (hit.object, hit.triangle);
        self.t < other.t || (self.t == other.t && number(self) < number(other))
    }
}

/// A place on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    pub position: DVec3,
    /// Geometric, unit; outward on a sphere, toward the front on polygons and planes.
    pub normal: DVec3,
    /// By how much, along each axis, the position may be off the surface, for the next ray that starts there.
    pub error: DVec3,
}

/// The objects of a scene, ready to be met by rays.
#[derive(Clone, Debug)]
pub struct Primitives {
    primitives: Vec<Solid>,
    /// By object, as the two below.
    casts_shadow: Vec<bool>,
    is_transparent: Vec<bool>,
    is_closed: Vec<bool>,
    /// The objects that are infinite.
    planes: Vec<u32>,
    /// The objects in the leaves of the hierarchy.
    finite: Vec<u32>,
    frame: Frame,
    hierarchy: Bvh,
}

impl Primitives {
    /// `tessellation` is that of the scene.
    pub fn of(scene: &Scene, tessellation: &Tessellation) -> Primitives {
        let objects = scene.objects.iter().zip(&tessellation.meshes);
        let (primitives, is_closed): (Vec<Solid>, Vec<bool>) = objects
            .map(|(object, mesh)| Solid::of(object, &scene.materials[object.material], mesh))
            .unzip();
        let (mut planes, mut finite, mut boxes) = (Vec::new(), Vec::new(), Vec::new());
        for (object, solid) in (0..).zip(&primitives) {
            match solid.bounds() {
                Some(bounds) => {
                    finite.push(object);
                    boxes.push(bounds);
                }
                None => planes.push(object),
            }
        }
        let low = boxes.iter().map(|&[low, _]| low).reduce(DVec3::min);
        let high = boxes.iter().map(|&[_, high]| high).reduce(DVec3::max);
        let frame = Frame::around(low.unwrap_or_default(), high.unwrap_or_default());
        let boxes: Vec<[Vec3; 2]> = boxes
            .into_iter()
            .map(|bounds| bounds.map(|corner| frame.unit_point(corner)))
            .collect();
        let (hierarchy, leaves) = Bvh::new(&boxes, 1);
        Primitives {
            finite: leaves
                .iter()
                .flatten()
                .map(|&place| finite[place as usize])
                .collect(),
            casts_shadow: scene
                .objects
                .iter()
                .map(|object| object.casts_shadow)
                .collect(),
            is_transparent: scene
                .objects
                .iter()
                .map(|object| scene.materials[object.material].transmission != Rgb::BLACK)
                .collect(),
            primitives,
            is_closed,
            planes,
            frame,
            hierarchy,
        }
    }

    /// The memory of the objects and their hierarchies, by the sizes of what they are made of.
    pub fn bytes(&self) -> u64 {
        let of = |solid: &Solid| match solid {
            Solid::Faces { faces, .. } => faces.bytes(),
            Solid::Sphere { .. } | Solid::Plane(_) | Solid::Cylinder(_) => 0,
        };
        let own = self.primitives.len() * size_of::<Solid>();
        own as u64 + self.hierarchy.bytes() + self.primitives.iter().map(of).sum::<u64>()
    }

    /// The nearest hit of one object.
    pub fn meet(&self, object: usize, ray: &Ray) -> Option<Hit> {
        match &self.primitives[object] {
            Solid::Plane(plane) => plane.meet(ray).map(|t| Hit {
                t,
                object: object as u32,
                triangle: 0,
            }),
            _ => {
                let near = self.frame.near(ray)?;
                let aim = Aim::of(ray.direction);
                let stack = &mut Stack::new();
                self.meet_finite(object as u32, ray, &near, &aim, f64::INFINITY, stack)
            }
        }
    }

    /// What is in front on a ray: the nearest hit of all objects, and of those that touch there the lowest object.
    pub fn nearest(&self, ray: &Ray) -> Option<Hit> {
        self.nearest_with_contact(ray).map(|nearest| nearest.hit)
    }

    /// The same, and what else is at its place.
    pub fn nearest_with_contact(&self, ray: &Ray) -> Option<Nearest> {
        let mut search = contact::Search::new(ray);
        self.for_each_hit(ray, &mut |hit| {
            search.add(hit);
            search.reach()
        });
        let hit = search.nearest?;
        if !search.has_close && !self.has_shells(hit.object) {
            return Some(Nearest { hit, contact: None });
        }
        let reach = search.reach();
        let mut hits = Vec::new();
        self.for_each_hit(ray, &mut |hit| {
            hits.push(hit);
            reach
        });
        hits.retain(|hit| hit.t <= reach);
        hits.sort_by_key(|hit| hit.object);
        self.front(ray, &hits)
    }

    /// Shows `met` the nearest hit of every object within the reach that it returns.
    fn for_each_hit(&self, ray: &Ray, met: &mut dyn FnMut(Hit) -> f64) {
        let mut reach = f64::INFINITY;
        for &plane in &self.planes {
            if let Some(hit) = self.meet(plane as usize, ray) {
                reach = met(hit);
            }
        }
        let Some(near) = self.frame.near(ray) else {
            return;
        };
        let aim = Aim::of(ray.direction);
        let unit = UnitRay::new(&self.frame, &near, &aim);
        let stack = &mut Stack::new();
        self.hierarchy
            .walk(&unit, unit.reach(reach), stack, |leaf, _, stack| {
                let object = self.finite[leaf];
                if let Some(hit) = self.meet_finite(object, ray, &near, &aim, reach, stack) {
                    reach = met(hit);
                }
                unit.reach(reach)
            });
    }

    /// Whether an object is a transparent mesh of several parts, which may touch each other.
    fn has_shells(&self, object: u32) -> bool {
        matches!(&self.primitives[object as usize], Solid::Faces { faces, .. } if faces.has_shells())
    }

    /// Where a ray meets, close to a hit, the other parts of the same mesh.
    fn other_shells(&self, ray: &Ray, hit: &Hit) -> Vec<Hit> {
        let (Solid::Faces { faces, .. }, Some(near)) =
            (&self.primitives[hit.object as usize], self.frame.near(ray))
        else {
            return Vec::new();
        };
        let reach = near.reach(hit.t + contact::close(ray, hit.t));
        let aim = Aim::of(ray.direction);
        let others = faces.meet_other_shells(hit.triangle, &near.ray, &aim, reach);
        let hit_of = |(t, triangle)| Hit {
            t: faces.t_along(ray, &near, t, triangle),
            triangle,
            ..*hit
        };
        others.into_iter().map(hit_of).collect()
    }

    /// What [`Self::nearest`] finds, to the bit, with no hierarchy: by testing every triangle of every object.
    pub fn nearest_by_brute_force(&self, ray: &Ray) -> Option<Hit> {
        let objects = 0..self.primitives.len();
        let hits: Vec<Hit> = objects
            .filter_map(|object| self.meet_by_brute_force(object, ray))
            .collect();
        self.front(ray, &hits).map(|front| front.hit)
    }

    fn meet_by_brute_force(&self, object: usize, ray: &Ray) -> Option<Hit> {
        let Solid::Faces { faces, .. } = &self.primitives[object] else {
            return self.meet(object, ray);
        };
        let near = self.frame.near(ray)?;
        let (t, triangle) = faces.meet_by_brute_force(&near.ray)?;
        Some(Hit {
            t: faces.t_along(ray, &near, t, triangle),
            object: object as u32,
            triangle,
        })
    }

    /// Whether an object that casts a shadow is met at 0 < t < `distance`, which may be infinite.
    pub fn blocked(&self, ray: &Ray, distance: f64) -> bool {
        let casts_shadow = |object: u32| self.casts_shadow[object as usize];
        let is_before = |hit: Option<Hit>| hit.is_some_and(|hit| hit.t < distance);
        let mut planes = self.planes.iter().filter(|&&plane| casts_shadow(plane));
        if planes.any(|&plane| is_before(self.meet(plane as usize, ray))) {
            return true;
        }
        let Some(near) = self.frame.near(ray) else {
            return false;
        };
        let aim = Aim::of(ray.direction);
        let unit = UnitRay::new(&self.frame, &near, &aim);
        let stack = &mut Stack::new();
        let mut is_blocked = false;
        let clearly_before = distance - faces::unsure(ray, distance);
        self.hierarchy
            .walk(&unit, unit.reach(distance), stack, |leaf, reach, stack| {
                let object = self.finite[leaf];
                is_blocked = casts_shadow(object)
                    && match &self.primitives[object as usize] {
                        Solid::Faces { faces, .. } => {
                            // Whether something is at the distance itself, within rounding, is decided by the nearest hit.
                            let mut is_close = false;
                            let clearly = |t, triangle| {
                                let t = faces.t_along(ray, &near, t, triangle);
                                is_close |= t < distance;
                                t < clearly_before
                            };
                            let reach = near.reach(distance);
                            faces.blocks(&near.ray, &aim, reach, stack, clearly)
                                || is_close && {
                                    let infinity = f64::INFINITY;
                                    is_before(
                                        self.meet_finite(object, ray, &near, &aim, infinity, stack),
                                    )
                                }
                        }
                        _ => is_before(self.meet_finite(object, ray, &near, &aim, distance, stack)),
                    };
                if is_blocked { -1.0 } else { reach }
            });
        is_blocked
    }

    /// The surface where `ray` met `hit`.
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let position = ray.at(hit.t);
        match &self.primitives[hit.object as usize] {
            &Solid::Sphere { center, radius } => sphere::surface(center, radius, position),
            Solid::Plane(plane) => plane.surface(position),
            Solid::Cylinder(cylinder) => cylinder.surface(hit.triangle, position),
            Solid::Faces { faces, .. } => {
                let near = self.frame.near(ray).map_or(*ray, |near| near.ray);
                faces.surface(&near, hit.triangle, position)
            }
        }
    }

    /// Texture coordinates (u, v) at the position of a hit. Those of meshes are kept only where their material has a texture.
    ///
    /// Planes: lengths from the plane's point along two axes (x and z on a floor). Polygons: [0, 1]², bilinear on four vertices. Spheres:
    /// longitude/2π from z toward x, and latitude/π from the north pole (+y) down. Meshes: those of the file, else (0, 0). Bézier surfaces: those
    /// of the patch. Cylinders: longitude/2π and the share of the height.
    pub fn uv(&self, hit: &Hit, position: DVec3) -> DVec2 {
        match &self.primitives[hit.object as usize] {
            Solid::Sphere { center, .. } => sphere::uv(*center, position),
            Solid::Plane(plane) => plane.uv(position),
            Solid::Cylinder(cylinder) => cylinder.uv(position),
            Solid::Faces { faces, vertices } if vertices.is_empty() => {
                faces.uv(hit.triangle, position)
            }
            Solid::Faces { vertices, .. } => chart::polygon_uv(vertices, position),
        }
    }

    /// Whether light passes through an object, and the object has an inside: its surface is closed.
    pub fn is_transparent_body(&self, object: u32) -> bool {
        self.is_transparent[object as usize] && self.is_closed[object as usize]
    }

    /// The closed objects that contain a point, outermost first: spheres, capped cylinders, and divided objects each
    /// face of which has a neighbour across each of its edges.
    pub fn around(&self, point: DVec3) -> Vec<u32> {
        // Any direction will do: what contains another thing is left after it.
        let ray = Ray {
            origin: point,
            direction: DVec3::new(0.6, 0.48, 0.64),
        };
        let exit = |object: usize| self.meet(object, &ray).map_or(0.0, |hit| hit.t);
        let mut around: Vec<u32> = (0..self.primitives.len())
            .filter(|&object| match &self.primitives[object] {
                Solid::Sphere { center, radius } => point.distance(*center) < *radius,
                Solid::Plane(_) => false,
                Solid::Cylinder(cylinder) => cylinder.contains(point),
                Solid::Faces { faces, .. } => self.is_closed[object] && faces.contains(point),
            })
            .map(|object| object as u32)
            .collect();
        around.sort_by(|&a, &b| exit(b as usize).total_cmp(&exit(a as usize)));
        around
    }

    fn meet_finite(
        &self,
        object: u32,
        ray: &Ray,
        near: &Near,
        aim: &Aim,
        distance: f64,
        stack: &mut Stack,
    ) -> Option<Hit> {
        let (t, triangle) = match &self.primitives[object as usize] {
            Solid::Sphere { center, radius } => {
                let t = meet_ball(*center, *radius, &near.ray)?;
                (near.moved + t, 0)
            }
            Solid::Cylinder(cylinder) => {
                let (t, part) = cylinder.meet(&near.ray)?;
                (near.moved + t, part)
            }
            Solid::Plane(_) => return None,
            Solid::Faces { faces, .. } => {
                let (t, triangle) = faces.meet(&near.ray, aim, near.reach(distance), stack)?;
                (faces.t_along(ray, near, t, triangle), triangle)
            }
        };
        Some(Hit {
            t,
            object,
            triangle,
        })
    }
}
