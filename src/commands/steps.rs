//! `lightwalk steps`: every step of a run, a JSON object a line, or a line of a table.

use super::arguments::{
    LimitArguments, RayArguments, method, method_names, parse_range, parse_size, parse_whole,
};
use super::failure::{Failure, note};
use super::files::{self, Document};
use super::hierarchy::HierarchyArguments;
use super::notes;
use super::output;
use super::progress::{self, Progress};
use super::radiosity::{SystemArguments, ToleranceArgument};
use crate::algorithms::focus::Focus;
use crate::export::{Table, TakeAway, steps_in_lines, steps_in_table};
use crate::methods::{Method, Settings, Setup};
use crate::record::RecordingLimit;
use crate::replay::Run;
use std::io::{BufWriter, Write};
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

#[derive(clap::Args)]
pub struct Arguments {
    #[command(flatten)]
    recorded: Recorded,
    #[command(flatten)]
    tolerance: ToleranceArgument,
    /// FILE.jsonl, or FILE.csv with a column for each value; JSON lines on standard output unless given
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// What is recorded, and how.
#[derive(clap::Args)]
pub struct Recorded {
    /// The id of a lesson, a lesson file, or a scene file
    #[arg(value_name = "LESSON_OR_SCENE")]
    name: String,
    /// How to draw a scene; a lesson has its own method
    #[arg(long, value_parser = method_names(), value_name = "METHOD")]
    method: Option<String>,
    /// Of the picture; a lesson has its own
    #[arg(long, allow_hyphen_values = true, value_parser = parse_size, value_name = "WxH")]
    size: Option<[u32; 2]>,
    #[command(flatten)]
    focus: FocusArguments,
    #[command(flatten)]
    rays: RayArguments,
    #[command(flatten)]
    hierarchy: HierarchyArguments,
    #[command(flatten)]
    system: SystemArguments,
    #[command(flatten)]
    limits: LimitArguments,
}

/// What is recorded: the whole frame unless given.
#[derive(clap::Args)]
#[group(multiple = false)]
struct FocusArguments {
    /// One pixel, from the top left, counted from 0
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = parse_pixel)]
    pixel: Option<[u32; 2]>,
    /// One scan line, from the top, counted from 0
    #[arg(long, value_name = "Y", allow_hyphen_values = true, value_parser = parse_whole::<u32>)]
    scan_line: Option<u32>,
    /// One polygon, counted from 0 over all objects
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = parse_whole::<usize>)]
    polygon: Option<usize>,
    /// Of radiosity: iterations (or shots), counted from 0
    #[arg(long, value_name = "A..B", allow_hyphen_values = true, value_parser = parse_range)]
    iterations: Option<Range<usize>>,
    /// Of radiosity: what one patch exchanges, counted from 0 over all objects
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = parse_whole::<u32>)]
    patch: Option<u32>,
    /// Of radiosity: how the form factor from patch I to patch J is found
    #[arg(long, value_name = "I,J", allow_hyphen_values = true, value_parser = parse_pair)]
    form_factor: Option<[u32; 2]>,
}

impl FocusArguments {
    fn focus(&self) -> Option<Focus> {
        let bounded = |end: usize| u32::try_from(end).unwrap_or(u32::MAX);
        match self {
            Self {
                pixel: Some([x, y]),
                ..
            } => Some(Focus::Pixel { x: *x, y: *y }),
            Self {
                scan_line: Some(y), ..
            } => Some(Focus::ScanLine(*y)),
            Self {
                polygon: Some(number),
                ..
            } => Some(Focus::Polygon(*number)),
            Self {
                iterations: Some(range),
                ..
            } => Some(Focus::Iterations {
                start: bounded(range.start),
                end: bounded(range.end),
            }),
            Self {
                patch: Some(number),
                ..
            } => Some(Focus::Patch(*number)),
            Self {
                form_factor: Some([i, j]),
                ..
            } => Some(Focus::FormFactor { i: *i, j: *j }),
            _ => None,
        }
    }
}

fn parse_pixel(text: &str) -> Result<[u32; 2], String> {
    two(text).ok_or_else(|| "a pixel is written as 12,34; it counts from 0".into())
}

fn parse_pair(text: &str) -> Result<[u32; 2], String> {
    two(text).ok_or_else(|| "a pair of patches is written as 12,34; it counts from 0".into())
}

fn two(text: &str) -> Option<[u32; 2]> {
    let (a, b) = text.split_once(',')?;
    Some([a.parse().ok()?, b.parse().ok()?])
}

