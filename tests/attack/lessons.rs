//! Lessons changed at random: keys, values, anchors, parameters, questions. Each is refused with a clear error, or it opens, its
//! parameters move, its questions can be answered and its panels drawn.

use crate::json::change;
use crate::kit::{Driver, Outcome, is_clear, not_finite, one_of, pick};
use crate::panels::{check_picture, side};
use crate::scenes::LIMITS;
use glam::Vec2;
use lightwalk::export::ExportedLesson;
use lightwalk::language::Language;
use lightwalk::lesson::{Change, Guess, Lesson, LessonError, OpenLesson, Parameter};
use lightwalk::numeric::Random;
use lightwalk::panels::Panel;
use lightwalk::picture::Theme;
use lightwalk::record::RecordingLimit;
use lightwalk::replay::Run;
use serde_json::{Value, json};
use std::fs;
use std::num::NonZeroUsize;
use std::sync::{Arc, LazyLock};

/// Pictures of longer sides take too long to be drawn for each of thousands of lessons.
const LONGEST_SIDE: u32 = 200;

/// The explanations that are kept of a lesson.
const FEW: usize = 3;

/// The folder of the program's lessons, and those.
const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/lessons/");
static LESSONS: LazyLock<Vec<Value>> = LazyLock::new(|| {
    let entries = fs::read_dir(FOLDER)
        .expect("the folder of the lessons")
        .flatten();
    let files = entries.map(|entry| entry.path());
    let mut files: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|ending| ending == "json"))
        .collect();
    files.sort();
    let read = |path| {
        serde_json::from_slice(&fs::read(path).expect("a lesson")).expect("lessons are JSON")
    };
    files.into_iter().map(read).collect()
});

/// One of the program's lessons with a small picture and few explanations, changed.
pub fn make(random: &mut Random) -> String {
    let mut lesson = small(random);
    for _ in 0..pick(random, 4) {
        let parts = [
            "scene",
            "steps",
            "steps",
            "parameters",
            "focus",
            "panels",
            "radiosity",
            "names",
            "title",
        ];
        match (pick(random, 3), lesson.get_mut(one_of(random, &parts))) {
            (1.., Some(part)) => change(part, random),
            _ => change(&mut lesson, random),
        }
    }
    lesson.to_string()
}

fn small(random: &mut Random) -> Value {
    let mut lesson = LESSONS[pick(random, LESSONS.len())].clone();
    let steps = lesson["steps"].as_array_mut().expect("a lesson has steps");
    let first = pick(random, steps.len() - FEW);
    *steps = steps.drain(first..first + FEW).collect();
    let longest = (0..2)
        .filter_map(|side| lesson["size"][side].as_u64())
        .max();
    let part = longest.unwrap_or(1).div_ceil(u64::from(LONGEST_SIDE) / 2);
    for path in [
        "/size/0",
        "/size/1",
        "/focus/pixel/0",
        "/focus/pixel/1",
        "/focus/scan_line",
    ] {
        if let Some(length) = lesson.pointer_mut(path) {
            *length = json!(length.as_u64().unwrap_or(1) / part);
        }
    }
    lesson
}

fn attempt(text: &str) -> Result<Outcome, String> {
    let mut read_file =
        |name: &str| fs::read(format!("{FOLDER}{name}")).map_err(|_| "no such file".to_owned());
    let read = Lesson::read(text.as_bytes(), &LIMITS, &mut read_file);
    let lesson = match read.and_then(|lesson| lesson.check_parameters().map(|()| lesson)) {
        Ok(lesson) => lesson,
        Err(error) => return refused(&error),
    };
    if lesson.size.iter().any(|&side| side > LONGEST_SIDE) {
        return Ok(Outcome::Refused);
    }
    let open = match lesson.open() {
        Ok(open) => open,
        Err(error) => return refused(&error),
    };
    let random = &mut Random(text.len() as u64);
    move_parameter(&open, random)?;
    // Some texts name it.
    let names_nan = text.contains("NaN");
    walk(open, random).or_else(|why| match names_nan && why.contains("not finite: ") {
        true => Ok(()),
        false => Err(why),
    })?;
    Ok(Outcome::Done)
}

fn refused(error: &LessonError) -> Result<Outcome, String> {
    is_clear(&error.to_string())?;
    match error.problems.is_empty() {
        true => Err("it is refused for nothing".into()),
        false => Ok(Outcome::Refused),
    }
}

/// The run and the texts with another value of one of the parameters.
fn move_parameter(open: &OpenLesson, random: &mut Random) -> Result<(), String> {
    let lesson = &open.lesson;
    let Some(&Parameter::ByPath(index)) =
        lesson.parameters.get(pick(random, lesson.parameters.len()))
    else {
        return Ok(());
    };
    let parameter = &lesson.by_path[index];
    let sampled = parameter.sampled();
    let change = Change::ByPath {
        parameter: index,
        value: one_of(random, &sampled),
    };
    let Ok((scene, settings)) = lesson.changed(&[change]) else {
        return Ok(());
    };
    let setup = Arc::new(
        lesson
            .setup(scene, settings)
            .ok_or("there is no camera any more")?,
    );
    if setup.check_for(lesson.method).is_err() || setup.check(lesson.focus).is_err() {
        return Ok(());
    }
    let run = Run::record(
        setup,
        lesson.method,
        lesson.focus,
        RecordingLimit::default(),
    );
    if let Err(error) = lesson.narrate_changed(&run) {
        refused(&error)?;
    }
    Ok(())
}

/// All panels at an explanation and at two other steps, and what is said and asked there.
fn walk(open: OpenLesson, random: &mut Random) -> Result<(), String> {
    let language = one_of(random, &Language::ALL);
    let mut panels = open.lesson.panels.clone();
    panels.extend([
        Panel::Code,
        Panel::Formula,
        Panel::TimeLine,
        Panel::Inspector,
    ]);
    let mut shown =
        ExportedLesson::new(open, &panels, language, NonZeroUsize::MIN, &|_, _| {}).asking();
    let count = shown.open.run.walk().len();
    let mut steps = vec![pick(random, count), count - 1];
    steps.extend(shown.narrated().first());
    for step in steps {
        let page = shown.page(step);
        if let Some(place) = not_finite(&page.said) {
            return Err(format!("at step {step}, not finite: {place}"));
        }
        if let Some(question) = &page.question {
            let guesses = [
                Guess::Number("1e308".into()),
                Guess::Choice(1),
                Guess::Pixel { x: 0, y: 0 },
                Guess::Pick(0),
                Guess::Order(vec![0, 1, 2]),
                Guess::Arrow(45.0),
            ];
            for guess in guesses {
                if question.answer.judge(&guess) == Ok(false) {
                    question.answer.hint(&guess, language);
                    question.answer.guess_in_words(&guess, language);
                }
            }
            question.answer.in_words(language);
        }
        for &panel in &panels {
            let size = Vec2::new(side(random), side(random));
            let picture = shown.draw(panel, step, size);
            let wrong = |why| format!("{}, step {step}, {size}: {why}", panel.name());
            check_picture(&picture, Theme::Light, 1.0).map_err(wrong)?;
        }
    }
    Ok(())
}

#[test]
fn a_changed_lesson_is_refused_or_can_be_walked_through() {
    let driver = Driver {
        kind: "lessons",
        cases: 400,
        done_percent: 25,
        make,
        attempt,
    };
    driver.attack();
}
