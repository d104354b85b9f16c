//! A handout: one HTML file that prints, with nothing outside of it. Of each step what is said, the picture, the line of code and the
//! formulas with their numbers; the questions with room for the answer.

use super::html::{code, escaped, figure, words};
use super::making::Making;
use super::question::{answered, asked, room};
use super::{ExportedLesson, Page};
use crate::language::Message;
use crate::panels::Panel;
use crate::picture::{Picture, Theme, plain};
use glam::Vec2;

const STYLE: &str = include_str!("handout.css");
/// The size of a step's picture, in points: two steps go on a page.
const PICTURE: Vec2 = Vec2::new(360.0, 240.0);
/// The width of the formulas: that of the page.
const FORMULA: f32 = 680.0;

/// The whole file; with `answers`, those stand on a last page.
pub fn handout(mut shown: ExportedLesson, steps: Vec<usize>, answers: bool) -> Making<'static> {
    let mut asked = Vec::new();
    Making::new(steps.len() + 2, move |part, out| {
        let text = match part.checked_sub(1) {
            None => head(&shown),
            Some(number) => match steps.get(number) {
                Some(&step) => explained(&mut shown, step, number + 1, &mut asked),
                None => end(&shown, asked.concat(), answers),
            },
        };
        out.write_all(text.as_bytes())
    })
}

fn head(shown: &ExportedLesson) -> String {
    let lesson = &shown.open.lesson;
    let title = lesson.title.in_language(shown.language);
    format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n<p>{}</p>\n</header>\n<main>\n",
        shown.language.code(),
        escaped(&plain(title)),
        words(title),
        words(lesson.summary.in_language(shown.language)),
    )
}

/// A step with its question, whose answer is added to `answers`.
fn explained(
    shown: &mut ExportedLesson,
    step: usize,
    number: usize,
    answers: &mut Vec<String>,
) -> String {
    let language = shown.language;
    let page = shown.page(step);
    let mut section = section(shown, &page, number);
    if let Some(question) = &page.question {
        let number = (answers.len() + 1).to_string();
        let title = Message("export-question").format(language, &[("number", &number)]);
        section += &format!(
            "<div class=\"question\">\n<h3>{title}</h3>\n{}{}</div>\n",
            asked(question, language),
            room(question, language)
        );
        let answer = answered(question, language);
        answers.push(format!("<h3>{title}</h3>\n{answer}"));
    }
    section + "</section>\n"
}

/// What was learned, the answers where they are wanted, and the end of the file.
fn end(shown: &ExportedLesson, answers: String, with_answers: bool) -> String {
    let mut end = String::new();
    if let Some(recap) = &shown.open.lesson.recap {
        let recap = words(recap.in_language(shown.language));
        end += &last("recap", "app-learned", recap, shown);
    }
    if with_answers && !answers.is_empty() {
        end += &last("answers", "export-answers", answers, shown);
    }
    end + "</main>\n</body>\n</html>\n"
}

/// A step up to its question; it is left open.
fn section(shown: &mut ExportedLesson, page: &Page, number: usize) -> String {
    let language = shown.language;
    let drawn = |panel: Panel, picture: &Picture, class: &str, id: &str| {
        let title = panel.title().text(language);
        figure(
            picture,
            title,
            Theme::Light,
            class,
            &format!("s{number}{id}-"),
        )
    };
    let picture = shown.draw(page.panel, page.step, PICTURE);
    let picture = drawn(page.panel, &picture, "panel", "p");
    let formula = shown.formula(page.step, FORMULA);
    let formula = formula.map_or(String::new(), |formula| {
        drawn(Panel::Formula, &formula, "formula", "f")
    });
    let slide = page.slide.as_ref().map_or(String::new(), |slide| {
        let as_printed = Message("app-slide").text(language);
        format!(
            "<p class=\"slide\"><strong>{as_printed}</strong><br>{}</p>\n",
            words(slide)
        )
    });
    format!(
        "<section class=\"step\">\n<h2>{number}. {}</h2>\n<div class=\"row\">\n<div><p class=\"place\">{}</p>\n<p>{}</p>\n{slide}<p class=\"code\">{}</p></div>\n{picture}</div>\n{formula}",
        words(&page.title),
        shown.place(page.step),
        words(&page.said),
        code(&page.code),
    )
}

/// A section behind the steps.
fn last(class: &str, title: &'static str, contents: String, shown: &ExportedLesson) -> String {
    let title = Message(title).text(shown.language);
    format!("<section class=\"{class}\">\n<h2>{title}</h2>\n{contents}\n</section>\n")
}
