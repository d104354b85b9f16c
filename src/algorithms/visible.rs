//! The visible surface: the nearest object that a ray meets, and whether anything stands between a point and a light
//! (Appel 1968; object by object as in Whitted 1980, §3).
//!
//! [`BruteForce`] tests one object after another, as in the textbook, and records every comparison with NearestT. [`Bvh`] finds the
//! same hit, bit for bit, without testing every object, and records only the result. At equal t, within rounding, the object of lower
//! index is in front; what touches it there is met next, by the ray that goes on. A point light of positive radius is a ball that rays see; it blocks no shadow ray.

use crate::record::Recorder;
use crate::scene::primitives::{Contact, Hit, Nearest, Primitives, Ray, meet_ball};
use crate::scene::{Light, Scene};

/// The first thing that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intersection {
    Nothing,
    Light { light: u32, t: f64 },
    Object(Hit),
}

/// A way to find the visible surface. Every way finds the same.
pub trait Search: Copy {
    /// The nearest object at t > 0, and what touches it there.
    fn nearest<E: From<Event>>(
        self,
        scene: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        recorder: &mut impl Recorder<E>,
    ) -> Option<Nearest>;

    /// An object that casts a shadow and is met at 0 < t < `distance`.
    fn blocker<E: From<Event>>(
        self,
        scene: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        distance: f64,
        recorder: &mut impl Recorder<E>,
    ) -> Option<Blocker>;
}

/// What stands between a point and a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocker {
    /// None where the search only finds out that there is one.
    pub hit: Option<Hit>,
}

/// One object after another.
#[derive(Clone, Copy, Debug)]
pub struct BruteForce;

/// By the bounding volume hierarchy.
#[derive(Clone, Copy, Debug)]
pub struct Bvh;

impl Search for BruteForce {
    fn nearest<E: From<Event>>(
        self,
        scene: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        recorder: &mut impl Recorder<E>,
    ) -> Option<Nearest> {
        let mut nearest: Option<Nearest> = None;
        let mut hits = Vec::new();
        for object in 0..scene.objects.len() {
            let hit = primitives.meet(object, ray);
            let nearest_t = nearest
                .as_ref()
                .map_or(f64::INFINITY, |nearest| nearest.hit.t);
            hits.extend(hit);
            let in_front = hit.and_then(|_| primitives.front(ray, &hits));
            let nearer =
                in_front.as_ref().map(|front| front.hit.object) == hit.map(|hit| hit.object);
            let nearer = nearer && hit.is_some();
            recorder.step(|| Event::tested(object, hit, nearest_t, nearer).into());
            nearest = in_front.or(nearest);
        }
        nearest
    }

    fn blocker<E: From<Event>>(
        self,
        scene: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        distance: f64,
        recorder: &mut impl Recorder<E>,
    ) -> Option<Blocker> {
        for (index, object) in scene.objects.iter().enumerate() {
            if !object.casts_shadow {
                recorder.step(|| {
                    Event::Unshadowing {
                        object: index as u32,
                    }
                    .into()
                });
                continue;
            }
            let hit = primitives.meet(index, ray);
            let blocks = hit.is_some_and(|hit| hit.t < distance);
            recorder.step(|| Event::between(index, hit, distance, blocks).into());
            if blocks {
                return Some(Blocker { hit });
            }
        }
        None
    }
}

impl Search for Bvh {
    fn nearest<E: From<Event>>(
        self,
        _: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        _: &mut impl Recorder<E>,
    ) -> Option<Nearest> {
        primitives.nearest_with_contact(ray)
    }

    fn blocker<E: From<Event>>(
        self,
        _: &Scene,
        primitives: &Primitives,
        ray: &Ray,
        distance: f64,
        _: &mut impl Recorder<E>,
    ) -> Option<Blocker> {
        primitives
            .blocked(ray, distance)
            .then_some(Blocker { hit: None })
    }
}

/// What a ray sees.
#[derive(Clone, Debug)]
pub struct Visible {
    pub met: Intersection,
    /// What is at the same place as the object that it meets.
    pub contact: Option<Contact>,
}

