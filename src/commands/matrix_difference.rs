//! How a matrix of form factors of another program differs from ours.

use super::failure::Failure;
use super::files;
use crate::algorithms::enclosure::{Enclosure, Settings};
use crate::render;
use crate::scene::{Parts, Scene};
use crate::study::matrix;
use serde_json::{Value as Json, json};
use std::convert::Infallible;
use std::io::Write;
use std::num::NonZeroUsize;
use std::path::Path;
use std::thread::available_parallelism;

/// Reads the matrix of another program.
pub fn read_matrix(path: &Path, enclosure: &Enclosure) -> Result<Vec<f64>, Failure> {
    let read = matrix::read(&files::bytes(path)?, enclosure.patches.len());
    read.map_err(|error| files::wrong(&path.display(), &error))
}

/// Says how a matrix of another program differs from ours.
pub fn compare_matrix(
    scene: &Scene,
    enclosure: &Enclosure,
    (mine, reference): (&[f64], &[f64]),
    tolerance: f64,
    in_json: bool,
) -> Result<(), Failure> {
    let unblocked = || {
        let settings = Settings {
            visibility: false,
            ..enclosure.settings
        };
        let unblocked = Enclosure::of(scene, settings, Parts::NONE).ok()?;
        let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let Ok(matrix) = render::matrix(&unblocked, threads, &|_, _| Ok::<(), Infallible>(()));
        Some(matrix.to_vec())
    };
    let areas = enclosure.patches.areas();
    let rho: Vec<[f64; 3]> = enclosure
        .reflectance
        .iter()
        .map(|rho| rho.channels())
        .collect();
    let found = matrix::compare(mine, reference, &areas, &rho, tolerance, unblocked);
    let text = match in_json {
        true => with_place(json!(found), scene, enclosure, "row").to_string() + "\n",
        false => matrix_in_words(&found, scene, enclosure, tolerance),
    };
    let (off, all) = (found.off, mine.len());
    print(
        &text,
        off,
        format!("{off} of {all} entries differ by more than {tolerance}"),
    )
}

pub fn print(text: &str, off: usize, failed: String) -> Result<(), Failure> {
    std::io::stdout().write_all(text.as_bytes())?;
    match off {
        0 => Ok(()),
        _ => Err(Failure::Failed(failed)),
    }
}

/// What was found, and the object and the cell of the first patch that differs.
pub fn with_place(mut found: Json, scene: &Scene, enclosure: &Enclosure, key: &str) -> Json {
    if let Some(first) = found.get_mut("first").and_then(Json::as_object_mut)
        && let Some(patch) = first.get(key).and_then(Json::as_u64)
    {
        let patch = &enclosure.patches[patch as usize];
        let [i, j] = patch.cell;
        let object = &scene.objects[patch.object as usize].name;
        first.extend([
            ("object".to_owned(), json!(object)),
            ("i".to_owned(), json!(i)),
            ("j".to_owned(), json!(j)),
        ]);
    }
    found
}

/// A patch by its number, its object and its cell.
pub fn place(patch: usize, scene: &Scene, enclosure: &Enclosure) -> String {
    let patch_of = &enclosure.patches[patch];
    let [i, j] = patch_of.cell;
    let object = &scene.objects[patch_of.object as usize].name;
    format!("{patch} (\"{object}\" {i},{j})")
}

fn matrix_in_words(
    found: &matrix::MatrixComparison,
    scene: &Scene,
    enclosure: &Enclosure,
    tolerance: f64,
) -> String {
    let n = enclosure.patches.len();
    let mut lines = vec![format!(
        "{n} × {n} entries: {} differ by more than {tolerance}, the largest difference is {:.3e}",
        found.off, found.largest
    )];
    if let Some(entry) = found.first {
        let [row, column] = [entry.row, entry.column].map(|patch| place(patch, scene, enclosure));
        lines.push(format!(
            "first row that differs: patch {row}; from it to patch {column} yours is {}, and the reference {}",
            entry.mine, entry.reference
        ));
    }
    match found.looks {
        Some(looks) => lines.push(looks.in_words().into()),
        None if found.is_symmetric => lines.push(
            "yours is symmetric, F_ij = F_ji: that is right only between patches of equal area"
                .into(),
        ),
        None => {}
    }
    if let Some(sum) = found.sums.first() {
        lines.push(format!(
            "{} rows sum to something else: row {} to {:.6}, that of the reference to {:.6}",
            found.sums.len(),
            sum.row,
            sum.mine,
            sum.reference
        ));
    }
    lines.join("\n") + "\n"
}
