//! A scene set in front of its camera: polygons in the camera frame and on the screen, ready for the scan-line methods.

use super::focus::{Focus, Region};
use super::frame::Frame;
use super::vertex_normal::FaceCorner;
use crate::color::Rgb;
use crate::scene::primitives::{self, Primitives};
use crate::scene::{Light, Material, Mesh, Scene, Tessellation, VertexNormals, View};
use glam::{DVec2, DVec3};
use std::sync::OnceLock;

/// A scene with its polygons, as its camera sees them.
#[derive(Clone, Debug)]
pub struct PreparedScene {
    pub scene: Scene,
    pub tessellation: Tessellation,
    pub view: View,
    /// By object, then by vertex of its mesh.
    vertices: Vec<Vec<PreparedVertex>>,
    /// Made when the first ray asks for them.
    primitives: OnceLock<Primitives>,
}

/// A vertex as the camera sees it.
#[derive(Clone, Copy, Debug)]
pub struct PreparedVertex {
    /// In the camera frame.
    pub camera: DVec3,
    /// On the screen; without meaning where the vertex lies before the near plane.
    pub screen: DVec2,
}

impl PreparedVertex {
    fn new(position: DVec3, view: &View) -> Self {
        let camera = view.to_camera(position);
        PreparedVertex {
            camera,
            screen: view.to_screen(camera),
        }
    }
}

/// One polygon of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Polygon<'a> {
    pub object: usize,
    /// Of the object's mesh.
    pub face: usize,
    /// Counted from 0 over all objects.
    pub number: usize,
    pub mesh: &'a Mesh,
    pub material: &'a Material,
    pub vertex_normals: VertexNormals,
    vertices: &'a [PreparedVertex],
}

/// The most polygons that a scene may become for the scan-line methods: ten million take about 4 GB.
const MAX_POLYGONS: u64 = 10_000_000;

impl PreparedScene {
    /// A scene in front of its own camera, in a picture of that size. Errors: why there is none.
    pub fn of_size(scene: Scene, [width, height]: [u32; 2]) -> Result<Self, String> {
        let Some(camera) = scene.camera else {
            return Err("camera: the key is missing; a picture needs a camera".into());
        };
        let polygons = Tessellation::count(&scene);
        if polygons > MAX_POLYGONS {
            return Err(format!(
                "objects: they divide into {polygons} polygons; at most {MAX_POLYGONS} are drawn"
            ));
        }
        let view = View::new(&camera, width, height);
        Ok(PreparedScene::new(scene, view))
    }

    /// `view` must be of the scene's own camera. Its near plane is set to a millionth of the distance to the nearest vertex, and nearer
    /// where a polygon larger than that passes by: so what is seen depends on no unit of length, nor on how far away the
    /// camera's target was put.
    pub fn new(scene: Scene, mut view: View) -> Self {
        let tessellation = Tessellation::of(&scene);
        let vertices: Vec<Vec<PreparedVertex>> = tessellation
            .meshes
            .iter()
            .map(|mesh| {
                let positions = (0..mesh.vertex_count() as u32).map(|vertex| mesh.position(vertex));
                positions
                    .map(|position| PreparedVertex::new(position, &view))
                    .collect()
            })
            .collect();
        let distances = vertices
            .iter()
            .flatten()
            .map(|vertex| vertex.camera.length());
        let nearest = distances
            .filter(|&distance| distance > 0.0)
            .fold(f64::INFINITY, f64::min);
        if nearest.is_finite() {
            view.near =
                (1e-6 * nearest).min(0.5 * least_depth(&tessellation, &view, 1e-12 * nearest));
        }
        PreparedScene {
            scene,
            tessellation,
            view,
            vertices,
            primitives: OnceLock::new(),
        }
    }

    /// The same under other lights.
    pub fn with_lights(self, lights: Vec<Light>) -> Self {
        let scene = Scene {
            lights,
            ..self.scene
        };
        PreparedScene { scene, ..self }
    }

    /// The objects as rays meet them.
    pub fn primitives(&self) -> &Primitives {
        self.primitives
            .get_or_init(|| Primitives::of(&self.scene, &self.tessellation))
    }

    pub fn entered(&self) -> Event {
        Event::Frame {
            width: self.view.width,
            height: self.view.height,
            ambient: self.scene.ambient,
        }
    }

