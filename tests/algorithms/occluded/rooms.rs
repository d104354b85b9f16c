//! Rooms with a door: all that reaches the door arrives in the room behind it.

use super::*;
use crate::rooms::rectangles::{self, Rectangle};

/// The walls of a box but those across x, seen from inside.
fn shell([x0, x1]: [f64; 2]) -> Vec<Corners> {
    let x = [x0, x1];
    let near = parallelogram([0.0; 3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [x, UNIT]);
    let far = turned(near.iter().map(|&[x, y, _]| [x, y, 1.0]).collect());
    vec![floor(x, 0.0, UNIT), lid(x, 1.0, UNIT), near, far]
}

#[test]
fn all_that_reaches_a_door_arrives_behind_it() {
    for (height, width) in [(0.6, 0.25), (0.02, 0.25), (1.0, 0.002)] {
        let [y, z] = [[0.0, height], [0.4, 0.4 + width]];
        let mut beside = vec![[UNIT, [0.0, z[0]]], [UNIT, [z[1], 1.0]]];
        if height < 1.0 {
            beside.push([[height, 1.0], z]);
        }
        let side = || beside.iter().map(|&[y, z]| wall(1.0, y, z));
        let mut polygons = [shell([0.0, 1.0]), vec![wall(0.0, UNIT, UNIT)]].concat();
        let of_first = polygons.len();
        polygons.extend(side().map(turned));
        let first_of_second = polygons.len();
        polygons.extend(side());
        polygons.extend(shell([1.0, 2.0]));
        polygons.push(turned(wall(2.0, UNIT, UNIT)));
        let scene = scene(
            &polygons
                .iter()
                .map(|corners| (corners.clone(), 1))
                .collect::<Vec<_>>(),
        );
        let patches = Patches::of(&scene, 100).unwrap();
        let blockers = Blockers::of(&scene, &patches);
        let matrix = FormFactors::new(&patches, METHOD, Some(&blockers)).matrix();
        let n = patches.len();
        let rectangle = |axis, height, sides| Rectangle {
            axis,
            height,
            sides,
        };
        let door = rectangle(0, 1.0, [y, z]);
        let walls = [
            rectangle(1, 0.0, [UNIT, UNIT]),
            rectangle(1, 1.0, [UNIT, UNIT]),
            rectangle(2, 0.0, [UNIT, UNIT]),
            rectangle(2, 1.0, [UNIT, UNIT]),
            rectangle(0, 0.0, [UNIT, UNIT]),
        ];
        for i in 0..of_first {
            let through: f64 = matrix[i * n + first_of_second..(i + 1) * n].iter().sum();
            let right = rectangles::exchange(&walls[i], &door);
            assert_right(
                &format!("wall {i}, door {height} by {width}"),
                through,
                right,
            );
            let sum: f64 = matrix[i * n..(i + 1) * n].iter().sum();
            assert!((sum - 1.0).abs() < 1e-3, "{i}: {sum}");
        }
    }
}

/// Between the right and the left wall of the Cornell box stand both blocks. The reference comes from 4 million random pairs of points on the
/// two patches, by a program of its own: 6.800e-4 with a standard error of 0.013e-4.
#[test]
fn two_walls_see_each_other_past_the_blocks_of_the_cornell_box() {
    let text = include_bytes!("../../../lessons/scenes/cornell-box.json");
    let scene = read(text, &Limits::default(), &mut |_| Err(String::new())).unwrap();
    let patches = Patches::of(&scene, 1000).unwrap();
    let blockers = Blockers::of(&scene, &patches);
    let form_factors = FormFactors::new(&patches, METHOD, Some(&blockers));
    assert_eq!(
        scene.objects[patches[61].object as usize].name,
        "right wall"
    );
    assert_eq!(scene.objects[patches[71].object as usize].name, "left wall");
    let f = form_factors.pair(61, 71, &mut Unrecorded);
    assert!((f / 6.800e-4 - 1.0).abs() < 8e-3, "{f}");
}
