//! `lightwalk compare`: a picture, form factors or radiosities of another program against ours.

use super::arguments::{LimitArguments, RayArguments, method, method_names};
use super::compare_room::{self, Room};
use super::failure::{Failure, note};
use super::files;
use super::form_factors::MemoryArgument;
use super::notes;
use super::output;
use super::progress::Progress;
use super::radiosity::SystemArguments;
use crate::algorithms::enclosure;
use crate::color::{StoredImage, png_rgb8, read_image, surplus};
use crate::language::Language;
use crate::methods::{Method, Mistake, Settings, Setup};
use crate::picture::plain;
use crate::study::against::{Comparison, compare, difference, screen_pixels};
use std::convert::Infallible;
use std::io::Write;
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
#[command(after_long_help = list_of_mistakes())]
pub struct Arguments {
    /// A scene file
    scene: PathBuf,
    /// How it was drawn; form factors and radiosities are those of radiosity
    #[arg(long, value_parser = method_names(), value_name = "METHOD", required_unless_present_any = ["matrix", "radiosity"])]
    method: Option<String>,
    #[command(flatten)]
    mine: Mine,
    /// How far a channel may be off, in the numbers of the file [default: 1/255]; an entry of a matrix [default: 1e-4]; or a radiosity,
    /// relative to the largest [default: 1e-3]
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    tolerance: Option<f64>,
    /// Prints one JSON object
    #[arg(long)]
    json: bool,
    /// A folder for the pictures: reference.png and difference.png
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    #[command(flatten)]
    rays: RayArguments,
    #[command(flatten)]
    system: SystemArguments,
    #[command(flatten)]
    memory: MemoryArgument,
    #[command(flatten)]
    limits: LimitArguments,
}

/// What your program made.
#[derive(clap::Args)]
#[group(required = true, multiple = false)]
struct Mine {
    /// Your picture: PNG, PPM or PFM; of a folder the newest of them
    #[arg(long, value_name = "IMAGE")]
    with: Option<PathBuf>,
    /// Your form factors, a row a patch: CSV, JSON or NPY
    #[arg(long, value_name = "MATRIX")]
    matrix: Option<PathBuf>,
    /// Your radiosities, a row a patch with red, green and blue, or with one number: CSV, JSON or NPY
    #[arg(long, value_name = "FILE")]
    radiosity: Option<PathBuf>,
}

/// Every mistake, a line each.
fn list_of_mistakes() -> String {
    let mut lines = vec!["Mistakes that are tried:".to_owned()];
    lines.extend(Mistake::ALL.iter().map(|mistake| {
        let words = plain(&mistake.in_words(Language::English));
        format!("  {:<30} {words}", mistake.name())
    }));
    lines.join("\n")
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    match &arguments.mine {
        Mine {
            with: Some(image), ..
        } => picture(&arguments, image),
        Mine {
            matrix: Some(path), ..
        } => {
            for_rooms_only(&arguments, "--matrix")?;
            compare_room::matrix(&arguments.room(compare_room::OF_ENTRIES)?, path)
        }
        Mine {
            radiosity: Some(path),
            ..
        } => {
            for_rooms_only(&arguments, "--radiosity")?;
            compare_room::radiosity(&arguments.room(compare_room::OF_RADIOSITIES)?, path)
        }
        Mine { .. } => Err(Failure::Wrong("nothing is given to compare".into())),
    }
}

/// What is said of pictures alone does not fit here.
fn for_rooms_only(arguments: &Arguments, option: &str) -> Result<(), Failure> {
    let wrong = |with: String| Err(Failure::Wrong(format!("{option} does not go with {with}")));
    match &arguments.method {
        Some(name) if name != Method::Radiosity.name() => wrong(format!("--method {name}")),
        _ if arguments.out.is_some() => wrong("--out, which is for pictures".into()),
        _ if arguments.rays.is_given() => wrong("--depth and --samples".into()),
        _ => Ok(()),
    }
}

impl Arguments {
    /// The tolerance given, or that of what is compared.
    fn tolerance(&self, unless: f64, most: f64) -> Result<f64, Failure> {
        let tolerance = self.tolerance.unwrap_or(unless);
        match (0.0..=most).contains(&tolerance) {
            true => Ok(tolerance),
            false => Err(Failure::Wrong(format!(
                "--tolerance {tolerance}: allowed are numbers from 0 to {most}"
            ))),
        }
    }

    /// Whose form factors or radiosities are compared, and how.
    fn room(&self, tolerance: f64) -> Result<Room<'_>, Failure> {
        Ok(Room {
            scene: &self.scene,
            system: &self.system,
            memory: self.memory,
            limits: self.limits,
            tolerance: self.tolerance(tolerance, 1.0)?,
            in_json: self.json,
        })
    }
}

