//! What is drawn: camera, lights, materials and objects, read from a scene file and checked.
//!
//! Right-handed coordinates, any length unit; angles in radians here, in degrees in files; colours in linear RGB.

mod bare_mesh;
mod body_notes;
mod camera;
mod division;
pub mod document;
pub mod edit;
mod even_odd;
mod file;
pub mod locate;
mod mesh;
mod mesh_file;
mod movable;
mod needs;
mod note;
mod outside;
mod parser_words;
pub mod patch_primitives;
pub mod patches;
pub mod primitives;
mod replaced;
mod schema;
mod tessellation;
mod validate;
mod values;

pub use bare_mesh::{is_mesh, scene_of_mesh};
pub use body_notes::body_notes;
pub use camera::{Camera, View};
pub use file::SceneFile;
pub use mesh::Mesh;
pub use mesh_file::{MeshData, mesh_path_is_inside};
pub use movable::{Movable, NoRoom};
pub use needs::{LeftOut, Needs, Part, Parts, has_highlights};
pub use note::Note;
pub use parser_words::what_the_parser_says;
pub use replaced::replaced;
pub use schema::{scene_schema, schema_of};
pub use tessellation::{
    CYLINDER_SIDES, Tessellation, grid_weights, patch_point, ring_axes, sphere as sphere_mesh,
};
pub use validate::{LARGEST, Limits, ReadFile, SceneError, read};

use crate::color::Rgb;
use crate::language::Language;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// A scene that was found right: every index is in range, every number finite and within its bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    pub background: Rgb,
    /// A, the ambient light of the scene.
    pub ambient: Rgb,
    /// a0, a1, a2 of the attenuation of secondary rays.
    pub path_attenuation: [f64; 3],
    pub camera: Option<Camera>,
    pub materials: Vec<Material>,
    pub objects: Vec<Object>,
    pub lights: Vec<Light>,
    /// What the file says without effect, whatever the method.
    pub notes: Vec<Note>,
    /// Of lessons, which have texts in every language.
    pub names: Names,
}

/// How a surface answers light. No coefficient is scaled by another.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub name: String,
    /// k_a
    pub ambient: Rgb,
    /// k_d
    pub diffuse: Rgb,
    /// k_s
    pub specular: Rgb,
    /// n_s
    pub shininess: f64,
    pub highlight: Highlight,
    pub reflection: Rgb,
    pub transmission: Rgb,
    /// η, the index of refraction inside.
    pub ior: f64,
    /// Radiant exitance that the surface gives off by itself.
    pub emission: Rgb,
    /// ρ, for radiosity.
    pub reflectance: Rgb,
    pub texture: Option<Texture>,
}

named! {
    /// Which cosine the specular term raises to the shininess.
    pub enum Highlight {
        /// N·H (Blinn 1977)
        Blinn = "blinn",
        /// R·V (Phong 1975)
        Phong = "phong",
    }
}

/// Multiplies the diffuse coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texture {
    /// `colors[(⌊u/scale⌋ + ⌊v/scale⌋) mod 2]`
    Checker { colors: [Rgb; 2], scale: f64 },
}

#[derive(Clone, Debug, PartialEq)]
pub struct Object {
    pub name: String,
    /// Index into [`Scene::materials`].
    pub material: usize,
    pub shape: Shape,
    /// Radiosity patches along u and v.
    pub patches: [u32; 2],
    /// Of a sphere: into n parts from pole to pole and 2n around, where polygons are needed.
    pub divisions: u32,
    pub casts_shadow: bool,
    pub vertex_normals: VertexNormals,
}

/// What the scan-line methods take for the normal at a corner of a face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VertexNormals {
    /// The mean over the faces around the vertex that meet this one at no more than `crease`, an angle in radians.
    Averaged { crease: f64 },
    /// That of the mesh file, and the mean over all faces around the vertex where the file has none.
    File,
    /// That of the face.
    Face,
}

named! {
    /// Where the normals at the vertices come from, as a file says it.
    pub enum NormalsFrom {
        Averaged = "averaged",
        File = "file",
        Face = "face",
    }
}

impl VertexNormals {
    /// Over all faces around the vertex.
    pub const AVERAGED: VertexNormals = VertexNormals::Averaged {
        crease: std::f64::consts::PI,
    };
}

impl Default for Scene {
    /// Nothing, and no camera.
    fn default() -> Self {
        Scene {
            background: Rgb::BLACK,
            ambient: Rgb::WHITE,
            path_attenuation: [1.0, 0.0, 0.0],
            camera: None,
            materials: Vec::new(),
            objects: Vec::new(),
            lights: Vec::new(),
            notes: Vec::new(),
            names: Names::new(),
        }
    }
}