    /// The frame before anything is drawn: its background.
    pub fn empty_frame(&self) -> Frame {
        Frame::new(self.view.width, 0..self.view.height, self.scene.background)
    }

    /// Polygon `number`, counted from 0 over all objects.
    pub fn polygon(&self, number: usize) -> Option<Polygon<'_>> {
        let (object, face) = self.tessellation.locate(number)?;
        let whole = &self.scene.objects[object];
        let material = &self.scene.materials[whole.material];
        Some(Polygon {
            object,
            face,
            number,
            mesh: &self.tessellation.meshes[object],
            material,
            vertex_normals: whole.vertex_normals,
            vertices: &self.vertices[object],
        })
    }

    /// The polygons that may touch what is looked at, in order. A polygon chosen by its number is always among them.
    pub fn polygons(&self, focus: Focus, region: &Region) -> impl Iterator<Item = Polygon<'_>> {
        let numbers = match focus {
            Focus::Polygon(only) => only..only.saturating_add(1),
            _ => 0..self.tessellation.polygon_count(),
        };
        let chosen = matches!(focus, Focus::Polygon(_));
        numbers
            .map_while(|number| self.polygon(number))
            .filter(move |polygon| chosen || polygon.may_touch(region, self.view.near))
    }
}

/// No polygon of whose plane the eye is off by more than `edge_on` is seen at a smaller depth: what the view shows at depth z is no further
/// away than z/cos θ, θ the angle of its corners, and no nearer than the plane.
fn least_depth(tessellation: &Tessellation, view: &View, edge_on: f64) -> f64 {
    let half = 0.5 * DVec2::new(view.width.into(), view.height.into()) / view.focal;
    let cos_theta = (1.0 + half.length_squared()).sqrt().recip();
    let distances = tessellation.meshes.iter().flat_map(|mesh| {
        (0..mesh.face_count()).map(|face| {
            let from_eye = mesh.position(mesh.face(face)[0]) - view.eye;
            from_eye.dot(mesh.normal(face)).abs()
        })
    });
    let nearest = distances.filter(|&distance| distance > edge_on);
    cos_theta * nearest.fold(f64::INFINITY, f64::min)
}

/// How every scan-line method walks the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Opens the frame; `ambient` is A, the ambient light of the scene.
    Frame {
        width: u32,
        height: u32,
        ambient: Rgb,
    },
    /// Opens a polygon, counted from 0 over all objects.
    Polygon { object: u32, polygon: u32 },
    /// Closes `Polygon`.
    PolygonDone,
    /// Closes `Frame`.
    FrameDone,
}

impl<'a> Polygon<'a> {
    pub fn entered(&self) -> Event {
        Event::Polygon {
            object: self.object as u32,
            polygon: self.number as u32,
        }
    }

    /// Its vertices in order, with their indices in the mesh.
    pub fn corners(&self) -> impl Iterator<Item = (u32, PreparedVertex)> + 'a {
        let vertices = self.vertices;
        self.mesh
            .face(self.face)
            .iter()
            .map(|&vertex| (vertex, vertices[vertex as usize]))
    }

    pub fn corner_count(&self) -> usize {
        self.mesh.face(self.face).len()
    }

    pub fn corner(&self, corner: usize) -> FaceCorner<'a> {
        FaceCorner {
            mesh: self.mesh,
            face: self.face,
            corner,
        }
    }

    /// Its division into triangles, by corner.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        primitives::triangles(self.mesh, self.face)
    }

    /// Whether its box on the screen meets the region; true where a part lies before the near plane.
    fn may_touch(&self, region: &Region, near: f64) -> bool {
        let mut low = DVec2::INFINITY;
        let mut high = DVec2::NEG_INFINITY;
        let mut behind = 0;
        for (_, vertex) in self.corners() {
            if vertex.camera.z < near {
                behind += 1;
            } else {
                low = low.min(vertex.screen);
                high = high.max(vertex.screen);
            }
        }
        if behind > 0 {
            return behind < self.mesh.face(self.face).len();
        }
        high.x >= f64::from(region.columns.start)
            && low.x <= f64::from(region.columns.end)
            && high.y >= f64::from(region.rows.start)
            && low.y <= f64::from(region.rows.end)
    }
}
