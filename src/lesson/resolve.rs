//! A lesson file checked, run, and tied to the steps of its run.

use super::file::{AnswerFile, FocusFile, LessonFile, QuestionFile, StepFile, Text};
use super::template::fill;
use crate::algorithms::focus::Focus;
use crate::algorithms::stage::Stage;
use crate::panels::Panel;
use crate::panels::words::Language;
use crate::record::{RecordingLimit, Value};
use crate::render::{MAX_PIXELS, MAX_SIDE, Method};
use crate::replay::{Query, Run, Walk, query};
use crate::scene::document::{self, Keyed, Problem};
use crate::scene::{self, Limits, Scene, SceneError, View};
use std::sync::Arc;

/// What is wrong with a lesson. Displayed as one problem a line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", document::one_a_line(.problems))]
pub struct LessonError {
    /// One or more.
    pub problems: Vec<Problem>,
}

impl From<Problem> for LessonError {
    fn from(problem: Problem) -> Self {
        LessonError {
            problems: vec![problem],
        }
    }
}

impl From<SceneError> for LessonError {
    fn from(SceneError { problems }: SceneError) -> Self {
        LessonError { problems }
    }
}

/// A lesson whose file is right by itself; it has not been run.
#[derive(Clone, Debug)]
pub struct Lesson {
    pub id: String,
    pub number: u32,
    pub title: Text,
    pub summary: Text,
    pub topics: Vec<String>,
    pub scene: Scene,
    pub method: Method,
    /// Pixels, width and height.
    pub size: [u32; 2],
    pub focus: Focus,
    pub panels: Vec<Panel>,
    steps: Vec<StepFile>,
}

/// A lesson that was run, with every narrated step found in the run.
pub struct OpenLesson {
    pub lesson: Lesson,
    pub stage: Arc<Stage>,
    pub run: Run,
    /// In the order of their steps.
    pub narrated: Vec<Narrated>,
}

/// What is said at a step.
#[derive(Clone, Debug)]
pub struct Narrated {
    pub step: usize,
    /// By language, with the values of the run filled in.
    say: [String; 2],
    slide: Option<[String; 2]>,
    pub question: Option<Question>,
}

/// A question whose answer was read from the run.
#[derive(Clone, Debug)]
pub struct Question {
    ask: [String; 2],
    why: [String; 2],
    /// The step that shows the answer.
    pub step: usize,
    pub answer: Answer,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    Number {
        value: f64,
        tolerance: f64,
    },
    /// Options by language, and the index of the right one.
    Choice {
        options: Vec<[String; 2]>,
        right: usize,
    },
    Pixel {
        x: u32,
        y: u32,
        tolerance: u32,
    },
}

impl Narrated {
    pub fn say(&self, language: Language) -> &str {
        &self.say[language as usize]
    }

    /// The note on what the lecture's slide prints instead.
    pub fn slide(&self, language: Language) -> Option<&str> {
        self.slide.as_ref().map(|slide| &*slide[language as usize])
    }
}

impl Question {
    pub fn ask(&self, language: Language) -> &str {
        &self.ask[language as usize]
    }

