//! What a method leaves out of a picture because the scene does not need it.

use super::Method;
use crate::algorithms::stage::Stage;
use crate::scene::LeftOut;

/// What the scene does not need of what `method` would do, done all the same or not. A room that cannot be divided needs nothing.
pub fn left_out(stage: &Stage, method: Method) -> Vec<LeftOut> {
    let all = match method {
        Method::Radiosity => stage.room().map_or(&[][..], |room| room.left_out()),
        _ => &stage.needs().left_out,
    };
    let done = all.iter().filter(|left_out| method.does(left_out.part));
    done.cloned().collect()
}
