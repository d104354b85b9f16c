//! Cards and blocks under a lid so wide that their whole shadow falls on it: what reaches them is missing there.

use super::*;

/// `blocker`: its polygons in the scene. `shown`: what of it the floor sees, from below.
fn assert_shades(name: &str, blocker: Vec<Corners>, shown: &[Corners]) {
    let (floor, lid) = (floor(UNIT, 0.0, UNIT), lid(WIDE, 1.0, WIDE));
    let whole = exact::exchange(&floor, &lid);
    let blocked: f64 = shown.iter().map(|part| exact::exchange(&floor, part)).sum();
    let right = whole - blocked;
    assert!(right > 0.0 && blocked > 0.0);
    assert_exchange(name, &[vec![floor, lid], blocker].concat(), right);
}

fn assert_card_shades(name: &str, card: Corners) {
    assert_shades(name, vec![card.clone()], &[card]);
}

#[test]
fn cards_take_away_what_reaches_them() {
    for (side, y) in [(0.5, 0.5), (0.02, 0.4), (0.002, 0.1), (1.5, 0.55)] {
        let ends = [0.4, 0.4 + side];
        assert_card_shades(&format!("card of {side}"), lid(ends, y, ends));
    }
    assert_card_shades("wire", lid([0.4, 0.402], 0.3, [-0.2, 1.3]));
    let aslant = vec![
        [0.2, 0.3, 0.1],
        [0.9, 0.6, 0.2],
        [0.9, 0.6, 0.8],
        [0.2, 0.3, 0.7],
    ];
    assert_card_shades("card aslant", aslant);
    let triangle = vec![[0.1, 0.4, 0.2], [0.8, 0.5, 0.3], [0.4, 0.3, 0.9]];
    assert_card_shades("triangle", triangle);
}

#[test]
fn a_card_in_the_shadow_of_another_takes_nothing_away() {
    let card = lid([0.3, 0.8], 0.4, [0.3, 0.8]);
    let behind = lid([0.4, 0.6], 0.42, [0.4, 0.6]);
    assert_shades(
        "in the shadow",
        vec![card.clone(), behind.clone()],
        std::slice::from_ref(&card),
    );
    assert_shades("in the shadow, first", vec![behind, card.clone()], &[card]);
}

#[test]
fn cards_in_one_plane_take_away_their_sum() {
    let cards: Vec<Corners> = (0..9)
        .map(|k| {
            [
                0.05 + 0.33 * f64::from(k / 3),
                0.05 + 0.33 * f64::from(k % 3),
            ]
        })
        .map(|[x, z]| lid([x, x + 0.2], 0.45, [z, z + 0.2]))
        .collect();
    assert_shades("nine cards", cards.clone(), &cards);
}

#[test]
fn a_block_takes_away_what_reaches_its_faces() {
    // Its sides lie outside the floor's: what is in front of one is the whole floor or nothing.
    let ([low, high], [bottom, top]) = ([-0.1, 1.1], [0.4, 0.6]);
    let ends = [low, high];
    let sides = [
        turned(wall(low, [bottom, top], ends)),
        wall(high, [bottom, top], ends),
        [[0, 1], [1, 1], [1, 0], [0, 0]]
            .map(|[k, m]| [ends[k], [top, bottom][m], low])
            .to_vec(),
        [[0, 0], [1, 0], [1, 1], [0, 1]]
            .map(|[k, m]| [ends[k], [top, bottom][m], high])
            .to_vec(),
    ];
    let below = lid(ends, bottom, ends);
    let block = [vec![below.clone(), floor(ends, top, ends)], sides.to_vec()].concat();
    assert_shades("block", block, &[below]);
}
