use super::*;

#[test]
fn a_question_is_answered_in_its_card() {
    let mut screen = triangle([]);
    let narrated = screen.session().panel_input().narrated.to_vec();
    let asked = narrated
        .into_iter()
        .find(|&step| screen.session().question_at(step))
        .expect("a question");
    screen
        .harness
        .state_mut()
        .0
        .update(Command::End)
        .expect("a way on");
    screen.harness.run();
    assert_eq!(
        screen.session().step(),
        asked,
        "the end lies behind the question"
    );
    screen
        .harness
        .get_by_label(strings::BEFORE_YOU_GO_ON.text(Language::English));
    let answer = screen
        .session()
        .question()
        .expect("a question")
        .0
        .answer
        .clone();
    match answer {
        Answer::Number { value, .. } => {
            screen
                .harness
                .get_by_label(strings::YOUR_ANSWER.text(Language::English))
                .focus();
            screen.harness.run();
            screen.harness.event(egui::Event::Text(value.to_string()));
            screen.press(Modifiers::NONE, Key::Enter);
        }
        Answer::Choice { options, right } => screen.click(&options[right][0]),
        Answer::Pick { names, right, .. } => screen.click(&names[right][0]),
        Answer::Order { .. } | Answer::Arrow { .. } => panic!("see below"),
        Answer::Undecided => panic!("nothing is changed"),
        Answer::Pixel { x, y, .. } => {
            let click = Command::Click(Tag::Pixel { x, y });
            screen
                .harness
                .state_mut()
                .0
                .update(click)
                .expect("an answer");
            screen.harness.run();
        }
    }
    assert_eq!(
        screen.session().question().map(|(_, standing)| standing),
        Some(Standing::Right)
    );
}

#[test]
fn an_answer_that_is_no_number_is_pointed_out_and_can_be_corrected() {
    let mut screen = triangle([Command::Questions]);
    let narrated = screen.session().panel_input().narrated.to_vec();
    screen.session_mut().update(Command::Questions).expect("on");
    let asks_number = |session: &Session| {
        matches!(
            session.question(),
            Some((question, Standing::Open)) if matches!(question.answer, Answer::Number { .. })
        )
    };
    for step in narrated {
        screen.session_mut().start_at(step);
        if asks_number(screen.session()) {
            break;
        }
    }
    screen.harness.run();
    let step = screen.session().step();
    // The field has the keyboard; Escape gives it back to the window.
    screen.press(Modifiers::NONE, Key::Escape);
    screen.press(Modifiers::NONE, Key::L);
    assert_eq!(screen.session().look.language, Language::Indonesian);
    screen.press(Modifiers::NONE, Key::L);
    screen
        .harness
        .get_by_label(strings::YOUR_ANSWER.text(Language::English))
        .focus();
    screen.harness.run();
    screen.harness.event(egui::Event::Text("much".into()));
    screen.press(Modifiers::NONE, Key::Enter);
    screen
        .harness
        .get_by_label(strings::NOT_A_NUMBER.text(Language::English));
    screen.keep("misread");
    screen.press(Modifiers::NONE, Key::L);
    assert_eq!(screen.session().look.language, Language::English);
    screen.press(Modifiers::COMMAND, Key::A);
    screen.harness.event(egui::Event::Text("1e9".into()));
    screen.press(Modifiers::NONE, Key::Enter);
    assert_eq!(screen.session().step(), step);
    screen.harness.get_by_label_contains("That is too large.");
    screen.keep("second-try");
    // The keyboard is still in the field, with what was typed.
    screen.press(Modifiers::COMMAND, Key::A);
    screen.harness.event(egui::Event::Text("-1e9".into()));
    screen.press(Modifiers::NONE, Key::Enter);
    let (question, standing) = screen.session().question().expect("a question");
    let Answer::Number { value, tolerance } = question.answer else {
        panic!("a number is asked for")
    };
    assert_eq!(standing, Standing::Wrong);
    let value = Language::English.number(rounded(value, tolerance));
    let recorded = format!("Not quite. The answer is {value}.");
    screen.harness.get_by_label(&recorded);
    screen.harness.get_by_label("Your answer was −1·10⁹.");
    screen.keep("wrong");
}

/// The window at the first question of that kind, whatever is asked before it.
fn asked(lesson: &str, is: impl Fn(&Answer) -> bool) -> Screen {
    let mut screen = screen(lesson, [1280, 800], 1.0, []);
    let narrated = screen.session().panel_input().narrated.to_vec();
    for step in narrated {
        screen.session_mut().start_at(step);
        let question = screen.session().question();
        if question.is_some_and(|(question, _)| is(&question.answer)) {
            screen.harness.run();
            return screen;
        }
    }
    panic!("{lesson} has no such question")
}

