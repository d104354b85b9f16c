//! What the exchange of light in an enclosure does not need: channels, equations, integrals and rays whose result is known.

use super::enclosure::{CHANNELS, Enclosure};
use super::radiosity::{Channel, equal_before};
use crate::scene::{LeftOut, Part};

/// What is left out of the form factors and their solution, with its share.
pub fn skipped(enclosure: &Enclosure) -> Vec<LeftOut> {
    let lists = [0, 1, 2].map(|c| enclosure.channel(c));
    let channels = [0, 1, 2].map(|c| Channel {
        name: CHANNELS[c],
        rho: &lists[c].0,
        emission: &lists[c].1,
    });
    let mut skipped = Vec::new();
    for (c, channel) in channels.iter().enumerate() {
        let mut leave_out = |part, like: Option<&str>, share| {
            let as_it = like.map_or(String::new(), |like| format!(" as {like}"));
            skipped.push(LeftOut {
                part,
                place: format!("materials, {}{as_it}", channel.name),
                share,
            });
        };
        let black = channel.rho.iter().filter(|&&rho| rho == 0.0).count();
        if channel.emission.iter().all(|&e| e == 0.0) {
            leave_out(Part::DarkChannels, None, None);
        } else if let Some(like) = equal_before(&channels, c) {
            leave_out(Part::EqualChannels, Some(channels[like].name), None);
        } else if black > 0 {
            leave_out(Part::BlackRows, None, Some([black, channel.rho.len()]));
        }
    }
    if enclosure.settings.form_factors.is_reciprocal() {
        skipped.extend(of_pairs(enclosure));
    }
    skipped
}

/// Integrals and rays that are not needed, by pairs of patches.
fn of_pairs(enclosure: &Enclosure) -> Vec<LeftOut> {
    let (n, form_factors) = (enclosure.patches.len(), enclosure.form_factors());
    let (mut away, mut clear) = (0, 0);
    for i in 0..n {
        for j in i + 1..n {
            if form_factors.face_away(i, j) {
                away += 1;
            } else if enclosure.settings.visibility && !enclosure.blockers.can_stand_between(i, j) {
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
