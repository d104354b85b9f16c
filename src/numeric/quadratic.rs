//! Where a ray meets a sphere, in the form that keeps its digits (Haines, Günther & Akenine-Möller 2019, "Precision
//! Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7).

use num_traits::Float;

/// Both t at which a ray passes a sphere, the smaller first; none where it passes by.
///
/// `from_center` leads from the sphere's centre to the ray's origin, `direction` is a unit vector.
///
/// With f = `from_center`, b = −f·d, c = f·f − r² the textbook's roots b ± √(b² − c) fail twice: b² − c cancels where the sphere is
/// small or far, and so does the difference of b and the root where one t is near zero. The squared perpendicular distance
/// of the centre, |f + b·d|², gives b² − c = r² − |f + b·d|² without the first; the smaller root c/q, q = b ± √(b² − c) taken
/// with the sign of b, is without the second.
pub fn sphere_roots<F: Float>(from_center: [F; 3], direction: [F; 3], radius: F) -> Option<[F; 2]> {
    let b = -dot(from_center, direction);
    let nearest = std::array::from_fn(|i| from_center[i] + b * direction[i]);
    let under_root = radius * radius - dot(nearest, nearest);
    if under_root < F::zero() {
        return None;
    }
    let c = dot(from_center, from_center) - radius * radius;
    let q = b + under_root.sqrt().copysign(b);
    let other = if q == F::zero() { q } else { c / q };
    let roots = [other.min(q), other.max(q)];
    roots.iter().all(|root| root.is_finite()).then_some(roots)
}

/// The textbook's roots, b ± √(b² − c), for comparison only.
pub fn plain_sphere_roots<F: Float>(
    from_center: [F; 3],
    direction: [F; 3],
    radius: F,
) -> Option<[F; 2]> {
    let b = -dot(from_center, direction);
    let c = dot(from_center, from_center) - radius * radius;
    let under_root = b * b - c;
    (under_root >= F::zero()).then(|| [b - under_root.sqrt(), b + under_root.sqrt()])
}

fn dot<F: Float>(a: [F; 3], b: [F; 3]) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    type Roots<F> = fn([F; 3], [F; 3], F) -> Option<[F; 2]>;

    /// The share of nearest hits in f32 that are lost, or whose t is off by more than a tenth of the radius: rays from `distance` away
    /// through the inner nine tenths of the unit sphere. The right answer is computed in f64 for the same f32 ray.
    fn share_of_wrong_hits(distance: f32, roots: Roots<f32>) -> f64 {
        const COUNT: u32 = 10_000;
        let wrong = (0..COUNT).filter(|&i| {
            // Points on a disc, a golden angle apart, seen from a place that turns as well
            let share = (f64::from(i) + 0.5) / f64::from(COUNT);
            let angle = f64::from(i) * std::f64::consts::PI * (3.0 - 5_f64.sqrt());
            let toward = DVec3::new(angle.sin(), 0.3 + share, (0.7 * angle).cos()).normalize();
            let (u, v) = toward.any_orthonormal_pair();
            let through = 0.9 * share.sqrt() * (angle.cos() * u + angle.sin() * v);
            let origin = (-f64::from(distance) * toward).as_vec3();
            let direction = (through - origin.as_dvec3()).normalize().as_vec3();
            let right = sphere_roots(
                origin.as_dvec3().to_array(),
                direction.as_dvec3().normalize().to_array(),
                1.0,
            );
            match (right, roots(origin.to_array(), direction.to_array(), 1.0)) {
                (Some([right, _]), Some([t, _])) => (f64::from(t) - right).abs() > 0.1,
                (right, found) => right.is_some() != found.is_some(),
            }
        });
        wrong.count() as f64 / f64::from(COUNT)
    }

    #[test]
    fn far_away_in_f32_the_plain_form_is_wrong_and_the_stable_form_is_not() {
        let plain = |distance| share_of_wrong_hits(distance, plain_sphere_roots);
        assert_eq!(plain(1e1), 0.0);
        assert!((0.05..0.12).contains(&plain(1e3)), "{}", plain(1e3));
        assert!(plain(1e4) > 0.9, "{}", plain(1e4));
        for distance in [1e1, 1e2, 1e3, 1e4, 1e5] {
            assert_eq!(share_of_wrong_hits(distance, sphere_roots), 0.0);
        }
    }

    #[test]
    fn roots_are_where_geometry_says() {
        // Straight through: 3 away, radius 1. From inside. Touching. Past it.
        let along_x = |from: [f64; 3]| sphere_roots(from, [1.0, 0.0, 0.0], 1.0);
        assert_eq!(along_x([-3.0, 0.0, 0.0]), Some([2.0, 4.0]));
        assert_eq!(along_x([0.0, 0.0, 0.0]), Some([-1.0, 1.0]));
        assert_eq!(along_x([-3.0, 1.0, 0.0]), Some([3.0, 3.0]));
        assert_eq!(along_x([-3.0, 1.0 + 1e-15, 0.0]), None);
        // An origin on the sphere has one root at 0, whichever way the ray goes.
        assert_eq!(along_x([-1.0, 0.0, 0.0]), Some([0.0, 2.0]));
        assert_eq!(along_x([0.0, 1.0, 0.0]), Some([0.0, 0.0]));
    }
}
