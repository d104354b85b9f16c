//! Labels beside points: each goes where it covers no other one, and as few lines as can be.

use crate::picture::{Ink, Picture, Rect, Text, ascent, descent};
use glam::Vec2;

/// Gaps between a point and its label, in points.
const GAPS: [f32; 7] = [3.0, 8.0, 15.0, 24.0, 36.0, 52.0, 72.0];
/// From the n-th gap on a thin line leads from the point to the label.
const LED: usize = 3;
/// What it costs to cover a part of a shape: more than to stand a little away from it.
const SHAPE: f32 = 3.0;
/// What it costs that the line to a label strikes through another one.
const STRUCK: f32 = 12.0;
/// How much of a line goes under a label that has to cover it.
const GROUND: f32 = 0.75;
/// Between the boxes of two labels.
const APART: f32 = 3.0;

#[derive(Clone)]
pub struct Labels {
    area: Rect,
    taken: Vec<Rect>,
    lines: Vec<Spared>,
    outlines: Vec<(Rect, Vec<[Vec2; 2]>)>,
    discs: Vec<(Vec2, f32)>,
}

/// A line that labels should not cover, with half its width.
#[derive(Clone)]
struct Spared {
    ends: [Vec2; 2],
    half: f32,
}

impl Spared {
    fn crosses(&self, place: Rect) -> bool {
        crosses(self.ends, place.grown(self.half))
    }
}

impl Labels {
    /// All labels will lie in `area`.
    pub fn new(area: Rect) -> Self {
        Labels {
            area,
            taken: Vec::new(),
            lines: Vec::new(),
            outlines: Vec::new(),
            discs: Vec::new(),
        }
    }

    pub fn area(&self) -> Rect {
        self.area
    }

    /// No label may cover `rect`.
    pub fn reserve(&mut self, rect: Rect) {
        self.taken.push(rect);
    }

    /// Labels should not cover the line, but may.
    pub fn avoid(&mut self, from: Vec2, to: Vec2) {
        self.avoid_stroke(from, to, 0.0);
    }

    /// As [`Labels::avoid`], of a line through several points.
    pub fn avoid_path(&mut self, points: &[Vec2]) {
        for pair in points.windows(2) {
            self.avoid(pair[0], pair[1]);
        }
    }

    /// As [`Labels::avoid`], of a line so wide that its middle does not show what would be covered.
    pub fn avoid_stroke(&mut self, from: Vec2, to: Vec2, width: f32) {
        self.lines.push(Spared {
            ends: [from, to],
            half: 0.5 * width,
        });
    }

    /// Labels should rather not cover the outline, whose lines count as one.
    pub fn avoid_outline(&mut self, lines: Vec<[Vec2; 2]>) {
        let boxes = lines.iter().map(|&[from, to]| Rect::between(from, to));
        if let Some(bounds) = boxes.reduce(|all, other| all.union(&other)) {
            self.outlines.push((bounds, lines));
        }
    }

    /// Labels should rather not cover any part of the disc.
    pub fn avoid_disc(&mut self, at: Vec2, radius: f32) {
        self.discs.push((at, radius));
    }

    /// Writes `text` beside the disc of `radius` at `at`, rather in the direction `toward`. Where there is no room left the
    /// label is left out. Returns whether it was written.
    pub fn put(
        &mut self,
        picture: &mut Picture,
        (at, radius): (Vec2, f32),
        toward: Vec2,
        text: &str,
        set: Text,
    ) -> bool {
        let above = ascent(set.style, set.size);
        let size = Vec2::new(set.width(text), above + descent(set.style, set.size));
        let Some((place, gap)) = self.place(at, radius, toward.normalize_or_zero(), size) else {
            return false;
        };
        if gap >= LED {
            let [start, end] = leader(at, radius, place);
            picture.line(start, end, Ink::Muted.stroke(0.75));
            self.avoid(start, end);
        }
        self.clear(picture, place);
        let baseline = Vec2::new(place.x, place.y + above);
        let set = Text {
            anchor: crate::picture::Anchor::Start,
            ..set
        };
        picture.text(baseline, text, set);
        self.taken.push(place);
        true
    }

