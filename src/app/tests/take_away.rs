//! Files that are taken away of what is shown.

use super::*;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::app::opened::{Opened, Readers};
use crate::export::{ExportedLesson, TakeAway};
use crate::lesson::Change;
use crate::methods::Method;
use crate::scene::{Limits, read};
use egui::OutputCommand;
use std::cell::RefCell;
use std::num::NonZeroUsize;
use std::path::PathBuf;

thread_local! {
    static WRITTEN: RefCell<Vec<(PathBuf, Vec<u8>)>> = const { RefCell::new(Vec::new()) };
}

const READERS: Readers = Readers {
    document: |_| Err("no document".into()),
    folder: |_| Err("no folder".into()),
    picture: |_| Err("no picture".into()),
    text: |_| Err("no text".into()),
    scene: |_, _| Err(Vec::new()),
    lesson: |_, _| Err(Vec::new()),
    write: |path, bytes| {
        WRITTEN.with_borrow_mut(|written| written.push((path.to_owned(), bytes.to_vec())));
        Ok(())
    },
    choose: |_| Ok(None),
};

fn own_scene() -> Lesson {
    let text = br#"{ "schema": 1,
        "camera": { "eye": [0, 0, 6], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
        "materials": { "lamp": { "emission": [1, 1, 1] }, "wall": { "reflectance": [0.5, 0.5, 0.5] } },
        "objects": [
          { "name": "floor", "material": "wall", "polygon": { "vertices": [[-1,-1,1],[1,-1,1],[1,-1,-1],[-1,-1,-1]] }, "patches": [2, 2] },
          { "name": "light", "material": "lamp", "polygon": { "vertices": [[-1,1,-1],[1,1,-1],[1,1,1],[-1,1,1]] } } ] }"#;
    let scene = read(text, &Limits::default(), &mut |_| unreachable!()).unwrap();
    let prepared = PreparedScene::of_size(scene, [48, 36]).unwrap();
    Lesson::of_scene("my room.json", prepared).of_size([48, 36])
}

fn with_files(mut screen: Screen) -> Screen {
    screen.harness.state_mut().1.opened = Some(Opened::new(READERS, None));
    screen
}

impl Screen {
    /// Gives the command, and waits for the end of what it makes. Returns what is then said.
    fn take(&mut self, what: TakeAway, ending: &'static str) -> String {
        let command = Command::TakeAway(what, ending);
        self.session_mut().update(command).unwrap();
        self.harness.step();
        while !self.harness.state().1.taking.is_empty() {
            self.harness.step();
            std::thread::yield_now();
        }
        self.harness.state().1.notice.clone().expect("a notice")
    }
}

/// The bytes that every file of its kind begins with.
fn beginning(ending: &str) -> &'static [u8] {
    match ending {
        "html" => b"<",
        "png" => b"\x89PNG",
        "gif" => b"GIF89a",
        "svg" => b"<svg",
        "pfm" => b"PF\n",
        "jsonl" => b"{\"step\":0,",
        "csv" => b"",
        "npy" => b"\x93NUMPY",
        _ => panic!("{ending}"),
    }
}

#[test]
fn all_of_the_list_is_made_of_an_own_scene_and_saved_under_its_name() {
    let mut screen = with_files(screen_of(own_scene(), [1280, 800], 1.0, []));
    assert_eq!(screen.session().lesson().method, Method::Radiosity);
    screen.session_mut().file = Some("rooms/box.json".into());
    let mut names = Vec::new();
    for what in TakeAway::ALL {
        for ending in what.endings() {
            let notice = screen.take(what, ending);
            let (path, bytes) = WRITTEN.with_borrow_mut(Vec::pop).expect(&notice);
            assert!(bytes.starts_with(beginning(ending)), "{path:?}");
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            assert!(notice.contains(&name), "{notice}");
            names.push(name);
        }
    }
    let panel = format!("box-{}-0", screen.session().key_panel().unwrap().name());
    let expected = [
        "box-handout-en.html",
        "box-slides-en.html",
        "box-explanations-en.png",
        "box-explanations-en.gif",
        "box-convergence.png",
        "box-convergence.gif",
        &format!("{panel}.png"),
        &format!("{panel}.svg"),
        "box-picture.png",
        "box-picture.pfm",
        "box-steps.jsonl",
        "box-steps.csv",
        "box-radiosity.csv",
        "box-radiosity.npy",
        "box-system.csv",
        "box-system.npy",
    ];
    assert_eq!(names, expected);
}

#[test]
fn a_lesson_is_taken_away_as_its_own_run_has_it() {
    let mut session = triangle([Command::Seek(9), Command::Speak(Language::Indonesian)]);
    let session = session.session_mut();
    let open = builtin("gouraud-triangle").unwrap().read().unwrap();
    let panels = open.panels.clone();
    for (what, ending) in [
        (TakeAway::Handout, "html"),
        (TakeAway::Slides, "html"),
        (TakeAway::Picture, "pfm"),
        (TakeAway::Steps, "csv"),
    ] {
        let lesson = open.clone().open().unwrap();
        let language = Language::Indonesian;
        let shown = ExportedLesson::new(lesson, &panels, language, NonZeroUsize::MIN, &|_, _| ());
        let made = |(shown, wish)| {
            let mut bytes = Vec::new();
            let making = what.make(ending, shown, wish).unwrap();
            making.write_all(&mut bytes, &|_, _| ()).unwrap();
            bytes
        };
        let (of_session, wish) = session.source(what).run();
        let (_, wish_too) = session.source(what).run();
        assert!(
            made((of_session, wish)) == made((shown, wish_too)),
            "{what:?}"
        );
    }
}

