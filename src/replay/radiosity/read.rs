//! Which form factors a solver has used so far.

use super::State;
use crate::algorithms::radiosity::{Event, SolverEvent};
use crate::replay::Replay;

/// Of the form factors of `n` patches, row by row, those that the steps up to the replay's have used.
pub fn used_form_factors(replay: &Replay<Event, State>, n: usize) -> Vec<bool> {
    let mut used = vec![false; n * n];
    let mut current = 0;
    let timeline = replay.timeline();
    for step in 0..timeline.len().min(replay.position() + 1) {
        let entry = match timeline.event(step).recorded {
            SolverEvent::Gathering { i, .. } | SolverEvent::Shooting { i, .. } => {
                current = i as usize;
                continue;
            }
            SolverEvent::Exchanged { j, .. } => current * n + j as usize,
            SolverEvent::Received { j, .. } => j as usize * n + current,
            _ => continue,
        };
        if let Some(used) = used.get_mut(entry) {
            *used = true;
        }
    }
    used
}
