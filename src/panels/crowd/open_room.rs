//! A small room with every kind of event of radiosity and of form factors.

use super::{material, object, scene};
use crate::algorithms::focus::Focus;
use crate::algorithms::form_factor::Method as Integration;
use crate::algorithms::form_factor::hemicube::Hemicubes;
use crate::algorithms::frame::Frame;
use crate::algorithms::radiosity::{Solver, Stop};
use crate::algorithms::room;
use crate::algorithms::stage::Stage;
use crate::color::Rgb;
use crate::panels::sample::Sample;
use crate::record::RecordingLimit;
use crate::render::Method;
use crate::replay::Run;
use crate::scene::{Highlight, Shape, View};
use glam::DVec3;
use std::sync::Arc;

/// Patches of [`open_room`].
pub const FLOOR: [u32; 2] = [0, 1];
pub const WALLS: [u32; 2] = [2, 3];
pub const LAMP: u32 = 4;
pub const TILE: u32 = 6;

/// A floor of two patches between two walls, a lamp above, a screen that stands between the walls, a small tile far away. Red
/// and green are alike, and nothing emits blue.
pub fn open_room(radiosity: room::Settings, focus: Focus) -> Sample {
    let surface = |name: &str, reflectance: f64, emission: f64| {
        let mut material = material(name, Rgb::splat(reflectance), Highlight::Blinn);
        material.reflectance = Rgb::new(reflectance, reflectance, 0.5 * reflectance);
        material.emission = Rgb::new(emission, emission, 0.0);
        material
    };
    let polygon = |corners: [[f64; 3]; 4]| Shape::Polygon {
        vertices: corners.map(DVec3::from).to_vec(),
    };
    let floor = [
        [-1.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 0.0, -1.0],
        [-1.0, 0.0, -1.0],
    ];
    let left = [
        [-1.0, 0.0, 1.0],
        [-1.0, 0.0, -1.0],
        [-1.0, 2.0, -1.0],
        [-1.0, 2.0, 1.0],
    ];
    let right = [
        [1.0, 0.0, -1.0],
        [1.0, 0.0, 1.0],
        [1.0, 2.0, 1.0],
        [1.0, 2.0, -1.0],
    ];
    let lamp = [
        [0.2, 2.0, -0.3],
        [0.8, 2.0, -0.3],
        [0.8, 2.0, 0.3],
        [0.2, 2.0, 0.3],
    ];
    let screen = [
        [0.0, 0.4, 0.9],
        [0.0, 0.4, -0.9],
        [0.0, 1.6, -0.9],
        [0.0, 1.6, 0.9],
    ];
    let tile = [
        [0.1, 6.0, 0.0],
        [0.2, 6.0, 0.0],
        [0.2, 6.0, 0.1],
        [0.1, 6.0, 0.1],
    ];
    let mut objects = vec![
        object("floor of tiles", 0, polygon(floor)),
        object("left wall", 1, polygon(left)),
        object("right wall", 1, polygon(right)),
        object("lamp", 2, polygon(lamp)),
        object("screen", 1, polygon(screen)),
        object("tile", 0, polygon(tile)),
    ];
    objects[0].patches = [2, 1];
    let materials = vec![
        surface("grey", 0.6, 0.0),
        surface("paint", 0.4, 0.0),
        surface("light", 0.0, 1.0),
    ];
    let scene = scene(materials, objects, Vec::new());
    let camera = scene.camera.expect("the room has a camera");
    let stage = Stage::new(scene, View::new(&camera, 16, 12)).with_radiosity(radiosity);
    Sample {
        finished: Frame::new(16, 0..12, stage.scene.background),
        run: Run::record(
            Arc::new(stage),
            Method::Radiosity,
            focus,
            RecordingLimit::default(),
        ),
        focus,
    }
}

/// The light of [`open_room`] by every solver, and by one that is stopped too early.
pub fn solvers() -> Vec<Sample> {
    let stop = |max_iterations| Stop {
        tolerance: 1e-3,
        max_iterations,
    };
    let solved = Solver::ALL.map(|solver| (solver, stop(1000)));
    let stopped = [(Solver::Jacobi, stop(1))];
    let samples = solved.into_iter().chain(stopped).map(|(solver, stop)| {
        let settings = room::Settings {
            solver,
            stop,
            ..room::Settings::default()
        };
        open_room(settings, Focus::Frame)
    });
    samples.collect()
}

/// Form factors of [`open_room`] by every method: of patches that touch, face away, are far, are small, are parted by the screen.
pub fn form_factors() -> Vec<Sample> {
    let auto = |tolerance| Integration::Auto { tolerance };
    let rays = Integration::MonteCarlo { rays: 64, seed: 0 };
    let hemicube = Integration::Hemicube(Hemicubes {
        resolution: 16,
        points: 1,
    });
    let [left, right] = WALLS;
    [
        (auto(1e-6), FLOOR[0], left),
        (auto(1e-6), FLOOR[0], FLOOR[1]),
        (auto(1e-2), TILE, FLOOR[0]),
        (auto(1e-6), LAMP, FLOOR[0]),
        (Integration::AreaToArea { points: 2 }, FLOOR[0], left),
        (Integration::ElementToPolygon { points: 2 }, FLOOR[0], LAMP),
        (Integration::Contour { tolerance: 1e-6 }, FLOOR[0], left),
        (Integration::Contour { tolerance: 1e-6 }, left, right),
        (rays, left, right),
        (hemicube, left, right),
        (hemicube, FLOOR[0], left),
    ]
    .map(|(form_factors, i, j)| {
        let settings = room::Settings {
            form_factors,
            ..room::Settings::default()
        };
        open_room(settings, Focus::FormFactor { i, j })
    })
    .into()
}
