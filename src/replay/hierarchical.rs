//! The state of hierarchical radiosity at one step: the elements that there are, their light and their links.

use super::Fold;
use super::cow_vec::CowVec;
use super::radiosity::exposure;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::hierarchical::tree::Tree;
use crate::algorithms::hierarchical::{Event, Hierarchy};
use crate::color::Rgb;
use std::sync::Arc;

/// An element so far.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementNow {
    pub parent: Option<u32>,
    pub level: u32,
    pub is_divided: bool,
    pub b: Rgb,
    /// The step that changed it last.
    pub step: Option<u32>,
}

/// A link, while it is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkNow {
    pub p: u32,
    pub q: u32,
    /// F_pq, of which the share `visible` passes.
    pub f_pq: f64,
    pub visible: f64,
    /// That of the smaller element: how often surfaces were divided for the link.
    pub level: u32,
    /// The step that made it.
    pub step: u32,
}

/// What the step works on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Current {
    /// A pair that is refined.
    Pair([u32; 2]),
    /// An element that gathers, and the one at the other end of the link.
    Gathering(u32, Option<u32>),
    /// An element in the push–pull.
    Pushing(u32),
}

/// What is known once the run is over: where every element lies.
#[derive(Clone, Debug)]
pub struct Solved {
    pub tree: Tree,
    /// What radiosity is multiplied by to be shown.
    pub exposure: f64,
}

impl Solved {
    pub fn new(hierarchy: &Hierarchy) -> Self {
        Solved {
            tree: hierarchy.tree.clone(),
            exposure: exposure(&hierarchy.by_patch(), &hierarchy.enclosure.emission),
        }
    }
}

#[derive(Clone, Debug, Default)]
pub struct State {
    /// None where the scene has no patches.
    pub solved: Option<Arc<Solved>>,
    pub elements: CowVec<ElementNow>,
    /// By number; none where a link was refined.
    pub links: CowVec<Option<LinkNow>>,
    pub pass: Option<u32>,
    pub sweep: Option<u32>,
    pub current: Option<Current>,
    /// F_pq of the current pair or link, once it is recorded.
    pub form_factor: Option<f64>,
    /// The pairs that are being refined, each with the link that it had.
    pairs: Vec<([u32; 2], Option<u32>)>,
    /// The elements from a root down that light is pushed to.
    pushed: Vec<u32>,
}

impl State {
    /// Before the first step.
    pub fn new(solved: Option<Solved>) -> Self {
        State {
            solved: solved.map(Arc::new),
            ..State::default()
        }
    }

    /// The links that there are, each with its number.
    pub fn links(&self) -> impl Iterator<Item = (u32, LinkNow)> {
        let numbered = (0..).zip(self.links.iter());
        numbered.filter_map(|(number, link)| Some((number, (*link)?)))
    }

    /// How many links there are by level, from 0 on.
    pub fn links_by_level(&self) -> Vec<usize> {
        let mut counts = Vec::new();
        for (_, link) in self.links() {
            let level = link.level as usize;
            counts.resize(counts.len().max(level + 1), 0);
            counts[level] += 1;
        }
        counts
    }

    /// An element, and those that it lies in, up to the root.
    pub fn path(&self, element: u32) -> Vec<u32> {
        let parent = |&element: &u32| self.elements.get(element as usize)?.parent;
        std::iter::successors(Some(element), parent).collect()
    }

    /// The radiosity of every patch so far: that of the smallest element that it lies in. It begins with the emission.
    pub fn light(&self, enclosure: &Enclosure) -> Vec<Rgb> {
        let mut light = enclosure.emission.clone();
        for (number, element) in self.leaves() {
            for patch in self.patches(enclosure, number) {
                light[patch] = element.b;
            }
        }
        light
    }

    /// The elements that are not divided yet.
    pub fn leaves(&self) -> impl Iterator<Item = (u32, &ElementNow)> {
        let numbered = (0..).zip(self.elements.iter());
        numbered.filter(|(_, element)| !element.is_divided)
    }

    /// The patches that an element is made of.
    pub fn patches(&self, enclosure: &Enclosure, number: u32) -> Vec<usize> {
        let element = |solved: &Arc<Solved>| {
            let element = solved.tree.elements.get(number as usize)?;
            let surface = &enclosure.patches.surfaces[element.object as usize];
            Some(element.patches(surface).collect())
        };
        self.solved.as_ref().and_then(element).unwrap_or_default()
    }

