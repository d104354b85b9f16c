//! Ray casting: the visible surface at every pixel by a ray, lit by the illumination model alone (Appel 1968; the name after
//! Roth, "Ray casting for modeling solids", 1982).
//!
//! No shadows, no reflections, no refraction: the picture is that of the scan-line methods, found pixel by pixel instead of polygon
//! by polygon.

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{self, Lighting};
use super::prepared_scene::{self, PreparedScene};
use super::primary::{self, Settings, for_each_pixel};
use super::surface::{self, interact, without_object};
use super::visible::{self, Intersection, Search, visible};
use crate::color::Rgb;
use crate::record::{Listing, Recorder};
use crate::scene::Needs;
use crate::scene::primitives::Ray;

pub static PSEUDOCODE: Listing = Listing {
    name: "ray casting",
    lines: &[
        ("pixel polygon", "{for-each-pixel-in-the-projection-plane}"),
        (
            "through ray",
            "  u ← {ray-from-the-reference-point-through-the-pixel}",
        ),
        ("search", "  NearestT ← ∞;  NearestObject ← {none}"),
        ("", "  {for-every-object-in-the-scene}"),
        ("test", "    {if-the-ray-meets-it-nearer}"),
        ("nearer", "      NearestT ← t;  NearestObject ← {object}"),
        ("found", "  {if-nothing-is-met}"),
        ("background", "    pixel ← {background}"),
        ("light-met", "  {if-a-light-is-met-its-colour}"),
        (
            "surface",
            "  {otherwise}  P ← O + NearestT · u;  N ← {normal-there}",
        ),
        ("turned", "    {if} u · N > 0:  N ← −N"),
        ("local", "    I ← illumination(P, N) + {emission}"),
        ("returned trace", "    pixel ← I"),
    ],
};

/// Ray casting of a scene.
#[derive(Clone, Copy)]
pub struct RayCaster<'a, S> {
    pub prepared: &'a PreparedScene,
    pub settings: Settings,
    pub needs: &'a Needs,
    pub search: S,
    lighting: Lighting<'a>,
}

/// Draws what `focus` selects of the prepared scene into `frame`.
pub fn ray_casting<S: Search, R: Recorder<Event>>(
    caster: &RayCaster<S>,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    for_each_pixel(caster.prepared, focus, frame, recorder, |x, y, recorder| {
        caster.pixel(x, y, recorder)
    });
}

impl<'a, S: Search> RayCaster<'a, S> {
    pub fn new(
        prepared: &'a PreparedScene,
        settings: Settings,
        needs: &'a Needs,
        search: S,
    ) -> Self {
        RayCaster {
            prepared,
            settings,
            needs,
            search,
            lighting: Lighting::of(&prepared.scene, needs.specular),
        }
    }

    /// The colour of pixel (x, y).
    pub fn pixel<R: Recorder<Event>>(&self, x: u32, y: u32, recorder: &mut R) -> Rgb {
        let samples = self.settings.samples;
        let view = &self.prepared.view;
        primary::pixel(view, samples, (x, y), recorder, |ray, recorder| {
            self.cast(ray, recorder)
        })
    }

    /// The light that comes back along a ray.
    fn cast<R: Recorder<Event>>(&self, ray: &Ray, recorder: &mut R) -> Rgb {
        let (scene, primitives) = (&self.prepared.scene, self.prepared.primitives());
        recorder.enter(|| Event::Ray { ray: *ray });
        let balls = self.needs.light_balls;
        let met = visible(self.search, scene, primitives, balls, ray, recorder).met;
        let color = match met {
            Intersection::Nothing | Intersection::Light { .. } => {
                without_object(scene, &met, recorder)
            }
            Intersection::Object(hit) => {
                let interaction = interact(scene, primitives, self.needs, ray, &hit, recorder);
                let emission = interaction.point.material.emission;
                let local = interaction.local(&self.lighting, recorder, |_, _| true);
                recorder.step(|| Event::Local { emission, local });
                local
            }
        };
        recorder.leave(|| Event::Returned { color });
        color
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    PreparedScene(prepared_scene::Event),
    Primary(primary::Event),
    /// Opens a ray; its direction is unit.
    Ray {
        ray: Ray,
    },
    Visible(visible::Event),
    Surface(surface::Event),
    Illumination(illumination::Event),
    /// The light of the lights and emission, together.
    Local {
        emission: Rgb,
        local: Rgb,
    },
    /// Closes `Ray`.
    Returned {
        color: Rgb,
    },
}

const _: () = assert!(size_of::<Event>() <= 64);

contains_events! {
    [] Event {
        prepared_scene::Event => Event::PreparedScene,
        primary::Event => Event::Primary,
        visible::Event => Event::Visible,
        surface::Event => Event::Surface,
        illumination::Event => Event::Illumination,
    }
}
