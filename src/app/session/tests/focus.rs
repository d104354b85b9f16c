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
        panic!("a pixel has its place")
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
fn a_click_selects_and_leaves_the_step_where_it_is() {
    let mut session = triangle();
    go(&mut session, Command::End);
    let end = session.step();
    go(&mut session, Command::Click(Tag::Step(7)));
    assert_eq!((session.step(), session.selected_step()), (end, Some(7)));
    assert!(
        session.lit().contains(&Tag::Scope(7)),
        "wherever the step is shown"
    );
    go(&mut session, Command::Click(Tag::Step(7)));
    assert_eq!((session.selected(), session.lit()), (None, Vec::new()));
    go(&mut session, Command::Go(Tag::Step(7)));
    assert_eq!(session.step(), 7);
    // A line of the pseudocode says which step comes next.
    let line = session.walk().line(session.step()).number;
    go(&mut session, Command::Click(Tag::Line(line)));
    assert!(session.step() != 7 && session.walk().line(session.step()).number == line);
}

#[test]
fn the_step_of_a_thing_is_the_last_one_about_it_so_far() {
    let mut session = triangle();
    let about = |session: &Session, step: usize| {
        session.walk().own_fields(step).get("edge") == Some(Value::Integer(1))
    };
    let steps: Vec<usize> = (0..=session.last_step())
        .filter(|&step| about(&session, step))
        .collect();
    go(&mut session, Command::Seek(steps[0]));
    go(&mut session, Command::Click(Tag::Edge(1)));
    assert_eq!(session.selected_step(), Some(steps[0]));
    // It stays selected while one walks on.
    go(&mut session, Command::Seek(steps[2] + 1));
    let newest = steps.iter().copied().rfind(|&step| step <= session.step());
    assert_eq!(
        (session.selected(), session.selected_step()),
        (Some(Tag::Edge(1)), newest)
    );
    // Before the first, there is none to show, but one to go to.
    go(&mut session, Command::Start);
    assert_eq!(
        (session.selected(), session.selected_step()),
        (Some(Tag::Edge(1)), None)
    );
    go(&mut session, Command::Go(Tag::Edge(1)));
    assert_eq!(session.step(), steps[0]);
}

#[test]
fn a_pixel_lights_up_with_the_step_that_coloured_it() {
    let mut session = triangle();
    go(&mut session, Command::End);
    let kind = |step: usize| session.walk().kind(step) == "PixelColored";
    let colored = (0..=session.last_step())
        .find(|&step| kind(step))
        .expect("a pixel");
    let fields = session.walk().fields(colored);
    let number = |name: &str| match fields.get(name) {
        Some(Value::Integer(number)) => number as u32,
        other => panic!("{name}: {other:?}"),
    };
    let pixel = Tag::Pixel {
        x: number("x"),
        y: number("y"),
    };
    let (step, focus) = (session.step(), session.focus());
    go(&mut session, Command::Click(pixel));
    assert_eq!((session.step(), session.focus()), (step, focus));
    assert_eq!(session.selected_step(), Some(colored));
    assert!(session.lit().contains(&Tag::Step(colored)));
    let size = glam::vec2(500.0, 600.0);
    let drawn = draw(Panel::Inspector, &session.panel_input(), size);
    assert!(
        drawn.tagged_bounds(Tag::Step(colored)).is_some(),
        "its values stand in the inspector"
    );
    go(&mut session, Command::Go(pixel));
    assert_ne!(session.focus(), focus, "the second action looks at it");
}

#[test]
fn a_matrix_cell_lights_up_with_its_patches() {
    let mut session = session("gathering");
    session.update(Command::Questions).expect("a switch");
    go(&mut session, Command::End);
    let step = session.step();
    go(&mut session, Command::Click(Tag::FormFactor { i: 0, j: 3 }));
    for tag in [Tag::FormFactor { i: 0, j: 3 }, Tag::Patch(0), Tag::Patch(3)] {
        assert!(session.lit().contains(&tag), "{tag:?}");
    }
    let about = session.selected_step().expect("an exchange");
    let fields = session.walk().fields(about);
    let both = ["i", "j"].map(|name| fields.get(name));
    assert_eq!(both, [0, 3].map(|number| Some(Value::Integer(number))));
    assert_eq!(session.step(), step);
}

#[test]
fn two_patches_make_a_pair_whose_form_factor_is_found_step_by_step() {
    let mut session = session("gathering");
    let own = session.lesson().focus;
    go(&mut session, Command::Click(Tag::Patch(0)));
    assert_eq!(
        (session.selected(), session.pair()),
        (Some(Tag::Patch(0)), None)
    );
    go(&mut session, Command::Click(Tag::Patch(3)));
    assert_eq!(session.pair(), Some([0, 3]));
    let follow = session.step_by_step().expect("a pair");
    assert!(!session.panels().contains(&Panel::FormFactor));
    assert_eq!(session.allows(&follow), Ok(()));
    go(&mut session, follow.clone());
    assert_eq!(session.key_panel(), Some(Panel::FormFactor));
    let walk = session.walk();
    let mut kinds = (0..walk.len()).map(|step| walk.kind(step));
    assert!(kinds.any(|kind| kind == "FormFactorFound"));
    assert_eq!(
        session.allows(&follow),
        Err(strings::FOLLOWED_ALREADY.into())
    );
    go(&mut session, Command::Focus(own));
    assert!(!session.panels().contains(&Panel::FormFactor));
    assert_ne!(session.key_panel(), Some(Panel::FormFactor));
    // A third patch begins anew.
    go(&mut session, Command::Click(Tag::Patch(5)));
    assert_eq!(
        (session.selected(), session.pair()),
        (Some(Tag::Patch(5)), None)
    );
}

#[test]
fn while_a_question_waits_no_form_factor_is_followed() {
    let mut session = session("gathering");
    go(&mut session, Command::End);
    assert!(session.question_at(session.step()));
    go(&mut session, Command::Click(Tag::FormFactor { i: 0, j: 3 }));
    let follow = session.step_by_step().expect("a pair");
    assert_eq!(session.allows(&follow), Err(strings::ANSWER_FIRST.into()));
}

#[test]
fn a_pixel_of_a_room_selects_the_patch_that_it_shows() {
    let mut session = session("shooting");
    let view = session.prepared().view;
    let room = session.setup().enclosure().expect("a room").clone();
    let mut found = 0;
    for (number, patch) in room.patches.iter().enumerate() {
        let at = view.to_screen(view.to_camera(patch.center));
        let (x, y) = (at.x as u32, at.y as u32);
        let inside = at.cmpge(glam::DVec2::ZERO).all() && x < view.width && y < view.height;
        if !inside || patch.normal.dot(view.eye - patch.center) <= 0.0 {
            continue;
        }
        go(&mut session, Command::Click(Tag::Pixel { x, y }));
        let Some(Tag::Patch(shown)) = session.selected() else {
            panic!("a patch is shown at {at}");
        };
        // Itself, or one that stands before it.
        let distance = |patch: usize| room.patches[patch].center.distance(view.eye);
        assert!(
            shown == number || distance(shown) < distance(number),
            "{shown} at {number}"
        );
        found += usize::from(shown == number);
        go(&mut session, Command::Click(Tag::Patch(shown)));
    }
    assert!(found > 5, "{found}");
}
