//! A plot area with logarithmic axes, powers of ten on both.

use crate::language::power_of_ten;
use crate::picture::{Ink, Picture, Rect, Style, Text};
use glam::Vec2;

const TEXT: f32 = 11.0;
const ROW: f32 = 16.0;
/// Between two ticks, at least, in points.
const TICKS_APART: f32 = 22.0;
const TICKS_BESIDE: f32 = 34.0;

/// Where powers of ten lie; what is smaller or larger lies on the border.
pub struct LogAxes {
    /// The field, without numbers and names.
    pub place: Rect,
    x: [i32; 2],
    y: [i32; 2],
}

impl LogAxes {
    /// The axes of all values that are positive and finite, each at least one power of ten long. `whole` is the room for the field
    /// with its numbers, a title above and a name below.
    pub fn new(
        x: impl IntoIterator<Item = f64>,
        y: impl IntoIterator<Item = f64>,
        whole: Rect,
    ) -> Self {
        let (x, y) = (exponents(x), exponents(y));
        let numbers = y.map(|exponent| style().width(&power_of_ten(exponent)));
        let left = numbers[0].max(numbers[1]) + 6.0;
        LogAxes {
            place: Rect::new(
                whole.x + left,
                whole.y + ROW + 2.0,
                (whole.width - left - 6.0).max(1.0),
                (whole.height - 3.0 * ROW - 2.0).max(1.0),
            ),
            x,
            y,
        }
    }

    pub fn point(&self, x: f64, y: f64) -> Vec2 {
        let across = share(x, self.x) as f32;
        let up = share(y, self.y) as f32;
        Vec2::new(
            self.place.x + self.place.width * across,
            self.place.bottom() - self.place.height * up,
        )
    }

    /// Grid, numbers, what goes upward above the field and what goes to the right below it.
    pub fn draw(&self, picture: &mut Picture, up: &str, right: &str) {
        let Rect { x, y, .. } = self.place;
        let (end, bottom) = (self.place.right(), self.place.bottom());
        let grid = Ink::Rule.stroke(1.0).opacity(0.6);
        for exponent in ticks(self.y, self.place.height / TICKS_APART) {
            let at = self.point(1.0, 10_f64.powi(exponent)).y;
            picture.line((x, at), (end, at), grid);
            let baseline = at + style().baseline_below_middle();
            picture.text((x - 5.0, baseline), power_of_ten(exponent), style().end());
        }
        for exponent in ticks(self.x, self.place.width / TICKS_BESIDE) {
            let at = self.point(10_f64.powi(exponent), 1.0).x;
            picture.line((at, y), (at, bottom), grid);
            let text = power_of_ten(exponent);
            let half = 0.5 * style().width(&text);
            let left = (at - half).clamp(x, (end - 2.0 * half).max(x));
            let row = Rect::new(left, bottom + 1.0, 2.0 * half, ROW);
            picture.text_in(row, text, style());
        }
        picture.line((x, y), (x, bottom), Ink::Muted.stroke(1.0));
        picture.line((x, bottom), (end, bottom), Ink::Muted.stroke(1.0));
        let above = Rect::new(x, y - ROW - 2.0, self.place.width, ROW);
        picture.text_in(above, up, style().ink(Ink::Text));
        let below = Rect::new(x, bottom + ROW, self.place.width, ROW);
        picture.text_in(below, right, style().end());
    }
}

fn style() -> Text {
    Style::Body.size(TEXT).ink(Ink::Muted)
}

/// Of the power of ten below all values, and of the one above.
fn exponents(values: impl IntoIterator<Item = f64>) -> [i32; 2] {
    let values = values.into_iter();
    let logarithms = values
        .filter(|value| *value > 0.0 && value.is_finite())
        .map(f64::log10);
    let (low, high) = logarithms.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return [-1, 0];
    }
    let low = low.floor() as i32;
    [low, (high.ceil() as i32).max(low + 1)]
}

fn share(value: f64, [low, high]: [i32; 2]) -> f64 {
    let exponent = value.log10().clamp(low.into(), high.into());
    (exponent - f64::from(low)) / f64::from(high - low)
}

/// Exponents as far apart as there is room for.
fn ticks([low, high]: [i32; 2], room: f32) -> impl Iterator<Item = i32> {
    let stride = ((high - low) / (room.max(1.0) as i32) + 1).max(1);
    (low..=high).filter(move |exponent| exponent % stride == 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_field_spans_whole_powers_of_ten() {
        assert_eq!(exponents([0.02, 3.0, 0.0, f64::NAN]), [-2, 1]);
        assert_eq!(exponents([1.0]), [0, 1]);
        assert_eq!(exponents([]), [-1, 0]);
        let whole = Rect::new(0.0, 0.0, 200.0, 150.0);
        let axes = LogAxes::new([1.0, 100.0], [1e-6, 1.0], whole);
        let Rect { x, y, .. } = axes.place;
        assert_eq!(axes.point(1.0, 1.0), Vec2::new(x, y));
        assert_eq!(axes.point(100.0, 1e-6), axes.place.max());
        assert_eq!(axes.point(10.0, 1e-3), axes.place.center());
        assert_eq!(axes.point(0.0, 0.0), Vec2::new(x, axes.place.bottom()));
    }
}
