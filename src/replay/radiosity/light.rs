//! The light of every patch at a step, in all channels.

use super::{ChannelNow, State};
use crate::algorithms::enclosure::{CHANNELS, Enclosure};
use crate::color::Rgb;
use std::iter::zip;

/// What the patches have still to shoot in the current channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Unshot {
    pub channel: &'static str,
    /// The brightest emission of any channel.
    pub brightest: f64,
    pub patches: Vec<f64>,
}

impl State {
    /// The radiosity of every patch so far. It begins with the emission; a channel that is still to be solved is dark, unless it is
    /// equal to one before it, whose light it shares: a grey enclosure is grey from the first step on. Where patches shoot, their
    /// unshot radiosity, which they already have, counts (Cohen, Chen, Wallace & Greenberg 1988).
    pub fn light(&self, enclosure: &Enclosure) -> Vec<Rgb> {
        self.of_channels(enclosure, true)
    }

    /// The same without what is still unshot: B alone, where patches shoot.
    pub fn radiosity(&self, enclosure: &Enclosure) -> Vec<Rgb> {
        self.of_channels(enclosure, false)
    }

    fn of_channels(&self, enclosure: &Enclosure, with_unshot: bool) -> Vec<Rgb> {
        if self.channels.is_empty() {
            return enclosure.emission.clone();
        }
        let [red, green, blue] = [0, 1, 2].map(|c| {
            self.solved_channel(CHANNELS[enclosure.first_equal_channel(c)])
                .map_or_else(
                    || vec![0.0; enclosure.patches.len()],
                    |channel| {
                        let emission = enclosure.emission.iter().map(|e| e.channels()[c]);
                        channel.radiosity(emission, with_unshot)
                    },
                )
        });
        let channels = zip(red, zip(green, blue));
        channels.map(|(r, (g, b))| Rgb::new(r, g, b)).collect()
    }

    /// None where the solver does not shoot, or nothing emits. Before the first shot, patches have to shoot what they emit.
    pub fn unshot(&self, enclosure: &Enclosure) -> Option<Unshot> {
        let emission = enclosure.emission.iter();
        let brightest = emission
            .clone()
            .map(|e| e.max_channel())
            .fold(0.0, f64::max);
        if !enclosure.settings.solver.shoots() || brightest <= 0.0 {
            return None;
        }
        let now = self.channel().and_then(|channel| channel.channel);
        let channel = now.unwrap_or(CHANNELS[0]);
        let number = CHANNELS.iter().position(|known| *known == channel)?;
        let patches = match self.solved_channel(channel) {
            Some(solved) if solved.has_begun() => {
                solved.patches.iter().map(|patch| patch.unshot).collect()
            }
            _ => emission.map(|e| e.channels()[number]).collect(),
        };
        Some(Unshot {
            channel,
            brightest,
            patches,
        })
    }

    /// The channel as it was solved, possibly under the name of an equal one; none where it is dark or still to be solved.
    fn solved_channel(&self, name: &str) -> Option<&ChannelNow> {
        let mut recorded = self.channels.iter().rev();
        let channel =
            recorded.find(|channel| channel.channel.is_none_or(|recorded| recorded == name))?;
        match channel.skipped {
            None => Some(channel),
            Some((_, Some(like))) if like != name => self.solved_channel(like),
            Some(_) => None,
        }
    }
}

impl ChannelNow {
    fn has_begun(&self) -> bool {
        self.patches.iter().any(|patch| patch.step.is_some())
    }

    fn radiosity(&self, emission: impl Iterator<Item = f64>, with_unshot: bool) -> Vec<f64> {
        if !self.has_begun() {
            return emission.collect();
        }
        let unshot_counts = f64::from(u8::from(with_unshot && self.solver.shoots()));
        let patches = self.patches.iter();
        patches
            .map(|patch| patch.b + unshot_counts * patch.unshot)
            .collect()
    }
}
