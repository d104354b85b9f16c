//! Form factors with something in the way, against references that share nothing with how they are found.

mod cards;
mod exact;
mod gratings;
mod halves;
mod openings;
mod partitions;
mod profiles;
mod rooms;

use lightwalk::algorithms::form_factor::{Blockers, FormFactors, Method};
use lightwalk::record::Unrecorded;
use lightwalk::scene::patches::Patches;
use lightwalk::scene::{Limits, Scene, read};

const UNIT: [f64; 2] = [0.0, 1.0];
/// Wide enough for every shadow of what stands half way between unit squares.
const WIDE: [f64; 2] = [-4.0, 5.0];

/// A convex polygon, counter-clockwise seen from its front.
type Corners = Vec<[f64; 3]>;

/// A horizontal rectangle, seen from above.
fn floor(x: [f64; 2], y: f64, z: [f64; 2]) -> Corners {
    vec![
        [x[0], y, z[0]],
        [x[0], y, z[1]],
        [x[1], y, z[1]],
        [x[1], y, z[0]],
    ]
}

/// A horizontal rectangle, seen from below.
fn lid(x: [f64; 2], y: f64, z: [f64; 2]) -> Corners {
    turned(floor(x, y, z))
}

/// A rectangle across the x axis, seen from where x is larger.
fn wall(x: f64, y: [f64; 2], z: [f64; 2]) -> Corners {
    vec![
        [x, y[0], z[0]],
        [x, y[1], z[0]],
        [x, y[1], z[1]],
        [x, y[0], z[1]],
    ]
}

/// The same polygon, seen from its other side.
fn turned(mut corners: Corners) -> Corners {
    corners.reverse();
    corners
}

/// A rectangle in the plane of two vectors, by its sides in units of those.
fn parallelogram(origin: [f64; 3], [u, v]: [[f64; 3]; 2], [of_u, of_v]: [[f64; 2]; 2]) -> Corners {
    let at = |s: f64, t: f64| std::array::from_fn(|k| origin[k] + s * u[k] + t * v[k]);
    let [[u0, u1], [v0, v1]] = [of_u, of_v];
    vec![at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)]
}

/// A rectangle of parameters around a hole in it, in four rectangles.
fn around(hole: [[f64; 2]; 2], [of_u, of_v]: [[f64; 2]; 2]) -> [[[f64; 2]; 2]; 4] {
    let [u, v] = hole;
    [
        [[of_u[0], u[0]], of_v],
        [[u[1], of_u[1]], of_v],
        [u, [of_v[0], v[0]]],
        [u, [v[1], of_v[1]]],
    ]
}

fn scene(polygons: &[(Corners, u32)]) -> Scene {
    let object = |(number, (corners, patches)): (usize, &(Corners, u32))| {
        format!(
            r#"{{"name": "{number}", "material": "m", "polygon": {{"vertices": {corners:?}}}, "patches": {patches}}}"#
        )
    };
    let objects: Vec<String> = polygons.iter().enumerate().map(object).collect();
    let text = format!(
        r#"{{"schema": 1, "materials": {{"m": {{}}}}, "objects": [{}]}}"#,
        objects.join(", ")
    );
    let mut no_file = |_: &str| Err("no such file".into());
    let limits = Limits {
        max_patches: 200_000,
        ..Limits::default()
    };
    read(text.as_bytes(), &limits, &mut no_file).unwrap()
}

const METHOD: Method = Method::Auto { tolerance: 1e-6 };

/// F from the first of the polygons to the second, and from the second to the first.
fn found(polygons: &[Corners]) -> [f64; 2] {
    let whole = |corners: &Corners| (corners.clone(), 1);
    let scene = scene(&polygons.iter().map(whole).collect::<Vec<_>>());
    let patches = Patches::of(&scene, 10_000).unwrap();
    let blockers = Blockers::of(&scene, &patches);
    let factors = FormFactors::new(&patches, METHOD, Some(&blockers));
    [[0, 1], [1, 0]].map(|[i, j]| factors.pair(i, j, &mut Unrecorded))
}

/// That what the first of the polygons exchanges with the second is right: F within 1e-4 either way, and within 1 % above 1e-5.
fn assert_exchange(name: &str, polygons: &[Corners], right: f64) {
    let forth_and_back = found(polygons);
    for (k, f) in forth_and_back.into_iter().enumerate() {
        assert_right(name, f, right / exact::area(&polygons[k]));
    }
}

fn assert_right(name: &str, found: f64, right: f64) {
    let error = (found - right).abs();
    println!(
        "{name}: {found:.6e} for {right:.6e}, off by {error:.1e}, {:.1e} of it",
        error / right
    );
    assert!(
        error <= 1e-4 && (right <= 1e-5 || error <= 0.01 * right),
        "{name}: {found} for {right}"
    );
}
