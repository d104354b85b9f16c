//! What need not be computed between two patches because the result is known. Without a shortcut it is computed all the same,
//! and the form factor stays the same.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shortcuts {
    /// F = 0 between patches that face away from each other, without an integral.
    pub facing_away: bool,
    /// All light passes between patches that nothing can part, without rays.
    pub sight_tests: bool,
}

impl Default for Shortcuts {
    /// All of them.
    fn default() -> Self {
        Shortcuts {
            facing_away: true,
            sight_tests: true,
        }
    }
}
