//! A lesson file checked, run, and tied to the steps of its run.

use super::answer::Answer;
use super::chapter::Chapter;
use super::checks;
use super::error::{LessonError, problem};
use super::file::{LessonFile, StepFile};
use super::narrate::narrate;
use super::narrated::Narrated;
use super::parameters::{ByPath, Parameter, ParameterFile, Source, parameters};
use super::settings::{compare, hierarchy, mapping, radiosity, rays};
use super::text::Text;
use super::translations;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::methods::{Method, Settings, Setup};
use crate::panels::Panel;
use crate::record::RecordingLimit;
use crate::replay::Run;
use crate::scene::document::{self, ByName, Keyed, Problem};
use crate::scene::{self, Limits, Note, Scene, View};
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
    /// The text of the scene of a walk as an address has it; none where it names other files or is long.
    pub packed: Option<Arc<str>>,
    /// What it was read from, to say where a mistake is.
    pub(super) text: Option<Arc<[u8]>>,
    pub panels: Vec<Panel>,
    /// What was learned, where the file says it.
    pub recap: Option<Text>,
    pub(super) steps: Vec<StepFile>,
    /// Texts that are not in both languages.
    pub missing: Vec<Note>,
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
            scene.names = checks::names(names, scene, &mut problems);
        }

        let method = checks::method(&file, &mut problems);
        let panels = checks::panels(&file, &mut problems);
        checks::mistakes(&file, method, &mut problems);
        let chapter = checks::chapter(&file, &mut problems);
        checks::texts(&file, &mut problems);
        let missing = translations::check(&file, &mut problems);
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
        let focus = checks::focus(&file, method, &mut problems);
        let settings = Settings::from(rays(&file, &mut problems))
            .with(radiosity(&file, &mut problems))
            .with(hierarchy(&file, &mut problems))
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
                packed: None,
                text: Some(bytes.into()),
                panels,
                recap: file.recap,
                steps: file.steps.into_iter().map(|Keyed(step)| step).collect(),
                missing,
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
        let narrated = self.narrate_unlocated(&run)?;
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

    /// What is said in the lesson's own run. Errors: every anchor, value and answer that is not in it.
    pub fn narrate(&self, run: &Run) -> Result<Vec<Narrated>, LessonError> {
        let text = self.text.as_deref().unwrap_or_default();
        self.narrate_unlocated(run)
            .map_err(|error| error.located(text))
    }

    fn narrate_unlocated(&self, run: &Run) -> Result<Vec<Narrated>, LessonError> {
        let narrated = narrate(&self.steps, run, false)?;
        check_panels(&narrated, &self.panels)?;
        Ok(narrated)
    }

    /// What is said in a run of the lesson's own part, whose scene may be changed: questions that have no answer then are
    /// undecided. Errors: every anchor and value that is not in the run.
    pub fn narrate_changed(&self, run: &Run) -> Result<Vec<Narrated>, LessonError> {
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
