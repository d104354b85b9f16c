//! Radiosity: the light that the patches of an enclosure exchange, seen from the camera.

use super::{Family, Properties, Visitor};
use crate::algorithms::enclosure::{Enclosure, Light};
use crate::algorithms::focus::Focus;
use crate::algorithms::form_factor::through::blocked_share;
use crate::algorithms::form_factor::{self, FormFactors};
use crate::algorithms::radiosity::{ChannelUnsolved, Event, RecordFilter};
use crate::record::{Recorder, Unrecorded};
use crate::scene::Part;

pub enum Radiosity {}

impl Properties for Radiosity {
    const NAME: &'static str = "radiosity";
    const FAMILY: Family = Family::Exchange;
    const PARTS: &'static [Part] = &[
        Part::DarkChannels,
        Part::EqualChannels,
        Part::BlackRows,
        Part::FacingAway,
        Part::SightTests,
    ];

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.radiosity()
    }
}

/// Solves for the light of the enclosure, of which what `focus` selects is recorded. Errors: why there is no solution, which the
/// last event says too.
pub fn solve<R: Recorder<Event>>(
    enclosure: &Enclosure,
    matrix: &[f64],
    focus: Focus,
    recorder: &mut R,
) -> Result<Light, ChannelUnsolved> {
    let mut filter = RecordFilter::default();
    match focus {
        Focus::Iterations { start, end } => filter.iterations = Some(start..end),
        Focus::Patch(patch) => filter.patch = Some(patch),
        _ => {}
    }
    enclosure.solve(matrix, &filter, recorder)
}

/// How exact the form factor is that others are compared with: unblocked, and what is blocked of it, as a share.
const REFERENCE: form_factor::Method = form_factor::Method::Contour { tolerance: 1e-10 };
const BLOCKED: f64 = 1e-7;

/// F_ij, found in another way than by the methods that are compared with it, unless too much stands between the two.
fn reference(enclosure: &Enclosure, [i, j]: [usize; 2]) -> f64 {
    let patches = &enclosure.patches;
    let of = |blockers| FormFactors::new(patches, REFERENCE, blockers).pair(i, j, &mut Unrecorded);
    let Some(blockers) = enclosure.visibility() else {
        return of(None);
    };
    let unblocked = of(None);
    match blocked_share(patches, blockers, [i, j], BLOCKED * unblocked) {
        Some(blocked) => unblocked - blocked,
        None => of(Some(blockers)),
    }
}

/// Finds the form factor from patch i to patch j, after the one that it is compared with; and once more, where the settings say by what.
pub fn form_factor<R: Recorder<form_factor::Event>>(
    enclosure: &Enclosure,
    [i, j]: [u32; 2],
    recorder: &mut R,
) {
    let [i, j] = [i as usize, j as usize];
    let f = reference(enclosure, [i, j]);
    recorder.step(|| form_factor::Event::Reference { f });
    enclosure.form_factors().pair(i, j, recorder);
    if let Some(method) = enclosure.settings.then_by {
        enclosure.form_factors_by(method).pair(i, j, recorder);
    }
}