    pub fn why(&self, language: Language) -> &str {
        &self.why[language as usize]
    }
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
        let mut problems = Vec::new();
        let scene = read_scene(&file, limits, read_file).unwrap_or_else(|error| {
            problems.extend(error.problems);
            None
        });
        if scene.as_ref().is_some_and(|scene| scene.camera.is_none()) {
            problems.push(problem(
                "scene.camera",
                "the key is missing; a lesson makes a picture, so its scene needs a camera",
            ));
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
            match Panel::from_name(name) {
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
        check_words(&file, &mut problems);
        let focus = match file.focus {
            FocusFile::Frame => Focus::Frame,
            FocusFile::Polygon(number) => Focus::Polygon(number),
            FocusFile::ScanLine(y) => Focus::ScanLine(y),
            FocusFile::Pixel([x, y]) => Focus::Pixel { x, y },
        };
        let [width, height] = file.size;
        let outside = match focus {
            Focus::ScanLine(y) => y >= height,
            Focus::Pixel { x, y } => x >= width || y >= height,
            Focus::Frame | Focus::Polygon(_) => false,
        };
        if outside {
            problems.push(problem("focus", format!("found {focus:?}; the picture has {width} columns and {height} rows, counted from 0")));
        }

        match (scene, method) {
            (Some(scene), Some(method)) if problems.is_empty() => Ok(Lesson {
                id: file.id,
                number: file.number,
                title: file.title,
                summary: file.summary,
                topics: file.topics,
                scene,
                method,
                size: file.size,
                focus,
                panels,
                steps: file.steps.into_iter().map(|Keyed(step)| step).collect(),
            }),
            _ => Err(LessonError { problems }),
        }
    }

    /// Runs the lesson and finds its narrated steps. Errors: every anchor, value and answer that is not in the run.
    pub fn open(self) -> Result<OpenLesson, LessonError> {
        let camera = self
            .scene
            .camera
            .ok_or_else(|| problem("scene.camera", "the key is missing"))?;
        let [width, height] = self.size;
        let stage = Arc::new(Stage::new(
            self.scene.clone(),
            View::new(&camera, width, height),
        ));
        if let Focus::Polygon(number) = self.focus
            && stage.polygon(number).is_none()
        {
            let count = stage.tessellation.polygon_count();
            let message =
                format!("found polygon {number}; the scene has {count} polygons, counted from 0");
            return Err(problem("focus.polygon", message).into());
        }
        let run = Run::record(
            stage.clone(),
            self.method,
            self.focus,
            RecordingLimit::default(),
        );
        let narrated = narrate(&self.steps, run.walk())?;
        Ok(OpenLesson {
            lesson: self,
            stage,
            run,
            narrated,
        })
    }
}

fn problem(place: impl Into<String>, message: impl Into<String>) -> Problem {
    Problem {
        place: place.into(),
        line: None,
        column: None,
        message: message.into(),
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
    let says = file
        .steps
        .iter()
        .enumerate()
        .map(|(index, Keyed(step))| (format!("steps[{index}].say"), &step.say));
    for (place, text) in texts.into_iter().chain(says) {
        for (language, text) in text.both() {
            if text.trim().is_empty() {
                problems.push(problem(
                    format!("{place}.{language}"),
                    "found an empty text",
                ));
            }
        }
    }
}

/// Finds every narrated step, in order, and fills in its texts.
fn narrate(steps: &[StepFile], walk: &dyn Walk) -> Result<Vec<Narrated>, LessonError> {
    let mut search = Search {
        walk,
        problems: Vec::new(),
    };
    let mut narrated = Vec::new();
    let mut from = 0;
    for (index, step) in steps.iter().enumerate() {
        let place = format!("steps[{index}]");
        let Some(at) = search.find(&step.at, from, &place) else {
            continue;
        };
        from = at + 1;
        let say = search.fill(&step.say, at, &format!("{place}.say"));
        let slide = step
            .slide
            .as_ref()
            .map(|slide| search.fill(slide, at, &format!("{place}.slide")));
        let question = step.question.as_ref().and_then(|Keyed(question)| {
            search.question(question, at, &format!("{place}.question"))
        });
        narrated.push(Narrated {
            step: at,
            say,
            slide,
            question,
        });
    }
    if search.problems.is_empty() {
        Ok(narrated)
    } else {
        Err(LessonError {
            problems: search.problems,
        })
    }
}

/// Looks things up in a run, and keeps what it does not find.
struct Search<'a> {
    walk: &'a dyn Walk,
    problems: Vec<Problem>,
}

impl Search<'_> {
    /// The first step at or behind `from` that the selector means.
    fn find(&mut self, selector: &Query, from: usize, place: &str) -> Option<usize> {
        let found = query::matches(self.walk, selector, from..self.walk.len()).next();
        if found.is_none() {
            let kinds: Vec<&str> = query::kinds(self.walk)
                .into_iter()
                .map(|(kind, _)| kind)
                .collect();
            let message = format!(
                "no step from {from} on is like this; the run has steps of the kinds {}",
                kinds.join(", ")
            );
            self.problems.push(problem(format!("{place}.at"), message));
        }
        found
    }

    /// A text in both languages, with the values of `step`.
    fn fill(&mut self, text: &Text, step: usize, place: &str) -> [String; 2] {
        let fields = self.walk.fields(step);
        text.both().map(|(language, text)| {
            fill(text, &fields).unwrap_or_else(|message| {
                self.problems
                    .push(problem(format!("{place}.{language}"), message));
                String::new()
            })
        })
    }

    fn question(
        &mut self,
        question: &QuestionFile,
        asked_at: usize,
        place: &str,
    ) -> Option<Question> {
        let step = self.find(&question.at, asked_at + 1, place)?;
        let ask = self.fill(&question.ask, asked_at, &format!("{place}.ask"));
        let why = self.fill(&question.why, step, &format!("{place}.why"));
        match read_answer(question, self.walk, step) {
            Ok(answer) => Some(Question {
                ask,
                why,
                step,
                answer,
            }),
            Err(message) => {
                self.problems
                    .push(problem(format!("{place}.answer"), message));
                None
            }
        }
    }
}

fn read_answer(question: &QuestionFile, walk: &dyn Walk, step: usize) -> Result<Answer, String> {
    let fields = walk.fields(step);
    match &question.answer {
        AnswerFile::Number { field, tolerance } => {
            if !(tolerance.is_finite() && *tolerance >= 0.0) {
                return Err(format!(
                    "found the tolerance {tolerance}; allowed are numbers from 0"
                ));
            }
            let value = query::number_of(&fields, field).ok_or_else(|| {
                format!(
                    "`{field}` is no number told at the step of the answer, which is {}",
                    walk.kind(step)
                )
            })?;
            Ok(Answer::Number {
                value,
                tolerance: *tolerance,
            })
        }
        AnswerFile::Choice(options) => {
            let holding: Vec<usize> = (0..options.len())
                .filter(|&index| {
                    query::matches(walk, &options[index].when, step..step + 1)
                        .next()
                        .is_some()
                })
                .collect();
            let [right] = holding[..] else {
                return Err(format!(
                    "{} of the {} options hold at the step of the answer; exactly one must",
                    holding.len(),
                    options.len()
                ));
            };
            let options = options
                .iter()
                .map(|option| option.text.both().map(|(_, text)| text.to_owned()))
                .collect();
            Ok(Answer::Choice { options, right })
        }
        AnswerFile::Pixel { tolerance } => match (fields.get("x"), fields.get("y")) {
            (Some(Value::Integer(x)), Some(Value::Integer(y))) => {
                let whole =
                    |v: i64| u32::try_from(v).map_err(|_| format!("{v} is no place in a picture"));
                Ok(Answer::Pixel {
                    x: whole(x)?,
                    y: whole(y)?,
                    tolerance: *tolerance,
                })
            }
            _ => Err(format!(
                "the step of the answer, {}, does not tell a pixel's x and y",
                walk.kind(step)
            )),
        },
    }
}
