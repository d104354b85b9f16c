//! The edges alone.

use super::Declared;
use super::entry::{entry, is};
use crate::algorithms::wireframe::{Event, PSEUDOCODE};
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
        Event::PreparedScene(event) => event,
    };
    Event::Edge { from, to } => "Edge" at "edge" number "from" scope ("edge", "sisi")
        {
            "from" = from,
            "to" = to,
        }
        [
            entry(
                "The edge between vertices {from} and {to} is not drawn yet.",
                "Sisi antara titik sudut {from} dan {to} belum digambar.",
                &[],
            ),
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
                "The part of the edge within the frame, in pixels.",
                "Bagian sisi yang di dalam gambar, dalam piksel.",
                &[is("{x_1}"), is("{y_1}"), is("{x_2}"), is("{y_2}")],
            ),
        ];
    Event::EdgeUnseen => "EdgeUnseen" at "clip"
        {
        }
        [
            entry(
                "Nothing of this edge is within the frame.",
                "Tidak ada bagian sisi ini di dalam gambar.",
                &[],
            ),
        ];
    Event::StepChosen { n, step } => "StepChosen" at "steps"
        {
            "n" = n,
            "dx" = step.x,
            "dy" = step.y,
        }
        [
            entry(
                "One pixel a step, along the longer of the two directions.",
                "Satu piksel tiap langkah, sepanjang arah yang lebih panjang.",
                &[
                    is("{n} = ⌈max(|{x_2} − {x_1}|, |{y_2} − {y_1}|)⌉"),
                    is("{Δx/n=dx} = [{x_2} − {x_1}; {n}]"),
                    is("{Δy/n=dy} = [{y_2} − {y_1}; {n}]"),
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
                "Pixel ({x}, {y}) is plotted: the one in which the exact point lies.",
                "Piksel ({x}, {y}) digambar: piksel yang memuat titik tepatnya.",
                &[
                    is("{x} = min(⌊{x_exact}⌋, {width} − 1)"),
                    is("{y} = min(⌊{y_exact}⌋, {height} − 1)"),
                    ],
            ),
        ];
    Event::EdgeDone => "EdgeDone" at "edge"
        {
        }
        [
            entry(
                "The edge is drawn.",
                "Sisi selesai digambar.",
                &[],
            ),
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
