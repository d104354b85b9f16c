//! Ray tracing: every ray is followed on, reflected and refracted, and every contribution counts (Whitted, "An improved illumination
//! model for shaded display", CACM 1980, §2 and §3).
//!
//! I = I_local + k_r·trace(R) + k_t·trace(T), where I_local is the illumination model with shadows, and emission;
//! R = u − 2(u·N)N; T = (η_i/η_r)u − (cos θ_r − (η_i/η_r)cos θ_i)N with cos²θ_r = 1 − (η_i/η_r)²(1 − cos²θ_i). Where that
//! is negative, nothing passes: k_t multiplies a ray in the mirror direction (total internal reflection). The light of a
//! secondary ray is divided by a0 + a1·d + a2·d², where d is the distance to the parent surface.
//!
//! The slide prints the refraction without that case, and without the way out of the glass, where N is turned and the η change places.

use super::focus::Focus;
use super::frame::Frame;
use super::illumination::{self, Lighting};
use super::incidence::{Incidence, divisor};
use super::place::{Place, Start};
use super::prepared_scene::{self, PreparedScene};
use super::primary::{self, Settings, for_each_pixel};
use super::ray_tree::{self, Branch, RayKind};
use super::surface::{self, interact, without_object};
use super::visible::{self, Intersection, Search, touching, visible};
use crate::color::Rgb;
use crate::numeric::{refracted, refraction_radicand};
use crate::record::{Listing, Recorder};
use crate::scene::primitives::{Contact, short_of};
use crate::scene::{Material, Needs};
use glam::DVec3;

pub static PSEUDOCODE: Listing = Listing {
    name: "ray tracing",
    lines: &[
        ("pixel polygon", "{for-each-pixel-in-the-projection-plane}"),
        (
            "through",
            "  u ← {ray-from-the-reference-point-through-the-pixel}",
        ),
        ("trace", "  pixel ← trace(u, 1)"),
        ("ray", "trace(u, level)"),
        ("search", "  NearestT ← ∞;  NearestObject ← {none}"),
        ("", "  {for-every-object-in-the-scene}"),
        ("test", "    {if-the-ray-meets-it-nearer}"),
        ("nearer", "      NearestT ← t;  NearestObject ← {object}"),
        (
            "found background",
            "  {if-nothing-is-met-return-background}",
        ),
        ("light-met", "  {if-a-light-is-met-return-its-colour}"),
        ("surface", "  P ← O + NearestT · u;  N ← {normal-there}"),
        ("turned", "  {if} u · N > 0:  N ← −N"),
        ("", "  {for-each-light}"),
        ("shadow", "    {shoot-a-ray-to-the-light-in-shadow-or-not}"),
        (
            "local",
            "  I ← {ambient-and-light-that-arrives-and-emission}",
        ),
        ("reflection", "  {if-the-surface-is-reflective}"),
        (
            "reflected-too-deep",
            "    {if-level-is-the-depth-nothing-comes}",
        ),
        ("", "    I_R ← trace(R, level + 1)"),
        (
            "reflected-attenuated",
            "    I_R ← I_R / (a0 + a1·d + a2·d²)",
        ),
        ("reflected", "    I ← I + k_r · I_R"),
        ("refraction", "  {if-it-is-transparent}"),
        (
            "total",
            "    {if} cos²θ_r < 0:  T ← R   {total-internal-reflection}",
        ),
        (
            "transmitted-too-deep",
            "    {if-level-is-the-depth-nothing-comes}",
        ),
        ("", "    I_T ← trace(T, level + 1)"),
        (
            "transmitted-attenuated",
            "    I_T ← I_T / (a0 + a1·d + a2·d²)",
        ),
        ("transmitted", "    I ← I + k_t · I_T"),
        ("returned", "  {return} I"),
    ],
};

/// Ray tracing of a scene.
#[derive(Clone)]
pub struct RayTracer<'a, S> {
    pub prepared: &'a PreparedScene,
    pub settings: Settings,
    pub needs: &'a Needs,
    pub search: S,
    lighting: Lighting<'a>,
    /// The closed transparent objects that contain the eye, outermost first.
    around_eye: Media,
}

/// The transparent objects that a ray is inside, in the order in which it entered them. Outside all is air.
type Media = Vec<u32>;

/// Draws what `focus` selects of the prepared scene into `frame`.
pub fn ray_tracing<S: Search, R: Recorder<Event>>(
    tracer: &RayTracer<S>,
    focus: Focus,
    frame: &mut Frame,
    recorder: &mut R,
) {
    for_each_pixel(tracer.prepared, focus, frame, recorder, |x, y, recorder| {
        tracer.pixel(x, y, recorder)
    });
}

