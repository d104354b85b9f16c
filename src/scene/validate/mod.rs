//! From a scene as it is written to a scene that is right: ranges, names and references, all problems in one go.

mod appearance;
mod objects;
mod rules;
mod shapes;

use super::document::{self, Keyed, Place, Problem};
use super::file::SceneFile;
use super::locate::locate;
use super::values::Triple;
use super::{Material, Scene};
use crate::color::Rgb;
use objects::Objects;
use rules::Check;

pub use rules::LARGEST;
pub(super) use rules::unit;
pub(super) use shapes::check_polygon;

/// How large a scene may be. Both hold for the whole scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Radiosity patches that the scene's keys `patches` ask for (`--max-patches`).
    pub max_patches: u64,
    /// Triangles of meshes and divided Bézier patches (`--max-triangles`); never more than 2³⁰, which indices can count.
    pub max_triangles: u64,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            max_patches: 100_000,
            max_triangles: 5_000_000,
        }
    }
}

/// Why a scene was refused. Displayed as one problem a line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", document::one_a_line(.problems))]
pub struct SceneError {
    /// One or more. Of more than a thousand, the first ones, and a last one that says how many more there are.
    pub problems: Vec<Problem>,
}

/// Gives the bytes of the mesh file that a scene names, by the path as it is written there, or says why not.
pub type ReadFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, String> + 'a;

/// Reads a scene file.
///
/// Errors: the first problem of syntax, keys or types, with line and column; or else all problems of values and references.
pub fn read(bytes: &[u8], limits: &Limits, read_file: &mut ReadFile) -> Result<Scene, SceneError> {
    let file: SceneFile = document::parse(bytes).map_err(|problem| SceneError {
        problems: vec![problem],
    })?;
    file.check(limits, read_file, "").map_err(|mut error| {
        locate(bytes, &mut error.problems);
        error
    })
}

