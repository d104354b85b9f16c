//! Cosines as Taylor series over a triangle, and by differences along its spans.

use super::Declared;
use super::entry::{When, entry, is, only};
use super::scan_line::INCREMENTAL;
use crate::algorithms::fast_phong::{Event, PSEUDOCODE};
use crate::algorithms::shading;
use crate::language::Message;
use crate::record::{self, Fields, Line};

vocabulary! {
    [] Event {
        Event::Shading(event) => event,
    };
    Event::Triangle { triangle, corners: [a, b, c] } => "Triangle" at "triangle" number "triangle" scope "scope-triangle"
        {
            "triangle" = triangle,
            "a" = a,
            "b" = b,
            "c" = c,
        }
        [
            entry("event-triangle", &[]),
        ];
    Event::NormalAtMiddle { middle, n_0, vanished } => "NormalAtMiddle" at "normal-series"
        {
            "x_0" = middle.x,
            "y_0" = middle.y,
            "N_0" = n_0,
            "vanished" = vanished,
        }
        [
            entry("event-normal-at-middle", &[is("x_0"), is("y_0"), is("N_0")]),
        ];
    Event::NormalSlopes { n_x, n_y } => "NormalSlopes" at "normal-series"
        {
            "N_x" = n_x,
            "N_y" = n_y,
        }
        [
            entry("event-normal-slopes", &[is("N_x"), is("N_y")]),
        ];
    Event::Series { cosine, series } => "Series" at "series"
        {
            "cosine" = cosine.name(),
            "T_0" = series.0[0],
            "T_1" = series.0[1],
            "T_2" = series.0[2],
            "T_3" = series.0[3],
            "T_4" = series.0[4],
            "T_5" = series.0[5],
        }
        [
            only(
                When::Is("cosine", "N_dot_L"),
                "event-series-n-dot-l",
                &[
                    is("T_0"),
                    is("T_1"),
                    is("T_2"),
                    is("T_3"),
                    is("T_4"),
                    is("T_5"),
                    ],
            ),
            entry(
                "event-series-highlight",
                &[
                    is("T_0"),
                    is("T_1"),
                    is("T_2"),
                    is("T_3"),
                    is("T_4"),
                    is("T_5"),
                    ],
            ),
        ];
    Event::LightExpanded => "LightExpanded" at "light"
        {
        }
        [
            entry("event-light-expanded", &[]),
        ];
    Event::Expanded => "Expanded" at "triangle"
        {
        }
        [
            entry("event-expanded", &[]),
        ];
    Event::DifferencesStarted { light, cosine, running } => "DifferencesStarted" at "differences"
        {
            "light" = light,
            "cosine" = cosine.name(),
            "c" = running.value,
            "dc" = running.first,
            "d2c" = running.second,
        }
        [
            entry("event-differences-started", &[is("c"), is("dc"), is("d2c")]),
        ];
    Event::CosineEvaluated { light, cosine, running, direct, exact } => "CosineEvaluated" at "increments"
        {
            "light" = light,
            "cosine" = cosine.name(),
            "c" = running.value,
            "dc" = running.first,
            "d2c" = running.second,
            "c_direct" = direct,
            "c_exact" = exact,
            "difference" = running.value - direct,
            "error" = running.value - exact,
        }
        [
            only(
                When::Is("cosine", "N_dot_L"),
                "event-cosine-evaluated-n-dot-l",
                &[
                    is("c = {c_{old}=c<<light,cosine,x_0,y,x-1} + {Δc_{old}=dc<<light,cosine,x_0,y,x-1}"),
                    is("dc = {Δc_{old}=dc<<light,cosine,x_0,y,x-1} + d2c"),
                    is("{Δ=difference}").noted(INCREMENTAL),
                    is("error").noted(APPROXIMATE),
                    ],
            ),
            entry(
                "event-cosine-evaluated-highlight",
                &[
                    is("c = {c_{old}=c<<light,cosine,x_0,y,x-1} + {Δc_{old}=dc<<light,cosine,x_0,y,x-1}"),
                    is("dc = {Δc_{old}=dc<<light,cosine,x_0,y,x-1} + d2c"),
                    is("{Δ=difference}").noted(INCREMENTAL),
                    is("error").noted(APPROXIMATE),
                    ],
            ),
        ];
    Event::LightSummed { power, i_d, i_s } => "LightSummed" at "sum"
        {
            "power" = power,
            "I_d" = i_d,
            "I_s" = i_s,
        }
        [
            entry("event-light-summed", &[is("{c^n=power}"), is("I_d"), is("I_s")]),
        ];
    Event::TriangleDone => "TriangleDone" at "triangle"
        {
        }
        [
            entry("event-triangle-done", &[]),
        ];
}

const APPROXIMATE: Message = Message("note-approximate");

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        Declared::kind(self).name
    }

    fn line(&self) -> Line {
        match self {
            // The directions have lines of their own here, for they are found once a triangle.
            Event::Shading(shading::Event::Illumination(event)) => PSEUDOCODE
                .labelled(event.label())
                .unwrap_or_else(|| PSEUDOCODE.line("expansion")),
            Event::Shading(event) => event.line(),
            _ => PSEUDOCODE.line(self.label()),
        }
    }

    fn fields(&self, fields: &mut Fields) {
        self.push_fields(fields);
    }
}
