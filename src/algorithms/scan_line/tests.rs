use super::*;
use crate::algorithms::focus::Region;
use crate::algorithms::frame::Frame;
use crate::color::Rgb;
use crate::record::Unrecorded;
use crate::scene::{Camera, View};
use glam::DVec3;
use proptest::prelude::*;

const SIZE: u32 = 24;

/// A camera in front of which the point (x, y) of the screen lies at camera coordinates (x − 12, 12 − y, depth 1).
fn view() -> View {
    let camera = Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        up: DVec3::Y,
        fov_x: 2.0 * f64::from(SIZE / 2).atan(),
    };
    View {
        focal: 1.0,
        ..View::new(&camera, SIZE, SIZE)
    }
}

/// A corner at (x, y) of the screen with `value`.
fn at(x: f64, y: f64, value: f64) -> Corner<Rgb> {
    let half = f64::from(SIZE / 2);
    Corner {
        position: DVec3::new(x - half, half - y, 1.0),
        value: Rgb::splat(value),
    }
}

fn whole() -> Region {
    Region {
        columns: 0..SIZE,
        rows: 0..SIZE,
    }
}

/// Draws a polygon into the whole frame.
fn fill<V: Named>(
    polygon: &[Corner<V>],
    frame: &mut Frame,
    mut color: impl FnMut(Pixel, V) -> Rgb,
) {
    let (view, region) = (view(), whole());
    EdgeTable::new(&view, &region).fill::<Event<V>, _>(
        polygon.iter().copied(),
        frame,
        &mut Unrecorded,
        |_, pixel, value| color(pixel, value),
    );
}

/// How often each pixel is shaded by the polygons, each in a frame of its own so that depth plays no part.
fn coverage(polygons: &[Vec<Corner<Rgb>>]) -> Vec<u32> {
    let mut count = vec![0; (SIZE * SIZE) as usize];
    for polygon in polygons {
        let mut frame = Frame::new(SIZE, 0..SIZE, Rgb::BLACK);
        fill(polygon, &mut frame, |pixel, value| {
            count[(pixel.y * SIZE + pixel.x) as usize] += 1;
            value
        });
    }
    count
}

/// Fills a triangle with `values` at its corners and compares every pixel with the linear function on its plane.
fn assert_bilinear<A: Named>(values: [A; 3], outside: A, apart: impl Fn(A, A) -> f64) {
    let places = [[3.2, 2.7], [21.6, 8.1], [7.3, 20.9]];
    let half = f64::from(SIZE / 2);
    let corners: Vec<Corner<A>> = places
        .into_iter()
        .zip(values)
        .map(|([x, y], value)| Corner {
            position: DVec3::new(x - half, half - y, 1.0),
            value,
        })
        .collect();
    let mut drawn = vec![outside; (SIZE * SIZE) as usize];
    let mut frame = Frame::new(SIZE, 0..SIZE, Rgb::BLACK);
    fill(&corners, &mut frame, |pixel, value| {
        drawn[(pixel.y * SIZE + pixel.x) as usize] = value;
        Rgb::WHITE
    });
    // Barycentric coordinates: the linear function on the plane of the triangle.
    let cross = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let [a, b, c] = places;
    let area = cross(a, b, c);
    let mut inside = 0;
    for (x, y) in (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))) {
        let p = [f64::from(x) + 0.5, f64::from(y) + 0.5];
        let weights = [
            cross(b, c, p) / area,
            cross(c, a, p) / area,
            cross(a, b, p) / area,
        ];
        let drawn = drawn[(y * SIZE + x) as usize];
        if weights.iter().all(|&weight| weight > 0.0) {
            let [one, two, three] = [0, 1, 2].map(|i| values[i].times(weights[i]));
            let error = apart(drawn, one.plus(two).plus(three));
            assert!(error < 1e-14, "({x}, {y}): off by {error:e}");
            inside += 1;
        } else {
            assert_eq!(drawn, outside, "({x}, {y}) is outside");
        }
    }
    // The area of the triangle, in pixels, up to its outline.
    assert!((f64::from(inside) - area.abs() / 2.0).abs() < 12.0);
}

#[test]
fn a_triangle_has_the_exact_bilinear_value_at_every_pixel_inside_and_nothing_outside() {
    let intensities = [0.82, 0.31, 0.55].map(Rgb::splat);
    assert_bilinear(intensities, Rgb::splat(-1.0), |a, b| (a - b).r.abs());
    let normals = [[0.6, 0.0, 0.8], [-0.48, 0.6, 0.64], [0.0, -1.0, 0.0]].map(DVec3::from);
    assert_bilinear(normals, DVec3::ZERO, |a, b| (a - b).abs().max_element());
}

#[test]
fn a_pixel_centre_on_an_edge_belongs_to_one_side() {
    // Two squares that meet on the centres of column 12 and of row 12, corners on pixel centres.
    let square = |x: f64, y: f64| {
        vec![
            at(x, y, 1.0),
            at(x + 8.0, y, 1.0),
            at(x + 8.0, y + 8.0, 1.0),
            at(x, y + 8.0, 1.0),
        ]
    };
    let count = coverage(&[
        square(4.5, 4.5),
        square(12.5, 4.5),
        square(4.5, 12.5),
        square(12.5, 12.5),
    ]);
    assert!(count.iter().all(|&count| count <= 1));
    assert_eq!(count.iter().sum::<u32>(), 16 * 16);
}

