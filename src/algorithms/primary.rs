//! Primary rays: from the projection reference point through every pixel of the projection plane (Appel 1968).
//!
//! A pixel is sampled at its centre, or at the centres of n×n cells of it, whose colours are averaged.

use super::focus::Focus;
use super::frame::Frame;
use super::prepared_scene::{self, PreparedScene};
use crate::color::Rgb;
use crate::record::Recorder;
use crate::scene::View;
use crate::scene::primitives::Ray;
use glam::DVec2;
use std::num::NonZeroU32;

/// The settings of the ray methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Settings {
    /// The deepest level that is traced, at most [`Settings::DEEPEST`]; the primary ray is level 1.
    pub depth: NonZeroU32,
    /// n of the n×n samples of a pixel, at most [`Settings::MOST_SAMPLES`].
    pub samples: NonZeroU32,
}

impl Settings {
    pub const DEEPEST: u32 = 64;
    pub const MOST_SAMPLES: u32 = 64;
}

impl Default for Settings {
    /// Depth 5, one sample.
    fn default() -> Self {
        Settings {
            depth: const { NonZeroU32::new(5).unwrap() },
            samples: NonZeroU32::MIN,
        }
    }
}

/// Colours the pixels of `frame` that `focus` selects, each by `color`.
pub fn for_each_pixel<E: From<prepared_scene::Event> + From<Event>, R: Recorder<E>>(
    prepared: &PreparedScene,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
    mut color: impl FnMut(u32, u32, &mut R) -> Rgb,
) {
    let region = focus.region(frame);
    recorder.enter(|| prepared.entered().into());
    for y in region.rows {
        for x in region.columns.clone() {
            let pixel = frame.index(x, y);
            frame.color[pixel] = color(x, y, recorder);
        }
    }
    recorder.leave(|| prepared_scene::Event::FrameDone.into());
}

/// The colour of pixel (x, y): the mean over its samples of what `trace` returns for the ray of each.
pub fn pixel<E: From<Event>, R: Recorder<E>>(
    view: &View,
    samples: NonZeroU32,
    (x, y): (u32, u32),
    recorder: &mut R,
    mut trace: impl FnMut(&Ray, &mut R) -> Rgb,
) -> Rgb {
    let n = samples.get();
    recorder.enter(|| Event::Pixel { x, y, samples: n }.into());
    let mut sum = Rgb::BLACK;
    for row in 0..n {
        for column in 0..n {
            let cell = DVec2::new(column.into(), row.into()) + 0.5;
            let place = DVec2::new(x.into(), y.into()) + cell / f64::from(n);
            let sample = (n > 1).then_some(row * n + column);
            recorder.step(|| Event::Through { place, sample }.into());
            sum += trace(&ray_through(view, place), recorder);
        }
    }
    let color = (sum / (f64::from(n) * f64::from(n))).finite();
    recorder.leave(|| Event::PixelColored { color }.into());
    color
}

/// The primary ray through the middle of a pixel.
pub fn middle_ray(view: &View, (x, y): (u32, u32)) -> Ray {
    ray_through(view, DVec2::new(x.into(), y.into()) + 0.5)
}

/// From the eye through a point of the screen, in pixels.
fn ray_through(view: &View, place: DVec2) -> Ray {
    let x = place.x - 0.5 * f64::from(view.width);
    let y = 0.5 * f64::from(view.height) - place.y;
    let direction = view.focal * view.forward + x * view.right + y * view.up;
    Ray {
        origin: view.eye,
        direction: direction.normalize(),
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Opens a pixel; `samples` is n of its n×n samples.
    Pixel { x: u32, y: u32, samples: u32 },
    /// The point of the screen through which the next primary ray goes, in pixels; `sample` counts the rays of the pixel, row by
    /// row, where there is more than one.
    Through { place: DVec2, sample: Option<u32> },
    /// Closes `Pixel`.
    PixelColored { color: Rgb },
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Unrecorded;
    use crate::scene::Camera;
    use glam::DVec3;

    fn view() -> View {
        let camera = Camera {
            eye: DVec3::new(1.0, 2.0, -6.0),
            target: DVec3::new(0.0, 0.7, 0.0),
            up: DVec3::Y,
            fov_x: 40_f64.to_radians(),
        };
        View::new(&camera, 64, 48)
    }

    fn rays(samples: u32, at: (u32, u32)) -> Vec<DVec2> {
        let view = view();
        let mut places = Vec::new();
        let samples = NonZeroU32::new(samples).expect("not zero");
        pixel::<Event, _>(&view, samples, at, &mut Unrecorded, |ray, _| {
            assert!((ray.direction.length() - 1.0).abs() < 1e-15);
            places.push(view.to_screen(view.to_camera(ray.at(7.0))));
            Rgb::WHITE
        });
        places
    }

    #[test]
    fn the_ray_of_a_pixel_goes_through_its_centre() {
        for at in [(0, 0), (63, 47), (20, 3)] {
            let centre = DVec2::new(at.0.into(), at.1.into()) + 0.5;
            let [place] = rays(1, at)[..] else {
                panic!("one ray")
            };
            assert!(place.distance(centre) < 1e-12, "{place} for {at:?}");
        }
    }

    #[test]
    fn samples_are_the_centres_of_cells() {
        let places = rays(2, (5, 6));
        let expected = [[5.25, 6.25], [5.75, 6.25], [5.25, 6.75], [5.75, 6.75]].map(DVec2::from);
        assert_eq!(places.len(), 4);
        for (place, expected) in places.iter().zip(expected) {
            assert!(place.distance(expected) < 1e-12);
        }
    }
}
