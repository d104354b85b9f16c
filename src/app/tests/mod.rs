//! The whole window, with no screen: keys pressed, buttons clicked, and what is then shown.

mod painter;
mod parameters;
mod ray_tree;
mod skipped;
mod studies;

use super::question_card::rounded;
use super::session::{Command, Session, Standing};
use super::window::{self, Window};
use super::{narration, strings, style};
use crate::algorithms::focus::Focus;
use crate::lesson::{Answer, Lesson, builtin};
use crate::panels::strings::Language;
use crate::picture::{Ink, Tag, Theme, to_png};
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use painter::Textures;

type App = (Session, Window);

struct Screen {
    harness: Harness<'static, App>,
    textures: Textures,
    /// In physical pixels.
    size: [u32; 2],
}

/// The window on a screen of `size` pixels, `scale` of them a point.
fn screen(
    id: &str,
    size: [u32; 2],
    scale: f32,
    commands: impl IntoIterator<Item = Command>,
) -> Screen {
    let lesson = builtin(id)
        .expect("a lesson")
        .read()
        .expect("a right lesson");
    screen_of(lesson, size, scale, commands)
}

fn screen_of(
    lesson: Lesson,
    size: [u32; 2],
    scale: f32,
    commands: impl IntoIterator<Item = Command>,
) -> Screen {
    let mut session = Session::new(lesson).expect("a lesson that resolves");
    for command in commands {
        session.update(command).expect("a command that can act");
    }
    session.wait_for_picture();
    let textures = Textures::default();
    let zoom = session.look.zoom();
    let points = egui::vec2(size[0] as f32, size[1] as f32) / scale / zoom;
    let harness = Harness::builder()
        .with_size(points)
        .with_pixels_per_point(scale)
        .with_max_steps(12)
        .renderer(textures.clone())
        .with_context_setup(|ctx| ctx.set_fonts(style::fonts()))
        .build_ui_state(
            |ui, (session, window): &mut App| window::ui(session, window, ui),
            (session, Window::default()),
        );
    let mut screen = Screen {
        harness,
        textures,
        size,
    };
    screen.harness.input_mut().max_texture_side = Some(1 << 14);
    screen.harness.run();
    screen
}

fn triangle(commands: impl IntoIterator<Item = Command>) -> Screen {
    screen("gouraud-triangle", [1280, 800], 1.0, commands)
}

impl Screen {
    fn session(&self) -> &Session {
        &self.harness.state().0
    }

    fn session_mut(&mut self) -> &mut Session {
        &mut self.harness.state_mut().0
    }

    fn press(&mut self, held: Modifiers, key: Key) {
        self.harness.key_press_modifiers(held, key);
        self.harness.run();
    }

    fn click(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.harness.run();
    }

    fn painted(&self) -> tiny_skia::Pixmap {
        self.textures
            .paint(&self.harness.ctx, self.harness.output(), self.size)
    }

    /// Keeps a PNG of the window under `LIGHTWALK_SCREENSHOTS`, for people to look at.
    fn keep(&self, name: &str) {
        if let Some(folder) = std::env::var_os("LIGHTWALK_SCREENSHOTS") {
            let path = std::path::Path::new(&folder).join(format!("{name}.png"));
            std::fs::write(path, to_png(&self.painted())).expect("a folder that can be written to");
        }
    }
}

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
    assert!(screen.session().said_here().is_some());
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
fn every_input_has_a_name() {
    for commands in [
        vec![],
        vec![Command::Keys],
        vec![Command::NextNarrated, Command::Speak(Language::Indonesian)],
    ] {
        // The harness panics on an input without a name.
        triangle(commands).harness.run();
    }
}

