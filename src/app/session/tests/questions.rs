use super::super::Sheet;
use super::*;
use crate::lesson::builtins;
use crate::picture::Shape;

#[test]
fn a_question_stops_every_way_forward_until_it_is_answered_or_skipped() {
    let mut session = session("gouraud-triangle");
    go(&mut session, Command::End);
    let asked = session.step();
    assert!(session.question_at(asked) && asked < session.last_step());
    for command in [
        Command::Forward(1),
        Command::End,
        Command::NextNarrated,
        Command::Play,
    ] {
        assert_eq!(session.update(command), Err(strings::ANSWER_FIRST.into()));
        assert_eq!(session.step(), asked);
    }
    go(&mut session, Command::Back(1));
    go(&mut session, Command::Play);
    (0..3).for_each(|_| session.advance(1.0));
    assert_eq!((session.step(), session.playing()), (asked, None));
    go(&mut session, Command::Skip);
    assert_eq!(
        session.question().map(|(_, standing)| standing),
        Some(Standing::Skipped)
    );
    go(&mut session, Command::Forward(1));
    assert_eq!(session.step(), asked + 1);
}

#[test]
fn a_shared_step_is_opened_whatever_is_asked_before_it() {
    let mut shared = session("gouraud-triangle");
    shared.start_at(usize::MAX);
    assert_eq!(shared.step(), shared.last_step());
    let asked = session("gouraud-triangle").question_between(0, usize::MAX);
    let asked = asked.expect("a question");
    for step in [asked, asked + 1, shared.last_step() / 2] {
        let mut session = session("gouraud-triangle");
        session.start_at(step);
        assert_eq!(session.question_at(step), step == asked);
        go(&mut session, Command::Share);
        let command = format!("lightwalk open gouraud-triangle --step {step}");
        assert_eq!(session.shared, Some(command));
    }
}

#[test]
fn answers_are_held_against_the_run() {
    let mut session = session("gouraud-triangle");
    let mut answered = 0;
    while session.step() < session.last_step() {
        go(&mut session, Command::End);
        let Some((question, Standing::Open)) = session.question() else {
            continue;
        };
        let tries = question.answer.tries();
        let right = match question.answer {
            Answer::Number { value, tolerance } => {
                Guess::Number(format!("{}", value + 0.9 * tolerance).replace('.', ","))
            }
            Answer::Choice { right, .. } => Guess::Choice(right),
            Answer::Pixel { x, y, .. } => Guess::Pixel { x, y },
            Answer::Pick { right, .. } => Guess::Pick(right),
            Answer::Order { ref right, .. } => Guess::Order(right.clone()),
            Answer::Arrow { .. } => panic!("see below"),
            Answer::Undecided => panic!("nothing is changed"),
        };
        let wrong = match right {
            Guess::Number(_) => Guess::Number("1e9".into()),
            Guess::Choice(right) => Guess::Choice(usize::from(right == 0)),
            Guess::Pixel { x, y } => Guess::Pixel { x: x + 1000, y },
            Guess::Order(ref right) => Guess::Order((0..right.len()).collect()),
            Guess::Pick(right) => Guess::Pick(usize::from(right == 0)),
            Guess::Arrow(degrees) => Guess::Arrow(degrees + 180.0),
        };
        if let Guess::Choice(_) = right {
            let none = Command::Answer(Guess::Choice(99));
            assert_eq!(session.update(none), Err(strings::NO_QUESTION.into()));
        }
        if matches!(right, Guess::Number(_)) {
            let much = Command::Answer(Guess::Number("much".into()));
            assert_eq!(session.update(much), Err(strings::NOT_A_NUMBER.into()));
        }
        answered += 1;
        let (guess, standing) = if answered % 2 == 0 {
            (wrong.clone(), Standing::Wrong)
        } else {
            (right, Standing::Right)
        };
        // After a first wrong answer the question still waits.
        if tries == 2 {
            go(&mut session, Command::Answer(wrong));
            assert!(session.question_at(session.step()) && session.guesses().len() == 1);
        }
        go(&mut session, Command::Answer(guess));
        assert_eq!(
            session.question().map(|(_, standing)| standing),
            Some(standing)
        );
    }
    assert!(answered >= 3, "a lesson asks three questions or more");
}

