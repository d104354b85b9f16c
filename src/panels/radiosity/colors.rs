//! The colours of patches: their light as the picture of the room would show it, and one channel's unshot light on a scale.

use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::radiosity::Solver;
use crate::color::Rgb;
use crate::replay::radiosity::{ChannelNow, State};
use std::iter::zip;

const CHANNELS: [&str; 3] = ["red", "green", "blue"];
/// The share of the patches that do not come out white in the finished picture, and how bright the last of them is.
const SHARE: f64 = 0.95;
const BRIGHT: f64 = 0.9;
/// The scale of unshot light spans so many powers of ten.
pub(super) const DECADES: i32 = 4;

/// Whether a solver keeps account of what every patch has still to shoot.
pub(super) fn shoots(solver: Solver) -> bool {
    matches!(solver, Solver::Shooting | Solver::Overshooting)
}

/// The light of every patch so far. It begins with what they emit; a channel that is still to be solved is dark, unless it is equal to
/// one before it, whose light it shares: a grey room is grey from the first step on. Where patches shoot, their unshot light, which
/// they already have, counts (Cohen, Chen, Wallace & Greenberg 1988).
pub(super) fn light(state: &State, room: &Enclosure) -> Vec<Rgb> {
    if state.channels.is_empty() {
        return room.emission.clone();
    }
    let [red, green, blue] = [0, 1, 2].map(|c| {
        of_channel(state, CHANNELS[twin(room, c)]).map_or_else(
            || vec![0.0; room.patches.len()],
            |channel| values(channel, room.emission.iter().map(|e| e.channels()[c])),
        )
    });
    let channels = zip(red, zip(green, blue));
    channels.map(|(r, (g, b))| Rgb::new(r, g, b)).collect()
}

/// The first channel in which patches reflect and emit as much as in channel `c`: one is solved for both.
pub(super) fn twin(room: &Enclosure, c: usize) -> usize {
    let equal = |other: usize| {
        let mut colors = room.reflectance.iter().chain(&room.emission);
        colors.all(|color| color.channels()[other] == color.channels()[c])
    };
    (0..c).find(|&other| equal(other)).unwrap_or(c)
}

/// The channel as it was solved, be it under the name of an equal one; none of one that is dark or still to be solved.
fn of_channel<'a>(state: &'a State, name: &str) -> Option<&'a ChannelNow> {
    let mut recorded = state.channels.iter().rev();
    let channel =
        recorded.find(|channel| channel.channel.is_none_or(|recorded| recorded == name))?;
    match channel.skipped {
        None => Some(channel),
        Some((_, Some(like))) if like != name => of_channel(state, like),
        Some(_) => None,
    }
}

/// Whether anything is told of its patches.
fn is_told(channel: &ChannelNow) -> bool {
    channel.patches.iter().any(|patch| patch.step.is_some())
}

fn values(channel: &ChannelNow, emission: impl Iterator<Item = f64>) -> Vec<f64> {
    if !is_told(channel) {
        return emission.collect();
    }
    let unshot_counts = f64::from(u8::from(shoots(channel.solver)));
    let patches = channel.patches.iter();
    patches
        .map(|patch| patch.b + unshot_counts * patch.unshot)
        .collect()
}

/// What light is multiplied by to be shown, the same at every step: by the finished light of the patches that do not shine by
/// themselves, as lamps may well be white.
pub(super) fn exposure(room: &Enclosure) -> f64 {
    let finished = room.matrix().and_then(|matrix| room.light(matrix).ok());
    let radiosity = finished.map_or(&room.emission, |light| &light.radiosity);
    let lit = zip(radiosity, &room.emission).filter(|(_, emission)| emission.max_channel() == 0.0);
    let lit = percentile(lit.map(|(b, _)| b.max_channel()).collect());
    let all = || percentile(radiosity.iter().map(|b| b.max_channel()).collect());
    lit.or_else(all).map_or(1.0, |bright| BRIGHT / bright)
}

/// None where it is not positive.
fn percentile(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let at = (SHARE * values.len().saturating_sub(1) as f64).round() as usize;
    let value = values.get(at).copied();
    value.filter(|value| *value > 0.0 && value.is_finite())
}

/// The unshot light of the channel in hand on a logarithmic scale that ends at the brightest emission.
pub(super) struct Unshot {
    pub channel: &'static str,
    pub brightest: f64,
    /// By patch, from 0 to 1.
    pub shares: Vec<f64>,
}

impl Unshot {
    /// None where the solver does not shoot, or nothing emits. Until it is told, patches have to shoot what they emit.
    pub fn of(state: &State, room: &Enclosure) -> Option<Self> {
        let emission = room.emission.iter();
        let brightest = emission
            .clone()
            .map(|e| e.max_channel())
            .fold(0.0, f64::max);
        if !shoots(room.settings.solver) || brightest <= 0.0 {
            return None;
        }
        let now = state.channel().and_then(|channel| channel.channel);
        let name = now.unwrap_or(CHANNELS[0]);
        let number = CHANNELS.iter().position(|known| *known == name)?;
        let untold = emission.map(|e| e.channels()[number]);
        let unshot: Vec<f64> = match of_channel(state, name) {
            Some(channel) if is_told(channel) => {
                channel.patches.iter().map(|patch| patch.unshot).collect()
            }
            _ => untold.collect(),
        };
        // Of nothing the logarithm is −∞, and the share 0.
        let share = |unshot: f64| 1.0 + (unshot.abs() / brightest).log10() / f64::from(DECADES);
        let shares = unshot
            .into_iter()
            .map(|unshot| share(unshot).clamp(0.0, 1.0));
        Some(Unshot {
            channel: name,
            brightest,
            shares: shares.collect(),
        })
    }
}

/// The colour at `share` of the scale of unshot light, from 0 to 1.
pub(super) fn viridis(share: f64) -> Rgb {
    Rgb::from_srgb8(crate::figure::viridis(share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_bright_patches_do_not_darken_the_rest() {
        let values = (0..100).map(|i| if i < 96 { 2.0 } else { 500.0 });
        assert_eq!(percentile(values.collect()), Some(2.0));
        assert_eq!(percentile(vec![0.0; 5]), None);
        assert_eq!(percentile(Vec::new()), None);
    }
}
