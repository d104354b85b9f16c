//! What a study found, as files: tables for programs, words for readers.

mod csv;
mod json;
pub mod strings;
mod summary;

pub use csv::csv;
pub use json::json;
pub use summary::summary;
