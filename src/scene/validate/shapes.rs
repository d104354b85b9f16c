//! Shapes: from their numbers, or the file that they name, to a [`Shape`] and how it can be divided.

use super::objects::{Division, Objects};
use super::rules::{COORDINATE, LARGEST, LENGTH, SMALLEST};
use crate::scene::division::{Divided, divided};
use crate::scene::document::{Keyed, Place};
use crate::scene::file::{
    BezierFile, CylinderFile, MeshFile, PlaneFile, PolygonFile, SphereFile, TransformFile,
};
use crate::scene::mesh_file::{MeshData, mesh_format, mesh_path_is_inside};
use crate::scene::tessellation::CYLINDER_SIDES;
use crate::scene::values::{Count, Triple};
use crate::scene::{Mesh, Shape, VertexNormals};
use glam::{DAffine3, DMat3, DVec3};
use std::rc::Rc;

/// Why faces are noted that cross themselves, or are not planar.
const EVEN_ODD: &str = "filled by the even-odd rule";
const TRIANGLES: &str = "divided into triangles";

impl Objects<'_, '_> {
    pub fn sphere(&mut self, place: &Place, file: &SphereFile) -> (Shape, Division) {
        let center = self.check.point(&place.key("center"), file.center);
        let radius = self.check.number(&place.key("radius"), file.radius, LENGTH);
        (Shape::Sphere { center, radius }, Division::Sphere)
    }

    pub fn plane(&mut self, place: &Place, file: &PlaneFile) -> (Shape, Division) {
        let point = self.check.point(&place.key("point"), file.point);
        let normal = self.check.direction(&place.key("normal"), file.normal);
        (
            Shape::Plane { point, normal },
            Division::Never("a plane, which has no end"),
        )
    }

    pub fn polygon(&mut self, place: &Place, file: &PolygonFile) -> Option<(Shape, Division)> {
        let place = &place.key("vertices");
        let problems = self.check.count;
        let vertices = self.points(place, &file.vertices);
        if self.check.count > problems {
            return None;
        }
        let count = vertices.len();
        if count < 3 {
            let message = format!("found {count} vertices; a polygon has 3 or more");
            self.check.refuse(place, message);
            return None;
        }
        let (bent, crossing) = match divided_polygon(&vertices) {
            Ok(divided) => (divided.bent > 0, divided.crossing > 0),
            Err(message) => {
                self.check.refuse(place, message);
                return None;
            }
        };
        if crossing {
            self.check
                .note(place, "a polygon that crosses itself", EVEN_ODD);
        }
        if bent && count > 4 {
            self.check
                .note(place, "a polygon that is not planar", TRIANGLES);
        }
        let division = match count {
            3 => Division::Triangles(1),
            4 if !crossing => Division::Quadrilateral,
            4 => Division::Never("a polygon that crosses itself"),
            _ => Division::Never("a polygon of more than 4 vertices"),
        };
        Some((Shape::Polygon { vertices }, division))
    }

    pub fn cylinder(&mut self, place: &Place, file: &CylinderFile) -> (Shape, Division) {
        let capped = file.capped.unwrap_or(true);
        let sides = u64::from(CYLINDER_SIDES);
        let caps = if capped { 2 * (sides - 2) } else { 0 };
        let shape = Shape::Cylinder {
            base: self.check.point(&place.key("base"), file.base),
            axis: self.check.direction(&place.key("axis"), file.axis),
            radius: self.check.number(&place.key("radius"), file.radius, LENGTH),
            height: self.check.number(&place.key("height"), file.height, LENGTH),
            capped,
        };
        (shape, Division::Triangles(2 * sides + caps))
    }

