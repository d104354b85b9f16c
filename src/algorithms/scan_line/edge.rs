//! An edge of the edge table.

use super::corner::ScreenCorner;
use super::event::Event;
use super::varying::Varying;
use crate::numeric::Ramp;

/// An edge from its upper to its lower end, and where the current scan line cuts it.
///
/// Invariant: equal ends give equal edges, in whichever direction a polygon runs along them.
#[derive(Clone, Copy, Debug)]
pub struct Edge<V> {
    /// Position in its polygon: from corner `number` to the next.
    pub number: u32,
    pub upper: End<V>,
    pub lower: End<V>,
    /// The first row of the frame whose centre it reaches, and the row behind the last.
    pub first: u32,
    pub end: u32,
    /// dx/dy
    pub slope: f64,
    /// Where the scan line cuts it.
    pub x_4: f64,
    /// The value on the current scan line.
    pub value: Ramp<V>,
    pub inverse_depth: Ramp<f64>,
}

/// An end of an edge, on the screen.
#[derive(Clone, Copy, Debug)]
pub struct End<V> {
    pub corner: u32,
    pub x: f64,
    pub y: f64,
    pub value: V,
}

impl<V: Varying> Edge<V> {
    /// The edge between two corners, or `None` where it passes the centre of no row: a horizontal edge never does.
    pub fn between(
        corners: &[ScreenCorner<V>],
        from: usize,
        to: usize,
        height: u32,
    ) -> Option<Self> {
        let end = |corner: usize| {
            let ScreenCorner { x, y, value, .. } = corners[corner];
            End {
                corner: corner as u32,
                x,
                y,
                value,
            }
        };
        let (upper, lower) = if corners[from].y <= corners[to].y {
            (from, to)
        } else {
            (to, from)
        };
        let (depth_1, depth_2) = (corners[upper].inverse_depth, corners[lower].inverse_depth);
        let (upper, lower) = (end(upper), end(lower));
        let first = first_centre(upper.y, height);
        let end = first_centre(lower.y, height);
        if first >= end {
            return None;
        }
        let y_4 = f64::from(first) + 0.5;
        Some(Edge {
            number: from as u32,
            upper,
            lower,
            first,
            end,
            slope: (lower.x - upper.x) / (lower.y - upper.y),
            x_4: upper.x,
            value: Ramp::start(upper.value, upper.y, lower.value, lower.y, y_4),
            inverse_depth: Ramp::start(depth_1, upper.y, depth_2, lower.y, y_4),
        })
    }

    /// Moves the cut to the line at height `y_4`, directly.
    pub fn cut(&mut self, y_4: f64) {
        self.x_4 = self.upper.x + (y_4 - self.upper.y) * self.slope;
    }

    /// One scan line down.
    pub fn advance(&mut self) {
        self.value.advance();
        self.inverse_depth.advance();
    }

    /// Its entry in the edge table.
    pub fn listed(&self) -> Event<V::Recorded> {
        Event::EdgeEntered {
            edge: self.number,
            upper: self.upper.corner,
            lower: self.lower.corner,
            first: self.first,
            end: self.end,
            slope: self.slope,
            step: self.value.step.recorded(),
        }
    }

    pub fn entered(&self) -> Event<V::Recorded> {
        Event::Edge {
            edge: self.number,
            upper: self.upper.corner,
            lower: self.lower.corner,
            y_1: self.upper.y,
            y_2: self.lower.y,
            x_4: self.x_4,
            z_4: 1.0 / self.inverse_depth.value,
        }
    }

    pub fn ends(&self) -> Event<V::Recorded> {
        Event::EdgeEnds {
            upper: self.upper.value.recorded(),
            lower: self.lower.value.recorded(),
        }
    }

    /// The (u, v) of a texture, where there is one.
    pub fn textured(&self) -> Option<Event<V::Recorded>> {
        Some(Event::EdgeTextured {
            upper: self.upper.value.texture()?,
            lower: self.lower.value.texture()?,
            cut: self.value.value.texture()?,
        })
    }
}

/// The first row or column, within 0..=size, whose centre is not before `edge`.
#[inline]
pub fn first_centre(edge: f64, size: u32) -> u32 {
    // A cast from float saturates, and takes NaN to 0.
    ((edge - 0.5).ceil() as u32).min(size)
}