    /// Writes `text` in the box with its upper left corner at `corner`, where that is free, and crossed by no line unless
    /// `crossing`. Returns whether it did.
    pub fn put_at(
        &mut self,
        picture: &mut Picture,
        corner: Vec2,
        text: &str,
        set: Text,
        crossing: bool,
    ) -> bool {
        let above = ascent(set.style, set.size);
        let place = set.bounds(corner + Vec2::new(0.0, above), text);
        let crossed = self.lines.iter().any(|line| line.crosses(place));
        if !self.is_free(place) || crossed && !crossing {
            return false;
        }
        picture.text(corner + Vec2::new(0.0, above), text, set);
        self.taken.push(place);
        true
    }

    /// Where a line passes through the box it pales, so that the letters stand out.
    fn clear(&self, picture: &mut Picture, place: Rect) {
        if self.lines.iter().any(|line| line.crosses(place)) {
            picture.rounded_rect(place, 2.0, Ink::Surface.fill().opacity(GROUND));
        }
    }

    /// The cheapest free box beside a disc, and which gap lies between them.
    fn place(&self, at: Vec2, radius: f32, toward: Vec2, size: Vec2) -> Option<(Rect, usize)> {
        let mut best: Option<(f32, Rect, usize)> = None;
        for (ring, gap) in GAPS.into_iter().enumerate() {
            for turn in 0..16 {
                let direction = Vec2::from_angle(turn as f32 * std::f32::consts::PI / 8.0);
                // The box's nearest point, not its middle, keeps the distance.
                let middle = at + (radius + gap) * direction + 0.5 * size * squared(direction);
                let corner = middle - 0.5 * size;
                let place = Rect::new(corner.x, corner.y, size.x, size.y);
                if !self.is_free(place) {
                    continue;
                }
                let crossed = self.lines.iter().filter(|line| line.crosses(place));
                let outlines = self.outlines.iter();
                let outlines = outlines.filter(|outline| covers(place, outline));
                let discs = self.discs.iter();
                let discs = discs.filter(|disc| touches(place, disc));
                let shapes = outlines.count() + discs.count();
                let mut cost = 0.06 * gap + 4.0 * crossed.count() as f32 - direction.dot(toward)
                    + SHAPE * shapes as f32;
                if ring >= LED {
                    let line = leader(at, radius, place);
                    let struck = self.taken.iter().filter(|taken| crosses(line, **taken));
                    cost += STRUCK * struck.count() as f32;
                }
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, place, ring));
                }
            }
        }
        best.map(|(_, place, ring)| (place, ring))
    }

    fn is_free(&self, place: Rect) -> bool {
        let apart = place.grown(APART);
        self.area.encloses(&place)
            && !self
                .taken
                .iter()
                .any(|taken| !taken.intersection(&apart).is_empty())
    }
}

/// Whether a box lies on a line of an outline.
fn covers(place: Rect, (bounds, lines): &(Rect, Vec<[Vec2; 2]>)) -> bool {
    let apart = bounds.grown(APART).intersection(&place).is_empty();
    !apart && lines.iter().any(|&line| crosses(line, place))
}

/// Whether a box and a disc have more than their edges in common.
fn touches(place: Rect, &(at, radius): &(Vec2, f32)) -> bool {
    at.distance(at.clamp(place.min(), place.max())) < radius
}

/// The line from the edge of a disc to the nearest point of a box.
fn leader(at: Vec2, radius: f32, place: Rect) -> [Vec2; 2] {
    let near = at.clamp(place.min(), place.max());
    [at + radius * (near - at).normalize_or_zero(), near]
}

/// The point of the square in a direction from its middle, from −1 to 1 on both axes.
fn squared(direction: Vec2) -> Vec2 {
    direction / direction.abs().max_element()
}

/// Whether a line passes through a rectangle.
pub fn crosses(line: [Vec2; 2], rect: Rect) -> bool {
    within(line, rect).is_some()
}

