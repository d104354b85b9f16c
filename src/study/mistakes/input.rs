//! Mistakes that a wrong input makes: a wrong scene, view or setting.

use super::{Mistake, normals, with};
use crate::algorithms::primary;
use crate::color::Rgb;
use crate::methods::Setup;
use crate::scene::{Camera, Highlight, Light, View};
use std::num::NonZeroU32;

/// Wider than this an angle of the camera is none, in radians.
const WIDEST: f64 = 3.1;

impl Mistake {
    /// What a right program would have to be given to err like this; none where no input does that.
    pub fn wrong_input(self, setup: &Setup) -> Option<Setup> {
        let prepared = &setup.prepared;
        let mut scene = prepared.scene.clone();
        let mut view = prepared.view;
        let mut rays: primary::Settings = setup.settings.get();
        match self {
            Mistake::EtaInverted => {
                let materials = scene.materials.iter_mut();
                materials.for_each(|material| material.ior = 1.0 / material.ior);
            }
            Mistake::FovVertical | Mistake::FovHalfAngle => {
                let camera = scene.camera?;
                let fov_x = if self == Mistake::FovHalfAngle {
                    2.0 * camera.fov_x
                } else {
                    let aspect = f64::from(view.width) / f64::from(view.height);
                    2.0 * ((0.5 * camera.fov_x).tan() * aspect).atan()
                };
                if fov_x > WIDEST {
                    return None;
                }
                view = View::new(&Camera { fov_x, ..camera }, view.width, view.height);
            }
            Mistake::AmbientPerLight => scene.ambient = scene.ambient * scene.lights.len() as f64,
            Mistake::NoAttenuation => {
                for light in &mut scene.lights {
                    if let Light::Point { attenuation, .. } = light {
                        *attenuation = [1.0, 0.0, 0.0];
                    }
                }
            }
            Mistake::DepthMinusOne => rays.depth = NonZeroU32::new(rays.depth.get() - 1)?,
            Mistake::DepthPlusOne => rays.depth = rays.depth.saturating_add(1),
            Mistake::ReflectionForgotten => {
                let materials = scene.materials.iter_mut();
                materials.for_each(|material| material.reflection = Rgb::BLACK);
            }
            Mistake::AmbientForgotten => scene.ambient = Rgb::BLACK,
            Mistake::ExponentForgotten => {
                let materials = scene.materials.iter_mut();
                materials.for_each(|material| material.shininess = 1.0);
            }
            Mistake::HighlightSwapped => {
                for material in &mut scene.materials {
                    material.highlight = match material.highlight {
                        Highlight::Phong => Highlight::Blinn,
                        Highlight::Blinn => Highlight::Phong,
                    };
                }
            }
            Mistake::NoShadows => {
                let objects = scene.objects.iter_mut();
                objects.for_each(|object| object.casts_shadow = false);
            }
            Mistake::VertexNormalsByArea => scene = normals::weighted_by_area(prepared),
            _ => return None,
        }
        Some(with(setup, scene, view, setup.settings.clone().with(rays)))
    }
}
