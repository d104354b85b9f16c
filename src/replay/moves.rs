//! Where the keys lead from a step: pure functions of the outline, `None` where a move cannot act.

use crate::record::Outline;

pub type Move = fn(&Outline, usize) -> Option<usize>;

/// The next step, inside the scope that `step` opens if it opens one.
pub fn into(outline: &Outline, step: usize) -> Option<usize> {
    forward(outline, step, step + 1)
}

/// The next step after the scope that `step` opens; the last step of all where nothing follows that scope.
pub fn over(outline: &Outline, step: usize) -> Option<usize> {
    forward(outline, step, outline.last(step) + 1)
}

/// The next step after the scope that `step` lies in; the last step of all where nothing follows that scope.
pub fn out(outline: &Outline, step: usize) -> Option<usize> {
    forward(outline, step, outline.last(outline.parent(step)?) + 1)
}

/// The next scope that opens after the current one has closed: a sibling, or else a scope further out.
/// Where none follows, the next one inside the current scope.
///
/// The current scope is the one that `step` opens, or else lies in.
pub fn next_scope(outline: &Outline, step: usize) -> Option<usize> {
    let after = match current_scope(outline, step) {
        Some(scope) => outline.last(scope) + 1,
        None => step + 1,
    };
    let opens = |&step: &usize| outline.opens(step);
    (after..outline.len())
        .find(opens)
        .or_else(|| (step + 1..after).find(opens))
}

/// The step that opened the current scope; from there the previous sibling, or else the scope around both.
///
/// The current scope is the one that `step` opens, or else lies in.
pub fn previous_scope(outline: &Outline, step: usize) -> Option<usize> {
    if let Some(scope) = current_scope(outline, step)
        && scope != step
    {
        return Some(scope);
    }
    // Going back at one level, a step is the scope around, or closes a sibling, which is its parent, or is a plain step.
    let around = outline.parent(step);
    (0..step).rev().find_map(|before| {
        if outline.opens(before) {
            Some(before)
        } else {
            outline
                .parent(before)
                .filter(|&scope| Some(scope) != around)
        }
    })
}

fn current_scope(outline: &Outline, step: usize) -> Option<usize> {
    if outline.opens(step) {
        Some(step)
    } else {
        outline.parent(step)
    }
}

/// `target`, or the last step where it lies beyond; `None` where that is no way forward.
fn forward(outline: &Outline, step: usize, target: usize) -> Option<usize> {
    let target = target.min(outline.len().checked_sub(1)?);
    (target > step).then_some(target)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Mark;
    use crate::replay::generators::{Trace, trace};
    use proptest::prelude::*;

    /// Step by step, with no outline: the step that closes the scope opened by `step`, or `step`.
    fn last(marks: &[Mark], step: usize) -> usize {
        if marks[step] != Mark::Enter {
            return step;
        }
        let mut open = 0;
        for (i, mark) in marks.iter().enumerate().skip(step) {
            match mark {
                Mark::Enter => open += 1,
                Mark::Leave => open -= 1,
                Mark::Step => {}
            }
            if open == 0 {
                return i;
            }
        }
        panic!("every scope is left");
    }

    /// The innermost scope opened before `step` that is not closed before it.
    fn parent(marks: &[Mark], step: usize) -> Option<usize> {
        (0..step)
            .rev()
            .find(|&i| marks[i] == Mark::Enter && last(marks, i) >= step)
    }

    fn depth(marks: &[Mark], step: usize) -> usize {
        (0..step)
            .filter(|&i| marks[i] == Mark::Enter && last(marks, i) > step)
            .count()
    }

    proptest! {
        #[test]
        fn moves_agree_with_the_marks(trace in trace()) {
            let recording = trace.recording();
            let outline = Outline::of(&recording);
            let marks: Vec<Mark> = recording.marks().collect();
            let clamp = |step: usize, target: usize| Some(target.min(marks.len() - 1)).filter(|&t| t > step);
            for step in 0..marks.len() {
                let parent = parent(&marks, step);
                let depth_here = depth(&marks, step);
                prop_assert_eq!(outline.parent(step), parent);
                prop_assert_eq!(outline.depth(step), depth_here);
                prop_assert_eq!(into(&outline, step), clamp(step, step + 1));
                prop_assert_eq!(over(&outline, step), clamp(step, last(&marks, step) + 1));
                prop_assert_eq!(out(&outline, step), parent.and_then(|p| clamp(step, last(&marks, p) + 1)));

                let scope = if marks[step] == Mark::Enter { Some(step) } else { parent };
                let level = scope.map_or(0, |scope| depth(&marks, scope));
                let enters = |i: &usize| marks[*i] == Mark::Enter;
                prop_assert_eq!(
                    next_scope(&outline, step),
                    (step + 1..marks.len()).filter(enters).find(|&i| depth(&marks, i) <= level)
                        .or_else(|| (step + 1..marks.len()).find(enters))
                );
                prop_assert_eq!(
                    previous_scope(&outline, step),
                    (0..step).rev().filter(enters).find(|&i| depth(&marks, i) <= level)
                );
            }
        }
    }

    #[test]
    fn a_lone_step_leads_nowhere() {
        let outline = Outline::of(&Trace::parse(".").recording());
        for go in [into, over, out, next_scope, previous_scope] {
            assert_eq!(go(&outline, 0), None);
        }
    }

    #[test]
    fn scopes_are_met_in_order() {
        //                                        0123456789
        let outline = Outline::of(&Trace::parse("(.(.)(.).)").recording());
        assert_eq!(
            next_scope(&outline, 1),
            Some(2),
            "only scopes inside are left"
        );
        assert_eq!(next_scope(&outline, 3), Some(5));
        assert_eq!(next_scope(&outline, 6), None);
        assert_eq!(previous_scope(&outline, 6), Some(5));
        assert_eq!(previous_scope(&outline, 5), Some(2));
        assert_eq!(previous_scope(&outline, 2), Some(0));
        assert_eq!(previous_scope(&outline, 0), None);
        assert_eq!(over(&outline, 0), Some(9), "the end, where nothing follows");
    }
}
