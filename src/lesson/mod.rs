//! Lessons: a scene, a method and a focus, and what is said and asked on the way.
//!
//! Anchors are selectors: a narrated step is the first event of a kind behind the narrated step before it. A lesson is
//! right when every anchor, every value in its texts and every answer is found in the run itself.

pub mod anchor;
mod answer;
mod builtin;
#[cfg(test)]
mod changed;
mod changes;
mod chapter;
mod checks;
mod contents;
pub mod draft;
mod error;
mod file;
mod kind;
mod link;
mod narrate;
mod narrated;
mod parameters;
#[cfg(test)]
mod pictures;
mod resolve;
mod settings;
mod synthetic;
pub mod template;
mod text;
#[cfg(test)]
mod translated;
mod translations;
#[cfg(test)]
mod unanswered;
mod walkable;

pub use answer::{ARROW_START, Answer, Guess, NoAnswer, Thing, read_number, rounded};
pub use builtin::{Builtin, builtin, builtins};
pub use chapter::Chapter;
pub use error::LessonError;
pub use file::{LessonFile, lesson_schema};
pub use kind::is_lesson;
pub use link::Link;
pub use narrated::{Narrated, Question};
pub use parameters::{
    ByPath, Change, Coefficient, DIVISIONS, Kind, NotAllowed, Parameter, PathValue,
};
pub use resolve::{Lesson, OpenLesson};
pub use text::Text;
