//! A small screen to convert polygons on, and what is measured there.

use super::case::{Measured, Ran};
use super::ramps::Single;
use super::scenes::{picture, scene, staged};
use crate::algorithms::focus::Region;
use crate::algorithms::frame::Frame;
use crate::algorithms::scan_line::{Corner, EdgeTable, Event, Named, Names};
use crate::color::Rgb;
use crate::numeric::Random;
use crate::numeric::interpolate;
use crate::record::{Unrecorded, Value};
use crate::render::{MAX_SIDE, Method};
use crate::scene::{Camera, View};
use glam::DVec3;

pub const SIZE: u32 = 24;
pub const PIXELS: usize = (SIZE * SIZE) as usize;

impl Named for Single {
    const NAMES: Option<&'static Names> = None;
    fn value(self) -> Option<Value> {
        None
    }
}

/// A camera in front of which the point (x, y) of the screen lies at [`place`].
fn view(width: u32, height: u32) -> View {
    let camera = Camera {
        eye: DVec3::ZERO,
        target: DVec3::NEG_Z,
        up: DVec3::Y,
        fov_x: 1.0,
    };
    View {
        focal: 1.0,
        ..View::new(&camera, width, height)
    }
}

/// Of depth 1, in the camera frame.
pub fn place(x: f64, y: f64) -> DVec3 {
    let half = 0.5 * f64::from(SIZE);
    DVec3::new(x - half, half - y, 1.0)
}

/// Draws into the whole frame, whose height and width are those of the view; `each` sees the pixels and their values.
pub fn fill<A: Named + Into<Shade>>(
    corners: &[Corner<A>],
    frame: &mut Frame,
    mut each: impl FnMut(usize, A),
) {
    let (width, height) = (frame.width, frame.rows.end);
    let region = Region {
        columns: 0..width,
        rows: 0..height,
    };
    let view = view(width, height);
    let mut edge_table = EdgeTable::new(&view, &region);
    let corners = corners.iter().copied();
    edge_table.fill::<Event<A>, _>(corners, frame, &mut Unrecorded, |_, pixel, value| {
        each((pixel.y * width + pixel.x) as usize, value);
        value.into().0
    });
}

/// The colour that an interpolated value stands for.
pub struct Shade(Rgb);

impl From<Rgb> for Shade {
    fn from(color: Rgb) -> Self {
        Shade(color)
    }
}

impl From<Single> for Shade {
    fn from(value: Single) -> Self {
        Shade(Rgb::splat(value.0.into()))
    }
}

/// How often a polygon draws each pixel.
pub fn covered(polygon: &[(f64, f64)]) -> Vec<u32> {
    let corners: Vec<Corner<Rgb>> = polygon
        .iter()
        .map(|&(x, y)| Corner {
            position: place(x, y),
            value: Rgb::WHITE,
        })
        .collect();
    let mut count = vec![0; PIXELS];
    let mut frame = Frame::new(SIZE, 0..SIZE, Rgb::BLACK);
    fill(&corners, &mut frame, |pixel, _| count[pixel] += 1);
    count
}

pub fn sum(count: Vec<u32>) -> f64 {
    count.into_iter().map(f64::from).sum()
}

pub fn add(count: &mut [u32], more: &[u32]) {
    for (count, more) in count.iter_mut().zip(more) {
        *count += more;
    }
}

/// The pixels that a star and the fan of its triangles draw differently often.
pub fn fan(seed: u64) -> usize {
    let mut random = Random(seed);
    let on_grid = |value: f64| (2.0 * value).round() / 2.0;
    let corners = 3 + seed as usize % 9;
    let middle = (on_grid(12.0 + 3.0 * random.number()), on_grid(12.0));
    let rim: Vec<(f64, f64)> = (0..corners)
        .map(|i| {
            let (sin, cos) = (i as f64 / corners as f64 * std::f64::consts::TAU).sin_cos();
            let radius = 5.5 + 3.0 * random.number();
            (
                on_grid(middle.0 + radius * cos),
                on_grid(middle.1 + radius * sin),
            )
        })
        .collect();
    let mut count = vec![0; PIXELS];
    for i in 0..corners {
        add(
            &mut count,
            &covered(&[middle, rim[i], rim[(i + 1) % corners]]),
        );
    }
    let star = covered(&rim);
    std::iter::zip(count, star).filter(|(a, b)| a != b).count()
}

