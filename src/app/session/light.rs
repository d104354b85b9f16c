//! Lights that are moved while one looks: the part that is looked at is recorded again, and the whole picture begun anew.

use super::{Refused, Session};
use crate::app::words;
use crate::panels::words::Words;
use crate::scene::{LARGEST, Light};
use glam::DVec3;
use std::sync::Arc;

impl Session {
    /// Whether a light stands elsewhere than the lesson has it.
    pub fn light_is_moved(&self) -> bool {
        self.open.stage.scene.lights != self.open.lesson.scene.lights
    }

    /// Whether the lesson falls silent because of that: something that it speaks of does not happen any more.
    pub fn is_unsaid(&self) -> bool {
        self.follows_lesson() && self.narrated.is_empty()
    }

    /// Why a light cannot be moved, if it cannot.
    pub(super) fn cannot_move(&self, light: usize) -> Option<Words> {
        let movable = self.open.lesson.movable_lights.contains(&light);
        (!movable).then_some(words::LIGHT_STAYS)
    }

    pub(super) fn move_light(&mut self, light: usize, position: DVec3) -> Result<(), Refused> {
        if let Some(words) = self.cannot_move(light) {
            return Err(words.into());
        }
        // Not a number is not allowed either.
        if !position.to_array().iter().all(|x| x.abs() <= LARGEST) {
            return Err(words::TOO_FAR.into());
        }
        let mut lights = self.open.stage.scene.lights.clone();
        match lights.get_mut(light) {
            Some(Light::Point { position: at, .. }) if *at != position => *at = position,
            _ => return Ok(()),
        }
        self.light_up(lights);
        Ok(())
    }

    pub(super) fn put_lights_back(&mut self) {
        self.light_up(self.open.lesson.scene.lights.clone());
    }

    fn light_up(&mut self, lights: Vec<Light>) {
        let stage = Arc::new((*self.open.stage).clone().with_lights(lights));
        self.preview
            .begin_anew(stage.clone(), super::methods(&self.open));
        self.open.stage = stage;
        self.look_again();
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Command, Session};
    use super::*;
    use crate::algorithms::focus::Focus;
    use crate::lesson::{Answer, Lesson, builtin};
    use crate::panels::words::Language;
    use crate::panels::{Panel, draw};
    use crate::picture::Picture;
    use crate::record::Value;
    use crate::render::render;
    use std::num::NonZeroUsize;

    const THERE: DVec3 = DVec3::new(-1.0, 2.0, 2.5);

    fn lesson() -> Lesson {
        let mut lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
        lesson.movable_lights = vec![0];
        lesson
    }

    fn session() -> Session {
        Session::new(lesson()).unwrap()
    }

    fn put(session: &mut Session, position: DVec3) {
        let light = 0;
        session
            .update(Command::MoveLight { light, position })
            .unwrap();
    }

    fn picture(session: &mut Session) -> Picture {
        session.wait_for_picture();
        draw(Panel::Image, &session.show(), glam::Vec2::new(400.0, 300.0))
    }

    fn intensity(session: &Session) -> Value {
        let fields = session.walk().fields(session.step());
        fields.get("I_v").expect("a vertex that is lit")
    }

    #[test]
    fn a_moved_light_is_seen_in_picture_run_and_narration_at_the_same_step() {
        let mut session = session();
        session.update(Command::Questions).unwrap();
        while session.said_here().is_none() || session.walk().kind(session.step()) != "VertexLit" {
            session.update(Command::NextNarrated).unwrap();
        }
        let (step, recording) = (session.step(), session.recording());
        let said = |session: &Session| {
            session
                .said_here()
                .unwrap()
                .say(Language::English)
                .to_owned()
        };
        let before = (intensity(&session), said(&session), picture(&mut session));
        put(&mut session, THERE);
        assert!(session.light_is_moved() && session.recording() > recording);
        assert_eq!(
            (session.step(), session.walk().kind(step)),
            (step, "VertexLit")
        );
        let after = (intensity(&session), said(&session), picture(&mut session));
        assert!(before.0 != after.0 && before.1 != after.1 && before.2 != after.2);

        let mut lit = lesson();
        let Light::Point { position, .. } = &mut lit.scene.lights[0] else {
            panic!("a point light")
        };
        *position = THERE;
        let open = lit.open().unwrap();
        assert_eq!(session.open.stage.settings, open.stage.settings);
        let rendered = render(
            &open.stage,
            open.lesson.method,
            NonZeroUsize::MIN,
            &|_, _| {},
        );
        assert!(session.show().finished == &rendered);

        let recording = session.recording();
        put(&mut session, THERE);
        assert_eq!(session.recording(), recording, "it stood there already");
    }

