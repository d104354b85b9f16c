//! Wireframe: only the edges of the polygons, by the digital differential analyser
//! (Foley, van Dam, Feiner, Hughes 1990, §3.2.1), after Liang–Barsky clipping (1984).
//!
//! Screen frame as in [`scan_line`](super::scan_line). Hidden lines are drawn too. An edge that polygons of one object share is drawn once.

use super::focus::{Focus, Region};
use super::frame::Frame;
use super::prepared_scene::{self, Polygon, PreparedScene};
use crate::color::Rgb;
use crate::numeric::Ramp;
use crate::record::{Listing, Recorder};
use crate::scene::View;
use glam::{DVec2, DVec3};
use std::collections::HashSet;

pub static PSEUDOCODE: Listing = Listing {
    name: "wireframe",
    lines: &[
        ("polygon", "{for-each-polygon}"),
        ("edge", "  {for-each-edge-not-yet-drawn}"),
        ("clip", "    {clip-the-edge-to-what-the-eye-sees}"),
        ("steps", "    n ← max(|Δx|, |Δy|), {rounded-up}"),
        ("", "    {for} i = 0 … n"),
        ("plot", "      {plot-the-pixel-at-x-y}"),
        ("", "      x ← x + Δx/n;  y ← y + Δy/n"),
    ],
};

/// Draws what `focus` selects of the prepared scene into `frame`, a band of its picture.
pub fn wireframe<R: Recorder<Event>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    let region = focus.region(frame);
    let ink = ink(prepared.scene.background);
    let mut drawn = HashSet::new();
    let mut object = None;

    recorder.enter(|| prepared.entered().into());
    for polygon in prepared.polygons(focus, &region) {
        recorder.enter(|| polygon.entered().into());
        if object.replace(polygon.object) != Some(polygon.object) {
            drawn.clear();
        }
        for (from, to) in edges(&polygon) {
            if !drawn.insert((from.min(to), from.max(to))) {
                continue;
            }
            recorder.enter(|| Event::Edge { from, to });
            let ends =
                [from, to].map(|vertex| prepared.view.to_camera(polygon.mesh.position(vertex)));
            match visible_part(ends, &prepared.view) {
                Some([start, end]) => {
                    recorder.step(|| Event::EdgeClipped { start, end });
                    draw_line([start, end], ink, &prepared.view, &region, frame, recorder);
                }
                None => recorder.step(|| Event::EdgeUnseen),
            }
            recorder.leave(|| Event::EdgeDone);
        }
        recorder.leave(|| prepared_scene::Event::PolygonDone.into());
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

/// The colour of the lines: black on a light background, white on a dark one.
pub fn ink(background: Rgb) -> Rgb {
    // 0.18 is the linear intensity that looks half-way from black to white.
    if background.luminance() < 0.18 {
        Rgb::WHITE
    } else {
        Rgb::BLACK
    }
}

/// The pairs of neighbouring vertices of a polygon.
fn edges<'a>(polygon: &Polygon<'a>) -> impl Iterator<Item = (u32, u32)> + 'a {
    let vertices = polygon.mesh.face(polygon.face);
    (0..vertices.len()).map(|corner| (vertices[corner], vertices[(corner + 1) % vertices.len()]))
}

/// One pixel per step along the longer of the two directions. Both ends must lie in the frame.
fn draw_line(
    [start, end]: [DVec2; 2],
    ink: Rgb,
    view: &View,
    region: &Region,
    frame: &mut Frame,
    recorder: &mut impl Recorder<Event>,
) {
    let delta = end - start;
    let steps = delta.abs().max_element().ceil().max(1.0);
    recorder.step(|| Event::StepChosen {
        n: steps as u32,
        step: delta / steps,
    });
    let mut x = Ramp {
        value: start.x,
        step: delta.x / steps,
    };
    let mut y = Ramp {
        value: start.y,
        step: delta.y / steps,
    };
    for _ in 0..=steps as u32 {
        // The outermost pixels also own the borders of the frame, and what rounding carries just beyond them.
        let (column, row) = (
            (x.value as u32).min(view.width - 1),
            (y.value as u32).min(view.height - 1),
        );
        if region.columns.contains(&column) && region.rows.contains(&row) {
            let index = frame.index(column, row);
            frame.color[index] = ink;
            recorder.step(|| Event::PixelPlotted {
                x: column,
                y: row,
                exact: DVec2::new(x.value, y.value),
            });
        }
        x.advance();
        y.advance();
    }
}

/// The part of an edge, given in the camera frame, that is beyond the near plane and within the frame; on the screen.
fn visible_part([a, b]: [DVec3; 2], view: &View) -> Option<[DVec2; 2]> {
    let (mut t_0, mut t_1) = (0.0, 1.0);
    clip(b.z - a.z, a.z - view.near, &mut t_0, &mut t_1)?;
    let [start, end] = [t_0, t_1].map(|t| {
        let point = a + (b - a) * t;
        view.to_screen(DVec3::new(point.x, point.y, point.z.max(view.near)))
    });
    let (mut t_0, mut t_1) = (0.0, 1.0);
    let delta = end - start;
    clip(delta.x, start.x, &mut t_0, &mut t_1)?;
    clip(
        -delta.x,
        f64::from(view.width) - start.x,
        &mut t_0,
        &mut t_1,
    )?;
    clip(delta.y, start.y, &mut t_0, &mut t_1)?;
    clip(
        -delta.y,
        f64::from(view.height) - start.y,
        &mut t_0,
        &mut t_1,
    )?;
    let size = DVec2::new(f64::from(view.width), f64::from(view.height));
    Some([t_0, t_1].map(|t| (start + delta * t).clamp(DVec2::ZERO, size)))
}

/// One boundary of Liang and Barsky: narrows [t_0, t_1] to where `inside + t·toward ≥ 0`; `None` where nothing is left.
fn clip(toward: f64, inside: f64, t_0: &mut f64, t_1: &mut f64) -> Option<()> {
    let t = -inside / toward;
    if toward > 0.0 {
        *t_0 = t.max(*t_0);
    } else if toward < 0.0 {
        *t_1 = t.min(*t_1);
    } else if inside < 0.0 {
        return None;
    }
    (*t_0 <= *t_1).then_some(())
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    PreparedScene(prepared_scene::Event),
    /// Opens an edge between two vertices of the object's mesh.
    Edge {
        from: u32,
        to: u32,
    },
    /// The part within the frame, in pixels.
    EdgeClipped {
        start: DVec2,
        end: DVec2,
    },
    /// Nothing of the edge is within the frame.
    EdgeUnseen,
    StepChosen {
        n: u32,
        step: DVec2,
    },
    /// `exact` is the point on the line, by increments.
    PixelPlotted {
        x: u32,
        y: u32,
        exact: DVec2,
    },
    /// Closes `Edge`.
    EdgeDone,
}

const _: () = assert!(size_of::<Event>() <= 64);

contains_events! {
    [] Event {
        prepared_scene::Event => Event::PreparedScene,
    }
}
