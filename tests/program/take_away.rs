//! What one takes away of a lesson: pictures, handouts, slides and animations.

use crate::markup::elements;
use crate::{command, files, folder, lightwalk, refused, succeeded};
use lightwalk::export::ExportedLesson;
use lightwalk::language::Language;
use lightwalk::lesson::{OpenLesson, builtin};
use lightwalk::picture::{Shape, Theme, to_svg};
use std::collections::BTreeSet;
use std::fs;
use std::num::NonZeroUsize;
use std::path::Path;

fn open(lesson: &str) -> OpenLesson {
    builtin(lesson).unwrap().read().unwrap().open().unwrap()
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

/// Width and height of a PNG.
fn size(folder: &Path, name: &str) -> [u32; 2] {
    let file = fs::File::open(folder.join(name)).unwrap();
    let reader = png::Decoder::new(std::io::BufReader::new(file))
        .read_info()
        .unwrap();
    [reader.info().width, reader.info().height]
}

#[test]
fn an_svg_has_one_shape_an_item() {
    for lesson in ["gouraud-triangle", "ray-tree", "gathering"] {
        let open = open(lesson);
        let panels = open.lesson.panels.clone();
        let mut shown = ExportedLesson::new(
            open,
            &panels,
            Language::Indonesian,
            NonZeroUsize::MIN,
            &|_, _| {},
        );
        let step = shown.narrated()[4];
        for panel in panels {
            let picture = shown.draw(panel, step, glam::Vec2::new(500.0, 400.0));
            let svg = to_svg(&picture, panel.name(), Theme::Light);
            let elements = elements(&svg);
            let count = |name: &str| elements.iter().filter(|element| **element == name).count();
            let items = |is: fn(&Shape) -> bool| {
                picture.items.iter().filter(|item| is(&item.shape)).count()
            };
            let what = format!("{lesson}, {}", panel.name());
            let rects = count("rect") - count("clipPath");
            assert_eq!(
                rects,
                items(|shape| matches!(shape, Shape::Rect { .. })),
                "{what}"
            );
            for (name, expected) in [
                (
                    "polyline",
                    items(|shape| matches!(shape, Shape::Polyline { .. })),
                ),
                (
                    "polygon",
                    items(|shape| matches!(shape, Shape::Polygon { .. })),
                ),
                (
                    "circle",
                    items(|shape| matches!(shape, Shape::Circle { .. })),
                ),
                ("text", items(|shape| matches!(shape, Shape::Text { .. }))),
                ("image", items(|shape| matches!(shape, Shape::Image { .. }))),
                ("title", 1),
                ("desc", 1),
            ] {
                assert_eq!(count(name), expected, "{name} in {what}");
            }
        }
    }
}

#[test]
fn frames_come_in_languages_themes_and_sizes() {
    let folder = folder();
    let frames = "frames gouraud-triangle --steps 2..4 --panel image --size 300x200";
    succeeded(
        folder.path(),
        &format!("{frames} --scale 2.5 --theme projector --out large"),
    );
    let names = ["step-000002-image.png", "step-000003-image.png"];
    let large = folder.path().join("large");
    assert_eq!(files(&large), names);
    assert_eq!(size(&large, names[0]), [750, 500]);
    succeeded(
        folder.path(),
        &format!("{frames} --svg --language id --theme dark --out svg"),
    );
    let svg = read(&folder.path().join("svg"), "step-000003-image.svg");
    assert!(
        svg.contains("fokus: poligon 0") && svg.contains("#1e2327"),
        "{svg}"
    );
}

/// What a page of HTML may refer to stands in the page.
pub fn refers_only_to_itself(page: &str) {
    for outside in ["://", "src=", "<link", "<script", "@import"] {
        assert!(!page.contains(outside), "{outside}");
    }
    for reference in page.split("href=\"").skip(1) {
        assert!(reference.starts_with("data:") || reference.starts_with('#'));
    }
    for reference in page.split("url(").skip(1) {
        assert!(reference.starts_with('#'));
    }
    let ids: Vec<&str> = page
        .split(" id=\"")
        .skip(1)
        .filter_map(|rest| rest.split('"').next())
        .collect();
    let different: BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(ids.len(), different.len(), "an id stands for two things");
}

#[test]
fn a_handout_is_one_page_with_everything_in_it() {
    let folder = folder();
    for (lesson, language) in [("gathering", "id"), ("refraction", "en")] {
        let made = format!("handout {lesson} --language {language} --out h.html");
        succeeded(folder.path(), &made);
        let page = read(folder.path(), "h.html");
        let elements = elements(&page);
        let count = |name: &str| elements.iter().filter(|element| **element == name).count();
        refers_only_to_itself(&page);
        assert!(page.contains(&format!("<html lang=\"{language}\">")));
        let open = open(lesson);
        assert_eq!(page.matches("class=\"step\"").count(), open.narrated.len());
        assert!(count("svg") >= open.narrated.len());
        assert_eq!(count("svg"), count("desc"), "every picture has its words");
        assert!(!page.contains("<desc></desc>"));
        let questions = open
            .narrated
            .iter()
            .filter(|narrated| narrated.question.is_some());
        assert_eq!(
            page.matches("class=\"question\"").count(),
            questions.count()
        );
        for of_print in ["@page", "break-inside: avoid"] {
            assert!(page.contains(of_print));
        }
    }
}

#[test]
fn a_handout_writes_numbers_as_its_language_does() {
    let folder = folder();
    let narrated = |language: &str| {
        let made = format!("handout gathering --language {language} --step 531 --out h.html");
        succeeded(folder.path(), &made);
        read(folder.path(), "h.html")
    };
    let (english, indonesian) = (narrated("en"), narrated("id"));
    assert!(english.contains("0.0242") && !english.contains("0,0242"));
    assert!(indonesian.contains("0,0242") && !indonesian.contains("0.0242"));
}

#[test]
fn answers_stand_on_the_last_page_and_only_if_asked_for() {
    let folder = folder();
    let open = open("gathering");
    let questions = || {
        open.narrated
            .iter()
            .filter_map(|narrated| narrated.question.as_ref())
    };
    succeeded(folder.path(), "handout gathering --out without.html");
    succeeded(folder.path(), "handout gathering --answers --out with.html");
    let [without, with] = ["without.html", "with.html"].map(|name| read(folder.path(), name));
    assert!(!without.contains("class=\"answers\""));
    let (before, last) = with.split_once("<section class=\"answers\">").unwrap();
    assert_eq!(last.matches("<section").count(), 0);
    assert_eq!(last.matches("<h3>").count(), questions().count());
    for question in questions() {
        let answer = question.answer.in_words(Language::English);
        let first = answer.lines().next().unwrap().split('_').next().unwrap();
        assert!(last.contains(first), "{first} is not in {last}");
    }
    assert!(
        before.contains("after your answer"),
        "the pictures wait, too"
    );
}

#[test]
fn steps_that_were_pinned_are_reported_by_themselves() {
    let folder = folder();
    let made = "handout gouraud-triangle --step 20 --step 7 --step 20 --out h.html";
    succeeded(folder.path(), made);
    let page = read(folder.path(), "h.html");
    let places: Vec<&str> = page.split("class=\"place\">").skip(1).collect();
    assert_eq!(places.len(), 2);
    assert!(places[0].starts_with("step 7 of") && places[1].starts_with("step 20 of"));
}

#[test]
fn slides_are_sections_alone() {
    let folder = folder();
    succeeded(
        folder.path(),
        "deck ray-tree --theme projector --language id --out d.html",
    );
    let deck = read(folder.path(), "d.html");
    let elements = elements(&deck);
    refers_only_to_itself(&deck);
    let open = open("ray-tree");
    let questions = open
        .narrated
        .iter()
        .filter(|narrated| narrated.question.is_some());
    // A title and a recap.
    let expected = open.narrated.len() + questions.count() + 2;
    assert_eq!(
        elements.iter().filter(|name| **name == "section").count(),
        expected
    );
    assert!(!elements.contains(&"html"));
    let lines = deck.lines().filter(|line| line.starts_with("<section"));
    assert!(
        lines.clone().count() == expected && lines.clone().all(|line| line.contains("lang=\"id\""))
    );
}

/// Of each frame of an APNG, for how many milliseconds it is shown.
fn delays(folder: &Path, name: &str) -> Vec<u32> {
    let file = fs::File::open(folder.join(name)).unwrap();
    let mut reader = png::Decoder::new(std::io::BufReader::new(file))
        .read_info()
        .unwrap();
    let frames = reader.info().animation_control.unwrap().num_frames;
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let mut delays = Vec::new();
    for _ in 0..frames {
        reader.next_frame(&mut bytes).unwrap();
        let control = reader.info().frame_control.unwrap();
        delays.push(u32::from(control.delay_num) * 1000 / u32::from(control.delay_den));
    }
    delays
}

#[test]
fn explanations_are_animated_at_the_pace_of_a_reader() {
    let folder = folder();
    succeeded(folder.path(), "animate illumination-model --out a.png");
    assert_eq!(size(folder.path(), "a.png"), [960, 600]);
    assert!(fs::metadata(folder.path().join("a.png")).unwrap().len() < 10_000_000);
    let open = open("illumination-model");
    let delays = delays(folder.path(), "a.png");
    assert_eq!(delays.len(), open.narrated.len());
    for (narrated, delay) in open.narrated.iter().zip(delays) {
        let words = narrated.text(Language::English).split_whitespace().count() as u32;
        assert!(delay >= 2000 + 300 * words, "{words} words in {delay} ms");
    }
}

#[test]
fn a_range_of_steps_and_iterations_are_animated() {
    let folder = folder();
    let animate = "animate gathering --size 200x150 --panel radiosity";
    succeeded(
        folder.path(),
        &format!("{animate} --steps 3..8 --fps 4 --out range.png"),
    );
    assert_eq!(
        delays(folder.path(), "range.png"),
        [250, 250, 250, 250, 2000]
    );
    succeeded(
        folder.path(),
        &format!("{animate} --at Iteration --out light.gif"),
    );
    let file = fs::read(folder.path().join("light.gif")).unwrap();
    let mut decoder = gif::DecodeOptions::new().read_info(&file[..]).unwrap();
    assert_eq!([decoder.width(), decoder.height()], [200, 150]);
    let mut frames = 0;
    while decoder.next_frame_info().unwrap().is_some() {
        frames += 1;
    }
    let open = open("gathering");
    let walk = open.run.walk();
    let iterations = (0..walk.len()).filter(|&step| walk.kind(step) == "Iteration");
    assert_eq!(frames, iterations.count());
}

#[test]
fn what_cannot_be_taken_away_is_reported() {
    let folder = folder();
    for (arguments, said) in [
        ("deck refraction --method flat --out d.html", "own method"),
        (
            "handout refractoin --out h.html",
            "did you mean refraction?",
        ),
        ("handout refraction --out h.pdf", "the name ends in .html"),
        (
            "handout refraction --language fr --out h.html",
            "possible values: en, id",
        ),
        (
            "handout refraction --step 99999999 --out h.html",
            "--step 99999999: the lesson has",
        ),
        (
            "handout refraction --steps 1..2 --step 3 --out h.html",
            "cannot be used with",
        ),
        (
            "handout gouraud-teapot --steps 0..600 --out h.html",
            "600 steps are too many for one file",
        ),
        (
            "deck refraction --out none/d.html",
            "its folder does not exist",
        ),
        (
            "deck refraction --theme blue --out d.html",
            "light, dark, projector",
        ),
        (
            "animate refraction --out a.jpg",
            "the name ends in .png or .gif",
        ),
        (
            "animate refraction --fps 0 --out a.gif",
            "allowed are numbers from 0.1 to 50",
        ),
        (
            "animate refraction --fps -3 --out a.gif",
            "allowed are numbers from 0.1 to 50",
        ),
        (
            "animate refraction --size 100x80 --out a.gif",
            "the least is 480x360",
        ),
        (
            "animate refraction --theme projector --size 500x400 --out a.gif",
            "the least is 600x450",
        ),
        (
            "animate refraction --at Iteration --out a.gif",
            "the run has steps of the kinds",
        ),
        (
            "animate refraction --at y= --out a.gif",
            "expected a number",
        ),
        (
            "animate gouraud-teapot --steps 0..900 --size 4000x4000 --out a.gif",
            "900 frames are too many; of this size there may be 134",
        ),
        (
            "frames refraction --scale 5 --out f",
            "allowed are numbers from 1 to 4",
        ),
        (
            "frames refraction --scale nan --out f",
            "allowed are numbers from 1 to 4",
        ),
        (
            "frames refraction --svg --scale 2 --out f",
            "cannot be used with",
        ),
        (
            "frames refraction --size 8000x8000 --scale 4 --out f",
            "too large",
        ),
    ] {
        let message = refused(&lightwalk(folder.path(), arguments), arguments);
        assert!(
            message.contains(said),
            "{arguments}: {message} lacks {said}"
        );
    }
    assert_eq!(files(folder.path()), ["meshes", "scene.json"]);
}

#[cfg(unix)]
#[test]
fn an_interrupted_animation_leaves_nothing() {
    let folder = folder();
    let animate = "animate gouraud-teapot --steps 0..1500 --panel image --out a.png";
    let mut child = command(folder.path(), animate).spawn().unwrap();
    while files(folder.path()).len() < 3 {
        assert!(child.try_wait().unwrap().is_none(), "it was not long");
        std::thread::sleep(std::time::Duration::from_millis(10));
    }
    crate::interrupted::interrupt(child);
    assert_eq!(files(folder.path()), ["meshes", "scene.json"]);
}
