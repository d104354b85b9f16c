//! Patches that lie in one place.

use super::occluded::{box_faces, estimated, scene};
use super::*;

#[test]
fn walls_given_twice_exchange_as_if_given_once() {
    let once = box_faces("room", [0.0; 3], [1.0; 3], true, 2);
    let twice = [once.clone(), once[..3].to_vec()].concat();
    let (single, double) = (estimated(&scene(&once)), estimated(&scene(&twice)));
    let (n, m) = (single.0.len(), double.0.len());
    for i in 0..m {
        for j in 0..m {
            let f = double.1.matrix[i * m + j];
            let right = if i < n && j < n {
                single.1.matrix[i * n + j]
            } else {
                0.0
            };
            assert_eq!(f, right, "{i} {j}");
        }
    }
}

#[test]
fn of_a_panel_on_a_wall_the_one_that_comes_first_is_in_front() {
    let room = box_faces("room", [0.0; 3], [1.0; 3], true, 2);
    let panel = (
        "panel",
        vec![
            [0.3, 0.0, 0.3],
            [0.3, 0.0, 0.6],
            [0.6, 0.0, 0.6],
            [0.6, 0.0, 0.3],
        ],
        1,
    );
    for is_first in [true, false] {
        let mut polygons = room.clone();
        polygons.insert(if is_first { 0 } else { 6 }, panel.clone());
        let (patches, estimated) = estimated(&scene(&polygons));
        let n = patches.len();
        let of_panel = if is_first { 0 } else { n - 1 };
        let sum = |i: usize| estimated.matrix[i * n..][..n].iter().sum::<f64>();
        assert!(
            (sum(of_panel) - f64::from(u8::from(is_first))).abs() < 1e-5,
            "{}",
            sum(of_panel)
        );
        // What it leaves of the floor, by area; what lies under it sees nothing.
        let floor: f64 = (0..n)
            .filter(|&i| i != of_panel && patches[i].center.y == 0.0)
            .map(|i| patches[i].area * sum(i))
            .sum();
        let left = if is_first { 1.0 - 0.09 } else { 1.0 };
        assert!((floor - left).abs() < 1e-4, "{is_first}: {floor}");
    }
}

#[test]
fn rays_and_hemicubes_know_what_lies_on_what() {
    let room = box_faces("room", [0.0; 3], [1.0; 3], true, 1);
    let block = box_faces("block", [0.2, 0.0, 0.3], [0.7, 0.4, 0.8], false, 1);
    // The floor again, and a block that stands on it.
    let polygons = [room.clone(), vec![room[4].clone()], block].concat();
    let scene = scene(&polygons);
    let patches = Patches::of(&scene, 100).unwrap();
    let blockers = Blockers::of(&scene, &patches);
    let matrix = |method| FormFactors::new(&patches, method, Some(&blockers)).matrix();
    let exact = matrix(Method::Auto { tolerance: 1e-6 });
    let hemicubes = Hemicubes {
        resolution: 32,
        points: 6,
    };
    let rays = 1 << 11;
    for (method, tolerance) in [
        (Method::MonteCarlo { rays, seed: 1 }, 0.03),
        (Method::Hemicube(hemicubes), 0.04),
    ] {
        let found = matrix(method);
        for (k, (found, exact)) in found.iter().zip(&exact).enumerate() {
            let error = (found - exact).abs();
            let [i, j] = [k / patches.len(), k % patches.len()];
            assert!(
                error <= tolerance,
                "{method:?} {i} {j}: {found} for {exact}"
            );
            assert!(*exact > 0.0 || *found == 0.0, "{method:?} {i} {j}: {found}");
        }
        let sum = |i: usize| {
            found[i * patches.len()..][..patches.len()]
                .iter()
                .sum::<f64>()
        };
        // The bottom of the block sees the floor alone, which sees it as far as it lies there.
        let [floor, again, bottom] = [4, 6, 11];
        assert_eq!(sum(again), 0.0);
        assert!((found[bottom * patches.len() + floor] - 1.0).abs() < 1e-12);
        assert!((found[floor * patches.len() + bottom] - 0.25).abs() < 1e-12);
    }
}
