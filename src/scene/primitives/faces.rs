//! A mesh as triangles under a hierarchy of its own.

use super::super::Mesh;
use super::aim::Aim;
use super::frame::{Frame, Near};
use super::hierarchy::{Bvh, UnitRay};
use super::packet::{NONE, PACKET, Packet, UnitShear};
use super::polygon::Polygon;
use super::stack::Stack;
use super::triangle::{self, Meeting, Shear};
use super::{ChartPart, Ray, Surface};
use glam::{DVec2, DVec3, Vec3};

/// The triangles of a mesh. They are numbered from 0, face by face.
#[derive(Clone, Debug)]
pub(super) struct Faces {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// Texture coordinates at the corners of each triangle; empty where they are not needed.
    uvs: Vec<[DVec2; 3]>,
    /// By triangle, the part of the mesh that it is of; empty where there is one alone.
    shells: Vec<u32>,
    /// The planar faces of more than four corners, in ascending order.
    planes: Vec<FacePlane>,
    pub low: DVec3,
    pub high: DVec3,
    frame: Frame,
    hierarchy: Bvh,
    /// The leaves of the hierarchy.
    packets: Vec<Packet>,
}

/// The plane that the triangles `start..end` share.
#[derive(Clone, Copy, Debug)]
struct FacePlane {
    start: u32,
    end: u32,
    normal: DVec3,
    off_plane: f64,
}

impl Faces {
    /// The memory of the triangles, the packets and the hierarchy.
    pub fn bytes(&self) -> u64 {
        let vertices = self.vertices.len() * size_of::<DVec3>();
        let triangles = self.triangles.len() * size_of::<[u32; 3]>();
        let uvs = self.uvs.len() * size_of::<[DVec2; 3]>();
        let packets = self.packets.len() * size_of::<Packet>();
        (vertices + triangles + uvs + packets) as u64 + self.hierarchy.bytes()
    }

    /// `turned` says by face which are wound the other way here; where it is empty, none is. `shells` are the parts of a mesh that may touch.
    pub fn new(mesh: &Mesh, is_textured: bool, turned: &[bool], shells: &[u32]) -> Self {
        let vertices: Vec<DVec3> = (0..mesh.vertex_count() as u32)
            .map(|vertex| mesh.position(vertex))
            .collect();
        let mut triangles = Vec::with_capacity(mesh.face_count());
        let mut uvs = Vec::new();
        let mut shell_of = Vec::new();
        let mut planes = Vec::new();
        for face in 0..mesh.face_count() {
            let corners = mesh.face(face);
            let face_uvs = mesh.face_uvs(face);
            let start = triangles.len();
            let is_turned = turned.get(face) == Some(&true);
            let mut add = |[first, second, third]: [u32; 3]| {
                let triangle = if is_turned {
                    [first, third, second]
                } else {
                    [first, second, third]
                };
                triangles.push(triangle.map(|corner| corners[corner as usize]));
                shell_of.extend(shells.get(face));
                if is_textured && !face_uvs.is_empty() {
                    uvs.push(triangle.map(|corner| face_uvs[corner as usize]));
                }
            };
            if corners.len() == 3 {
                add([0, 1, 2]);
                continue;
            }
            let polygon = Polygon::of_face(mesh, face);
            polygon.triangles().into_iter().for_each(add);
            if corners.len() > 4 && polygon.is_planar() {
                planes.push(FacePlane {
                    start: start as u32,
                    end: triangles.len() as u32,
                    normal: if is_turned {
                        -polygon.normal
                    } else {
                        polygon.normal
                    },
                    off_plane: polygon.off_plane,
                });
            }
        }
        let low = vertices
            .iter()
            .copied()
            .reduce(DVec3::min)
            .unwrap_or_default();
        let high = vertices
            .iter()
            .copied()
            .reduce(DVec3::max)
            .unwrap_or_default();
        let frame = Frame::around(low, high);
        let boxes: Vec<[Vec3; 2]> = triangles
            .iter()
            .map(|corners| {
                let [a, b, c] = corners.map(|vertex| frame.unit_point(vertices[vertex as usize]));
                [a.min(b).min(c), a.max(b).max(c)]
            })
            .collect();
        let (hierarchy, leaves) = Bvh::new(&boxes, PACKET);
        let vertices = in_order_of_use(vertices, &mut triangles, leaves.iter().flatten());
        let packets = leaves
            .iter()
            .map(|leaf| {
                Packet::new(leaf, |triangle| {
                    let vertex_indices = triangles[triangle as usize];
                    let corners =
                        vertex_indices.map(|vertex| frame.unit_point(vertices[vertex as usize]));
                    (vertex_indices, corners)
                })
            })
            .collect();
        Faces {
            vertices,
            triangles,
            uvs,
            shells: shell_of,
            planes,
            low,
            high,
            frame,
            hierarchy,
            packets,
        }
    }