impl<'a, S: Search> RayTracer<'a, S> {
    pub fn new(
        prepared: &'a PreparedScene,
        settings: Settings,
        needs: &'a Needs,
        search: S,
    ) -> Self {
        let mut tracer = RayTracer {
            prepared,
            settings,
            needs,
            search,
            lighting: Lighting::of(&prepared.scene, needs.specular),
            around_eye: Media::new(),
        };
        if needs.transmission {
            let around = prepared.primitives().around(prepared.view.eye);
            let transparent = |&object: &u32| tracer.material(object).transmission != Rgb::BLACK;
            tracer.around_eye = around.into_iter().filter(transparent).collect();
        }
        tracer
    }

    /// The colour of pixel (x, y).
    pub fn pixel<R: Recorder<Event>>(&self, x: u32, y: u32, recorder: &mut R) -> Rgb {
        let samples = self.settings.samples;
        let view = &self.prepared.view;
        primary::pixel(view, samples, (x, y), recorder, |ray, recorder| {
            let (ray, between) = (*ray, None);
            let start = Start { ray, between };
            let (color, _) = self.trace(RayKind::Primary, start, 1, &self.around_eye, recorder);
            color
        })
    }

    /// The light that comes back along a ray, and the distance to the surface where it comes from, unless that is the background.
    fn trace<R: Recorder<Event>>(
        &self,
        kind: RayKind,
        Start { ray, between }: Start,
        level: u32,
        media: &Media,
        recorder: &mut R,
    ) -> (Rgb, Option<f64>) {
        let (scene, primitives) = (&self.prepared.scene, self.prepared.primitives());
        let opened = ray_tree::Event::Ray {
            kind,
            level: level as u16,
            ray,
        };
        recorder.enter(|| opened.into());
        let balls = self.needs.light_balls;
        let seen = match between {
            Some(between) => touching(scene, between.hit(), recorder),
            None => visible(self.search, scene, primitives, balls, &ray, recorder),
        };
        let met = seen.met;
        let Intersection::Object(hit) = met else {
            let color = without_object(scene, &met, recorder);
            recorder.leave(|| ray_tree::Event::Returned { color }.into());
            return (color, met.t().is_finite().then_some(met.t()));
        };
        let interaction = interact(scene, primitives, self.needs, &ray, &hit, recorder);
        let place = Place {
            hit,
            interaction,
            between: between.or(seen.contact.as_ref().map(Contact::start)),
        };
        let interaction = &place.interaction;
        let mut sum = self.local(&place, recorder);

        // The reflected ray
        let Material {
            reflection: k_r,
            transmission: k_t,
            ..
        } = *interaction.point.material;
        let (u, n) = (ray.direction, interaction.normal);
        let mirrored = u - 2.0 * u.dot(n) * n;
        let branch = |kind, coefficient, direction| Branch {
            kind,
            coefficient,
            direction,
        };
        if self.needs.reflects(interaction.point.material) {
            let reflected = branch(RayKind::Reflected, k_r, mirrored);
            sum = self.follow(&reflected, &place, level, media, sum, recorder);
        } else {
            recorder.step(|| ray_tree::Event::no_coefficient(RayKind::Reflected).into());
        }

        // The refracted ray
        if self.needs.transmits(interaction.point.material) {
            let beyond = self.beyond(&place, media);
            let eta_i = self.ior(media);
            let eta_r = self.ior(&beyond);
            let eta = eta_i / eta_r;
            let cos_i = interaction.cos_theta_i;
            let radicand = refraction_radicand(eta, cos_i);
            recorder.step(|| {
                ray_tree::Event::Refraction {
                    eta_i,
                    eta_r,
                    cos_theta_i: cos_i,
                    radicand,
                }
                .into()
            });
            let (transmitted, inside) = if radicand < 0.0 {
                let mirrored = branch(RayKind::TotalInternalReflection, k_t, mirrored);
                (mirrored, media)
            } else {
                // Near the critical angle rounding decides the sign of the radicand: it is tested before the root is taken.
                let t = refracted(u.to_array(), n.to_array(), eta, cos_i, radicand);
                let t = DVec3::from_array(t).normalize();
                (branch(RayKind::Transmitted, k_t, t), &beyond)
            };
            sum = self.follow(&transmitted, &place, level, inside, sum, recorder);
        } else {
            recorder.step(|| ray_tree::Event::no_coefficient(RayKind::Transmitted).into());
        }

        recorder.leave(|| ray_tree::Event::Returned { color: sum }.into());
        (sum, Some(hit.t))
    }