    pub fn bezier(&mut self, place: &Place, file: &BezierFile) -> Option<(Shape, Division)> {
        let Count(divisions) = file.divisions;
        if divisions == 0 {
            self.check.refuse(
                &place.key("divisions"),
                "found 0; allowed is 1 or more".into(),
            );
        }
        let patches_place = &place.key("patches");
        if file.patches.is_empty() {
            self.check.refuse(
                patches_place,
                "found no patches; allowed is one or more, each a list of 16 points".into(),
            );
        }
        let mut patches = Vec::with_capacity(file.patches.len());
        for (index, points) in file.patches.iter().enumerate() {
            let place = &patches_place.index(index);
            match <[DVec3; 16]>::try_from(self.points(place, points)) {
                Ok(points) => patches.push(points),
                Err(points) => {
                    let message = format!(
                        "found {} points; a bicubic patch has 16, row by row",
                        points.len()
                    );
                    self.check.refuse(place, message);
                }
            }
        }
        let cells = u128::from(divisions).pow(2);
        let triangles = cells.saturating_mul(2 * file.patches.len() as u128);
        if !self.has_room_for(&place.key("divisions"), triangles) {
            return None;
        }
        // Within the limit, so within 32 bits.
        let shape = Shape::Bezier {
            patches,
            divisions: u32::try_from(divisions).ok()?,
        };
        Some((shape, Division::Triangles(u64::try_from(triangles).ok()?)))
    }

    /// `object` is the place of the object, which holds `mesh` and `transform` side by side.
    pub fn mesh(
        &mut self,
        object: &Place,
        file: &MeshFile,
        transform: Option<&Keyed<TransformFile>>,
        vertex_normals: VertexNormals,
    ) -> Option<(Shape, Division)> {
        let problems = self.check.count;
        let transform_place = &object.key("transform");
        let to_world = transform.map_or(DAffine3::IDENTITY, |Keyed(transform)| {
            self.transform(transform_place, transform)
        });
        let transform_is_right = self.check.count == problems;

        let mesh_place = &object.key("mesh");
        let place = &mesh_place.key("file");
        let is_new = !self.meshes.contains_key(&file.file);
        let data = self.mesh_data(&file.file);
        let data = match &*data {
            Ok(data) => data,
            Err(message) => {
                self.check.refuse(place, message.clone());
                return None;
            }
        };
        if !self.has_room_for(place, data.triangles().into()) || !transform_is_right {
            return None;
        }
        let with_normals = vertex_normals == VertexNormals::File;
        let mesh = data.mesh(&to_world, with_normals);
        let lost = data.face_count() - mesh.face_count();
        let divided = match divided(mesh) {
            Ok(divided) => divided,
            Err(message) => {
                let message = format!("in {:?}: {message}", file.file);
                self.check.refuse(place, message);
                return None;
            }
        };
        if is_new {
            for remark in &data.remarks {
                self.check.note(place, &*remark.what, remark.why);
            }
            for (count, which, why) in [
                (
                    lost,
                    "fewer than three different corners",
                    "left out, having no area",
                ),
                (
                    divided.bent,
                    "corners that do not lie in a plane",
                    TRIANGLES,
                ),
                (divided.crossing, "a border that crosses itself", EVEN_ODD),
            ] {
                if count > 0 {
                    let faces = if count == 1 { "face" } else { "faces" };
                    self.check
                        .note(place, format!("{count} {faces} with {which}"), why);
                }
            }
        }
        if with_normals && data.corners_without_normal() > 0 {
            let (count, of) = (data.corners_without_normal(), data.corner_count());
            let what = format!("{count} of {of} corners without a normal in the file");
            let why = "they take the mean of the faces around the vertex";
            self.check.note(&object.key("normals"), what, why);
        } else if !with_normals && data.has_normals() && is_new {
            let why = "not used: an object takes them with \"normals\": \"file\"";
            self.check.note(place, "normals of the file", why);
        }
        let mesh = divided.mesh;
        if mesh.face_count() == 0 {
            let message = format!(
                "found no face in {:?} with three corners at different places; a mesh needs at least one",
                file.file
            );
            self.check.refuse(place, message);
            return None;
        }
        if !is_within_bounds(&mesh) {
            self.check.refuse(
                transform_place,
                format!("takes vertices of {:?} too far away; allowed are coordinates from -1e75 to 1e75", file.file),
            );
            return None;
        }
        let triangles = (0..mesh.face_count()).map(|face| mesh.face(face).len() as u64 - 2);
        let division = Division::Triangles(triangles.sum());
        Some((Shape::Mesh(mesh), division))
    }

