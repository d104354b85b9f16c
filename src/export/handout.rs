//! A handout: one HTML file that prints, with nothing outside of it. Of each step what is said, the picture, the line of code and the
//! formulas with their numbers; the questions with room for the answer.

use super::html::{code, escaped, figure, words};
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

/// What a handout is made of.
pub struct Contents<'a> {
    pub steps: &'a [usize],
    /// Whether the answers stand on a last page.
    pub answers: bool,
}

/// The whole file. `progress` hears how many steps are done.
pub fn handout(
    shown: &mut ExportedLesson,
    contents: &Contents,
    progress: &dyn Fn(usize),
) -> String {
    let language = shown.language;
    let mut body = String::new();
    let mut answers = String::new();
    let mut questions = 0;
    for (number, &step) in contents.steps.iter().enumerate() {
        let page = shown.page(step);
        body += &section(shown, &page, number + 1);
        if let Some(question) = &page.question {
            questions += 1;
            let title =
                Message("export-question").format(language, &[("number", &questions.to_string())]);
            body += &format!(
                "<div class=\"question\">\n<h3>{title}</h3>\n{}{}</div>\n",
                asked(question, language),
                room(question, language)
            );
            answers += &format!("<h3>{title}</h3>\n{}", answered(question, language));
        }
        body += "</section>\n";
        progress(number + 1);
    }
    let lesson = &shown.open.lesson;
    if let Some(recap) = &lesson.recap {
        body += &last(
            "recap",
            "app-learned",
            words(recap.in_language(language)),
            shown,
        );
    }
    if contents.answers && !answers.is_empty() {
        body += &last("answers", "export-answers", answers, shown);
    }
    let title = lesson.title.in_language(language);
    format!(
        "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n<h1>{}</h1>\n<p>{}</p>\n</header>\n\
         <main>\n{body}</main>\n</body>\n</html>\n",
        language.code(),
        escaped(&plain(title)),
        words(title),
        words(lesson.summary.in_language(language)),
    )
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
