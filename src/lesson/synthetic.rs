//! Lessons that are made in the program: a picture that can be walked through, with a few words at its first step.

use super::file::{StepFile, Text};
use super::resolve::Lesson;
use crate::methods::{Method, Setup};
use crate::panels::Panel;
use crate::replay::Query;

impl Lesson {
    /// The number of a lesson that stands in no list.
    pub const UNNUMBERED: u32 = 0;

    /// A lesson about the middle of a picture. `title` and `say` are by language; in neither may there be braces.
    pub fn of_picture(
        title: [String; 2],
        say: [String; 2],
        setup: &Setup,
        method: Method,
    ) -> Lesson {
        let prepared = &setup.prepared;
        let size = [prepared.view.width, prepared.view.height];
        let panels = method.panels().into_iter();
        let [title, say] = [title, say].map(|[en, id]| Text { en, id });
        Lesson {
            id: "picture".into(),
            number: Lesson::UNNUMBERED,
            chapter: None,
            title,
            summary: say.clone(),
            topics: Vec::new(),
            scene: prepared.scene.clone(),
            method,
            size,
            settings: setup.settings.clone(),
            compare: Vec::new(),
            focus: method.family().focus(size),
            parameters: Vec::new(),
            by_path: Vec::new(),
            source: None,
            recap: None,
            panels: panels.filter_map(Panel::called).collect(),
            steps: vec![StepFile {
                at: Query::default(),
                title: None,
                key: None,
                say,
                slide: None,
                question: None,
                otherwise: None,
            }],
        }
    }
}
