//! Where the rows and their bars lie.

use crate::picture::Rect;
use crate::record::Outline;
use crate::replay::Walk;
use glam::Vec2;
use std::ops::Range;

pub const MARGIN: f32 = 10.0;
/// Above the track and below the rows.
pub const EDGE: f32 = 4.0;
/// Height of the track with the marks.
pub const TRACK: f32 = 14.0;
pub const ROW: f32 = 16.0;
pub const ROW_GAP: f32 = 3.0;
/// Rows shown unless there is more room.
pub const USUAL_ROWS: usize = 3;
/// Bars are at least this wide, and so are the places of the marks.
pub const NARROWEST: f64 = 3.0;
/// The bars of a run are all drawn on one scale where a step has this width.
pub const WHOLE_RUN: f64 = 2.0;

/// The place of the track; names of the rows stand to the left of it.
pub fn track(size: Vec2) -> Rect {
    let names = (0.16 * size.x).clamp(64.0, 140.0);
    Rect::new(MARGIN + names, EDGE, size.x - 2.0 * MARGIN - names, TRACK)
}

/// Steps laid out from left to right, all of the same width.
#[derive(Clone, PartialEq, Debug)]
pub struct Span {
    pub steps: Range<usize>,
    pub left: f64,
    /// Points a step.
    pub scale: f64,
}

impl Span {
    pub fn new(steps: Range<usize>, place: Rect) -> Self {
        let scale = f64::from(place.width).max(0.0) / steps.len().max(1) as f64;
        Span {
            steps,
            left: f64::from(place.x),
            scale,
        }
    }

    /// The left border of a step.
    pub fn x(&self, step: usize) -> f32 {
        (self.left + (step as f64 - self.steps.start as f64) * self.scale) as f32
    }

    pub fn middle(&self, step: usize) -> f32 {
        (self.left + (step as f64 + 0.5 - self.steps.start as f64) * self.scale) as f32
    }

    /// The step at `x`; beyond the ends the first or the last.
    pub fn step(&self, x: f32) -> usize {
        // A cast from float saturates.
        let steps = ((f64::from(x) - self.left) / self.scale) as usize;
        (self.steps.start + steps).min(self.steps.end.saturating_sub(1))
    }

    /// How many steps are as wide as the narrowest bar.
    pub fn slot(&self) -> usize {
        self.steps_in(NARROWEST)
    }

    /// How many steps take so many points, one at least; where no width is left, all of them.
    pub fn steps_in(&self, points: f64) -> usize {
        let steps = (points / self.scale).ceil() as usize;
        steps.clamp(1, self.steps.len().max(1))
    }
}

/// A bar: one scope, or several that are too narrow to be distinct.
#[derive(Clone, PartialEq, Debug)]
pub struct Bar {
    pub steps: Range<usize>,
    pub several: bool,
}

pub struct Row {
    pub place: Rect,
    pub span: Span,
    pub bars: Vec<Bar>,
    /// The scope of this depth around the cursor.
    pub current: Option<usize>,
    /// The steps that must not be shown yet.
    pub hidden: Option<Range<usize>>,
}

impl Row {
    /// Ends the bars at `step`: how far they go, and what follows, must not be shown yet.
    pub fn hide_after(&mut self, step: usize) {
        let end = (step + 1).max(self.span.steps.start);
        self.bars.retain(|bar| bar.steps.start < end);
        for bar in &mut self.bars {
            bar.steps.end = bar.steps.end.min(end);
        }
        self.hidden = Some(end..self.span.steps.end).filter(|hidden| !hidden.is_empty());
    }
}

/// Of the track and so many rows below it.
pub fn height(rows: usize) -> f32 {
    EDGE + TRACK + 4.0 + rows as f32 * (ROW + ROW_GAP)
}

/// The rows that fit, those of the outermost depths first; where the cursor is deeper, the rows around it.
pub fn rows(walk: &dyn Walk, size: Vec2) -> Vec<Row> {
    let outline = walk.outline();
    let position = walk.position();
    let track = track(size);
    let whole = 0..walk.len();
    let short = f64::from(track.width) >= WHOLE_RUN * whole.len() as f64;

    // The scopes around the cursor from the outermost; the one that the step itself opens is among them.
    let mut around: Vec<usize> = outline.scopes(position).collect();
    around.reverse();
    if outline.opens(position) {
        around.push(position);
    }
    let mut rows: Vec<Row> = (0..=around.len())
        .map(|depth| {
            let steps = match depth.checked_sub(1) {
                Some(parent) if !short => around[parent] + 1..outline.last(around[parent]) + 1,
                _ => whole.clone(),
            };
            let span = Span::new(steps, track);
            Row {
                place: track,
                bars: bars(outline, &span, depth),
                span,
                current: around.get(depth).copied(),
                hidden: None,
            }
        })
        .filter(|row| !row.bars.is_empty())
        .collect();
    // A scope around the whole run says nothing.
    if rows.len() > 1 && rows[0].bars.len() == 1 {
        rows.remove(0);
    }

    let top = height(0);
    let room = ((size.y - top - EDGE + ROW_GAP) / (ROW + ROW_GAP)) as usize;
    rows.drain(..rows.len().saturating_sub(room));
    for (i, row) in rows.iter_mut().enumerate() {
        row.place.y = top + i as f32 * (ROW + ROW_GAP);
        row.place.height = ROW;
    }
    rows
}

/// The scopes of `depth` within the span, from left to right; narrow neighbours as one bar. Looks at one step for every
/// bar or gap, and at the scopes around it.
pub fn bars(outline: &Outline, span: &Span, depth: usize) -> Vec<Bar> {
    let slot = span.slot();
    let mut bars: Vec<Bar> = Vec::new();
    let mut step = span.steps.start;
    while step < span.steps.end {
        let Some(scope) = scope_at(outline, step, depth) else {
            step += slot;
            if slot > 1
                && let Some(scope) = scope_at(outline, step.min(span.steps.end - 1), depth)
            {
                // The jump may have passed the beginning of a scope.
                step = scope.max(step + 1 - slot);
            }
            continue;
        };
        let end = outline.last(scope) + 1;
        if end - step >= slot {
            bars.push(Bar {
                steps: step..end,
                several: step != scope,
            });
            step = end;
            continue;
        }
        // From here on to the next slot, or as far as the scope there reaches; a wide one has a bar of its own.
        let mut next = (step + slot).min(span.steps.end);
        if next < span.steps.end
            && let Some(scope) = scope_at(outline, next, depth)
            && scope > step
        {
            let end = outline.last(scope) + 1;
            next = if end - scope >= slot { scope } else { end };
        }
        let next = next.max(end);
        bars.push(Bar {
            steps: step..next,
            several: next > end,
        });
        step = next;
    }
    bars
}

/// The scope of `depth` that `step` is in or opens.
pub fn scope_at(outline: &Outline, step: usize, depth: usize) -> Option<usize> {
    let innermost = if outline.opens(step) {
        Some(step)
    } else {
        outline.parent(step)
    };
    std::iter::successors(innermost, |&scope| outline.parent(scope))
        .find(|&scope| outline.depth(scope) <= depth)
        .filter(|&scope| outline.depth(scope) == depth)
}
