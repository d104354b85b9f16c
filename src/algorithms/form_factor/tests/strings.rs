//! What stands between long strips, against crossed strings (Hottel 1954).

use super::occluded::{assert_right, first_to_second, level};

#[test]
fn strips_past_a_blocker_exchange_what_crossed_strings_say() {
    // 2000 long, so that what leaves at the ends is below 1e-3 of F; two lengths take that away.
    for (left, right) in [
        (-0.2, 0.3),
        (0.1, 0.9),
        (-1.0, 0.5),
        (0.45, 0.55),
        (-0.5, 0.02),
    ] {
        let of_length = |length: f64| {
            let z = [0.0, length];
            first_to_second(&[
                level("floor", [0.0, 1.0], 0.0, z, true, 1),
                level("lid", [0.0, 1.0], 1.0, z, false, 1),
                level("card", [left, right], 0.4, [-length, 2.0 * length], true, 1),
            ])
        };
        let found = 2.0 * of_length(400.0) - of_length(200.0);
        // Past each side of the card: crossed less uncrossed strings, over twice the width (Hottel 1954).
        let string = |from: [f64; 2], to: [f64; 2]| {
            ((to[0] - from[0]).powi(2) + (to[1] - from[1]).powi(2)).sqrt()
        };
        let bent = |over: [f64; 2], x: f64, y: f64, is_left: bool| {
            // From (x, 0) to (y, 1), taut around the edge where that is in the way.
            let at = x + over[1] * (y - x);
            let is_free = if is_left {
                at <= over[0]
            } else {
                at >= over[0]
            };
            if is_free {
                string([x, 0.0], [y, 1.0])
            } else {
                string([x, 0.0], over) + string(over, [y, 1.0])
            }
        };
        let past = |edge: f64, is_left: bool| {
            let over = [edge, 0.4];
            let (near, far) = if is_left { (0.0, 1.0) } else { (1.0, 0.0) };
            let crossed = bent(over, near, far, is_left) + bent(over, far, near, is_left);
            let uncrossed = bent(over, near, near, is_left) + bent(over, far, far, is_left);
            (0.5 * (crossed - uncrossed)).max(0.0)
        };
        assert_right(
            &format!("{left} to {right}"),
            found,
            past(left, true) + past(right, false),
        );
    }
}

#[test]
fn a_floor_and_a_wall_exchange_past_a_blocker_what_crossed_strings_say() {
    // The floor is 1 wide from the corner line on, as is the wall; the blocker stands or lies between, given by its ends in the cross section.
    let string = |from: [f64; 2], to: [f64; 2]| (to[0] - from[0]).hypot(to[1] - from[1]);
    for [low, high] in [
        [[0.3, 0.0], [0.3, 0.4]],
        [[0.3, 0.2], [0.6, 0.2]],
        [[0.0, 0.5], [0.5, 0.5]],
        [[0.2, 0.2], [0.5, 0.6]],
        [[0.5, 0.1], [0.5, 0.45]],
        [[0.05, 0.05], [0.3, 0.05]],
    ] {
        let of_length = |length: f64| {
            let z = [0.0, length];
            let [far, near] = [2.0 * length, -length];
            let wall = vec![
                [0.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [0.0, 1.0, length],
                [0.0, 0.0, length],
            ];
            let card = vec![
                [low[0], low[1], near],
                [low[0], low[1], far],
                [high[0], high[1], far],
                [high[0], high[1], near],
            ];
            first_to_second(&[
                level("floor", [0.0, 1.0], 0.0, z, true, 1),
                ("wall", wall, 1),
                ("card", card, 1),
            ])
        };
        let found = 2.0 * of_length(400.0) - of_length(200.0);
        // ½ ∫ (sin of the highest direction − sin of the lowest) over what of the wall a point of the floor sees, by the angles of the ends.
        let steps = 20_000;
        let exact: f64 = (0..steps)
            .map(|k| (f64::from(k) + 0.5) / f64::from(steps))
            .map(|x| {
                // Toward the wall, a direction is known by its sine against the floor's normal.
                let sine = |[u, v]: [f64; 2]| (x - u) / string([x, 0.0], [u, v]);
                let (top, bottom) = (sine([0.0, 1.0]), 1.0);
                let ends = [sine(low), sine(high)];
                let hidden = [
                    ends[0].min(ends[1]).clamp(top, bottom),
                    ends[0].max(ends[1]).clamp(top, bottom),
                ];
                0.5 * (bottom - top - (hidden[1] - hidden[0])) / f64::from(steps)
            })
            .sum();
        assert_right(&format!("{low:?} to {high:?}"), found, exact);
    }
}
