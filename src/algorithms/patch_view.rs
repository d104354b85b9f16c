//! An enclosure seen by the camera: every patch in its radiosity, constant over the patch or interpolated between its corners
//! (Cohen & Greenberg, "The hemi-cube", SIGGRAPH 1985, §5).
//!
//! Primary rays, and nothing else: what a diffuse surface gives off looks the same from everywhere. The back of a patch gives off
//! nothing, and is black; so is what lies beside the patches.

use super::enclosure::Enclosure;
use super::primary;
use crate::color::Rgb;
use crate::record::Unrecorded;
use crate::scene::View;
use crate::scene::primitives::Ray;
use glam::DVec3;
use std::collections::HashMap;
use std::num::NonZeroU32;

/// The picture of an enclosure whose light is known.
pub struct PatchView<'a> {
    view: &'a View,
    /// n of the n×n samples of a pixel.
    samples: NonZeroU32,
    enclosure: &'a Enclosure,
    radiosity: &'a [Rgb],
    /// By patch, the radiosity at the corners of its pieces in their order; none where patches are shown constant.
    corners: Option<Vec<Vec<Rgb>>>,
}

impl<'a> PatchView<'a> {
    /// `radiosity` has one colour a patch. The settings of the enclosure say whether they are interpolated.
    pub fn new(
        view: &'a View,
        samples: NonZeroU32,
        enclosure: &'a Enclosure,
        radiosity: &'a [Rgb],
    ) -> Self {
        let smooth = enclosure.settings.smooth;
        PatchView {
            view,
            samples,
            enclosure,
            radiosity,
            corners: smooth.then(|| corner_values(enclosure, radiosity)),
        }
    }

    /// The colour of pixel (x, y).
    pub fn pixel(&self, x: u32, y: u32) -> Rgb {
        let mut untold = Unrecorded;
        let seen = |ray: &Ray, _: &mut Unrecorded| self.seen(ray);
        primary::pixel::<primary::Event, _>(self.view, self.samples, (x, y), &mut untold, seen)
    }

    fn seen(&self, ray: &Ray) -> Rgb {
        let Some((patch, hit)) = self.enclosure.primitives.nearest(ray) else {
            return Rgb::BLACK;
        };
        if ray.direction.dot(self.enclosure.patches[patch].normal) >= 0.0 {
            return Rgb::BLACK;
        }
        match &self.corners {
            None => self.radiosity[patch],
            Some(corners) => self.interpolated(patch, &corners[patch], ray.at(hit.t)),
        }
    }

    /// Between the corners of the triangle of the patch in which the point lies.
    fn interpolated(&self, patch: usize, values: &[Rgb], point: DVec3) -> Rgb {
        let mut first = 0;
        let mut best = (f64::NEG_INFINITY, self.radiosity[patch]);
        for piece in self.enclosure.patches.pieces(patch) {
            let values = &values[first..first + piece.corners.len()];
            first += piece.corners.len();
            for i in 2..piece.corners.len() {
                let corners = [0, i - 1, i];
                let [a, b, c] = corners.map(|corner| piece.corners[corner]);
                let area = |p: DVec3, q: DVec3, r: DVec3| (q - p).cross(r - p).dot(piece.normal);
                let whole = area(a, b, c);
                let weights = [area(point, b, c), area(a, point, c), area(a, b, point)]
                    .map(|part| part / whole);
                let inside = weights.into_iter().fold(f64::INFINITY, f64::min);
                if inside > best.0 {
                    let sum = |sum: Rgb, i: usize| sum + values[corners[i]] * weights[i];
                    best = (inside, (0..3).fold(Rgb::BLACK, sum));
                }
            }
        }
        best.1
    }
}

/// The patch whose front is seen through the middle of each pixel, row by row.
pub fn seen_patches(enclosure: &Enclosure, view: &View) -> Vec<Option<u32>> {
    let pixels = (0..view.height).flat_map(|y| (0..view.width).map(move |x| (x, y)));
    let seen = pixels.map(|(x, y)| {
        let ray = primary::middle_ray(view, (x, y));
        let (patch, _) = enclosure.primitives.nearest(&ray)?;
        let faces = ray.direction.dot(enclosure.patches[patch].normal) < 0.0;
        faces.then_some(patch as u32)
    });
    seen.collect()
}

/// By patch, the radiosity at the corners of its pieces in their order: the mean of the patches of one object that meet there.
pub fn corner_values(enclosure: &Enclosure, radiosity: &[Rgb]) -> Vec<Vec<Rgb>> {
    let place = |object: u32, corner: DVec3| (object, corner.to_array().map(f64::to_bits));
    let mut sums: HashMap<(u32, [u64; 3]), (Rgb, f64)> = HashMap::new();
    for (number, patch) in enclosure.patches.iter().enumerate() {
        // A corner that two pieces of a patch share counts once.
        let mut places: Vec<_> = corners_of(enclosure, number)
            .map(|corner| place(patch.object, corner))
            .collect();
        places.sort_unstable();
        places.dedup();
        for place in places {
            let (sum, count) = sums.entry(place).or_insert((Rgb::BLACK, 0.0));
            *sum += radiosity[number];
            *count += 1.0;
        }
    }
    let mean = |object, corner| {
        let (sum, count) = sums[&place(object, corner)];
        sum * (1.0 / count)
    };
    let patches = enclosure.patches.iter().enumerate();
    patches
        .map(|(number, patch)| {
            corners_of(enclosure, number)
                .map(|corner| mean(patch.object, corner))
                .collect()
        })
        .collect()
}

fn corners_of(enclosure: &Enclosure, patch: usize) -> impl Iterator<Item = DVec3> {
    let pieces = enclosure.patches.pieces(patch);
    pieces.flat_map(|piece| piece.corners.iter().copied())
}
