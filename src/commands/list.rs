//! `lightwalk list`: the lessons.

use super::failure::Failure;
use super::files::wrong;
use super::progress::Progress;
use crate::lesson::{Chapter, Text, builtins};
use crate::panels::strings::Language;
use crate::picture::plain;
use std::io::Write;

#[derive(clap::Args)]
pub struct Arguments {
    /// As a JSON array of objects with id, number, chapter, title, summary, topics and steps
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let mut lessons = Vec::new();
    let progress = Progress::new("running the lessons");
    for (done, lesson) in builtins().iter().enumerate() {
        progress.show(done, builtins().len());
        lessons.push(
            lesson
                .read()
                .and_then(|lesson| lesson.open())
                .map_err(|error| wrong(&lesson.id, &error))?,
        );
    }
    drop(progress);
    let mut out = std::io::stdout().lock();
    if arguments.json {
        let lessons: Vec<_> = lessons
            .iter()
            .map(|open| {
                let texts = |text: &Text| {
                    let [en, id] = text.both().map(|(_, text)| text);
                    serde_json::json!({ "en": en, "id": id })
                };
                serde_json::json!({
                    "id": open.lesson.id,
                    "number": open.lesson.number,
                    "chapter": open.lesson.chapter.map(Chapter::name),
                    "title": texts(&open.lesson.title),
                    "summary": texts(&open.lesson.summary),
                    "topics": open.lesson.topics,
                    "steps": open.run.walk().len(),
                    "narrated": open.narrated.len(),
                })
            })
            .collect();
        serde_json::to_writer_pretty(&mut out, &lessons).map_err(std::io::Error::from)?;
        writeln!(out)?;
    } else {
        for open in &lessons {
            let lesson = &open.lesson;
            writeln!(
                out,
                "{:>2}  {:<20} {}",
                lesson.number,
                lesson.id,
                plain(lesson.title.in_language(Language::English))
            )?;
            writeln!(
                out,
                "{:24}{} · {} steps, {} narrated",
                "",
                lesson.topics.join(", "),
                open.run.walk().len(),
                open.narrated.len()
            )?;
        }
    }
    Ok(())
}
