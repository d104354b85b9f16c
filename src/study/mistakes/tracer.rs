//! A ray tracer as a student writes it in one evening, with one classic mistake or none.
//!
//! It knows nothing of surfaces that touch, and it leaves out nothing that a scene does not need. With no mistake it draws what the
//! reference draws.

use super::model::Model;
use super::{Mistake, Workers};
use crate::algorithms::frame::Frame;
use crate::algorithms::illumination::SurfacePoint;
use crate::algorithms::incidence::{Incidence, divisor};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary;
use crate::algorithms::ray_tracing::Event;
use crate::algorithms::surface::without_object;
use crate::algorithms::visible::{Bvh, Intersection, visible};
use crate::color::Rgb;
use crate::methods::Setup;
use crate::numeric::{refracted, refraction_radicand};
use crate::record::Unrecorded;
use crate::render::Painter;
use crate::scene::Material;
use crate::scene::primitives::{Hit, Part, Ray, Surface, leaving, short_of};
use glam::DVec3;

pub struct Tracer<'a> {
    setup: &'a Setup,
    prepared: &'a PreparedScene,
    settings: primary::Settings,
    /// Ray casting: no shadows, and no rays but primary ones.
    only_casts: bool,
    model: Model<'a>,
}

/// Where a ray meets a surface.
struct Place<'a> {
    ray: &'a Ray,
    hit: Hit,
    surface: Surface,
    /// Turned toward the ray, of unit length: both unless that is the mistake.
    normal: DVec3,
    material: &'a Material,
}

/// The transparent objects that a ray is inside, in the order in which it entered them.
type Media = Vec<u32>;

impl<'a> Tracer<'a> {
    pub fn new(setup: &'a Setup, only_casts: bool, mistake: Option<Mistake>) -> Self {
        Tracer {
            setup,
            prepared: &setup.prepared,
            settings: setup.settings.get(),
            only_casts,
            model: Model {
                scene: &setup.prepared.scene,
                mistake,
            },
        }
    }

    /// None where it is called off.
    pub fn picture(&self, workers: Workers) -> Option<Frame> {
        let painter = Painter::new(self.prepared, workers.threads, |_, _| (workers.go_on)());
        let around = self.prepared.primitives().around(self.prepared.view.eye);
        let transparent = |&object: &u32| self.material(object).transmission != Rgb::BLACK;
        let media: Media = around.into_iter().filter(transparent).collect();
        let (view, samples) = (&self.prepared.view, self.settings.samples);
        let frame = painter.pixels(|x, y| {
            let traced = |ray: &Ray, _: &mut Unrecorded| self.trace(ray, 1, &media).0;
            primary::pixel::<primary::Event, _>(view, samples, (x, y), &mut Unrecorded, traced)
        });
        frame.ok()
    }

    /// The light that comes back along a ray, and how far away it starts.
    fn trace(&self, ray: &Ray, level: u32, media: &Media) -> (Rgb, Option<f64>) {
        let (scene, primitives) = (&self.prepared.scene, self.prepared.primitives());
        let balls = self.setup.needs().light_balls;
        let met = visible::<Event>(Bvh, scene, primitives, balls, ray, &mut Unrecorded).met;
        let Intersection::Object(hit) = met else {
            let color = without_object::<Event>(scene, &met, &mut Unrecorded);
            return (color, met.t().is_finite().then_some(met.t()));
        };
        let surface = primitives.surface(ray, &hit);
        let place = Place {
            ray,
            hit,
            surface,
            normal: self.normal(ray, &hit, &surface),
            material: self.material(hit.object),
        };
        let mut sum = self.local(&place);
        if !self.only_casts {
            sum = (sum + self.reflected(&place, level, media)).finite();
            sum = (sum + self.transmitted(&place, level, media)).finite();
        }
        (sum, Some(hit.t))
    }

    fn normal(&self, ray: &Ray, hit: &Hit, surface: &Surface) -> DVec3 {
        let normal = match self.model.errs(Mistake::NormalNotNormalized) {
            true => self.of_any_length(hit, surface),
            false => surface.normal,
        };
        self.model.turned(normal, -ray.direction)
    }

