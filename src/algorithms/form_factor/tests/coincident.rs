//! Patches that lie in one place.

use super::occluded::{box_faces, estimated, scene};

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
