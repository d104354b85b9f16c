//! The point at which a ray meets a surface, prepared for the illumination model: the side it is on, its normal and its diffuse
//! coefficient.
//!
//! N_geometric points out of a closed object, and to the front of a polygon. The ray enters where u·N_geometric < 0; N is
//! turned toward the incoming ray. A texture multiplies k_d.

use super::illumination::{self, Lighting, SurfacePoint, illuminate};
use super::incidence::Incidence;
use super::visible::Intersection;
use crate::color::Rgb;
use crate::record::Recorder;
use crate::scene::primitives::{Hit, Primitives, Ray, Surface};
use crate::scene::{Light, Needs, Scene};
use glam::{DVec2, DVec3};

/// A surface as the ray sees it.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceInteraction<'a> {
    pub surface: Surface,
    pub point: SurfacePoint<'a>,
    /// Unit, toward the incoming ray.
    pub normal: DVec3,
    /// −u·N, not negative.
    pub cos_theta_i: f64,
    /// Into the object, through its outside.
    pub entering: bool,
}

impl SurfaceInteraction<'_> {
    /// I_local: the illumination model, for which `arrives` says whether a light reaches the point, and emission.
    pub fn local<E: From<illumination::Event>, R: Recorder<E>>(
        &self,
        lighting: &Lighting,
        recorder: &mut R,
        arrives: impl FnMut(&Incidence, &mut R) -> bool,
    ) -> Rgb {
        let lit = illuminate(&self.point, lighting, recorder, arrives).whole;
        (lit + self.point.material.emission).finite()
    }
}

/// The surface at a hit. A texture is looked up only where one is needed.
pub fn interact<'a, E: From<Event>>(
    scene: &'a Scene,
    primitives: &Primitives,
    needs: &Needs,
    ray: &Ray,
    hit: &Hit,
    recorder: &mut impl Recorder<E>,
) -> SurfaceInteraction<'a> {
    let surface = primitives.surface(ray, hit);
    recorder.step(|| {
        Event::SurfaceMet {
            object: hit.object,
            position: surface.position,
            normal: surface.normal,
        }
        .into()
    });
    let along = ray.direction.dot(surface.normal);
    let entering = along < 0.0;
    let normal = if along > 0.0 {
        -surface.normal
    } else {
        surface.normal
    };
    recorder.step(|| {
        Event::Faced {
            normal,
            cos_theta_i: along.abs(),
            entering,
        }
        .into()
    });

    let material = &scene.materials[scene.objects[hit.object as usize].material];
    let mut diffuse = material.diffuse;
    if let Some(texture) = needs.texture(material) {
        let uv = primitives.uv(hit, surface.position);
        let color = texture.color_at(uv);
        recorder.step(|| Event::Textured { uv, color }.into());
        diffuse = diffuse * color;
    }
    let point = SurfacePoint {
        position: surface.position,
        normal,
        to_eye: -ray.direction,
        material,
        diffuse,
    };
    SurfaceInteraction {
        surface,
        point,
        normal,
        cos_theta_i: along.abs(),
        entering,
    }
}

/// The colour of a ray that meets no object: the background, or the colour of a light ball.
pub fn without_object<E: From<Event>>(
    scene: &Scene,
    met: &Intersection,
    recorder: &mut impl Recorder<E>,
) -> Rgb {
    match *met {
        Intersection::Light { light, .. } => {
            let (Light::Point { color, .. } | Light::Directional { color, .. }) =
                scene.lights[light as usize];
            recorder.step(|| Event::LightMet { light, color }.into());
            color
        }
        Intersection::Nothing | Intersection::Object(_) => {
            let color = scene.background;
            recorder.step(|| Event::Background { color }.into());
            color
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// The ray leaves the scene.
    Background {
        color: Rgb,
    },
    /// The ray meets the ball of a light and has its colour.
    LightMet {
        light: u32,
        color: Rgb,
    },
    /// `normal` is N_geometric.
    SurfaceMet {
        object: u32,
        position: DVec3,
        normal: DVec3,
    },
    /// `normal` is N, turned toward the incoming ray.
    Faced {
        normal: DVec3,
        cos_theta_i: f64,
        entering: bool,
    },
    Textured {
        uv: DVec2,
        color: Rgb,
    },
}
