//! SolveSystem: passes from coarse to fine, each of which refines the links and gathers over them until the light has settled.

use super::event::Event;
use super::link::{Link, LinksOf};
use super::oracle::Oracle;
use super::settings::{COARSER, Settings};
use super::tree::{Element, Tree};
use crate::algorithms::enclosure::Enclosure;
use crate::color::Rgb;
use crate::record::Recorder;

/// The change at which a pass ends that is not the last one: its light says only which links are refined next.
const SETTLED_ENOUGH: f64 = 1e-2;

/// After so many gatherings it is looked how much less the light changes.
const LOOK: u32 = 100;

/// So many links take 1.5 GiB at most.
pub(super) const MOST_LINKS: usize = 1 << 25;

/// Why there is no result.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Unsolved {
    #[error(
        "the light of the elements still changes by {change:e} of the largest radiosity after {sweeps} gatherings over all links, and \
         would not settle in time: too little light is lost, or links are too coarse for surfaces that reflect so much"
    )]
    Unsettled { sweeps: u32, change: f64 },
    #[error(
        "more than {MOST_LINKS} links are needed; links that may carry more light (link_light) are fewer, and so are those of fewer patches"
    )]
    TooManyLinks,
}

/// What a gathering changes of a leaf at most, also as a share of the largest radiosity.
struct Change {
    most: f64,
    share: f64,
}

/// The elements of an enclosure, their links, and their light.
#[derive(Clone, Debug)]
pub struct Hierarchy<'a> {
    pub enclosure: &'a Enclosure,
    pub settings: Settings,
    pub tree: Tree,
    /// By number; none where a link was refined.
    pub links: Vec<Option<Link>>,
    pub(super) links_of: LinksOf,
    /// By element: B, and what it has gathered over its own links.
    pub b: Vec<Rgb>,
    pub(super) b_g: Vec<Rgb>,
    pub sweeps: u32,
}

impl<'a> Hierarchy<'a> {
    /// The roots, which only emit, without any link.
    pub fn new(enclosure: &'a Enclosure, settings: Settings) -> Self {
        let tree = Tree::of(enclosure);
        Hierarchy {
            enclosure,
            settings,
            links: Vec::new(),
            links_of: LinksOf::default(),
            b: tree.elements.iter().map(|root| root.emission).collect(),
            b_g: vec![Rgb::BLACK; tree.elements.len()],
            tree,
            sweeps: 0,
        }
    }

    pub fn element(&self, number: u32) -> &Element {
        &self.tree.elements[number as usize]
    }

    /// Whether no more links are made.
    pub(super) fn is_full(&self) -> bool {
        self.links.len() >= MOST_LINKS
    }

    /// How many links there are now.
    pub fn link_count(&self) -> u32 {
        self.links.iter().flatten().count() as u32
    }

    /// B by patch: that of the leaf it lies in.
    pub fn by_patch(&self) -> Vec<Rgb> {
        self.tree
            .by_patch(&self.enclosure.patches, Rgb::BLACK, |leaf| {
                self.b[leaf as usize]
            })
    }

    /// Σ A E, in the channel that has the most.
    fn flux(&self) -> f64 {
        let roots = self.tree.elements[..self.tree.roots as usize].iter();
        let sum: Rgb = roots.map(|root| root.emission * root.area).sum();
        sum.max_channel()
    }

