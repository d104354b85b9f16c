//! What a scan-line method has in hand at a step: the polygon, vertex, point, edge, scan line, span and pixel that it is at,
//! with what has been told of each so far and the step that told it.

use crate::algorithms::illumination;
use crate::color::Rgb;
use glam::DVec3;

#[derive(Clone, Copy, Debug)]
pub struct CurrentPolygon {
    pub object: u32,
    pub polygon: u32,
    pub step: usize,
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
    pub step: usize,
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
    /// What the illumination model told of the point in hand.
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

/// On the screen; `z` is the depth.
#[derive(Clone, Copy, Debug)]
pub struct CurrentCorner<A> {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub value: A,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct ActiveEdge<A> {
    pub edge: u32,
    pub upper: u32,
    pub lower: u32,
    pub first: u32,
    pub end: u32,
    pub slope: f64,
    pub value_step: A,
    /// Where the scan line in hand cuts it, once that was told.
    pub cut: Option<CurrentCut<A>>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentCut<A> {
    pub x_4: f64,
    /// Direct and incremental value, once they are told.
    pub values: Option<(A, A)>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentRow {
    pub y: u32,
    pub y_4: f64,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentSpan<A> {
    pub x_4: f64,
    pub x_5: f64,
    pub first: u32,
    pub end: u32,
    /// a_4 and a_5, once they are told.
    pub ends: Option<(A, A)>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct CurrentPixel<A> {
    pub x: u32,
    pub y: u32,
    pub x_p: f64,
    /// Depth, the depth drawn before, and whether the pixel is nearer.
    pub depth: Option<(f64, f64, bool)>,
    /// Direct and incremental value.
    pub values: Option<(A, A)>,
    pub step: usize,
}
