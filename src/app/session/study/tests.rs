use super::super::{Command, PointAt, Session, StudyCommand};
use super::*;
use crate::lesson::builtin;
use crate::panels::strings::Language;
use crate::render::Method;
use crate::study::form::Drawn;
use crate::study::tests::findings;

fn session() -> Session {
    Session::new(builtin("gouraud-triangle").unwrap().read().unwrap()).unwrap()
}

fn go(session: &mut Session, command: StudyCommand) -> Result<(), Refused> {
    session.update(Command::Study(command))
}

const FIRST: PointAt = PointAt {
    part: 0,
    line: 0,
    point: 0,
};

/// A study that was measured before; its first point draws the lesson's own stage by some method.
fn measured(method: Method) -> Session {
    let mut session = session();
    let setup = session.open.setup.clone();
    let found = findings();
    let studying = &mut session.studying;
    (studying.of, studying.parts) = (Some((found.study, true)), found.parts);
    studying.parts[0].lines[0].points[0].drawn = Some(Drawn { setup, method });
    studying.is_open = true;
    session
}

#[test]
fn a_study_is_measured_in_the_background_and_every_part_comes() {
    let mut session = session();
    go(&mut session, StudyCommand::View).unwrap();
    let interpolation = families::ALL.iter().position(|s| s.name == "interpolation");
    go(&mut session, StudyCommand::Choose(interpolation.unwrap())).unwrap();
    go(&mut session, StudyCommand::Measure).unwrap();
    assert!(session.studying().percent().is_some());
    let again = go(&mut session, StudyCommand::Measure);
    assert_eq!(again, Err(strings::STILL_MEASURING.into()));
    session.studying_mut().wait();
    let studying = session.studying();
    assert_eq!((studying.parts.len(), studying.percent()), (1, None));
    assert_eq!(studying.outcome, Outcome::Well);
    let command = "lightwalk study interpolation --quick --out found";
    assert_eq!(studying.command_line().as_deref(), Some(command));
    let exact = studying.parts[0]
        .lines
        .iter()
        .find(|line| line.name.name() == "direct, f64");
    assert!(
        exact
            .unwrap()
            .points
            .iter()
            .all(|p| p.errors.unwrap().rms < 1e-15)
    );
}

#[test]
fn a_study_that_is_called_off_ends_at_once_for_its_viewer() {
    let mut session = session();
    let nothing = go(&mut session, StudyCommand::Cancel);
    assert_eq!(nothing, Err(strings::NOTHING_IS_MEASURED.into()));
    go(&mut session, StudyCommand::Measure).unwrap();
    go(&mut session, StudyCommand::Cancel).unwrap();
    assert_eq!(session.studying().percent(), None);
    assert_eq!(session.studying().outcome, Outcome::Cancelled);
    // The next one need not wait for it.
    go(&mut session, StudyCommand::Measure).unwrap();
}

#[test]
fn the_measurer_stops_at_the_next_setting_once_it_is_called_off() {
    let (mut work, worker) = Work::pair();
    work.cancel();
    let interpolation = families::ALL.iter().find(|s| s.name == "interpolation");
    measure(interpolation.unwrap(), true, &worker);
    drop(worker);
    assert!(matches!(
        work.wait()[..],
        [News::Unmeasured(Unmeasured::Cancelled(_))]
    ));
}

#[test]
fn a_point_with_a_picture_opens_it_with_its_run_and_the_study_stays() {
    for method in [Method::Gouraud, Method::RayTracing, Method::Wireframe] {
        let mut session = measured(method);
        session
            .update(Command::Speak(Language::Indonesian))
            .unwrap();
        go(&mut session, StudyCommand::Pick(FIRST)).unwrap();
        assert_eq!(session.lesson().method, method);
        assert_eq!(session.title(), "rough, n = 2");
        let said = session.narration_here().unwrap().text(Language::English);
        assert!(said.contains("0.25 in 2.00 ms"), "{said}");
        assert!(session.last_step() > 1);
        assert_eq!(session.look.language, Language::Indonesian);
        let shared = session.update(Command::Share);
        assert_eq!(shared, Err(strings::SHARE_NO_STUDY.into()));
        assert!(!session.studying().is_open);
        go(&mut session, StudyCommand::View).unwrap();
        assert_eq!(session.studying().picked, Some(FIRST));
        assert_eq!(session.studying().parts.len(), 1);
    }
}

#[test]
fn a_point_without_a_picture_is_reported_and_one_that_is_not_there_is_refused() {
    let mut session = measured(Method::Gouraud);
    let other = PointAt { line: 1, ..FIRST };
    go(&mut session, StudyCommand::Pick(other)).unwrap();
    assert_eq!(session.studying().picked, Some(other));
    assert!(session.studying().is_open);
    let gone = PointAt { point: 99, ..FIRST };
    let refused = go(&mut session, StudyCommand::Pick(gone));
    assert_eq!(refused, Err(strings::NO_SUCH_POINT.into()));
    let none = go(&mut session, StudyCommand::Choose(99));
    assert_eq!(none, Err(strings::NO_SUCH_STUDY.into()));
}

#[test]
fn opening_a_lesson_leaves_the_study() {
    let mut session = measured(Method::Gouraud);
    session.update(Command::Open("shadows".into())).unwrap();
    assert!(!session.studying().is_open && session.studying().parts.len() == 1);
}