    /// SolveSystem. `go_on` is asked now and then. Errors: its own; inside, why there is no result.
    pub fn solve<R: Recorder<Event>, E>(
        &mut self,
        recorder: &mut R,
        mut go_on: impl FnMut() -> Result<(), E>,
    ) -> Result<Result<(), Unsolved>, E> {
        let (roots, flux) = (self.tree.roots, self.flux());
        recorder.enter(|| Event::Hierarchy {
            roots,
            patches: self.enclosure.patches.len() as u32,
            flux,
        });
        let Settings {
            passes,
            link_light,
            link_size,
            ..
        } = self.settings;
        let mut settled = Ok(());
        for pass in 0..=passes {
            let coarser = COARSER.powi((passes - pass) as i32);
            let oracle = match pass {
                0 => Oracle::FormFactor(link_size),
                _ => Oracle::Carried(link_light * coarser * flux),
            };
            let allowed = oracle.allowed();
            recorder.enter(|| Event::Pass { pass, allowed });
            if pass == 0 {
                self.link_roots(oracle, recorder, &mut go_on)?;
            } else {
                self.refine_links(oracle, recorder, &mut go_on)?;
            }
            settled = match self.is_full() {
                true => Err(Unsolved::TooManyLinks),
                false => {
                    self.links_of = LinksOf::of(self.tree.elements.len(), &self.links);
                    self.settle(pass == passes, recorder, &mut go_on)?
                }
            };
            recorder.leave(|| Event::PassDone {
                elements: self.tree.elements.len() as u32,
                links: self.link_count(),
            });
            if settled.is_err() {
                break;
            }
        }
        recorder.leave(|| Event::HierarchyDone {
            elements: self.tree.elements.len() as u32,
            leaves: self.tree.leaves().count() as u32,
            links: self.link_count(),
        });
        Ok(settled)
    }

    /// Gathers, pushes and pulls until the light changes no more.
    fn settle<R: Recorder<Event>, E>(
        &mut self,
        is_last: bool,
        recorder: &mut R,
        go_on: &mut impl FnMut() -> Result<(), E>,
    ) -> Result<Result<(), Unsolved>, E> {
        let stop = self.enclosure.settings.stop;
        let enough = match is_last {
            true => stop.tolerance,
            false => SETTLED_ENOUGH.max(stop.tolerance),
        };
        let (mut before, mut at_last_look) = (f64::INFINITY, f64::INFINITY);
        for sweeps in 1.. {
            go_on()?;
            let Change { most, share } = self.sweep(recorder);
            // A pass that is not the last one may gain light, as its links are coarse.
            let gains = most >= before && share.is_finite();
            if share <= enough || gains && !is_last {
                break;
            }
            before = most;
            let mut left = match share.is_finite() {
                true => stop.max_iterations.saturating_sub(self.sweeps),
                false => 0,
            };
            if sweeps % LOOK == 0 {
                let looks = (enough / share).ln() / (most / at_last_look).ln();
                at_last_look = most;
                // What changes as much as before never settles: then this is no number from 0 up.
                if !(0.0..=f64::from(left / LOOK)).contains(&looks) {
                    left = 0;
                }
            }
            if left == 0 {
                return Ok(Err(Unsolved::Unsettled {
                    sweeps: self.sweeps,
                    change: share,
                }));
            }
        }
        Ok(Ok(()))
    }

    /// One gathering over all links, and the push–pull after it.
    fn sweep<R: Recorder<Event>>(&mut self, recorder: &mut R) -> Change {
        let sweep = self.sweeps;
        recorder.enter(|| Event::Sweep { sweep });
        let before = self.b.clone();
        (0..self.tree.roots).for_each(|root| self.gather(root, recorder));
        for root in 0..self.tree.roots {
            self.push_pull(root, Rgb::BLACK, recorder);
        }
        let (mut most, mut largest) = (0.0_f64, 0.0_f64);
        for leaf in self.tree.leaves() {
            let b = self.b[leaf as usize].channels();
            for (b, old) in b.into_iter().zip(before[leaf as usize].channels()) {
                most = most.max((b - old).abs());
                largest = largest.max(b);
            }
        }
        let share = match largest.is_finite() {
            true if most == 0.0 => 0.0,
            true => most / largest,
            false => f64::INFINITY,
        };
        self.sweeps += 1;
        recorder.leave(|| Event::SweepDone { change: share });
        Change { most, share }
    }
}
