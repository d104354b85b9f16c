//! `lightwalk study`: error against run time, and how work grows; tables, plots and a summary in words.

use super::arguments::LimitArguments;
use super::failure::{Failure, note};
use super::files;
use super::notes;
use super::output;
use super::progress::Progress;
use crate::language::Language;
use crate::picture::{Theme, rasterize, to_png, to_svg};
use crate::study::families;
use crate::study::form::{Request, Study};
use crate::study::harness::Findings;
use crate::study::machine::Machine;
use crate::study::plot::plot;
use crate::study::report::{csv, json, summary};
use std::path::{Path, PathBuf};

#[derive(clap::Args)]
pub struct Arguments {
    /// Which studies; all of them unless named
    #[arg(value_name = "NAME", value_parser = names())]
    names: Vec<String>,
    /// Few and small settings: less than a minute for all studies
    #[arg(long)]
    quick: bool,
    /// A scene file of one's own, instead of the scenes that the studies bring
    #[arg(long, value_name = "SCENE")]
    scene: Option<PathBuf>,
    /// Where NAME.csv, NAME.json, NAME.png, NAME.svg and summary.md go; it is made if it does not exist
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[command(flatten)]
    limits: LimitArguments,
}

fn names() -> clap::builder::PossibleValuesParser {
    families::ALL.map(|study| study.name).into()
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    output::check_output_folder(&arguments.out)?;
    let scene = match &arguments.scene {
        Some(path) => {
            let (scene, ..) = files::scene(path, &arguments.limits.into())?;
            notes::print(&path.display(), &scene.notes);
            Some(scene)
        }
        None => None,
    };
    let request = Request {
        scene: scene.as_ref(),
        quick: arguments.quick,
    };
    let machine = Machine::this(files::processor_name());
    let wanted = |study: &&&Study| {
        let named = |name: &String| name == study.name;
        arguments.names.is_empty() || arguments.names.iter().any(named)
    };
    let (mut found, mut skipped) = (Vec::new(), Vec::new());
    for &study in families::ALL.iter().filter(wanted) {
        let progress = Progress::new(study.name);
        let recorded = |done, all| {
            progress.show(done, all);
            Ok(())
        };
        let measured = study.measure(&request, &recorded, &|_| ());
        drop(progress);
        match measured {
            Ok(mut findings) => {
                write(&findings, &machine, &arguments)?;
                findings.forget_pictures();
                found.push(findings);
            }
            Err(why) => {
                note(format_args!("lightwalk: {} is left out: {why}", study.name));
                skipped.push((study.name, why.to_string()));
            }
        }
    }
    let text = summary(&found, &skipped, &machine);
    let path = arguments.out.join("summary.md");
    make_folder(&arguments.out)?;
    output::write_whole(&path, |out| out.write_all(text.as_bytes()))
}

/// The four files of one study.
fn write(findings: &Findings, machine: &Machine, arguments: &Arguments) -> Result<(), Failure> {
    let picture = plot(findings, Language::English);
    let pixels = rasterize(&picture, Theme::Light, 1.0)
        .map_err(|error| Failure::Failed(format!("{}: {error}", findings.study.name)))?;
    let scene = arguments
        .scene
        .as_ref()
        .map(|path| path.display().to_string());
    let recorded = json(findings, machine, arguments.quick, scene.as_deref());
    make_folder(&arguments.out)?;
    let put = |ending: &str, bytes: &[u8]| {
        let path = arguments
            .out
            .join(format!("{}.{ending}", findings.study.name));
        output::write_whole(&path, |out| out.write_all(bytes))
    };
    put("csv", csv(findings).as_bytes())?;
    put("json", format!("{recorded:#}\n").as_bytes())?;
    put("png", &to_png(&pixels))?;
    let title = findings.study.title.text(Language::English);
    put("svg", to_svg(&picture, title, Theme::Light).as_bytes())
}

/// Not before there is something to put into it.
fn make_folder(folder: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(folder)
        .map_err(|error| Failure::Wrong(format!("--out {}: {error}", folder.display())))
}
