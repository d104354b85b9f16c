//! The values in formulas that no event records, because the scene states them.

mod camera;
mod corner;
mod intersection;
mod light;
mod texture;
mod true_surface;
mod vertex;

use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::form_factor::Method;
use crate::algorithms::form_factor::polygon::Polygon;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::record::{Fields, Value};
use glam::DVec3;

/// The recorded values of a step, by name.
pub type Recorded<'a> = &'a dyn Fn(&str) -> Option<Value>;

/// What a run is about.
#[derive(Clone, Copy)]
pub struct Given<'a> {
    pub prepared: &'a PreparedScene,
    /// Of runs of radiosity.
    pub enclosure: Option<&'a Enclosure>,
    /// What the step itself recorded.
    pub own: &'a Fields,
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
        let families = [
            camera::VALUES,
            light::VALUES,
            corner::VALUES,
            intersection::VALUES,
            texture::VALUES,
            true_surface::VALUES,
            vertex::VALUES,
            PATCHES,
        ];
        let mut values = families.into_iter().flatten();
        values.find(|value| value.name == name)
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

const FAN: &str = "(P_k − P_0) × (P_{k+1} − P_0)";

const PATCHES: &[SceneValue] = &[
    value("area_of_i", "A_i", |given, recorded| {
        area(given, recorded, "i")
    }),
    value("area_of_j", "A_j", |given, recorded| {
        area(given, recorded, "j")
    }),
    value("corners_of_i", "P_k", |given, recorded| {
        Some(vectors(whole(given, recorded, ["i", "area_i"])?))
    }),
    value("corners_of_j", "P_k", |given, recorded| {
        Some(vectors(whole(given, recorded, ["j", "area_j"])?))
    }),
    value("fan_of_i", FAN, |given, recorded| {
        Some(vectors(&fan(whole(given, recorded, ["i", "area_i"])?)))
    }),
    value("fan_of_j", FAN, |given, recorded| {
        Some(vectors(&fan(whole(given, recorded, ["j", "area_j"])?)))
    }),
    value("matrix_F_ij", "F_{ij}", |given, recorded| {
        let enclosure = given.enclosure?;
        let (i, j) = (index(recorded, "i")?, index(recorded, "j")?);
        one(*enclosure.matrix()?.get(i * enclosure.patches.len() + j)?)
    }),
    value("normal_at_x", "N_x", |given, recorded| {
        normal_at(given, recorded, "x")
    }),
    value("normal_at_y", "N_y", |given, recorded| {
        normal_at(given, recorded, "y")
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

fn vector(recorded: Recorded, name: &str) -> Option<DVec3> {
    match recorded(name)? {
        Value::Vector(vector) => Some(vector),
        _ => None,
    }
}

fn index(recorded: Recorded, name: &str) -> Option<usize> {
    match recorded(name)? {
        Value::Integer(number) => usize::try_from(number).ok(),
        _ => None,
    }
}

fn area(given: Given, recorded: Recorded, patch: &str) -> Option<Vec<Value>> {
    let patches = &given.enclosure?.patches;
    let patch = index(recorded, patch).filter(|&patch| patch < patches.len())?;
    one(patches[patch].area)
}

/// The corners of a patch of one piece, of which the whole has the recorded area.
fn whole<'a>(
    given: Given<'a>,
    recorded: Recorded,
    [patch, area]: [&str; 2],
) -> Option<&'a [DVec3]> {
    let patches = &given.enclosure?.patches;
    let patch = index(recorded, patch).filter(|&patch| patch < patches.len())?;
    let mut pieces = patches.pieces(patch);
    let piece = pieces.next().filter(|_| pieces.len() == 0)?;
    let polygon = Polygon::new(piece.corners.into(), piece.normal)?;
    (polygon.area == number(recorded, area)?).then_some(piece.corners)
}

/// Between its corners and the first, each twice the area of a triangle as long.
fn fan(corners: &[DVec3]) -> Vec<DVec3> {
    let pairs = corners[1..].windows(2);
    let product = |pair: &[DVec3]| (pair[0] - corners[0]).cross(pair[1] - corners[0]);
    pairs.map(product).collect()
}

fn vectors(vectors: &[DVec3]) -> Vec<Value> {
    vectors.iter().copied().map(Value::from).collect()
}

/// The normal of the piece of patch i or j that a point lies on: that whose plane it is nearest to.
fn normal_at(given: Given, recorded: Recorded, point: &str) -> Option<Vec<Value>> {
    let patches = &given.enclosure?.patches;
    let point = vector(recorded, point)?;
    let both = [index(recorded, "i")?, index(recorded, "j")?];
    let pieces = both.into_iter().flat_map(|patch| patches.pieces(patch));
    let height = |corner: DVec3, normal: DVec3| (point - corner).dot(normal).abs();
    let found = pieces
        .min_by(|a, b| height(a.corners[0], a.normal).total_cmp(&height(b.corners[0], b.normal)));
    one(found?.normal)
}

fn form_factors(given: Given) -> Option<Method> {
    Some(given.enclosure?.settings.form_factors)
}
