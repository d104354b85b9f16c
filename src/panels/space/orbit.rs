//! From where the scene in space is looked at: a choice of the viewer.

use super::extent::{around, bounds};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::figure::{Fit, Space};
use crate::picture::Rect;
use glam::{DQuat, DVec2, DVec3, Vec2};
use std::f64::consts::{FRAC_PI_2, PI};

named! {
    /// Where the viewer stands before turning.
    #[derive(Default)]
    pub enum Preset {
        /// Behind the eye, aside and above.
        #[default]
        Overview = "overview",
        /// Where the scene's eye is, in perspective.
        Eye = "eye",
        /// Beside the scene; the camera looks to the right.
        Side = "side",
        /// Above the scene; the camera looks to the right.
        Above = "above",
        /// Across the plane of incidence where the current ray meets a surface.
        Incidence = "incidence",
        /// Behind the current ray.
        Ray = "ray",
    }
}

/// How the scene in space is looked at: a preset, turned, enlarged and moved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Orbit {
    pub from: Preset,
    /// To the viewer's right about the scene's vertical, and upward, in radians.
    turn: DVec2,
    /// Times e to this power as large.
    enlarged: f64,
    /// By how much what is shown is moved, in sizes of the panel; y down.
    shift: DVec2,
}

/// e to this power is the largest and the inverse the smallest scale.
const LARGEST: f64 = 3.5;
const SMALLEST: f64 = -1.0;

impl Orbit {
    /// A preset as it is.
    pub fn preset(from: Preset) -> Self {
        Orbit {
            from,
            ..Orbit::default()
        }
    }

    /// As if the scene were taken by the pointer and turned with it: by so many radians to the right and down.
    pub fn turned(self, by: Vec2) -> Self {
        let turn = self.turn + DVec2::new(-f64::from(by.x), f64::from(by.y));
        let around = (turn.x + PI).rem_euclid(2.0 * PI) - PI;
        Orbit {
            turn: DVec2::new(around, turn.y.clamp(-PI, PI)),
            ..self
        }
    }

    /// `factor` times as large about a place that lies `from_middle` of the panel's middle, in sizes of the panel.
    pub fn zoomed(self, factor: f32, from_middle: Vec2) -> Self {
        let enlarged = (self.enlarged + f64::from(factor).ln()).clamp(SMALLEST, LARGEST);
        let factor = (enlarged - self.enlarged).exp();
        let about = from_middle.as_dvec2();
        let shift = about + factor * (self.shift - about);
        Orbit {
            enlarged,
            ..self.at(shift)
        }
    }

    /// Moved by so many sizes of the panel.
    pub fn moved(self, by: Vec2) -> Self {
        self.at(self.shift + by.as_dvec2())
    }

    /// Something of the scene always stays in the panel.
    fn at(self, shift: DVec2) -> Self {
        let most = 0.5 * self.enlarged.exp().max(1.0);
        Orbit {
            shift: shift.clamp(DVec2::splat(-most), DVec2::splat(most)),
            ..self
        }
    }
}

/// A frame to look at something in, before it is turned and fitted.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub right: DVec3,
    pub up: DVec3,
    /// None where the middle of what is shown will do.
    pub pivot: Option<DVec3>,
    /// Of the viewer from the pivot; none of a parallel projection.
    pub distance: Option<f64>,
}

impl Frame {
    pub fn parallel(right: DVec3, up: DVec3) -> Self {
        Frame {
            right,
            up,
            pivot: None,
            distance: None,
        }
    }

    /// As seen from where `toward` points, with `vertical` upward.
    pub fn toward(toward: DVec3, vertical: DVec3) -> Self {
        let right = vertical
            .cross(toward)
            .try_normalize()
            .unwrap_or_else(|| toward.any_orthonormal_vector());
        Frame::parallel(right, toward.cross(right))
    }