    /// The smallest element that a patch lies in.
    pub fn leaf_of(&self, enclosure: &Enclosure, patch: usize) -> Option<u32> {
        let mut leaves = self.leaves();
        leaves.find_map(|(number, _)| {
            self.patches(enclosure, number)
                .contains(&patch)
                .then_some(number)
        })
    }

    fn begin(&mut self, roots: u32) {
        let Some(solved) = &self.solved else { return };
        for root in &solved.tree.elements[..roots as usize] {
            self.elements.push(ElementNow {
                b: root.emission,
                ..ElementNow::default()
            });
        }
    }

    fn divide(&mut self, divided: u32, parts: u32, level: u32, step: usize) {
        let Some(parent) = self.elements.get_mut(divided as usize) else {
            return;
        };
        parent.is_divided = true;
        let b = parent.b;
        for _ in 0..parts {
            self.elements.push(ElementNow {
                parent: Some(divided),
                level,
                is_divided: false,
                b,
                step: Some(step as u32),
            });
        }
    }

    fn level(&self, element: u32) -> u32 {
        let element = self.elements.get(element as usize);
        element.map_or(0, |element| element.level)
    }

    /// Closes the refinement of a pair. The step is still about that pair.
    fn end_pair(&mut self) -> Option<[u32; 2]> {
        let (pair, old) = self.pairs.pop()?;
        if let Some(link) = old.and_then(|old| self.links.get_mut(old as usize)) {
            *link = None;
        }
        self.current = Some(Current::Pair(pair));
        Some(pair)
    }

    fn lit(&mut self, b: Rgb, step: usize) {
        let Some(p) = self.pushed.pop() else { return };
        self.current = Some(Current::Pushing(p));
        if let Some(element) = self.elements.get_mut(p as usize) {
            element.b = b;
            element.step = Some(step as u32);
        }
    }
}

impl Fold<Event> for State {
    fn apply(&mut self, step: usize, event: &Event) {
        self.form_factor = match *event {
            Event::Refining { f_pq, .. } | Event::LinkGathered { f_pq, .. } => Some(f_pq),
            Event::Linked { f_pq, visible, .. } => Some(f_pq * visible),
            Event::Divided { .. } => self.form_factor,
            _ => None,
        };
        match *event {
            Event::Hierarchy { roots, .. } => self.begin(roots),
            Event::Pass { pass, .. } => (self.pass, self.sweep) = (Some(pass), None),
            Event::Refining { p, q, link, .. } => {
                self.pairs.push(([p, q], link));
                self.current = Some(Current::Pair([p, q]));
            }
            Event::Unlinked { p, q } => self.current = Some(Current::Pair([p, q])),
            Event::Divided {
                divided,
                parts,
                level,
                ..
            } => self.divide(divided, parts, level, step),
            Event::Linked { f_pq, visible, .. } => {
                if let Some([p, q]) = self.end_pair() {
                    let levels = [p, q].map(|number| self.level(number));
                    self.links.push(Some(LinkNow {
                        p,
                        q,
                        f_pq,
                        visible,
                        level: levels[0].max(levels[1]),
                        step: step as u32,
                    }));
                }
            }
            Event::Parted { .. } => {
                self.end_pair();
            }
            Event::Sweep { sweep } => {
                self.sweep = Some(sweep);
                self.current = None;
            }
            Event::LinksGathering { p, .. } => self.current = Some(Current::Gathering(p, None)),
            Event::LinkGathered { q, .. } => {
                if let Some(Current::Gathering(_, other)) = &mut self.current {
                    *other = Some(q);
                }
            }
            Event::PushedDown { p, .. } => {
                self.pushed.push(p);
                self.current = Some(Current::Pushing(p));
            }
            Event::LeafLit { b_p, .. } | Event::PulledUp { b_p } => self.lit(b_p, step),
            Event::ChildPulled { .. } | Event::LinksGathered { .. } => {}
            Event::SweepDone { .. } | Event::PassDone { .. } | Event::HierarchyDone { .. } => {
                self.current = None;
            }
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        size_of::<Self>()
            + self.elements.bytes_beyond(&before.elements)
            + self.links.bytes_beyond(&before.links)
    }
}
