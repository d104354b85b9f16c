//! Camera, materials and lights.

use super::rules::{
    Check, FIELD_OF_VIEW, LENGTH, NOT_NEGATIVE, POSITIVE, RADIUS_OR_NONE, SHARE, SMALLEST, unit,
};
use crate::color::Rgb;
use crate::scene::document::{Keyed, Place};
use crate::scene::file::{CameraFile, LightFile, MaterialFile};
use crate::scene::values::{Coefficient, Number, Triple};
use crate::scene::{Camera, Highlight, Light, Material, Object, Shape, Texture};
use glam::DVec3;

impl Check {
    pub fn camera(&mut self, place: &Place, file: &CameraFile) -> Option<Camera> {
        let problems = self.count;
        let eye = self.point(&place.key("eye"), file.eye);
        let target = self.point(&place.key("target"), file.target);
        let places_are_right = self.count == problems;
        let up = self.direction(&place.key("up"), file.up);
        let degrees = self.number(
            &place.key("fov_x_degrees"),
            file.fov_x_degrees,
            FIELD_OF_VIEW,
        );
        if !places_are_right {
            return None;
        }
        let to_target = target - eye;
        let forward = unit(to_target).filter(|_| to_target.abs().max_element() >= SMALLEST);
        let Some(forward) = forward else {
            self.refuse(
                &place.key("target"),
                format!(
                    "found {:?}, the same place as `eye`; the camera needs a direction to look in",
                    file.target.0
                ),
            );
            return None;
        };
        if up != DVec3::ZERO && forward.cross(up).length() < 1e-9 {
            self.refuse(
                &place.key("up"),
                format!("found {:?}, parallel to the view from `eye` to `target`; allowed is any direction across it", file.up.0),
            );
        }
        Some(Camera {
            eye,
            target,
            up,
            fov_x: degrees.to_radians(),
        })
    }

    pub fn material(&mut self, place: &Place, name: String, file: MaterialFile) -> Material {
        let default = Material::default();
        let mut color = |key, written: Option<Triple>| {
            written.map_or(Rgb::BLACK, |written| self.color(&place.key(key), written))
        };
        let ambient = color("ambient", file.ambient);
        let diffuse = color("diffuse", file.diffuse);
        let emission = color("emission", file.emission);
        let mut coefficient = |key, written: Option<Coefficient>| match written {
            None => Rgb::BLACK,
            Some(Coefficient::Grey(k)) => Rgb::splat(self.number(&place.key(key), k, NOT_NEGATIVE)),
            Some(Coefficient::Color(k)) => self.color(&place.key(key), k),
        };
        let specular = coefficient("specular", file.specular);
        let reflection = coefficient("reflection", file.reflection);
        let transmission = coefficient("transmission", file.transmission);
        let mut number = |key, written: Option<Number>, default, rule| {
            written.map_or(default, |written| {
                self.number(&place.key(key), written, rule)
            })
        };
        let shininess = number("shininess", file.shininess, default.shininess, NOT_NEGATIVE);
        let ior = number("ior", file.ior, default.ior, POSITIVE);
        let reflectance = match file.reflectance {
            Some(written) => self
                .triple(&place.key("reflectance"), written, SHARE)
                .into(),
            None => diffuse.channels().map(|k_d| k_d.min(1.0)).into(),
        };
        let highlight = file.highlight.map_or(default.highlight, |written| {
            Highlight::from_name(&written).unwrap_or_else(|| {
                let known = Highlight::ALL.map(Highlight::name).join(", ");
                self.refuse(
                    &place.key("highlight"),
                    format!("found {written:?}; allowed are {known}"),
                );
                default.highlight
            })
        });
        let texture = file.texture.map(|Keyed(texture)| {
            let Keyed(checker) = texture.checker;
            let place = place.key("texture");
            let place = place.key("checker");
            let colors_place = place.key("colors");
            let colors: Vec<Rgb> = checker
                .colors
                .iter()
                .enumerate()
                .map(|(i, &color)| self.color(&colors_place.index(i), color))
                .collect();
            let colors = <[Rgb; 2]>::try_from(colors).unwrap_or_else(|colors| {
                self.refuse(
                    &colors_place,
                    format!("found {} colours; allowed are exactly 2", colors.len()),
                );
                [Rgb::BLACK; 2]
            });
            let scale = checker
                .scale
                .map_or(1.0, |scale| self.number(&place.key("scale"), scale, LENGTH));
            Texture::Checker { colors, scale }
        });
        Material {
            name,
            ambient,
            diffuse,
            specular,
            shininess,
            highlight,
            reflection,
            transmission,
            ior,
            emission,
            reflectance,
            texture,
        }
    }

    pub fn light(&mut self, place: &Place, file: &LightFile) -> Option<Light> {
        match (&file.point, &file.directional) {
            (Some(Keyed(point)), None) => {
                let place = place.key("point");
                Some(Light::Point {
                    position: self.point(&place.key("position"), point.position),
                    color: self.light_color(&place, point.color),
                    attenuation: self.attenuation(&place.key("attenuation"), point.attenuation),
                    radius: point.radius.map_or(0.0, |radius| {
                        self.number(&place.key("radius"), radius, RADIUS_OR_NONE)
                    }),
                })
            }
            (None, Some(Keyed(directional))) => {
                let place = place.key("directional");
                Some(Light::Directional {
                    toward: self.direction(&place.key("toward"), directional.toward),
                    color: self.light_color(&place, directional.color),
                })
            }
            (point, _) => {
                let found = if point.is_some() {
                    "two kinds"
                } else {
                    "no kind"
                };
                self.refuse(
                    place,
                    format!("found {found} of light; allowed is exactly one of `point` and `directional`"),
                );
                None
            }
        }
    }

    /// Notes checkers on meshes that have no texture coordinates.
    pub fn textures(&mut self, root: &Place, objects: &[Object], materials: &[Material]) {
        for (number, object) in objects.iter().enumerate() {
            let material = &materials[object.material];
            if let Shape::Mesh(mesh) = &object.shape
                && !mesh.has_uvs()
                && material.texture.is_some()
            {
                let what = format!("the texture of the material {:?}", material.name);
                let why = "the mesh has no texture coordinates (`vt`), so that all of it takes the colour at (0, 0)";
                self.note(
                    &root.key("objects").index(number).key("material"),
                    what,
                    why,
                );
            }
        }
    }

    fn light_color(&mut self, light: &Place, written: Option<Triple>) -> Rgb {
        let Some(written) = written else {
            return Rgb::WHITE;
        };
        let place = &light.key("color");
        let color = self.color(place, written);
        if color == Rgb::BLACK {
            self.note(place, "a black light", "it lights nothing");
        }
        color
    }
}
