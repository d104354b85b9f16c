//! What one takes away of a lesson, or of a walk through a scene of one's own, as files: [`TakeAway`] lists it for the command line, the
//! window and the page. A file is a [`Making`], written part by part.
//!
//! The steps that are explained become [`Page`]s: what is said and asked there, the line of code, and pictures of its panels. A handout,
//! slides and an animation are three uses of the same pages.

mod animation;
mod card;
mod deck;
mod handout;
mod html;
mod making;
mod page;
mod picture;
mod question;
mod radiosity_table;
mod shown;
mod steps;
mod steps_table;
mod tables;
mod take_away;

pub use animation::{Film, animation};
pub use card::{SMALLEST_CARD, card, reading_seconds};
pub use deck::deck;
pub use handout::handout;
pub use making::Making;
pub use page::Page;
pub use picture::{panel, whole_picture};
pub use radiosity_table::{radiosities, system};
pub use shown::ExportedLesson;
pub use steps::steps_in_lines;
pub use steps_table::steps_in_table;
pub use tables::Table;
pub use take_away::{SIZE, TakeAway, Wish};
