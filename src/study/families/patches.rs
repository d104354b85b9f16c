//! Radiosity by patches a wall: how far constant patches are off the light of finer ones, from dividing to solving.

use super::scenes;
use crate::algorithms::enclosure::{self, Enclosure};
use crate::algorithms::form_factor::Method;
use crate::algorithms::form_factor::hemicube::Hemicubes;
use crate::algorithms::radiosity::RecordFilter;
use crate::language::Message;
use crate::record::Unrecorded;
use crate::scene::Parts;
use crate::scene::{Scene, Shape};
use crate::study::errors::Errors;
use crate::study::fit::Law;
use crate::study::form::{
    Axes, Curve, Operations, Reference, Request, Setting, Study, Sweep, Values,
};
use crate::study::label::Label;
use std::rc::Rc;

pub static STUDY: Study = Study {
    name: "patches",
    title: Message("study-patches"),
    about: Message("study-patches-about"),
    sweeps,
};

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    let scene = request.scene.map_or_else(|| scenes::cube(1), Scene::clone);
    let is_quadrilateral =
        |shape: &Shape| matches!(shape, Shape::Polygon { vertices } if vertices.len() == 4);
    if !scene
        .objects
        .iter()
        .all(|object| is_quadrilateral(&object.shape))
    {
        return Err(
            "walls that are not quadrilaterals have no grid of patches to be compared in".into(),
        );
    }
    // So that the finest matrix has a few million entries
    let walls = scene.objects.len() as u32;
    let afford = |n: u32| walls * n * n <= request.either(700, 4000);
    let sweep: &[u32] = request.either(&[1, 2, 4], &[1, 2, 4, 8]);
    let finest = request.either(8, 16);
    if !afford(finest) {
        return Err(format!(
            "{walls} walls of {finest}×{finest} patches are too many to be solved again and again"
        ));
    }
    let scene = Rc::new(scene);
    let right = Work {
        scene: scene.clone(),
        n: finest,
        form_factors: Method::Auto { tolerance: 1e-6 },
    };
    let fine = right.solve()?;
    let coarse = Work {
        n: finest / 2,
        ..right.clone()
    };
    // Richardson: an error of second order is a third of what halving the patches changes.
    let means = means(&fine, finest as usize);
    let change = Errors::of(&coarse.solve()?, &means).map_or(0.0, |errors| errors.rms);
    let truth: Rc<[f64]> = fine.into();
    let methods = [
        (Label::of("value-auto"), right.form_factors),
        (
            Label::of("curve-hemicube-of-64-pixels"),
            Method::Hemicube(Hemicubes {
                resolution: 64,
                points: 1,
            }),
        ),
    ];
    let curves = methods.map(|(name, form_factors)| {
        let sweep_settings = sweep.iter().map(|&n| {
            let work = Work {
                scene: scene.clone(),
                n,
                form_factors,
            };
            work.sweep_setting(finest)
        });
        Curve::against(&truth, name, sweep_settings.collect())
    });
    Ok(vec![Sweep {
        title: Label::of("part-walls"),
        axes: Axes::ErrorOverTime,
        size: Message("measure-patches-along-a-wall"),
        quantity: Message("measure-radiosity-at-the-finest-centres"),
        law: Law::Power,
        reference: Reference {
            what: Label::with("reference-finest-patches", "finest", finest),
            error: change / 3.0,
            known_by: Label::of("reference-richardson"),
        },
        memory: Message("memory-matrix-of-form-factors"),
        curves: curves.into(),
    }])
}

/// A room to be divided and solved.
#[derive(Clone)]
struct Work {
    scene: Rc<Scene>,
    n: u32,
    form_factors: Method,
}

impl Work {
    /// B of every patch and channel. Errors: why there is none.
    fn solve(&self) -> Result<Vec<f64>, String> {
        let mut scene = (*self.scene).clone();
        for object in &mut scene.objects {
            object.patches = [self.n; 2];
        }
        let settings = enclosure::Settings {
            form_factors: self.form_factors,
            ..enclosure::Settings::default()
        };
        let enclosure =
            Enclosure::of(&scene, settings, Parts::NONE).map_err(|error| error.to_string())?;
        let matrix = enclosure.form_factors().matrix();
        let light = enclosure.solve(&matrix, &RecordFilter::default(), &mut Unrecorded);
        let light = light.map_err(|why| why.to_string())?;
        let patches = light.radiosity.iter();
        Ok(patches.flat_map(|b| b.channels()).collect())
    }

    /// What it finds at the centres of `finest`² patches a wall.
    fn sweep_setting(self, finest: u32) -> Setting {
        let n = self.n;
        let walls = self.scene.objects.len() as u64;
        let patches = walls * u64::from(n).pow(2);
        Setting {
            setting: Label::Plain(format!("{n}×{n}")),
            size: n.into(),
            bytes: patches * patches * size_of::<f64>() as u64,
            operations: vec![
                Operations {
                    of: "patches",
                    count: patches,
                },
                Operations {
                    of: "form_factors",
                    count: patches * patches,
                },
            ],
            truth: None,
            drawn: None,
            run: Box::new(move || {
                let found = self.solve()?;
                Ok(Values::Numbers(spread(&found, n as usize, finest as usize)))
            }),
        }
    }
}

/// Channels of a patch.
const CHANNELS: usize = 3;

/// The values of n×n patches a wall at the centres of `finest`² ones, of which n is a divisor. Patches run along u first.
fn spread(values: &[f64], n: usize, finest: usize) -> Vec<f64> {
    let within = finest / n;
    let wall = |wall: &[f64]| -> Vec<f64> {
        let places = (0..finest).flat_map(|i| (0..finest).map(move |j| (i, j)));
        places
            .flat_map(|(i, j)| {
                let patch = (i / within) * n + j / within;
                wall[patch * CHANNELS..(patch + 1) * CHANNELS].to_vec()
            })
            .collect()
    };
    values.chunks(n * n * CHANNELS).flat_map(wall).collect()
}

/// The means over 2×2 of n×n patches a wall.
fn means(values: &[f64], n: usize) -> Vec<f64> {
    let half = n / 2;
    let wall = |wall: &[f64]| -> Vec<f64> {
        let mut means = vec![0.0; half * half * CHANNELS];
        for (index, value) in wall.iter().enumerate() {
            let (patch, channel) = (index / CHANNELS, index % CHANNELS);
            let (i, j) = (patch / n / 2, patch % n / 2);
            means[(i * half + j) * CHANNELS + channel] += 0.25 * value;
        }
        means
    };
    values.chunks(n * n * CHANNELS).flat_map(wall).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_means_of_what_was_spread_are_what_it_was() {
        // Two walls of 2×2 patches, three channels each
        let values: Vec<f64> = (0..24).map(f64::from).collect();
        assert_eq!(means(&spread(&values, 2, 4), 4), values);
        assert_eq!(spread(&values, 2, 2), values);
    }
}
