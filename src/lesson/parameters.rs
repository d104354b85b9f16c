//! What a student may change in a lesson, and what a change does to its scene.

mod by_path;

pub use by_path::{ByPath, Kind, PathValue, Source};

use super::error::problem;
use super::resolve::Lesson;
use crate::methods::Settings;
use crate::scene::document::{Keyed, Problem};
use crate::scene::{LARGEST, Light, Material, Object, Scene, Shape};
use by_path::{ChoiceFile, NumberFile};
use glam::DVec3;
use schemars::JsonSchema;
use serde::Deserialize;

/// How finely a curved object may be divided.
pub const DIVISIONS: std::ops::RangeInclusive<u32> = 2..=64;

/// What a student may change.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum ParameterFile {
    /// The place of a point light, by its index.
    Light(usize),
    /// The place of the eye, which goes on looking at its target; that stays as large in the picture as it was.
    Eye,
    /// A coefficient of the material of this name.
    Ambient(String),
    Diffuse(String),
    Specular(String),
    Shininess(String),
    /// Into how many parts the curved object of this name is divided.
    Divisions(String),
    /// A number that the lesson gives at a path.
    Number(Keyed<NumberFile>),
    /// One of several values at a path.
    Choice(Keyed<ChoiceFile>),
}

impl ParameterFile {
    pub(super) fn has_path(&self) -> bool {
        matches!(self, ParameterFile::Number(_) | ParameterFile::Choice(_))
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coefficient {
    Ambient,
    Diffuse,
    Specular,
    Shininess,
}

impl Coefficient {
    /// As in the formulas.
    pub fn symbol(self) -> &'static str {
        match self {
            Coefficient::Ambient => "k_a",
            Coefficient::Diffuse => "k_d",
            Coefficient::Specular => "k_s",
            Coefficient::Shininess => "n_s",
        }
    }
}

/// Something that may be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// A point light, by its index.
    Light(usize),
    Eye,
    /// Of a material, by its index.
    Coefficient(usize, Coefficient),
    /// Of an object, by its index.
    Divisions(usize),
    /// At a path of the document, by its index among the lesson's.
    ByPath(usize),
}

/// A value for a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    Light {
        light: usize,
        position: DVec3,
    },
    Eye {
        position: DVec3,
    },
    /// The largest channel of the coefficient; the others keep their ratio to it.
    Coefficient {
        material: usize,
        coefficient: Coefficient,
        value: f64,
    },
    Divisions {
        object: usize,
        divisions: u32,
    },
    ByPath {
        parameter: usize,
        value: PathValue,
    },
}

/// Why a value cannot be had.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NotAllowed {
    TooFar,
    /// The eye would look along the camera's up, or stand at its target.
    NoView,
    OutOfRange,
    /// What a file with this value would be refused for.
    Refused(String),
}

impl Parameter {
    /// The change that would make the scene what it is; none for what is not of the scene.
    fn value(self, scene: &Scene) -> Option<Change> {
        Some(match self {
            Parameter::Light(light) => match *scene.lights.get(light)? {
                Light::Point { position, .. } => Change::Light { light, position },
                Light::Directional { .. } => return None,
            },
            Parameter::Eye => Change::Eye {
                position: scene.camera?.eye,
            },
            Parameter::Coefficient(material, coefficient) => Change::Coefficient {
                material,
                coefficient,
                value: largest_channel(scene.materials.get(material)?, coefficient),
            },
            Parameter::ByPath(_) => return None,
            Parameter::Divisions(object) => {
                let of = scene.objects.get(object)?;
                Change::Divisions {
                    object,
                    divisions: match of.shape {
                        Shape::Bezier { divisions, .. } => divisions,
                        _ => of.divisions,
                    },
                }
            }
        })
    }
}

impl Change {
    pub fn parameter(self) -> Parameter {
        match self {
            Change::Light { light, .. } => Parameter::Light(light),
            Change::Eye { .. } => Parameter::Eye,
            Change::Coefficient {
                material,
                coefficient,
                ..
            } => Parameter::Coefficient(material, coefficient),
            Change::Divisions { object, .. } => Parameter::Divisions(object),
            Change::ByPath { parameter, .. } => Parameter::ByPath(parameter),
        }
    }

