//! What `radiosity` says of the errors of its form factors, and of its result with them.

use super::failure::note;
use super::progress::named;
use crate::algorithms::accuracy::{Accuracy, Excess};
use crate::algorithms::enclosure::{Enclosure, Light};
use crate::render::reference_errors;
use crate::scene::Scene;
use serde_json::{Value as Json, json};
use std::num::NonZeroUsize;
use std::thread::available_parallelism;

/// The accuracy of a matrix that was made; none without one.
pub fn of(enclosure: &Enclosure) -> Option<Accuracy<'_>> {
    let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
    let reference = named("estimating the errors", || {
        reference_errors(enclosure, threads)
    });
    Some(Accuracy::of(enclosure.exchange()?, reference))
}

/// The keys of a result that say how exact it is: null where form factors were found one by one.
pub fn json(enclosure: &Enclosure, accuracy: Option<&Accuracy>, light: &Light) -> Json {
    let Some((accuracy, exchange)) = accuracy.zip(enclosure.exchange()) else {
        return json!({ "rows": null, "reciprocity_error": null, "closed": null, "closure_defect": null, "closure_correction": null,
            "form_factor_error": null, "total_error": [null, null, null] });
    };
    let [least, largest] = exchange.report.row_sums;
    json!({
        "rows": { "least": least, "largest": largest },
        "reciprocity_error": exchange.report.reciprocity_defect,
        "closed": exchange.is_closed,
        "closure_defect": exchange.report.closure_defect,
        "closure_correction": exchange.correction.as_ref().map_or(0.0, |correction| correction.size()),
        "form_factor_error": accuracy.largest_error(),
        "total_error": accuracy.total_errors(enclosure, light),
    })
}

/// Says on standard error which row sums to more than its estimated error allows.
pub fn report_excess(scene: &Scene, enclosure: &Enclosure, accuracy: &Accuracy) {
    if let Some(excess) = accuracy.excess() {
        let excess = in_words(scene, enclosure, &excess);
        note(format_args!("lightwalk: {excess}"));
    }
}

/// Why light is gained in reflection.
pub fn why_light_is_gained(scene: &Scene, enclosure: &Enclosure) -> Option<String> {
    let accuracy = of(enclosure)?;
    let exchange = enclosure.exchange()?;
    let [_, largest] = exchange.report.row_sums;
    if !exchange.is_opaque {
        return Some(format!(
            "form factors from a patch sum to {largest}, since patches are seen through what casts no shadow, or is not to block (--visibility none)"
        ));
    }
    if let Some(excess) = accuracy.excess() {
        return Some(in_words(scene, enclosure, &excess));
    }
    Some(format!(
        "form factors from a patch sum to {largest}, which is right to an estimated {:.1e}; that is more than the light that is lost. \
         More exact ones are found by --form-factors auto, and --closure auto corrects those of a closed scene",
        accuracy.largest_error()
    ))
}

fn in_words(scene: &Scene, enclosure: &Enclosure, excess: &Excess) -> String {
    let Excess {
        patch,
        sum,
        estimate,
    } = *excess;
    let patch = &enclosure.patches[patch];
    let object = &scene.objects[patch.object as usize].name;
    format!(
        "the form factors from patch {:?} of {object:?} sum to {sum}, more than 1 by more than their estimated error of {estimate:.1e}: \
         this is an error of the program and not of the scene, and the result is off by as much as its `total_error` says",
        patch.cell
    )
}