#[test]
fn a_thing_is_chosen_in_the_card_without_a_mouse() {
    let mut screen = asked("shooting", |answer| matches!(answer, Answer::Pick { .. }));
    screen.keep("pick");
    for patch in ["patch 32, right wall (1, 1)", "patch 13, ceiling (0, 0)"] {
        screen.harness.get_by_label(patch).focus();
        screen.harness.run();
        screen.press(Modifiers::NONE, Key::Enter);
    }
    let (_, standing) = screen.session().question().expect("a question");
    assert_eq!(standing, Standing::Right);
    let recorded = "✓ Right. The answer is patch 13, ceiling (0, 0).";
    screen.harness.get_by_label(recorded);
    screen.keep("picked");
}

#[test]
fn items_are_put_in_order_with_the_keyboard() {
    let mut screen = asked("ray-tree", |answer| matches!(answer, Answer::Order { .. }));
    screen.keep("order");
    let (question, _) = screen.session().question().expect("a question");
    let Answer::Order { items, right } = question.answer.clone() else {
        panic!("an order is asked for")
    };
    screen.click(strings::CHECK.text(Language::English));
    let given = Guess::Order((0..items.len()).collect());
    assert_eq!(screen.session().guesses(), [given]);
    screen.keep("order-again");
    // Each item in turn rises to its place; the keyboard stays with it.
    let mut order: Vec<usize> = (0..items.len()).collect();
    for (place, &item) in right.iter().enumerate() {
        let at = order.iter().position(|&other| other == item).expect("once");
        if at == place {
            continue;
        }
        let up = strings::MOVE_UP.format(Language::English, &[("item", &items[item][0])]);
        screen.harness.get_by_label(&up).focus();
        screen.harness.run();
        for _ in place..at {
            screen.press(Modifiers::NONE, Key::Enter);
        }
        order.remove(at);
        order.insert(place, item);
    }
    screen.click(strings::CHECK.text(Language::English));
    assert_eq!(
        screen.session().guesses().last(),
        Some(&Guess::Order(right))
    );
    let (_, standing) = screen.session().question().expect("a question");
    assert_eq!(standing, Standing::Right);
    screen.keep("ordered");
}

#[test]
fn an_arrow_is_turned_with_the_keyboard_or_dragged_in_the_picture() {
    let is_arrow = |answer: &Answer| matches!(answer, Answer::Arrow { .. });
    let mut screen = asked("reflection", is_arrow);
    let degrees = |screen: &Screen| screen.session().arrow_asked().expect("an arrow");
    let (step, start) = (screen.session().step(), degrees(&screen));
    screen.keep("arrow");
    // The slider has the keyboard: the arrow keys turn, and do not walk.
    for key in [Key::ArrowLeft, Key::ArrowLeft, Key::ArrowLeft] {
        screen.press(Modifiers::NONE, key);
    }
    assert_eq!(
        (screen.session().step(), degrees(&screen)),
        (step, start - 3.0)
    );
    screen.press(Modifiers::NONE, Key::Enter);
    assert_eq!(screen.session().guesses(), [Guess::Arrow(start - 3.0)]);
    screen.keep("arrow-again");
    // In the picture it points where the pointer is.
    assert_eq!(screen.session().key_panel(), Some(Panel::Vectors));
    let rect = screen.panel(Panel::Vectors);
    screen.harness.hover_at(rect.center());
    screen.harness.drag_at(rect.center());
    screen.harness.run();
    let above = rect.center_top() + egui::vec2(0.0, 20.0);
    screen.harness.hover_at(above);
    screen.harness.run();
    screen.harness.drop_at(above);
    screen.harness.run();
    let (question, _) = screen.session().question().expect("a question");
    let &Answer::Arrow {
        plane, direction, ..
    } = &question.answer
    else {
        panic!("an arrow is asked for")
    };
    assert!(degrees(&screen).abs() < 20.0, "{}", degrees(&screen));
    // After the mouse the keyboard goes on from there.
    let right = plane.degrees(direction).round();
    let turned = degrees(&screen);
    for _ in 0..(right - turned).round() as usize {
        screen.press(Modifiers::NONE, Key::ArrowRight);
    }
    screen.press(Modifiers::NONE, Key::Enter);
    let (_, standing) = screen.session().question().expect("a question");
    assert_eq!(standing, Standing::Right);
    screen.keep("arrow-answered");
}
