//! Rays aimed at one object alone, and how many of them go wrong.

use super::case::{Measured, Ran};
use super::scenes::alone;
use crate::numeric::Random;
use crate::scene::primitives::{Primitives, Ray, Surface, leaving};
use crate::scene::{Mesh, Shape};
use glam::DVec3;
use num_traits::Float;

/// Centre and radius.
pub const BALLS: [(DVec3, f64); 6] = [
    (DVec3::ZERO, 1e-6),
    (DVec3::ZERO, 1.0),
    (DVec3::ZERO, 1e6),
    (DVec3::new(1e7, -1e7, 1e7), 1e-6),
    (DVec3::new(1e7, -1e7, 1e7), 1.0),
    (DVec3::new(1e7, -1e7, 1e7), 1e6),
];

pub type Roots<F> = fn([F; 3], [F; 3], F) -> Option<[F; 2]>;

pub fn spheres(distance: f64, double: Roots<f64>, single: Roots<f32>) -> Result<Ran, String> {
    let [double, single] = [wrong_hits(distance, double), wrong_hits(distance, single)];
    Ok(Ran::from(double)
        .and_f32(single)
        .conditioned(distance * distance))
}

/// The share of nearest hits that are lost, or whose t is off by more than a tenth of the radius. What is right is geometry, in f64, of
/// the ray in that precision.
pub fn wrong_hits<F: Float + Into<f64>>(distance: f64, roots: Roots<F>) -> Measured {
    at_ball(distance, |origin, direction| {
        let [o, d] = [origin, direction].map(|v: [F; 3]| DVec3::from_array(v.map(F::into)));
        let d = d.normalize();
        let right = -o.dot(d) - (1.0 - o.cross(d).length_squared()).sqrt();
        let found = roots(origin, direction, F::one()).map(|[t, _]| t.into());
        found.is_none_or(|t: f64| (t - right).abs() > 0.1 || t.is_nan())
    })
}

pub fn lost_hits<F: Float>(distance: f64, roots: Roots<F>) -> Measured {
    at_ball(distance, |origin, direction| {
        roots(origin, direction, F::one()).is_none()
    })
}

/// The share of rays for which `is_wrong`: from `distance` away through the inner nine tenths of the unit sphere.
fn at_ball<F: Float>(distance: f64, is_wrong: impl Fn([F; 3], [F; 3]) -> bool) -> Measured {
    const COUNT: usize = 10_000;
    let mut random = Random(3);
    let rounded = |v: DVec3| v.to_array().map(|x| F::from(x).unwrap_or_else(F::nan));
    let wrong = (0..COUNT).filter(|_| {
        let from = distance * random.direction();
        let aside = from.cross(random.direction()).normalize();
        // Evenly over a disc
        let through = 0.9 * (0.5 + 0.5 * random.number()).sqrt() * aside;
        is_wrong(rounded(from), rounded((through - from).normalize()))
    });
    Measured::share(wrong.count(), COUNT)
}

pub fn ball(center: DVec3, radius: f64) -> Primitives {
    alone(Shape::Sphere { center, radius })
}

pub fn toward(origin: DVec3, point: DVec3) -> Ray {
    Ray {
        origin,
        direction: (point - origin).normalize(),
    }
}

/// The ray that starts `distance` off the surface, along its normal.
pub fn offset(surface: &Surface, direction: DVec3, distance: f64) -> Ray {
    Ray {
        origin: surface.position + distance * surface.normal,
        direction,
    }
}

/// The share of rays that leave a ball outward and meet it again.
pub fn self_hits(balls: &[(DVec3, f64)], leave: impl Fn(&Surface, DVec3) -> Ray) -> Measured {
    const EACH: usize = 2000;
    let mut random = Random(4);
    let mut wrong = 0;
    for &(center, radius) in balls {
        let primitives = ball(center, radius);
        for _ in 0..EACH {
            let from = center + 5.0 * radius * random.direction();
            let ray = toward(from, center + 0.9 * radius * random.direction());
            let Some(hit) = primitives.nearest(&ray) else {
                wrong += 1;
                continue;
            };
            let surface = primitives.surface(&ray, &hit);
            let direction = random.direction();
            let outward = direction * direction.dot(surface.normal).signum();
            wrong += usize::from(primitives.nearest(&leave(&surface, outward)).is_some());
        }
    }
    Measured::share(wrong, balls.len() * EACH)
}

/// The share of rays that leave a quadrilateral to either side and meet it again.
pub fn polygon_self_hits() -> Measured {
    const EACH: usize = 2000;
    let mut random = Random(5);
    let mut wrong = 0;
    for (place, size) in BALLS {
        let (u, v) = (size * random.direction(), size * random.direction());
        let vertices = vec![place, place + u, place + u + v, place + v];
        let primitives = alone(Shape::Polygon { vertices });
        let normal = u.cross(v).normalize();
        for _ in 0..EACH {
            let [s, t] = [(); 2].map(|()| 0.5 + 0.49 * random.number());
            let aimed_at = place + s * u + t * v;
            let ray = toward(
                aimed_at + size * (normal + 0.3 * random.direction()),
                aimed_at,
            );
            let Some(hit) = primitives.nearest(&ray) else {
                wrong += 1;
                continue;
            };
            let surface = primitives.surface(&ray, &hit);
            let left = leaving(&surface, random.direction());
            wrong += usize::from(primitives.nearest(&left).is_some());
        }
    }
    Measured::share(wrong, BALLS.len() * EACH)
}

/// The share of rays at the diagonals of quadrilaterals that pass.
pub fn edge_leaks() -> Measured {
    let (quadrilaterals, each) = (200, 100);
    let mut random = Random(6);
    let mut leaked = 0;
    for _ in 0..quadrilaterals {
        let (a, u, v) = (random.point(), random.point(), random.point());
        let vertices = vec![a, a + u, a + u + v, a + v];
        let [from, to] = [vertices[0], vertices[2]];
        let primitives = alone(Shape::Polygon { vertices });
        for i in 0..each {
            let share = (f64::from(i) + 0.5) / f64::from(each);
            let origin = 5.0 * u.cross(v).normalize() + random.point();
            let ray = toward(origin, from + share * (to - from));
            leaked += usize::from(primitives.nearest(&ray).is_none());
        }
    }
    Measured::share(leaked, quadrilaterals * each as usize)
}

/// The share of rays at the middle of a fan of seven triangles that pass.
pub fn corner_leaks() -> Measured {
    const COUNT: usize = 5000;
    let center = DVec3::new(0.1, 0.7, -0.3);
    let rim = (0..7).map(|i| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 7.0).sin_cos();
        center + DVec3::new(1.3 * cos, 0.9 * sin, 0.2 * sin * cos)
    });
    let positions: Vec<DVec3> = std::iter::once(center).chain(rim).collect();
    let faces = (0..7_u32).map(|i| [0, i + 1, (i + 1) % 7 + 1]);
    let primitives = alone(Shape::Mesh(Mesh::new(&positions, faces, &[])));
    let mut random = Random(7);
    let leaked = (0..COUNT).filter(|_| {
        let origin = center + DVec3::new(random.number(), random.number(), 3.0);
        primitives.nearest(&toward(origin, center)).is_none()
    });
    Measured::share(leaked.count(), COUNT)
}