#[test]
fn a_lesson_ends_behind_its_last_explanation_and_not_before_a_question() {
    let mut session = session("gouraud-triangle");
    session.start_at(usize::MAX);
    assert!(session.is_last_explanation());
    go(&mut session, Command::NextNarrated);
    assert_eq!(session.look.sheet, Some(Sheet::Finished));
    go(&mut session, Command::Sheet(Sheet::Finished));
    assert_eq!(session.look.sheet, None);
    // As if the last explanation had a question.
    let mut narrated = session.open.narrated.iter();
    let index = narrated.position(|said| said.question.is_some());
    let index = index.expect("a question");
    session.narrated.truncate(index + 1);
    session.open.narrated.truncate(index + 1);
    session.standings[index] = Standing::Open;
    session.seek(session.narrated[index]);
    let refused = Err(strings::ANSWER_FIRST.into());
    assert_eq!(session.allows(&Command::NextNarrated), refused);
    assert_eq!(session.update(Command::NextNarrated), refused);
    assert_eq!(session.look.sheet, None);
}

/// At the first question of that kind, whatever is asked before it.
fn asked(lesson: &str, is: impl Fn(&Answer) -> bool) -> Session {
    let mut session = session(lesson);
    for step in session.narrated.clone() {
        session.start_at(step);
        let question = session.question();
        if question.is_some_and(|(question, _)| is(&question.answer)) {
            return session;
        }
    }
    panic!("{lesson} has no such question")
}

#[test]
fn a_thing_is_picked_where_a_picture_shows_it() {
    let is_pick = |answer: &Answer| matches!(answer, Answer::Pick { .. });
    let mut shadows = asked("shadows", is_pick);
    // The marked pixel itself shows the table top.
    go(&mut shadows, Command::Click(Tag::Pixel { x: 322, y: 200 }));
    assert_eq!(shadows.guesses(), [Guess::Pick(0)]);
    assert_eq!(shadows.answered().right, None);
    let ball = shadows.place_of(Thing::Object, 2).expect("in the picture");
    go(&mut shadows, Command::Click(ball));
    assert_eq!(shadows.guesses().last(), Some(&Guess::Pick(2)));
    assert_eq!(shadows.question().unwrap().1, Standing::Right);
    assert_eq!(shadows.answered().right, Some(ball));

    let mut shooting = asked("shooting", is_pick);
    go(&mut shooting, Command::Click(Tag::Patch(22)));
    let before = draw(
        Panel::Radiosity,
        &shooting.panel_input(),
        glam::vec2(900.0, 600.0),
    );
    go(&mut shooting, Command::Click(Tag::Patch(0)));
    assert_eq!(shooting.question().unwrap().1, Standing::Wrong);
    let marks = shooting.answered();
    let (own, right) = (Some(Tag::Patch(0)), Some(Tag::Patch(13)));
    assert_eq!((marks.own, marks.right), (own, right));
    let after = draw(
        Panel::Radiosity,
        &shooting.panel_input(),
        glam::vec2(900.0, 600.0),
    );
    assert!(after.items.len() > before.items.len());
    // What is answered is a question no more: the click lights the patch up.
    go(&mut shooting, Command::Click(Tag::Patch(13)));
    assert_eq!(shooting.selected(), Some(Tag::Patch(13)));
}

#[test]
fn an_arrow_is_turned_and_the_right_one_stands_beside_it() {
    let mut session = asked("reflection", |answer| {
        matches!(answer, Answer::Arrow { .. })
    });
    let (question, _) = session.question().unwrap();
    let Answer::Arrow {
        plane,
        direction,
        tolerance,
        ..
    } = question.answer
    else {
        panic!("an arrow is asked for")
    };
    let right = plane.degrees(direction);
    let shown = |session: &Session| session.answered().arrow.expect("an arrow");
    assert!(
        session
            .arrow_asked()
            .is_some_and(|start| (start - right).abs() > tolerance)
    );
    let wrong = right + tolerance + 10.0;
    go(&mut session, Command::Turn(wrong));
    assert_eq!(session.arrow_asked(), Some(wrong));
    assert!(shown(&session).own.distance(plane.direction(wrong)) < 1e-12);
    assert_eq!(shown(&session).right, None);
    go(&mut session, Command::Answer(Guess::Arrow(wrong)));
    // The second try begins where the first one ended.
    assert_eq!(session.arrow_asked(), Some(wrong));
    go(&mut session, Command::Answer(Guess::Arrow(wrong - 1.0)));
    assert_eq!(session.question().unwrap().1, Standing::Wrong);
    let arrow = shown(&session);
    assert_eq!((arrow.right, arrow.is_right), (Some(direction), false));
    // What has its verdict is turned no more.
    assert_eq!(session.arrow_asked(), None);
    let refused = Err(strings::NO_QUESTION.into());
    assert_eq!(session.update(Command::Turn(0.0)), refused);
}

