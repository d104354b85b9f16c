//! The current polygon, vertex, point, edge, scan line, span and pixel of a scan-line method, each with what is known of it so
//! far and the step that opened it.

use crate::algorithms::illumination;
use crate::algorithms::scan_line::Named;
use crate::color::Rgb;
use crate::record::Value;
use glam::DVec3;

#[derive(Clone, Copy, Debug)]
pub struct CurrentPolygon {
    pub polygon: u32,
}

#[derive(Clone, Debug)]
pub struct CurrentVertex {
    pub vertex: u32,
    pub position: DVec3,
    /// Faces whose normals were added so far, with the step that did it.
    pub faces: Vec<(u32, DVec3, usize)>,
    pub sum: DVec3,
    /// N_v, once it is known.
    pub normal: Option<DVec3>,
    /// I_v, once it is known.
    pub intensity: Option<Rgb>,
}

#[derive(Clone, Debug)]
pub struct CurrentPoint {
    pub position: DVec3,
    pub normal: DVec3,
    pub to_eye: Option<DVec3>,
    pub ambient: Option<Rgb>,
    pub lights: Vec<CurrentLight>,
    pub intensity: Option<Rgb>,
    pub step: usize,
}

impl CurrentPoint {
    /// Follows the illumination model at the current point.
    pub(super) fn light(current: &mut Option<Self>, step: usize, event: &illumination::Event) {
        use illumination::Event;
        if let Event::Illumination { position, normal } = *event {
            let point = CurrentPoint {
                position,
                normal,
                to_eye: None,
                ambient: None,
                lights: Vec::new(),
                intensity: None,
                step,
            };
            *current = Some(point);
        }
        let Some(point) = current else { return };
        if let Event::Light {
            light,
            distance,
            attenuation,
            slide_factor,
            ..
        } = *event
        {
            let light = CurrentLight {
                light,
                distance,
                attenuation,
                slide_factor,
                to_light: None,
                halfway: None,
                mirrored: None,
                diffuse: None,
                specular: None,
                step,
            };
            point.lights.push(light);
        }
        let light = point.lights.last_mut();
        match (*event, light) {
            (Event::Viewer { to_eye, .. }, _) => point.to_eye = Some(to_eye),
            (Event::Ambient { term, .. }, _) => point.ambient = Some(term),
            (Event::Illuminated { intensity }, _) => point.intensity = Some(intensity),
            (Event::ToLight { to_light, n_dot_l }, Some(light)) => {
                light.to_light = Some((to_light, n_dot_l));
            }
            (Event::Diffuse { term, .. }, Some(light)) => light.diffuse = Some(term),
            (
                Event::Mirrored {
                    mirrored, r_dot_v, ..
                },
                Some(light),
            ) => {
                light.mirrored = Some((mirrored, r_dot_v));
            }
            (
                Event::Halfway {
                    halfway, n_dot_h, ..
                },
                Some(light),
            ) => {
                light.halfway = Some((halfway, n_dot_h));
            }
            (Event::Specular { term, .. }, Some(light)) => light.specular = Some(term),
            _ => {}
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentLight {
    pub light: u32,
    /// Infinite for a directional light.
    pub distance: f64,
    pub attenuation: f64,
    /// What the slide has in place of f_att·N·L.
    pub slide_factor: f64,
    /// L and N·L.
    pub to_light: Option<(DVec3, f64)>,
    /// H and N·H.
    pub halfway: Option<(DVec3, f64)>,
    /// R and R·V.
    pub mirrored: Option<(DVec3, f64)>,
    pub diffuse: Option<Rgb>,
    pub specular: Option<Rgb>,
    pub step: usize,
}

/// A value interpolated both ways, and their difference, which is rounding.
#[derive(Clone, Copy, Debug)]
pub struct Interpolated {
    pub direct: Value,
    pub incremental: Value,
    pub difference: Value,
}

impl Interpolated {
    pub(super) fn new<A: Named>(direct: A, incremental: A) -> Option<Self> {
        Some(Interpolated {
            direct: direct.value()?,
            incremental: incremental.value()?,
            difference: incremental.minus(direct).value()?,
        })
    }
}

/// On the screen.
#[derive(Clone, Copy, Debug)]
pub struct CurrentCorner {
    pub x: f64,
    pub y: f64,
    pub value: Option<Value>,
}

#[derive(Clone, Copy, Debug)]
pub struct ActiveEdge {
    pub edge: u32,
    pub upper: u32,
    pub lower: u32,
    pub first: u32,
    pub end: u32,
    pub slope: f64,
    pub value_step: Option<Value>,
    /// Where the current scan line cuts it, once that is known.
    pub cut: Option<CurrentCut>,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentCut {
    pub x_4: f64,
    pub values: Option<Interpolated>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentRow {
    pub y: u32,
    pub y_4: f64,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentSpan {
    pub x_4: f64,
    pub x_5: f64,
    pub first: u32,
    pub end: u32,
    /// The values at x_4 and x_5, once they are known.
    pub ends: Option<[Value; 2]>,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentPixel {
    pub x: u32,
    pub y: u32,
    pub x_p: f64,
    /// Depth, the depth drawn before, and whether the pixel is nearer.
    pub depth: Option<(f64, f64, bool)>,
    pub values: Option<Interpolated>,
    pub step: usize,
}
