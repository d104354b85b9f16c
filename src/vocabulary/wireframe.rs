//! The edges alone.

use super::Declared;
use super::entry::{When, entry, is};
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
            entry(
                "event-edge-clipped",
                &[
                    is("{z_a=from_depth} := (from_position − eye) · forward"),
                    is("x_1 = [width; 2] + focal · [(from_position − eye) · right; {z_a=from_depth}]").when(BOTH_ENDS_SEEN),
                    is("y_1 = [height; 2] − focal · [(from_position − eye) · up; {z_a=from_depth}]").when(BOTH_ENDS_SEEN),
                    is("x_1 = 'x_a' + 's' ('x_b' − 'x_a')").when(When::Not(&BOTH_ENDS_SEEN)).unevaluated(CUT),
                    is("y_1 = 'y_a' + 's' ('y_b' − 'y_a')").when(When::Not(&BOTH_ENDS_SEEN)).unevaluated(CUT),
                    is("{z_b=to_depth} := (to_position − eye) · forward"),
                    is("x_2 = [width; 2] + focal · [(to_position − eye) · right; {z_b=to_depth}]").when(BOTH_ENDS_SEEN),
                    is("y_2 = [height; 2] − focal · [(to_position − eye) · up; {z_b=to_depth}]").when(BOTH_ENDS_SEEN),
                    is("x_2 = 'x_a' + 's' ('x_b' − 'x_a')").when(When::Not(&BOTH_ENDS_SEEN)).unevaluated(CUT),
                    is("y_2 = 'y_a' + 's' ('y_b' − 'y_a')").when(When::Not(&BOTH_ENDS_SEEN)).unevaluated(CUT),
                    ],
            ),
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
                    is("x_exact = {x_{old}=x_exact<} + dx").when(GOES_ON),
                    is("y_exact = {y_{old}=y_exact<} + dy").when(GOES_ON),
                    is("x_exact = x_1").when(STARTS),
                    is("y_exact = y_1").when(STARTS),
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

/// Both ends of the edge are within the picture, so that nothing cuts it.
const BOTH_ENDS_SEEN: When = When::All(&[When::True("from_is_seen"), When::True("to_is_seen")]);
/// The pixel before was plotted too.
const GOES_ON: When = When::Known("{x_exact<}");
const STARTS: When = When::All(&[When::Same("x_exact", "x_1"), When::Same("y_exact", "y_1")]);
const CUT: &str = "the borders of the picture and the near plane cut the edge";

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
