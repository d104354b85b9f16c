//! One of several options.

use crate::language::{Language, Message};

const ANOTHER: Message = Message("hint-another");

/// The card strikes the wrong option out.
pub(super) fn hint(language: Language) -> String {
    ANOTHER.text(language).to_owned()
}
