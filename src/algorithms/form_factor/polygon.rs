//! Convex planar polygons: cut at a plane, and covered with Gauss points.

use super::gauss::gauss;
use crate::scene::patches::Patches;
use glam::DVec3;
use std::borrow::Cow;

/// A convex planar polygon, counter-clockwise seen from the front.
#[derive(Clone, Debug)]
pub struct Polygon<'a> {
    pub corners: Cow<'a, [DVec3]>,
    /// Unit.
    pub normal: DVec3,
    pub area: f64,
    /// The mean of the corners.
    pub center: DVec3,
    /// Of a ball about the centre that holds the polygon.
    pub radius: f64,
}

impl<'a> Polygon<'a> {
    /// None where no area is left.
    pub fn new(corners: Cow<'a, [DVec3]>, normal: DVec3) -> Option<Self> {
        let first = *corners.first()?;
        let twice: f64 = corners[1..]
            .windows(2)
            .map(|pair| (pair[0] - first).cross(pair[1] - first).dot(normal))
            .sum();
        if !(twice > 0.0 && twice.is_finite()) {
            return None;
        }
        let from_first: DVec3 = corners.iter().map(|&corner| corner - first).sum();
        let center = first + from_first / corners.len() as f64;
        let radius = corners
            .iter()
            .map(|corner| corner.distance_squared(center))
            .fold(0.0, f64::max)
            .sqrt();
        Some(Polygon {
            corners,
            normal,
            area: 0.5 * twice,
            center,
            radius,
        })
    }

    /// A plane, as polygons are cut at. It has no area.
    pub fn plane(point: DVec3, normal: DVec3) -> Polygon<'static> {
        Polygon {
            corners: Cow::Owned(vec![point]),
            normal,
            area: 0.0,
            center: point,
            radius: 0.0,
        }
    }

    /// The part in front of the plane of `other`. Corners within `slack` of the plane lie in it.
    pub fn in_front_of(self, other: &Polygon, slack: f64) -> Option<Self> {
        // A ball that is far from the plane need not be looked at corner by corner.
        let height = |point: DVec3| other.normal.dot(point - other.corners[0]);
        let of_center = height(self.center);
        if of_center >= self.radius {
            return Some(self);
        }
        if of_center < -self.radius {
            return None;
        }
        let mut lowest = f64::INFINITY;
        let mut highest = f64::NEG_INFINITY;
        for &corner in self.corners.iter() {
            let height = height(corner);
            lowest = lowest.min(height);
            highest = highest.max(height);
        }
        if highest <= slack {
            return None;
        }
        if lowest >= -slack {
            return Some(self);
        }
        Polygon::new(Cow::Owned(cut(&self.corners, height)), self.normal)
    }

    /// The part inside another convex polygon of the same plane, and what is left of it outside, in convex parts.
    pub fn parted_by(self, other: &Polygon, slack: f64) -> (Option<Self>, Vec<Self>) {
        let mut outside = Vec::new();
        let mut rest = Some(self.clone());
        for [from, to] in other.edges() {
            let Some(part) = rest else { break };
            let inward = other.normal.cross(to - from).normalize_or_zero();
            let [inner, outer] = [inward, -inward].map(|side| Polygon::plane(from, side));
            outside.extend(part.clone().in_front_of(&outer, slack));
            rest = part.in_front_of(&inner, slack);
        }
        match rest {
            Some(inside) => (Some(inside), outside),
            None => (None, vec![self]),
        }
    }

    pub fn into_owned(self) -> Polygon<'static> {
        Polygon {
            corners: Cow::Owned(self.corners.into_owned()),
            ..self
        }
    }

    /// The directed edges.
    pub fn edges(&self) -> impl Iterator<Item = [DVec3; 2]> + Clone {
        let corners = &self.corners;
        (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]])
    }

    /// Calls `at` for n × n Gauss points and their weights, which sum to the area. Polygons of more than four corners are taken as a
    /// fan of triangles; a triangle has one row more, where it narrows to its tip, and a quadrilateral that is no parallelogram one row and column.
    pub fn points(&self, n: usize, mut at: impl FnMut(DVec3, f64)) {
        match *self.corners {
            [a, b, c, d] => quadrilateral_points([a, b, c, d], self.normal, n, &mut at),
            _ => {
                let first = self.corners[0];
                for pair in self.corners[1..].windows(2) {
                    triangle_points([first, pair[0], pair[1]], n, &mut at);
                }
            }
        }
    }
}

/// The part of a convex polygon where `height` ≥ 0 (Sutherland & Hodgman 1974, for one plane).
pub(super) fn cut(corners: &[DVec3], height: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut part = Vec::with_capacity(corners.len() + 1);
    let mut before = *corners.last().unwrap_or(&DVec3::ZERO);
    let mut height_before = height(before);
    for &corner in corners {
        let height = height(corner);
        if (height_before < 0.0) != (height < 0.0) {
            part.push(before + height_before / (height_before - height) * (corner - before));
        }
        if height >= 0.0 {
            part.push(corner);
        }
        (before, height_before) = (corner, height);
    }
    part
}

/// Gauss points of [0, 1]² under the bilinear map.
fn quadrilateral_points(
    [a, b, c, d]: [DVec3; 4],
    normal: DVec3,
    n: usize,
    at: &mut impl FnMut(DVec3, f64),
) {
    let (along, across, twist) = (b - a, d - a, (c - d) - (b - a));
    // The map of a parallelogram stretches evenly; any other is a polynomial factor more.
    let is_even =
        twist.length_squared() <= 1e-20 * along.length_squared().min(across.length_squared());
    let n = if is_even { n } else { n + 1 };
    for &[v, weight_v] in gauss(n) {
        for &[u, weight_u] in gauss(n) {
            let stretch = (along + v * twist).cross(across + u * twist).dot(normal);
            let point = a + u * along + v * (across + u * twist);
            at(point, weight_u * weight_v * stretch);
        }
    }
}

/// Gauss points of [0, 1]² under the map that draws the side v = 1 together.
fn triangle_points([a, b, c]: [DVec3; 3], n: usize, at: &mut impl FnMut(DVec3, f64)) {
    let (along, across) = (b - a, c - a);
    let twice = along.cross(across).length();
    for &[v, weight_v] in gauss(n + 1) {
        for &[u, weight_u] in gauss(n) {
            let point = a + (1.0 - v) * u * along + v * across;
            at(point, weight_u * weight_v * twice * (1.0 - v));
        }
    }
}

/// The pieces of a patch.
pub fn polygons(patches: &Patches, patch: usize) -> impl Iterator<Item = Polygon<'_>> {
    let pieces = patches.pieces(patch);
    pieces.filter_map(|piece| Polygon::new(piece.corners.into(), piece.normal))
}
