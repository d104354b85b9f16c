//! Megapixels a second of the scan-line methods, unrecorded, on one thread: the textbook body in f64, the body in lanes in f32, and a plain
//! scalar span body in f32, written here as most would write it. Diffuse surfaces under one directional light.
//!
//! All in one run, in alternating order: medians with quartiles, the median ratio of runs taken in turn, and the ratio of the fastest runs,
//! which other work on the machine disturbs least. The lanes and
//! the plain body start from vertices that are lit, or whose normals are known; the textbook body finds them in every frame.

mod plain;

use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::render::lanes::{LaneFrame, LanePainter};
use lightwalk::render::{Method, render};
use lightwalk::scene::{self, Limits, View};
use plain::{Plain, PlainFrame};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::time::Instant;

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;
const ROUNDS: usize = 41;

const METHODS: [Method; 4] = [
    Method::Flat,
    Method::Gouraud,
    Method::Phong,
    Method::FastPhong,
];

/// A torus with bumps: around a ring of radius 1, a tube of radius 0.45 + 0.05 sin 12φ sin 8θ, of 2·`along`·`across` triangles.
fn bumpy_torus(along: u32, across: u32) -> String {
    let mut text = String::new();
    for (i, j) in (0..along).flat_map(|i| (0..across).map(move |j| (i, j))) {
        let phi = TAU * f64::from(i) / f64::from(along);
        let theta = TAU * f64::from(j) / f64::from(across);
        let tube = 0.45 + 0.05 * (12.0 * phi).sin() * (8.0 * theta).sin();
        let from_axis = 1.0 + tube * theta.cos();
        let (x, y) = (from_axis * phi.cos(), from_axis * phi.sin());
        text += &format!("v {x} {y} {}\n", tube * theta.sin());
    }
    let at = |i: u32, j: u32| (i % along) * across + j % across + 1;
    for (i, j) in (0..along).flat_map(|i| (0..across).map(move |j| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}

/// Two triangles that fill the picture, folded along their diagonal and with wings outside it, so that the normals of their corners differ.
const QUAD: &str = "v -2 -2 0\nv 2 -2 0\nv 2 2 0\nv -2 2 0\nv -9 -9 -9\nv 9 9 -9\n\
                    f 1 2 3\nf 1 3 4\nf 1 4 5\nf 2 1 5\nf 3 2 6\nf 4 3 6\n";

fn prepared(mesh: &str, eye: [f64; 3]) -> PreparedScene {
    let json = format!(
        r#"{{ "schema": 1,
        "camera": {{ "eye": {eye:?}, "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 45 }},
        "materials": {{ "clay": {{ "ambient": [0.05, 0.06, 0.07], "diffuse": [0.7, 0.5, 0.3] }} }},
        "objects": [ {{ "name": "mesh", "material": "clay", "mesh": {{ "file": "mesh.obj" }} }} ],
        "lights": [ {{ "directional": {{ "toward": [0.3, 0.2, -0.9], "color": [1, 0.9, 0.8] }} }} ] }}"#
    );
    let mut files = |_: &str| Ok(mesh.as_bytes().to_vec());
    let scene = scene::read(json.as_bytes(), &Limits::default(), &mut files)
        .expect("the scene of a benchmark is right");
    let camera = scene.camera.expect("the scene of a benchmark has a camera");
    PreparedScene::new(scene, View::new(&camera, WIDTH, HEIGHT))
}

/// Lower quartile, median, upper quartile.
fn quartiles(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| values[quarter * (values.len() - 1) / 4])
}

fn fastest(seconds: &[f64]) -> f64 {
    seconds.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Seconds of `rounds` runs of each contender, in turn; the first round warms up.
fn race(contenders: &mut [Box<dyn FnMut() + '_>], rounds: usize) -> Vec<Vec<f64>> {
    let mut seconds = vec![Vec::new(); contenders.len()];
    for round in 0..=rounds {
        for turn in 0..contenders.len() {
            let i = (turn + round) % contenders.len();
            let start = Instant::now();
            contenders[i]();
            if round > 0 {
                seconds[i].push(start.elapsed().as_secs_f64());
            }
        }
    }
    seconds
}

fn compare(name: &str, prepared: &PreparedScene) {
    println!(
        "\n{name}: {} triangles, {WIDTH}×{HEIGHT}",
        prepared.tessellation.polygon_count()
    );
    for method in METHODS {
        let start = Instant::now();
        let painter = LanePainter::new(prepared, method).expect("lanes draw the scene");
        let setup = start.elapsed();
        let plain = Plain::new(prepared, method);
        let (mut lanes, mut pixels) = (
            LaneFrame::new(WIDTH, HEIGHT),
            PlainFrame::new(WIDTH, HEIGHT),
        );
        painter.draw(&mut lanes);
        plain.draw(&mut pixels);
        let (differing, drawn) = difference(&lanes, &pixels);
        println!(
            "  {}: {drawn} pixels seen; vertices ready in {setup:.1?}; plain differs in {differing}",
            method.name()
        );
        let seconds = race(
            &mut [
                Box::new(|| painter.draw(black_box(&mut lanes))),
                Box::new(|| plain.draw(black_box(&mut pixels))),
                Box::new(|| {
                    black_box(render(prepared, method, NonZeroUsize::MIN, &|_, _| {}));
                }),
            ],
            ROUNDS,
        );
        let megapixels = f64::from(WIDTH * HEIGHT) / 1e6;
        for (body, seconds_of) in ["lanes", "plain", "textbook"].into_iter().zip(&seconds) {
            let rates = seconds_of.iter().map(|seconds| megapixels / seconds);
            let [low, median, high] = quartiles(rates.collect());
            let pairs = seconds_of.iter().zip(&seconds[0]);
            let [_, ratio, _] = quartiles(pairs.map(|(other, lanes)| other / lanes).collect());
            let of_fastest = fastest(seconds_of) / fastest(&seconds[0]);
            println!(
                "    {body:9} {median:7.1} ({low:.1} to {high:.1}) megapixels/s; lanes are {ratio:.2} times as fast, {of_fastest:.2} in the fastest runs"
            );
        }
    }
}

/// How many pixels differ by more than 1/1000, and how many are drawn.
fn difference(lanes: &LaneFrame, plain: &PlainFrame) -> (usize, usize) {
    let pixels = || (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    let differs = |&(x, y): &(u32, u32)| {
        let pairs = lanes.pixel(x, y).into_iter().zip(plain.pixel(x, y));
        pairs.into_iter().any(|(a, b)| (a - b).abs() > 1e-3)
    };
    let drawn = |&(x, y): &(u32, u32)| lanes.pixel(x, y) != [0.0; 3];
    (
        pixels().filter(differs).count(),
        pixels().filter(drawn).count(),
    )
}

fn main() {
    compare("full-screen quad", &prepared(QUAD, [0.0, 0.0, 3.0]));
    compare("torus", &prepared(&bumpy_torus(220, 110), [0.6, -1.8, 2.0]));
}