    /// Makes the change in `scene`, which was `opened` before any change. Errors: nothing has changed then.
    fn make(self, scene: &mut Scene, opened: &Scene) -> Result<(), NotAllowed> {
        match self {
            // The scene is read with it.
            Change::ByPath { .. } => {}
            Change::Light { light, position } => {
                check_place(position)?;
                if let Some(Light::Point { position: at, .. }) = scene.lights.get_mut(light) {
                    *at = position;
                }
            }
            Change::Eye { position } => {
                check_place(position)?;
                if let Some(camera) = &mut scene.camera {
                    let forward = (camera.target - position).try_normalize();
                    let up = camera.up.normalize_or_zero();
                    let aside = forward.map_or(0.0, |forward| forward.cross(up).length());
                    if aside < 1e-6 {
                        return Err(NotAllowed::NoView);
                    }
                    // What the eye looks at stays as large in the picture as it was.
                    if let Some(opened) = &opened.camera {
                        let width = opened.eye.distance(opened.target) * (0.5 * opened.fov_x).tan();
                        let distance = position.distance(camera.target);
                        camera.fov_x = 2.0 * (width / distance).atan();
                    }
                    camera.eye = position;
                }
            }
            Change::Coefficient {
                material,
                coefficient,
                value,
            } => {
                if !(0.0..=LARGEST).contains(&value) {
                    return Err(NotAllowed::OutOfRange);
                }
                let all = (scene.materials.get_mut(material)).zip(opened.materials.get(material));
                if let Some((material, opened)) = all {
                    set_coefficient(material, opened, coefficient, value);
                }
            }
            Change::Divisions { object, divisions } => {
                if !DIVISIONS.contains(&divisions) {
                    return Err(NotAllowed::OutOfRange);
                }
                match scene.objects.get_mut(object) {
                    Some(Object {
                        shape: Shape::Bezier { divisions: of, .. },
                        ..
                    }) => *of = divisions,
                    Some(object) => object.divisions = divisions,
                    None => {}
                }
            }
        }
        Ok(())
    }
}

impl Lesson {
    /// The value that a parameter has after the changes.
    pub fn value(&self, parameter: Parameter, changes: &[Change]) -> Option<Change> {
        let mut changes = changes.iter().copied();
        let changed = changes.rfind(|change| change.parameter() == parameter);
        changed.or_else(|| match parameter {
            Parameter::ByPath(parameter) => Some(Change::ByPath {
                parameter,
                value: self.by_path.get(parameter)?.value,
            }),
            _ => parameter.value(&self.scene),
        })
    }

    /// Scene and settings after the changes, of which there is at most one a parameter. Errors: why a value cannot be had.
    pub fn changed(&self, changes: &[Change]) -> Result<(Scene, Settings), NotAllowed> {
        let by_path = changes.iter().filter_map(|change| match *change {
            Change::ByPath { parameter, value } => Some((self.by_path.get(parameter)?, value)),
            _ => None,
        });
        let mut by_path = by_path.peekable();
        let source = self.source.as_ref().filter(|_| by_path.peek().is_some());
        let (opened, settings) = match source {
            None => (self.scene.clone(), self.settings.clone()),
            Some(source) => {
                let read = source.with(by_path);
                let read = read.map_err(|error| NotAllowed::Refused(error.to_string()))?;
                (read.scene, read.settings)
            }
        };
        let mut scene = opened.clone();
        for change in changes {
            change.make(&mut scene, &opened)?;
        }
        Ok((scene, settings))
    }
}

fn check_place(position: DVec3) -> Result<(), NotAllowed> {
    // Not a number is not allowed either.
    let near = position.to_array().iter().all(|x| x.abs() <= LARGEST);
    near.then_some(()).ok_or(NotAllowed::TooFar)
}

fn largest_channel(material: &Material, coefficient: Coefficient) -> f64 {
    match coefficient {
        Coefficient::Ambient => material.ambient.max_channel(),
        Coefficient::Diffuse => material.diffuse.max_channel(),
        Coefficient::Specular => material.specular.max_channel(),
        Coefficient::Shininess => material.shininess,
    }
}

