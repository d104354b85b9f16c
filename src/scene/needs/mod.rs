//! What rays need of a scene, read once, and what can be left out without changing a bit of the picture: each with its place in
//! the scene and the reason.

mod part;
mod shadows;

pub use part::{Part, Parts};

use super::{Light, Material, Scene, Texture};
use crate::color::Rgb;
use shadows::shadows;

/// What ray tracing has to do in a scene. What is false is left out, and the picture stays the same, bit for bit.
#[derive(Clone, Debug, PartialEq)]
pub struct Needs {
    /// Some surface reflects: mirrored rays.
    pub reflection: bool,
    /// Some surface transmits: refracted rays, and the media that they are in.
    pub transmission: bool,
    /// Some surface has a texture: (u, v) at the hit.
    pub textures: bool,
    /// Some surface has a highlight: a cosine raised to the shininess.
    pub specular: bool,
    /// Some light is a ball that rays see.
    pub light_balls: bool,
    /// Secondary rays lose light on their way.
    pub path_attenuation: bool,
    /// What is done although the scene does not need it.
    forced: Parts,
    /// By light, then by object: whether anything may stand between a lit point of the object and the light.
    shadows: Vec<Vec<bool>>,
    /// What the scene does not need.
    pub skipped: Vec<LeftOut>,
}

/// Something that a scene does not need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    pub part: Part,
    /// Where in the scene file the reason stands: `materials`, `lights[1]`.
    pub place: String,
    /// How many of how many it concerns, as its part counts them; none where it concerns all.
    pub share: Option<[usize; 2]>,
}

impl Needs {
    pub fn of(scene: &Scene) -> Self {
        let used = || {
            scene
                .objects
                .iter()
                .map(|object| &scene.materials[object.material])
        };
        let any = |has: fn(&Material) -> bool| used().any(has);
        let mut needs = Needs {
            reflection: any(|material| material.reflection != Rgb::BLACK),
            transmission: any(|material| material.transmission != Rgb::BLACK),
            textures: any(|material| material.texture.is_some()),
            specular: has_highlights(scene),
            light_balls: scene
                .lights
                .iter()
                .any(|light| matches!(light, Light::Point { radius, .. } if *radius > 0.0)),
            path_attenuation: scene.path_attenuation != [1.0, 0.0, 0.0],
            forced: Parts::NONE,
            shadows: shadows(scene),
            skipped: Vec::new(),
        };
        needs.skipped = needs.list();
        needs
    }

    /// The same, with some parts done although they are not needed: on every surface, also where the scene needs them on others.
    pub fn with_forced(mut self, forced: Parts) -> Self {
        self.forced = forced;
        for (needed, part) in [
            (&mut self.reflection, Part::ReflectedRays),
            (&mut self.transmission, Part::TransmittedRays),
            (&mut self.textures, Part::TextureCoordinates),
            (&mut self.specular, Part::Highlights),
            (&mut self.light_balls, Part::LightBalls),
            (&mut self.path_attenuation, Part::PathAttenuation),
        ] {
            *needed |= forced.has(part);
        }
        if forced.has(Part::ShadowRays) {
            let all = self.shadows.iter_mut().flatten();
            all.for_each(|shadow| *shadow = true);
        }
        self
    }

    /// Whether a mirrored ray is sent from such a surface.
    pub fn reflects(&self, material: &Material) -> bool {
        let forced = self.forced.has(Part::ReflectedRays);
        self.reflection && (forced || material.reflection != Rgb::BLACK)
    }

    /// Whether a refracted ray is sent into such a surface.
    pub fn transmits(&self, material: &Material) -> bool {
        let forced = self.forced.has(Part::TransmittedRays);
        self.transmission && (forced || material.transmission != Rgb::BLACK)
    }

    /// What is looked up on such a surface.
    pub fn texture(&self, material: &Material) -> Option<Texture> {
        let white = self.forced.has(Part::TextureCoordinates);
        let texture = material.texture.or(white.then_some(Texture::WHITE));
        texture.filter(|_| self.textures)
    }

    /// Whether a shadow ray is needed from `object` to `light`.
    pub fn shadow(&self, light: usize, object: usize) -> bool {
        self.shadows[light][object]
    }

    fn list(&self) -> Vec<LeftOut> {
        let parts = [
            (self.reflection, Part::ReflectedRays, "materials"),
            (self.transmission, Part::TransmittedRays, "materials"),
            (self.textures, Part::TextureCoordinates, "materials"),
            (self.specular, Part::Highlights, "materials"),
            (self.light_balls, Part::LightBalls, "lights"),
            (
                self.path_attenuation,
                Part::PathAttenuation,
                "path_attenuation",
            ),
        ];
        let mut skipped: Vec<LeftOut> = parts
            .into_iter()
            .filter(|(needed, ..)| !needed)
            .map(|(_, part, place)| LeftOut {
                part,
                place: place.into(),
                share: None,
            })
            .collect();
        for (light, objects) in self.shadows.iter().enumerate() {
            let clear = objects.iter().filter(|&&shadowed| !shadowed).count();
            if clear > 0 {
                skipped.push(LeftOut {
                    part: Part::ShadowRays,
                    place: format!("lights[{light}]"),
                    share: (clear < objects.len()).then_some([clear, objects.len()]),
                });
            }
        }
        skipped
    }
}

/// Whether some surface has a highlight.
pub fn has_highlights(scene: &Scene) -> bool {
    let material = |object: &super::Object| &scene.materials[object.material];
    let mut used = scene.objects.iter().map(material);
    used.any(|material| material.specular != Rgb::BLACK)
}