impl SceneFile {
    /// The scene that is meant, its colours, lengths and indices known to be right.
    ///
    /// `place` is the path of this scene in its document: empty for a scene file, such as `scene` where a lesson holds it.
    ///
    /// Errors: all problems of values and references.
    pub fn check(
        self,
        limits: &Limits,
        read_file: &mut ReadFile,
        place: &str,
    ) -> Result<Scene, SceneError> {
        let mut check = Check::default();
        let root = &Place::Root(place);
        let camera = self
            .camera
            .and_then(|Keyed(camera)| check.camera(&root.key("camera"), &camera));
        let materials: Vec<Material> = self
            .materials
            .0
            .into_iter()
            .map(|(name, Keyed(material))| {
                check.material(&root.key("materials").key(&name), name.clone(), material)
            })
            .collect();
        let objects =
            Objects::new(&mut check, &materials, limits, read_file).all(root, self.objects);
        if check.count == 0 {
            check.textures(root, &objects, &materials);
        }
        let lights = self
            .lights
            .iter()
            .enumerate()
            .filter_map(|(i, Keyed(light))| check.light(&root.key("lights").index(i), light))
            .collect();
        let mut color = |key, written: Option<Triple>, default| {
            written.map_or(default, |written| check.color(&root.key(key), written))
        };
        let background = color("background", self.background, Rgb::BLACK);
        let ambient = color("ambient", self.ambient, Rgb::WHITE);
        let path_attenuation =
            check.attenuation(&root.key("path_attenuation"), self.path_attenuation);
        if check.count > 0 {
            return Err(SceneError {
                problems: check.placed(root),
            });
        }
        Ok(Scene {
            background,
            ambient,
            path_attenuation,
            camera,
            materials,
            objects,
            lights,
            notes: check.notes,
            names: Default::default(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Highlight, Light, Shape, Texture};
    use glam::DVec3;

    /// The example of the format's description, with every shape and every key.
    const FULL: &str = r#"
{ "schema": 1,
  "background": [0.2, 0.3, 0.5],
  "path_attenuation": [1, 0.5, 0.25],
  "camera": { "eye": [0, 1.5, -6], "target": [0, 0.7, 0], "up": [0, 2, 0], "fov_x_degrees": 40 },
  "materials": {
    "red": { "ambient": [0.08, 0.02, 0.02], "diffuse": [0.48, 0.12, 0.12],
             "specular": [0.5, 0.25, 0.125], "shininess": 40, "highlight": "phong",
             "reflection": 0.5, "transmission": [0, 0, 0], "ior": 1.5,
             "emission": [0, 0, 7], "reflectance": [0.8, 0.2, 0.2],
             "texture": { "checker": { "colors": [[1, 1, 1], [0.2, 0.2, 0.2]], "scale": 2 } } },
    "bright": { "diffuse": [0.5, 1, 3] } },
  "objects": [
    { "name": "ball", "material": "red", "sphere": { "center": [-1.3, 0.8, 0.5], "radius": 0.8 } },
    { "name": "floor", "material": "bright", "plane": { "point": [0, 0, 0], "normal": [0, 3, 0] } },
    { "name": "wall", "material": "red", "polygon": { "vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }, "patches": [8, 4] },
    { "name": "door", "material": "red", "polygon": { "vertices": [[0,0,0],[1,0,0],[1,1,0.2],[0,1,0]] }, "patches": 3 },
    { "name": "pot", "material": "red", "mesh": { "file": "meshes/pot.obj" }, "casts_shadow": false, "patches": 2,
      "transform": { "translate": [10, 0, 0], "rotate_degrees": [90, 0, 90], "scale": 2 } },
    { "name": "can", "material": "red", "cylinder": { "base": [0,0,0], "axis": [0,0,-4], "radius": 1, "height": 2, "capped": false } },
    { "name": "sheet", "material": "red", "bezier": { "divisions": 4, "patches": [[
        [0,0,0],[1,0,0],[2,0,0],[3,0,0], [0,1,0],[1,1,1],[2,1,1],[3,1,0],
        [0,2,0],[1,2,1],[2,2,1],[3,2,0], [0,3,0],[1,3,0],[2,3,0],[3,3,0]]] } } ],
  "lights": [
    { "point": { "position": [4, 6, -5], "color": [1, 0.5, 1], "attenuation": [0, 0, 1], "radius": 0.25 } },
    { "point": { "position": [0, 0, 0] } },
    { "directional": { "toward": [0, -2, 0] } } ] }"#;

    fn pot(path: &str) -> Result<Vec<u8>, String> {
        assert_eq!(path, "meshes/pot.obj");
        Ok(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec())
    }

    fn full() -> Scene {
        read(FULL.as_bytes(), &Limits::default(), &mut pot).unwrap()
    }

    #[test]
    fn values_are_taken_as_written() {
        let scene = full();
        assert_eq!(scene.background, Rgb::new(0.2, 0.3, 0.5));
        assert_eq!(scene.path_attenuation, [1.0, 0.5, 0.25]);
        let camera = scene.camera.unwrap();
        assert_eq!(camera.eye, DVec3::new(0.0, 1.5, -6.0));
        assert_eq!(camera.up, DVec3::Y);
        assert_eq!(camera.fov_x, 40_f64.to_radians());
        let red = &scene.materials[0];
        assert_eq!(red.specular, Rgb::new(0.5, 0.25, 0.125));
        assert_eq!(red.reflection, Rgb::splat(0.5));
        assert_eq!((red.shininess, red.ior), (40.0, 1.5));
        assert_eq!(red.highlight, Highlight::Phong);
        assert_eq!(red.emission, Rgb::new(0.0, 0.0, 7.0));
        assert_eq!(red.reflectance, Rgb::new(0.8, 0.2, 0.2));
        let Some(Texture::Checker { colors, scale }) = red.texture else {
            panic!("no texture");
        };
        assert_eq!((colors[1], scale), (Rgb::splat(0.2), 2.0));
        assert_eq!(
            scene.lights[0],
            Light::Point {
                position: DVec3::new(4.0, 6.0, -5.0),
                color: Rgb::new(1.0, 0.5, 1.0),
                attenuation: [0.0, 0.0, 1.0],
                radius: 0.25
            }
        );
    }

    #[test]
    fn what_is_left_out_has_its_default() {
        let scene = full();
        assert_eq!(scene.ambient, Rgb::WHITE);
        let bright = &scene.materials[1];
        assert_eq!(bright.reflectance, Rgb::new(0.5, 1.0, 1.0));
        assert_eq!((bright.ambient, bright.specular), (Rgb::BLACK, Rgb::BLACK));
        assert_eq!((bright.shininess, bright.ior), (1.0, 1.0));
        assert_eq!(bright.highlight, Highlight::Blinn);
        assert_eq!(bright.texture, None);
        assert_eq!(
            scene.lights[1..],
            [
                Light::Point {
                    position: DVec3::ZERO,
                    color: Rgb::WHITE,
                    attenuation: [1.0, 0.0, 0.0],
                    radius: 0.0
                },
                Light::Directional {
                    toward: DVec3::NEG_Y,
                    color: Rgb::WHITE
                }
            ]
        );
        let empty = br#"{"schema": 1, "materials": {}, "objects": []}"#;
        let scene = read(empty, &Limits::default(), &mut pot).unwrap();
        assert_eq!((scene.camera, scene.background), (None, Rgb::BLACK));
        assert_eq!(scene.path_attenuation, [1.0, 0.0, 0.0]);
    }

    #[test]
    fn objects_have_their_shape_patches_and_shadow() {
        let scene = full();
        let patches: Vec<[u32; 2]> = scene.objects.iter().map(|object| object.patches).collect();
        assert_eq!(
            patches,
            [[16, 8], [1, 1], [8, 4], [3, 3], [2, 2], [1, 1], [1, 1]]
        );
        let shadows: Vec<bool> = scene.objects.iter().map(|o| o.casts_shadow).collect();
        assert_eq!(shadows, [true, true, true, true, false, true, true]);
        assert_eq!(scene.objects[1].material, 1);
        assert!(matches!(
            scene.objects[1].shape,
            Shape::Plane {
                normal: DVec3::Y,
                ..
            }
        ));
        assert!(matches!(
            scene.objects[5].shape,
            Shape::Cylinder {
                axis: DVec3::NEG_Z,
                capped: false,
                ..
            }
        ));
        assert!(matches!(
            &scene.objects[6].shape,
            Shape::Bezier { divisions: 4, patches } if patches[0][5] == DVec3::ONE
        ));
    }

    #[test]
    fn a_mesh_is_scaled_then_turned_about_x_y_z_then_moved() {
        let scene = full();
        let Shape::Mesh(mesh) = &scene.objects[4].shape else {
            panic!("no mesh");
        };
        // (1, 0, 0): scaled (2, 0, 0), about x the same, about z (0, 2, 0).
        // (0, 1, 0): scaled (0, 2, 0), about x (0, 0, 2), about z the same.
        for (vertex, expected) in [[10.0, 0.0, 0.0], [10.0, 2.0, 0.0], [10.0, 0.0, 2.0]]
            .into_iter()
            .enumerate()
        {
            let expected = DVec3::from(expected);
            assert!(mesh.position(vertex as u32).distance(expected) < 1e-14);
        }
    }

    #[test]
    fn places_start_where_the_scene_stands() {
        let text = FULL.replace("\"material\": \"bright\"", "\"material\": \"pale\"");
        let file: SceneFile = document::parse(text.as_bytes()).unwrap();
        let error = file
            .check(&Limits::default(), &mut pot, "scene")
            .unwrap_err();
        assert_eq!(
            error.to_string(),
            "scene.objects[1].material: found \"pale\", which is no material of this scene; it has \"red\", \"bright\""
        );
    }
}
