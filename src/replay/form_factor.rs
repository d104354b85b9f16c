//! The state of a form factor at one step: the pair of patches, what was sampled so far, and the value as it runs.

use super::Fold;
use super::cow_vec::CowVec;
use crate::algorithms::form_factor::Event;
use glam::DVec3;

#[derive(Clone, Debug, Default)]
pub struct State {
    /// From patch, to patch, method; and the step that opened them.
    pub pair: Option<(u32, u32, &'static str, usize)>,
    /// F_ij by the reference, and the step that recorded it.
    pub reference: Option<(f64, usize)>,
    /// The method that an automatic choice fell on, and the step.
    pub chosen: Option<(&'static str, usize)>,
    /// Segments between the patches so far: pairs of points, rays, lines of sight.
    pub segments: CowVec<Segment>,
    /// The points of hemicubes and elements so far.
    pub points: CowVec<(DVec3, usize)>,
    /// The ends of the polygon's edge that is seen from the last point.
    pub edge: Option<([DVec3; 2], usize)>,
    /// The pixels of the current hemicube that show j: face, column, row, ΔF, step.
    pub pixels: CowVec<(u32, u32, u32, f64, usize)>,
    pub resolution: Option<u32>,
    /// The two points of a pair that has no term yet.
    open: Option<[DVec3; 2]>,
    /// A_i F_ij, or F_ij itself, as it runs: value and step.
    pub running: CowVec<(Running, usize)>,
    /// The share that nothing blocks by the lines of sight so far, with the step of each.
    pub shares: CowVec<(f64, usize)>,
    /// The value and its standard error after each batch of samples.
    pub batches: CowVec<Batch>,
    /// The share that nothing blocks, and of how many rays.
    pub visible: Option<(f64, usize)>,
    /// F_ij at last, and the step.
    pub found: Option<(f64, usize)>,
}

/// What so many samples say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Batch {
    pub samples: u32,
    pub value: f64,
    pub error: f64,
    pub step: usize,
}

/// A running value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Running {
    /// A_i F_ij.
    Exchange(f64),
    /// F_ij.
    FormFactor(f64),
    /// So many rays met j of those cast so far.
    Hits(u32),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    pub from: DVec3,
    pub way: Way,
    pub step: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// To a point of j.
    To(DVec3),
    /// A line of sight to a point of j, and whether something stands in it.
    Sight { to: DVec3, blocked: bool },
    /// A ray in a direction, and whether it met j.
    Ray { direction: DVec3, met: bool },
}

impl State {
    fn add(&mut self, from: DVec3, way: Way, step: usize) {
        self.segments.push(Segment { from, way, step });
    }

    /// F_ij so far as each step of the sum has it, with that step; of the first hemicube, pixel by pixel. `area` is A_i.
    pub fn running_values(&self, area: f64) -> Vec<(f64, usize)> {
        if self.running.len() < 2 && !self.pixels.is_empty() {
            let mut sum = 0.0;
            let pixels = self.pixels.iter();
            return pixels
                .map(|&(_, _, _, delta, step)| {
                    sum += delta;
                    (sum, step)
                })
                .collect();
        }
        let running = self.running.iter().zip(1_u32..);
        running
            .map(|(&(running, step), count)| {
                let f = match running {
                    Running::Exchange(exchange) => exchange / area,
                    Running::FormFactor(f) => f,
                    Running::Hits(hits) => f64::from(hits) / f64::from(count),
                };
                (f, step)
            })
            .collect()
    }

    /// Whether samples are taken: rays, or lines of sight.
    pub fn is_sampled(&self) -> bool {
        let is_hits = |&(running, _): &(Running, usize)| matches!(running, Running::Hits(_));
        !self.shares.is_empty() || self.running.get(0).is_some_and(is_hits)
    }

    /// Whether the running value is a mean, which can be compared with the reference, and not an unfinished sum.
    pub fn runs_as_mean(&self) -> bool {
        let running = self.running.iter();
        running
            .last()
            .is_some_and(|(running, _)| !matches!(running, Running::Exchange(_)))
    }
}

impl Fold<Event> for State {
    fn apply(&mut self, step: usize, event: &Event) {
        match *event {
            Event::Reference { f } => self.reference = Some((f, step)),
            Event::FormFactor { i, j, method } => {
                *self = State {
                    pair: Some((i, j, method, step)),
                    reference: self.reference,
                    ..State::default()
                };
            }
            Event::FacesAway
            | Event::Pieces { .. }
            | Event::Centers { .. }
            | Event::EdgeAdded { .. } => {}
            Event::Chosen { method, .. } => self.chosen = Some((method, step)),
            Event::Points { x, y } => self.open = Some([x, y]),
            Event::Pair { sum, .. } => {
                if let Some([x, y]) = self.open.take() {
                    self.add(x, Way::To(y), step);
                }
                self.running.push((Running::Exchange(sum), step));
            }
            Event::Element { x, .. } => self.points.push((x, step)),
            Event::Edge { from, to, .. } => self.edge = Some(([from, to], step)),
            Event::ElementSeen { sum, .. } => {
                self.edge = None;
                self.running.push((Running::Exchange(sum), step));
            }
            Event::EdgePair { sum, .. } => self.running.push((Running::Exchange(sum), step)),
            Event::Ray {
                x,
                direction,
                met,
                hits,
            } => {
                self.add(x, Way::Ray { direction, met }, step);
                self.running.push((Running::Hits(hits), step));
            }
            Event::Hemicube { x, resolution, .. } => {
                self.points.push((x, step));
                self.pixels = CowVec::default();
                self.resolution = Some(resolution);
            }
            Event::Pixel {
                face, x, y, delta, ..
            } => self.pixels.push((face, x, y, delta, step)),
            Event::HemicubeSeen { mean, .. } => {
                self.running.push((Running::FormFactor(mean), step));
            }
            Event::Sight {
                x,
                y,
                blocked,
                share,
            } => {
                self.add(x, Way::Sight { to: y, blocked }, step);
                self.shares.push((share, step));
            }
            Event::Rays { .. } | Event::Sights { .. } => {}
            Event::RaysCast {
                rays: samples,
                f: value,
                error,
            }
            | Event::SightsTaken {
                rays: samples,
                share: value,
                error,
            } => self.batches.push(Batch {
                samples,
                value,
                error,
                step,
            }),
            Event::Seen { x, .. } => self.points.push((x, step)),
            Event::Visible { share, .. } => self.visible = Some((share, step)),
            Event::FormFactorFound { f, .. } => self.found = Some((f, step)),
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        size_of::<Self>()
            + self.segments.bytes_beyond(&before.segments)
            + self.points.bytes_beyond(&before.points)
            + self.pixels.bytes_beyond(&before.pixels)
            + self.running.bytes_beyond(&before.running)
            + self.shares.bytes_beyond(&before.shares)
            + self.batches.bytes_beyond(&before.batches)
    }
}
