//! What a student may change in a lesson, and what a change does to its scene.

mod by_path;
mod file;

pub use by_path::{ByPath, Kind, PathValue, Source};
pub use file::ParameterFile;
pub(super) use file::parameters;

use crate::scene::{LARGEST, Material, Movable, NoRoom, Object, Scene, Shape};
use glam::DVec3;

/// How finely a curved object may be divided.
pub const DIVISIONS: std::ops::RangeInclusive<u32> = 2..=64;

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
    /// The place of something.
    Place(Movable),
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
    Place {
        of: Movable,
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
    NoRoom(NoRoom),
    OutOfRange,
    /// What a file with this value would be refused for.
    Refused(String),
}

impl Parameter {
    /// The change that would make the scene what it is; none for what is not of the scene.
    pub(super) fn value(self, scene: &Scene) -> Option<Change> {
        Some(match self {
            Parameter::Place(of) => Change::Place {
                of,
                position: of.position(scene)?,
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
            Change::Place { of, .. } => Parameter::Place(of),
            Change::Coefficient {
                material,
                coefficient,
                ..
            } => Parameter::Coefficient(material, coefficient),
            Change::Divisions { object, .. } => Parameter::Divisions(object),
            Change::ByPath { parameter, .. } => Parameter::ByPath(parameter),
        }
    }

    /// Its value, as [`super::Lesson::change`] takes it.
    pub fn numbers(self) -> Vec<f64> {
        match self {
            Change::Place { position, .. } => position.to_array().to_vec(),
            Change::Coefficient { value, .. } => vec![value],
            Change::Divisions { divisions, .. } => vec![divisions.into()],
            Change::ByPath { value, .. } => vec![match value {
                PathValue::Number(number) => number,
                PathValue::Option(option) => option as f64,
            }],
        }
    }

    /// Makes the change in `scene`, which was `opened` before any change. Errors: nothing has changed then.
    pub(super) fn make(self, scene: &mut Scene, opened: &Scene) -> Result<(), NotAllowed> {
        match self {
            // The scene is read with it.
            Change::ByPath { .. } => {}
            Change::Place { of, position } => {
                of.put(scene, opened, position)
                    .map_err(NotAllowed::NoRoom)?;
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
