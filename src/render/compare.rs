//! Several methods on one scene: their pictures, what each did for its own, how long it took, and how far they are apart.

use super::{Method, render_unless};
use crate::algorithms::frame::Frame;
use crate::color::Rgb;
use crate::methods::Setup;
use crate::numeric::perceived;
use std::convert::Infallible;
use std::iter::zip;
use std::num::NonZeroUsize;
use web_time::Instant;

/// How many pictures are timed, to take the median.
const REPEATS: usize = 5;

/// One method on a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    pub method: Method,
    pub frame: Frame,
    /// Of the whole picture on one thread, unrecorded: the median of five.
    pub seconds: f64,
    pub operations: Operations,
    /// How bright the pixels of each row look.
    perceived: Vec<f64>,
}

impl Compared {
    /// How bright the pixels of row `y` look beside each other.
    pub fn perceived(&self, y: u32) -> &[f64] {
        let start = self.frame.index(0, y);
        &self.perceived[start..start + self.frame.width as usize]
    }
}

/// Pictures of one scene, as many as are made. Of those that are shaded the last one is the reference.
#[derive(Clone, Debug, Default)]
pub struct SideBySide {
    pictures: Vec<Compared>,
    differences: Vec<Difference>,
}

impl SideBySide {
    pub fn push(&mut self, compared: Compared) {
        self.pictures.push(compared);
        self.differences = differences(&self.pictures);
    }

    pub fn pictures(&self) -> &[Compared] {
        &self.pictures
    }

    /// Of the shaded pictures, but the last, against the last.
    pub fn differences(&self) -> &[Difference] {
        &self.differences
    }

    /// All pictures but that of wireframe, which fills nothing, with their numbers among all.
    pub fn shaded(&self) -> impl DoubleEndedIterator<Item = (usize, &Compared)> {
        shaded(&self.pictures)
    }
}

impl FromIterator<Compared> for SideBySide {
    fn from_iter<I: IntoIterator<Item = Compared>>(pictures: I) -> Self {
        let pictures: Vec<Compared> = pictures.into_iter().collect();
        SideBySide {
            differences: differences(&pictures),
            pictures,
        }
    }
}

fn shaded(pictures: &[Compared]) -> impl DoubleEndedIterator<Item = (usize, &Compared)> {
    let all = pictures.iter().enumerate();
    all.filter(|(_, compared)| compared.method != Method::Wireframe)
}

fn differences(pictures: &[Compared]) -> Vec<Difference> {
    let mut shaded = shaded(pictures).map(|(_, compared)| &compared.frame);
    let Some(reference) = shaded.next_back() else {
        return Vec::new();
    };
    shaded.map(|frame| difference(frame, reference)).collect()
}

/// What a method did for a whole picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Pixels drawn, one behind another more than once.
    pub pixels: u64,
    /// Points lit by the illumination model.
    pub illuminations: u64,
    /// Values interpolated on edges and spans.
    pub interpolations: u64,
    /// Normals brought to unit length at pixels: a square root and a division each.
    pub unit_normals: u64,
    /// Cosines taken from the series of a triangle: two additions each.
    pub series: u64,
    /// Rays of all kinds.
    pub rays: u64,
}

/// Draws the scene's whole picture by `method`; on the clock of this machine.
pub fn compare(setup: &Setup, method: Method) -> Compared {
    let Ok(compared) = compare_unless(setup, method, &|| Ok::<(), Infallible>(()));
    compared
}

/// As [`compare`]. Errors: those of `go_on`, which end the work.
pub fn compare_unless<E: Send>(
    setup: &Setup,
    method: Method,
    go_on: &(impl Fn() -> Result<(), E> + Sync),
) -> Result<Compared, E> {
    let start = Instant::now();
    timed(setup, method, || start.elapsed().as_secs_f64(), go_on)
}

