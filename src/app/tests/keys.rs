use super::*;
use crate::app::keys::BINDINGS;

#[test]
fn keys_walk_through_the_run() {
    let mut screen = triangle([]);
    for (held, key, step) in [
        (Modifiers::NONE, Key::ArrowRight, 1),
        (Modifiers::NONE, Key::ArrowDown, 2),
        (Modifiers::NONE, Key::ArrowLeft, 1),
        (Modifiers::NONE, Key::Home, 0),
    ] {
        screen.press(held, key);
        assert_eq!(screen.session().step(), step, "{key:?}");
    }
    screen.press(Modifiers::NONE, Key::N);
    assert!(screen.session().narration_here().is_some());
}

#[test]
fn letters_typed_into_the_search_are_no_commands() {
    let mut screen = triangle([]);
    screen.press(Modifiers::NONE, Key::Slash);
    screen.harness.event(egui::Event::Text("ScanLine".into()));
    screen.press(Modifiers::NONE, Key::L);
    assert_eq!(screen.session().look.language, Language::English);
    screen.press(Modifiers::NONE, Key::Enter);
    let session = screen.session();
    let arrived =
        session.walk().kind(session.step()) == "ScanLine" || session.question_at(session.step());
    assert!(arrived, "{}", session.walk().kind(session.step()));
}

#[test]
fn a_focused_button_keeps_its_space() {
    let mut screen = triangle([]);
    screen
        .harness
        .get_by_label(strings::ONE_ON.text(Language::English))
        .focus();
    screen.harness.run();
    screen.press(Modifiers::NONE, Key::Space);
    assert_eq!(
        (screen.session().step(), screen.session().playing()),
        (1, None)
    );
    screen.press(Modifiers::NONE, Key::ArrowRight);
    assert_eq!(screen.session().step(), 2, "arrows walk all the same");
    screen.press(Modifiers::NONE, Key::Space);
    assert_eq!(
        screen.session().step(),
        3,
        "and the focus stays where it was"
    );
}

#[test]
fn buttons_do_what_their_keys_do() {
    let mut screen = triangle([]);
    screen.click("one event on");
    assert_eq!(screen.session().step(), 1);
    screen.click("first step");
    assert_eq!(screen.session().step(), 0);
    screen.click("ID");
    assert_eq!(screen.session().look.language, Language::Indonesian);
    screen.click(strings::KEYS.text(Language::Indonesian));
    assert!(screen.session().look.keys);
    screen.press(Modifiers::NONE, Key::F1);
    assert!(!screen.session().look.keys);
}

#[test]
fn escape_ends_the_presentation() {
    let mut screen = triangle([Command::Present]);
    screen.press(Modifiers::NONE, Key::Escape);
    assert!(!screen.session().look.presenting);
    screen.press(Modifiers::NONE, Key::Escape);
    assert!(!screen.session().look.presenting);
}

#[test]
fn an_open_menu_leaves_keys_their_meaning_and_closes() {
    let mut screen = triangle([]);
    let loop_off = format!("{} ▾", strings::LOOP_OFF.text(Language::English));
    let open = |screen: &Screen| egui::Popup::is_any_open(&screen.harness.ctx);
    screen.click(&loop_off);
    assert!(open(&screen));
    screen.press(Modifiers::NONE, Key::ArrowRight);
    assert_eq!((screen.session().step(), open(&screen)), (1, false));
    for seconds in [0.1, 2.0] {
        screen.click(&loop_off);
        assert!(open(&screen));
        screen.harness.drag_at(egui::pos2(1000.0, 620.0));
        screen.harness.step();
        screen.harness.input_mut().time = Some(screen.harness.ctx.input(|i| i.time) + seconds);
        screen.harness.drop_at(egui::pos2(1000.0, 620.0));
        screen.harness.run();
        assert!(!open(&screen), "after a click of {seconds} s");
    }
}

#[test]
fn a_number_a_title_and_the_lesson_choose_the_key_panel() {
    let mut screen = triangle([]);
    let panels = screen.session().panels().to_vec();
    screen.press(Modifiers::NONE, Key::Num2);
    assert_eq!(screen.session().key_panel(), Some(panels[1]));
    let title = panels[2].title().text(Language::English);
    let enlarge = strings::ENLARGE.format(Language::English, &[("panel", title)]);
    screen.click(&enlarge);
    assert_eq!(screen.session().key_panel(), Some(panels[2]));
    assert!(!screen.session().other_panels().contains(&panels[2]));
    screen.press(Modifiers::NONE, Key::Num9);
    assert_eq!(screen.session().key_panel(), Some(panels[2]));
    screen
        .harness
        .get_by_label(strings::NO_SUCH_PANEL.text(Language::English));
}

#[test]
fn the_key_panel_fills_the_window_until_escape() {
    let mut screen = triangle([]);
    let before = screen.panel(Panel::Image);
    screen.press(Modifiers::NONE, Key::Z);
    let filled = screen.panel(Panel::Image);
    assert!(filled.area() > 0.85 * 1280.0 * 800.0, "{filled}");
    screen.press(Modifiers::NONE, Key::Escape);
    assert_eq!(screen.panel(Panel::Image), before);
}

#[test]
fn no_key_means_two_things() {
    for (index, binding) in BINDINGS.iter().enumerate() {
        for held in [Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND] {
            let others = BINDINGS[index + 1..].iter();
            let doubled = others
                .filter(|_| binding.is_pressed(binding.key, held))
                .filter(|other| other.is_pressed(binding.key, held));
            assert_eq!(doubled.count(), 0, "{}", binding.shown);
        }
    }
}
