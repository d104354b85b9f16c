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
    screen
        .harness
        .get_by_label("That is too large. Try once more.");
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

#[test]
fn a_thing_is_chosen_in_the_card_without_a_mouse() {
    let mut screen = screen("shooting", [1280, 800], 1.0, []);
    let narrated = screen.session().panel_input().narrated.to_vec();
    let picks = |session: &Session| {
        let question = session.question();
        question.is_some_and(|(question, _)| matches!(question.answer, Answer::Pick { .. }))
    };
    for step in narrated {
        screen.session_mut().start_at(step);
        if picks(screen.session()) {
            break;
        }
    }
    screen.harness.run();
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
