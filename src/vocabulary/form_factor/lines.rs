//! Which line of which listing a step carries out, and whether its values hold for the next.

use crate::algorithms::form_factor::{
    Event, PSEUDOCODE, area_to_area, auto, contour, element_to_polygon, hemicube, monte_carlo,
    sampled, visibility,
};
use crate::record::{self, Fields, Line, Listing};
use crate::vocabulary::Declared;

/// The listings of all methods; a label stands in one of them only.
static LISTINGS: [&Listing; 9] = [
    &PSEUDOCODE,
    &auto::PSEUDOCODE,
    &area_to_area::PSEUDOCODE,
    &element_to_polygon::PSEUDOCODE,
    &contour::PSEUDOCODE,
    &monte_carlo::PSEUDOCODE,
    &hemicube::PSEUDOCODE,
    &visibility::PSEUDOCODE,
    &sampled::PSEUDOCODE,
];

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        let label = match *self {
            // Each choice has a line of its own.
            Event::Chosen { method, .. } => method,
            _ => self.label(),
        };
        let line = LISTINGS.iter().find_map(|listing| listing.labelled(label));
        line.unwrap_or_else(|| PSEUDOCODE.line(label))
    }

    /// The values of one point do not hold for the next.
    fn holds_on(&self) -> bool {
        !matches!(
            self,
            Event::Points { .. }
                | Event::Pair { .. }
                | Event::Edge { .. }
                | Event::EdgeAdded { .. }
                | Event::EdgePair { .. }
                | Event::Ray { .. }
                | Event::Pixel { .. }
                | Event::Sight { .. }
                | Event::Seen { .. }
        )
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