/// The hue is that of the material as it was opened, so that it comes back from 0.
fn set_coefficient(
    material: &mut Material,
    opened: &Material,
    coefficient: Coefficient,
    value: f64,
) {
    let (color, opened) = match coefficient {
        Coefficient::Ambient => (&mut material.ambient, opened.ambient),
        Coefficient::Diffuse => (&mut material.diffuse, opened.diffuse),
        Coefficient::Specular => (&mut material.specular, opened.specular),
        Coefficient::Shininess => {
            material.shininess = value;
            return;
        }
    };
    let largest = opened.max_channel();
    *color = if value == largest {
        opened
    } else if largest > 0.0 {
        opened * (value / largest)
    } else {
        crate::color::Rgb::splat(value)
    };
}

/// What the file names, in the scene and in the document. What is not there, or given twice, is a problem.
pub(super) fn parameters(
    files: &[ParameterFile],
    scene: &Scene,
    source: Option<&Source>,
    problems: &mut Vec<Problem>,
) -> (Vec<Parameter>, Vec<ByPath>) {
    let (mut parameters, mut by_path) = (Vec::new(), Vec::new());
    for (index, file) in files.iter().enumerate() {
        let found = match (file, source) {
            (ParameterFile::Number(Keyed(file)), Some(source)) => {
                Some(by_path::number(file, source))
            }
            (ParameterFile::Choice(Keyed(file)), Some(source)) => {
                Some(by_path::choice(file, source))
            }
            _ => None,
        };
        let found = match found {
            Some(found) => found.map(|found| {
                by_path.push(found);
                Parameter::ByPath(by_path.len() - 1)
            }),
            None => find(file, scene),
        };
        let parameter = found.and_then(|parameter| {
            let new = !parameters.contains(&parameter);
            new.then_some(parameter)
                .ok_or_else(|| "found a parameter that stands in the list already".into())
        });
        match parameter {
            Ok(parameter) => parameters.push(parameter),
            Err(message) => problems.push(problem(format!("parameters[{index}]"), message)),
        }
    }
    (parameters, by_path)
}

fn find(file: &ParameterFile, scene: &Scene) -> Result<Parameter, String> {
    let (name, coefficient) = match file {
        &ParameterFile::Light(light) => return point_light(light, &scene.lights),
        ParameterFile::Eye => return Ok(Parameter::Eye),
        ParameterFile::Divisions(name) => return curved_object(name, &scene.objects),
        ParameterFile::Ambient(name) => (name, Coefficient::Ambient),
        ParameterFile::Diffuse(name) => (name, Coefficient::Diffuse),
        ParameterFile::Specular(name) => (name, Coefficient::Specular),
        ParameterFile::Shininess(name) => (name, Coefficient::Shininess),
        ParameterFile::Number(_) | ParameterFile::Choice(_) => {
            return Err("the lesson is no document whose values have paths".into());
        }
    };
    let mut materials = scene.materials.iter();
    let material = materials.position(|material| material.name == *name);
    material
        .map(|material| Parameter::Coefficient(material, coefficient))
        .ok_or_else(|| {
            let known = scene.materials.iter().map(|material| &*material.name);
            format!(
                "found \"{name}\", which is no material of the scene; it has {}",
                known.collect::<Vec<_>>().join(", ")
            )
        })
}

fn point_light(light: usize, lights: &[Light]) -> Result<Parameter, String> {
    match lights.get(light) {
        Some(Light::Point { .. }) => Ok(Parameter::Light(light)),
        Some(Light::Directional { .. }) => Err(format!(
            "found {light}, a directional light; only point lights can be moved"
        )),
        None => Err(format!(
            "found {light}; the scene has {} lights, counted from 0",
            lights.len()
        )),
    }
}

fn curved_object(name: &str, objects: &[Object]) -> Result<Parameter, String> {
    let index = objects.iter().position(|object| object.name == name);
    let index =
        index.ok_or_else(|| format!("found \"{name}\", which is no object of the scene"))?;
    match objects[index].shape {
        Shape::Sphere { .. } | Shape::Bezier { .. } => Ok(Parameter::Divisions(index)),
        _ => Err(format!(
            "found \"{name}\", which is no curved object; spheres and Bézier patches can be divided"
        )),
    }
}
