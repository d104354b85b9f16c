//! Lessons that are made in the program: a picture that can be walked through, with a few words at its first step.

use super::file::{StepFile, Text};
use super::resolve::Lesson;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::Settings;
use crate::panels::Panel;
use crate::render::Method;
use crate::replay::Query;

impl Lesson {
    /// The number of a lesson that stands in no list.
    pub const UNNUMBERED: u32 = 0;

    /// A lesson about the middle of a picture of the stage. `title` is the same in both languages, `say` is by language; in
    /// neither may there be braces. `method` draws pictures of its own: it is not radiosity.
    pub fn of_picture(
        title: String,
        say: [String; 2],
        prepared: &PreparedScene,
        method: Method,
        settings: Settings,
    ) -> Lesson {
        let size = [prepared.view.width, prepared.view.height];
        let [x, y] = size.map(|side| side / 2);
        let (focus, panels) = match method.follows_rays() {
            true => (
                Focus::Pixel { x, y },
                vec![Panel::Image, Panel::RayTree, Panel::Rays],
            ),
            false => (
                Focus::ScanLine(y),
                vec![Panel::Image, Panel::ScanLine, Panel::Inspector],
            ),
        };
        let [en, id] = say;
        let say = Text { en, id };
        Lesson {
            id: "picture".into(),
            number: Lesson::UNNUMBERED,
            title: Text {
                en: title.clone(),
                id: title,
            },
            summary: say.clone(),
            topics: Vec::new(),
            scene: prepared.scene.clone(),
            method,
            size,
            settings,
            radiosity: prepared.radiosity,
            compare: Vec::new(),
            mapping: prepared.mapping,
            focus,
            parameters: Vec::new(),
            panels,
            steps: vec![StepFile {
                at: Query::default(),
                say,
                slide: None,
                question: None,
            }],
        }
    }
}
