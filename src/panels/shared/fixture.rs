//! Small runs that the tests of panels look at.

use super::strings::Language;
use crate::algorithms::enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::Settings;
use crate::algorithms::radiosity::Solver;
use crate::color::Rgb;
use crate::methods::Setup;
use crate::panels::PanelInput;
use crate::record::RecordingLimit;
use crate::render::{Finished, Method, render};
use crate::replay::Run;
use crate::scene::{
    self, Camera, Highlight, Light, Limits, Material, Mesh, Object, Scene, Shape, VertexNormals,
    View,
};
use glam::{DVec2, DVec3};
use std::num::{NonZeroU32, NonZeroUsize};
use std::sync::Arc;

/// A recorded run with the finished picture.
pub struct Fixture {
    pub run: Run,
    pub finished: Finished,
    pub focus: Focus,
}

impl Fixture {
    /// One triangle, grey, 48×36 pixels, the whole of it recorded.
    pub fn triangle(method: Method) -> Self {
        let shape = Shape::Polygon {
            vertices: [[-0.58, 0.91, 0.0], [-1.44, -0.23, 0.0], [1.29, -0.68, 0.0]]
                .map(DVec3::from)
                .to_vec(),
        };
        let scene = scene(shape, Rgb::splat(0.7), Highlight::Blinn);
        Fixture::of(scene, method, Focus::Polygon(0), (48, 36))
    }

    /// A red pyramid of four faces around one vertex, 640×480 pixels, its first face recorded.
    pub fn pyramid(method: Method) -> Self {
        Fixture::of(pyramid(&[]), method, Focus::Polygon(0), (640, 480))
    }

    /// The same with vertex normals of a mesh file.
    pub fn pyramid_with_normals(method: Method) -> Self {
        let mut scene = pyramid(&[DVec3::Z; 12]);
        scene.objects[0].vertex_normals = VertexNormals::File;
        Fixture::of(scene, method, Focus::Polygon(0), (640, 480))
    }

    /// Two triangles, of which one turns its back to the eye; the normals of either's corners cancel out. 32×24, the whole frame.
    pub fn cancelling_normals(method: Method) -> Self {
        let third = |turn: f64| DVec3::new(turn.cos(), turn.sin(), 0.0);
        let normals: Vec<DVec3> = (0..6)
            .map(|corner| third(f64::from(corner) * std::f64::consts::TAU / 3.0))
            .collect();
        let mut scene = mesh(&[[0, 1, 2], [0, 4, 3]], &normals);
        scene.objects[0].vertex_normals = VertexNormals::File;
        Fixture::of(scene, method, Focus::Frame, (32, 24))
    }

    /// A glass ball, a glass cube and a red ball on a mirroring checkered floor, under a light ball and a dim light; 640×480
    /// pixels, one of them recorded and none finished, which would take seconds.
    pub fn rays(method: Method, pixel: (u32, u32), depth: u32) -> Self {
        Fixture::rays_of(rays_scene(), method, pixel, depth)
    }

    /// As [`Fixture::rays`], of another scene.
    pub fn rays_of(scene: Scene, method: Method, pixel: (u32, u32), depth: u32) -> Self {
        let [fixture] = Fixture::pixels_of(scene, method, [pixel], depth);
        fixture
    }

    /// Several pixels of one scene.
    pub fn pixels_of<const N: usize>(
        scene: Scene,
        method: Method,
        pixels: [(u32, u32); N],
        depth: u32,
    ) -> [Self; N] {
        let settings = Settings {
            depth: NonZeroU32::new(depth).expect("a depth is at least 1"),
            ..Settings::default()
        };
        let setup = Setup::new(prepared(scene, (640, 480)), settings);
        pixels.map(|(x, y)| {
            let focus = Focus::Pixel { x, y };
            let picture = setup.prepared.empty_frame();
            Fixture::recorded(setup.clone(), picture, method, focus)
        })
    }

    /// A red ball over a white floor under a lamp, 64 patches, whose light `solver` finds; 640×480 pixels, none finished.
    pub fn room(solver: Solver, focus: Focus) -> Self {
        let scene = scene::read(
            include_bytes!("sample/room.json"),
            &Limits::default(),
            &mut |_| Ok(Vec::new()),
        );
        Fixture::room_of(scene.expect("the sample is a scene"), solver, focus)
    }

    /// As [`Fixture::room`], of another scene.
    pub fn room_of(scene: Scene, solver: Solver, focus: Focus) -> Self {
        let settings = enclosure::Settings {
            solver,
            ..enclosure::Settings::default()
        };
        let setup = Setup::new(prepared(scene, (640, 480)), settings);
        let picture = setup.prepared.empty_frame();
        Fixture::recorded(setup, picture, Method::Radiosity, focus)
    }

    pub fn of(scene: Scene, method: Method, focus: Focus, size: (u32, u32)) -> Self {
        Fixture::with_settings(scene, method, focus, size, Settings::default())
    }

    pub fn with_settings(
        scene: Scene,
        method: Method,
        focus: Focus,
        size: (u32, u32),
        settings: Settings,
    ) -> Self {
        let setup = Setup::new(prepared(scene, size), settings);
        Fixture::rendered(setup, method, focus)
    }

