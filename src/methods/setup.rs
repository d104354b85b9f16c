//! What a run starts from: a prepared scene with the settings of the methods.

use super::hierarchical::{Linked, NoLight};
use super::{Family, Method, Settings};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::patch_view::seen_patches;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::shading::ShadedScene;
use crate::algorithms::texture::Texturing;
use crate::scene::patches::PatchError;
use crate::scene::{LeftOut, Light, Needs, Part, Parts, Texture, View};
use std::sync::{Arc, OnceLock};

/// A scene that any method can draw, and what is found of it once.
#[derive(Clone, Debug)]
pub struct Setup {
    pub prepared: Arc<PreparedScene>,
    pub settings: Settings,
    /// What is done although the scene does not need it.
    forced: Parts,
    needs: OnceLock<Needs>,
    enclosure: OnceLock<Result<Enclosure, PatchError>>,
    /// The light of hierarchical radiosity.
    pub(super) linked: OnceLock<Result<Linked, NoLight>>,
    /// The patch in the middle of each pixel, row by row.
    seen: OnceLock<Vec<Option<u32>>>,
}

/// Something that is looked at, but is not there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{value}: there are {count} {what}, counted from 0")]
pub struct Outside {
    pub what: &'static str,
    pub value: usize,
    pub count: usize,
}

impl Setup {
    pub fn new(prepared: impl Into<Arc<PreparedScene>>, settings: impl Into<Settings>) -> Self {
        Setup {
            prepared: prepared.into(),
            settings: settings.into(),
            forced: Parts::NONE,
            needs: OnceLock::new(),
            enclosure: OnceLock::new(),
            linked: OnceLock::new(),
            seen: OnceLock::new(),
        }
    }

    /// The same, with those parts done although the scene does not need them, and no others.
    pub fn with_forced(&self, forced: Parts) -> Self {
        Setup {
            forced,
            ..Setup::new(self.prepared.clone(), self.settings.clone())
        }
    }

    /// The same under other lights.
    pub fn with_lights(&self, lights: Vec<Light>) -> Self {
        let prepared = (*self.prepared).clone().with_lights(lights);
        Setup {
            prepared: Arc::new(prepared),
            needs: OnceLock::new(),
            ..self.clone()
        }
    }

    /// What is done although the scene does not need it.
    pub fn forced(&self) -> Parts {
        self.forced
    }

    /// The scene as the scan-line methods light it: with what it needs, and what is done although it does not.
    pub fn shaded_scene(&self) -> ShadedScene<'_> {
        let mut scene = ShadedScene::of(&self.prepared);
        let white = self.forced.has(Part::TextureCoordinates);
        scene.lighting.specular |= self.forced.has(Part::Highlights);
        scene.texturing = Texturing {
            plain: white.then_some(Texture::WHITE),
            mapping: self.settings.get(),
        };
        scene
    }

    /// What rays need of the scene.
    pub fn needs(&self) -> &Needs {
        self.needs
            .get_or_init(|| Needs::of(&self.prepared.scene).with_forced(self.forced))
    }

    /// The scene divided into patches. Errors: what cannot be divided.
    pub fn enclosure(&self) -> Result<&Enclosure, &PatchError> {
        let enclosure = self
            .enclosure
            .get_or_init(|| Enclosure::of(&self.prepared.scene, self.settings.get(), self.forced));
        enclosure.as_ref()
    }

    /// The patches in the middle of the pixels, row by row: none where the picture shows none, or the back of one. Found on first
    /// use; empty where the scene cannot be divided into patches.
    pub fn seen_patches(&self) -> &[Option<u32>] {
        self.seen.get_or_init(|| {
            self.enclosure().map_or_else(
                |_| Vec::new(),
                |room| seen_patches(room, &self.prepared.view),
            )
        })
    }

    /// The patch in the middle of pixel (x, y).
    pub fn patch_at(&self, x: u32, y: u32) -> Option<usize> {
        let View { width, .. } = self.prepared.view;
        let index = y as usize * width as usize + x as usize;
        let seen = self.seen_patches().get(index).filter(|_| x < width)?;
        seen.map(|patch| patch as usize)
    }

    /// What the scene does not need of what `method` would do, forced or not. A scene that cannot be divided into patches needs
    /// nothing of radiosity.
    pub fn skipped(&self, method: Method) -> Vec<LeftOut> {
        let all = match method.family() {
            Family::Exchange => self
                .enclosure()
                .map_or(&[][..], |enclosure| enclosure.skipped()),
            Family::Hierarchy => &[],
            Family::Polygons | Family::Rays => &self.needs().skipped,
        };
        let done = all
            .iter()
            .filter(|skipped| method.parts().contains(&skipped.part));
        done.cloned().collect()
    }

    /// Whether `method` can run. Errors: of radiosity, what cannot be divided into patches.
    pub fn check_for(&self, method: Method) -> Result<(), &PatchError> {
        match method.family() {
            Family::Exchange | Family::Hierarchy => self.enclosure().map(drop),
            Family::Polygons | Family::Rays => Ok(()),
        }
    }

    /// Whether the scene has what `focus` looks at. Errors: what it has instead.
    pub fn check(&self, focus: Focus) -> Result<(), Outside> {
        let within = |what, value: usize, count: usize| match value < count {
            true => Ok(()),
            false => Err(Outside { what, value, count }),
        };
        let View { width, height, .. } = self.prepared.view;
        let polygons = self.prepared.tessellation.polygon_count();
        let patches = || {
            self.enclosure()
                .map_or(0, |enclosure| enclosure.patches.len())
        };
        match focus {
            Focus::Frame | Focus::Iterations { .. } => Ok(()),
            Focus::Polygon(number) => within("polygons", number, polygons),
            Focus::ScanLine(y) => within("rows", y as usize, height as usize),
            Focus::Pixel { x, y } => within("columns", x as usize, width as usize)
                .and_then(|()| within("rows", y as usize, height as usize)),
            Focus::Patch(number) => within("patches", number as usize, patches()),
            Focus::FormFactor { i, j } => within("patches", i.max(j) as usize, patches()),
        }
    }
}
