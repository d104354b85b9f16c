//! Furnaces whose furniture touches the room and itself.

use super::*;

/// A block, and which of its faces are in the file.
struct Block {
    low: [f64; 3],
    high: [f64; 3],
    without: &'static [usize],
}

const BOTTOM: usize = 4;

/// A block on the floor y = 0 between shares of the room in x, and in all of its depth.
fn standing(random: &mut Random, size: [f64; 3], [from, to]: [f64; 2]) -> Block {
    let mut ends = |from: f64, to: f64| {
        let start = random.between(from, from + 0.4 * (to - from));
        [start, random.between(start + 0.2 * (to - from), to)]
    };
    let [x, z] = [ends(from * size[0], to * size[0]), ends(0.1, 0.9 * size[2])];
    let top = random.between(0.2, 0.7) * size[1];
    Block {
        low: [x[0], 0.0, z[0]],
        high: [x[1], top, z[1]],
        without: &[],
    }
}

fn arrangements(random: &mut Random, size: [f64; 3]) -> Vec<(&'static str, Vec<Block>)> {
    let whole = [0.1, 0.9];
    let mut one = || standing(random, size, whole);
    let with = |block: Block, change: fn(&mut Block, [f64; 3])| {
        let mut block = block;
        change(&mut block, size);
        block
    };
    let on_floor = one();
    let open_below = with(one(), |block, _| block.without = &[BOTTOM]);
    let at_wall = with(one(), |block, _| block.low[0] = 0.0);
    let in_corner = with(one(), |block, _| (block.low[0], block.low[2]) = (0.0, 0.0));
    let in_open_corner = with(one(), |block, _| {
        block.low[0] = 0.0;
        block.without = &[BOTTOM, 2];
    });
    let column = with(one(), |block, size| block.high[1] = size[1]);
    let hung = with(one(), |block, size| {
        (block.low[1], block.high[1]) = (0.8 * size[1], size[1]);
    });
    let sunk = with(one(), |block, size| block.low[1] = -0.2 * size[1]);
    let lower = one();
    let mut upper = one();
    (upper.low[1], upper.high[1]) = (lower.high[1], 0.9 * size[1]);
    let [left, mut right] = [[0.1, 0.5], [0.5, 0.9]].map(|part| standing(random, size, part));
    right.low[0] = left.high[0];
    let [first, mut second] = [whole, whole].map(|part| standing(random, size, part));
    second.low[0] = 0.5 * (first.low[0] + first.high[0]);
    second.high[0] = 0.95 * size[0];
    vec![
        ("on the floor", vec![on_floor]),
        ("with no bottom", vec![open_below]),
        ("at a wall", vec![at_wall]),
        ("in a corner", vec![in_corner]),
        ("with no back and no bottom", vec![in_open_corner]),
        ("from floor to ceiling", vec![column]),
        ("below the ceiling", vec![hung]),
        ("through the floor", vec![sunk]),
        ("stacked", vec![lower, upper]),
        ("side by side", vec![left, right]),
        ("through each other", vec![first, second]),
    ]
}

fn faces(random: &mut Random, size: [f64; 3], blocks: &[Block], loss: f64) -> Vec<Face> {
    let walls = cuboid([0.0; 3], size, false).map(|corners| (corners, [2, 2]));
    let blocks = blocks.iter().flat_map(|block| {
        let faces = cuboid(block.low, block.high, true).enumerate();
        let kept = faces.filter(|(face, _)| !block.without.contains(face));
        kept.map(|(_, corners)| (corners, [1, 1]))
            .collect::<Vec<_>>()
    });
    let mut faces: Vec<_> = walls.chain(blocks).collect();
    // In any order.
    for k in (1..faces.len()).rev() {
        faces.swap(k, (random.next() * (k + 1) as f64) as usize);
    }
    let of = |(corners, patches)| Face {
        corners,
        patches,
        rho: 1.0 - loss,
        emission: loss,
    };
    faces.into_iter().map(of).collect()
}

#[test]
fn furnaces_hold_with_furniture_that_touches() {
    let mut random = Random(12);
    for round in 0..3 {
        let size: [f64; 3] = std::array::from_fn(|_| random.between(0.5, 2.0));
        for (name, blocks) in arrangements(&mut random, size) {
            let loss = [1e-3, 1e-5, 1e-6][round];
            let enclosure = enclosure(&faces(&mut random, size, &blocks, loss), true);
            let (b, bound) = solved(&enclosure);
            let exchange = enclosure.exchange().unwrap();
            assert!(
                exchange.is_closed && exchange.correction.is_some(),
                "{name}"
            );
            // What sees nothing has what it gives off.
            let seen = |i: usize| if exchange.is_seen[i] { 1.0 } else { loss };
            let error = largest_difference(&b, seen);
            println!(
                "{name}: {error:e} of {bound:e}, corrected {:e}",
                exchange.correction.as_ref().unwrap().size()
            );
            assert!(error < 1e-6, "{error:e} {name} and a loss of {loss}");
            assert!(
                error <= bound,
                "{error:e} {name}, and at most {bound:e} was stated"
            );
        }
    }
}