    /// A run of `method`, with its finished picture.
    pub fn rendered(setup: Setup, method: Method, focus: Focus) -> Self {
        let picture = render(&setup, method, NonZeroUsize::MIN, &|_, _| {});
        Fixture::recorded(setup, picture, method, focus)
    }

    /// A run of `method` with another finished picture.
    pub fn recorded(setup: Setup, picture: Frame, method: Method, focus: Focus) -> Self {
        let finished = Finished::new(picture, &setup.prepared.scene.lights);
        let limit = RecordingLimit::default();
        Fixture {
            run: Run::record(Arc::new(setup), method, focus, limit),
            finished,
            focus,
        }
    }

    pub fn input(&self) -> PanelInput<'_> {
        PanelInput::of(&self.run, &self.finished, self.focus, Language::English)
    }

    /// Goes to the `n`-th event of a kind, counted from 0.
    pub fn go_to(&mut self, kind: &str, n: usize) -> &mut Self {
        let walk = self.run.walk_mut();
        let step = (0..walk.len())
            .filter(|&step| walk.kind(step) == kind)
            .nth(n)
            .expect("the run has such an event");
        walk.seek(step);
        self
    }
}

/// Pixels of [`Fixture::rays`]. Through the glass ball to the cube, where total internal reflection follows, and to the floor,
/// which the cube shades; 14 rays at depth 5.
pub const BALL: (u32, u32) = (380, 270);
/// A spot of the glass ball that mirrors the light ball.
pub const SPARK: (u32, u32) = (250, 231);
/// The floor, which mirrors the red ball.
pub const FLOOR: (u32, u32) = (480, 400);
/// The background.
pub const SKY: (u32, u32) = (320, 20);

/// The scene of [`Fixture::rays`].
pub fn rays_scene() -> Scene {
    let cube = include_bytes!("sample/cube.obj");
    let scene = include_bytes!("sample/rays.json");
    let read = scene::read(scene, &Limits::default(), &mut |_| Ok(cube.to_vec()));
    read.expect("the sample is a scene")
}

fn prepared(scene: Scene, (width, height): (u32, u32)) -> PreparedScene {
    let camera = scene.camera.expect("a sample has a camera");
    PreparedScene::new(scene, View::new(&camera, width, height))
}

/// An object seen from straight ahead, lit by one lamp near it.
fn scene(shape: Shape, diffuse: Rgb, highlight: Highlight) -> Scene {
    Scene {
        background: Rgb::splat(0.02),
        camera: Some(Camera {
            eye: DVec3::new(0.0, 0.0, 5.0),
            target: DVec3::ZERO,
            up: DVec3::Y,
            fov_x: 40_f64.to_radians(),
        }),
        materials: vec![Material {
            name: "clay".to_string(),
            ambient: diffuse * 0.1,
            diffuse,
            specular: Rgb::splat(0.3),
            shininess: 12.0,
            highlight,
            reflectance: diffuse,
            ..Material::default()
        }],
        objects: vec![Object::new("thing", 0, shape)],
        lights: vec![Light::Point {
            position: DVec3::new(-1.2, 1.6, 1.4),
            color: Rgb::WHITE,
            attenuation: [1.0, 0.0, 0.0],
            radius: 0.0,
        }],
        ..Scene::default()
    }
}

/// A pyramid, with unit normals at the corners of its faces, or none.
fn pyramid(normals: &[DVec3]) -> Scene {
    mesh(&[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]], normals)
}

/// Faces between the vertices of the pyramid.
fn mesh(faces: &[[u32; 3]], normals: &[DVec3]) -> Scene {
    let positions = [
        [0.1, 0.1, 1.0],
        [-1.0, -0.8, 0.0],
        [1.0, -0.7, 0.0],
        [0.9, 0.8, 0.1],
        [-0.8, 0.9, 0.0],
    ]
    .map(DVec3::from);
    let no_uvs: [DVec2; 0] = [];
    let shape = Shape::Mesh(Mesh::with_normals(
        &positions,
        faces.iter().copied(),
        &no_uvs,
        normals,
    ));
    scene(shape, Rgb::new(0.7, 0.2, 0.1), Highlight::Phong)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pixels_show_what_is_said_of_them() {
        let kinds = |pixel| {
            let fixture = Fixture::rays(Method::RayTracing, pixel, 5);
            let walk = fixture.run.walk();
            (0..walk.len())
                .map(|step| walk.kind(step))
                .collect::<Vec<_>>()
        };
        let has = |kinds: &[&str], kind| kinds.contains(&kind);
        let ball = kinds(BALL);
        assert!(has(&ball, "TotalInternalReflection") && has(&ball, "BranchEnded"));
        assert_eq!(ball.iter().filter(|kind| **kind == "Ray").count(), 14);
        assert!(has(&kinds(SPARK), "LightMet"));
        assert!(has(&kinds(FLOOR), "Shadow"));
        assert!(!has(&kinds(SKY), "SurfaceMet"));
    }
}
