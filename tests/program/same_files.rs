//! What the command line writes is what the window and the page make; and scenes of one's own are taken away as lessons are.

use crate::take_away::refers_only_to_itself;
use crate::{folder, succeeded};
use lightwalk::export::{ExportedLesson, SIZE, TakeAway, Wish};
use lightwalk::language::Language;
use lightwalk::lesson::{OpenLesson, builtin};
use lightwalk::panels::Panel;
use lightwalk::picture::Theme;
use std::fs;
use std::num::NonZeroUsize;
use std::path::Path;

fn open(lesson: &str) -> OpenLesson {
    builtin(lesson).unwrap().read().unwrap().open().unwrap()
}

/// What the window makes of a lesson, with that panel large at step 0.
fn made(lesson: &str, panel: Panel, what: TakeAway, ending: &str) -> Vec<u8> {
    let open = open(lesson);
    let panels = open.lesson.panels.clone();
    let mut shown = ExportedLesson::new(
        open,
        &panels,
        Language::English,
        NonZeroUsize::MIN,
        &|_, _| {},
    );
    let wish = Wish {
        steps: None,
        panel,
        seen: shown.draw(panel, 0, glam::Vec2::from(SIZE.map(|side| side as f32))),
        theme: Theme::Light,
    };
    let mut bytes = Vec::new();
    let making = what.make(ending, shown, wish).unwrap();
    making.write_all(&mut bytes, &|_, _| {}).unwrap();
    bytes
}

#[test]
fn the_command_line_and_the_window_make_the_same_files() {
    let folder = folder();
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("lessons/21-gathering.json");
    fs::copy(source, folder.path().join("gathering.json")).unwrap();
    let lesson = open("gathering").lesson;
    let [width, height] = lesson.size;
    let frames = "frames gathering --step 0 --panel radiosity --size 960x600";
    let solved = "radiosity gathering.json --out";
    let picture = format!("render gathering.json --method radiosity --size {width}x{height} --out");
    for (what, ending, arguments, file) in [
        (
            TakeAway::Handout,
            "html",
            "handout gouraud-triangle --answers --out a.html",
            "a.html",
        ),
        (
            TakeAway::Slides,
            "html",
            "deck gouraud-triangle --out b.html",
            "b.html",
        ),
        (
            TakeAway::Explanations,
            "png",
            "animate gouraud-triangle --out c.png",
            "c.png",
        ),
        (
            TakeAway::Convergence,
            "gif",
            "animate gathering --at Iteration --panel radiosity --out d.gif",
            "d.gif",
        ),
        (
            TakeAway::Panel,
            "png",
            &format!("{frames} --scale 2 --out e"),
            "e/step-000000-radiosity.png",
        ),
        (
            TakeAway::Panel,
            "svg",
            &format!("{frames} --svg --out f"),
            "f/step-000000-radiosity.svg",
        ),
        (
            TakeAway::Picture,
            "png",
            &format!("{picture} g.png"),
            "g.png",
        ),
        (
            TakeAway::Picture,
            "pfm",
            &format!("{picture} h.pfm"),
            "h.pfm",
        ),
        (
            TakeAway::Steps,
            "jsonl",
            "steps gathering --out i.jsonl",
            "i.jsonl",
        ),
        (
            TakeAway::Steps,
            "csv",
            "steps gathering --out j.csv",
            "j.csv",
        ),
        (
            TakeAway::Radiosities,
            "csv",
            &format!("{solved} k.csv"),
            "k.csv",
        ),
        (
            TakeAway::Radiosities,
            "npy",
            &format!("{solved} l.npy"),
            "l.npy",
        ),
        (
            TakeAway::System,
            "csv",
            &format!("{solved} m.json --matrix m.csv"),
            "m.csv",
        ),
        (
            TakeAway::System,
            "npy",
            &format!("{solved} n.json --matrix n.npy"),
            "n.npy",
        ),
    ] {
        succeeded(folder.path(), arguments);
        let of_command = fs::read(folder.path().join(file)).unwrap();
        // Not where measured times are shown, which differ.
        let lesson = match what.has_words() {
            true => "gouraud-triangle",
            false => "gathering",
        };
        let of_window = made(lesson, Panel::Radiosity, what, ending);
        assert!(of_command == of_window, "{arguments}");
    }
}

#[test]
fn a_scene_of_ones_own_is_taken_away_by_the_method_that_is_named() {
    let folder = folder();
    let handout = "handout scene.json --language en --step 3";
    succeeded(folder.path(), &format!("{handout} --out rays.html"));
    succeeded(
        folder.path(),
        &format!("{handout} --method gouraud --out gouraud.html"),
    );
    let [rays, gouraud] = ["rays.html", "gouraud.html"]
        .map(|name| fs::read_to_string(folder.path().join(name)).unwrap());
    for page in [&rays, &gouraud] {
        refers_only_to_itself(page);
        assert!(page.contains("<h1>scene.json</h1>") && page.contains("step 3 of"));
    }
    assert!(rays != gouraud);
    succeeded(
        folder.path(),
        "animate scene.json --steps 0..3 --panel image --size 200x150 --out a.gif",
    );
    assert!(
        fs::read(folder.path().join("a.gif"))
            .unwrap()
            .starts_with(b"GIF89a")
    );
}
