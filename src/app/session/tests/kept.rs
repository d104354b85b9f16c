use super::super::kept::Place;
use super::super::{Kept, Progress};
use super::*;
use crate::picture::Theme;

/// As the file keeps it.
fn through_the_file(kept: &Kept) -> Kept {
    let text = serde_json::to_string(kept).expect("data");
    serde_json::from_str(&text).expect("what was written")
}

fn reopened(session: &mut Session) -> Session {
    let mut again = self::session("gouraud-triangle");
    again.restore(through_the_file(&session.keep()));
    again
}

#[test]
fn a_lesson_goes_on_where_it_was_left() {
    let mut session = session("gouraud-triangle");
    go(&mut session, Command::End);
    go(&mut session, Command::Skip);
    let skipped = session.step();
    go(&mut session, Command::Forward(2));
    for command in [
        Command::Speak(Language::Indonesian),
        Command::Theme(Theme::Dark),
        Command::LargerText,
        Command::Present,
    ] {
        go(&mut session, command);
    }
    let mut again = reopened(&mut session);
    assert_eq!(again.step(), skipped + 2);
    go(&mut again, Command::Seek(skipped));
    let standing = again.question().map(|(_, standing)| standing);
    assert_eq!(standing, Some(Standing::Skipped));
    assert_eq!(again.look.language, Language::Indonesian);
    assert_eq!(again.look.theme, Theme::Dark, "not that of presenting");
    let mut larger = self::session("gouraud-triangle");
    go(&mut larger, Command::LargerText);
    assert_eq!(again.look.zoom(), larger.look.zoom());
}

/// A second try stays one.
#[test]
fn the_answers_given_are_kept() {
    let mut session = session("gouraud-triangle");
    go(&mut session, Command::End);
    let (question, _) = session.question().expect("a question");
    let wrong = match &question.answer {
        Answer::Number { .. } => Guess::Number("1e9".into()),
        Answer::Choice { right, .. } => Guess::Choice((right + 1) % 2),
        Answer::Pixel { x, y, .. } => Guess::Pixel { x: x + 1000, y: *y },
        Answer::Pick { right, .. } => Guess::Pick(usize::from(*right == 0)),
        Answer::Order { items, .. } => Guess::Order((0..items.len()).collect()),
        Answer::Arrow { .. } => Guess::Arrow(180.0),
        Answer::Undecided => panic!("the lesson's own values decide"),
    };
    go(&mut session, Command::Answer(wrong.clone()));
    assert_eq!(reopened(&mut session).guesses(), [wrong]);
}

#[test]
fn another_lesson_and_back_loses_nothing() {
    let mut session = session("gouraud-triangle");
    go(&mut session, Command::NextNarrated);
    let step = session.step();
    assert!(step > 0);
    go(&mut session, Command::Open("gouraud-teapot".into()));
    assert_eq!(session.step(), 0);
    assert_eq!(session.keep().lesson.as_deref(), Some("gouraud-teapot"));
    go(&mut session, Command::Open("gouraud-triangle".into()));
    assert_eq!(session.step(), step);
}

#[test]
fn another_focus_keeps_the_place_in_the_lesson() {
    let mut session = session("gouraud-triangle");
    go(&mut session, Command::NextNarrated);
    let step = session.step();
    let kept = session.keep();
    go(&mut session, Command::Focus(Focus::ScanLine(3)));
    go(&mut session, Command::Forward(4));
    assert_eq!(session.keep(), kept);
    assert_eq!(reopened(&mut session).step(), step);
}

#[test]
fn a_place_stays_at_its_explanation_when_more_events_are_recorded() {
    let narrated = [0, 10, 20];
    for (step, place) in [(0, 0), (13, 13), (20, 20), (25, 25)] {
        assert_eq!(Place::of(step, &narrated).step(&narrated, 30), place);
    }
    let place = Place::of(13, &narrated);
    assert_eq!(place.step(&[0, 110, 220], 300), 113);
    assert_eq!(place.step(&[0, 5, 7], 9), 6, "before the next explanation");
    assert_eq!(Place::of(29, &narrated).step(&narrated, 22), 22);
    assert_eq!(Place::of(25, &narrated).step(&[4], 9), 9);
    assert_eq!(Place::of(2, &[4]).step(&[1], 9), 0);
}

#[test]
fn what_makes_no_sense_here_is_passed_over() {
    let mut kept = Kept::default();
    kept.language = Some("tlh".into());
    let progress = Progress {
        place: Place(Some(usize::MAX), usize::MAX),
        reached: usize::MAX,
        answers: (0..100).map(|index| (index, Standing::Right)).collect(),
        guesses: (0..100)
            .map(|index| (index, vec![Guess::Choice(99)]))
            .collect(),
    };
    kept.lessons.insert("gouraud-triangle".into(), progress);
    let mut session = session("gouraud-triangle");
    session.restore(through_the_file(&kept));
    assert_eq!(session.step(), session.last_step());
    assert_eq!(session.look.language, Language::English);
    let asked = session.open.narrated.iter();
    let asked = asked.filter(|said| said.question.is_some()).count();
    let kept = session.keep();
    let progress = &kept.lessons["gouraud-triangle"];
    assert_eq!(progress.answers.len(), asked);
    assert!(progress.guesses.is_empty());
    assert_eq!(progress.reached, session.open.narrated.len());
}

#[test]
fn a_lesson_can_be_started_again_and_everything_forgotten() {
    let mut session = session("gouraud-triangle");
    go(&mut session, Command::End);
    go(&mut session, Command::Skip);
    go(&mut session, Command::Open("gouraud-teapot".into()));
    go(&mut session, Command::NextNarrated);
    let before = session.keep();
    go(&mut session, Command::Reset);
    let kept = session.keep();
    assert_eq!(session.step(), 0);
    let triangle = "gouraud-triangle";
    assert_eq!(kept.lessons[triangle], before.lessons[triangle]);
    assert!(kept.lessons["gouraud-teapot"].reached < before.lessons["gouraud-teapot"].reached);
    go(&mut session, Command::Forget);
    let kept = session.keep();
    let ids: Vec<&String> = kept.lessons.keys().collect();
    assert_eq!(ids, ["gouraud-teapot"]);
    go(&mut session, Command::Open(triangle.into()));
    assert!(session.keep().lessons[triangle].answers.is_empty());
    assert_eq!(session.step(), 0);
}