/// As [`compare`], timed by `clock`, in seconds.
pub fn compare_on(setup: &Setup, method: Method, clock: impl FnMut() -> f64) -> Compared {
    let Ok(compared) = timed(setup, method, clock, &|| Ok::<(), Infallible>(()));
    compared
}

fn timed<E: Send>(
    setup: &Setup,
    method: Method,
    mut clock: impl FnMut() -> f64,
    go_on: &(impl Fn() -> Result<(), E> + Sync),
) -> Result<Compared, E> {
    let draw = || render_unless(setup, method, NonZeroUsize::MIN, |_, _| go_on());
    // The first one warms up.
    let frame = draw()?;
    let mut times = [0.0; REPEATS];
    for seconds in &mut times {
        let start = clock();
        draw()?;
        *seconds = clock() - start;
    }
    times.sort_by(f64::total_cmp);
    let rows = frame.color.chunks(frame.width.max(1) as usize);
    let luminance = |row: &[Rgb]| {
        row.iter()
            .map(|color| color.luminance())
            .collect::<Vec<_>>()
    };
    Ok(Compared {
        method,
        perceived: rows.flat_map(|row| perceived(&luminance(row))).collect(),
        frame,
        seconds: times[REPEATS / 2],
        operations: operations(setup, method),
    })
}

/// Counted in a recorded run of which no event is kept. Those of radiosity are about patches, not pixels.
fn operations(setup: &Setup, method: Method) -> Operations {
    if !method.draws_pixels() {
        return Operations::default();
    }
    let counter = method.count(setup).events;
    let sum = |kinds: &[&str]| kinds.iter().map(|kind| counter.of(kind)).sum();
    Operations {
        pixels: sum(&["PixelColored", "PixelPlotted"]),
        illuminations: sum(&["Illuminated"]),
        interpolations: sum(&["EdgeInterpolated", "SpanInterpolated"]),
        unit_normals: sum(&["PixelNormal"]),
        series: sum(&["CosineEvaluated"]),
        rays: sum(&["Ray", "ShadowRay"]),
    }
}

/// How far one picture is from another of the same size.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Luminance of the one minus that of the other, pixel by pixel.
    pub signed: Vec<f64>,
    /// The largest magnitude, and the root of the mean square, over the pixels on which either has drawn something.
    pub largest: f64,
    pub rms: f64,
}

/// `picture` against `reference`.
fn difference(picture: &Frame, reference: &Frame) -> Difference {
    let colors = zip(&picture.color, &reference.color);
    let signed: Vec<f64> = colors
        .map(|(one, other)| one.luminance() - other.luminance())
        .collect();
    let depths = zip(&picture.inverse_depth, &reference.inverse_depth);
    let drawn = zip(&signed, depths).filter(|(d, (one, other))| {
        // Methods that follow rays keep no depth: where they differ, something is drawn.
        **one > 0.0 || **other > 0.0 || **d != 0.0
    });
    let (mut largest, mut squares, mut count) = (0.0_f64, 0.0, 0.0);
    for (d, _) in drawn {
        largest = largest.max(d.abs());
        squares += d * d;
        count += 1.0;
    }
    Difference {
        signed,
        largest,
        rms: if count > 0.0 {
            f64::sqrt(squares / count)
        } else {
            0.0
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_difference_counts_drawn_pixels_alone() {
        let mut picture = Frame::new(4, 0..1, Rgb::BLACK);
        let reference = Frame::new(4, 0..1, Rgb::BLACK);
        picture.color[1] = Rgb::splat(0.3);
        picture.color[2] = Rgb::splat(-0.4);
        picture.inverse_depth = vec![0.0, 1.0, 1.0, 1.0];
        let difference = difference(&picture, &reference);
        let near = |value: f64, wanted: f64| (value - wanted).abs() < 1e-12;
        assert!(near(difference.signed[1], 0.3) && near(difference.signed[2], -0.4));
        assert!(near(difference.largest, 0.4));
        assert!(near(difference.rms, (0.25_f64 / 3.0).sqrt()));
    }
}
