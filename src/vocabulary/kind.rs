//! A kind of event, as it is declared.

use super::entry::Entry;
use super::quantity::Quantity;
use crate::language::{Language, Message, named};

#[derive(Debug)]
pub struct Kind {
    /// As search, lessons and `steps` write it: `EdgeInterpolated`.
    pub name: &'static str,
    /// All values that an event of this kind may have, in their order.
    pub quantities: &'static [Quantity],
    /// The labels of the lines of pseudocode that it carries out: one, or two of which the event chooses.
    pub labels: &'static [&'static str],
    /// What the scope is called that such an event opens.
    pub scope: Option<Message>,
    /// The values that distinguish the scope from others of its kind in the same scope: usually its number. None where there is
    /// only one.
    pub numbers: &'static [&'static str],
    /// The first that fits says what the step does.
    pub entries: &'static [Entry],
}

impl Kind {
    pub fn quantity(&self, name: &str) -> Option<&'static Quantity> {
        self.quantities
            .iter()
            .find(|quantity| quantity.name == name)
    }

    /// What the value of that name says of an event of this kind: the message `meaning-NAME-of-KIND`, or `meaning-NAME` where
    /// the name says the same of every kind.
    pub fn meaning(&self, name: &str, language: Language) -> Option<String> {
        named(&format!("meaning-{name}-of-{}", self.name), language)
            .or_else(|| named(&format!("meaning-{name}"), language))
    }
}
