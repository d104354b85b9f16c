//! Polygons as triangles.

use super::super::Mesh;
use earcut::Earcut;
use glam::{DVec2, DVec3};

/// How far corners may lie off their plane, as a share of the polygon's extent, to be in it but for rounding.
pub(super) const PLANAR: f64 = 1e-10;

/// The same for polygons whose corners were written with few digits: those are drawn as one polygon.
const NEARLY_PLANAR: f64 = 1e-4;

/// The corners of a polygon, and the plane through them.
pub(in crate::scene) struct Polygon {
    corners: Vec<DVec3>,
    /// Unit, of the mean plane (Newell); zero where there is no area.
    pub normal: DVec3,
    /// The largest distance of a corner from the plane through the first.
    pub off_plane: f64,
    extent: f64,
}

/// A face as triangles by corner, in its own sense: those that rays meet.
pub fn triangles(mesh: &Mesh, face: usize) -> Vec<[u32; 3]> {
    match mesh.face(face).len() {
        3 => vec![[0, 1, 2]],
        _ => Polygon::of_face(mesh, face).triangles(),
    }
}

impl Polygon {
    pub fn of_face(mesh: &Mesh, face: usize) -> Self {
        let corners = mesh.face(face).iter().map(|&v| mesh.position(v)).collect();
        Polygon::new(corners, mesh.normal(face))
    }

    fn new(corners: Vec<DVec3>, normal: DVec3) -> Self {
        let furthest = |distance: &dyn Fn(DVec3) -> f64| {
            let distances = corners.iter().map(|&corner| distance(corner - corners[0]));
            distances.fold(0.0, f64::max)
        };
        Polygon {
            off_plane: furthest(&|from_first| from_first.dot(normal).abs()),
            extent: furthest(&|from_first| from_first.abs().max_element()),
            normal,
            corners,
        }
    }

    /// The same in a plane across another unit vector.
    pub fn with_normal(self, normal: DVec3) -> Self {
        Polygon::new(self.corners, normal)
    }

    /// The unit normal of the plane that the polygon lies in: also where it crosses itself, so that the parts of its area cancel out. The front
    /// is then where its first turn is counter-clockwise. None where all corners lie on a line.
    pub fn facing(&self) -> Option<DVec3> {
        let places = || {
            self.corners
                .iter()
                .map(|&corner| (corner - self.corners[0]) / self.extent)
        };
        let longest = |a: DVec3, b: DVec3| {
            if b.length_squared() > a.length_squared() {
                b
            } else {
                a
            }
        };
        let far = places().fold(DVec3::ZERO, longest);
        let widest = places()
            .map(|place| far.cross(place))
            .fold(DVec3::ZERO, longest);
        if widest.length() < PLANAR {
            return None;
        }
        let places: Vec<DVec3> = places().collect();
        let area: DVec3 = places.windows(2).map(|pair| pair[0].cross(pair[1])).sum();
        if area.length() > 0.05 * widest.length() {
            return Some(area.normalize());
        }
        let turns = places
            .windows(3)
            .map(|at| (at[1] - at[0]).cross(at[2] - at[1]));
        let first_turn = turns
            .map(|turn| turn.dot(widest))
            .find(|turn| turn.abs() > PLANAR);
        let front = [area.dot(widest), first_turn.unwrap_or(1.0)]
            .into_iter()
            .find(|side| side.abs() > PLANAR);
        Some(widest.normalize() * front.unwrap_or(1.0).signum())
    }

    pub fn is_planar(&self) -> bool {
        self.normal != DVec3::ZERO && self.off_plane <= PLANAR * self.extent
    }

    pub fn is_nearly_planar(&self) -> bool {
        self.normal != DVec3::ZERO && self.off_plane <= NEARLY_PLANAR * self.extent
    }

