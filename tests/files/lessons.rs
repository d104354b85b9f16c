//! The program's own lessons: each reads, runs, finds every anchor, and teaches enough.

use lightwalk::lesson::{Answer, builtins};
use lightwalk::panels::strings::Language;

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
            let [en, id] = Language::ALL.map(|language| narrated.localize(language));
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
