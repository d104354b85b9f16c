//! The edges alone.

use super::Declared;
use super::entry::{entry, is};
use crate::algorithms::wireframe::{Event, PSEUDOCODE};
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
        Event::PreparedScene(event) => event,
    };
    Event::Edge { from, to } => "Edge" at "edge" number "from" scope "scope-edge"
        {
            "from" = from,
            "to" = to,
        }
        [
            entry("event-edge-undrawn", &[]),
        ];
    Event::EdgeClipped { start, end } => "EdgeClipped" at "clip"
        {
            "x_1" = start.x,
            "y_1" = start.y,
            "x_2" = end.x,
            "y_2" = end.y,
        }
        [
            entry("event-edge-clipped", &[is("x_1"), is("y_1"), is("x_2"), is("y_2")]),
        ];
    Event::EdgeUnseen => "EdgeUnseen" at "clip"
        {
        }
        [
            entry("event-edge-unseen", &[]),
        ];
    Event::StepChosen { n, step } => "StepChosen" at "steps"
        {
            "n" = n,
            "dx" = step.x,
            "dy" = step.y,
        }
        [
            entry(
                "event-step-chosen",
                &[
                    is("n = ⌈max(1, |x_2 − x_1|, |y_2 − y_1|)⌉"),
                    is("{Δx/n=dx} = [x_2 − x_1; n]"),
                    is("{Δy/n=dy} = [y_2 − y_1; n]"),
                    ],
            ),
        ];
    Event::PixelPlotted { x, y, exact } => "PixelPlotted" at "plot"
        {
            "x" = x,
            "y" = y,
            "x_exact" = exact.x,
            "y_exact" = exact.y,
        }
        [
            entry(
                "event-pixel-plotted",
                &[
                    is("x = max(0, min(⌊x_exact⌋, width − 1))"),
                    is("y = max(0, min(⌊y_exact⌋, height − 1))"),
                    ],
            ),
        ];
    Event::EdgeDone => "EdgeDone" at "edge"
        {
        }
        [
            entry("event-edge-done", &[]),
        ];
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        PSEUDOCODE.line(self.label())
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
