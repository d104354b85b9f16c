//! The picture of a room while its light is found: a pixel has what its patch has so far, as the panel of the room shows it. Nothing
//! in it is ahead of the step.

use super::super::radiosity;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Region;
use crate::color::Rgb;
use crate::language::Message;
use crate::panels::PanelInput;
use crate::picture::Image;
use crate::replay::Run;
use glam::DVec3;

const SURFACES: Message = Message("image-surfaces");

pub(super) struct Light {
    /// Row by row.
    colors: Vec<Rgb>,
    /// What they are multiplied by to be shown.
    pub exposure: f64,
    width: u32,
}

impl Light {
    /// None where the run does not find the light of a room.
    pub fn of(input: &PanelInput) -> Option<Self> {
        let (Run::Radiosity(setup, _) | Run::Hierarchical(setup, _)) = input.run else {
            return None;
        };
        let room = input.run.enclosure()?;
        let view = &setup.prepared.view;
        let (colors, exposure) = match has_begun(input.run) {
            false => (flat(setup.seen_patches(), &surfaces(room, view.eye)), 1.0),
            true => {
                let (light, exposure) = input.run.light()?;
                let all: Vec<usize> = (0..room.patches.len()).collect();
                let whole = Region {
                    columns: 0..view.width,
                    rows: 0..view.height,
                };
                let smooth = input.smooth;
                let smooth = smooth.map(|draw| draw(room, &all, view, &whole, &light).color);
                (
                    smooth.unwrap_or_else(|| flat(setup.seen_patches(), &light)),
                    exposure,
                )
            }
        };
        Some(Light {
            colors,
            exposure,
            width: view.width,
        })
    }

    /// Of a pixel of the picture.
    pub fn at(&self, x: u32, y: u32) -> Option<Rgb> {
        let index = y as usize * self.width as usize + x as usize;
        self.colors.get(index).copied().filter(|_| x < self.width)
    }

    pub fn image(&self) -> Image {
        let shown = self.colors.iter();
        let shown = shown.flat_map(|&color| (color * self.exposure).to_srgb8());
        let bytes: Vec<u8> = shown.collect();
        Image::new(
            self.width,
            bytes.len() as u32 / 3 / self.width.max(1),
            bytes,
        )
    }
}

/// What the picture shows, in words; none where the run does not find the light of a room.
pub(super) fn title(input: &PanelInput) -> Option<String> {
    let title = match input.run {
        Run::Radiosity(_, replay) => {
            radiosity::title(replay.state(), input.run.enclosure()?, input.language)
        }
        Run::Hierarchical(..) => radiosity::RADIOSITY.text(input.language).to_string(),
        _ => return None,
    };
    Some(match has_begun(input.run) {
        false => SURFACES.text(input.language).to_string(),
        true => title,
    })
}

/// Whether light is being solved for, or was.
fn has_begun(run: &Run) -> bool {
    match run {
        Run::Radiosity(_, replay) => !replay.state().channels.is_empty(),
        Run::Hierarchical(_, replay) => replay.state().sweep.is_some(),
        _ => false,
    }
}

/// What the surfaces look like by a lamp at the eye, before there is any light of their own; what emits shines.
fn surfaces(room: &Enclosure, eye: DVec3) -> Vec<Rgb> {
    const LEAST: f64 = 0.3;
    let surface = |number: usize| {
        let patch = &room.patches[number];
        let cosine = patch.normal.dot((eye - patch.center).normalize_or_zero());
        let shade = LEAST + (1.0 - LEAST) * cosine.abs();
        room.reflectance[number] * shade + room.emission[number]
    };
    (0..room.patches.len()).map(surface).collect()
}

/// Each pixel in the colour of the patch that is seen in its middle.
fn flat(seen: &[Option<u32>], patches: &[Rgb]) -> Vec<Rgb> {
    let seen = seen.iter();
    seen.map(|patch| patch.map_or(Rgb::BLACK, |patch| patches[patch as usize]))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::super::fixtures::open_room;
    use super::*;
    use crate::algorithms::enclosure;
    use crate::algorithms::focus::Focus;
    use crate::algorithms::radiosity::Solver;
    use crate::language::Language;
    use crate::methods::Setup;
    use crate::render::{Method, render, smooth_patches};
    use std::num::NonZeroUsize;

    fn solved_by(solver: Solver) -> crate::panels::fixture::Fixture {
        let settings = enclosure::Settings {
            solver,
            ..enclosure::Settings::default()
        };
        open_room(settings, Focus::Frame)
    }

    fn setup<'a>(input: &PanelInput<'a>) -> &'a Setup {
        match input.run {
            Run::Radiosity(setup, _) => setup,
            _ => panic!("a room"),
        }
    }

    #[test]
    fn at_every_step_a_pixel_has_the_light_of_its_patch_and_at_the_end_the_picture_is_finished() {
        for solver in [Solver::GaussSeidel, Solver::Shooting] {
            let mut fixture = solved_by(solver);
            for step in fixture.some_steps(37) {
                fixture.seek(step);
                let input = fixture.input();
                let setup = setup(&input);
                if !has_begun(input.run) {
                    continue;
                }
                let shown = Light::of(&input).expect("a room");
                let (light, _) = input.run.light().expect("a room");
                for (x, y) in (0..12).flat_map(|y| (0..16).map(move |x| (x, y))) {
                    let patch = setup.patch_at(x, y);
                    let expected = patch.map_or(Rgb::BLACK, |patch| light[patch]);
                    assert_eq!(shown.at(x, y), Some(expected), "({x}, {y}) at {step}");
                }
            }
            let last = fixture.walk().len() - 1;
            fixture.seek(last);
            let input = fixture.input();
            let setup = setup(&input);
            let finished = render(setup, Method::Radiosity, NonZeroUsize::MIN, &|_, _| {});
            let shown = Light::of(&input).expect("a room");
            let mut lit = 0;
            for (&shown, finished) in shown.colors.iter().zip(&finished.color) {
                let apart = (shown - *finished).channels().map(f64::abs);
                // What is left unshot is below the tolerance of the solver.
                assert!(apart.iter().all(|&apart| apart < 1e-4), "{apart:?}");
                lit += usize::from(finished.max_channel() > 0.0);
            }
            assert!(lit > 10, "{lit}");
        }
    }

    #[test]
    fn before_the_first_channel_there_are_surfaces_and_no_light() {
        let mut fixture = solved_by(Solver::GaussSeidel);
        fixture.seek(0);
        let english = |input: &PanelInput| title(input).expect("a room");
        assert_eq!(english(&fixture.input()), SURFACES.text(Language::English));
        let started = fixture.first("Started");
        fixture.seek(started);
        assert!(english(&fixture.input()).starts_with("radiosity B"));
    }

    #[test]
    fn the_smooth_picture_is_that_of_the_light_so_far_too() {
        let mut fixture = solved_by(Solver::GaussSeidel);
        let [early, late] = [fixture.first("Started"), fixture.walk().len() - 1];
        let mut brightness = |step| {
            fixture.seek(step);
            let input = PanelInput {
                smooth: Some(smooth_patches),
                ..fixture.input()
            };
            let shown = Light::of(&input).expect("a room");
            shown
                .colors
                .iter()
                .map(|color| color.luminance())
                .sum::<f64>()
        };
        assert!(brightness(early) < 0.5 * brightness(late));
    }
}
