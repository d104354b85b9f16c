//! No bytes make the reader of lessons panic or hang; nor does running what it takes.

use lightwalk::lesson::Lesson;
use lightwalk::scene::Limits;
use proptest::prelude::*;

const LESSON: &str = include_str!("../../lessons/04-gouraud-triangle.json");

/// Reads a lesson and, where it is taken and small, runs it.
fn try_lesson(bytes: &[u8]) {
    let read = Lesson::read(bytes, &Limits::default(), &mut |_| {
        Err("no such file".into())
    });
    if let Ok(lesson) = read
        && lesson.size.iter().all(|&side| side <= 64)
        && let Err(error) = lesson.open()
    {
        assert!(!error.problems.is_empty());
    }
}

#[test]
fn the_lesson_is_taken_unbroken() {
    let lesson = Lesson::read(LESSON.as_bytes(), &Limits::default(), &mut |_| {
        Err("no such file".into())
    });
    assert!(lesson.and_then(Lesson::open).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn no_cut_makes_it_panic(at in 0..LESSON.len()) {
        try_lesson(&LESSON.as_bytes()[..at]);
    }

    #[test]
    fn no_changed_bytes_make_it_panic(changes in prop::collection::vec((0..LESSON.len(), any::<u8>()), 1..4)) {
        let mut bytes = LESSON.as_bytes().to_vec();
        for (at, byte) in changes {
            bytes[at] = byte;
        }
        try_lesson(&bytes);
    }

    /// Numbers are exchanged for others, so that files stay JSON and reach the run.
    #[test]
    fn no_exchanged_number_makes_it_panic(which in 0_usize..60, by in prop::sample::select(vec!["0", "-1", "1e-300", "1e75", "-7.5", "65", "4294967295", "1e308"])) {
        let mut digits = LESSON.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at).filter(|&at| {
            !LESSON[..at].ends_with(|c: char| c.is_ascii_digit() || c == '.' || c == '-' || c.is_alphabetic() || c == '_')
        });
        if let Some(at) = digits.nth(which) {
            let end = LESSON[at..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(LESSON.len(), |length| at + length);
            try_lesson(format!("{}{by}{}", &LESSON[..at], &LESSON[end..]).as_bytes());
        }
    }
}

#[test]
fn an_unknown_chapter_is_refused_with_those_that_there_are() {
    let renamed = LESSON.replace("\"chapter\": \"shading\"", "\"chapter\": \"Shading\"");
    assert_ne!(renamed, LESSON);
    let error = Lesson::read(renamed.as_bytes(), &Limits::default(), &mut |_| {
        Err("no such file".into())
    })
    .expect_err("a chapter that there is not");
    let line = renamed[..renamed.find("\"Shading\"").unwrap()]
        .matches('\n')
        .count()
        + 1;
    let problem = &error.problems[0];
    assert_eq!(
        (problem.line, problem.place.as_str()),
        (Some(line), "chapter")
    );
    assert_eq!(
        problem.message,
        "found \"Shading\"; allowed are shading, ray-tracing, radiosity, study"
    );
}
