use super::*;

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
        assert!(session.recording() > recording && session.explanation().is_none());
    }
    let own = session.lesson().focus;
    go(&mut session, Command::Focus(own));
    assert_eq!((session.step(), place(&session)), (step, here));
    assert!(session.explanation().is_some());
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
