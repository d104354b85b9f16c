//! The window: a [`Session`](session::Session) holds what is shown, [`window`] shows it, [`open`] puts it on the screen.

mod keys;
pub mod session;
mod words;

pub use session::{Command, Session};
