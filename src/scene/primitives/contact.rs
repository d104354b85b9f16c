//! Surfaces that touch: hits of different objects that the arithmetic cannot tell apart.
//!
//! Two hits of a ray count as equal where the distance between the two surfaces, across them, is within the bounds on their errors,
//! and the surfaces do not cross there. Of equal hits the lower object is in front, as if there were a gap between the two that goes to
//! 0. Bodies that are parts of one mesh touch as those of two objects do. Where a ray leaves one transparent body and enters another that shares the face, it leaves first: there is no place inside both.

use super::error::gamma;
use super::{Hit, Primitives, Ray, Surface};
use glam::DVec3;

/// The surfaces at one place on a ray, two or more, in the order in which the ray passes them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contact {
    hits: Vec<Hit>,
    /// How far the surfaces may be apart.
    thickness: f64,
}

/// The nearest hit of a ray, and what else is at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Nearest {
    pub hit: Hit,
    /// None where the surface stands alone.
    pub contact: Option<Contact>,
}

/// A ray that starts between surfaces that touch: those at `next`, and on in its direction, are still ahead.
#[derive(Clone, Copy, Debug)]
pub struct Between<'a> {
    contact: &'a Contact,
    next: usize,
    /// In the order of the contact, or against it.
    forward: bool,
}

impl Contact {
    /// Where the ray is that met the first of them.
    pub fn start(&self) -> Between<'_> {
        Between {
            contact: self,
            next: 0,
            forward: true,
        }
    }
}

impl<'a> Between<'a> {
    /// What the ray meets at once, at distance 0.
    pub fn hit(&self) -> Hit {
        Hit {
            t: 0.0,
            ..self.contact.hits[self.next]
        }
    }

    /// Where a ray is that leaves the surface that this one met, through it or back; none where nothing is ahead.
    pub fn leaving(self, through: bool) -> Option<Between<'a>> {
        let forward = self.forward == through;
        let next = if forward {
            self.next + 1
        } else {
            self.next.checked_sub(1)?
        };
        (next < self.contact.hits.len()).then_some(Between {
            next,
            forward,
            ..self
        })
    }

    /// The surfaces still ahead, the next one first.
    pub fn ahead(self) -> impl Iterator<Item = Hit> + use<'a> {
        std::iter::successors(Some(self), |between| between.leaving(true))
            .map(|between| between.hit())
    }

    /// The surface that a ray leaves here for good: its error covers the others, so that the ray starts past all of them.
    pub fn last(self, surface: &Surface) -> Surface {
        Surface {
            error: surface.error + DVec3::splat(self.contact.thickness),
            ..*surface
        }
    }
}

/// Beyond this much of its distance and coordinates, a hit is told apart from another without a look at the surfaces.
const CLOSE: f64 = 1.0 / (1 << 20) as f64;

/// How far behind a hit at `t` another may be to be looked at.
pub(super) fn close(ray: &Ray, t: f64) -> f64 {
    CLOSE * (t + ray.origin.abs().max_element())
}

/// Of the hits of a ray, the nearest so far, and whether another is close to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search<'a> {
    ray: &'a Ray,
    pub nearest: Option<Hit>,
    pub has_close: bool,
}

impl<'a> Search<'a> {
    pub fn new(ray: &'a Ray) -> Self {
        Search {
            ray,
            nearest: None,
            has_close: false,
        }
    }

    pub fn add(&mut self, hit: Hit) {
        let Some(nearest) = self.nearest else {
            self.nearest = Some(hit);
            return;
        };
        if hit.is_before(&nearest) {
            self.has_close = nearest.t - hit.t <= close(self.ray, hit.t);
            self.nearest = Some(hit);
        } else {
            self.has_close |= hit.t - nearest.t <= close(self.ray, nearest.t);
        }
    }

    /// How far hits are of interest.
    pub fn reach(&self) -> f64 {
        self.nearest.map_or(f64::INFINITY, |nearest| {
            nearest.t + close(self.ray, nearest.t)
        })
    }
}

impl Primitives {
    /// What is in front among the hits of a ray, one an object, given in the order of the objects.
    pub fn front(&self, ray: &Ray, hits: &[Hit]) -> Option<Nearest> {
        let with_shells = |hit: &Hit| [vec![*hit], self.other_shells(ray, hit)].concat();
        let hits: Vec<Hit> = hits.iter().flat_map(with_shells).collect();
        let first = *hits
            .iter()
            .reduce(|a, b| if b.is_before(a) { b } else { a })?;
        let here = self.touch(ray, &first);
        let mut thickness = 2.0 * here.error;
        let mut contact = Vec::new();
        for hit in hits {
            if hit == first {
                contact.push(hit);
            } else if let Some(there) = self.touching(ray, &here, &hit) {
                thickness += 2.0 * there.error;
                contact.push(hit);
            }
        }
        let stands_alone = contact.len() == 1;
        self.leave_first(ray, &mut contact);
        Some(Nearest {
            hit: contact[0],
            contact: (!stands_alone).then_some(Contact {
                hits: contact,
                thickness,
            }),
        })
    }

    /// Among transparent bodies those that the ray leaves come before those that it enters.
    fn leave_first(&self, ray: &Ray, contact: &mut [Hit]) {
        let is_body = |hit: &Hit| self.is_transparent_body(hit.object);
        let leaves = |hit: &Hit| ray.direction.dot(self.surface(ray, hit).normal) > 0.0;
        let places: Vec<usize> = (0..contact.len())
            .filter(|&i| is_body(&contact[i]))
            .collect();
        let mut bodies: Vec<Hit> = places.iter().map(|&place| contact[place]).collect();
        bodies.sort_by_key(|hit| !leaves(hit));
        for (place, body) in places.into_iter().zip(bodies) {
            contact[place] = body;
        }
    }

    fn touch(&self, ray: &Ray, hit: &Hit) -> Touch {
        let surface = self.surface(ray, hit);
        let of_t = gamma(64) * (hit.t + ray.origin.abs().max_element());
        Touch {
            t: hit.t,
            error: surface.normal.abs().dot(surface.error) + of_t,
            surface,
        }
    }

    /// Another hit, where it is at the place of the nearest.
    fn touching(&self, ray: &Ray, here: &Touch, hit: &Hit) -> Option<Touch> {
        // Surfaces that lean against each other cross at an edge, where a ray passes them one after the other.
        const SAME_PLANE: f64 = 1.0 - 1e-6;
        if hit.t - here.t > close(ray, here.t) {
            return None;
        }
        let there = self.touch(ray, hit);
        let normals = [&here.surface.normal, &there.surface.normal];
        let steepest = normals.map(|normal| ray.direction.dot(*normal).abs());
        let apart = (hit.t - here.t) * steepest[0].max(steepest[1]);
        let is_along = normals[0].dot(*normals[1]).abs() >= SAME_PLANE;
        (is_along && apart <= here.error + there.error).then_some(there)
    }
}

struct Touch {
    t: f64,
    surface: Surface,
    /// How far the surface may be, across it, from where the hit says.
    error: f64,
}
