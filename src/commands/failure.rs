//! Why a command did not do what was asked, and what is said on standard error.

use std::io::Write;

/// Why a command did not do what was asked.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// A file or an argument is wrong: status 2.
    #[error("{0}")]
    Wrong(String),
    /// The work failed: status 1.
    #[error("{0}")]
    Failed(String),
    /// The reader of the results is gone: no message.
    #[error("")]
    ReaderGone,
}

impl Failure {
    pub fn status(&self) -> u8 {
        match self {
            Failure::Wrong(_) => 2,
            Failure::Failed(_) | Failure::ReaderGone => 1,
        }
    }
}

/// Writing results to standard output.
impl From<std::io::Error> for Failure {
    fn from(error: std::io::Error) -> Self {
        match error.kind() {
            std::io::ErrorKind::BrokenPipe => Failure::ReaderGone,
            _ => Failure::Failed(format!("cannot write the results: {}", unwritable(&error))),
        }
    }
}

/// Why nothing can be written. No path is in it: that of a temporary file would puzzle.
pub fn unwritable(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::PermissionDenied => "no permission to write there".into(),
        std::io::ErrorKind::NotFound => "no files can be made there".into(),
        kind => kind.to_string(),
    }
}

/// Writes a line to standard error. Where that fails, the work goes on.
pub fn note(line: std::fmt::Arguments) {
    let _ = writeln!(std::io::stderr(), "{line}");
}