    fn points(&mut self, place: &Place, written: &[Triple]) -> Vec<DVec3> {
        written
            .iter()
            .enumerate()
            .map(|(i, &point)| self.check.point(&place.index(i), point))
            .collect()
    }

    /// Scale, then rotations about x, y, z, then translation.
    fn transform(&mut self, place: &Place, file: &TransformFile) -> DAffine3 {
        let translate = file.translate.map_or(DVec3::ZERO, |translate| {
            self.check.point(&place.key("translate"), translate)
        });
        let rotate = file.rotate_degrees.map_or(DVec3::ZERO, |degrees| {
            let degrees = self
                .check
                .triple(&place.key("rotate_degrees"), degrees, COORDINATE);
            DVec3::from(degrees.map(f64::to_radians))
        });
        let scale = file.scale.map_or(1.0, |scale| {
            self.check.number(&place.key("scale"), scale, LENGTH)
        });
        let rotation = DMat3::from_rotation_z(rotate.z)
            * DMat3::from_rotation_y(rotate.y)
            * DMat3::from_rotation_x(rotate.x);
        DAffine3::from_mat3_translation(rotation * scale, translate)
    }

    /// What the mesh file at this path holds; each is read once.
    fn mesh_data(&mut self, path: &str) -> Rc<Result<MeshData, String>> {
        if let Some(data) = self.meshes.get(path) {
            return data.clone();
        }
        let max_triangles = self.max_triangles();
        let data = mesh_path_is_inside(path)
            .and_then(|()| mesh_format(path))
            .and_then(|format| {
                let bytes = (self.read_file)(path);
                let bytes = bytes.map_err(|why| format!("cannot read {path:?}: {why}"))?;
                MeshData::read(&bytes, format, max_triangles)
                    .map_err(|why| format!("in {path:?}: {why}"))
            });
        let data = Rc::new(data);
        self.meshes.insert(path.to_owned(), data.clone());
        data
    }
}

/// Whether three vertices or more make a polygon. Errors: why they do not.
pub fn check_polygon(vertices: &[DVec3]) -> Result<(), String> {
    divided_polygon(vertices).map(drop)
}

fn divided_polygon(vertices: &[DVec3]) -> Result<Divided, String> {
    let face: Vec<u32> = (0..vertices.len() as u32).collect();
    let divided = divided(Mesh::new(vertices, [face], &[]))?;
    let has_area = match divided.bent + divided.crossing {
        0 => has_area(vertices),
        _ => divided.mesh.face_count() > 0,
    };
    match has_area {
        true => Ok(divided),
        false => Err(
            "found vertices on one line, or a turn that undoes itself; a polygon has an area"
                .into(),
        ),
    }
}

/// Whether the area of a polygon is more than the rounding of its coordinates can make up.
fn has_area(vertices: &[DVec3]) -> bool {
    let origin = vertices[0];
    let size = extent(vertices);
    if size < SMALLEST {
        return false;
    }
    let furthest = vertices
        .iter()
        .map(|v| v.abs().max_element())
        .fold(0.0, f64::max);
    let area: DVec3 = vertices[1..]
        .windows(2)
        .map(|pair| ((pair[0] - origin) / size).cross((pair[1] - origin) / size))
        .sum();
    area.length() > 4.0 * f64::EPSILON * (furthest / size)
}

/// The largest difference of a coordinate from that of the first vertex.
fn extent(vertices: &[DVec3]) -> f64 {
    vertices
        .iter()
        .map(|&v| (v - vertices[0]).abs().max_element())
        .fold(0.0, f64::max)
}

fn is_within_bounds(mesh: &Mesh) -> bool {
    (0..mesh.vertex_count() as u32).all(|v| mesh.position(v).abs().max_element() <= LARGEST)
}
