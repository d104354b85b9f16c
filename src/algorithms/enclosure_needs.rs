//! What the exchange of light in an enclosure does not need: channels, equations, integrals and rays whose result is known; and
//! which of that is done although it is not needed.

use super::form_factor::{Blockers, FormFactors, Shortcuts};
use super::radiosity::{Channel, Known};
use crate::scene::{LeftOut, Part, Parts};

/// What is known of each channel without solving it, but for what is `forced`.
pub fn known_channels<const N: usize>(
    channels: &[Channel; N],
    forced: Parts,
) -> [Option<Known>; N] {
    let known = |c: usize| {
        let Channel { rho, emission, .. } = channels[c];
        if emission.iter().all(|&e| e == 0.0) && !forced.has(Part::DarkChannels) {
            return Some(Known::Dark);
        }
        let mut before = channels[..c].iter();
        let equal = before.position(|other| (other.rho, other.emission) == (rho, emission));
        equal
            .filter(|_| !forced.has(Part::EqualChannels))
            .map(Known::EqualTo)
    };
    std::array::from_fn(known)
}

/// What is left out between two patches, but for what is `forced`.
pub fn shortcuts(forced: Parts) -> Shortcuts {
    Shortcuts {
        facing_away: !forced.has(Part::FacingAway),
        sight_tests: !forced.has(Part::SightTests),
    }
}

/// Channels and equations that are not needed, each with its share.
pub fn skipped_of_channels<const N: usize>(channels: &[Channel; N]) -> Vec<LeftOut> {
    let known = known_channels(channels, Parts::NONE);
    let mut skipped = Vec::new();
    for (channel, known) in channels.iter().zip(known) {
        let black = channel.rho.iter().filter(|&&rho| rho == 0.0).count();
        let (part, like, share) = match known {
            Some(Known::Dark) => (Part::DarkChannels, String::new(), None),
            Some(Known::EqualTo(c)) => {
                let like = format!(" as {}", channels[c].name);
                (Part::EqualChannels, like, None)
            }
            None if black > 0 => {
                let share = Some([black, channel.rho.len()]);
                (Part::BlackRows, String::new(), share)
            }
            None => continue,
        };
        skipped.push(LeftOut {
            part,
            place: format!("materials, {}{like}", channel.name),
            share,
        });
    }
    skipped
}

/// Integrals and rays that are not needed, by pairs of `n` patches. Without `blockers` there are no rays.
pub fn skipped_of_pairs(
    n: usize,
    form_factors: &FormFactors,
    blockers: Option<&Blockers>,
) -> Vec<LeftOut> {
    let (mut away, mut clear) = (0, 0);
    for i in 0..n {
        for j in i + 1..n {
            if form_factors.face_away(i, j) {
                away += 1;
            } else if blockers.is_some_and(|blockers| !blockers.can_stand_between(i, j)) {
                clear += 1;
            }
        }
    }
    let pairs = n * n.saturating_sub(1) / 2;
    let counted = [
        (Part::FacingAway, away, pairs),
        (Part::SightTests, clear, pairs - away),
    ];
    let some = counted.into_iter().filter(|&(_, count, _)| count > 0);
    some.map(|(part, count, all)| LeftOut {
        part,
        place: "objects".into(),
        share: Some([count, all]),
    })
    .collect()
}
