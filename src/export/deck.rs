//! Slides: sections of HTML for reveal.js, to be put into a deck of one's own.

use super::html::{code, figure, words};
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

/// The sections, with the style that they need. `progress` hears how many steps are done.
pub fn deck(
    shown: &mut ExportedLesson,
    steps: &[usize],
    theme: Theme,
    progress: &dyn Fn(usize),
) -> String {
    let language = shown.language;
    let lesson = &shown.open.lesson;
    let id = lesson.id.clone();
    let lang = language.code();
    let section = |class: &str, contents: &str| {
        format!("<section class=\"lightwalk {class}\" lang=\"{lang}\">\n{contents}</section>\n")
    };
    let titled =
        |level: u8, title: &str, rest: &str| format!("<h{level}>{title}</h{level}>\n{rest}");
    let summary = format!("<p>{}</p>\n", words(lesson.summary.in_language(language)));
    let title = words(lesson.title.in_language(language));
    let recap = lesson.recap.as_ref().map(|recap| {
        let recap = format!("<p>{}</p>\n", words(recap.in_language(language)));
        titled(2, Message("app-learned").text(language), &recap)
    });
    let mut deck = format!("<style>\n{STYLE}</style>\n");
    deck += &section("title", &titled(1, &title, &summary));
    for (number, &step) in steps.iter().enumerate() {
        let page = shown.page(step);
        let id = format!("{id}-{step}");
        let said = said(shown, &page, theme, &id);
        deck += &section("step", &titled(2, &words(&page.title), &said));
        if let Some(question) = &page.question {
            let picture = picture(shown, &page, theme, &format!("{id}q-"));
            let asked = asked(question, language);
            let answer = answered(question, language);
            let both = format!("{asked}<div class=\"fragment\">\n{answer}</div>\n");
            let title = Message("app-before-you-go-on").text(language);
            deck += &section("question", &titled(2, title, &beside(&picture, &both)));
        }
        progress(number + 1);
    }
    deck + &recap.map_or(String::new(), |recap| section("recap", &recap))
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