/// The part of a line within a rectangle (Liang and Barsky).
pub fn within([from, to]: [Vec2; 2], rect: Rect) -> Option<[Vec2; 2]> {
    let (mut first, mut last) = (0.0_f32, 1.0_f32);
    let along = to - from;
    for (step, low, high) in [
        (along.x, rect.x - from.x, rect.right() - from.x),
        (along.y, rect.y - from.y, rect.bottom() - from.y),
    ] {
        if step == 0.0 {
            if low > 0.0 || high < 0.0 {
                return None;
            }
        } else {
            let (enter, leave) = (low / step, high / step);
            first = first.max(enter.min(leave));
            last = last.min(enter.max(leave));
        }
    }
    (first <= last).then(|| [from + first * along, from + last * along])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Style;

    #[test]
    fn a_line_pales_under_the_label_that_has_to_cover_it() {
        let area = Rect::new(0.0, 0.0, 90.0, 60.0);
        for (lines, grounds) in [(0, 0), (11, 1)] {
            let mut labels = Labels::new(area);
            let mut picture = Picture::new(90.0, 60.0);
            for y in (0..lines).map(|line| 6.0 * line as f32) {
                labels.avoid(Vec2::new(0.0, y), Vec2::new(90.0, y));
            }
            let at = (Vec2::new(45.0, 30.0), 4.0);
            labels.put(&mut picture, at, Vec2::X, "L_0", Style::Label.size(12.0));
            assert_eq!(picture.items.len(), 1 + grounds);
        }
    }

    #[test]
    fn labels_of_one_point_lie_apart_until_there_is_no_room() {
        let area = Rect::new(0.0, 0.0, 120.0, 90.0);
        let mut labels = Labels::new(area);
        let mut picture = Picture::new(120.0, 90.0);
        for _ in 0..40 {
            let set = Style::Label.size(12.0);
            labels.put(
                &mut picture,
                (Vec2::new(60.0, 45.0), 4.0),
                Vec2::X,
                "I_4 = 0.5",
                set,
            );
        }
        let count = labels.taken.len();
        assert!((4..40).contains(&count), "{count} labels");
        for (i, place) in labels.taken.iter().enumerate() {
            assert!(area.encloses(place));
            let others = &labels.taken[..i];
            assert!(
                others
                    .iter()
                    .all(|other| other.intersection(place).is_empty())
            );
        }
    }

    #[test]
    fn a_label_keeps_off_a_wide_line_and_an_outline() {
        let area = Rect::new(0.0, 0.0, 200.0, 200.0);
        let (at, set) = (Vec2::new(100.0, 100.0), Style::Label.size(12.0));
        let [left, right] = [Vec2::new(0.0, 112.0), Vec2::new(200.0, 112.0)];
        let place = |avoid: &dyn Fn(&mut Labels)| {
            let mut labels = Labels::new(area);
            avoid(&mut labels);
            let mut picture = Picture::new(200.0, 200.0);
            labels.put(&mut picture, (at, 0.0), Vec2::Y, "floor", set);
            labels.taken[0]
        };
        let free = place(&|_| ());
        assert!(crosses([left, right], free));
        let beside_line = place(&|labels| labels.avoid_stroke(left, right, 8.0));
        assert!(!crosses([left, right], beside_line.grown(4.0)));
        let beside_outline = place(&|labels| labels.avoid_outline(vec![[left, right]]));
        assert!(!crosses([left, right], beside_outline));
    }

    #[test]
    fn a_line_crosses_a_box_that_it_passes_through() {
        let rect = Rect::new(10.0, 10.0, 10.0, 10.0);
        let line = |from: [f32; 2], to: [f32; 2]| [Vec2::from(from), Vec2::from(to)];
        assert!(crosses(line([0.0, 0.0], [30.0, 30.0]), rect));
        assert!(crosses(line([15.0, 0.0], [15.0, 11.0]), rect));
        assert!(!crosses(line([0.0, 25.0], [25.0, 40.0]), rect));
        assert!(!crosses(line([0.0, 5.0], [40.0, 5.0]), rect));
    }
}
