//! Rooms whose light is known exactly: what `radiosity` says of its error holds, and in closed rooms light is neither lost nor gained.

mod furniture;
pub mod rectangles;

use lightwalk::algorithms::accuracy::Accuracy;
use lightwalk::algorithms::enclosure::{Enclosure, Settings};
use lightwalk::scene::{Limits, Parts, read};
use rectangles::{Rectangle, exchange};

/// Random numbers in [0, 1), the same every time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Between 1 − 10^−a and 1 − 10^−b, evenly in the exponent: so that every order of loss has its share.
    fn reflectance(&mut self, a: f64, b: f64) -> f64 {
        1.0 - 10_f64.powf(-self.between(a, b))
    }
}

/// One object: its corners from its front, how finely it is divided, ρ and E.
struct Face {
    corners: [[f64; 3]; 4],
    patches: [u32; 2],
    rho: f64,
    emission: f64,
}

const FACES: [[usize; 4]; 6] = [
    [0, 1, 3, 2],
    [5, 4, 6, 7],
    [4, 0, 2, 6],
    [1, 5, 7, 3],
    [4, 5, 1, 0],
    [2, 3, 7, 6],
];

/// The faces of a box, from inside or from outside.
fn cuboid(low: [f64; 3], high: [f64; 3], is_block: bool) -> impl Iterator<Item = [[f64; 3]; 4]> {
    let corner = move |bits: usize| -> [f64; 3] {
        std::array::from_fn(|axis| {
            if bits >> axis & 1 == 1 {
                high[axis]
            } else {
                low[axis]
            }
        })
    };
    FACES.into_iter().map(move |corners| {
        let mut corners = corners.map(corner);
        if is_block {
            corners.reverse();
        }
        corners
    })
}

