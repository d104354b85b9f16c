//! The state of the wireframe at one step: the picture so far, and the current edge.

use super::Canvas;
use super::Fold;
use super::shading::Dot;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::wireframe::Event;
use crate::color::Rgb;
use glam::DVec2;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub struct State {
    /// What does not change from step to step.
    pub prepared: Arc<PreparedScene>,
    pub canvas: Canvas<Dot>,
    /// Vertices of the current edge.
    pub edge: Option<(u32, u32)>,
    /// Its part within the frame, in pixels.
    pub line: Option<[DVec2; 2]>,
    /// The pixel plotted last on this edge, and the exact point.
    pub pixel: Option<(u32, u32, DVec2)>,
    ink: Rgb,
}

impl State {
    /// Before the first step: an empty picture.
    pub fn new(prepared: Arc<PreparedScene>) -> Self {
        State {
            canvas: Canvas::blank(&prepared),
            ink: crate::algorithms::wireframe::ink(prepared.scene.background),
            prepared,
            edge: None,
            line: None,
            pixel: None,
        }
    }
}

impl Fold<Event> for State {
    fn apply(&mut self, step: usize, event: &Event) {
        match *event {
            Event::Edge { from, to } => self.edge = Some((from, to)),
            Event::EdgeClipped { start, end } => self.line = Some([start, end]),
            Event::PixelPlotted { x, y, exact } => {
                self.pixel = Some((x, y, exact));
                self.canvas.set(
                    x as usize,
                    y as usize,
                    Dot {
                        color: self.ink,
                        step: Some(step as u32),
                        depth: f64::INFINITY,
                    },
                );
            }
            Event::EdgeDone => (self.edge, self.line, self.pixel) = (None, None, None),
            Event::PreparedScene(_) | Event::EdgeUnseen | Event::StepChosen { .. } => {}
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        size_of::<Self>() + self.canvas.bytes_beyond(&before.canvas)
    }
}
