//! Red, green and blue: what panels call them, and how they draw their curves.

use crate::language::Message;
use crate::picture::Ink;

pub struct Channel {
    /// As events have it.
    pub name: &'static str,
    pub letter: &'static str,
    pub word: Message,
    pub ink: Ink,
}

impl Channel {
    const fn new(name: &'static str, letter: &'static str, word: &'static str, series: u8) -> Self {
        Channel {
            name,
            letter,
            word: Message(word),
            ink: Ink::Series(series),
        }
    }
}

pub static CHANNELS: [Channel; 3] = [
    Channel::new("red", "R", "radiosity-red", 3),
    Channel::new("green", "G", "radiosity-green", 2),
    Channel::new("blue", "B", "radiosity-blue", 0),
];

/// The channel that events call so.
pub fn channel(name: &str) -> Option<&'static Channel> {
    CHANNELS.iter().find(|channel| channel.name == name)
}
