//! What the lessons and the panels show is set: no mark of the notation is left on the screen.

use lightwalk::language::Language;
use lightwalk::lesson::{Answer, OpenLesson, builtins};
use lightwalk::picture::{Script, math, prose};

/// The marks of the notation that would be seen where `text` is set.
fn raw_marks(text: &str) -> Vec<String> {
    let runs = prose(text).into_iter().filter(|run| !run.code);
    let marked = runs.filter(|run| run.text.contains(['`', '_', '^', '{', '}']));
    marked.map(|run| run.text).collect()
}

/// Every text of a lesson that a student reads.
fn texts(open: &OpenLesson, language: Language) -> Vec<String> {
    let lesson = &open.lesson;
    let mut texts = vec![
        lesson.title.in_language(language).to_string(),
        lesson.summary.in_language(language).to_string(),
    ];
    for narrated in &open.narrated {
        texts.push(narrated.text(language).to_string());
        texts.extend(narrated.slide(language).map(str::to_string));
        if let Some(question) = &narrated.question {
            texts.push(question.ask(language).to_string());
            texts.push(question.why(language).to_string());
            if let Answer::Choice { options, .. } = &question.answer {
                texts.extend(
                    options
                        .iter()
                        .map(|option| option[language as usize].clone()),
                );
            }
        }
    }
    texts
}

#[test]
fn no_text_of_a_lesson_shows_marks_of_its_notation() {
    for builtin in builtins() {
        let open = builtin.read().and_then(|lesson| lesson.open());
        let open = open.unwrap_or_else(|error| panic!("{}: {error}", builtin.id));
        for text in Language::ALL
            .into_iter()
            .flat_map(|language| texts(&open, language))
        {
            let what = format!("{}: {text}", builtin.id);
            assert!(text.matches('`').count() % 2 == 0, "{what}");
            assert_eq!(raw_marks(&text), [""; 0], "{what}");
            for run in prose(&text) {
                // An exponent or an index is short, closed in itself, and has no words.
                if run.script != Script::Base {
                    assert!(run.text.chars().count() <= 12, "{what}: {}", run.text);
                    assert!(!run.text.contains(['(', ')', ' ']), "{what}: {}", run.text);
                }
            }
        }
    }
}

#[test]
fn marks_are_found() {
    assert_eq!(raw_marks("the file `a_b` has F_jj and x^30"), [""; 0]);
    assert_eq!(raw_marks("so _ and"), ["so _ and"]);
    assert_eq!(raw_marks("so {5}"), ["so {5}"]);
}

/// The texts of the golden display lists, each after its style.
fn drawn() -> Vec<(String, String)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/lists");
    let folders = std::fs::read_dir(folder).expect("the golden lists are there");
    let mut texts = Vec::new();
    for folder in folders {
        let files = std::fs::read_dir(folder.expect("a folder").path()).expect("a lesson’s lists");
        for file in files {
            let lists = std::fs::read_to_string(file.expect("a file").path()).expect("text");
            for line in lists.lines() {
                let columns: Vec<&str> = line.split('\t').collect();
                if let [kind, _, look, text] = columns[..]
                    && kind.ends_with("text")
                {
                    let style = look.split(' ').next().unwrap_or_default();
                    texts.push((style.to_string(), text.to_string()));
                }
            }
        }
    }
    texts
}

#[test]
fn no_panel_shows_marks_of_the_notation() {
    let texts = drawn();
    assert!(texts.len() > 10_000, "only {} texts", texts.len());
    for (style, text) in texts {
        let shown: Vec<String> = match style.as_str() {
            "Label" | "LabelBold" | "Formula" => {
                math(&text).into_iter().map(|run| run.text).collect()
            }
            _ => vec![text.clone()],
        };
        let marks = ['`', '_', '^', '{', '}'];
        assert!(
            shown.iter().all(|text| !text.contains(marks)),
            "{style}: {text}"
        );
    }
}
