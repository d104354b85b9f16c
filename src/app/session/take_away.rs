//! What can be taken away of a lesson, as a file.

use crate::app::strings;
use crate::language::Message;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TakeAway {
    /// The lesson on paper.
    Handout,
    /// The lesson as slides.
    Deck,
    /// The key panel.
    Picture,
}

impl TakeAway {
    pub const ALL: [TakeAway; 3] = [TakeAway::Handout, TakeAway::Deck, TakeAway::Picture];

    pub fn name(self) -> Message {
        match self {
            TakeAway::Handout => strings::HANDOUT,
            TakeAway::Deck => strings::DECK,
            TakeAway::Picture => strings::PICTURE,
        }
    }
}
