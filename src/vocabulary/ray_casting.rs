//! Rays that end at the first surface.

use super::Declared;
use super::entry::{When, entry, is};
use crate::algorithms::ray_casting::{Event, PSEUDOCODE};
use crate::algorithms::{illumination, primary};
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
        Event::PreparedScene(event) => event,
        Event::Primary(event) => event,
        Event::Visible(event) => event,
        Event::Surface(event) => event,
        Event::Illumination(event) => event,
    };
    Event::Ray { ray } => "Ray" at "ray" scope "scope-ray"
        {
            "O" = ray.origin,
            "u" = ray.direction,
        }
        [
            entry("event-ray-primary", &[is("O = eye"), is("u = [screen_point − O; |screen_point − O|]")]),
        ];
    Event::Local { emission, local } => "Local" at "local"
        {
            "emission" = emission,
            "I_local" = local,
        }
        [
            entry("event-local", &[is("I_local = I + emission")]),
        ];
    Event::Returned { color } => "Returned" at "returned"
        {
            "I" = color,
        }
        [
            entry(
                "event-returned",
                &[
                    is("I = {I_local<}").when(When::Known("{I_local<}")),
                    is("I = {color<}").when(When::Not(&When::Known("{I_local<}"))),
                    ],
            ),
        ];
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
