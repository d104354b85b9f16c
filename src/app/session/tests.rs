mod focus;
mod kept;
mod questions;
mod reused;

use super::{Command, Direction, Guess, Refused, Session, Standing};
use crate::algorithms::focus::Focus;
use crate::app::strings;
use crate::language::Language;
use crate::lesson::{Answer, Thing, builtin};
use crate::panels::{Panel, draw};
use crate::picture::Tag;
use crate::record::Value;
use crate::render::render;
use std::num::NonZeroUsize;

fn session(id: &str) -> Session {
    let lesson = builtin(id)
        .expect("a lesson")
        .read()
        .expect("a right lesson");
    Session::new(lesson).expect("a lesson that resolves")
}

/// Without questions in the way.
fn triangle() -> Session {
    let mut session = session("gouraud-triangle");
    session.update(Command::Questions).expect("a switch");
    session
}

fn go(session: &mut Session, command: Command) {
    session
        .update(command.clone())
        .unwrap_or_else(|refused| panic!("{command:?}: {refused:?}"));
}

/// What every panel shows: equal where the state is.
fn shown(session: &Session) -> Vec<crate::picture::Picture> {
    Panel::ALL
        .map(|panel| draw(panel, &session.panel_input(), glam::Vec2::new(400.0, 300.0)))
        .into()
}

fn integer(session: &Session, name: &str) -> Option<i64> {
    match session.walk().fields(session.step()).get(name) {
        Some(Value::Integer(value)) => Some(value),
        _ => None,
    }
}

#[test]
fn step_back_then_forward_is_the_same_state() {
    let mut session = triangle();
    for step in [1, 10, 57, session.last_step()] {
        go(&mut session, Command::Seek(step));
        let before = shown(&session);
        go(&mut session, Command::Back(1));
        go(&mut session, Command::Forward(1));
        assert_eq!((session.step(), shown(&session)), (step, before));
    }
}

#[test]
fn both_ends_refuse_to_go_further() {
    let mut session = triangle();
    assert_eq!(
        session.update(Command::Back(1)),
        Err(strings::AT_THE_START.into())
    );
    go(&mut session, Command::Forward(usize::MAX));
    assert_eq!(session.step(), session.last_step());
    assert_eq!(
        session.update(Command::Forward(1)),
        Err(strings::AT_THE_END.into())
    );
    assert_eq!(
        session.allows(&Command::Forward(1)),
        Err(strings::AT_THE_END.into())
    );
    go(&mut session, Command::Start);
    assert_eq!(session.step(), 0);
}

#[test]
fn playing_forward_takes_steps_in_time_and_ends_at_the_end() {
    let mut session = triangle();
    go(&mut session, Command::Play);
    session.advance(0.4);
    assert_eq!(session.step(), 0, "two steps a second");
    session.advance(0.2);
    assert_eq!(session.step(), 1);
    go(&mut session, Command::Faster);
    session.advance(1.0);
    assert_eq!(session.step(), 5);
    let last = session.last_step();
    go(&mut session, Command::Seek(last - 1));
    assert_eq!(session.playing(), None, "who walks stops playing");
    go(&mut session, Command::Play);
    session.advance(1.0);
    assert_eq!(
        (session.step(), session.playing()),
        (session.last_step(), None)
    );
    assert_eq!(
        session.update(Command::Play),
        Err(strings::AT_THE_END.into())
    );
}

#[test]
fn playing_backwards_moves_steps_in_reverse() {
    let mut session = triangle();
    go(&mut session, Command::Seek(5));
    go(&mut session, Command::PlayBackwards);
    let mut seen = Vec::new();
    while session.playing() == Some(Direction::Backward) {
        session.advance(0.5);
        seen.push(session.step());
    }
    assert_eq!(seen, [4, 3, 2, 1, 0]);
}

#[test]
fn playing_stays_in_the_loop_and_stops_at_breakpoints() {
    let mut session = triangle();
    go(&mut session, Command::Seek(3));
    go(&mut session, Command::LoopFrom);
    go(&mut session, Command::Seek(5));
    go(&mut session, Command::LoopTo);
    assert_eq!(session.loop_range(), Some((3, 5)));
    go(&mut session, Command::Seek(4));
    go(&mut session, Command::Play);
    let seen: Vec<usize> = (0..6)
        .map(|_| {
            session.advance(0.5);
            session.step()
        })
        .collect();
    assert_eq!(seen, [5, 3, 4, 5, 3, 4]);
    go(&mut session, Command::LoopOff);
    go(&mut session, Command::Seek(20));
    go(&mut session, Command::Breakpoint);
    go(&mut session, Command::Seek(18));
    go(&mut session, Command::Play);
    (0..4).for_each(|_| session.advance(1.0));
    assert_eq!((session.step(), session.playing()), (20, None));
    go(&mut session, Command::Breakpoint);
    assert!(session.breakpoints().is_empty());
}

