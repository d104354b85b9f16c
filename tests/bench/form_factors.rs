//! Form factors of a closed cube of 8 × 8 patches a face (384), one thread: for each method the largest relative error of an entry beside the
//! time of the whole matrix, and the ratio of entries a second to the goal of 20 million. Then how time and memory grow with the number
//! of patches.

use lightwalk::algorithms::form_factor::hemicube::Hemicubes;
use lightwalk::algorithms::form_factor::{FormFactors, Method};
use lightwalk::scene::patches::Patches;
use lightwalk::scene::{Limits, read};
use lightwalk::study::timing::Timing;
use std::time::Instant;

const ROUNDS: usize = 9;
const GOAL: f64 = 20e6;

fn cube(side: usize) -> Patches {
    let faces = [
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]],
        [[1, 0, 1], [0, 0, 1], [0, 1, 1], [1, 1, 1]],
        [[0, 0, 1], [0, 0, 0], [0, 1, 0], [0, 1, 1]],
        [[1, 0, 0], [1, 0, 1], [1, 1, 1], [1, 1, 0]],
        [[0, 0, 1], [1, 0, 1], [1, 0, 0], [0, 0, 0]],
        [[0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]],
    ];
    let objects: Vec<String> = faces
        .iter()
        .enumerate()
        .map(|(face, vertices)| {
            format!(
                r#"{{"name": "{face}", "material": "m", "polygon": {{"vertices": {vertices:?}}}, "patches": {side}}}"#
            )
        })
        .collect();
    let text = format!(
        r#"{{"schema": 1, "materials": {{"m": {{}}}}, "objects": [{}]}}"#,
        objects.join(", ")
    );
    let scene = read(text.as_bytes(), &Limits::default(), &mut |_| {
        Err(String::new())
    });
    Patches::of(&scene.unwrap(), 100_000).unwrap()
}

fn main() {
    let patches = cube(8);
    let n = patches.len();
    let exact = FormFactors::new(&patches, Method::Auto { tolerance: 1e-10 }, None).matrix();
    println!(
        "{:60} {:>12} {:>10} {:>14}",
        "method", "worst error", "ms", "of 20 M/s"
    );
    for (method, rounds) in [
        (Method::Auto { tolerance: 1e-3 }, ROUNDS),
        (Method::Auto { tolerance: 1e-6 }, ROUNDS),
        (Method::AreaToArea { points: 2 }, ROUNDS),
        (Method::ElementToPolygon { points: 2 }, ROUNDS),
        (Method::ElementToPolygon { points: 4 }, ROUNDS),
        (Method::Contour { tolerance: 1e-6 }, ROUNDS),
        (
            Method::MonteCarlo {
                rays: 1024,
                seed: 0,
            },
            1,
        ),
        (
            Method::Hemicube(Hemicubes {
                resolution: 128,
                points: 1,
            }),
            1,
        ),
        (
            Method::Hemicube(Hemicubes {
                resolution: 128,
                points: 3,
            }),
            1,
        ),
    ] {
        let factors = FormFactors::new(&patches, method, None);
        let mut seconds = Vec::new();
        let mut matrix = Vec::new();
        for _ in 0..rounds {
            let start = Instant::now();
            matrix = factors.matrix();
            seconds.push(start.elapsed().as_secs_f64());
        }
        let median = Timing::of(seconds).median;
        let worst = matrix
            .iter()
            .zip(&exact)
            .filter(|&(_, &exact)| exact > 0.0)
            .map(|(found, exact)| (found / exact - 1.0).abs())
            .fold(0.0, f64::max);
        let ratio = (n * n) as f64 / median / GOAL;
        println!(
            "{:60} {worst:12.1e} {:10.2} {ratio:14.4}",
            format!("{method:?}"),
            1e3 * median
        );
    }
    growth();
}

/// How time and memory grow with the number of patches, at 1e-6 and with nothing in between.
fn growth() {
    println!(
        "\n{:>10} {:>10} {:>16} {:>12}",
        "patches", "seconds", "ns an entry", "MiB"
    );
    for side in [4, 8, 16, 24] {
        let patches = cube(side);
        let entries = (patches.len() * patches.len()) as f64;
        let start = Instant::now();
        let matrix = FormFactors::new(&patches, Method::Auto { tolerance: 1e-6 }, None).matrix();
        let seconds = start.elapsed().as_secs_f64();
        let mebibytes = size_of_val(&*matrix) as f64 / f64::from(1 << 20);
        println!(
            "{:10} {seconds:10.3} {:16.1} {mebibytes:12.1}",
            patches.len(),
            1e9 * seconds / entries
        );
    }
}
