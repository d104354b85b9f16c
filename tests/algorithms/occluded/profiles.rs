//! What is in the way is as long as the patches are, so that a point sees of the other patch a strip in its whole length: the mean over
//! one patch of what its points see, found in the cross section.

use super::*;

type Place = [f64; 2];
/// Of a blocker, in the cross section.
type Segment = [Place; 2];

/// What the floor of unit width looks at, in the cross section.
#[derive(Clone, Copy)]
enum Target {
    /// Between two x at a height.
    Lid([f64; 2], f64),
    /// From 0 to 1 above the floor's edge at x = 0.
    Wall,
}

impl Target {
    fn polygon(self, ends: [f64; 2], length: f64) -> Corners {
        match self {
            Target::Lid(_, y) => lid(ends, y, [0.0, length]),
            Target::Wall => wall(0.0, ends, [0.0, length]),
        }
    }

    fn ends(self) -> [f64; 2] {
        match self {
            Target::Lid(ends, _) => ends,
            Target::Wall => UNIT,
        }
    }

    /// Where the line from (x, 0) through a point meets the target's line; how far the point is on the way.
    fn image(self, x: f64, [u, v]: Place) -> f64 {
        match self {
            Target::Lid(_, y) => x + (u - x) * y / v,
            Target::Wall => v * x / (x - u),
        }
    }

    fn on_the_way(self, x: f64, [u, v]: Place) -> f64 {
        match self {
            Target::Lid(_, y) => v / y,
            Target::Wall => (x - u) / x,
        }
    }

    /// The interval of the target's line that a segment hides from (x, 0).
    fn hidden(self, x: f64, segment: Segment) -> Option<[f64; 2]> {
        // Of the segment, what lies between the point and the target.
        let [a, b] = segment.map(|end| self.on_the_way(x, end));
        let mut span = [0.0_f64, 1.0_f64];
        for (limit, sign) in [(1e-9, 1.0), (1.0, -1.0)] {
            let [a, b] = [sign * (a - limit), sign * (b - limit)];
            match (a >= 0.0, b >= 0.0) {
                (true, true) => {}
                (false, false) => return None,
                (true, false) => span[1] = span[1].min(a / (a - b)),
                (false, true) => span[0] = span[0].max(a / (a - b)),
            }
        }
        let at =
            |t: f64| std::array::from_fn(|k| segment[0][k] + t * (segment[1][k] - segment[0][k]));
        let [from, to] = span.map(|t| self.image(x, at(t)));
        Some([from.min(to), from.max(to)])
    }

    fn visible(self, x: f64, segments: &[Segment]) -> Vec<[f64; 2]> {
        let mut visible = vec![self.ends()];
        for [from, to] in segments
            .iter()
            .filter_map(|&segment| self.hidden(x, segment))
        {
            visible = (visible.into_iter())
                .flat_map(|[low, high]| [[low, high.min(from)], [low.max(to), high]])
                .filter(|[low, high]| low < high)
                .collect();
        }
        visible
    }

    /// F from the floor, which is `length` long. What is seen jumps at the x where a blocker stands on it.
    fn exact(self, segments: &[Segment], length: f64) -> f64 {
        let mut ends: Vec<f64> = segments
            .iter()
            .flatten()
            .filter(|end| end[1] == 0.0)
            .map(|end| end[0])
            .collect();
        ends.extend(UNIT);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        ends.retain(|end| (0.0..=1.0).contains(end));
        let with_parts = |parts: usize| {
            exact::mean(&ends, parts, |x| {
                let visible = self.visible(x, segments);
                exact::mean(&[0.0, length], 10, |z| {
                    let of = |&ends: &[f64; 2]| {
                        exact::from_point([x, 0.0, z], [0.0, 1.0, 0.0], &self.polygon(ends, length))
                    };
                    visible.iter().map(of).sum()
                })
            })
        };
        let (coarse, fine) = (with_parts(150), with_parts(300));
        assert!((fine - coarse).abs() < 1e-3 * fine, "{coarse} {fine}");
        fine
    }
}

fn assert_profile(name: &str, target: Target, segments: &[Segment], length: f64) {
    let mut polygons = vec![
        floor(UNIT, 0.0, [0.0, length]),
        target.polygon(target.ends(), length),
    ];
    let sheet = |&[[x0, y0], [x1, y1]]: &Segment| {
        let [near, far] = [-0.5, length + 0.5];
        vec![[x0, y0, near], [x0, y0, far], [x1, y1, far], [x1, y1, near]]
    };
    polygons.extend(segments.iter().map(sheet));
    assert_exchange(name, &polygons, length * target.exact(segments, length));
}