    /// The illumination model with shadows, and emission.
    fn local<R: Recorder<Event>>(&self, place: &Place, recorder: &mut R) -> Rgb {
        let Place {
            hit, interaction, ..
        } = place;
        let emission = interaction.point.material.emission;
        let local = interaction.local(&self.lighting, recorder, |incidence, recorder| {
            let shadows = self.needs.shadow(incidence.light, hit.object as usize);
            !(shadows && self.in_shadow(place, incidence, recorder))
        });
        recorder.step(|| ray_tree::Event::Local { emission, local }.into());
        local
    }

    /// Whether an object that casts a shadow lies between the surface and a light.
    fn in_shadow<R: Recorder<Event>>(
        &self,
        place: &Place,
        incidence: &Incidence,
        recorder: &mut R,
    ) -> bool {
        let (scene, primitives) = (&self.prepared.scene, self.prepared.primitives());
        let (light, direction) = (incidence.light as u32, incidence.to_light);
        let distance = incidence.distance;
        let ray = place.past_all(direction);
        recorder.enter(|| {
            ray_tree::Event::ShadowRay {
                light,
                origin: ray.origin,
                direction,
                distance,
            }
            .into()
        });
        let touching = place.leaving(direction, false).blocker(scene, recorder);
        let blocker = touching.or_else(|| {
            let between = short_of(&ray, &place.interaction.surface, distance);
            let search = self.search;
            search.blocker(scene, primitives, &ray, between, recorder)
        });
        recorder.leave(|| {
            ray_tree::Event::Shadow {
                light,
                blocked: blocker.is_some(),
                by: blocker.and_then(|blocker| blocker.hit),
            }
            .into()
        });
        blocker.is_some()
    }

    /// Adds to the sum so far what comes back along a secondary ray.
    fn follow<R: Recorder<Event>>(
        &self,
        branch: &Branch,
        place: &Place,
        level: u32,
        media: &Media,
        sum: Rgb,
        recorder: &mut R,
    ) -> Rgb {
        let &Branch {
            kind,
            coefficient,
            direction,
        } = branch;
        recorder.step(|| ray_tree::Event::Branched { branch: *branch }.into());
        if level >= self.settings.depth.get() {
            recorder.step(|| ray_tree::Event::too_deep(kind).into());
            return sum;
        }
        let start = place.leaving(direction, kind == RayKind::Transmitted);
        let (color, distance) = self.trace(kind, start, level + 1, media, recorder);

        let mut carried = color;
        if self.needs.path_attenuation
            && let Some(d) = distance
        {
            let attenuation = self.prepared.scene.path_attenuation;
            carried = (color / divisor(attenuation, d)).finite();
            recorder.step(|| {
                ray_tree::Event::Attenuated {
                    kind,
                    distance: d,
                    attenuation,
                    carried,
                }
                .into()
            });
        }
        let sum = (sum + coefficient * carried).finite();
        recorder.step(|| ray_tree::Event::Added { kind, carried, sum }.into());
        sum
    }

    /// The media on the other side of the surface: with the object where the ray enters it, without it where it leaves. A surface that is
    /// not closed is a thin pane, with the same media on both sides.
    fn beyond(&self, place: &Place, media: &Media) -> Media {
        let object = place.hit.object;
        let mut beyond = media.clone();
        if !self.prepared.primitives().is_transparent_body(object) {
            return beyond;
        }
        if place.interaction.entering {
            beyond.push(object);
        } else if let Some(innermost) = beyond.iter().rposition(|&inside| inside == object) {
            beyond.remove(innermost);
        }
        beyond
    }

    /// η of the innermost medium; 1, air, outside all.
    fn ior(&self, media: &Media) -> f64 {
        media
            .last()
            .map_or(1.0, |&object| self.material(object).ior)
    }

    fn material(&self, object: u32) -> &Material {
        let scene = &self.prepared.scene;
        &scene.materials[scene.objects[object as usize].material]
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    PreparedScene(prepared_scene::Event),
    Primary(primary::Event),
    Visible(visible::Event),
    Surface(surface::Event),
    Illumination(illumination::Event),
    Tree(ray_tree::Event),
}

const _: () = assert!(size_of::<Event>() <= 64);

contains_events! {
    [] Event {
        prepared_scene::Event => Event::PreparedScene,
        primary::Event => Event::Primary,
        visible::Event => Event::Visible,
        surface::Event => Event::Surface,
        illumination::Event => Event::Illumination,
        ray_tree::Event => Event::Tree,
    }
}
