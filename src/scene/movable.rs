//! What can be taken by the hand and put elsewhere: lights, the eye, objects, and single vertices.

use super::validate::check_polygon;
use super::{LARGEST, Light, Object, Scene, Shape};
use glam::DVec3;

/// Something that has a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Movable {
    /// A point light, by its index.
    Light(usize),
    /// It goes on looking at its target.
    Eye,
    /// All of an object, by its index. Its place is that of [`Object::anchor`].
    Object(usize),
    /// A vertex of an inline polygon.
    Vertex { object: usize, vertex: usize },
}

/// Why it cannot be put there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoRoom {
    TooFar,
    /// The eye would look along the camera's up, or stand at its target.
    NoView,
    /// What a file with this place would be refused for.
    Refused(String),
}

impl Movable {
    /// All that a scene has, meshes aside: single vertices are those of inline polygons.
    pub fn all(scene: &Scene) -> impl Iterator<Item = Movable> {
        let lights = (0..scene.lights.len()).map(Movable::Light);
        let eye = scene.camera.map(|_| Movable::Eye);
        let objects = scene.objects.iter().enumerate();
        let objects = objects.flat_map(|(object, of)| {
            let vertices = match &of.shape {
                Shape::Polygon { vertices } => vertices.len(),
                _ => 0,
            };
            let vertices = (0..vertices).map(move |vertex| Movable::Vertex { object, vertex });
            vertices.chain([Movable::Object(object)])
        });
        let all = lights.chain(eye).chain(objects);
        all.filter(|movable| movable.position(scene).is_some())
    }

    /// None of what has no place, or is not there.
    pub fn position(self, scene: &Scene) -> Option<DVec3> {
        match self {
            Movable::Light(light) => match *scene.lights.get(light)? {
                Light::Point { position, .. } => Some(position),
                Light::Directional { .. } => None,
            },
            Movable::Eye => scene.camera.map(|camera| camera.eye),
            Movable::Object(object) => scene.objects.get(object)?.anchor(),
            Movable::Vertex { object, vertex } => match &scene.objects.get(object)?.shape {
                Shape::Polygon { vertices } => vertices.get(vertex).copied(),
                _ => None,
            },
        }
    }

    /// Puts it at `position` in a scene that was `opened` before anything was moved. Errors: nothing has changed then.
    pub fn put(self, scene: &mut Scene, opened: &Scene, position: DVec3) -> Result<(), NoRoom> {
        check_place(position)?;
        match self {
            Movable::Light(light) => {
                if let Some(Light::Point { position: at, .. }) = scene.lights.get_mut(light) {
                    *at = position;
                }
            }
            Movable::Eye => return put_eye(scene, opened, position),
            Movable::Object(object) => {
                if let Some(object) = scene.objects.get_mut(object) {
                    object.put(position)?;
                }
            }
            Movable::Vertex { object, vertex } => {
                if let Some(Object {
                    shape: Shape::Polygon { vertices },
                    ..
                }) = scene.objects.get_mut(object)
                    && vertex < vertices.len()
                {
                    let mut moved = vertices.clone();
                    moved[vertex] = position;
                    check_polygon(&moved).map_err(NoRoom::Refused)?;
                    *vertices = moved;
                }
            }
        }
        Ok(())
    }
}

impl Object {
    /// The place by which it is moved: a sphere's centre, a cylinder's base, a plane's point, the mean of a polygon's vertices and of
    /// the control points of Bézier patches. Meshes stand where their file and its transform put them.
    pub fn anchor(&self) -> Option<DVec3> {
        match &self.shape {
            Shape::Sphere { center, .. } => Some(*center),
            Shape::Plane { point, .. } => Some(*point),
            Shape::Polygon { vertices } => Some(mean(vertices)),
            Shape::Cylinder { base, .. } => Some(*base),
            Shape::Bezier { patches, .. } => Some(mean(patches.as_flattened())),
            Shape::Mesh(_) => None,
        }
    }

    /// With its anchor there. Errors: nothing has changed then.
    fn put(&mut self, position: DVec3) -> Result<(), NoRoom> {
        let Some(anchor) = self.anchor() else {
            return Ok(());
        };
        let moved = |points: &[DVec3]| {
            let moved = points.iter().map(|&point| point + (position - anchor));
            let moved: Vec<DVec3> = moved.collect();
            moved.iter().try_for_each(|&point| check_place(point))?;
            Ok(moved)
        };
        match &mut self.shape {
            Shape::Sphere { center, .. } => *center = position,
            Shape::Plane { point, .. } => *point = position,
            Shape::Cylinder { base, .. } => *base = position,
            Shape::Polygon { vertices } => {
                let moved = moved(vertices)?;
                // Far away, rounding can take its area.
                check_polygon(&moved).map_err(NoRoom::Refused)?;
                *vertices = moved;
            }
            Shape::Bezier { patches, .. } => {
                let moved = moved(patches.as_flattened())?;
                patches.as_flattened_mut().copy_from_slice(&moved);
            }
            Shape::Mesh(_) => {}
        }
        Ok(())
    }
}

/// What the eye looks at stays as large in the picture as it was.
fn put_eye(scene: &mut Scene, opened: &Scene, position: DVec3) -> Result<(), NoRoom> {
    let Some(camera) = &mut scene.camera else {
        return Ok(());
    };
    let forward = (camera.target - position).try_normalize();
    let up = camera.up.normalize_or_zero();
    let aside = forward.map_or(0.0, |forward| forward.cross(up).length());
    if aside < 1e-6 {
        return Err(NoRoom::NoView);
    }
    if let Some(opened) = &opened.camera {
        let width = opened.eye.distance(opened.target) * (0.5 * opened.fov_x).tan();
        let distance = position.distance(camera.target);
        camera.fov_x = 2.0 * (width / distance).atan();
    }
    camera.eye = position;
    Ok(())
}

fn check_place(position: DVec3) -> Result<(), NoRoom> {
    // Not a number is not allowed either.
    let near = position.to_array().iter().all(|x| x.abs() <= LARGEST);
    near.then_some(()).ok_or(NoRoom::TooFar)
}

fn mean(points: &[DVec3]) -> DVec3 {
    let count = points.len().max(1) as f64;
    points.iter().map(|&point| point / count).sum()
}

#[cfg(test)]
mod tests;
