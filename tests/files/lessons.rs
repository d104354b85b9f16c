//! The program's own lessons: each reads, runs, finds every anchor, and teaches enough.

use lightwalk::lesson::{Answer, OpenLesson, builtins};
use lightwalk::panels::Panel;
use lightwalk::panels::strings::Language;

/// Every lesson, opened.
fn open_lessons() -> impl Iterator<Item = OpenLesson> {
    builtins().iter().map(|builtin| {
        let open = builtin.read().and_then(|lesson| lesson.open());
        open.unwrap_or_else(|error| panic!("{}: {error}", builtin.id))
    })
}

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
            let [en, id] = Language::ALL.map(|language| narrated.say(language));
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
    for open in open_lessons() {
        let id = &open.lesson.id;
        let recap = open.lesson.recap.as_ref();
        let recap = recap.unwrap_or_else(|| panic!("{id}: no recap"));
        for language in Language::ALL {
            let recap = recap.in_language(language);
            assert!((30..=70).contains(&count_words(recap)), "{id}: {recap}");
            for narrated in &open.narrated {
                let title = narrated.title.as_ref();
                let title = title.unwrap_or_else(|| panic!("{id}: step {}", narrated.step));
                let title = title.in_language(language);
                assert!((2..=6).contains(&count_words(title)), "{id}: {title}");
            }
        }
    }
}

#[test]
fn every_lesson_opens_with_a_picture() {
    let pictures = [
        Panel::Image,
        Panel::Comparison,
        Panel::Radiosity,
        Panel::FormFactor,
    ];
    for open in open_lessons() {
        let key = open.narrated[0].key.unwrap_or(open.lesson.panels[0]);
        assert!(pictures.contains(&key), "{}: {key:?}", open.lesson.id);
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
