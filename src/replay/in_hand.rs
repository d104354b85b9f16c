//! What a scan-line method has in hand at a step: the polygon, vertex, point, edge, scan line, span and pixel that it is at,
//! with what has been told of each so far and the step that told it.

use crate::color::Rgb;
use glam::DVec3;

#[derive(Clone, Copy, Debug)]
pub struct PolygonInHand {
    pub object: u32,
    pub polygon: u32,
    pub step: usize,
}

#[derive(Clone, Debug)]
pub struct VertexInHand {
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
pub struct PointInHand {
    pub position: DVec3,
    pub normal: DVec3,
    pub to_eye: Option<DVec3>,
    pub ambient: Option<Rgb>,
    pub lights: Vec<LightInHand>,
    pub intensity: Option<Rgb>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct LightInHand {
    pub light: u32,
    pub attenuation: f64,
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
pub struct CornerInHand<A> {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub value: A,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct EdgeInHand<A> {
    pub edge: u32,
    pub upper: u32,
    pub lower: u32,
    pub first: u32,
    pub end: u32,
    pub slope: f64,
    pub value_step: A,
    /// Where the scan line in hand cuts it, once that was told.
    pub cut: Option<CutInHand<A>>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct CutInHand<A> {
    pub x_4: f64,
    /// Direct and incremental value, once they are told.
    pub values: Option<(A, A)>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct RowInHand {
    pub y: u32,
    pub y_4: f64,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct SpanInHand<A> {
    pub x_4: f64,
    pub x_5: f64,
    pub first: u32,
    pub end: u32,
    /// a_4 and a_5, once they are told.
    pub ends: Option<(A, A)>,
    pub step: usize,
}

#[derive(Clone, Copy, Debug)]
pub struct PixelInHand<A> {
    pub x: u32,
    pub y: u32,
    pub x_p: f64,
    /// Depth, the depth drawn before, and whether the pixel is nearer.
    pub depth: Option<(f64, f64, bool)>,
    /// Direct and incremental value.
    pub values: Option<(A, A)>,
    pub step: usize,
}
