//! How panels draw red, green and blue.

use crate::algorithms::enclosure::CHANNELS;
use crate::picture::Ink;

pub struct Channel {
    pub letter: &'static str,
    /// Of its curves.
    pub ink: Ink,
}

/// In the order of [`CHANNELS`].
pub static DRAWN: [Channel; 3] = [
    Channel::new("R", 3),
    Channel::new("G", 2),
    Channel::new("B", 0),
];

impl Channel {
    const fn new(letter: &'static str, series: u8) -> Self {
        Channel {
            letter,
            ink: Ink::Series(series),
        }
    }
}

/// The channel that events call so.
pub fn channel(name: &str) -> Option<&'static Channel> {
    let number = CHANNELS.iter().position(|known| *known == name)?;
    Some(&DRAWN[number])
}
