//! A scene as radiosity sees it: patches, what stands between them, and their form factors.

use super::form_factor::{Blockers, FormFactors, Method};
use crate::scene::Scene;
use crate::scene::patches::{PatchError, Patches};
use std::sync::OnceLock;

/// How the form factors of a room are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exchange {
    pub method: Method,
    /// Whether what stands between two patches counts. What lies behind one of them never exchanges with it.
    pub visibility: bool,
}

impl Default for Exchange {
    fn default() -> Self {
        Exchange {
            method: Method::Auto { tolerance: 1e-6 },
            visibility: true,
        }
    }
}

/// The patches of a scene. Their matrix is made when it is first asked for.
#[derive(Clone, Debug)]
pub struct Room {
    pub patches: Patches,
    pub blockers: Blockers,
    pub exchange: Exchange,
    matrix: OnceLock<Vec<f64>>,
}

impl Room {
    /// `most` patches are allowed. Errors: planes, patches without area, too many patches.
    pub fn of(scene: &Scene, exchange: Exchange, most: u64) -> Result<Room, PatchError> {
        let patches = Patches::of(scene, most)?;
        let blockers = Blockers::of(scene, &patches);
        Ok(Room {
            patches,
            blockers,
            exchange,
            matrix: OnceLock::new(),
        })
    }

    /// By the pair, by the row, or all of them.
    pub fn form_factors(&self) -> FormFactors<'_> {
        let blockers = self.exchange.visibility.then_some(&self.blockers);
        FormFactors::new(&self.patches, self.exchange.method, blockers)
    }

    /// F, row-major, n×n for n patches; `make` makes it where it is not there yet.
    pub fn matrix_or(&self, make: impl FnOnce() -> Vec<f64>) -> &[f64] {
        self.matrix.get_or_init(make)
    }

    /// F, where it was made.
    pub fn matrix(&self) -> Option<&[f64]> {
        self.matrix.get().map(Vec::as_slice)
    }

    /// How many bytes a matrix of all form factors takes.
    pub fn matrix_bytes(&self) -> u64 {
        let n = self.patches.len() as u64;
        n.saturating_mul(n).saturating_mul(8)
    }
}