    /// Where the preset stands that needs no ray.
    pub fn of(preset: Preset, prepared: &PreparedScene) -> Self {
        let (across, vertical) = axes(prepared);
        let side = across.cross(vertical);
        match preset {
            Preset::Eye => Frame {
                pivot: Some(target(prepared)),
                distance: Some(prepared.view.eye.distance(target(prepared))),
                ..Frame::parallel(prepared.view.right, prepared.view.up)
            },
            Preset::Side => Frame::parallel(across, vertical),
            Preset::Above => Frame::parallel(across, vertical.cross(across)),
            Preset::Overview | Preset::Incidence | Preset::Ray => {
                let aside = (side - 0.75 * across).normalize();
                Frame::toward((aside + 0.45 * vertical).normalize(), vertical)
            }
        }
    }

    /// The frame as `orbit` turns it, with all of `shown`, and lights not far away, as large as it fits
    /// into the area; at the eye, what the camera sees.
    pub fn looked_at(
        self,
        orbit: &Orbit,
        prepared: &PreparedScene,
        [shown, lights]: [&[DVec3]; 2],
        area: Rect,
    ) -> Space {
        let (_, vertical) = axes(prepared);
        let about_vertical = DQuat::from_axis_angle(vertical, orbit.turn.x);
        let (right, up) = (about_vertical * self.right, about_vertical * self.up);
        // Not over the top: the vertical stays upward.
        let risen = right.cross(up).dot(vertical).clamp(-1.0, 1.0).asin();
        let rise = (risen + orbit.turn.y).clamp(-FRAC_PI_2, FRAC_PI_2) - risen;
        let up = DQuat::from_axis_angle(right, -rise) * up;
        let toward = right.cross(up);
        let pivot = self.pivot.unwrap_or_else(|| middle(shown));
        let flat = |point: DVec3| {
            let point = point - pivot;
            DVec2::new(point.dot(right), -point.dot(up))
        };
        let flat = |points: &[DVec3]| -> Vec<DVec2> { points.iter().copied().map(flat).collect() };
        let (whole, [low, high]) = match self.distance {
            Some(distance) => {
                let view = &prepared.view;
                let size = DVec2::new(view.width.into(), view.height.into());
                let half = 0.5 * distance / view.focal * size;
                (Fit::new(-half, half, area), [-half, half])
            }
            None => {
                let [low, high] = around(&flat(shown), &flat(lights));
                (Fit::new(low, high, area), around(&flat(shown), &[]))
            }
        };
        let scale = whole.scale * orbit.enlarged.exp();
        let size = DVec2::new(area.width.into(), area.height.into());
        let center = whole.point(area.center()) - orbit.shift * size / scale;
        // What is moved far away stays at the border of what there is.
        let center = match orbit.shift == DVec2::ZERO {
            true => center,
            false => center.max(low).min(high),
        };
        Space {
            right,
            up,
            toward,
            pivot,
            distance: self.distance,
            fit: Fit::centered(center, scale, area),
            area,
        }
    }
}

/// Of the box around points.
fn middle(points: &[DVec3]) -> DVec3 {
    let [low, high] = bounds(points.iter().copied());
    match low.cmple(high).all() {
        true => low.midpoint(high),
        false => DVec3::ZERO,
    }
}

/// What the camera looks at.
pub(super) fn target(prepared: &PreparedScene) -> DVec3 {
    let ahead = prepared.view.eye + prepared.view.forward;
    prepared.scene.camera.map_or(ahead, |camera| camera.target)
}

/// The horizontal direction in which the camera looks, and up.
pub(super) fn axes(prepared: &PreparedScene) -> (DVec3, DVec3) {
    let view = &prepared.view;
    let up = prepared
        .scene
        .camera
        .map_or(view.up, |camera| camera.up.normalize());
    let across = (view.forward - view.forward.dot(up) * up).try_normalize();
    (across.unwrap_or(view.up), up)
}
