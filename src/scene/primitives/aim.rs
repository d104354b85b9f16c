//! What the tests need of a ray's direction, found once a ray.

use glam::{DVec3, Vec4};

/// A direction's component below this is taken for it: at that slope a ray leaves no slab within the unit box.
const FLATTEST: f64 = 1e-20;

/// A unit direction, prepared for boxes and for triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim {
    /// 1/direction, by axis.
    pub inverse: [Vec4; 3],
    /// Which side of a box is nearer, by axis: 0 the low one, 1 the high one.
    pub near_side: [usize; 3],
    /// The axes in cyclic order, the one along which the ray runs the most last.
    pub axes: [usize; 3],
    /// How far the ray runs along the first two axes a unit along the last.
    pub slopes: [f64; 2],
    /// How far the ray runs a unit along the last axis, of its sign.
    pub length: f64,
}

impl Aim {
    pub fn of(direction: DVec3) -> Self {
        let steep = direction
            .to_array()
            .map(|x| x.abs().max(FLATTEST).copysign(x));
        let axis = direction.abs().max_position();
        let axes = [(axis + 1) % 3, (axis + 2) % 3, axis];
        let [x, y, z] = axes.map(|axis| direction[axis]);
        Aim {
            inverse: steep.map(|x| Vec4::splat((1.0 / x) as f32)),
            near_side: steep.map(|x| usize::from(x < 0.0)),
            axes,
            slopes: [x / z, y / z],
            length: 1.0 / z,
        }
    }
}
