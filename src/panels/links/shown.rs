//! Which links a step is about.

use crate::replay::hierarchical::{Current, LinkNow, State};

/// More lines are not told apart.
const MOST: usize = 300;

/// Which links are looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Chosen {
    All,
    /// Those between two surfaces, by their roots.
    Between([u32; 2]),
    /// Those over which light comes to an element: its own, and those of the elements that it lies in.
    Toward(u32),
}

/// The links that are drawn, the coarsest first.
#[derive(Clone, Debug)]
pub struct Shown {
    pub chosen: Chosen,
    pub links: Vec<LinkNow>,
    /// With those that are too many to be drawn.
    pub count: usize,
    /// The pair of the step, be it linked or not: the one that gathers first.
    pub current: Option<[u32; 2]>,
    /// The element of the step, where it is about one alone.
    pub alone: Option<u32>,
}

impl Shown {
    pub fn of(state: &State) -> Shown {
        let root = |element| state.path(element).last().copied().unwrap_or(element);
        let (chosen, current, alone) = match state.current {
            None => (Chosen::All, None, None),
            Some(Current::Pair(pair)) => (Chosen::Between(pair.map(root)), Some(pair), None),
            Some(Current::Gathering(p, Some(q))) => (Chosen::Toward(p), Some([p, q]), None),
            Some(Current::Gathering(p, None) | Current::Pushing(p)) => {
                (Chosen::Toward(p), None, Some(p))
            }
        };
        let mut links: Vec<LinkNow> = match chosen {
            Chosen::All => state.links().map(|(_, link)| link).collect(),
            Chosen::Between([one, other]) => {
                let is_between = |link: &LinkNow| {
                    let roots = [link.p, link.q].map(root);
                    roots == [one, other] || roots == [other, one]
                };
                let links = state.links().map(|(_, link)| link);
                links.filter(is_between).collect()
            }
            Chosen::Toward(p) => {
                let path = state.path(p);
                let links = state.links().map(|(_, link)| link);
                links
                    .filter(|link| path.contains(&link.p) || path.contains(&link.q))
                    .collect()
            }
        };
        let count = links.len();
        links.sort_by_key(|link| link.level);
        links.truncate(MOST);
        Shown {
            chosen,
            links,
            count,
            current,
            alone,
        }
    }

    pub fn is_current(&self, link: &LinkNow) -> bool {
        self.current
            .is_some_and(|[p, q]| [link.p, link.q] == [p, q] || [link.p, link.q] == [q, p])
    }
}
