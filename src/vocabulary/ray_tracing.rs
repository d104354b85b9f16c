//! Rays that go on: what happens on the way is declared with its part.

use super::Declared;
use crate::algorithms::ray_tracing::{Event, PSEUDOCODE};
use crate::algorithms::{illumination, primary};
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
        Event::PreparedScene(event) => event,
        Event::Primary(event) => event,
        Event::Visible(event) => event,
        Event::Surface(event) => event,
        Event::Illumination(event) => event,
        Event::Tree(event) => event,
    };
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        match self {
            Event::Illumination(event) => illumination::PSEUDOCODE.line(event.label()),
            _ => PSEUDOCODE.line(self.label()),
        }
    }

    fn holds_on(&self) -> bool {
        match self {
            // A pixel of several samples goes through several points.
            Event::Primary(primary::Event::Through { .. }) => false,
            Event::Visible(event) => !event.tests_one(),
            _ => true,
        }
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
