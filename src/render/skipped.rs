//! What a method leaves out of a picture because the scene does not need it.

use super::Method;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::scene::LeftOut;

/// What the scene does not need of what `method` would do, done all the same or not. A room that cannot be divided needs nothing.
pub fn skipped(prepared: &PreparedScene, method: Method) -> Vec<LeftOut> {
    let all = match method {
        Method::Radiosity => prepared
            .enclosure()
            .map_or(&[][..], |enclosure| enclosure.skipped()),
        _ => &prepared.needs().skipped,
    };
    let done = all.iter().filter(|skipped| method.does(skipped.part));
    done.cloned().collect()
}
