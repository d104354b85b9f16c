//! Lines: rules along the pixel grid, and all others anti-aliased.

use super::super::blit::{self, PixelRect};
use super::super::font::Coverage;
use super::super::ink::{Dash, Stroke};
use super::super::line::{End, cover};
use super::super::path::{path_through, segment_within};
use super::super::rect::Rect;
use super::{Canvas, rgba};
use glam::Vec2;

impl Canvas<'_> {
    pub(super) fn polyline(&mut self, points: &[Vec2], stroke: &Stroke) {
        match points {
            &[from, to] if from.x == to.x || from.y == to.y => {
                self.rule(Rect::between(from, to), stroke);
            }
            &[from, to] => {
                let ends = [from * self.scale, to * self.scale];
                self.segment(ends, stroke, stroke.width * self.scale);
            }
            points => self.joined(&self.scaled(points), false, stroke),
        }
    }

    /// A straight line on its own, whole or in dashes. The ends and the width are in pixels.
    fn segment(&mut self, ends: [Vec2; 2], stroke: &Stroke, width: f32) {
        let seen = self.clip.to_rect().grown(width + 2.0);
        let Some((from, to)) = segment_within(ends[0], ends[1], seen) else {
            return;
        };
        let color = rgba(self.theme, stroke.ink, stroke.opacity);
        let mut draw = |ends| {
            cover(self.clip, ends, width, [End::Cut; 2], |x, y, coverage| {
                blit::dot(self.pixmap, x, y, color, coverage);
            });
        };
        let Some([on, off]) = stroke.dash.lengths() else {
            draw([from, to]);
            return;
        };
        let length = from.distance(to);
        let along = (to - from).normalize_or_zero();
        let period = (on + off) * self.scale;
        for dash in 0..(length / period).ceil() as usize {
            let start = dash as f32 * period;
            let end = (start + on * self.scale).min(length);
            draw([from + start * along, from + end * along]);
        }
    }

    /// A line through points, with round joints. Its segments' coverage is gathered first, and drawn once: joints are no
    /// darker than the rest. A closed line ends where it began. The points are in pixels.
    pub(super) fn joined(&mut self, points: &[Vec2], closed: bool, stroke: &Stroke) {
        let width = stroke.width * self.scale;
        if stroke.dash != Dash::Solid {
            self.stroke_path(path_through(points.iter().copied(), false), stroke, width);
            return;
        }
        let seen = self.clip.to_rect().grown(width + 2.0);
        let Some(bounds) = Rect::around(points.iter().copied()) else {
            return;
        };
        let area = PixelRect::around(bounds.grown(width + 2.0)).intersection(self.clip);
        if area.is_empty() {
            return;
        }
        let columns = area.width() as usize;
        let mut coverage = vec![0; columns * area.height() as usize];
        let segments = points.len() - 1;
        for (i, ends) in points.windows(2).enumerate() {
            let Some((from, to)) = segment_within(ends[0], ends[1], seen) else {
                continue;
            };
            let cap = |outermost: bool| {
                if outermost && !closed {
                    End::Cut
                } else {
                    End::Joint
                }
            };
            let caps = [cap(i == 0), cap(i + 1 == segments)];
            cover(area, [from, to], width, caps, |x, y, covered| {
                let at = (y - area.top) as usize * columns + (x - area.left) as usize;
                coverage[at] = covered.max(coverage[at]);
            });
        }
        let mask = Coverage {
            left: area.left,
            top: area.top,
            width: columns,
            bytes: coverage.into_boxed_slice(),
        };
        let color = rgba(self.theme, stroke.ink, stroke.opacity);
        blit::coverage(self.pixmap, self.clip, &mask, (0, 0), color);
    }

    /// A horizontal or vertical line, given as a rectangle without width: moved to where its sides are on whole pixels.
    fn rule(&mut self, line: Rect, stroke: &Stroke) {
        let width = self.whole_width(stroke.width);
        let half = 0.5 * width as f32 / self.scale;
        let horizontal = line.height == 0.0;
        let mut bar = if horizontal {
            self.snapped(Rect {
                y: line.y - half,
                ..line
            })
        } else {
            self.snapped(Rect {
                x: line.x - half,
                ..line
            })
        };
        if horizontal {
            bar.bottom = bar.top + width;
        } else {
            bar.right = bar.left + width;
        }
        if stroke.dash == Dash::Solid {
            self.fill_rect(bar, rgba(self.theme, stroke.ink, stroke.opacity));
            return;
        }
        let middle = 0.5 * width as f32;
        let (left, top) = (bar.left as f32, bar.top as f32);
        let ends = if horizontal {
            [(left, top + middle), (bar.right as f32, top + middle)]
        } else {
            [(left + middle, top), (left + middle, bar.bottom as f32)]
        };
        self.segment(ends.map(Vec2::from), stroke, width as f32);
    }
}