/// What is said of a run that is too long to be recorded whole.
pub const TRUNCATED: &str = "the recording met its memory limit, and holds only the beginning; choose --polygon, --scan-line or --pixel";

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    if let Some(out) = &arguments.out {
        let endings = [TakeAway::Steps.endings(), &["json"]].concat();
        output::check_known_ending("--out", out, &endings)?;
        output::check_output(out)?;
    }
    let Recording { run, .. } = arguments.recorded.record(arguments.tolerance)?;
    if run.walk().truncated() {
        // A file appears whole or not at all.
        if arguments.out.is_some() {
            return Err(Failure::Failed(TRUNCATED.into()));
        }
        note(format_args!("lightwalk: {TRUNCATED}"));
    }
    let table = arguments.out.as_deref().and_then(Table::of);
    let steps = match table {
        Some(Table::Csv) => steps_in_table(run),
        _ => steps_in_lines(run),
    };
    match &arguments.out {
        Some(path) => output::write_made(path, "writing steps", steps),
        None => {
            let mut out = BufWriter::new(std::io::stdout().lock());
            let progress = Progress::new("writing steps");
            steps.write_all(&mut out, &|done, all| progress.show(done, all))?;
            Ok(out.flush()?)
        }
    }
}

/// A run, and what it is a run of.
pub struct Recording {
    pub run: Run,
    pub setup: Arc<Setup>,
    pub focus: Focus,
}

impl Recorded {
    fn settings(
        &self,
        unless: Settings,
        tolerance: ToleranceArgument,
    ) -> Result<Settings, Failure> {
        let rays = self.rays.or(unless.get());
        let radiosity = tolerance.or(self.system.or(unless.get(), self.limits)?)?;
        let hierarchy = self.hierarchy.or(unless.get())?;
        Ok(unless.with(rays).with(radiosity).with(hierarchy))
    }

    pub fn record(&self, tolerance: ToleranceArgument) -> Result<Recording, Failure> {
        let focus = self.focus.focus();
        let method = self.method.as_deref().map(method).transpose()?;
        let notes = |method| {
            let notes = [
                self.rays.notes(method),
                self.system.notes(tolerance, method),
                self.hierarchy.notes(method),
            ];
            notes::print(&self.name, &notes.concat());
        };
        match files::lesson_or_scene(&self.name, &self.limits.into())? {
            Document::Lesson(lesson)
                if method.is_none()
                    && focus.is_none()
                    && self.size.is_none()
                    && !self.rays.is_given()
                    && self.system.given().is_empty()
                    && !self.hierarchy.is_given()
                    && tolerance.given().is_none() =>
            {
                let open = lesson
                    .open()
                    .map_err(|error| files::wrong(&self.name, &error))?;
                notes::print(&self.name, &open.setup.notes(open.lesson.method));
                Ok(Recording {
                    focus: open.lesson.focus,
                    setup: open.setup,
                    run: open.run,
                })
            }
            Document::Lesson(lesson) => {
                let method = method.unwrap_or(lesson.method);
                let size = self.size.unwrap_or(lesson.size);
                let settings = self.settings(lesson.settings, tolerance)?;
                let prepared = files::prepared(lesson.scene, size, method, &self.name)?;
                let focus = focus.unwrap_or(lesson.focus);
                notes(method);
                record_on(Setup::new(prepared, settings), method, focus, &self.name)
            }
            Document::Scene(scene) => {
                let method = method.ok_or_else(|| {
                    let known = Method::ALL.map(Method::name).join(", ");
                    Failure::Wrong(format!(
                        "--method is missing: a scene can be drawn in several ways; allowed are {known}"
                    ))
                })?;
                let size = self.size.unwrap_or([640, 480]);
                let settings = self.settings(Settings::default(), tolerance)?;
                let prepared = files::prepared(*scene, size, method, &self.name)?;
                let focus = focus.unwrap_or(Focus::Frame);
                notes(method);
                record_on(Setup::new(prepared, settings), method, focus, &self.name)
            }
        }
    }
}

fn record_on(setup: Setup, method: Method, focus: Focus, name: &str) -> Result<Recording, Failure> {
    setup
        .check_for(method)
        .map_err(|error| files::wrong(&name, error))?;
    let option = match focus {
        Focus::Frame => "",
        Focus::Polygon(_) => "--polygon",
        Focus::ScanLine(_) => "--scan-line",
        Focus::Pixel { .. } => "--pixel",
        Focus::Iterations { .. } => "--iterations",
        Focus::Patch(_) => "--patch",
        Focus::FormFactor { .. } => "--form-factor",
    };
    if !method.records(focus) {
        let does = if method == Method::HierarchicalRadiosity {
            "is recorded as a whole; choose no part of it"
        } else if method.converts_polygons() {
            "goes polygon by polygon; choose --pixel, --scan-line or --polygon"
        } else if method.follows_rays() {
            "goes pixel by pixel; choose --pixel or --scan-line"
        } else {
            "goes patch by patch; choose --iterations, --patch or --form-factor"
        };
        return Err(Failure::Wrong(format!(
            "{option}: {} {does}",
            method.name()
        )));
    }
    setup
        .check(focus)
        .map_err(|outside| Failure::Wrong(format!("{option} {outside}")))?;
    notes::print(&name, &setup.notes(method));
    let setup = Arc::new(setup);
    let run = progress::named("recording", || {
        Run::record(setup.clone(), method, focus, RecordingLimit::default())
    });
    Ok(Recording { run, setup, focus })
}
