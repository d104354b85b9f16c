use super::{Command, Direction, Guess, Refused, Session, Standing};
use crate::algorithms::focus::Focus;
use crate::app::strings;
use crate::lesson::{Answer, builtin};
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
        .map(|panel| draw(panel, &session.show(), glam::Vec2::new(400.0, 300.0)))
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
        let right = match question.answer {
            Answer::Number { value, tolerance } => {
                Guess::Number(format!("{}", value + 0.9 * tolerance).replace('.', ","))
            }
            Answer::Choice { right, .. } => Guess::Choice(right),
            Answer::Pixel { x, y, .. } => Guess::Pixel { x, y },
        };
        let wrong = match right {
            Guess::Number(_) => Guess::Number("1e9".into()),
            Guess::Choice(right) => Guess::Choice(right + 1),
            Guess::Pixel { x, y } => Guess::Pixel { x: x + 1000, y },
        };
        if matches!(right, Guess::Number(_)) {
            let much = Command::Answer(Guess::Number("much".into()));
            assert_eq!(session.update(much), Err(strings::NOT_A_NUMBER.into()));
        }
        answered += 1;
        let (guess, standing) = if answered % 2 == 0 {
            (wrong, Standing::Wrong)
        } else {
            (right, Standing::Right)
        };
        go(&mut session, Command::Answer(guess));
        assert_eq!(
            session.question().map(|(_, standing)| standing),
            Some(standing)
        );
    }
    assert!(answered >= 3, "a lesson asks three questions or more");
}

#[test]
fn another_focus_keeps_the_place_and_the_way_back_brings_the_narration() {
    let mut session = triangle();
    go(&mut session, Command::Find("PixelColored".into()));
    go(&mut session, Command::Find("PixelColored".into()));
    let place = |session: &Session| {
        (
            integer(session, "x"),
            integer(session, "y"),
            session.walk().kind(session.step()),
        )
    };
    let (here, step) = (place(&session), session.step());
    let (Some(x), Some(y), _) = here else {
        panic!("a pixel tells its place")
    };
    for focus in [
        Focus::Pixel {
            x: x as u32,
            y: y as u32,
        },
        Focus::ScanLine(y as u32),
        Focus::Frame,
    ] {
        let recording = session.recording();
        go(&mut session, Command::Focus(focus));
        assert_eq!((session.focus(), place(&session)), (focus, here));
        assert!(session.recording() > recording && session.said_last().is_none());
    }
    let own = session.lesson().focus;
    go(&mut session, Command::Focus(own));
    assert_eq!((session.step(), place(&session)), (step, here));
    assert!(session.said_last().is_some());
    assert_eq!(
        session.update(Command::Focus(Focus::ScanLine(9999))),
        Err(strings::OUTSIDE.into())
    );
}

#[test]
fn the_way_back_to_the_lesson_leads_to_the_step_that_was_left() {
    let mut session = session("gouraud-triangle");
    let own = session.lesson().focus;
    go(&mut session, Command::End);
    let asked = session.step();
    assert!(session.question_at(asked));
    let middle = session.lesson().size.map(|size| size / 2);
    let pixel = Focus::Pixel {
        x: middle[0],
        y: middle[1],
    };
    for step in [asked, asked - 1, 0] {
        go(&mut session, Command::Seek(step));
        go(&mut session, Command::Focus(pixel));
        go(&mut session, Command::Focus(Focus::Frame));
        let _ = session.update(Command::End);
        go(&mut session, Command::Focus(own));
        assert_eq!(session.step(), step);
        assert!(session.question_at(asked));
    }
}

#[test]
fn the_polygon_under_a_pixel_is_found() {
    let mut session = session("gouraud-teapot");
    let [width, height] = session.lesson().size;
    go(
        &mut session,
        Command::FocusOnPolygonAt {
            x: width / 2,
            y: height / 2,
        },
    );
    assert!(matches!(session.focus(), Focus::Polygon(_)));
    assert_eq!(
        session.update(Command::FocusOnPolygonAt { x: 0, y: 0 }),
        Err(strings::NOTHING_DRAWN_THERE.into())
    );
    go(
        &mut session,
        Command::Hover(Some(Tag::Pixel {
            x: width / 2,
            y: height / 2,
        })),
    );
    go(&mut session, Command::FocusOnPointer);
    assert_eq!(
        session.focus(),
        Focus::Pixel {
            x: width / 2,
            y: height / 2
        }
    );
    assert_eq!(session.walk().kind(session.step()), "PixelColored");
}

#[test]
fn clicks_go_there_or_light_up() {
    let mut session = triangle();
    go(&mut session, Command::Click(Tag::Step(7)));
    assert_eq!(session.step(), 7);
    go(&mut session, Command::Click(Tag::Edge(1)));
    assert_eq!((session.lit(), session.step()), (Some(Tag::Edge(1)), 7));
    go(&mut session, Command::Click(Tag::Edge(1)));
    assert_eq!(session.lit(), None);
    let line = session.walk().line(session.step()).number;
    go(&mut session, Command::Click(Tag::Line(line)));
    assert!(session.step() != 7 && session.walk().line(session.step()).number == line);
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
    assert!(matches!(
        session.update(Command::Find("y=".into())),
        Err(Refused::Error(_))
    ));
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
    let prepared = &session.open.prepared;
    let rendered = render(
        prepared,
        session.lesson().method,
        NonZeroUsize::MIN,
        &|_, _| {},
    );
    assert!(session.show().finished.picture == rendered);
}

#[test]
fn a_picture_of_the_lesson_before_never_shows() {
    let mut session = session("gouraud-teapot");
    for id in ["gouraud-triangle", "gouraud-teapot", "gouraud-triangle"] {
        go(&mut session, Command::Open(id.into()));
        session.take_picture();
        let [width, height] = session.lesson().size;
        let finished = &session.show().finished.picture;
        assert_eq!([finished.width, finished.rows.end], [width, height]);
    }
    session.wait_for_picture();
    let mut alone = self::session("gouraud-triangle");
    alone.wait_for_picture();
    assert!(session.show().finished.picture == alone.show().finished.picture);
}