const LID: Target = Target::Lid(UNIT, 1.0);

#[test]
fn profiles_under_a_lid() {
    let thin = |x: f64, y: f64| [[x, y], [x + 0.002, y]];
    let blind = |k: u32| {
        let x = 0.125 * f64::from(k);
        [[x, 0.45], [x + 0.1, 0.55]]
    };
    let cases: Vec<(&str, Vec<Segment>)> = vec![
        ("wire", vec![thin(0.3, 0.5)]),
        ("wire over the floor", vec![thin(0.5, 0.01)]),
        ("card aslant", vec![[[0.2, 0.3], [0.7, 0.8]]]),
        (
            "three cards",
            vec![
                [[0.1, 0.3], [0.3, 0.3]],
                [[0.4, 0.5], [0.7, 0.5]],
                [[0.2, 0.8], [0.6, 0.9]],
            ],
        ),
        (
            "two slits",
            vec![
                [[-2.0, 0.45], [0.45, 0.45]],
                [[0.46, 0.45], [3.0, 0.45]],
                [[-2.0, 0.55], [0.55, 0.55]],
                [[0.57, 0.55], [3.0, 0.55]],
            ],
        ),
        (
            "bar",
            vec![
                [[0.4, 0.4], [0.6, 0.4]],
                [[0.6, 0.4], [0.6, 0.6]],
                [[0.6, 0.6], [0.4, 0.6]],
                [[0.4, 0.6], [0.4, 0.4]],
            ],
        ),
        ("blind", (0..8).map(blind).collect()),
        ("curb on the floor", vec![[[0.35, 0.0], [0.35, 0.2]]]),
        ("beam under the lid", vec![[[0.35, 0.7], [0.35, 1.0]]]),
        ("leaning on the floor", vec![[[0.2, 0.0], [0.6, 0.5]]]),
        ("from the edge", vec![[[0.0, 0.0], [0.4, 0.9]]]),
        ("gap under a wall", vec![[[0.5, 0.002], [0.5, 1.0]]]),
        (
            "tent",
            vec![[[0.2, 0.0], [0.4, 0.4]], [[0.4, 0.4], [0.6, 0.0]]],
        ),
    ];
    for (name, segments) in cases {
        assert_profile(name, LID, &segments, 1.0);
    }
}

#[test]
fn profiles_under_other_lids() {
    let card = [[[0.3, 0.5], [0.8, 0.5]]];
    assert_profile("lid aside", Target::Lid([1.5, 2.5], 1.0), &card, 1.0);
    assert_profile(
        "small lid",
        Target::Lid([0.4, 0.41], 1.0),
        &[[[0.3, 0.2], [0.45, 0.2]]],
        1.0,
    );
    assert_profile(
        "low lid",
        Target::Lid(UNIT, 0.05),
        &[[[0.3, 0.02], [0.8, 0.03]]],
        1.0,
    );
    assert_profile(
        "far lid",
        Target::Lid([-2.0, 3.0], 20.0),
        &[[[-0.4, 10.0], [0.6, 9.0]]],
        1.0,
    );
    assert_profile("short", LID, &card, 0.05);
    assert_profile("long", LID, &card, 20.0);
}

#[test]
fn profiles_between_floor_and_wall() {
    let cases: Vec<(&str, Vec<Segment>)> = vec![
        ("from the corner", vec![[[0.0, 0.0], [0.4, 0.3]]]),
        ("slit over the floor", vec![[[0.4, 0.002], [0.4, 3.0]]]),
        ("slit beside the wall", vec![[[0.002, 0.3], [3.0, 0.3]]]),
        (
            "slit half way",
            vec![[[0.3, 0.0], [0.3, 0.299]], [[0.3, 0.301], [0.3, 3.0]]],
        ),
        ("wire", vec![[[0.3, 0.3], [0.302, 0.3]]]),
        ("leaning on the wall", vec![[[0.3, 0.0], [0.0, 0.5]]]),
        (
            "shelf over a curb",
            vec![[[0.0, 0.4], [0.3, 0.4]], [[0.6, 0.0], [0.6, 0.2]]],
        ),
    ];
    for (name, segments) in cases {
        assert_profile(name, Target::Wall, &segments, 1.0);
    }
}
