//! The lesson file as it is written: what is shown, and what is said and asked at which steps.

use super::chapter::Chapter;
use super::parameters::ParameterFile;
use super::text::Text;
use crate::algorithms::form_factor;
use crate::algorithms::radiosity::Solver;
use crate::algorithms::texture::Mapping;
use crate::methods::{Method, Mistake};
use crate::panels::{Hidden, Panel};
use crate::replay::Query;
use crate::scene::document::{ByName, Keyed, Schema, present};
use crate::scene::{SceneFile, schema_of};
use schemars::JsonSchema;
use serde::Deserialize;

/// A lesson: a scene, a method, a part of what it does, and what is said and asked on the way.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Lightwalk lesson")]
pub struct LessonFile {
    /// Where the JSON Schema of this file is, for editors.
    #[serde(default, rename = "$schema", deserialize_with = "present")]
    pub described_at: Option<String>,
    /// The version of the format.
    #[serde(default, deserialize_with = "present")]
    pub schema: Option<Schema>,
    /// Unique among lessons; part of links and command lines: lower-case words joined by `-`.
    pub id: String,
    /// Place in the list of lessons.
    pub number: u32,
    /// The name of the chapter in the list of lessons.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Chapter>")]
    pub chapter: Option<String>,
    pub title: Text,
    /// One sentence for the list of lessons.
    pub summary: Text,
    pub topics: Vec<String>,
    /// A scene in the lesson file itself; either this or `scene_file`.
    #[serde(default, deserialize_with = "present")]
    pub scene: Option<Keyed<SceneFile>>,
    /// Path of a scene file, relative to the lesson file.
    #[serde(default, deserialize_with = "present")]
    pub scene_file: Option<String>,
    /// What the objects and materials of the scene are called, by their names; one that is not given is called by its name.
    #[serde(default, deserialize_with = "present")]
    pub names: Option<ByName<Keyed<Text>>>,
    #[schemars(with = "Method")]
    pub method: String,
    /// Pixels, width and height.
    pub size: [u32; 2],
    /// Of ray tracing: the last level that is shaded, 5 unless given.
    #[serde(default, deserialize_with = "present")]
    pub depth: Option<u32>,
    /// Of the ray methods: n of n×n rays a pixel, 1 unless given.
    #[serde(default, deserialize_with = "present")]
    pub samples: Option<u32>,
    /// Of radiosity: how the light of the room is found.
    #[serde(default, deserialize_with = "present")]
    pub radiosity: Option<Keyed<RadiosityFile>>,
    /// Of hierarchical radiosity: when links are refined.
    #[serde(default, deserialize_with = "present")]
    pub hierarchy: Option<Keyed<HierarchyFile>>,
    /// Two to six methods whose pictures are compared, the last one the reference.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Vec<Method>>")]
    pub compare: Option<Vec<String>>,
    /// Of textured polygons: `perspective` unless given, or `linear`, which is wrong.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Mapping>")]
    pub texture_mapping: Option<String>,
    pub focus: FocusFile,
    /// What may be changed.
    #[serde(default, deserialize_with = "present")]
    pub parameters: Option<Vec<ParameterFile>>,
    #[schemars(with = "Vec<Panel>")]
    pub panels: Vec<String>,
    /// What was learned, for the end of the lesson: about three sentences.
    #[serde(default, deserialize_with = "present")]
    pub recap: Option<Text>,
    pub steps: Vec<Keyed<StepFile>>,
}

/// How the light of a room is found. What is not given is as on the command line.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RadiosityFile {
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Solver>")]
    pub solver: Option<String>,
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<form_factor::Method>")]
    pub form_factors: Option<String>,
    /// A second method, by which a form factor that is followed is found once more.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<form_factor::Method>")]
    pub then_by: Option<String>,
    #[serde(default, deserialize_with = "present")]
    pub visibility: Option<bool>,
    #[serde(default, deserialize_with = "present")]
    pub tolerance: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    pub max_iterations: Option<u32>,
    #[serde(default, deserialize_with = "present")]
    pub smooth: Option<bool>,
}

/// When links are refined. What is not given is as on the command line.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HierarchyFile {
    /// F_ε: how large an element may be, seen from the other, to be linked in the first pass.
    #[serde(default, deserialize_with = "present")]
    pub link_size: Option<f64>,
    /// How much light a link may carry in the last pass, as a share of all that is emitted.
    #[serde(default, deserialize_with = "present")]
    pub link_light: Option<f64>,
    /// A_ε: what is no larger is not divided.
    #[serde(default, deserialize_with = "present")]
    pub smallest_area: Option<f64>,
    /// How many passes come after the first one.
    #[serde(default, deserialize_with = "present")]
    pub passes: Option<u32>,
}

/// Which part of the frame, or of the exchange of light, is recorded.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum FocusFile {
    Frame,
    Polygon(usize),
    ScanLine(u32),
    Pixel([u32; 2]),
    /// From, and up to but without.
    Iterations([u32; 2]),
    Patch(u32),
    /// From patch i to patch j.
    FormFactor([u32; 2]),
}

/// A step at which something is said.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StepFile {
    /// The first such event after the narrated step before.
    pub at: Query,
    /// A few words for the outline.
    #[serde(default, deserialize_with = "present")]
    pub title: Option<Text>,
    /// The panel to look at, one of the lesson's; the first unless given.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Panel>")]
    pub key: Option<String>,
    pub say: Text,
    /// What the lecture's slide prints, where it differs from the standard form.
    #[serde(default, deserialize_with = "present")]
    pub slide: Option<Text>,
    #[serde(default, deserialize_with = "present")]
    pub question: Option<Keyed<QuestionFile>>,
    /// A classic mistake at this step, whose picture can be seen beside the right one.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Mistake>")]
    pub mistake: Option<String>,
    /// Said where the step does not happen after a parameter was changed: what happens instead.
    #[serde(default, deserialize_with = "present")]
    pub otherwise: Option<Text>,
}

/// Predict before seeing.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct QuestionFile {
    pub ask: Text,
    /// The first such event behind the narrated step: the answer is read there.
    pub at: Query,
    pub answer: AnswerFile,
    /// What is hidden until it is answered, beside all that is ahead of the step.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Vec<Hidden>>")]
    pub hide: Option<Vec<String>>,
    /// Said after a first wrong answer, behind on which side of the right one it lies, or that it is another option.
    #[serde(default, deserialize_with = "present")]
    pub hint: Option<Text>,
    /// Said once it is answered.
    pub why: Text,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum AnswerFile {
    /// The value of a field, give or take `tolerance`.
    Number { field: String, tolerance: f64 },
    /// The one option whose condition holds at the step of the answer.
    Choice(Vec<OptionFile>),
    /// The pixel whose column and row the step records as `x` and `y`, give or take `tolerance` pixels.
    Pixel { tolerance: u32 },
    /// The object, or in a room the patch, whose number the step itself records under that name.
    Pick { field: String },
    /// Three to five items, in any order: the right one is that of their first steps behind the question.
    Order(Vec<ItemFile>),
    /// The direction that the step itself records under that name, shown by an arrow, give or take `tolerance` degrees.
    Arrow { field: String, tolerance: f64 },
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ItemFile {
    pub text: Text,
    pub at: Query,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OptionFile {
    pub text: Text,
    pub when: Query,
}

/// The JSON Schema of lesson files.
pub fn lesson_schema() -> serde_json::Value {
    schema_of::<LessonFile>()
}
