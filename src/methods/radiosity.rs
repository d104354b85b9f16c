//! Radiosity: the light that the patches of a room exchange, seen from the camera.

use super::{Family, Properties, Visitor};
use crate::scene::Part;

pub enum Radiosity {}

impl Properties for Radiosity {
    const NAME: &'static str = "radiosity";
    const FAMILY: Family = Family::Exchange;

    fn does(part: Part) -> bool {
        part.concerns_patches()
    }

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.radiosity()
    }
}
