//! Every panel of lessons at random steps, in random sizes from one pixel up, with random choices of who looks: there is a picture, on the
//! screen and as SVG, without a number that is not finite.

use crate::kit::{Driver, Outcome, not_finite, one_of, pick};
use glam::Vec2;
use lightwalk::language::Language;
use lightwalk::lesson::{OpenLesson, builtin};
use lightwalk::numeric::Random;
use lightwalk::panels::{Hidden, InspectorView, Panel, PanelInput, TreeView, draw};
use lightwalk::picture::{Picture, Theme, raster_size, rasterize, to_svg};
use lightwalk::render::compare::compare;
use lightwalk::render::{Finished, race, render, smooth_patches};
use std::cell::RefCell;
use std::collections::HashMap;
use std::convert::Infallible;
use std::num::NonZeroUsize;

/// These have every panel between them.
const LESSONS: [&str; 7] = [
    "illumination-model",
    "gouraud-triangle",
    "fast-phong",
    "side-by-side",
    "ray-tree",
    "form-factors",
    "gathering",
];

/// A lesson that was run, and what its panels show beside the steps.
struct Opened {
    open: OpenLesson,
    finished: Finished,
    narrated: Vec<usize>,
}

impl Opened {
    fn of(lesson: &str) -> Self {
        let lesson = builtin(lesson).expect("a lesson of the program");
        let open = lesson.read().and_then(|lesson| lesson.open());
        let open = open.unwrap_or_else(|error| panic!("{error}"));
        let picture = render(
            &open.setup,
            open.lesson.method,
            NonZeroUsize::MIN,
            &|_, _| {},
        );
        let mut finished = Finished::new(picture, &open.setup.prepared.scene.lights);
        let methods = open.lesson.compare.iter();
        finished.compared = methods
            .map(|&method| compare(&open.setup, method))
            .collect();
        if open.lesson.panels.contains(&Panel::Race) {
            let Ok(race) = race(&open.setup, || Ok::<(), Infallible>(()));
            finished.race = race;
        }
        let narrated = open.narrated.iter().map(|said| said.step).collect();
        Opened {
            open,
            finished,
            narrated,
        }
    }
}

/// A size, small ones most often.
pub fn side(random: &mut Random) -> f32 {
    match pick(random, 4) {
        0 => 1.0 + pick(random, 4) as f32,
        1 => (20.0 * random.number().abs()).max(0.01) as f32,
        _ => (900.0 * random.number().powi(4)).max(1.0) as f32,
    }
}

/// The picture on the screen and as SVG. Errors: what is wrong with it.
pub fn check_picture(picture: &Picture, theme: Theme, scale: f32) -> Result<(), String> {
    let size = Vec2::new(picture.width, picture.height);
    let pixmap = rasterize(picture, theme, scale).map_err(|error| error.to_string())?;
    let wanted = raster_size(size, scale).map_err(|error| error.to_string())?;
    if [pixmap.width(), pixmap.height()] != wanted {
        return Err(format!("the picture is not {wanted:?}"));
    }
    match not_finite(&to_svg(picture, "panel", theme)) {
        Some(place) => Err(format!("a number that is not finite: {place}")),
        None => Ok(()),
    }
}

/// The lesson, the seed of the choices, the panel, the size and what it is drawn in.
fn make(random: &mut Random) -> String {
    let panel = one_of(random, &Panel::ALL).name();
    let theme = one_of(random, &Theme::ALL).name();
    let language = one_of(random, &Language::ALL).code();
    let lesson = one_of(random, &LESSONS);
    let [width, height] = [0; 2].map(|_| side(random));
    let scale = one_of(random, &[1.0, 1.0, 1.25, 2.0]);
    format!(
        "{lesson} {panel} {width} {height} {scale} {theme} {language} {}",
        random.bits()
    )
}

fn attempt(case: &str) -> Result<Outcome, String> {
    thread_local! {
        static OPENED: RefCell<HashMap<String, Opened>> = RefCell::default();
    }
    let words: Vec<&str> = case.split(' ').collect();
    let [lesson, panel, width, height, scale, theme, language, seed] = words[..] else {
        return Err("a case has eight words".into());
    };
    let float = |text: &str| text.parse::<f32>().map_err(|error| error.to_string());
    let random = &mut Random(seed.parse().map_err(|_| "a seed is a whole number")?);
    let panel = Panel::called(panel).ok_or("there is no such panel")?;
    let theme = Theme::from_name(theme).unwrap_or_default();
    let language = Language::of_tag(language).unwrap_or_default();
    let (size, scale) = (Vec2::new(float(width)?, float(height)?), float(scale)?);
    OPENED.with_borrow_mut(|opened| {
        let opened = opened.entry(lesson.to_owned());
        let opened = opened.or_insert_with(|| Opened::of(lesson));
        let picture = draw_as_chosen(opened, panel, language, size, random);
        check_picture(&picture, theme, scale)
    })?;
    Ok(Outcome::Done)
}

fn draw_as_chosen(
    opened: &mut Opened,
    panel: Panel,
    language: Language,
    size: Vec2,
    random: &mut Random,
) -> Picture {
    let walk = opened.open.run.walk_mut();
    let count = walk.len();
    let any_step = |random: &mut Random| pick(random, count);
    walk.seek(match pick(random, 4) {
        0 => one_of(random, &opened.narrated),
        1 => count - 1,
        _ => any_step(random),
    });
    let tree = TreeView {
        zoom: one_of(random, &[1.0, 3.0, TreeView::LARGEST]),
        held: None,
        collapsed: (0..pick(random, 3)).map(|_| any_step(random)).collect(),
    };
    let inspector = InspectorView {
        search: one_of(random, &["", "n", "I_d", "zzz"]).into(),
        first: pick(random, 60),
    };
    let mut breakpoints: Vec<usize> = (0..pick(random, 4)).map(|_| any_step(random)).collect();
    breakpoints.sort_unstable();
    let enclosure = opened.open.setup.enclosure().ok();
    let patches = enclosure.map_or(0, |enclosure| enclosure.patches.len());
    let pair = [0; 2].map(|_| pick(random, patches));
    let hidden = [Hidden::ALL.as_slice(), &[]][pick(random, 2)];
    let sometimes = |random: &mut Random| pick(random, 3) == 0;
    let input = PanelInput {
        narrated: &opened.narrated,
        breakpoints: &breakpoints,
        tree: &tree,
        inspector: &inspector,
        channel: sometimes(random).then(|| pick(random, 3)),
        smooth: sometimes(random).then_some(smooth_patches),
        pending: sometimes(random).then_some(hidden),
        waiting: sometimes(random).then(|| any_step(random)),
        selected: sometimes(random).then(|| any_step(random)),
        unshot: sometimes(random),
        pair: (patches > 0 && sometimes(random)).then_some(pair),
        ..PanelInput::of(
            &opened.open.run,
            &opened.finished,
            opened.open.lesson.focus,
            language,
        )
    };
    draw(panel, &input, size)
}

#[test]
fn every_panel_has_a_picture_of_any_size_at_any_step() {
    let driver = Driver {
        kind: "panels",
        cases: 3_000,
        done_percent: 100,
        make,
        attempt,
    };
    driver.attack();
}
