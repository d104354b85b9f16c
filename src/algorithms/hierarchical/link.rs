//! Links: the exchange of two elements as one number, at the level where that is enough.

use super::tree::Tree;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::form_factor::{Blockers, auto, facing};
use crate::record::Unrecorded;

/// Light passes both ways: A_p F_pq = A_q F_qp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    pub p: u32,
    pub q: u32,
    pub estimate: Estimate,
}

/// What passes between two elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// A_p F_pq, as if nothing were between the two; 0 where one surface hides all of the one from all of the other.
    pub exchange: f64,
    /// The share of it that passes.
    pub visible: f64,
}

/// How exact the form factor of a link is, relative.
const TOLERANCE: f64 = 1e-4;

impl Estimate {
    /// Where nothing stands between two elements it is exact to `TOLERANCE`; else the exchange is, and the share that passes is what
    /// is seen from a few points.
    pub fn of(enclosure: &Enclosure, tree: &Tree, p: u32, q: u32) -> Estimate {
        let patches = &enclosure.patches;
        let [of_p, of_q] = [p, q].map(|number| tree.polygons(patches, number));
        let (mut exchange, mut passing) = (0.0, 0.0);
        for a in &of_p {
            for b in &of_q {
                let Some([a, b]) = facing(a.clone(), b.clone()) else {
                    continue;
                };
                let look = |blockers: &Blockers| blockers.glimpse(&a, &b);
                if let Some(visible) = enclosure.visibility().map_or(Some(1.0), look) {
                    let whole = auto::exchange(&a, &b, TOLERANCE, &mut 0, &mut Unrecorded);
                    exchange += whole;
                    passing += whole * visible;
                }
            }
        }
        let exposed = [p, q].map(|number| tree.elements[number as usize].exposed);
        Estimate {
            exchange: exchange * exposed[0] * exposed[1],
            visible: if exchange > 0.0 {
                passing / exchange
            } else {
                0.0
            },
        }
    }

    /// A_p F_pq.
    pub fn passing(&self) -> f64 {
        self.exchange * self.visible
    }
}

/// By element, the links that it has: those of element p are `ends[p]..ends[p + 1]` of `links`.
#[derive(Clone, Debug, Default)]
pub struct LinksOf {
    ends: Vec<u32>,
    links: Vec<u32>,
}

impl LinksOf {
    /// `links` are none where they were refined.
    pub fn of(elements: usize, links: &[Option<Link>]) -> LinksOf {
        let ends_of = |link: &Link| [link.p as usize, link.q as usize];
        let mut ends = vec![0; elements + 1];
        for end in links.iter().flatten().flat_map(ends_of) {
            ends[end + 1] += 1;
        }
        for element in 0..elements {
            ends[element + 1] += ends[element];
        }
        let mut next = ends.clone();
        let mut sorted = vec![0; ends[elements] as usize];
        for (number, link) in (0..).zip(links) {
            for end in link.iter().flat_map(ends_of) {
                sorted[next[end] as usize] = number;
                next[end] += 1;
            }
        }
        LinksOf {
            ends,
            links: sorted,
        }
    }

    /// By number.
    pub fn links(&self, element: u32) -> &[u32] {
        let element = element as usize;
        &self.links[self.ends[element] as usize..self.ends[element + 1] as usize]
    }
}
