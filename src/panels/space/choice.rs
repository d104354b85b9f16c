//! What of the scene in space is shown: from where, and which rays.

use super::orbit::Orbit;
use crate::algorithms::ray_tree::RayKind;

/// A choice of the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpaceView {
    pub orbit: Orbit,
    pub rays: RayChoice,
}

named! {
    /// Whose rays are shown.
    #[derive(Default)]
    pub enum Pixels {
        /// Of the pixel that is followed, as far as they are traced.
        #[default]
        Current = "current",
        /// Of the pixels around it too.
        Block = "block",
        /// Of pixels all along its row.
        Row = "row",
        /// Of pixels all over the picture.
        Grid = "grid",
    }
}

/// Pixels of a block on either side of the middle.
const BLOCK: i64 = 2;
/// Pixels of a row, and of a grid in each direction.
const ROW: u32 = 21;
const GRID: [u32; 2] = [9, 7];

impl Pixels {
    /// Beside the current pixel, in a picture of that size.
    pub fn around(self, (x, y): (u32, u32), [width, height]: [u32; 2]) -> Vec<(u32, u32)> {
        let every = |count: u32, size: u32| {
            let count = count.min(size);
            (0..count).map(move |i| {
                ((2 * u64::from(i) + 1) * u64::from(size) / (2 * u64::from(count))) as u32
            })
        };
        let near = |middle: u32, size: u32| {
            let range = i64::from(middle) - BLOCK..=i64::from(middle) + BLOCK;
            range.filter_map(move |at| u32::try_from(at).ok().filter(|&at| at < size))
        };
        match self {
            Pixels::Current => Vec::new(),
            Pixels::Block => near(y, height)
                .flat_map(|y| near(x, width).map(move |x| (x, y)))
                .collect(),
            Pixels::Row => every(ROW, width).map(|x| (x, y)).collect(),
            Pixels::Grid => every(GRID[1], height)
                .flat_map(|y| every(GRID[0], width).map(move |x| (x, y)))
                .collect(),
        }
    }
}

/// Which rays are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RayChoice {
    pub pixels: Pixels,
    /// Kinds that are hidden, in their order.
    hidden: [bool; RayKind::ALL.len()],
    /// The last level that is shown; none where all are.
    pub last_level: Option<u16>,
}

impl RayChoice {
    pub fn shows(&self, kind: RayKind, level: u16) -> bool {
        self.shows_kind(kind) && self.last_level.is_none_or(|last| level <= last)
    }

    pub fn shows_kind(&self, kind: RayKind) -> bool {
        !self.hidden[kind as usize]
    }

    /// The same with a kind shown that was hidden, or hidden that was shown.
    pub fn toggled(mut self, kind: RayKind) -> Self {
        self.hidden[kind as usize] ^= true;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_lie_in_the_picture_each_once_and_around_the_current_one() {
        for size in [[1, 1], [3, 2], [40, 30], [640, 480]] {
            let current = (size[0] - 1, 0);
            for pixels in Pixels::ALL {
                let chosen = pixels.around(current, size);
                let mut sorted = chosen.clone();
                sorted.sort_unstable();
                sorted.dedup();
                assert_eq!(sorted.len(), chosen.len(), "{pixels:?} of {size:?}");
                assert!(chosen.iter().all(|&(x, y)| x < size[0] && y < size[1]));
            }
            assert!(Pixels::Block.around(current, size).contains(&current));
            assert!(
                Pixels::Row
                    .around(current, size)
                    .iter()
                    .all(|&(_, y)| y == 0)
            );
        }
        assert_eq!(Pixels::Grid.around((0, 0), [640, 480]).len(), 63);
    }

    #[test]
    fn a_kind_hidden_twice_is_shown() {
        let all = RayChoice::default();
        let hidden = all.toggled(RayKind::Reflected);
        assert!(!hidden.shows(RayKind::Reflected, 1) && hidden.shows(RayKind::Primary, 1));
        assert_eq!(hidden.toggled(RayKind::Reflected), all);
        let shallow = RayChoice {
            last_level: Some(2),
            ..all
        };
        assert!(shallow.shows(RayKind::Primary, 2) && !shallow.shows(RayKind::Primary, 3));
    }
}
