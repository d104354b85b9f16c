//! What a whole run of a method does, counted by kinds of events, of which none is kept.

use super::{
    Draw, Method, RayMethod, Setup, ShadingMethod, Visitor, Wireframe, hierarchical, radiosity,
};
use crate::algorithms;
use crate::algorithms::focus::Focus;
use crate::algorithms::visible::Bvh;
use crate::record::Counter;
use std::convert::Infallible;

/// The events of a whole run.
pub struct Counted {
    pub events: Counter,
    /// Bytes of one event in a recording.
    pub event_size: usize,
}

impl Method {
    /// Counts the events of the whole frame, or of the solution of the enclosure; none where the scene cannot be divided into patches.
    pub fn count(self, setup: &Setup) -> Counted {
        self.visit(Count { setup })
    }
}

struct Count<'a> {
    setup: &'a Setup,
}

impl Count<'_> {
    fn frame<M: Draw>(self) -> Counted {
        let mut events = Counter::default();
        let frame = &mut self.setup.prepared.empty_frame();
        M::draw(self.setup, Focus::Frame, frame, Bvh, &mut events);
        Counted {
            events,
            event_size: size_of::<M::Event>(),
        }
    }
}

impl Visitor for Count<'_> {
    type Output = Counted;

    fn wireframe(self) -> Counted {
        self.frame::<Wireframe>()
    }

    fn shading<M: ShadingMethod>(self) -> Counted {
        self.frame::<M>()
    }

    fn rays<M: RayMethod>(self) -> Counted {
        self.frame::<M>()
    }

    fn radiosity(self) -> Counted {
        let mut events = Counter::default();
        if let Ok(enclosure) = self.setup.enclosure() {
            let matrix = enclosure.matrix_or(|| enclosure.form_factors().estimated());
            // The events are counted whether there is a solution or not.
            let _ = radiosity::solve(enclosure, matrix, Focus::Frame, &mut events);
        }
        Counted {
            events,
            event_size: size_of::<algorithms::radiosity::Event>(),
        }
    }

    fn hierarchical(self) -> Counted {
        let mut events = Counter::default();
        // The events are counted whether there is light or not.
        let Ok(_) = hierarchical::solve(self.setup, &mut events, || Ok::<(), Infallible>(()));
        Counted {
            events,
            event_size: size_of::<algorithms::hierarchical::Event>(),
        }
    }
}
