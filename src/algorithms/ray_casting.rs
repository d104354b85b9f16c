//! Ray casting: the visible surface at every pixel by a ray, lit by the illumination model alone (Appel 1968; the name after
//! Roth, "Ray casting for modeling solids", 1982).
//!
//! No shadows, no reflections, no refraction: what the scan-line methods show, found pixel by pixel instead of polygon by polygon.

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{self, Lighting, illuminate};
use super::prepared_scene::{self, PreparedScene};
use super::primary::{self, for_each_pixel};
use super::surface::{self, face, without_object};
use super::visible::{self, Intersection, Search, visible};
use crate::color::Rgb;
use crate::record::{self, Fields, Line, Listing, Recorder};
use crate::scene::Needs;
use crate::scene::primitives::Ray;

pub static PSEUDOCODE: Listing = Listing {
    name: "ray casting",
    lines: &[
        "for each pixel in the projection plane",
        "  u ← ray from the reference point through the pixel",
        "  NearestT ← ∞;  NearestObject ← none",
        "  for every object in the scene",
        "    if the ray meets it and t < NearestT",
        "      NearestT ← t;  NearestObject ← object",
        "  if NearestObject is none",
        "    pixel ← background",
        "  otherwise",
        "    I ← illumination(P, N) + emission",
        "    pixel ← I",
    ],
};

/// Ray casting on a stage.
#[derive(Clone, Copy)]
pub struct RayCaster<'a, S> {
    pub prepared: &'a PreparedScene,
    pub needs: &'a Needs,
    pub search: S,
}

/// Draws the part of the stage that `focus` takes into `frame`.
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
    pub fn new(prepared: &'a PreparedScene, needs: &'a Needs, search: S) -> Self {
        RayCaster {
            prepared,
            needs,
            search,
        }
    }

    /// The colour of pixel (x, y).
    pub fn pixel<R: Recorder<Event>>(&self, x: u32, y: u32, recorder: &mut R) -> Rgb {
        let samples = self.prepared.settings.samples;
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
        let met = visible(self.search, scene, primitives, balls, ray, recorder);
        let color = match met {
            Intersection::Nothing | Intersection::Light { .. } => {
                without_object(scene, &met, recorder)
            }
            Intersection::Object(hit) => {
                let interaction = face(scene, primitives, self.needs, ray, &hit, recorder);
                let lighting = Lighting {
                    specular: self.needs.specular,
                    ..self.prepared.lighting()
                };
                let lit = illuminate(&interaction.point, &lighting, recorder, |_, _| true).whole;
                let emission = interaction.point.material.emission;
                let local = (lit + emission).finite();
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
    /// The light of the lights and the light given off, together.
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

impl From<prepared_scene::Event> for Event {
    fn from(event: prepared_scene::Event) -> Self {
        Event::PreparedScene(event)
    }
}

impl From<primary::Event> for Event {
    fn from(event: primary::Event) -> Self {
        Event::Primary(event)
    }
}

impl From<visible::Event> for Event {
    fn from(event: visible::Event) -> Self {
        Event::Visible(event)
    }
}

impl From<surface::Event> for Event {
    fn from(event: surface::Event) -> Self {
        Event::Surface(event)
    }
}

impl From<illumination::Event> for Event {
    fn from(event: illumination::Event) -> Self {
        Event::Illumination(event)
    }
}

impl record::Event for Event {
    fn kind(&self) -> &'static str {
        match self {
            Event::PreparedScene(event) => event.kind(),
            Event::Primary(event) => event.kind(),
            Event::Ray { .. } => "Ray",
            Event::Visible(event) => event.kind(),
            Event::Surface(event) => event.kind(),
            Event::Illumination(event) => event.kind(),
            Event::Local { .. } => "Local",
            Event::Returned { .. } => "Returned",
        }
    }

    fn line(&self) -> Line {
        let number = match self {
            Event::PreparedScene(_) | Event::Primary(primary::Event::Pixel { .. }) => 0,
            Event::Primary(primary::Event::Through { .. }) | Event::Ray { .. } => 1,
            Event::Visible(visible::Event::Search { .. }) => 2,
            Event::Visible(event) if event.found_nearer() => 5,
            Event::Visible(visible::Event::Found { .. }) => 6,
            Event::Visible(_) => 4,
            Event::Surface(surface::Event::Background { .. } | surface::Event::LightMet { .. }) => {
                7
            }
            Event::Surface(_) => 8,
            Event::Illumination(event) => return event.line(),
            Event::Local { .. } => 9,
            Event::Returned { .. } | Event::Primary(primary::Event::PixelColored { .. }) => 10,
        };
        Line {
            listing: &PSEUDOCODE,
            number,
        }
    }

    fn holds_on(&self) -> bool {
        match self {
            // A pixel of several samples goes through several points.
            Event::Primary(primary::Event::Through { .. }) => false,
            Event::Visible(event) => !event.tests_one(),
            _ => true,
        }
    }

    fn fields(&self, fields: &mut Fields) {
        match *self {
            Event::PreparedScene(event) => event.fields(fields),
            Event::Primary(event) => event.fields(fields),
            Event::Ray { ray } => {
                fields.push("O", ray.origin).push("u", ray.direction);
            }
            Event::Visible(event) => event.fields(fields),
            Event::Surface(event) => event.fields(fields),
            Event::Illumination(event) => event.fields(fields),
            Event::Local { emission, local } => {
                fields.push("emission", emission).push("I_local", local);
            }
            Event::Returned { color } => {
                fields.push("I", color);
            }
        }
    }
}