#[test]
fn a_search_goes_around_and_says_when_it_fails() {
    let mut session = triangle();
    go(&mut session, Command::Find("ScanLine".into()));
    let first = session.step();
    go(&mut session, Command::FindBack("ScanLine".into()));
    assert!(session.step() > first);
    go(&mut session, Command::Find("ScanLine".into()));
    assert_eq!(session.step(), first);
    assert_eq!(
        session.update(Command::Find("Nonsense".into())),
        Err(strings::NOT_FOUND.into())
    );
    let Err(Refused::Error(error)) = session.update(Command::Find("y=".into())) else {
        panic!("a condition without a value");
    };
    assert!(error.starts_with("column 3: expected"), "{error}");
}

#[test]
fn a_search_takes_names_of_the_readers_language_and_those_of_the_program() {
    let mut session = triangle();
    session.look.language = Language::Indonesian;
    let mut step_of = |text: &str| {
        go(&mut session, Command::Seek(0));
        go(&mut session, Command::Find(text.into()));
        session.step()
    };
    for (written, named) in [
        ("Garis scan", "ScanLine"),
        ("garis scan y=5", "ScanLine y=5"),
        (
            "Sisi diinterpolasi y=5 sisi=2",
            "EdgeInterpolated y=5 edge=2",
        ),
        (
            "EdgeInterpolated sisi=2 I_4<0,82",
            "EdgeInterpolated edge=2 I_4<0.82",
        ),
        ("lebih dekat=ya", "nearer=true"),
    ] {
        assert_eq!(step_of(written), step_of(named), "{written}");
    }
}

#[test]
fn presenting_and_back_leaves_the_theme_as_it_was() {
    let mut session = triangle();
    go(&mut session, Command::NextTheme);
    let look = session.look;
    go(&mut session, Command::Present);
    assert!(session.look.zoom() > look.zoom());
    go(&mut session, Command::Present);
    assert_eq!(session.look.theme, look.theme);
}

#[test]
fn another_lesson_takes_the_place_of_this_one() {
    let mut session = triangle();
    go(&mut session, Command::Forward(5));
    go(&mut session, Command::Open("gouraud-teapot".into()));
    assert_eq!(
        (session.lesson().id.as_str(), session.step()),
        ("gouraud-teapot", 0)
    );
    assert_eq!(
        session.update(Command::Open("nothing".into())),
        Err(strings::NO_SUCH_LESSON.into())
    );
    go(&mut session, Command::Share);
    assert_eq!(
        session.shared.as_deref(),
        Some("lightwalk open gouraud-teapot --step 0")
    );
}

#[test]
fn a_lesson_is_walked_while_its_picture_is_made() {
    let mut session = session("gouraud-teapot");
    for _ in 0..3 {
        // Whatever has come in by now, nothing waits for it and every panel can be drawn.
        shown(&session);
        go(&mut session, Command::Forward(1));
        session.take_picture();
    }
    let pictures = session.pictures();
    session.wait_for_picture();
    assert!(!session.awaits_picture() && session.picture_percent().is_none());
    assert!(session.pictures() > pictures);
    let setup = &session.open.setup;
    let rendered = render(
        setup,
        session.lesson().method,
        NonZeroUsize::MIN,
        &|_, _| {},
    );
    assert!(session.panel_input().finished.picture == rendered);
}

#[test]
fn a_picture_of_the_lesson_before_never_shows() {
    let mut session = session("gouraud-teapot");
    for id in ["gouraud-triangle", "gouraud-teapot", "gouraud-triangle"] {
        go(&mut session, Command::Open(id.into()));
        session.take_picture();
        let [width, height] = session.lesson().size;
        let finished = &session.panel_input().finished.picture;
        assert_eq!([finished.width, finished.rows.end], [width, height]);
    }
    session.wait_for_picture();
    let mut alone = self::session("gouraud-triangle");
    alone.wait_for_picture();
    assert!(session.panel_input().finished.picture == alone.panel_input().finished.picture);
}

#[test]
fn a_pinned_tree_stays_as_it_was_until_the_lesson_starts_over() {
    let mut session = session("ray-tree");
    session.start_at(session.last_step());
    go(&mut session, Command::Pin);
    let light = session.pinned().unwrap().light_so_far();
    go(&mut session, Command::Back(100));
    let focus = Focus::Pixel { x: 10, y: 10 };
    go(&mut session, Command::Focus(focus));
    let pinned = session.panel_input().pinned.unwrap();
    assert_eq!(
        (pinned.pixel, pinned.light_so_far()),
        (Some((284, 149)), light)
    );
    go(&mut session, Command::Reset);
    assert!(session.pinned().is_none());
}
