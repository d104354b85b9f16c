//! Refine: a pair of elements is linked where the error of one number for both is small enough; else the larger one is divided.

use super::event::Event;
use super::hierarchy::Hierarchy;
use super::link::{Estimate, Link};
use super::oracle::Oracle;
use crate::record::Recorder;

/// So many links are looked at before it is asked whether to go on.
const LINKS_BETWEEN: usize = 1000;

impl Hierarchy<'_> {
    /// Whether one number is enough for the exchange of p and q. What hides a part of it does not count, so that borders of
    /// shadows are divided as if they were lit.
    pub fn is_fine(&self, oracle: Oracle, [p, q]: [u32; 2], estimate: &Estimate) -> bool {
        match oracle {
            Oracle::FormFactor(allowed) => {
                let smaller = self.element(p).area.min(self.element(q).area);
                estimate.exchange / smaller <= allowed
            }
            Oracle::Carried(allowed) => self.rho_b(p, q) * estimate.exchange <= allowed,
        }
    }

    /// The largest of ρ_p B_q and ρ_q B_p in any channel.
    fn rho_b(&self, p: u32, q: u32) -> f64 {
        let one_way = |p: u32, q: u32| (self.element(p).rho * self.b[q as usize]).max_channel();
        one_way(p, q).max(one_way(q, p))
    }

    /// The larger of the two, if it may be divided; else the other, if that may.
    fn divisible(&self, [p, q]: [u32; 2]) -> Option<[u32; 2]> {
        let is_p_larger = self.element(p).area >= self.element(q).area;
        let order = if is_p_larger {
            [[p, q], [q, p]]
        } else {
            [[q, p], [p, q]]
        };
        let smallest = self.settings.smallest_area;
        order
            .into_iter()
            .find(|&[divided, _]| self.tree.is_divisible(divided, smallest))
    }

    /// Refine(p, q). `link` is the one that the pair had.
    pub fn refine<R: Recorder<Event>>(
        &mut self,
        oracle: Oracle,
        [p, q]: [u32; 2],
        link: Option<u32>,
        recorder: &mut R,
    ) {
        if self.is_full() {
            return;
        }
        let known = link.and_then(|link| self.links[link as usize]);
        let estimate = known.map_or_else(
            || Estimate::of(self.enclosure, &self.tree, p, q),
            |link| link.estimate,
        );
        if estimate.exchange == 0.0 {
            recorder.step(|| Event::Unlinked { p, q });
            return;
        }
        let [area_p, area_q] = [p, q].map(|number| self.element(number).area);
        recorder.enter(|| Event::Refining {
            p,
            q,
            link,
            areas: [area_p, area_q],
            f_pq: estimate.exchange / area_p,
            rho_b: matches!(oracle, Oracle::Carried(_)).then(|| self.rho_b(p, q)),
        });
        let divisible = match self.is_fine(oracle, [p, q], &estimate) {
            true => None,
            false => self.divisible([p, q]),
        };
        let Some([divided, other]) = divisible else {
            self.links.push(Some(Link { p, q, estimate }));
            let link = self.links.len() as u32 - 1;
            recorder.leave(|| Event::Linked {
                link,
                f_pq: estimate.exchange / area_p,
                visible: estimate.visible,
            });
            return;
        };
        self.divide(divided, recorder);
        for child in self.element(divided).children() {
            self.refine(oracle, [child, other], None, recorder);
        }
        recorder.leave(|| Event::Parted { divided });
    }

    /// Links the roots, or what they are divided into. `go_on` is asked now and then.
    pub fn link_roots<R: Recorder<Event>, E>(
        &mut self,
        oracle: Oracle,
        recorder: &mut R,
        mut go_on: impl FnMut() -> Result<(), E>,
    ) -> Result<(), E> {
        let roots = self.tree.roots;
        for p in 0..roots {
            go_on()?;
            (p + 1..roots).for_each(|q| self.refine(oracle, [p, q], None, recorder));
        }
        Ok(())
    }

    /// Refines the links whose error is too large. What they carry goes to the links of the children. `go_on` is asked now and then.
    pub fn refine_links<R: Recorder<Event>, E>(
        &mut self,
        oracle: Oracle,
        recorder: &mut R,
        mut go_on: impl FnMut() -> Result<(), E>,
    ) -> Result<(), E> {
        for number in 0..self.links.len() {
            if number % LINKS_BETWEEN == 0 {
                go_on()?;
            }
            let Some(link) = self.links[number] else {
                continue;
            };
            let pair = [link.p, link.q];
            if self.is_fine(oracle, pair, &link.estimate) || self.divisible(pair).is_none() {
                continue;
            }
            self.refine(oracle, pair, Some(number as u32), recorder);
            self.links[number] = None;
        }
        Ok(())
    }

    fn divide<R: Recorder<Event>>(&mut self, divided: u32, recorder: &mut R) {
        if !self.tree.divide(self.enclosure, divided) {
            return;
        }
        // Until light is gathered again, a child is as bright as the whole.
        let b = self.b[divided as usize];
        self.b.resize(self.tree.elements.len(), b);
        self.b_g
            .resize(self.tree.elements.len(), Default::default());
        let children = self.element(divided).children();
        recorder.step(|| Event::Divided {
            divided,
            first: children.start,
            parts: children.len() as u32,
            level: self.element(divided).level + 1,
        });
    }
}
