//! What is said at one step.

use crate::lesson::Question;
use crate::panels::Panel;

/// A step with its words, in one language. Symbols in the words are written as in lessons: `I_4`.
#[derive(Clone, Debug)]
pub struct Page {
    pub step: usize,
    pub title: String,
    pub said: String,
    /// What the lecture's slide prints, where it differs.
    pub slide: Option<String>,
    pub question: Option<Question>,
    /// The line of pseudocode that the step carries out.
    pub code: String,
    /// The panel to look at.
    pub panel: Panel,
}