fn enclosure(faces: &[Face], closure: bool) -> Enclosure {
    let grey = |value: f64| [value; 3];
    let materials = faces.iter().enumerate().map(|(k, face)| {
        let (rho, emission) = (grey(face.rho), grey(face.emission));
        format!(r#""{k}": {{"reflectance": {rho:?}, "emission": {emission:?}}}"#)
    });
    let objects = faces.iter().enumerate().map(|(k, face)| {
        let Face { corners, patches, .. } = face;
        format!(r#"{{"name": "{k}", "material": "{k}", "polygon": {{"vertices": {corners:?}}}, "patches": {patches:?}}}"#)
    });
    let text = format!(
        r#"{{"schema": 1, "materials": {{{}}}, "objects": [{}]}}"#,
        materials.collect::<Vec<_>>().join(", "),
        objects.collect::<Vec<_>>().join(", ")
    );
    let mut no_file = |_: &str| Err("no such file".into());
    let scene = read(text.as_bytes(), &Limits::default(), &mut no_file).unwrap();
    let settings = Settings {
        closure,
        ..Settings::default()
    };
    Enclosure::of(&scene, settings, Parts::NONE).unwrap()
}

/// B of every patch, and the bound of its error.
fn solved(enclosure: &Enclosure) -> (Vec<f64>, f64) {
    let matrix = enclosure.matrix_or(|| enclosure.form_factors().estimated());
    let light = enclosure.light(matrix).unwrap();
    let accuracy = Accuracy::of(enclosure.exchange().unwrap(), None);
    let [bound, ..] = accuracy.total_errors(enclosure, light);
    let radiosity = light.radiosity.iter().map(|b| b.channels()[0]).collect();
    (radiosity, bound.unwrap())
}

fn largest_difference(b: &[f64], exact: impl Fn(usize) -> f64) -> f64 {
    let differences = b.iter().enumerate().map(|(i, b)| (b - exact(i)).abs());
    differences.fold(0.0, f64::max)
}

/// A room, and in it `blocks` blocks that do not touch, in which every surface gives off what it does not reflect: B = 1.
fn furnace(
    blocks: usize,
    random: &mut Random,
    mut rho: impl FnMut(&mut Random) -> f64,
) -> Vec<Face> {
    let size: [f64; 3] = std::array::from_fn(|_| random.between(0.5, 2.0));
    let mut faces: Vec<[[f64; 3]; 4]> = cuboid([0.0; 3], size, false).collect();
    for block in 0..blocks {
        // Each in a part of the room of its own, along x.
        let part = size[0] / blocks as f64;
        let mut ends = |low: f64, width: f64| {
            let start = low + width * random.between(0.1, 0.5);
            [start, start + width * random.between(0.1, 0.4)]
        };
        let [x, y, z] = [
            ends(block as f64 * part, part),
            ends(0.0, size[1]),
            ends(0.0, size[2]),
        ];
        faces.extend(cuboid([x[0], y[0], z[0]], [x[1], y[1], z[1]], true));
    }
    let mut face = |(k, corners)| {
        let rho = rho(random);
        Face {
            corners,
            patches: if k < 6 {
                [2, 1 + (random.next() * 2.0) as u32]
            } else {
                [1, 1]
            },
            rho,
            emission: 1.0 - rho,
        }
    };
    faces.into_iter().enumerate().map(&mut face).collect()
}

/// An empty box, its walls in parts that each have their own ρ and E; and its B, from form factors in closed form.
fn empty_box(random: &mut Random) -> (Vec<Face>, Vec<f64>) {
    let size: [f64; 3] = std::array::from_fn(|_| random.between(0.5, 2.0));
    let mut faces = Vec::new();
    let mut parts = Vec::new();
    for (wall, corners) in cuboid([0.0; 3], size, false).enumerate() {
        let [a, b, _, d] = corners;
        let cut = random.between(0.2, 0.8);
        for [start, end] in [[0.0, cut], [cut, 1.0]] {
            // A part of the wall along its first edge.
            let at = |u: f64, v: f64| -> [f64; 3] {
                std::array::from_fn(|k| a[k] + u * (b[k] - a[k]) + v * (d[k] - a[k]))
            };
            let corners = [at(start, 0.0), at(end, 0.0), at(end, 1.0), at(start, 1.0)];
            let rho = random.reflectance(0.1, 3.0);
            faces.push(Face {
                corners,
                patches: [1, 1],
                rho,
                emission: random.next(),
            });
            let axis = [2, 2, 0, 0, 1, 1][wall];
            let interval = |k: usize| {
                let ends = corners.map(|corner| corner[k]);
                [
                    ends.into_iter().fold(f64::INFINITY, f64::min),
                    ends.into_iter().fold(0.0, f64::max),
                ]
            };
            let sides: Vec<[f64; 2]> = (0..3).filter(|&k| k != axis).map(interval).collect();
            parts.push(Rectangle {
                axis,
                height: corners[0][axis],
                sides: [sides[0], sides[1]],
            });
        }
    }
    let n = parts.len();
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for i in 0..n {
        let f = |j: usize| exchange(&parts[i], &parts[j]) / parts[i].area();
        let mut row: Vec<f64> = (0..n).map(|j| if i == j { 0.0 } else { f(j) }).collect();
        let sum: f64 = row.iter().sum();
        assert!((sum - 1.0).abs() < 1e-12, "{sum}");
        for (j, f) in row.iter_mut().enumerate() {
            *f = f64::from(u8::from(i == j)) - faces[i].rho * *f;
        }
        row.push(faces[i].emission);
        rows.push(row);
    }
    let exact = eliminated(rows);
    (faces, exact)
}

/// The solution of a system whose rows end with their right side (Gauss, with partial pivoting).
fn eliminated(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let largest = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()));
        rows.swap(k, largest.unwrap());
        for i in 0..n {
            if i != k {
                let pivot = rows[k].clone();
                let factor = rows[i][k] / pivot[k];
                for (value, pivot) in rows[i].iter_mut().zip(&pivot).skip(k) {
                    *value -= factor * pivot;
                }
            }
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

#[test]
fn the_stated_bound_covers_the_error_in_a_hundred_rooms() {
    let mut random = Random(2026);
    let mut covered = 0;
    for room in 0..100 {
        let closure = room % 2 == 0;
        let (error, bound) = if room % 4 < 2 {
            let (faces, exact) = empty_box(&mut random);
            let (b, bound) = solved(&enclosure(&faces, closure));
            (largest_difference(&b, |i| exact[i]), bound)
        } else {
            let faces = furnace(1, &mut random, |random| random.reflectance(0.1, 3.0));
            let (b, bound) = solved(&enclosure(&faces, closure));
            (largest_difference(&b, |_| 1.0), bound)
        };
        covered += u32::from(error <= bound);
    }
    assert!(covered >= 95, "{covered} of 100");
}

#[test]
fn furnaces_hold_to_a_millionth_up_to_a_loss_of_a_millionth() {
    let mut random = Random(7);
    for blocks in 0..3 {
        for loss in [1e-3, 1e-5, 1e-6] {
            let faces = furnace(blocks, &mut random, |_| 1.0 - loss);
            let enclosure = enclosure(&faces, true);
            let (b, bound) = solved(&enclosure);
            let exchange = enclosure.exchange().unwrap();
            assert!(exchange.is_closed && exchange.correction.is_some());
            let error = largest_difference(&b, |_| 1.0);
            assert!(
                error < 1e-6,
                "{error:e} with {blocks} blocks and a loss of {loss}"
            );
            assert!(
                error <= bound,
                "{error:e}, and at most {bound:e} was stated"
            );
        }
    }
}
