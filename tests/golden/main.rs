//! What must look and read as before: every lesson's panels at every narrated step as display lists in text, about a hundred
//! pictures chosen for what they show, and the whole trace of a tiny run.
//!
//! `UPDATE_GOLDEN=1 cargo test --test golden` renews them all; read the differences, and look at old and new pictures, before you
//! keep them.

mod change;
mod delta;
mod display_list;
mod files;
mod lists;
mod pictures;
mod trace;
mod walk;
