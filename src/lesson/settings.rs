//! How far ray methods go in a lesson, where textures are looked up, how the light of its room is found, and which methods are
//! compared.

use super::error::problem;
use super::file::LessonFile;
use crate::algorithms::enclosure;
use crate::algorithms::form_factor::Method;
use crate::algorithms::hierarchical;
use crate::algorithms::primary::Settings;
use crate::algorithms::radiosity::Solver;
use crate::algorithms::texture::Mapping;
use crate::render::Method as Picture;
use crate::scene::document::{Keyed, Problem};
use std::num::NonZeroU32;

/// How far the ray methods are to go.
pub fn rays(file: &LessonFile, problems: &mut Vec<Problem>) -> Settings {
    let mut within = |place: &str, asked: Option<u32>, most: u32, unless: NonZeroU32| {
        let Some(asked) = asked else { return unless };
        NonZeroU32::new(asked)
            .filter(|asked| asked.get() <= most)
            .unwrap_or_else(|| {
                let message = format!("found {asked}; allowed are whole numbers from 1 to {most}");
                problems.push(problem(place, message));
                unless
            })
    };
    let unless = Settings::default();
    Settings {
        depth: within("depth", file.depth, Settings::DEEPEST, unless.depth),
        samples: within(
            "samples",
            file.samples,
            Settings::MOST_SAMPLES,
            unless.samples,
        ),
    }
}

/// How many methods are compared at a time.
const COMPARED: std::ops::RangeInclusive<usize> = 2..=6;

/// The methods that are compared; none where the lesson compares none.
pub fn compare(file: &LessonFile, problems: &mut Vec<Problem>) -> Vec<Picture> {
    let Some(names) = &file.compare else {
        return Vec::new();
    };
    let mut methods = Vec::new();
    let allowed = || {
        Picture::ALL
            .into_iter()
            .filter(|method| method.draws_pixels())
    };
    for (index, name) in names.iter().enumerate() {
        let place = format!("compare[{index}]");
        match allowed().find(|method| method.name() == name) {
            Some(method) if methods.contains(&method) => {
                let message =
                    format!("found \"{name}\" a second time; each stands for itself once");
                problems.push(problem(place, message));
            }
            Some(method) => methods.push(method),
            None => {
                let known: Vec<_> = allowed().map(Picture::name).collect();
                let message = format!("found \"{name}\"; allowed are {}", known.join(", "));
                problems.push(problem(place, message));
            }
        }
    }
    if !COMPARED.contains(&names.len()) {
        let message = format!("found {} methods; allowed are 2 to 6", names.len());
        problems.push(problem("compare", message));
    }
    methods
}

/// Where the textures of polygons are to be looked up.
pub fn mapping(file: &LessonFile, problems: &mut Vec<Problem>) -> Mapping {
    let Some(name) = &file.texture_mapping else {
        return Mapping::default();
    };
    Mapping::from_name(name).unwrap_or_else(|| {
        let known = Mapping::ALL.map(Mapping::name).join(", ");
        let message = format!("found \"{name}\"; allowed are {known}");
        problems.push(problem("texture_mapping", message));
        Mapping::default()
    })
}

/// How the light of a room is to be found.
pub fn radiosity(file: &LessonFile, problems: &mut Vec<Problem>) -> enclosure::Settings {
    let mut settings = enclosure::Settings::default();
    let Some(Keyed(file)) = &file.radiosity else {
        return settings;
    };
    let mut refuse = |key: &str, message| {
        problems.push(problem(format!("radiosity.{key}"), message));
    };
    if let Some(name) = &file.solver {
        match Solver::from_name(name) {
            Some(solver) => settings.solver = solver,
            None => {
                let known = Solver::ALL.map(Solver::name).join(", ");
                refuse("solver", format!("found \"{name}\"; allowed are {known}"));
            }
        }
    }
    let mut method = |key: &str, name: &Option<String>| {
        let name = name.as_ref()?;
        let method = Method::from_name(name);
        if method.is_none() {
            let known = Method::ALL.map(Method::name).join(", ");
            refuse(key, format!("found \"{name}\"; allowed are {known}"));
        }
        method
    };
    let asked = method("form_factors", &file.form_factors);
    settings.form_factors = asked.unwrap_or(settings.form_factors);
    settings.then_by = method("then_by", &file.then_by);
    settings.visibility = file.visibility.unwrap_or(settings.visibility);
    settings.smooth = file.smooth.unwrap_or(settings.smooth);
    if let Some(tolerance) = file.tolerance {
        settings.stop.tolerance = tolerance;
        if !(tolerance > 0.0 && tolerance < 1.0) {
            let message = format!("found {tolerance}; allowed are numbers above 0 and below 1");
            refuse("tolerance", message);
        }
    }
    if let Some(most) = file.max_iterations {
        settings.stop.max_iterations = most;
        if most == 0 {
            refuse(
                "max_iterations",
                "found 0; allowed are whole numbers of 1 or more".into(),
            );
        }
    }
    settings
}

/// When the links of hierarchical radiosity are to be refined.
pub fn hierarchy(file: &LessonFile, problems: &mut Vec<Problem>) -> hierarchical::Settings {
    let unless = hierarchical::Settings::default();
    let Some(Keyed(file)) = &file.hierarchy else {
        return unless;
    };
    let settings = hierarchical::Settings {
        link_size: file.link_size.unwrap_or(unless.link_size),
        link_light: file.link_light.unwrap_or(unless.link_light),
        smallest_area: file.smallest_area.unwrap_or(unless.smallest_area),
        passes: file.passes.unwrap_or(unless.passes),
    };
    if let Err(hierarchical::NotAllowed {
        what,
        found,
        allowed,
    }) = settings.check()
    {
        let message = format!("found {found}; allowed are {allowed}");
        problems.push(problem(format!("hierarchy.{what}"), message));
    }
    settings
}
