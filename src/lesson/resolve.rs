//! A lesson file checked, run, and tied to the steps of its run.

use super::answer::Answer;
use super::contents::{Chapter, chapter};
use super::error::{LessonError, problem};
use super::file::{FocusFile, LessonFile, StepFile, Text};
use super::narrate::narrate;
use super::narrated::Narrated;
use super::parameters::{ByPath, Parameter, ParameterFile, Source, parameters};
use super::settings::{compare, mapping, radiosity, rays};
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::methods::{Method, Settings, Setup};
use crate::panels::{Hidden, Panel};
use crate::record::RecordingLimit;
use crate::render::{MAX_PIXELS, MAX_SIDE};
use crate::replay::Run;
use crate::scene::document::{self, ByName, Keyed, Problem};
use crate::scene::{self, Limits, Names, Scene, View};
use std::collections::BTreeSet;
use std::iter;
use std::sync::Arc;

/// A lesson whose file is right by itself; it has not been run.
#[derive(Clone, Debug)]
pub struct Lesson {
    pub id: String,
    pub number: u32,
    pub chapter: Option<Chapter>,
    pub title: Text,
    pub summary: Text,
    pub topics: Vec<String>,
    pub scene: Scene,
    pub method: Method,
    /// Pixels, width and height.
    pub size: [u32; 2],
    pub settings: Settings,
    /// Methods whose pictures are compared, the last one the reference.
    pub compare: Vec<Method>,
    pub focus: Focus,
    /// What may be changed while one looks.
    pub parameters: Vec<Parameter>,
    /// Those at paths of the document.
    pub by_path: Vec<ByPath>,
    /// The document, where values of it may be changed.
    pub(super) source: Option<Arc<Source>>,
    /// What it was read from, to say where a mistake is.
    pub(super) text: Option<Arc<[u8]>>,
    pub panels: Vec<Panel>,
    /// What was learned, where the file says it.
    pub recap: Option<Text>,
    pub(super) steps: Vec<StepFile>,
}

/// A lesson that was run, with every narrated step found in the run.
pub struct OpenLesson {
    pub lesson: Lesson,
    pub setup: Arc<Setup>,
    pub run: Run,
    /// In the order of their steps.
    pub narrated: Vec<Narrated>,
}

