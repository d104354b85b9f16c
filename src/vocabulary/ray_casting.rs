//! Rays that end at the first surface.

use super::Declared;
use super::entry::{entry, is};
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
    Event::Ray { ray } => "Ray" at "ray" scope ("ray", "sinar")
        {
            "O" = ray.origin,
            "u" = ray.direction,
        }
        [
            entry(
                "The primary ray begins at the eye O and goes through P_s, the point on the screen; u is its unit direction.",
                "Sinar primer mulai dari mata O melewati P_s, titik di layar; u arah satuannya.",
                &[is("{O}"), is("{u} = [P_s − O; |P_s − O|]")],
            ),
        ];
    Event::Local { emission, local } => "Local" at "local"
        {
            "emission" = emission,
            "I_local" = local,
        }
        [
            entry(
                "The local term: the light that arrives, and what the surface gives off itself.",
                "Suku lokal: cahaya yang sampai, dan yang dipancarkan permukaan sendiri.",
                &[is("{I_local} = {I} + {emission}")],
            ),
        ];
    Event::Returned { color } => "Returned" at "returned"
        {
            "I" = color,
        }
        [
            entry(
                "The light that comes back along the ray.",
                "Cahaya yang kembali sepanjang sinar.",
                &[is("{I}")],
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
