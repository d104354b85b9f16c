//! Moving things of the scene by the pointer, wherever a panel shows where they stand.

use super::super::list::{image, scan_line, space};
use super::super::{Panel, PanelInput};
use crate::figure::{Fit, Space};
use crate::picture::Rect;
use crate::scene::{Movable, View};
use glam::{DVec3, Vec2};

/// How near the pointer must be to what it takes, in points.
const REACH: f32 = 14.0;

/// How a panel shows the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sight {
    Space(Space),
    /// Through the camera, in `area`; the fit is that of its pixels.
    Camera {
        view: View,
        fit: Fit,
        area: Rect,
    },
}

impl Sight {
    fn of(panel: Panel, input: &PanelInput, size: Vec2) -> Option<Self> {
        match panel {
            Panel::Space => Some(Sight::Space(space::sight(input, size))),
            Panel::Image => image::sight(input, size),
            Panel::ScanLine => scan_line::sight(input, size),
            _ => None,
        }
    }

    fn area(&self) -> Rect {
        match self {
            Sight::Space(space) => space.area,
            Sight::Camera { area, .. } => *area,
        }
    }

    fn place(&self, point: DVec3) -> Option<Vec2> {
        match self {
            Sight::Space(space) => space.place(point),
            Sight::Camera { view, fit, .. } => {
                let seen = view.to_camera(point);
                (seen.z >= view.near).then(|| fit.place(view.to_screen(seen)))
            }
        }
    }

    /// The point of the world at a place in the area, as far from the viewer as `beside`.
    fn lift(&self, at: Vec2, beside: DVec3) -> DVec3 {
        match self {
            Sight::Space(space) => space.lift(at, beside),
            Sight::Camera { view, fit, area } => {
                let inside = at.clamp(area.min(), area.max());
                view.from_screen(fit.point(inside), view.to_camera(beside).z)
            }
        }
    }
}

/// Where something stands that may be moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Handle {
    pub of: Movable,
    pub at: Vec2,
    position: DVec3,
    sight: Sight,
}

/// Of what may be moved, what has its place in the panel of that size.
pub fn handles(
    panel: Panel,
    input: &PanelInput,
    size: Vec2,
    movable: impl Iterator<Item = Movable>,
) -> Vec<Handle> {
    let Some(sight) = Sight::of(panel, input, size) else {
        return Vec::new();
    };
    let scene = &input.run.prepared().scene;
    // A panel of one polygon is about nothing but its vertices.
    let polygon = (panel == Panel::ScanLine).then(|| scan_line::object(input));
    // Lamps play no part where light is exchanged.
    let exchanges = input.run.enclosure().is_some();
    let is_shown = |of: Movable| match (polygon, of) {
        (Some(polygon), Movable::Vertex { object, .. }) => polygon == Some(object),
        (Some(_), _) => false,
        (None, Movable::Light(_)) => !exchanges,
        _ => true,
    };
    let handle = |of: Movable| {
        let position = of.position(scene)?;
        let at = sight.place(position)?;
        sight.area().contains(at).then_some(Handle {
            of,
            at,
            position,
            sight,
        })
    };
    movable
        .filter(|&of| is_shown(of))
        .filter_map(handle)
        .collect()
}

/// Something that the pointer holds: it moves across the line of sight, as the view was when it was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    handle: Handle,
    /// From the pointer to the handle.
    offset: Vec2,
}

impl Grip {
    /// What the pointer at `at` takes.
    pub fn nearest(handles: &[Handle], at: Vec2) -> Option<Self> {
        let grips = handles.iter().map(|&handle| Grip {
            handle,
            offset: handle.at - at,
        });
        grips
            .filter(|grip| grip.offset.length() <= REACH)
            .min_by(|a, b| a.offset.length().total_cmp(&b.offset.length()))
    }

    pub fn of(&self) -> Movable {
        self.handle.of
    }

    /// Where it is once the pointer is at `at`; it stays in the view, and as far from the viewer as it was.
    pub fn position(&self, at: Vec2) -> DVec3 {
        let Handle {
            sight, position, ..
        } = self.handle;
        sight.lift(at + self.offset, position)
    }
}

#[cfg(test)]
mod tests;