impl Lesson {
    /// Reads a lesson file. `read_file` gets paths relative to the lesson file: of its scene, and of the meshes
    /// relative to the file that names them.
    ///
    /// Errors: as for scenes, syntax, keys and types one by one with line and column, everything else at once.
    pub fn read(
        bytes: &[u8],
        limits: &Limits,
        read_file: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Lesson, LessonError> {
        let file: LessonFile = document::parse(bytes)?;
        Lesson::checked(file, bytes, limits, read_file).map_err(|error| error.located(bytes))
    }

    fn checked(
        file: LessonFile,
        bytes: &[u8],
        limits: &Limits,
        read_file: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Lesson, LessonError> {
        let mut problems = Vec::new();
        let mut files = Vec::new();
        let read_file = &mut |path: &str| {
            let bytes = read_file(path)?;
            files.push((path.to_owned(), bytes.clone()));
            Ok(bytes)
        };
        let mut scene = read_scene(&file, limits, read_file).unwrap_or_else(|error| {
            problems.extend(error.problems);
            None
        });
        if scene.as_ref().is_some_and(|scene| scene.camera.is_none()) {
            problems.push(problem(
                "scene.camera",
                "the key is missing; a lesson makes a picture, so its scene needs a camera",
            ));
        }

        if let (Some(scene), Some(ByName(names))) = (&mut scene, &file.names) {
            scene.names = checked_names(names, scene, &mut problems);
        }

        let method = Method::from_name(&file.method);
        if method.is_none() {
            problems.push(problem(
                "method",
                format!(
                    "found \"{}\"; allowed are {}",
                    file.method,
                    Method::ALL.map(Method::name).join(", ")
                ),
            ));
        }
        let mut panels = Vec::new();
        for (index, name) in file.panels.iter().enumerate() {
            match Panel::called(name) {
                Some(panel) => panels.push(panel),
                None => {
                    let known = Panel::ALL.map(Panel::name).join(", ");
                    problems.push(problem(
                        format!("panels[{index}]"),
                        format!("found \"{name}\"; allowed are {known}"),
                    ));
                }
            }
        }
        let chapter = chapter(&file, &mut problems);
        check_keys(&file, &mut problems);
        check_hidden(&file, &mut problems);
        check_words(&file, &mut problems);
        let has_paths = file
            .parameters
            .iter()
            .flatten()
            .any(ParameterFile::has_path);
        let source = has_paths
            .then(|| Source::new(bytes, files, limits))
            .flatten();
        let (parameters, by_path) = match (&scene, &file.parameters) {
            (Some(scene), Some(files)) => parameters(files, scene, source.as_ref(), &mut problems),
            _ => Default::default(),
        };
        let focus = match file.focus {
            FocusFile::Frame => Focus::Frame,
            FocusFile::Polygon(number) => Focus::Polygon(number),
            FocusFile::ScanLine(y) => Focus::ScanLine(y),
            FocusFile::Pixel([x, y]) => Focus::Pixel { x, y },
            FocusFile::Iterations([start, end]) => Focus::Iterations { start, end },
            FocusFile::Patch(number) => Focus::Patch(number),
            FocusFile::FormFactor([i, j]) => Focus::FormFactor { i, j },
        };
        if let Some(method) = method.filter(|method| !method.records(focus)) {
            let allowed = if method.converts_polygons() {
                "allowed are `frame`, `polygon`, `scan_line` and `pixel`"
            } else if method.follows_rays() {
                "ray methods go pixel by pixel: allowed are `pixel`, `scan_line` and `frame`"
            } else {
                "allowed are `frame`, `iterations`, `patch` and `form_factor`"
            };
            let message = format!(
                "found a focus that {} does not have; {allowed}",
                method.name()
            );
            problems.push(problem("focus", message));
        }
        let settings = Settings::from(rays(&file, &mut problems))
            .with(radiosity(&file, &mut problems))
            .with(mapping(&file, &mut problems));
        let compare = compare(&file, &mut problems);

        match (scene, method) {
            (Some(scene), Some(method)) if problems.is_empty() => Ok(Lesson {
                id: file.id,
                number: file.number,
                chapter,
                title: file.title,
                summary: file.summary,
                topics: file.topics,
                scene,
                method,
                size: file.size,
                settings,
                compare,
                focus,
                parameters,
                by_path,
                source: source.map(Arc::new),
                text: Some(bytes.into()),
                panels,
                recap: file.recap,
                steps: file.steps.into_iter().map(|Keyed(step)| step).collect(),
            }),
            _ => Err(LessonError { problems }),
        }
    }

    /// Runs the lesson and finds its narrated steps. Errors: every anchor, value and answer that is not in the run.
    pub fn open(self) -> Result<OpenLesson, LessonError> {
        let text = self.text.clone();
        self.run()
            .map_err(|error| error.located(text.as_deref().unwrap_or_default()))
    }

    fn run(self) -> Result<OpenLesson, LessonError> {
        let setup = Arc::new(
            self.setup(self.scene.clone(), self.settings.clone())
                .ok_or_else(|| problem("scene.camera", "the key is missing"))?,
        );
        let wrong = |error: &_| problem("scene", format!("{error}"));
        setup.check_for(self.method).map_err(wrong)?;
        let outside = |outside| problem("focus", format!("found {outside}"));
        setup.check(self.focus).map_err(outside)?;
        let run = Run::record(
            setup.clone(),
            self.method,
            self.focus,
            RecordingLimit::default(),
        );
        let narrated = narrate(&self.steps, &run, false)?;
        check_panels(&narrated, &self.panels)?;
        Ok(OpenLesson {
            lesson: self,
            setup,
            run,
            narrated,
        })
    }

    /// The lesson's scene and settings, as they are or changed, in front of the camera. None without a camera.
    pub fn setup(&self, scene: Scene, settings: Settings) -> Option<Setup> {
        let [width, height] = self.size;
        let view = View::new(scene.camera.as_ref()?, width, height);
        let prepared = PreparedScene::new(scene, view);
        Some(Setup::new(prepared, settings))
    }

    /// What is said in a run of the lesson's own part, whose scene may be changed: questions that have no answer then are
    /// undecided. Errors: every anchor and value that is not in the run.
    pub fn narrate(&self, run: &Run) -> Result<Vec<Narrated>, LessonError> {
        narrate(&self.steps, run, true)
    }
}

/// What is clicked or turned to answer is shown.
fn check_panels(narrated: &[Narrated], shown: &[Panel]) -> Result<(), LessonError> {
    let mut problems = Vec::new();
    for (index, said) in narrated.iter().enumerate() {
        let answer = said.question.as_ref().map(|question| &question.answer);
        let fits = answer.map_or(&[][..], Answer::panels);
        if !fits.is_empty() && !fits.iter().any(|panel| shown.contains(panel)) {
            let names: Vec<&str> = fits.iter().map(|panel| panel.name()).collect();
            let message = format!(
                "it is answered in the panel {}, which the lesson does not show",
                names.join(" or ")
            );
            problems.push(problem(format!("steps[{index}].question"), message));
        }
    }
    match problems.is_empty() {
        true => Ok(()),
        false => Err(LessonError { problems }),
    }
}

/// What a question hides is something that can be hidden.
fn check_hidden(file: &LessonFile, problems: &mut Vec<Problem>) {
    for (index, Keyed(step)) in file.steps.iter().enumerate() {
        let Some(Keyed(question)) = &step.question else {
            continue;
        };
        for (number, name) in question.hide.iter().flatten().enumerate() {
            if Hidden::from_name(name).is_none() {
                let place = format!("steps[{index}].question.hide[{number}]");
                let known = Hidden::ALL.map(Hidden::name).join(", ");
                let message = format!("found \"{name}\"; allowed are {known}");
                problems.push(problem(place, message));
            }
        }
    }
}

/// A key panel is one of the lesson's.
fn check_keys(file: &LessonFile, problems: &mut Vec<Problem>) {
    for (index, Keyed(step)) in file.steps.iter().enumerate() {
        let Some(key) = &step.key else { continue };
        if !file.panels.contains(key) {
            problems.push(problem(
                format!("steps[{index}].key"),
                format!(
                    "found \"{key}\"; allowed are the lesson's panels: {}",
                    file.panels.join(", ")
                ),
            ));
        }
    }
}

fn read_scene(
    file: &LessonFile,
    limits: &Limits,
    read_file: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Option<Scene>, LessonError> {
    match (&file.scene, &file.scene_file) {
        (Some(Keyed(scene)), None) => Ok(Some(scene.clone().check(limits, read_file, "scene")?)),
        (None, Some(path)) => {
            scene::mesh_path_is_inside(path).map_err(|message| problem("scene_file", message))?;
            let bytes = read_file(path).map_err(|reason| problem("scene_file", format!("cannot read \"{path}\": {reason}")))?;
            let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
            let mut read_mesh = |mesh: &str| read_file(&if folder.is_empty() { mesh.to_owned() } else { format!("{folder}/{mesh}") });
            let scene = scene::read(&bytes, limits, &mut read_mesh);
            // The places, lines and columns are those of the other file.
            let named = |found: Problem| problem("scene_file", format!("in \"{path}\": {found}"));
            Ok(Some(scene.map_err(|error| LessonError { problems: error.problems.into_iter().map(named).collect() })?))
        }
        _ => Err(problem("", "a lesson has exactly one of the keys `scene` (a scene) and `scene_file` (the path of one)").into()),
    }
}

/// What the objects and materials of the scene are called.
fn checked_names(
    names: &[(String, Keyed<Text>)],
    scene: &Scene,
    problems: &mut Vec<Problem>,
) -> Names {
    let objects = scene.objects.iter().map(|object| object.name.as_str());
    let materials = scene
        .materials
        .iter()
        .map(|material| material.name.as_str());
    let known: BTreeSet<&str> = objects.chain(materials).collect();
    for (name, _) in names.iter().filter(|(name, _)| !known.contains(&**name)) {
        let allowed: Vec<&str> = known.iter().copied().collect();
        let message = format!(
            "there is no object or material of this name; allowed are {}",
            allowed.join(", ")
        );
        problems.push(problem(format!("names.{name}"), message));
    }
    let texts = names.iter().map(|(name, Keyed(text))| {
        refuse_empty(&format!("names.{name}"), text, problems);
        let texts = text.both().map(|(_, text)| text.to_owned());
        (name.clone(), texts)
    });
    texts.collect()
}

fn refuse_empty(place: &str, text: &Text, problems: &mut Vec<Problem>) {
    for (language, text) in text.both() {
        if text.trim().is_empty() {
            let place = format!("{place}.{}", language.code());
            problems.push(problem(place, "found an empty text"));
        }
    }
}

/// What can be wrong with words and numbers before anything is run.
fn check_words(file: &LessonFile, problems: &mut Vec<Problem>) {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    if file.id.is_empty() || !file.id.chars().all(plain) {
        problems.push(problem(
            "id",
            format!(
                "found \"{}\"; allowed are lower-case letters, digits and `-`",
                file.id
            ),
        ));
    }
    let [width, height] = file.size.map(u64::from);
    let sides = 1..=u64::from(MAX_SIDE);
    if !sides.contains(&width) || !sides.contains(&height) || width * height > MAX_PIXELS {
        let message = format!(
            "found {width}×{height}; sides are from 1 to {MAX_SIDE}, with at most {MAX_PIXELS} pixels in all"
        );
        problems.push(problem("size", message));
    }
    if file.panels.is_empty() {
        problems.push(problem(
            "panels",
            "found an empty list; a lesson shows one panel or more",
        ));
    }
    if file.steps.is_empty() {
        problems.push(problem(
            "steps",
            "found an empty list; a lesson says something at one step or more",
        ));
    }
    let texts = [("title", &file.title), ("summary", &file.summary)]
        .map(|(place, text)| (place.to_owned(), text));
    let recap = file.recap.iter().map(|text| ("recap".to_owned(), text));
    let steps = file.steps.iter().enumerate();
    let of_steps = steps.flat_map(|(index, Keyed(step))| {
        let title = step.title.iter();
        let title = title.map(move |text| (format!("steps[{index}].title"), text));
        iter::once((format!("steps[{index}].say"), &step.say)).chain(title)
    });
    for (place, text) in texts.into_iter().chain(recap).chain(of_steps) {
        refuse_empty(&place, text, problems);
    }
}
