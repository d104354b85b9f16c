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

fn dot<F: Float>(a: [F; 3], b: [F; 3]) -> F {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
