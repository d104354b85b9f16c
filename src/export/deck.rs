//! Slides: sections of HTML for reveal.js, to be put into a deck of one's own.

use super::html::{code, figure, words};
use super::making::Making;
use super::question::{answered, asked};
use super::{ExportedLesson, Page};
use crate::language::Message;
use crate::panels::Panel;
use crate::picture::{Picture, Theme};
use glam::Vec2;

const STYLE: &str = include_str!("deck.css");
/// Sizes in points on a slide of 960×700.
const PICTURE: Vec2 = Vec2::new(560.0, 400.0);
const FORMULA: Vec2 = Vec2::new(920.0, 200.0);
/// How much larger formulas are than in the window.
const GROWN: f32 = 1.25;

/// The sections, with the style that they need.
pub fn deck(mut shown: ExportedLesson, steps: Vec<usize>, theme: Theme) -> Making<'static> {
    Making::new(steps.len() + 2, move |part, out| {
        let text = match part.checked_sub(1) {
            None => head(&shown),
            Some(number) => match steps.get(number) {
                Some(&step) => slides(&mut shown, step, theme),
                None => recap(&shown),
            },
        };
        out.write_all(text.as_bytes())
    })
}

/// A slide of that class.
fn section(shown: &ExportedLesson, class: &str, title: &str, contents: &str) -> String {
    let level = if class == "title" { 1 } else { 2 };
    let lang = shown.language.code();
    format!(
        "<section class=\"lightwalk {class}\" lang=\"{lang}\">\n<h{level}>{title}</h{level}>\n{contents}</section>\n"
    )
}

fn head(shown: &ExportedLesson) -> String {
    let lesson = &shown.open.lesson;
    let summary = words(lesson.summary.in_language(shown.language));
    let title = words(lesson.title.in_language(shown.language));
    let slide = section(shown, "title", &title, &format!("<p>{summary}</p>\n"));
    format!("<style>\n{STYLE}</style>\n{slide}")
}

/// A step; and what is asked there, with the answer.
fn slides(shown: &mut ExportedLesson, step: usize, theme: Theme) -> String {
    let language = shown.language;
    let page = shown.page(step);
    let id = format!("{}-{step}", shown.open.lesson.id);
    let said = said(shown, &page, theme, &id);
    let mut slides = section(shown, "step", &words(&page.title), &said);
    if let Some(question) = &page.question {
        let picture = picture(shown, &page, theme, &format!("{id}q-"));
        let asked = asked(question, language);
        let answer = answered(question, language);
        let both = format!("{asked}<div class=\"fragment\">\n{answer}</div>\n");
        let title = Message("app-before-you-go-on").text(language);
        slides += &section(shown, "question", title, &beside(&picture, &both));
    }
    slides
}

fn recap(shown: &ExportedLesson) -> String {
    let recap = shown.open.lesson.recap.as_ref().map(|recap| {
        let recap = words(recap.in_language(shown.language));
        let title = Message("app-learned").text(shown.language);
        section(shown, "recap", title, &format!("<p>{recap}</p>\n"))
    });
    recap.unwrap_or_default()
}

/// The picture of a step, with what is said there beside it and the formulas below.
fn said(shown: &mut ExportedLesson, page: &Page, theme: Theme, id: &str) -> String {
    let language = shown.language;
    let words = format!(
        "<p>{}</p>\n<p>{}</p>\n",
        words(&page.said),
        code(&page.code)
    );
    let row = beside(&picture(shown, page, theme, &format!("{id}p-")), &words);
    let formula = formula(shown, page.step, theme).map_or(String::new(), |formula| {
        let title = Panel::Formula.title().text(language);
        figure(&formula, title, theme, "formula", &format!("{id}f-"))
    });
    let notes = shown.place(page.step);
    format!("{row}{formula}<aside class=\"notes\">{notes}</aside>\n")
}

/// The formulas in the largest type with room for all; where there is none, as in the window.
fn formula(shown: &mut ExportedLesson, step: usize, theme: Theme) -> Option<Picture> {
    let room = FORMULA / GROWN / theme.text_scale();
    let whole = shown.formula(step, room.x)?;
    Some(match whole.height <= room.y {
        true => shown.draw(Panel::Formula, step, room),
        false => whole,
    })
}

fn picture(shown: &mut ExportedLesson, page: &Page, theme: Theme, id: &str) -> String {
    let picture = shown.draw(page.panel, page.step, PICTURE / theme.text_scale());
    let title = page.panel.title().text(shown.language);
    figure(&picture, title, theme, "panel", id)
}

fn beside(picture: &str, words: &str) -> String {
    format!("<div class=\"row\">\n{picture}<div>\n{words}</div>\n</div>\n")
}
