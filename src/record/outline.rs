//! The tree of scopes over a flat list of steps: parent, last step and depth of each.

use super::{Mark, Recording};

/// Stands for "no parent".
const NONE: u32 = u32::MAX;

/// For each step: the scope that it lies in, the last step of the scope that it opens, and its depth.
///
/// The step that leaves a scope lies in that scope, and is drawn at the depth of the step that entered it.
#[derive(Clone, Debug, Default)]
pub struct Outline {
    parent: Vec<u32>,
    last: Vec<u32>,
    depth: Vec<u16>,
    deepest: usize,
}

impl Outline {
    /// Memory that an outline takes for each event.
    pub const BYTES_AN_EVENT: usize = 2 * size_of::<u32>() + size_of::<u16>();

    /// Reads the scopes from the marks. A scope that was never left ends with the last step.
    pub fn of<E: Send + 'static>(recording: &Recording<E>) -> Self {
        let len = recording.len();
        let mut outline = Outline {
            parent: Vec::with_capacity(len),
            last: Vec::with_capacity(len),
            depth: Vec::with_capacity(len),
            deepest: 0,
        };
        let mut open: Vec<u32> = Vec::new();
        let depth = |open: &[u32]| u16::try_from(open.len()).unwrap_or(u16::MAX);
        for (step, mark) in recording.marks().enumerate() {
            let step = step as u32;
            let parent = open.last().copied().unwrap_or(NONE);
            outline.parent.push(parent);
            outline.last.push(step);
            match mark {
                Mark::Step => outline.depth.push(depth(&open)),
                Mark::Enter => {
                    outline.depth.push(depth(&open));
                    open.push(step);
                    outline.deepest = outline.deepest.max(open.len());
                }
                Mark::Leave => {
                    let scope = open.pop();
                    debug_assert!(scope.is_some(), "a scope is left only after it was entered");
                    if let Some(scope) = scope {
                        outline.last[scope as usize] = step;
                    }
                    outline.depth.push(depth(&open));
                }
            }
        }
        for scope in open {
            outline.last[scope as usize] = len as u32 - 1;
        }
        outline
    }

    pub fn len(&self) -> usize {
        self.parent.len()
    }

    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }

    /// The step that opened the scope in which `step` lies.
    pub fn parent(&self, step: usize) -> Option<usize> {
        let parent = self.parent[step];
        (parent != NONE).then_some(parent as usize)
    }

    /// The last step of the scope that `step` opens; `step` itself where it opens none.
    pub fn last(&self, step: usize) -> usize {
        self.last[step] as usize
    }

    /// How many scopes are open around `step`; 65 535 where there are more.
    pub fn depth(&self, step: usize) -> usize {
        self.depth[step] as usize
    }

    /// How many scopes are within each other at most.
    pub fn deepest(&self) -> usize {
        self.deepest
    }

    /// Whether `step` opens a scope.
    pub fn opens(&self, step: usize) -> bool {
        self.last[step] as usize > step
    }

    /// The scopes around `step`, innermost first, without `step` itself.
    pub fn scopes(&self, step: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(self.parent(step), |&scope| self.parent(scope))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Recorder, RecordingLimit};

    #[test]
    fn scopes_nest() {
        let mut recording = Recording::new(RecordingLimit::default());
        recording.step(|| 'a'); // 0
        recording.enter(|| 'b'); // 1
        recording.step(|| 'c'); // 2
        recording.enter(|| 'd'); // 3
        recording.leave(|| 'e'); // 4
        recording.leave(|| 'f'); // 5
        let outline = Outline::of(&recording);
        assert_eq!(
            (0..6).map(|i| outline.parent(i)).collect::<Vec<_>>(),
            [None, None, Some(1), Some(1), Some(3), Some(1)]
        );
        assert_eq!(
            (0..6).map(|i| outline.last(i)).collect::<Vec<_>>(),
            [0, 5, 2, 4, 4, 5]
        );
        assert_eq!(
            (0..6).map(|i| outline.depth(i)).collect::<Vec<_>>(),
            [0, 0, 1, 1, 1, 0]
        );
        assert_eq!(outline.deepest(), 2);
        assert_eq!(outline.scopes(4).collect::<Vec<_>>(), [3, 1]);
    }
    #[test]
    fn very_deep_scopes_do_not_look_shallow() {
        let mut recording = Recording::new(RecordingLimit::default());
        (0..70_000).for_each(|_| recording.enter(|| ()));
        (0..70_000).for_each(|_| recording.leave(|| ()));
        let outline = Outline::of(&recording);
        assert_eq!(outline.depth(69_999), 65_535);
        assert_eq!(outline.last(0), 139_999);
        assert_eq!(outline.depth(139_999), 0);
    }
}
