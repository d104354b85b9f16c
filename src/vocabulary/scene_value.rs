//! The values in formulas that no event records, because the scene states them.

use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::form_factor::Method;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::record::Value;
use crate::scene::Light;
use glam::{DVec2, DVec3};

/// The recorded values of a step, by name.
pub type Recorded<'a> = &'a dyn Fn(&str) -> Option<Value>;

/// What a run is about.
#[derive(Clone, Copy)]
pub struct Given<'a> {
    pub prepared: &'a PreparedScene,
    /// Of runs of radiosity.
    pub enclosure: Option<&'a Enclosure>,
}

/// A named value of the scene, or several.
pub struct SceneValue {
    pub name: &'static str,
    /// In the notation of [`math`](crate::picture::math()).
    pub symbol: &'static str,
    find: fn(Given, Recorded) -> Option<Vec<Value>>,
}

impl SceneValue {
    pub fn named(name: &str) -> Option<&'static SceneValue> {
        SCENE_VALUES.iter().find(|value| value.name == name)
    }

    /// At a step that recorded these values.
    pub fn at(&self, given: Given, recorded: Recorded) -> Option<Vec<Value>> {
        (self.find)(given, recorded)
    }
}

const fn value(
    name: &'static str,
    symbol: &'static str,
    find: fn(Given, Recorded) -> Option<Vec<Value>>,
) -> SceneValue {
    SceneValue { name, symbol, find }
}

const SCENE_VALUES: [SceneValue; 15] = [
    value("eye", "eye", |given, _| one(given.prepared.view.eye)),
    value("forward", "forward", |given, _| {
        one(given.prepared.view.forward)
    }),
    value("light_position", "light", |given, recorded| {
        one(light(given.prepared, recorded)?.0)
    }),
    value("light_a_0", "a_0", |given, recorded| {
        one(light(given.prepared, recorded)?.1[0])
    }),
    value("light_a_1", "a_1", |given, recorded| {
        one(light(given.prepared, recorded)?.1[1])
    }),
    value("light_a_2", "a_2", |given, recorded| {
        one(light(given.prepared, recorded)?.1[2])
    }),
    value("screen_point", "P_s", |given, recorded| {
        let place = DVec2::new(number(recorded, "x_P")?, number(recorded, "y_P")?);
        one(given
            .prepared
            .view
            .from_screen(place, given.prepared.view.focal))
    }),
    value("pixel_direction", "u", |given, recorded| {
        let pixel = DVec2::new(number(recorded, "x")?, number(recorded, "y")?);
        let point = given
            .prepared
            .view
            .from_screen(pixel + 0.5, given.prepared.view.focal);
        one((point - given.prepared.view.eye).normalize())
    }),
    value("polygon_corners", "P_k", |given, recorded| {
        Some(
            corners(given.prepared, recorded)?
                .into_iter()
                .map(Value::from)
                .collect(),
        )
    }),
    value("corner_count", "n", |given, recorded| {
        one(corners(given.prepared, recorded)?.len() as f64)
    }),
    value("area_of_i", "A_i", |given, recorded| {
        area(given, recorded, "i")
    }),
    value("area_of_j", "A_j", |given, recorded| {
        area(given, recorded, "j")
    }),
    value("matrix_F_ij", "F_{ij}", |given, recorded| {
        let enclosure = given.enclosure?;
        let (i, j) = (index(recorded, "i")?, index(recorded, "j")?);
        one(*enclosure.matrix()?.get(i * enclosure.patches.len() + j)?)
    }),
    value("ray_count", "n", |given, _| match form_factors(given)? {
        Method::MonteCarlo { rays, .. } => one(rays),
        _ => None,
    }),
    value("hemicube_points", "n", |given, _| {
        match form_factors(given)? {
            Method::Hemicube(hemicubes) => one(hemicubes.points * hemicubes.points),
            _ => None,
        }
    }),
];

fn one(value: impl Into<Value>) -> Option<Vec<Value>> {
    Some(vec![value.into()])
}

fn number(recorded: Recorded, name: &str) -> Option<f64> {
    match recorded(name)? {
        Value::Number(number) => Some(number),
        Value::Integer(number) => Some(number as f64),
        _ => None,
    }
}

fn index(recorded: Recorded, name: &str) -> Option<usize> {
    match recorded(name)? {
        Value::Integer(number) => usize::try_from(number).ok(),
        _ => None,
    }
}

/// Position and attenuation of the point light of the step.
fn light(prepared: &PreparedScene, recorded: Recorded) -> Option<(DVec3, [f64; 3])> {
    match *prepared.scene.lights.get(index(recorded, "light")?)? {
        Light::Point {
            position,
            attenuation,
            ..
        } => Some((position, attenuation)),
        Light::Directional { .. } => None,
    }
}

/// The corners of the step's polygon, in the world.
fn corners(prepared: &PreparedScene, recorded: Recorded) -> Option<Vec<DVec3>> {
    let polygon = prepared.polygon(index(recorded, "polygon")?)?;
    let corners = polygon.corners();
    Some(
        corners
            .map(|(vertex, _)| polygon.mesh.position(vertex))
            .collect(),
    )
}

fn area(given: Given, recorded: Recorded, patch: &str) -> Option<Vec<Value>> {
    let patches = &given.enclosure?.patches;
    let patch = index(recorded, patch).filter(|&patch| patch < patches.len())?;
    one(patches[patch].area)
}

fn form_factors(given: Given) -> Option<Method> {
    Some(given.enclosure?.settings.form_factors)
}