#[test]
fn handouts_are_about_the_steps_with_breakpoints_where_there_are_some() {
    let mut screen = with_files(triangle([]));
    for step in [20, 7] {
        screen.session_mut().update(Command::Questions).ok();
        screen.session_mut().update(Command::Seek(step)).unwrap();
        screen.session_mut().update(Command::Breakpoint).unwrap();
    }
    let places = |screen: &mut Screen| {
        screen.take(TakeAway::Handout, "html");
        let (_, bytes) = WRITTEN.with_borrow_mut(Vec::pop).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        let parts = text.split("class=\"place\">").skip(1);
        let places = parts.map(|place| place.split(" of").next().unwrap().to_owned());
        places.collect::<Vec<_>>()
    };
    assert_eq!(places(&mut screen), ["step 7", "step 20"]);
    // In a scene of one's own there is no other explanation than the step that is shown.
    let mut screen = with_files(screen_of(own_scene(), [1280, 800], 1.0, [Command::Seek(5)]));
    assert_eq!(places(&mut screen), ["step 5"]);
}

#[test]
fn values_that_were_changed_are_those_of_the_file() {
    let mut screen = with_files(screen("illumination-model", [1280, 800], 1.0, []));
    let before = screen.take(TakeAway::Steps, "jsonl");
    let (_, before) = WRITTEN.with_borrow_mut(Vec::pop).expect(&before);
    let session = screen.session_mut();
    let values = session.lesson().parameters.iter();
    let values = values.filter_map(|&parameter| session.value(parameter));
    let mut coefficients = values.filter_map(|change| match change {
        Change::Coefficient {
            material,
            coefficient,
            value,
        } => Some(Change::Coefficient {
            material,
            coefficient,
            value: 0.5 * value,
        }),
        _ => None,
    });
    let change = coefficients.next().expect("a coefficient");
    drop(coefficients);
    session.update(Command::Change(change)).unwrap();
    session.wait_for_picture();
    let notice = screen.take(TakeAway::Steps, "jsonl");
    let (_, after) = WRITTEN.with_borrow_mut(Vec::pop).expect(&notice);
    let walk = screen.session().walk();
    assert_eq!(
        after.iter().filter(|&&byte| byte == b'\n').count(),
        walk.len()
    );
    assert!(after != before, "the file has the values of the lesson");
}

#[test]
fn what_is_called_off_is_not_written_and_that_is_said() {
    let mut screen = with_files(triangle([]));
    let animation = Command::TakeAway(TakeAway::Explanations, "gif");
    screen.session_mut().update(animation).unwrap();
    screen.harness.step();
    screen.harness.step();
    let name = "gouraud-triangle-explanations-en.gif";
    assert!(screen.harness.query_by_label(name).is_some());
    screen.click("Cancel");
    while !screen.harness.state().1.taking.is_empty() {
        screen.harness.step();
        std::thread::yield_now();
    }
    let notice = screen.harness.state().1.notice.clone().unwrap();
    assert_eq!(notice, format!("Cancelled: {name} was not written."));
    assert!(WRITTEN.with_borrow(Vec::is_empty));
}

#[test]
fn what_only_radiosity_has_is_disabled_elsewhere_and_says_why() {
    let screen = triangle([]);
    for what in TakeAway::ALL {
        let command = Command::TakeAway(what, what.endings()[0]);
        let of_radiosity = matches!(
            what,
            TakeAway::Convergence | TakeAway::System | TakeAway::Radiosities
        );
        let allowed = screen.session().allows(&command);
        assert_eq!(allowed.is_err(), of_radiosity, "{what:?}");
    }
}

#[test]
fn the_large_panel_is_copied_as_a_picture() {
    let mut screen = triangle([]);
    screen.session_mut().update(Command::CopyPicture).unwrap();
    screen.harness.step();
    let commands = &screen.harness.output().platform_output.commands;
    let copied = commands.iter().find_map(|command| match command {
        OutputCommand::CopyImage(image) => Some(image),
        _ => None,
    });
    let image = copied.expect("a picture");
    assert_eq!(image.size, [1920, 1200]);
    let different: std::collections::HashSet<_> = image.pixels.iter().collect();
    assert!(different.len() > 50, "{} colours", different.len());
}

#[test]
fn the_menu_has_a_button_for_each_kind_of_file() {
    let mut screen = triangle([]);
    screen.click("More");
    screen.click("Take away");
    for what in TakeAway::ALL {
        for ending in what.endings() {
            let title = screen.session().localize(what.title());
            let name = format!("{title} ({})", ending.to_uppercase());
            assert!(screen.harness.query_by_label(&name).is_some(), "{name}");
        }
    }
}
