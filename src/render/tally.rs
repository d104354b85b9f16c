//! How many rays of which kind a picture takes: counted, as everything else is, from the events of the run.

use crate::algorithms::ray_tracing;
use crate::algorithms::ray_tree::{self, RayKind};
use crate::record::Recorder;
use std::sync::atomic::{AtomicU64, Ordering};

/// Rays by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    pub primary: u64,
    pub shadow: u64,
    pub reflected: u64,
    pub transmitted: u64,
    pub total_internal_reflection: u64,
}

impl RayCounts {
    /// Of all kinds.
    pub fn total(&self) -> u64 {
        let secondary = self.reflected + self.transmitted + self.total_internal_reflection;
        self.primary + self.shadow + secondary
    }

    fn count(&mut self, kind: RayKind) {
        match kind {
            RayKind::Primary => self.primary += 1,
            RayKind::Reflected => self.reflected += 1,
            RayKind::Transmitted => self.transmitted += 1,
            RayKind::TotalInternalReflection => self.total_internal_reflection += 1,
        }
    }
}

impl<E: Into<ray_tracing::Event>> Recorder<E> for RayCounts {
    fn step(&mut self, _: impl FnOnce() -> E) {}

    fn enter(&mut self, event: impl FnOnce() -> E) {
        match event().into() {
            ray_tracing::Event::Tree(ray_tree::Event::Ray { kind, .. }) => self.count(kind),
            ray_tracing::Event::Tree(ray_tree::Event::ShadowRay { .. }) => self.shadow += 1,
            _ => {}
        }
    }

    fn leave(&mut self, _: impl FnOnce() -> E) {}
}

/// The sum over all threads.
#[derive(Default)]
pub(super) struct Totals([AtomicU64; 5]);

impl Totals {
    /// Adds what is counted while `work` is done.
    pub fn counting<T>(&self, work: impl FnOnce(&mut RayCounts) -> T) -> T {
        let mut counts = RayCounts::default();
        let result = work(&mut counts);
        let RayCounts {
            primary,
            shadow,
            reflected,
            transmitted,
            total_internal_reflection,
        } = counts;
        let counts = [
            primary,
            shadow,
            reflected,
            transmitted,
            total_internal_reflection,
        ];
        for (total, count) in self.0.iter().zip(counts) {
            total.fetch_add(count, Ordering::Relaxed);
        }
        result
    }

    pub fn sum(self) -> RayCounts {
        let [
            primary,
            shadow,
            reflected,
            transmitted,
            total_internal_reflection,
        ] = self.0.map(AtomicU64::into_inner);
        RayCounts {
            primary,
            shadow,
            reflected,
            transmitted,
            total_internal_reflection,
        }
    }
}
