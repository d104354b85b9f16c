//! Contenders timed alternately, in one run, so that a machine that slows down slows down all.

use lightwalk::study::timing::Timing;
use std::time::Instant;

/// Seconds of `rounds` runs of each contender. A round begins with another one each time; the first round only warms up.
pub fn race(contenders: &mut [&mut dyn FnMut()], rounds: usize) -> Vec<Vec<f64>> {
    let count = contenders.len();
    let mut seconds = vec![Vec::with_capacity(rounds); count];
    for round in 0..=rounds {
        for i in (0..count).map(|turn| (turn + round) % count) {
            let start = Instant::now();
            contenders[i]();
            if round > 0 {
                seconds[i].push(start.elapsed().as_secs_f64());
            }
        }
    }
    seconds
}

/// How many times as long `a` takes as `b`, by the runs of one round.
pub fn ratio(a: &[f64], b: &[f64]) -> Timing {
    Timing::of(a.iter().zip(b).map(|(a, b)| a / b).collect())
}
