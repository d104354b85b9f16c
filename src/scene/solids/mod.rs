//! The objects of a scene as rays meet them.

use crate::color::Rgb;
use crate::scene::{Scene, Shape, Tessellation, Texture};
use glam::{DVec2, DVec3};

/// origin + t·direction; `direction` is unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    pub origin: DVec3,
    pub direction: DVec3,
}

impl Ray {
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// The ray that leaves a surface toward `direction`, from beside it.
    pub fn leaving(surface: &Surface, direction: DVec3) -> Ray {
        let side = surface.normal.dot(direction).signum();
        Ray {
            origin: surface.position + side * surface.error * surface.normal,
            direction,
        }
    }
}

/// Where a ray meets an object; `triangle` is 0 for spheres and planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    pub t: f64,
    pub object: u32,
    pub triangle: u32,
}

/// A place on a surface; `normal` is geometric, unit, outward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    pub position: DVec3,
    pub normal: DVec3,
    pub error: f64,
}

#[derive(Clone, Debug)]
enum Solid {
    Sphere { center: DVec3, radius: f64 },
    Plane { point: DVec3, normal: DVec3 },
    Triangles(Vec<[DVec3; 3]>),
}

#[derive(Clone, Debug)]
pub struct Solids {
    solids: Vec<Solid>,
    casts_shadow: Vec<bool>,
}

impl Solids {
    pub fn of(scene: &Scene, tessellation: &Tessellation) -> Solids {
        let solid = |(index, object): (usize, &crate::scene::Object)| match object.shape {
            Shape::Sphere { center, radius } => Solid::Sphere { center, radius },
            Shape::Plane { point, normal } => Solid::Plane { point, normal },
            _ => {
                let mesh = &tessellation.meshes[index];
                let fan = |face: usize| {
                    let corners = mesh.face(face);
                    corners[1..].windows(2).map(move |pair| {
                        [corners[0], pair[0], pair[1]].map(|vertex| mesh.position(vertex))
                    })
                };
                Solid::Triangles((0..mesh.face_count()).flat_map(fan).collect())
            }
        };
        Solids {
            solids: scene.objects.iter().enumerate().map(solid).collect(),
            casts_shadow: scene.objects.iter().map(|o| o.casts_shadow).collect(),
        }
    }

    /// The nearest hit of one object, with t > 0.
    pub fn meet(&self, object: usize, ray: &Ray) -> Option<Hit> {
        let hit = |(t, triangle)| Hit {
            t,
            object: object as u32,
            triangle,
        };
        match &self.solids[object] {
            Solid::Sphere { center, radius } => {
                meet_ball(*center, *radius, ray).map(|t| hit((t, 0)))
            }
            Solid::Plane { point, normal } => {
                let t = (*point - ray.origin).dot(*normal) / ray.direction.dot(*normal);
                (t > 0.0 && t.is_finite()).then(|| hit((t, 0)))
            }
            Solid::Triangles(triangles) => {
                let mut nearest: Option<(f64, u32)> = None;
                for (index, &[a, b, c]) in triangles.iter().enumerate() {
                    let (ab, ac) = (b - a, c - a);
                    let p = ray.direction.cross(ac);
                    let det = ab.dot(p);
                    let s = ray.origin - a;
                    let u = s.dot(p) / det;
                    let q = s.cross(ab);
                    let v = ray.direction.dot(q) / det;
                    let t = ac.dot(q) / det;
                    if u >= 0.0
                        && v >= 0.0
                        && u + v <= 1.0
                        && t > 0.0
                        && nearest.is_none_or(|(n, _)| t < n)
                    {
                        nearest = Some((t, index as u32));
                    }
                }
                nearest.map(hit)
            }
        }
    }

    /// The nearest hit of all objects.
    pub fn nearest(&self, ray: &Ray) -> Option<Hit> {
        let hits = (0..self.solids.len()).filter_map(|object| self.meet(object, ray));
        hits.reduce(|nearest, hit| if hit.t < nearest.t { hit } else { nearest })
    }

    /// Whether an object that casts a shadow lies at 0 < t < `distance`.
    pub fn blocked(&self, ray: &Ray, distance: f64) -> bool {
        (0..self.solids.len()).any(|object| {
            self.casts_shadow[object] && self.meet(object, ray).is_some_and(|hit| hit.t < distance)
        })
    }

    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let position = ray.at(hit.t);
        let normal = match &self.solids[hit.object as usize] {
            Solid::Sphere { center, .. } => (position - *center).normalize(),
            Solid::Plane { normal, .. } => *normal,
            Solid::Triangles(triangles) => {
                let [a, b, c] = triangles[hit.triangle as usize];
                (b - a).cross(c - a).normalize()
            }
        };
        Surface {
            position,
            normal,
            error: 1e-12 * (1.0 + position.length()),
        }
    }

    /// Texture coordinates.
    pub fn uv(&self, _: &Hit, position: DVec3) -> DVec2 {
        DVec2::new(position.x, position.z)
    }

    /// The closed objects that contain the point, outermost first.
    pub fn around(&self, point: DVec3) -> Vec<u32> {
        let inside = |solid: &Solid| matches!(solid, Solid::Sphere { center, radius } if point.distance(*center) < *radius);
        (0..self.solids.len() as u32)
            .filter(|&object| inside(&self.solids[object as usize]))
            .collect()
    }
}

/// Where a ray meets a ball, from outside or inside.
pub fn meet_ball(center: DVec3, radius: f64, ray: &Ray) -> Option<f64> {
    let to_center = center - ray.origin;
    let b = to_center.dot(ray.direction);
    let discriminant = radius * radius - (to_center - b * ray.direction).length_squared();
    let root = (discriminant >= 0.0).then(|| discriminant.sqrt())?;
    [b - root, b + root].into_iter().find(|&t| t > 0.0)
}

impl Texture {
    pub fn color_at(&self, uv: DVec2) -> Rgb {
        let Texture::Checker { colors, scale } = self;
        let cell = (uv / *scale).floor();
        colors[(cell.x + cell.y).rem_euclid(2.0) as usize]
    }
}
