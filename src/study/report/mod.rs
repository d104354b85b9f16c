//! What a study found, as files: tables for programs, words for readers.

mod csv;
mod json;
mod summary;
pub mod words;

pub use csv::csv;
pub use json::json;
pub use summary::summary;