/// The largest error of a value down a polygon so many times as large as the screen.
pub fn larger(times: f64) -> Result<Ran, String> {
    let far = times * f64::from(SIZE);
    let corners = [
        (-far, -far, 0.0),
        (far, -far, 0.0),
        (far, far, 1.0),
        (-far, far, 1.0),
    ];
    let corners = corners.map(|(x, y, value)| Corner {
        position: place(x, y),
        value: Rgb::splat(value),
    });
    // What was drawn nowhere is off by 1.
    let mut values = vec![f64::NAN; PIXELS];
    let mut frame = Frame::new(SIZE, 0..SIZE, Rgb::BLACK);
    fill(&corners, &mut frame, |pixel, color| values[pixel] = color.r);
    let worst = values.iter().enumerate().map(|(pixel, value)| {
        let y = f64::from(pixel as u32 / SIZE) + 0.5;
        (value - (y + far) / (2.0 * far)).abs()
    });
    let worst = worst.reduce(|a, b| if a.is_nan() || a > b { a } else { b });
    Ok(Measured::absolute(worst.unwrap_or(f64::NAN), 0.0).into())
}

/// The largest difference of values by increments and directly, along the longest span that pictures have.
pub fn drift<A: Named + Into<Shade>>(a_1: A, a_2: A, number: fn(A) -> f64) -> f64 {
    let (left, right) = (0.25, f64::from(MAX_SIDE) - 0.25);
    let corners = [
        (left, -1.0, a_1),
        (right, -1.0, a_2),
        (right, 2.0, a_2),
        (left, 2.0, a_1),
    ];
    let corners = corners.map(|(x, y, value)| Corner {
        position: DVec3::new(x - 0.5 * f64::from(MAX_SIDE), 0.5 - y, 1.0),
        value,
    });
    let mut frame = Frame::new(MAX_SIDE, 0..1, Rgb::BLACK);
    let (mut worst, mut seen) = (0.0_f64, 0);
    fill(&corners, &mut frame, |x, value| {
        let direct = interpolate(a_1, left, a_2, right, x as f64 + 0.5);
        worst = worst.max((number(value) - number(direct)).abs());
        seen += 1;
    });
    if seen == MAX_SIDE { worst } else { f64::NAN }
}

/// A floor 1 below the eye that reaches so far to all sides: how many of its 288 pixels are drawn.
pub fn floor(size: &str) -> Result<Ran, String> {
    let corner = |x, z| format!("[{x}{size}, -1, {z}{size}]");
    let corners = [("-", "-"), ("-", ""), ("", ""), ("", "-")].map(|(x, z)| corner(x, z));
    let count = drawn(&format!("[{}]", corners.join(", ")))?;
    Ok(Measured::absolute(count, 288.0).into())
}

/// How many pixels a polygon draws in front of a camera at the origin that looks along z.
pub fn drawn(vertices: &str) -> Result<f64, String> {
    let text = format!(
        r#"{{ "schema": 1, "camera": {{ "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 90 }},
             "materials": {{ "m": {{ "ambient": [1, 1, 1] }} }},
             "objects": [ {{ "name": "sheet", "material": "m", "polygon": {{ "vertices": {vertices} }} }} ] }}"#
    );
    let setup = staged(scene(&text)?, [SIZE, SIZE], 1)?;
    let colors = picture(&setup, Method::Gouraud);
    Ok(colors.iter().filter(|color| color.r > 0.0).count() as f64)
}
