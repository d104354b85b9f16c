//! Lessons, scenes and meshes that come from files.

use super::focus::Place;
use super::{Refused, Session, Standing};
use crate::app::strings;
use crate::language::Message;
use crate::lesson::{Lesson, LessonError};
use crate::methods::Method;
use crate::scene::document::Problem;

impl Session {
    /// Shows the same file as it was saved again: at the same place of its run, by the same method, with the same panel large.
    ///
    /// Errors: those of the lesson; nothing has changed then.
    pub fn replace_document(&mut self, lesson: Lesson) -> Result<(), Vec<Problem>> {
        let shown = match self.runs_as(&lesson) {
            true => self.replace_texts(lesson),
            false => self.rerun(lesson),
        };
        shown.map_err(|error| error.problems)
    }

    /// Whether the run that is shown is that of `lesson` too.
    fn runs_as(&self, lesson: &Lesson) -> bool {
        let own = self.lesson();
        let part = |lesson: &Lesson| (lesson.method, lesson.size, lesson.focus);
        let is_as_opened = !self.is_changed() && self.setup().forced().is_empty();
        is_as_opened
            && self.follows_lesson()
            && part(own) == part(lesson)
            && (&own.scene, &own.settings) == (&lesson.scene, &lesson.settings)
            && own.compare == lesson.compare
    }

    /// The same run with other words. How questions were answered stays where there are as many explanations.
    fn replace_texts(&mut self, lesson: Lesson) -> Result<(), LessonError> {
        let narrated = lesson.narrate(&self.open.run)?;
        self.narrated = narrated.iter().map(|said| said.step).collect();
        if narrated.len() != self.standings.len() {
            self.standings = vec![Standing::Open; narrated.len()];
            self.guesses.clear();
        }
        self.open.narrated = narrated;
        self.open.lesson = lesson;
        Ok(())
    }

    fn rerun(&mut self, lesson: Lesson) -> Result<(), LessonError> {
        let lesson = match self.lesson().is_free_walk() {
            true => lesson
                .by_method(self.lesson().method)
                .of_size(self.lesson().size),
            false => lesson,
        };
        let (here, chosen, focus) = (self.step(), self.chosen, self.focus);
        let place = Place::of(self.walk(), here);
        self.replace_compared(lesson)?;
        // What was looked at may not be there any more: then the file's own part is.
        if self.focus_on(focus).is_ok()
            && let Some(step) = place.nearest(self.walk(), here)
        {
            self.start_at(step);
        }
        self.chosen = chosen;
        Ok(())
    }

    /// Why what is shown cannot be edited as a scene, if it cannot.
    pub(super) fn cannot_edit(&self) -> Option<Message> {
        let file = self.file.as_ref().filter(|_| self.lesson().is_free_walk());
        let is_scene = file.is_some_and(|file| file.extension().is_some_and(|end| end == "json"));
        (!is_scene).then_some(strings::EDIT_A_SCENE)
    }

    /// Whether the file that is shown is being edited.
    pub fn is_edited(&self) -> bool {
        self.look.editing || self.is_written()
    }

    /// Why the method cannot be chosen, if it cannot.
    pub(super) fn cannot_choose(&self, method: Method) -> Option<Message> {
        let lesson = self.lesson();
        if !lesson.is_free_walk() {
            return Some(strings::METHOD_OF_THE_LESSON);
        }
        (lesson.method == method).then_some(strings::METHOD_AS_IT_IS)
    }

    pub(super) fn choose_method(&mut self, method: Method) -> Result<(), Refused> {
        if let Some(why) = self.cannot_choose(method) {
            return Err(why.into());
        }
        let lesson = self.lesson().by_method(method);
        self.replace_compared(lesson)
            .map_err(|error| Refused::Error(error.to_string()))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Command;
    use super::*;
    use crate::algorithms::focus::Focus;
    use crate::algorithms::prepared_scene::PreparedScene;
    use crate::scene::{Limits, View, read};

    fn walk(radius: f64) -> Lesson {
        let text = format!(
            r#"{{ "schema": 1,
            "camera": {{ "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 }},
            "materials": {{ "mirror": {{ "reflection": 0.5 }} }},
            "objects": [{{ "name": "ball", "material": "mirror", "sphere": {{ "center": [0, 0, 0], "radius": {radius} }} }}],
            "lights": [{{ "point": {{ "position": [0, 9, 9] }} }}] }}"#
        );
        let scene = read(text.as_bytes(), &Limits::default(), &mut |_| unreachable!()).unwrap();
        let [width, height] = Lesson::SIZE_OF_A_WALK;
        let view = View::new(&scene.camera.unwrap(), width, height);
        Lesson::of_scene("own", PreparedScene::new(scene, view))
    }

    #[test]
    fn a_scene_is_walked_by_any_method_and_a_lesson_by_its_own() {
        let mut session = Session::new(walk(1.0)).unwrap();
        assert!(matches!(session.focus(), Focus::Pixel { .. }));
        for method in Method::ALL {
            if session.lesson().method != method {
                session.update(Command::Method(method)).unwrap();
            }
            assert_eq!(session.lesson().method, method);
            assert!(!session.walk().is_empty(), "{}", method.name());
            assert!(session.key_panel().is_some());
        }
        let lesson = crate::lesson::builtins()[3].read().unwrap();
        session.open_document(lesson, None).unwrap();
        let refused = session.update(Command::Method(Method::Phong));
        assert_eq!(refused, Err(strings::METHOD_OF_THE_LESSON.into()));
    }

    #[test]
    fn a_scene_that_is_saved_anew_is_shown_at_the_same_place() {
        let mut session = Session::new(walk(1.0)).unwrap();
        let focus = Focus::Pixel { x: 200, y: 170 };
        session.update(Command::Focus(focus)).unwrap();
        let met = |session: &Session| {
            let walk = session.walk();
            (0..walk.len()).find(|&step| walk.kind(step) == "Local")
        };
        session
            .update(Command::Seek(met(&session).unwrap()))
            .unwrap();
        session.replace_document(walk(1.2)).unwrap();
        assert_eq!(session.focus(), focus);
        assert_eq!(session.walk().kind(session.step()), "Local");
        let radius = match session.prepared().scene.objects[0].shape {
            crate::scene::Shape::Sphere { radius, .. } => radius,
            _ => panic!("a sphere"),
        };
        assert_eq!(radius, 1.2);
    }
}
