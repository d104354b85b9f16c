//! Rooms that are closed, and such that are not.

use super::*;
use crate::algorithms::fixtures::{Cuboid, polygon, scene};
use crate::algorithms::form_factor::Blockers;

fn closed_in(objects: &[String]) -> Option<Closed> {
    let scene = scene("", objects);
    let patches = Patches::of(&scene, 100_000).unwrap();
    Blockers::of(&scene, &patches).closed(&patches).cloned()
}

fn is_closed_in(objects: &[String]) -> bool {
    closed_in(objects).is_some()
}

const BLOCK: Cuboid = Cuboid {
    low: [0.3, 0.2, 0.35],
    high: [0.6, 0.7, 0.6],
};

fn room() -> Vec<String> {
    Cuboid::UNIT.room("wall", [2; 6])
}

#[test]
fn rooms_are_closed_empty_and_furnished_and_however_they_are_divided() {
    assert!(is_closed_in(&room()));
    let uneven = Cuboid::UNIT.room("wall", [1, 2, 3, 4, 5, 7]);
    assert!(is_closed_in(&uneven));
    let sphere =
        r#"{"name": "s", "material": "m", "sphere": {"center": [0.8, 0.8, 0.8], "radius": 0.1}}"#;
    let furnished = [uneven, BLOCK.block("block", 2), vec![sphere.into()]].concat();
    assert!(is_closed_in(&furnished));
    let far = Cuboid {
        low: [1e6, -1e6, 1e6],
        high: [1e6 + 1.0, 1.0 - 1e6, 1e6 + 1.0],
    };
    assert!(is_closed_in(&far.room("wall", [3; 6])));
}

#[test]
fn the_smallest_opening_leaves_a_room_open() {
    assert!(!is_closed_in(&room()[..5]));
    for missing in [1e-7, 1e-3] {
        let short = 1.0 - missing;
        let mut open = room();
        let corners = [[0., 1., 0.], [1., 1., 0.], [1., 1., short], [0., 1., short]];
        open[5] = polygon("wall5", &corners, 2);
        assert!(!is_closed_in(&open), "{missing}");
    }
}

#[test]
fn a_back_that_is_seen_leaves_a_room_open() {
    let with = |more: &[String]| is_closed_in(&[&room()[..], more].concat());
    assert!(!with(&BLOCK.block("sheet", 1)[..1]));
    assert!(!with(&BLOCK.room("block inside out", [1; 6])));
    assert!(!is_closed_in(&Cuboid::UNIT.block("room inside out", 2)));
}

/// The light that each patch exchanges, in a room with a block of these faces.
fn with_block(block: Cuboid, faces: &[usize], divisions: u32) -> Option<Closed> {
    let all = block.block("block", 1);
    let kept = faces.iter().map(|&face| all[face].clone());
    let room = Cuboid::UNIT.room("wall", [divisions; 6]);
    closed_in(&room.into_iter().chain(kept).collect::<Vec<_>>())
}

const ALL: [usize; 6] = [0, 1, 2, 3, 4, 5];
const STANDING: Cuboid = Cuboid {
    low: [0.3, 0.0, 0.35],
    high: [0.6, 0.7, 0.6],
};

#[test]
fn a_block_that_touches_the_room_exchanges_with_what_it_touches() {
    for (low, high, sides) in [
        (STANDING.low, STANDING.high, 1),
        ([0.0, 0.0, 0.2], [0.3, 0.4, 0.5], 2),
        ([0.0, 0.0, 0.0], [0.3, 0.4, 0.5], 3),
        ([0.4, 0.0, 0.2], [0.5, 1.0, 0.5], 2),
    ] {
        for divisions in [1, 3] {
            let block = Cuboid { low, high };
            let closed = with_block(block, &ALL, divisions).unwrap();
            let walls = 6 * (divisions * divisions) as usize;
            assert!(
                closed
                    .shares
                    .iter()
                    .all(|&share| (share - 1.0).abs() < 1e-9)
            );
            let contacts =
                |i: usize| -> f64 { (0..walls + 6).filter_map(|j| closed.contact(i, j)).sum() };
            let touching = (walls..walls + 6).filter(|&face| contacts(face) > 0.0);
            assert_eq!(touching.count(), sides, "{low:?}");
        }
    }
}

#[test]
fn a_face_that_is_missing_where_a_block_stands_leaves_the_rest_of_the_floor() {
    let floor = |block: Cuboid, faces: &[usize]| -> f64 {
        let closed = with_block(block, faces, 2).unwrap();
        closed.shares[16..20].iter().map(|share| 0.25 * share).sum()
    };
    let bottom = ALL[4];
    let faces: Vec<usize> = ALL.into_iter().filter(|&face| face != bottom).collect();
    assert!((floor(STANDING, &faces) - (1.0 - 0.3 * 0.25)).abs() < 1e-9);
    // Nor does light come to what is below the floor.
    let sunk = Cuboid {
        low: [0.3, -0.2, 0.35],
        ..STANDING
    };
    assert!((floor(sunk, &ALL) - (1.0 - 0.3 * 0.25)).abs() < 1e-9);
    // In a corner of the floor and a wall.
    let corner = Cuboid {
        low: [0.0, 0.0, 0.35],
        ..STANDING
    };
    let faces = [0, 1, 3, 5];
    assert!((floor(corner, &faces) - (1.0 - 0.6 * 0.25)).abs() < 1e-9);
    let hole = ALL[5];
    let faces: Vec<usize> = ALL.into_iter().filter(|&face| face != hole).collect();
    assert!(with_block(STANDING, &faces, 2).is_none());
}

#[test]
fn two_rooms_that_share_a_wall_have_no_contact() {
    let beside = Cuboid {
        low: [1.0, 0.0, 0.0],
        high: [2.0, 1.0, 1.0],
    };
    let closed = closed_in(&[room(), beside.room("beside", [1; 6])].concat()).unwrap();
    assert!(closed.contacts.is_empty());
    assert!(closed.shares.iter().all(|&share| share == 1.0));
    let box_in_room = [
        room(),
        BLOCK.block("block", 1),
        BLOCK.room("inside", [1; 6]),
    ];
    assert!(
        closed_in(&box_in_room.concat())
            .unwrap()
            .contacts
            .is_empty()
    );
}

#[test]
fn stacked_blocks_and_walls_given_twice_leave_a_room_closed() {
    let on_top = Cuboid {
        low: [0.2, 0.7, 0.3],
        high: [0.5, 0.9, 0.8],
    };
    let stack = [room(), STANDING.block("one", 2), on_top.block("two", 1)].concat();
    let closed = closed_in(&stack).unwrap();
    assert!(
        closed
            .shares
            .iter()
            .all(|&share| (share - 1.0).abs() < 1e-9)
    );
    let twice = [room(), Cuboid::UNIT.room("again", [1; 6])[..3].to_vec()].concat();
    let closed = closed_in(&twice).unwrap();
    assert_eq!(closed.shares[24..], [0.0; 3]);
}
