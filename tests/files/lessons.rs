//! The program's own lessons: each reads, runs, finds every anchor, and teaches enough.

use lightwalk::lesson::{Answer, Narrated, builtins};
use lightwalk::panels::Panel;
use lightwalk::panels::strings::Language;
use std::sync::LazyLock;

/// What the tests of texts read of a lesson.
struct LessonTexts {
    id: String,
    panels: Vec<Panel>,
    recap: Option<[String; 2]>,
    narrated: Vec<Narrated>,
}

/// Every lesson, opened once for all tests.
static LESSONS: LazyLock<Vec<LessonTexts>> = LazyLock::new(|| {
    let open = builtins().iter().map(|builtin| {
        let open = builtin.read().and_then(|lesson| lesson.open());
        let open = open.unwrap_or_else(|error| panic!("{}: {error}", builtin.id));
        let recap = open.lesson.recap.as_ref();
        LessonTexts {
            id: open.lesson.id.clone(),
            panels: open.lesson.panels.clone(),
            recap: recap
                .map(|recap| Language::ALL.map(|language| recap.in_language(language).to_string())),
            narrated: open.narrated,
        }
    });
    open.collect()
});

fn count_words(text: &str) -> usize {
    text.split_whitespace().count()
}

#[test]
fn every_lesson_opens_and_teaches() {
    let mut numbers = Vec::new();
    for builtin in builtins() {
        let lesson = builtin
            .read()
            .unwrap_or_else(|error| panic!("{}: {error}", builtin.id));
        assert_eq!(lesson.id, builtin.id);
        numbers.push(lesson.number);
        let open = lesson
            .open()
            .unwrap_or_else(|error| panic!("{}: {error}", builtin.id));
        assert!(
            open.narrated.len() >= 10,
            "{}: {} narrated steps",
            builtin.id,
            open.narrated.len()
        );
        assert!(open.narrated.is_sorted_by(|a, b| a.step < b.step));
        let questions: Vec<_> = open
            .narrated
            .iter()
            .filter_map(|narrated| narrated.question.as_ref().map(|q| (narrated.step, q)))
            .collect();
        assert!(
            questions.len() >= 3,
            "{}: {} questions",
            builtin.id,
            questions.len()
        );
        for (step, question) in questions {
            assert!(
                question.step > step,
                "{}: the answer comes after the question",
                builtin.id
            );
            if let Answer::Choice { options, right } = &question.answer {
                assert!(options.len() >= 2 && *right < options.len());
            }
        }
        for narrated in &open.narrated {
            let [en, id] = Language::ALL.map(|language| narrated.text(language));
            assert_ne!(
                en, id,
                "{}: step {} says the same in both languages",
                builtin.id, narrated.step
            );
            assert!(!en.contains(['{', '}']) && !id.contains(['{', '}']));
        }
        assert!(!open.run.walk().truncated());
    }
    assert!(
        numbers.is_sorted_by(|a, b| a < b),
        "lessons are listed in the order of their numbers"
    );
}

#[test]
fn every_explanation_has_a_short_title_and_every_lesson_a_recap() {
    for lesson in LESSONS.iter() {
        let id = &lesson.id;
        let recap = lesson.recap.as_ref();
        let recap = recap.unwrap_or_else(|| panic!("{id}: no recap"));
        for language in Language::ALL {
            let recap = &recap[language as usize];
            assert!((30..=70).contains(&count_words(recap)), "{id}: {recap}");
            for narrated in &lesson.narrated {
                let title = narrated.title.as_ref();
                let title = title.unwrap_or_else(|| panic!("{id}: step {}", narrated.step));
                let title = title.in_language(language);
                assert!((2..=6).contains(&count_words(title)), "{id}: {title}");
            }
        }
    }
}

/// Nobody reads a page of text beside a picture: an explanation has 70 words at most.
#[test]
fn every_explanation_is_short() {
    let mut long = Vec::new();
    for lesson in LESSONS.iter() {
        let id = &lesson.id;
        let count = lesson.narrated.len();
        assert!((10..=30).contains(&count), "{id}: {count} explanations");
        for language in Language::ALL {
            for (index, narrated) in lesson.narrated.iter().enumerate() {
                let texts = [Some(narrated.text(language)), narrated.slide(language)];
                let words = texts.into_iter().flatten().map(count_words);
                long.extend(
                    words
                        .filter(|&words| words > 70)
                        .map(|words| format!("{id} {language:?} [{index}]: {words} words")),
                );
            }
        }
    }
    assert_eq!(long, [""; 0]);
}

