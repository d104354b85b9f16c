//! Form factors and radiosities of another program against ours.

use super::arguments::LimitArguments;
use super::failure::Failure;
use super::files;
use super::form_factors::{MemoryArgument, enclosure, matrix_of};
use super::matrix_difference::{compare_matrix, place, print, read_matrix, with_place};
use super::radiosity::{SystemArguments, light};
use crate::algorithms::enclosure::{Enclosure, Settings};
use crate::color::Rgb;
use crate::scene::Scene;
use crate::study::room_light;
use serde_json::json;
use std::path::Path;

/// How far an entry of a matrix may be off, and a radiosity relative to the largest.
pub const OF_ENTRIES: f64 = 1e-4;
pub const OF_RADIOSITIES: f64 = 1e-3;

/// Whose form factors or radiosities are compared, and how.
pub struct Room<'a> {
    /// A scene file.
    pub scene: &'a Path,
    pub system: &'a SystemArguments,
    pub memory: MemoryArgument,
    pub limits: LimitArguments,
    pub tolerance: f64,
    pub in_json: bool,
}

/// `compare --matrix`
pub fn matrix(room: &Room, path: &Path) -> Result<(), Failure> {
    let unless = Settings {
        closure: false,
        ..Settings::default()
    };
    let (scene, enclosure) = read_room(room, Some(unless))?;
    let mine = read_matrix(path, &enclosure)?;
    let both = (&mine[..], matrix_of(&enclosure));
    compare_matrix(&scene, &enclosure, both, room.tolerance, room.in_json)
}

/// `compare --radiosity`
pub fn radiosity(room: &Room, path: &Path) -> Result<(), Failure> {
    let (scene, enclosure) = read_room(room, None)?;
    let mine = room_light::read(&files::bytes(path)?, enclosure.patches.len());
    let mine = mine.map_err(|error| files::wrong(&path.display(), &error))?;
    let ours = &light(&scene, &enclosure)?.radiosity;
    let (matrix, tolerance) = (matrix_of(&enclosure), room.tolerance);
    let found = room_light::compare(&mine, ours, &enclosure, matrix, tolerance);
    let (off, all) = (found.off, found.patches);
    let text = match room.in_json {
        true => with_place(json!(found), &scene, &enclosure, "patch").to_string() + "\n",
        false => light_in_words(&found, &scene, &enclosure, tolerance),
    };
    let failed = format!("{off} of {all} radiosities differ by more than {tolerance}");
    print(&text, off, failed)
}

/// The scene's patches. The settings are those of the scene unless given.
fn read_room(room: &Room, unless: Option<Settings>) -> Result<(Scene, Enclosure), Failure> {
    let path = room.scene;
    let (scene, settings) = files::scene(path, &room.limits.into())?;
    let unless = unless.unwrap_or(settings.get());
    let settings = room.system.or(unless, room.limits)?;
    let enclosure = enclosure(&scene, path, settings)?;
    match room.memory.refusal(&enclosure) {
        Some(refusal) => Err(files::wrong(&path.display(), &refusal)),
        None => Ok((scene, enclosure)),
    }
}

fn light_in_words(
    found: &room_light::LightComparison,
    scene: &Scene,
    enclosure: &Enclosure,
    tolerance: f64,
) -> String {
    let mut lines = vec![format!(
        "{} patches: {} differ by more than {tolerance} of the largest radiosity, the largest difference is {:.3e} of it",
        found.patches, found.off, found.largest
    )];
    if let Some(first) = found.first {
        let place = place(first.patch, scene, enclosure);
        let [mine, reference] = [first.mine, first.reference].map(Rgb::from).map(written);
        lines.push(format!(
            "first patch that differs: {place}; yours is {mine}, and the reference {reference}"
        ));
    }
    lines.extend(found.looks.map(|looks| looks.in_words().into()));
    lines.join("\n") + "\n"
}

fn written(color: Rgb) -> String {
    color
        .channels()
        .map(|channel| format!("{channel:.6}"))
        .join(" ")
}
