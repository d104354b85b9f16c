//! What the part of a run is called that is looked at.

use crate::algorithms::focus::Focus;
pub use crate::language::Language;
use crate::language::Message;

/// The part of a run that is looked at.
pub fn focus(focus: Focus, language: Language) -> String {
    let numbered = |key, number: String| Message(key).format(language, &[("number", &number)]);
    match focus {
        Focus::Frame => Message("focus-frame").text(language).to_owned(),
        Focus::Polygon(number) => numbered("focus-polygon", number.to_string()),
        Focus::ScanLine(y) => numbered("focus-line", y.to_string()),
        Focus::Pixel { x, y } => {
            Message("focus-pixel").format(language, &[("x", &x.to_string()), ("y", &y.to_string())])
        }
        Focus::Iterations { start, end } => Message("focus-iterations").format(
            language,
            &[
                ("first", &start.to_string()),
                ("last", &(end - 1).to_string()),
            ],
        ),
        Focus::Patch(number) => numbered("focus-patch", number.to_string()),
        Focus::FormFactor { i, j } => format!("F({i}, {j})"),
    }
}
