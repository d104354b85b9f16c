//! Anti-aliased lines by distance: a pixel takes as much ink as the line covers of a unit interval about its centre, across
//! and along. A few operations a pixel touched, an order of magnitude faster than filling a stroke's outline.

use glam::Vec2;

use super::blit::PixelRect;

/// What happens at an end of a segment.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum End {
    /// Cut off square: the end of a line.
    Cut,
    /// A half disc: the joint with the next segment.
    Joint,
}

/// Hands every pixel (x, y) of `clip` that a segment touches, with its coverage, 1 to 255, to `put`. All in pixels; the ends
/// must be finite.
pub(super) fn cover(
    clip: PixelRect,
    [from, to]: [Vec2; 2],
    width: f32,
    [start, end]: [End; 2],
    mut put: impl FnMut(i32, i32, u8),
) {
    let half = 0.5 * width;
    let half_length = 0.5 * from.distance(to);
    let along = (to - from).try_normalize().unwrap_or(Vec2::X);
    let middle = 0.5 * (from + to);
    let low = if start == End::Cut {
        -half_length
    } else {
        f32::NEG_INFINITY
    };
    let high = if end == End::Cut {
        half_length
    } else {
        f32::INFINITY
    };

    // Half a pixel for the unit interval; the box leans out as far along the line.
    let reach = half + 0.5;
    let (least, most) = (from.min(to) - reach - 0.5, from.max(to) + reach + 0.5);
    let rows = (least.y as i32).max(clip.top)..(most.y.ceil() as i32).min(clip.bottom);
    for y in rows {
        let dy = y as f32 + 0.5 - middle.y;
        // Where this row is near enough to the line, endless in both directions, and to the segment's box.
        let centre = middle.x + dy * along.x / along.y;
        let spread = (reach / along.y).abs();
        let left = least.x.max(centre - spread);
        let right = most.x.min(centre + spread);
        // Pixels whose centres lie between the two.
        let columns = ((left - 0.5).ceil() as i32).max(clip.left)
            ..((right - 0.5).floor() as i32 + 1).min(clip.right);
        for x in columns {
            let offset = Vec2::new(x as f32 + 0.5 - middle.x, dy);
            let mut distance = along.perp_dot(offset);
            let at = along.dot(offset);
            let beyond = at.abs() - half_length;
            if beyond > 0.0 && End::Joint == if at < 0.0 { start } else { end } {
                distance = distance.hypot(beyond);
            }
            let coverage = overlap(distance, -half, half) * overlap(at, low, high);
            let coverage = (coverage * 255.0 + 0.5) as u8;
            if coverage > 0 {
                put(x, y, coverage);
            }
        }
    }
}

/// The length of the unit interval about `at` that lies between `low` and `high`.
fn overlap(at: f32, low: f32, high: f32) -> f32 {
    ((at + 0.5).min(high) - (at - 0.5).max(low)).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(ends: [[f32; 2]; 2], width: f32, caps: [End; 2]) -> f32 {
        let clip = PixelRect {
            left: 0,
            top: 0,
            right: 100,
            bottom: 100,
        };
        let mut sum = 0.0;
        cover(clip, ends.map(Vec2::from), width, caps, |_, _, coverage| {
            sum += f32::from(coverage) / 255.0;
        });
        sum
    }

    #[test]
    fn a_line_has_the_ink_of_its_area() {
        for (from, to) in [
            ([20.0, 20.0], [70.0, 20.0]),
            ([20.3, 70.0], [20.3, 20.0]),
            ([10.2, 15.0], [80.7, 63.1]),
            ([80.0, 10.0], [60.0, 90.0]),
        ] {
            let length = Vec2::from(from).distance(to.into());
            for width in [0.5, 1.0, 1.5, 4.0] {
                let cut = area([from, to], width, [End::Cut; 2]);
                let exact = length * width;
                assert!((cut - exact).abs() < 0.02 * exact, "{width} {cut} {exact}");
            }
            let joined = area([from, to], 8.0, [End::Cut, End::Joint]);
            let exact = length * 8.0 + 0.5 * std::f32::consts::PI * 16.0;
            assert!((joined - exact).abs() < 0.02 * exact);
        }
    }

    #[test]
    fn a_point_has_no_length_and_a_clip_holds() {
        assert_eq!(area([[5.0, 5.0]; 2], 2.0, [End::Cut; 2]), 0.0);
        let outside = [[-50.0, 150.0], [-10.0, 300.0]];
        assert_eq!(area(outside, 9.0, [End::Joint; 2]), 0.0);
    }
}
