//! A corner of a polygon, in the camera frame and on the screen.

use glam::DVec3;

/// A corner in the camera frame, with the value there.
#[derive(Clone, Copy, Debug)]
pub struct Corner<V> {
    pub position: DVec3,
    pub value: V,
}

impl<V> Corner<V> {
    /// The same corner with another value.
    pub fn map<W>(self, change: impl FnOnce(V) -> W) -> Corner<W> {
        Corner {
            position: self.position,
            value: change(self.value),
        }
    }
}

/// A corner on the screen.
#[derive(Clone, Copy, Debug)]
pub struct ScreenCorner<V> {
    pub x: f64,
    pub y: f64,
    pub inverse_depth: f64,
    pub value: V,
}