    /// A normal as it comes out of the equation of the surface.
    fn of_any_length(&self, hit: &Hit, surface: &Surface) -> DVec3 {
        let primitives = self.prepared.primitives();
        match primitives.part(hit.object as usize, hit.triangle) {
            Some(Part::Sphere { radius, .. } | Part::Side { radius, .. }) => {
                radius * surface.normal
            }
            Some(Part::Triangle {
                corners: [a, b, c], ..
            }) => (b - a).cross(c - a).length() * surface.normal,
            _ => surface.normal,
        }
    }

    fn local(&self, place: &Place) -> Rgb {
        let mut point = SurfacePoint {
            position: place.surface.position,
            normal: place.normal,
            to_eye: -place.ray.direction,
            material: place.material,
            diffuse: place.material.diffuse,
        };
        if let Some(texture) = place.material.texture {
            let uv = self
                .prepared
                .primitives()
                .uv(&place.hit, place.surface.position);
            point.diffuse = point.diffuse * texture.color_at(uv);
        }
        let arrives = |incidence: &Incidence| !self.in_shadow(place, incidence);
        let lit = self.model.intensity(&point, arrives).whole;
        (lit + place.material.emission).finite()
    }

    fn in_shadow(&self, place: &Place, incidence: &Incidence) -> bool {
        let (direction, mut distance) = (incidence.to_light, incidence.distance);
        let ray = if self.model.errs(Mistake::NoShadowOffset) {
            let origin = place.ray.at(place.hit.t);
            Ray { origin, direction }
        } else {
            let ray = leaving(&place.surface, direction);
            distance = short_of(&ray, &place.surface, distance);
            ray
        };
        if self.model.errs(Mistake::ShadowIgnoresLightDistance) {
            distance = f64::INFINITY;
        }
        !self.only_casts && self.prepared.primitives().blocked(&ray, distance)
    }

    fn reflected(&self, place: &Place, level: u32, media: &Media) -> Rgb {
        let direction = self.model.mirrored(place.ray.direction, place.normal);
        self.followed(place, place.material.reflection, direction, level, media)
    }

    fn transmitted(&self, place: &Place, level: u32, media: &Media) -> Rgb {
        let (u, n, k_t) = (
            place.ray.direction,
            place.normal,
            place.material.transmission,
        );
        if k_t == Rgb::BLACK {
            return Rgb::BLACK;
        }
        let enters = u.dot(place.surface.normal) < 0.0;
        let beyond = self.beyond(place, media, enters);
        let mut eta = self.ior(media) / self.ior(&beyond);
        if self.model.errs(Mistake::EtaNotSwappedOnLeaving) && !enters {
            eta = 1.0 / eta;
        }
        let cos_i = -u.dot(n);
        let radicand = refraction_radicand(eta, cos_i);
        if radicand < 0.0 {
            if self.model.errs(Mistake::TirBlack) {
                return Rgb::BLACK;
            }
            return self.followed(place, k_t, self.model.mirrored(u, n), level, media);
        }
        let direction = refracted(u.to_array(), n.to_array(), eta, cos_i, radicand);
        self.followed(place, k_t, direction.into(), level, &beyond)
    }

    /// What a secondary ray adds.
    fn followed(
        &self,
        place: &Place,
        coefficient: Rgb,
        direction: DVec3,
        level: u32,
        media: &Media,
    ) -> Rgb {
        if coefficient == Rgb::BLACK || level >= self.settings.depth.get() {
            return Rgb::BLACK;
        }
        let ray = leaving(&place.surface, direction.normalize_or(place.ray.direction));
        let (color, distance) = self.trace(&ray, level + 1, media);
        let attenuation = self.prepared.scene.path_attenuation;
        match distance {
            Some(d) if attenuation != [1.0, 0.0, 0.0] => {
                coefficient * (color / divisor(attenuation, d)).finite()
            }
            _ => coefficient * color,
        }
    }

    fn beyond(&self, place: &Place, media: &Media, enters: bool) -> Media {
        let object = place.hit.object;
        let mut beyond = media.clone();
        if !self.prepared.primitives().is_transparent_body(object) {
            return beyond;
        }
        if enters {
            beyond.push(object);
        } else if let Some(innermost) = beyond.iter().rposition(|&inside| inside == object) {
            beyond.remove(innermost);
        }
        beyond
    }

    fn ior(&self, media: &Media) -> f64 {
        let innermost = media.last();
        innermost.map_or(1.0, |&object| self.material(object).ior)
    }

    fn material(&self, object: u32) -> &'a Material {
        let scene = &self.prepared.scene;
        &scene.materials[scene.objects[object as usize].material]
    }
}