#[test]
fn concave_polygons_are_filled_even_odd() {
    // A "U": the notch from x = 8 to 16 stays open above row 16.
    let u = [
        (4.0, 4.0),
        (8.0, 4.0),
        (8.0, 16.0),
        (16.0, 16.0),
        (16.0, 4.0),
        (20.0, 4.0),
        (20.0, 20.0),
        (4.0, 20.0),
    ];
    let count = coverage(&[u.map(|(x, y)| at(x, y, 1.0)).to_vec()]);
    assert_eq!(count.iter().sum::<u32>(), 16 * 16 - 8 * 12);
    assert_eq!(count[(10 * SIZE + 12) as usize], 0);
}

#[test]
fn the_nearer_polygon_is_seen_in_either_order() {
    let plane = |depth: f64, value: f64| {
        [
            at(2.0, 2.0, value),
            at(20.0, 2.0, value),
            at(2.0, 20.0, value),
        ]
        .map(|corner| Corner {
            position: corner.position * depth,
            ..corner
        })
    };
    for order in [[1.0, 2.0], [2.0, 1.0]] {
        let mut frame = Frame::new(SIZE, 0..SIZE, Rgb::BLACK);
        for depth in order {
            let corners = plane(depth, depth);
            fill(&corners, &mut frame, |_, value| value);
        }
        assert!(
            frame.pixel(5, 5).r < 1.5,
            "the polygon at depth 1, whose value is 1, hides the one at depth 2"
        );
    }
}

#[test]
fn slivers_and_degenerate_polygons_draw_nothing_wrong() {
    let line = vec![at(2.0, 2.0, 1.0), at(20.0, 9.0, 1.0), at(11.0, 5.5, 1.0)];
    let horizontal = vec![at(2.0, 5.5, 1.0), at(20.0, 5.5, 1.0), at(9.0, 5.5, 1.0)];
    let point = vec![at(5.5, 5.5, 1.0); 3];
    assert_eq!(coverage(&[line, horizontal, point]).iter().sum::<u32>(), 0);
    // A thousandth of a pixel wide, over the centres of column 7.
    let sliver = vec![
        at(7.4995, 2.0, 0.0),
        at(7.5005, 2.0, 1.0),
        at(7.5005, 12.0, 1.0),
        at(7.4995, 12.0, 0.0),
    ];
    assert_eq!(coverage(&[sliver]).iter().sum::<u32>(), 10);
}

#[test]
fn a_polygon_a_million_times_the_screen_keeps_its_value() {
    let far = 1e6 * f64::from(SIZE);
    let corners = [
        at(-far, -far, 0.0),
        at(far, -far, 0.0),
        at(far, far, 1.0),
        at(-far, far, 1.0),
    ];
    let mut frame = Frame::new(SIZE, 0..SIZE, Rgb::BLACK);
    fill(&corners, &mut frame, |_, value| value);
    for y in 0..SIZE {
        let exact = (f64::from(y) + 0.5 + far) / (2.0 * far);
        assert!((frame.pixel(3, y).r - exact).abs() < 1e-13, "row {y}");
    }
}

proptest! {
    /// A star around a centre, cut into a fan of triangles: together they cover each pixel as often as the star itself.
    #[test]
    fn neighbours_neither_overlap_nor_gap(
        radii in prop::collection::vec(0.5_f64..11.0, 3..12),
        centre in (8.0_f64..16.0, 8.0_f64..16.0),
        turn in 0.0_f64..6.3,
        on_grid in any::<bool>(),
    ) {
        // On the grid of half pixels, corners and edges often meet pixel centres exactly.
        let snap = |value: f64| if on_grid { (2.0 * value).round() / 2.0 } else { value };
        let (x, y) = (snap(centre.0), snap(centre.1));
        let rim: Vec<(f64, f64)> = radii.iter().enumerate().map(|(i, radius)| {
            let angle = turn + i as f64 / radii.len() as f64 * std::f64::consts::TAU;
            (snap(x + radius * angle.cos()), snap(y + radius * angle.sin()))
        }).collect();
        let fan: Vec<Vec<Corner<Rgb>>> = (0..rim.len()).map(|i| {
            let (p, q) = (rim[i], rim[(i + 1) % rim.len()]);
            vec![at(x, y, 0.0), at(p.0, p.1, 0.0), at(q.0, q.1, 0.0)]
        }).collect();
        // Snapping may fold a thin triangle over: then the fan is no division of the star.
        let signed = |t: &Vec<Corner<Rgb>>| (t[1].position - t[0].position).cross(t[2].position - t[0].position).z;
        prop_assume!(fan.iter().all(|t| signed(t) <= 0.0));
        let star: Vec<Corner<Rgb>> = rim.iter().map(|&(x, y)| at(x, y, 0.0)).collect();
        prop_assert_eq!(coverage(&fan), coverage(&[star]));
    }
}