/// Where a panel stands depends on the window, so a text names it and does not say where it is.
#[test]
fn no_text_says_where_a_panel_is() {
    let parts = [
        "panel",
        "panels",
        "slider",
        "sliders",
        "strip",
        "view",
        "window",
        "penggeser",
        "jalur",
        "jendela",
    ];
    let places = [
        "above", "below", "left", "right", "upper", "lower", "top", "bottom", "beside", "atas",
        "bawah", "kiri", "kanan", "sebelah",
    ];
    for lesson in LESSONS.iter() {
        for language in Language::ALL {
            for narrated in &lesson.narrated {
                let say = narrated.text(language).to_lowercase();
                let letters = |c: char| !c.is_alphabetic();
                let words: Vec<&str> = say.split(letters).filter(|word| !word.is_empty()).collect();
                // "panel above", "upper strip", "penggeser di atas".
                for near in words.windows(3) {
                    let placed = match near {
                        [a, b, _] if parts.contains(a) && places.contains(b) => true,
                        [a, b, _] if places.contains(a) && parts.contains(b) => true,
                        [a, "di", b] => parts.contains(a) && places.contains(b),
                        _ => false,
                    };
                    assert!(!placed, "{}: {near:?} in: {say}", lesson.id);
                }
            }
        }
    }
}

/// Paper has no keys, and neither has a phone.
#[test]
fn no_explanation_says_what_to_press() {
    for lesson in LESSONS.iter() {
        for narrated in &lesson.narrated {
            for language in Language::ALL {
                let say = narrated.text(language).to_lowercase();
                let mut words = say.split(|c: char| !c.is_alphabetic());
                let pressed = words.any(|word| ["press", "tekan"].contains(&word));
                assert!(!pressed, "{}: {say}", lesson.id);
            }
        }
    }
}

/// A panel that a text names stands in the window under that name.
#[test]
fn texts_call_the_lessons_panels_by_their_titles() {
    let mut named = 0;
    for lesson in LESSONS.iter() {
        for language in Language::ALL {
            for narrated in &lesson.narrated {
                let question = narrated.question.as_ref();
                let asked =
                    question.map(|question| [question.ask(language), question.why(language)]);
                let texts = [narrated.text(language)].into_iter();
                for text in texts.chain(asked.into_iter().flatten()) {
                    let behind = text.split("anel “").skip(1);
                    let names = behind.filter_map(|behind| Some(behind.split_once('”')?.0));
                    for name in names {
                        let titles = lesson
                            .panels
                            .iter()
                            .map(|panel| panel.title().text(language));
                        assert!(
                            titles.into_iter().any(|title| title == name),
                            "{}: {name}",
                            lesson.id
                        );
                        named += 1;
                    }
                }
            }
        }
    }
    assert!(named > 0);
}

#[test]
fn every_lesson_begins_and_ends_with_a_picture() {
    let pictures = [
        Panel::Image,
        Panel::Comparison,
        Panel::Radiosity,
        Panel::FormFactor,
    ];
    for lesson in LESSONS.iter() {
        let first = lesson.narrated.first();
        for narrated in first.into_iter().chain(lesson.narrated.last()) {
            let key = narrated.key.unwrap_or(lesson.panels[0]);
            assert!(pictures.contains(&key), "{}: {key:?}", lesson.id);
        }
    }
}

/// The largest error of `next`, called once for each of the fractions 1/n, 2/n, … 1.
fn largest_error(n: u32, mut next: impl FnMut() -> f32) -> f64 {
    let exact = (1..=n).map(|i| f64::from(i) / f64::from(n));
    let errors = exact.map(|exact| (f64::from(next()) - exact).abs());
    errors.fold(0.0, f64::max)
}

#[test]
fn a_ramp_in_32_bits_drifts_as_lesson_7_says() {
    let added = |n: u32| {
        let mut sum = 0.0_f32;
        largest_error(n, || {
            sum += 1.0 / n as f32;
            sum
        })
    };
    let compensated = |n: u32| {
        let (mut sum, mut excess) = (0.0_f32, 0.0);
        largest_error(n, || {
            let corrected = 1.0 / n as f32 - excess;
            let next = sum + corrected;
            excess = (next - sum) - corrected;
            sum = next;
            sum
        })
    };
    let direct = |n: u32| {
        let mut i = 0.0_f32;
        largest_error(n, || {
            i += 1.0;
            i / n as f32
        })
    };
    for (found, said) in [
        (added(10_000), 5.4e-5),
        (added(1_000_000), 9.5e-3),
        (compensated(1_000_000), 3.2e-8),
        (direct(1_000_000), 3.0e-8),
    ] {
        assert!((found / said - 1.0).abs() < 0.1, "{found:e} for {said:e}");
    }
}
