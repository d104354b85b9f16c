//! How playing stands.

/// Steps a second.
pub(super) const SPEEDS: [f64; 10] = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0, 256.0, 1024.0];

pub(super) const NORMAL_SPEED: usize = 3;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    Forward,
    Backward,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Play {
    pub direction: Direction,
    /// Steps, or parts of one, that are due and not yet taken.
    pub due: f64,
}

/// The range of steps that playing stays in; it is one once both ends are set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Loop {
    pub from: Option<usize>,
    pub to: Option<usize>,
}

impl Loop {
    pub fn range(self) -> Option<(usize, usize)> {
        self.from.zip(self.to).filter(|(from, to)| from < to)
    }
}
