//! Hierarchical radiosity: the light that elements of an enclosure exchange over links, seen from the camera.

use super::{Family, Properties, Setup, Visitor};
use crate::algorithms::hierarchical::{Event, Hierarchy, Unsolved};
use crate::color::Rgb;
use crate::record::{Recorder, Unrecorded};
use crate::scene::Part;
use crate::scene::patches::PatchError;

pub enum HierarchicalRadiosity {}

impl Properties for HierarchicalRadiosity {
    const NAME: &'static str = "hierarchical-radiosity";
    const FAMILY: Family = Family::Hierarchy;
    const PARTS: &'static [Part] = &[];

    fn visit<V: Visitor>(visitor: V) -> V::Output {
        visitor.hierarchical()
    }
}

/// The light of a scene's patches, and what it took.
#[derive(Clone, Debug)]
pub struct Linked {
    /// B by patch.
    pub radiosity: Vec<Rgb>,
    pub elements: usize,
    pub leaves: usize,
    pub links: u32,
    /// How often light was gathered over all links.
    pub sweeps: u32,
}

impl Linked {
    pub fn of(hierarchy: &Hierarchy) -> Self {
        Linked {
            radiosity: hierarchy.by_patch(),
            elements: hierarchy.tree.elements.len(),
            leaves: hierarchy.tree.leaves().count(),
            links: hierarchy.link_count(),
            sweeps: hierarchy.sweeps,
        }
    }
}

/// Why there is no light.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NoLight {
    #[error(transparent)]
    Patches(PatchError),
    #[error(transparent)]
    Unsolved(#[from] Unsolved),
}

/// The elements of the scene with their links and light. Errors: those of `go_on`, which is asked now and then; inside, why there is none.
pub fn solve<'a, R: Recorder<Event>, E>(
    setup: &'a Setup,
    recorder: &mut R,
    go_on: impl FnMut() -> Result<(), E>,
) -> Result<Result<Hierarchy<'a>, NoLight>, E> {
    let enclosure = match setup.enclosure() {
        Ok(enclosure) => enclosure,
        Err(why) => return Ok(Err(NoLight::Patches(why.clone()))),
    };
    let mut hierarchy = Hierarchy::new(enclosure, setup.settings.get());
    let settled = hierarchy.solve(recorder, go_on)?;
    Ok(settled.map(|()| hierarchy).map_err(NoLight::from))
}

/// The light of the scene, solved for on first use. Errors: as of [`solve`].
pub fn light<E>(
    setup: &Setup,
    go_on: impl FnMut() -> Result<(), E>,
) -> Result<Result<&Linked, &NoLight>, E> {
    let known = match setup.linked.get() {
        Some(known) => known,
        None => {
            let solved = solve(setup, &mut Unrecorded, go_on)?;
            let solved = solved.map(|hierarchy| Linked::of(&hierarchy));
            setup.linked.get_or_init(|| solved)
        }
    };
    Ok(known.as_ref())
}
