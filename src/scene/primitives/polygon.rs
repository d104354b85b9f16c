//! Polygons as triangles.

use super::super::Mesh;
use earcut::Earcut;
use glam::DVec3;

/// How far corners may lie off their plane, as a share of the polygon's extent, to be in it but for rounding.
pub(super) const PLANAR: f64 = 1e-10;

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
        let corners: Vec<DVec3> = mesh.face(face).iter().map(|&v| mesh.position(v)).collect();
        let normal = mesh.normal(face);
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

    pub fn is_planar(&self) -> bool {
        self.normal != DVec3::ZERO && self.off_plane <= PLANAR * self.extent
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
            4 if self.is_planar() && (self.is_reflex(1) || self.is_reflex(3)) => {
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

    /// Whether the polygon turns one way at all corners.
    pub fn is_convex(&self) -> bool {
        (0..self.corners.len()).all(|corner| !self.is_reflex(corner))
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
        let drop = self.normal.abs().max_position();
        let (x, y) = ((drop + 1) % 3, (drop + 2) % 3);
        let flat: Vec<[f64; 2]> = self
            .corners
            .iter()
            .map(|&corner| (corner - self.corners[0]) / self.extent)
            .map(|corner| [corner[x], corner[y]])
            .collect();
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
