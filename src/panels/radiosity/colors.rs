//! The unshot light of one channel on a logarithmic scale.

use crate::replay::radiosity::Unshot;

/// The scale spans so many powers of ten, up to the brightest emission.
pub(super) const DECADES: i32 = 4;

/// The place on the scale, from 0 to 1, of every patch.
pub(super) fn shares(unshot: &Unshot) -> Vec<f64> {
    // Of nothing the logarithm is −∞, and the share 0.
    let share = |patch: f64| 1.0 + (patch.abs() / unshot.brightest).log10() / f64::from(DECADES);
    let patches = unshot.patches.iter();
    patches.map(|&patch| share(patch).clamp(0.0, 1.0)).collect()
}