    /// Triangles by corner, in the sense of the polygon.
    ///
    /// Four corners make 0-1-2 and 0-2-3, unless the polygon is planar and that diagonal runs outside. More make a fan around the first
    /// where the polygon is convex; otherwise ears are cut.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let fan = || {
            (2..self.corners.len() as u32)
                .map(|i| [0, i - 1, i])
                .collect()
        };
        match self.corners.len() {
            3 => fan(),
            4 if self.is_nearly_planar() && (self.is_reflex(1) || self.is_reflex(3)) => {
                vec![[1, 2, 3], [1, 3, 0]]
            }
            4 => fan(),
            _ => {
                if self.normal == DVec3::ZERO || self.is_convex() {
                    fan()
                } else {
                    self.ears()
                }
            }
        }
    }

    /// Whether the polygon turns one way at all corners, and once in all.
    pub fn is_convex(&self) -> bool {
        (0..self.corners.len()).all(|corner| !self.is_reflex(corner)) && self.turns_once()
    }

    /// Of a polygon without a reflex corner, whether it turns by 360° in all: it then runs forward once and back once, along both axes.
    fn turns_once(&self) -> bool {
        let flat = self.flattened();
        [0, 1].into_iter().all(|axis| {
            let steps = (0..flat.len()).map(|i| flat[(i + 1) % flat.len()][axis] - flat[i][axis]);
            let mut forward = steps.filter(|&step| step != 0.0).map(|step| step > 0.0);
            let Some(first) = forward.next() else {
                return true;
            };
            let (changes, last) = forward.fold((0, first), |(changes, before), now| {
                (changes + u32::from(before != now), now)
            });
            changes + u32::from(first != last) <= 2
        })
    }

    /// Whether it does not cross itself, as far as its turns alone can say.
    pub fn is_surely_simple(&self) -> bool {
        let reflex = || (0..self.corners.len()).filter(|&corner| self.is_reflex(corner));
        match self.corners.len() {
            4 => reflex().count() < 2,
            _ => self.is_convex(),
        }
    }

    /// The corners in the coordinate plane that the polygon faces most, from the first, in units of the extent, counter-clockwise.
    pub fn flattened(&self) -> Vec<DVec2> {
        let drop = self.normal.abs().max_position();
        let [x, y] = match self.normal[drop] >= 0.0 {
            true => [(drop + 1) % 3, (drop + 2) % 3],
            false => [(drop + 2) % 3, (drop + 1) % 3],
        };
        self.corners
            .iter()
            .map(|&corner| (corner - self.corners[0]) / self.extent)
            .map(|corner| DVec2::new(corner[x], corner[y]))
            .collect()
    }

    /// Whether the polygon turns the other way at a corner.
    fn is_reflex(&self, corner: usize) -> bool {
        let at = |i: usize| self.corners[i % self.corners.len()];
        let before = at(corner) - at(corner + self.corners.len() - 1);
        let after = at(corner + 1) - at(corner);
        (before / self.extent)
            .cross(after / self.extent)
            .dot(self.normal)
            < 0.0
    }

    /// By `earcut`, in the coordinate plane that the polygon faces most.
    fn ears(&self) -> Vec<[u32; 3]> {
        let flat: Vec<[f64; 2]> = self.flattened().iter().map(DVec2::to_array).collect();
        let mut indices: Vec<u32> = Vec::new();
        Earcut::new().earcut_slice(&flat, &[], &mut indices);
        let area = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|i| self.corners[i as usize]);
            (b - a).cross(c - a).dot(self.normal)
        };
        indices
            .as_chunks()
            .0
            .iter()
            .map(|&[a, b, c]| {
                if area([a, b, c]) < 0.0 {
                    [a, c, b]
                } else {
                    [a, b, c]
                }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangles(corners: &[[f64; 3]]) -> Vec<[u32; 3]> {
        let positions: Vec<DVec3> = corners.iter().copied().map(DVec3::from).collect();
        let face: Vec<u32> = (0..corners.len() as u32).collect();
        let mesh = Mesh::new(&positions, [face], &[]);
        let polygon = Polygon::of_face(&mesh, 0);
        let triangles = polygon.triangles();
        let area = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|i| polygon.corners[i as usize]);
            (b - a).cross(c - a).dot(polygon.normal)
        };
        // The same way round as the polygon, and of its area where it is planar
        assert!(triangles.iter().all(|&triangle| area(triangle) >= 0.0));
        if polygon.is_planar() {
            let whole: DVec3 = (2..corners.len())
                .map(|i| {
                    let from_first = |i: usize| polygon.corners[i] - polygon.corners[0];
                    from_first(i - 1).cross(from_first(i))
                })
                .sum();
            let sum: f64 = triangles.iter().map(|&triangle| area(triangle)).sum();
            assert!((sum - whole.length()).abs() < 1e-12 * sum);
        }
        triangles
    }

    #[test]
    fn four_corners_are_split_at_0_and_2_unless_that_runs_outside() {
        let usual = [[0, 1, 2], [0, 2, 3]];
        let square = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
        assert_eq!(triangles(&square), usual);
        let bent = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.5], [0., 1., 0.]];
        assert_eq!(triangles(&bent), usual);
        let dart_at_2 = [[0., 0., 0.], [4., 0., 0.], [1., 1., 0.], [0., 4., 0.]];
        assert_eq!(triangles(&dart_at_2), usual);
        let dart_at_1 = [[0., 4., 0.], [3., 3., 0.], [4., 0., 0.], [4., 4., 0.]];
        assert_eq!(triangles(&dart_at_1), [[1, 2, 3], [1, 3, 0]]);
        let dart_at_3 = [[4., 0., 0.], [4., 4., 0.], [0., 4., 0.], [3., 3., 0.]];
        assert_eq!(triangles(&dart_at_3), [[1, 2, 3], [1, 3, 0]]);
    }

    #[test]
    fn more_corners_make_a_fan_or_ears() {
        let house = [
            [0., 0., 0.],
            [2., 0., 0.],
            [2., 1., 0.],
            [1., 2., 0.],
            [0., 1., 0.],
        ];
        assert_eq!(triangles(&house), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
        let letter = [
            [0., 0., 0.],
            [0., 0., 3.],
            [0., 1., 3.],
            [0., 1., 1.],
            [0., 3., 1.],
            [0., 3., 0.],
        ];
        assert_eq!(triangles(&letter).len(), 4);
        // A square with a hole, joined to the rim by a bridge
        let hole = [
            [0., 0., 7.],
            [9., 0., 7.],
            [9., 9., 7.],
            [0., 9., 7.],
            [0., 0., 7.],
            [2., 2., 7.],
            [2., 5., 7.],
            [5., 2., 7.],
            [2., 2., 7.],
        ];
        assert_eq!(triangles(&hole).len(), 7);
        // No area at all
        let line = [
            [0., 0., 0.],
            [1., 0., 0.],
            [2., 0., 0.],
            [3., 0., 0.],
            [1.5, 0., 0.],
        ];
        triangles(&line);
    }
}