    #[test]
    fn a_light_goes_where_the_lesson_and_numbers_allow_and_nowhere_else() {
        let mut session = session();
        let far = DVec3::new(0.0, 2e75, 0.0);
        for (light, position, why) in [
            (1, THERE, words::LIGHT_STAYS),
            (usize::MAX, THERE, words::LIGHT_STAYS),
            (0, DVec3::NAN, words::TOO_FAR),
            (0, DVec3::NEG_INFINITY, words::TOO_FAR),
            (0, far, words::TOO_FAR),
        ] {
            let command = Command::MoveLight { light, position };
            assert_eq!(
                session.update(command),
                Err(why.into()),
                "{light} {position}"
            );
        }
        assert!(!session.light_is_moved() && session.recording() == 1);
        session.open.lesson.movable_lights.clear();
        let command = Command::MoveLight {
            light: 0,
            position: THERE,
        };
        assert_eq!(session.allows(&command), Err(words::LIGHT_STAYS.into()));
        assert_eq!(session.update(command), Err(words::LIGHT_STAYS.into()));
    }

    #[test]
    fn reset_puts_the_light_back() {
        let mut session = session();
        let as_opened = picture(&mut session);
        put(&mut session, THERE);
        assert_eq!(
            session.update(Command::Share),
            Err(words::SHARE_AS_LIT_ONLY.into())
        );
        session.update(Command::Focus(Focus::Frame)).unwrap();
        session.update(Command::Forward(9)).unwrap();
        session.update(Command::Reset).unwrap();
        assert!(!session.light_is_moved() && session.follows_lesson());
        assert_eq!(session.step(), 0);
        assert!(picture(&mut session) == as_opened);
        session.update(Command::Share).unwrap();
    }

    #[test]
    fn answers_follow_the_light_and_no_question_is_got_around() {
        let mut session = session();
        let mut numbers = 0;
        while session.step() < session.last_step() {
            session.update(Command::End).unwrap();
            let answer = |session: &Session| session.question().map(|asked| asked.0.answer.clone());
            let before = answer(&session);
            for position in [DVec3::new(0.0, 0.0, 9.0), THERE] {
                put(&mut session, position);
                let waits = session.question_at(session.step());
                assert!(waits || before.is_none(), "{}", session.step());
            }
            if let Some(Answer::Number { .. }) = before {
                numbers += usize::from(answer(&session) != before);
            }
            put(&mut session, DVec3::new(0.9, 0.7, 1.5));
            assert_eq!(answer(&session), before, "the light is back");
            if before.is_some() {
                session.update(Command::Skip).unwrap();
            }
        }
        assert!(numbers > 0, "a number depends on the light");
    }

    #[test]
    fn a_light_moved_elsewhere_is_moved_in_the_lesson_too() {
        let mut session = session();
        session.update(Command::Forward(5)).unwrap();
        let own = session.focus();
        session
            .update(Command::Focus(Focus::Pixel { x: 20, y: 15 }))
            .unwrap();
        let kind = session.walk().kind(session.step());
        put(&mut session, THERE);
        assert_eq!(session.focus(), Focus::Pixel { x: 20, y: 15 });
        assert_eq!(session.walk().kind(session.step()), kind);
        session.update(Command::Focus(own)).unwrap();
        assert_eq!(session.step(), 5);
        let mut moved_there = self::session();
        put(&mut moved_there, THERE);
        let said = |session: &Session| {
            let narrated = session.open.narrated.iter();
            narrated
                .map(|said| said.say(Language::English).to_owned())
                .collect::<Vec<_>>()
        };
        assert_eq!(said(&session), said(&moved_there));
        assert_ne!(said(&session), said(&self::session()));
    }

    #[test]
    fn what_does_not_happen_any_more_is_not_narrated() {
        let json = r#"{ "schema": 1, "id": "bright", "number": 1, "topics": [],
            "title": { "en": "T", "id": "T" }, "summary": { "en": "S", "id": "S" },
            "scene": { "schema": 1, "materials": { "chalk": { "diffuse": [1, 1, 1] } },
                "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
                "objects": [{ "name": "page", "material": "chalk", "polygon": { "vertices": [[-1, -1, 0], [1, -1, 0], [0, 1, 0]] } }],
                "lights": [{ "directional": { "toward": [0, 0, -1], "color": [0.1, 0.1, 0.1] } }, { "point": { "position": [0, 0, 3] } }] },
            "method": "gouraud", "size": [24, 18], "focus": "frame", "panels": ["image"], "movable_lights": [1],
            "steps": [{ "at": { "kind": "VertexLit", "where": { "I_v.r": { "above": 0.5 } } }, "say": { "en": "Lit", "id": "Terang" } }] }"#;
        let lesson = Lesson::read(
            json.as_bytes(),
            &Default::default(),
            &mut |_| unreachable!(),
        );
        let mut session = Session::new(lesson.unwrap()).unwrap();
        session.update(Command::NextNarrated).unwrap();
        let step = session.step();
        let mut put = |z: f64| {
            let position = DVec3::new(0.0, 0.0, z);
            session
                .update(Command::MoveLight { light: 1, position })
                .unwrap();
            (
                session.is_unsaid(),
                session.step(),
                session.said_here().is_some(),
            )
        };
        assert_eq!(put(-3.0), (true, step, false));
        assert_eq!(put(3.5), (false, step, true));
    }
}