#[test]
fn a_question_is_answered_in_its_card() {
    let mut screen = triangle([]);
    let narrated = screen.session().show().narrated.to_vec();
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
    let narrated = screen.session().show().narrated.to_vec();
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
    let (question, standing) = screen.session().question().expect("a question");
    let Answer::Number { value, tolerance } = question.answer else {
        panic!("a number is asked for")
    };
    assert_eq!(standing, Standing::Wrong);
    let value = Language::English.number(rounded(value, tolerance));
    let recorded = format!("Not quite. The answer is {value}.");
    screen.harness.get_by_label(&recorded);
    screen.keep("wrong");
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
fn the_column_is_as_wide_as_before_after_the_window_was_small() {
    let mut screen = triangle([]);
    let usual = screen.painted();
    screen.harness.hover_at(egui::pos2(349.0, 300.0));
    screen.harness.drag_at(egui::pos2(349.0, 300.0));
    screen.harness.run();
    screen.harness.hover_at(egui::pos2(449.0, 300.0));
    screen.harness.run();
    screen.harness.drop_at(egui::pos2(449.0, 300.0));
    screen.harness.remove_cursor();
    screen.harness.run();
    let chosen = screen.painted();
    assert!(usual != chosen);
    screen.keep("wide-column");
    for size in [[700.0, 500.0], [1280.0, 800.0]] {
        screen.harness.set_size(size.into());
        screen.harness.run();
    }
    assert!(screen.painted() == chosen);
}

#[test]
fn an_index_stands_low_and_the_space_after_it_stays() {
    let screen = triangle([]);
    let job = narration::prose(screen.session(), "I_P incremental", 14.0, Ink::Text);
    let galley = screen.harness.ctx.fonts_mut(|fonts| fonts.layout_job(job));
    let glyphs = &galley.rows[0].glyphs;
    let place = |index: usize| (glyphs[index].chr, glyphs[index].pos.y);
    let ((i, base), (p, low), (space, _)) = (place(0), place(1), place(2));
    assert_eq!([i, p, space], ['I', 'P', ' ']);
    assert!(low > base + 1.0, "{low} below {base}");
    assert!(glyphs[3].pos.x - glyphs[2].pos.x > 3.0, "a whole space");
}

#[test]
fn the_title_of_the_window_tells_the_step() {
    let mut screen = triangle([]);
    screen.press(Modifiers::NONE, Key::ArrowRight);
    let last = screen.session().last_step();
    let title = screen.session().window_title();
    assert!(
        title.starts_with("Lightwalk") && title.ends_with(&format!("step 1 of {last}")),
        "{title}"
    );
}

/// Everything that the window looks like, in one loop; what is drawn must fill the screen and differ from theme to theme.
#[test]
fn the_window_can_be_painted_at_every_size() {
    let far = |questions: bool| {
        let mut commands = vec![Command::Questions; usize::from(questions)];
        commands.extend(vec![Command::NextNarrated; 5]);
        commands
    };
    let mut kept = Vec::new();
    for (lesson, name, size, scale, theme, language, commands) in [
        (
            "gouraud-triangle",
            "light",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            far(true),
        ),
        (
            "gouraud-triangle",
            "question",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            vec![Command::End],
        ),
        (
            "gouraud-triangle",
            "plain-step",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::Indonesian,
            vec![Command::Forward(3)],
        ),
        (
            "gouraud-teapot",
            "dark",
            [1280, 800],
            1.0,
            Theme::Dark,
            Language::Indonesian,
            far(true),
        ),
        (
            "gouraud-teapot",
            "pixel",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            vec![Command::Focus(Focus::Pixel { x: 320, y: 240 })],
        ),
        (
            "gouraud-triangle",
            "projector",
            [1280, 800],
            1.0,
            Theme::Projector,
            Language::English,
            far(true),
        ),
        (
            "gouraud-triangle",
            "large",
            [1920, 1080],
            1.0,
            Theme::Light,
            Language::English,
            far(true),
        ),
        (
            "gouraud-teapot",
            "projector-large",
            [1920, 1080],
            1.0,
            Theme::Projector,
            Language::Indonesian,
            far(true),
        ),
        (
            "gouraud-triangle",
            "fine",
            [2560, 1600],
            2.0,
            Theme::Dark,
            Language::English,
            far(true),
        ),
        (
            "gouraud-triangle",
            "keys",
            [1280, 800],
            1.0,
            Theme::Light,
            Language::English,
            vec![Command::Keys],
        ),
        (
            "gouraud-triangle",
            "small",
            [720, 480],
            1.0,
            Theme::Light,
            Language::English,
            far(true),
        ),
    ] {
        let looks = [Command::Theme(theme), Command::Speak(language)];
        let screen = screen(lesson, size, scale, looks.into_iter().chain(commands));
        screen.keep(name);
        if size == [1280, 800] {
            let pixmap = screen.painted();
            // The harness leaves up to 10 pixels free on each side.
            let mut inside = (10..790).flat_map(|y| (10..1270).map(move |x| (x, y)));
            assert!(
                inside.all(|(x, y)| pixmap.pixel(x, y).is_some_and(|pixel| pixel.alpha() == 255)),
                "{name}"
            );
            assert!(!kept.contains(&pixmap), "{name}");
            kept.push(pixmap);
        }
    }
}