/// The nearest among all objects and, with `light_balls`, the balls of the lights.
pub fn visible<E: From<Event>>(
    search: impl Search,
    scene: &Scene,
    primitives: &Primitives,
    light_balls: bool,
    ray: &Ray,
    recorder: &mut impl Recorder<E>,
) -> Visible {
    recorder.enter(|| Event::search(scene).into());
    let (mut met, mut contact) = match search.nearest(scene, primitives, ray, recorder) {
        Some(Nearest { hit, contact }) => (Intersection::Object(hit), contact),
        None => (Intersection::Nothing, None),
    };
    if light_balls {
        for (light, of) in scene.lights.iter().enumerate() {
            let &Light::Point {
                position, radius, ..
            } = of
            else {
                continue;
            };
            if radius <= 0.0 {
                continue;
            }
            let light = light as u32;
            let t = meet_ball(position, radius, ray);
            let nearest_t = met.t();
            let nearer = t.is_some_and(|t| t < nearest_t);
            recorder.step(|| {
                Event::LightTested {
                    light,
                    t: t.unwrap_or(f64::INFINITY),
                    nearest_t,
                    nearer,
                }
                .into()
            });
            if let (Some(t), true) = (t, nearer) {
                met = Intersection::Light { light, t };
                contact = None;
            }
        }
    }
    recorder.leave(|| Event::Found { met }.into());
    Visible { met, contact }
}

/// The surface that touches the one from which the ray starts, at distance 0: nothing can be nearer.
pub fn touching<E: From<Event>>(
    scene: &Scene,
    hit: Hit,
    recorder: &mut impl Recorder<E>,
) -> Visible {
    let met = Intersection::Object(hit);
    recorder.enter(|| Event::search(scene).into());
    recorder.step(|| Event::tested(hit.object as usize, Some(hit), f64::INFINITY, true).into());
    recorder.leave(|| Event::Found { met }.into());
    Visible { met, contact: None }
}

impl Intersection {
    /// Infinite where the ray meets nothing.
    pub fn t(&self) -> f64 {
        match *self {
            Intersection::Nothing => f64::INFINITY,
            Intersection::Light { t, .. } => t,
            Intersection::Object(hit) => hit.t,
        }
    }
}

/// One test per object; t is infinite where the ray misses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Opens the search for the nearest object.
    Search { objects: u32 },
    ObjectTested {
        object: u32,
        triangle: u32,
        t: f64,
        /// Before this test.
        nearest_t: f64,
        nearer: bool,
    },
    LightTested {
        light: u32,
        t: f64,
        nearest_t: f64,
        nearer: bool,
    },
    /// Closes `Search`.
    Found { met: Intersection },
    /// An object on the way to a light.
    BetweenTested {
        object: u32,
        triangle: u32,
        t: f64,
        /// A hit at or beyond this distance does not block: that of the light, less a margin for rounding.
        distance: f64,
        blocks: bool,
    },
    /// An object that casts no shadow, skipped on the way to a light.
    Unshadowing { object: u32 },
}

impl Event {
    fn search(scene: &Scene) -> Self {
        Event::Search {
            objects: scene.objects.len() as u32,
        }
    }

    fn tested(object: usize, hit: Option<Hit>, nearest_t: f64, nearer: bool) -> Self {
        Event::ObjectTested {
            object: object as u32,
            triangle: hit.map_or(0, |hit| hit.triangle),
            t: hit.map_or(f64::INFINITY, |hit| hit.t),
            nearest_t,
            nearer,
        }
    }

    pub fn between(object: usize, hit: Option<Hit>, distance: f64, blocks: bool) -> Self {
        Event::BetweenTested {
            object: object as u32,
            triangle: hit.map_or(0, |hit| hit.triangle),
            t: hit.map_or(f64::INFINITY, |hit| hit.t),
            distance,
            blocks,
        }
    }

    /// Whether it is about one object or light of several.
    pub fn tests_one(&self) -> bool {
        !matches!(self, Event::Search { .. } | Event::Found { .. })
    }
}