    pub fn triangle_count(&self) -> usize {
        self.triangles.len()
    }

    /// The corners of a triangle.
    #[inline]
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.triangles[triangle as usize].map(|vertex| self.vertices[vertex as usize])
    }

    /// The nearest meeting within `reach`, the first triangle of equally near ones: its t and the triangle.
    pub fn meet(&self, ray: &Ray, aim: &Aim, reach: f64, stack: &mut Stack) -> Option<(f64, u32)> {
        let near = self.frame.near(ray)?;
        let mut best: Option<(f64, u32)> = None;
        self.walk(&near, aim, reach, stack, |triangle, meeting, unit| {
            let is_nearer =
                best.is_none_or(|(t, first)| meeting.t < t || (meeting.t == t && triangle < first));
            if !is_nearer {
                return None;
            }
            best = Some((meeting.t, triangle));
            Some(unit.reach(meeting.t + near.moved))
        });
        best.map(|(t, triangle)| (near.moved + t, triangle))
    }

    /// What [`Self::meet`] finds, by testing every triangle.
    pub fn meet_by_brute_force(&self, ray: &Ray) -> Option<(f64, u32)> {
        let near = self.frame.near(ray)?;
        let aim = Aim::of(ray.direction);
        let shear = Shear::new(&near.ray, &aim);
        let mut best: Option<(f64, u32)> = None;
        for triangle in 0..self.triangle_count() as u32 {
            if let Some(meeting) = shear.meet(self.corners(triangle))
                && best.is_none_or(|(t, _)| meeting.t < t)
            {
                best = Some((meeting.t, triangle));
            }
        }
        best.map(|(t, triangle)| (near.moved + t, triangle))
    }

    pub fn has_shells(&self) -> bool {
        !self.shells.is_empty()
    }

    /// The nearest meetings within `reach` of every part of the mesh but that of a triangle.
    pub fn meet_other_shells(
        &self,
        triangle: u32,
        ray: &Ray,
        aim: &Aim,
        reach: f64,
    ) -> Vec<(f64, u32)> {
        let mut found: Vec<(f64, u32)> = Vec::new();
        let (Some(&own), Some(near)) = (self.shells.get(triangle as usize), self.frame.near(ray))
        else {
            return found;
        };
        let stack = &mut Stack::new();
        self.walk(&near, aim, reach, stack, |triangle, meeting, _| {
            let shell = self.shells[triangle as usize];
            let met = (near.moved + meeting.t, triangle);
            let known = found
                .iter_mut()
                .find(|(_, other)| self.shells[*other as usize] == shell);
            match known {
                Some(known) if met < *known => *known = met,
                None if shell != own && met.0 <= reach => found.push(met),
                _ => {}
            }
            None
        });
        found
    }

    /// Whether some triangle is met within `reach` at a t that is `near_enough`; which gets the triangle too.
    pub fn blocks(
        &self,
        ray: &Ray,
        aim: &Aim,
        reach: f64,
        stack: &mut Stack,
        mut near_enough: impl FnMut(f64, u32) -> bool,
    ) -> bool {
        let Some(near) = self.frame.near(ray) else {
            return false;
        };
        let mut is_blocked = false;
        self.walk(&near, aim, reach, stack, |triangle, meeting, _| {
            is_blocked = near_enough(near.moved + meeting.t, triangle);
            is_blocked.then_some(-1.0)
        });
        is_blocked
    }

    /// Shows `met` every meeting of the exact test in the leaves within reach; it may return a new reach.
    #[inline]
    fn walk(
        &self,
        near: &Near,
        aim: &Aim,
        reach: f64,
        stack: &mut Stack,
        mut met: impl FnMut(u32, Meeting, &UnitRay) -> Option<f32>,
    ) {
        let shear = Shear::new(&near.ray, aim);
        let unit = UnitRay::new(&self.frame, near, aim);
        let unit_shear = UnitShear::new(self.frame.unit_point(near.ray.origin), aim);
        self.hierarchy
            .walk(&unit, unit.reach(reach), stack, |leaf, mut reach, _| {
                let packet = &self.packets[leaf];
                let mut candidates = packet.candidates(&unit_shear);
                while candidates != 0 {
                    let place = candidates.trailing_zeros() as usize;
                    candidates &= candidates - 1;
                    let triangle = packet.triangles[place];
                    if triangle == NONE {
                        break;
                    }
                    let corners =
                        packet.vertices[place].map(|vertex| self.vertices[vertex as usize]);
                    let shorter = shear
                        .meet(corners)
                        .and_then(|meeting| met(triangle, meeting, &unit));
                    if let Some(shorter) = shorter {
                        reach = shorter;
                        if reach < 0.0 {
                            break;
                        }
                    }
                }
                reach
            });
    }

    /// The t of a hit along a ray that came `near` to be tested, where it was met at `t`. It is that of [`triangle::t_across`] unless the two
    /// are so far apart that a hierarchy could separate them: where the ray is flat, or the object small for its coordinates.
    pub fn t_along(&self, ray: &Ray, near: &Near, t: f64, triangle: u32) -> f64 {
        let moved_along = near.moved + t;
        triangle::t_across(self.corners(triangle), ray)
            .filter(|across| {
                let apart = (across - moved_along).abs();
                apart <= self.frame.sliver().min(0.25 * unsure(ray, moved_along))
            })
            .unwrap_or(moved_along)
    }

    /// The surface where a ray met a triangle, about at `position`.
    pub fn surface(&self, ray: &Ray, triangle: u32, position: DVec3) -> Surface {
        let corners = self.corners(triangle);
        let near = self.frame.near(ray);
        let aim = Aim::of(ray.direction);
        let meeting = near.and_then(|near| Shear::new(&near.ray, &aim).meet(corners));
        let weights = meeting.map_or_else(
            || triangle::weights_at(corners, position),
            |meeting| meeting.weights,
        );
        let plane = self.plane(triangle);
        let mut surface = triangle::surface(corners, weights, plane.map(|plane| plane.normal));
        if let Some(plane) = plane {
            surface.error += DVec3::splat(2.0 * plane.off_plane);
        }
        surface
    }

    fn plane(&self, triangle: u32) -> Option<&FacePlane> {
        let place = self.planes.partition_point(|plane| plane.end <= triangle);
        let plane = self.planes.get(place);
        plane.filter(|plane| plane.start <= triangle)
    }

    /// The normal of the whole face that a triangle is of, where all triangles of the face take it.
    pub fn plane_of(&self, triangle: u32) -> Option<DVec3> {
        Some(self.plane(triangle)?.normal)
    }

    /// Texture coordinates at a point of a triangle; (0, 0) where the mesh has none.
    pub fn uv(&self, triangle: u32, position: DVec3) -> DVec2 {
        let Some([a, b, c]) = self.uvs.get(triangle as usize) else {
            return DVec2::ZERO;
        };
        let [v, w] = triangle::weights_at(self.corners(triangle), position);
        *a + v * (*b - *a) + w * (*c - *a)
    }

    /// The chart of a triangle; none where the mesh has no texture coordinates.
    pub fn chart_part(&self, triangle: u32) -> Option<ChartPart> {
        let uvs = self.uvs.get(triangle as usize)?;
        ChartPart::triangle(self.corners(triangle), *uvs)
    }

    /// Whether a point is inside the surface, which is closed.
    pub fn contains(&self, point: DVec3) -> bool {
        let is_in_box = point.cmpge(self.low).all() && point.cmple(self.high).all();
        let triangles = (0..self.triangle_count() as u32).map(|triangle| self.corners(triangle));
        is_in_box && super::closed::winds_around(triangles, point)
    }
}

/// By how much the t of two hits near `distance` may be off against each other, where they were found along a ray moved near and
/// along the ray itself. Zero where the distance has no end.
pub(super) fn unsure(ray: &Ray, distance: f64) -> f64 {
    if distance.is_infinite() {
        return 0.0;
    }
    4096.0 * f64::EPSILON * (distance + ray.origin.abs().max_element())
}

/// The vertices in the order in which the triangles use them, so that those of one leaf lie together in memory. The triangles index the
/// new order afterwards.
fn in_order_of_use<'a>(
    vertices: Vec<DVec3>,
    triangles: &mut [[u32; 3]],
    order: impl Iterator<Item = &'a u32>,
) -> Vec<DVec3> {
    const UNUSED: u32 = u32::MAX;
    let mut place = vec![UNUSED; vertices.len()];
    let mut in_order = Vec::with_capacity(vertices.len());
    for &triangle in order {
        for vertex in &mut triangles[triangle as usize] {
            let place = &mut place[*vertex as usize];
            if *place == UNUSED {
                *place = in_order.len() as u32;
                in_order.push(vertices[*vertex as usize]);
            }
            *vertex = *place;
        }
    }
    in_order
}
