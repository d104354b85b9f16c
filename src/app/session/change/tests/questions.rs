//! Questions whose answers depend on what is changed.

use super::*;
use crate::lesson::Answer;

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
fn a_question_that_no_option_answers_says_so_and_stops_nobody() {
    let ball = builtin("illumination-model").unwrap().read().unwrap();
    let specular = |&parameter: &Parameter| {
        matches!(parameter, Parameter::Coefficient(_, Coefficient::Specular))
    };
    let parameter = ball.parameters.iter().copied().find(specular).unwrap();
    let opened = ball.value(parameter, &[]).unwrap();
    let mut session = Session::new(ball).unwrap();
    let Change::Coefficient {
        material,
        coefficient,
        ..
    } = opened
    else {
        panic!("a coefficient")
    };
    // What is left of nothing is neither much nor little.
    let change = Change::Coefficient {
        material,
        coefficient,
        value: 0.0,
    };
    session.update(Command::Change(change)).unwrap();
    let is_undecided = |session: &Session| {
        let question = session.question();
        question.is_some_and(|(question, _)| question.answer == Answer::Undecided)
    };
    while !is_undecided(&session) {
        if session.question_at(session.step()) {
            session.update(Command::Skip).unwrap();
        }
        session.update(Command::NextNarrated).unwrap();
    }
    let step = session.step();
    assert!(!session.question_at(step) && session.panel_input().pending.is_none());
    session.update(Command::Forward(1)).unwrap();
    session.update(Command::Back(1)).unwrap();
    session.update(Command::Change(opened)).unwrap();
    assert!(session.question_at(step) && !is_undecided(&session));
}