fn picture(arguments: &Arguments, image: &Path) -> Result<(), Failure> {
    // Without a method, clap has refused the command.
    let method = method(arguments.method.as_deref().unwrap_or_default())?;
    let tolerance = arguments.tolerance(1.0 / 255.0, 1e6)?;
    if let Some(folder) = &arguments.out {
        output::check_output_folder(folder)?;
    }
    let image = &newest(image)?;
    let wrong = |error: &str| files::wrong(&image.display(), &error);
    let bytes = files::bytes(image)?;
    let mine = read_image(&bytes).map_err(|error| wrong(&error))?;
    let surplus = surplus(&bytes);
    if surplus > 0 {
        let what = format!("{surplus} bytes follow its pixels and are not read");
        note(format_args!("{}: note: {what}", image.display()));
    }
    let setup = setup(arguments, method, &mine)?;
    notes::print(&arguments.scene.display(), &arguments.rays.notes(method));
    let threads = std::thread::available_parallelism().unwrap_or(std::num::NonZeroUsize::MIN);
    let progress = Progress::new("comparing");
    let show = |done, all| {
        progress.show(done, all);
        Ok::<(), Infallible>(())
    };
    let Ok(found) = compare(&mine, &setup, method, tolerance, threads, &show, |_| {});
    drop(progress);
    if let Some(folder) = &arguments.out {
        write(folder, &mine, &found)?;
    }
    let mut out = std::io::stdout();
    match arguments.json {
        true => {
            let json = serde_json::to_string(&found).map_err(|error| wrong(&error.to_string()))?;
            writeln!(out, "{json}")?;
        }
        false => write!(out, "{}", in_words(&found, arguments, method))?,
    }
    match found.off {
        0 => Ok(()),
        off => Err(Failure::Failed(format!(
            "{off} of {} pixels differ by more than {tolerance}",
            found.pixels
        ))),
    }
}

/// The scene before a picture of the size of the other.
fn setup(arguments: &Arguments, method: Method, mine: &StoredImage) -> Result<Setup, Failure> {
    let scene = &arguments.scene;
    let (read, settings) = files::scene(scene, &arguments.limits.into())?;
    let system = arguments
        .system
        .or(settings.get::<enclosure::Settings>(), arguments.limits)?;
    let settings = Settings::from(arguments.rays.or(settings.get())).with(system);
    let size = [mine.width, mine.height];
    let prepared = files::prepared(read, size, method, &scene.display())?;
    let setup = Setup::new(prepared, settings);
    let checked = setup.check_for(method).map_err(|error| error.to_string());
    checked.map_err(|error| files::wrong(&scene.display(), &error))?;
    Ok(setup)
}

/// The picture itself, or the newest one of a folder.
fn newest(path: &Path) -> Result<PathBuf, Failure> {
    if !path.is_dir() {
        return Ok(path.to_owned());
    }
    let cannot = |reason: &str| files::wrong(&path.display(), &reason);
    let entries = std::fs::read_dir(path).map_err(|error| cannot(&error.to_string()))?;
    let pictures = entries.filter_map(|entry| {
        let path = entry.ok()?.path();
        let extension = path.extension()?.to_ascii_lowercase();
        let is_picture = ["png", "ppm", "pfm"]
            .iter()
            .any(|known| extension == *known);
        let saved = path.metadata().ok()?.modified().ok()?;
        is_picture.then_some((saved, path))
    });
    let newest = pictures.max();
    newest
        .map(|(_, path)| path)
        .ok_or_else(|| cannot("no picture is in this folder (.png, .ppm or .pfm)"))
}

fn in_words(found: &Comparison, arguments: &Arguments, method: Method) -> String {
    let [width, height] = found.size;
    let mut lines = vec![
        format!("{width} × {height} pixels, encoding {}", found.encoding),
        format!(
            "{} of {} pixels differ; largest difference {:.4}, rms {:.2e}",
            found.off, found.pixels, found.largest, found.rms
        ),
    ];
    for worst in &found.worst {
        let [mine, reference] = [worst.mine, worst.reference]
            .map(|channels| channels.map(|channel| format!("{channel:.3}")).join(" "));
        lines.push(format!(
            "  pixel ({}, {}): yours {mine}, reference {reference}",
            worst.x, worst.y
        ));
    }
    if let Some(worst) = found.worst.first() {
        lines.push(format!(
            "how the worst one comes about: lightwalk steps {} --method {} --size {width}x{height} --pixel {},{}",
            arguments.scene.display(),
            method.name(),
            worst.x,
            worst.y
        ));
    }
    for mistake in &found.mistakes {
        lines.push(format!(
            "{}: ours with {} explains {} of {} differing pixels",
            mistake.name,
            plain(&mistake.mistake.in_words(Language::English)),
            mistake.explains,
            mistake.of
        ));
    }
    if found.off > 0 && found.mistakes.is_empty() {
        lines.push("no classic mistake explains a tenth of them".into());
    }
    lines.join("\n") + "\n"
}

/// The reference as it would be stored, and the signed difference of the channels' mean: orange where yours is brighter.
fn write(folder: &Path, mine: &StoredImage, found: &Comparison) -> Result<(), Failure> {
    std::fs::create_dir_all(folder).map_err(|error| {
        Failure::Failed(format!(
            "cannot make the folder {}: {error}",
            folder.display()
        ))
    })?;
    let reference = screen_pixels(&found.reference, mine.is_float);
    let difference = difference(&mine.pixels, found);
    for (name, bytes) in [("reference.png", reference), ("difference.png", difference)] {
        let png = png_rgb8(mine.width, mine.height, bytes.as_flattened());
        output::write_whole(&folder.join(name), |writer| writer.write_all(&png))?;
    }
    Ok(())
}