/// What objects and materials are called, by their names in the file and by language.
pub type Names = BTreeMap<String, [String; Language::ALL.len()]>;

impl Scene {
    /// What the object or material of that name is called: its name where nothing else is given.
    pub fn called<'a>(&'a self, name: &'a str, language: Language) -> &'a str {
        let place = Language::ALL.iter().position(|&known| known == language);
        // The pseudo-language has the English names.
        self.names
            .get(name)
            .map_or(name, |names| &names[place.unwrap_or_default()])
    }
}

impl Default for Material {
    /// Black.
    fn default() -> Self {
        Material {
            name: String::new(),
            ambient: Rgb::BLACK,
            diffuse: Rgb::BLACK,
            specular: Rgb::BLACK,
            shininess: 1.0,
            highlight: Highlight::Blinn,
            reflection: Rgb::BLACK,
            transmission: Rgb::BLACK,
            ior: 1.0,
            emission: Rgb::BLACK,
            reflectance: Rgb::BLACK,
            texture: None,
        }
    }
}

impl Object {
    /// An undivided object that casts shadows.
    pub fn new(name: impl Into<String>, material: usize, shape: Shape) -> Self {
        Object {
            name: name.into(),
            material,
            shape,
            patches: [1, 1],
            divisions: Object::DIVISIONS,
            casts_shadow: true,
            vertex_normals: VertexNormals::AVERAGED,
        }
    }

    /// Longitudes and latitudes of a sphere whose file does not say.
    pub const SPHERE_PATCHES: [u32; 2] = [16, 8];
    /// Of a sphere whose file does not say.
    pub const DIVISIONS: u32 = 16;
    /// The most that a file may ask for.
    pub const MOST_DIVISIONS: u32 = 512;
}

#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    Sphere {
        center: DVec3,
        radius: f64,
    },
    /// `normal` is a unit vector.
    Plane {
        point: DVec3,
        normal: DVec3,
    },
    /// Three vertices or more, counter-clockwise seen from the front.
    Polygon {
        vertices: Vec<DVec3>,
    },
    /// From `base` along the unit vector `axis`.
    Cylinder {
        base: DVec3,
        axis: DVec3,
        radius: f64,
        height: f64,
        capped: bool,
    },
    /// Bicubic patches of 4×4 control points, row by row; each is divided into `divisions`² cells where polygons are needed.
    Bezier {
        patches: Vec<[DVec3; 16]>,
        divisions: u32,
    },
    /// Already transformed to world coordinates.
    Mesh(Mesh),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    Point {
        position: DVec3,
        color: Rgb,
        /// a0, a1, a2 of f_att(d) = 1/(a0 + a1·d + a2·d²), not all zero.
        attenuation: [f64; 3],
        /// Of the ball that rays see; 0 for none.
        radius: f64,
    },
    /// `toward` is the unit direction in which the light travels.
    Directional { toward: DVec3, color: Rgb },
}

impl Texture {
    /// Changes nothing.
    pub const WHITE: Texture = Texture::Checker {
        colors: [Rgb::WHITE; 2],
        scale: 1.0,
    };

    /// The colour by which the diffuse coefficient is multiplied at (u, v).
    pub fn color_at(&self, uv: DVec2) -> Rgb {
        let Texture::Checker { colors, scale } = self;
        let cells = (uv / *scale).floor();
        // Cells may be too many for an integer to count; their parity is exact all the same.
        let is_odd = cells.x.rem_euclid(2.0) != cells.y.rem_euclid(2.0);
        colors[usize::from(is_odd)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checker_changes_at_every_multiple_of_its_scale_also_below_zero() {
        let checker = Texture::Checker {
            colors: [Rgb::WHITE, Rgb::BLACK],
            scale: 0.5,
        };
        for (u, v, expected) in [
            (0.25, 0.25, Rgb::WHITE),
            (0.75, 0.25, Rgb::BLACK),
            (0.75, 0.75, Rgb::WHITE),
            (-0.25, 0.25, Rgb::BLACK),
            (-0.25, -0.75, Rgb::BLACK),
            (-0.25, -0.25, Rgb::WHITE),
            (0.5, 0.0, Rgb::BLACK),
            (1e300, 0.0, Rgb::WHITE),
        ] {
            assert_eq!(checker.color_at(DVec2::new(u, v)), expected, "({u}, {v})");
        }
    }
}