#[test]
fn what_was_turned_at_one_step_is_not_turned_at_another() {
    let mut session = asked("reflection", |answer| {
        matches!(answer, Answer::Arrow { .. })
    });
    let start = session.arrow_asked();
    let step = session.step();
    go(&mut session, Command::Turn(12.0));
    go(&mut session, Command::Back(1));
    assert_eq!(session.answered().arrow, None);
    go(&mut session, Command::Seek(step));
    assert_eq!(session.arrow_asked(), Some(12.0));
    go(&mut session, Command::Reset);
    session.start_at(step);
    assert_eq!(session.arrow_asked(), start);
}

#[test]
fn what_is_clicked_or_turned_is_shown_large_while_it_is_asked_for() {
    let mut asked = 0;
    for builtin in builtins() {
        let mut session = session(builtin.id);
        for step in session.narrated.clone() {
            // Whatever was chosen before.
            let chosen = session.panels()[session.panels().len() - 1];
            go(&mut session, Command::Key(chosen));
            session.start_at(step);
            let Some((question, _)) = session.question() else {
                continue;
            };
            let fits = question.answer.panels();
            if fits.is_empty() {
                continue;
            }
            asked += 1;
            let key = session.key_panel().expect("a panel");
            assert!(fits.contains(&key), "{} at {step}: {key:?}", builtin.id);
            go(&mut session, Command::Skip);
            assert_eq!(session.key_panel(), Some(key), "{} at {step}", builtin.id);
        }
    }
    assert!(asked >= 10, "{asked} questions");
}

#[test]
fn the_right_arrow_is_the_one_that_the_run_draws() {
    for (id, name) in [
        ("reflection", "R"),
        ("refraction", "T"),
        ("illumination-model", "R_L"),
    ] {
        let mut session = asked(id, |answer| matches!(answer, Answer::Arrow { .. }));
        let size = glam::vec2(900.0, 700.0);
        let tips = |session: &Session, name: &str| -> Vec<glam::Vec2> {
            let picture = draw(Panel::Vectors, &session.panel_input(), size);
            let named = picture
                .items
                .into_iter()
                .filter_map(|item| match item.shape {
                    Shape::Text { at, text, .. } if text == name => Some(at),
                    _ => None,
                });
            named.collect()
        };
        assert_eq!(tips(&session, name), [], "{id}");
        go(&mut session, Command::Skip);
        let (question, _) = session.question().unwrap();
        let (field, step) = match question.answer {
            Answer::Arrow { name, .. } => (name, question.step),
            _ => panic!("an arrow is asked for"),
        };
        let tip = tips(&session, field);
        session.start_at(step);
        let drawn = tips(&session, name);
        let (tip, drawn) = (tip[0], drawn[0]);
        assert!(tip.distance(drawn) < 40.0, "{id}: {tip}, drawn {drawn}");
    }
}

#[test]
fn nothing_beyond_the_next_question_is_known() {
    let mut session = asked("ray-tree", |_| true);
    let question = session.step();
    session.update(Command::Start).unwrap();
    assert_eq!(session.panel_input().last_known(), question);
    go(&mut session, Command::NextNarrated);
    while session.step() < question {
        go(&mut session, Command::NextNarrated);
    }
    go(&mut session, Command::Skip);
    let next = session.panel_input().last_known();
    assert!(next > question, "{next} after {question}");
    // Who asks for no questions sees everything.
    go(&mut session, Command::Questions);
    assert_eq!(session.panel_input().last_known(), usize::MAX);
}
