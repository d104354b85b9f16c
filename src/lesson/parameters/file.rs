//! Parameters as a lesson file writes them.

use super::super::error::problem;
use super::by_path::{self, ByPath, ChoiceFile, NumberFile, Source};
use super::{Coefficient, Parameter};
use crate::scene::document::{Keyed, Problem};
use crate::scene::{Light, Movable, Object, Scene, Shape};
use schemars::JsonSchema;
use serde::Deserialize;

/// What a student may change.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum ParameterFile {
    /// The place of a point light, by its index.
    Light(usize),
    /// The place of the eye, which goes on looking at its target; that stays as large in the picture as it was.
    Eye,
    /// The place of the object of this name, which is no mesh.
    Object(String),
    /// The place of a vertex of a polygon.
    Vertex(Keyed<VertexFile>),
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

/// A vertex of an inline polygon.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VertexFile {
    /// By its name.
    pub object: String,
    /// Counted from 0, as the polygon lists them.
    pub vertex: usize,
}

impl ParameterFile {
    pub fn has_path(&self) -> bool {
        matches!(self, ParameterFile::Number(_) | ParameterFile::Choice(_))
    }
}

/// What the file names, in the scene and in the document. What is not there, or given twice, is a problem.
pub fn parameters(
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
        ParameterFile::Eye => return Ok(Parameter::Place(Movable::Eye)),
        ParameterFile::Object(name) => return object_with_a_place(name, scene),
        ParameterFile::Vertex(Keyed(file)) => return vertex(file, scene),
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
        Some(Light::Point { .. }) => Ok(Parameter::Place(Movable::Light(light))),
        Some(Light::Directional { .. }) => Err(format!(
            "found {light}, a directional light; only point lights can be moved"
        )),
        None => Err(format!(
            "found {light}; the scene has {} lights, counted from 0",
            lights.len()
        )),
    }
}

fn object(name: &str, objects: &[Object]) -> Result<usize, String> {
    let index = objects.iter().position(|object| object.name == name);
    index.ok_or_else(|| format!("found \"{name}\", which is no object of the scene"))
}

fn object_with_a_place(name: &str, scene: &Scene) -> Result<Parameter, String> {
    let moved = Movable::Object(object(name, &scene.objects)?);
    match moved.position(scene) {
        Some(_) => Ok(Parameter::Place(moved)),
        None => Err(format!(
            "found \"{name}\", a mesh; its place is the `translate` of its `transform`, a `number` by its path"
        )),
    }
}

fn vertex(file: &VertexFile, scene: &Scene) -> Result<Parameter, String> {
    let VertexFile {
        object: name,
        vertex,
    } = file;
    let object = object(name, &scene.objects)?;
    let Shape::Polygon { vertices } = &scene.objects[object].shape else {
        return Err(format!(
            "found \"{name}\", which is no polygon; only vertices of polygons can be moved"
        ));
    };
    if *vertex >= vertices.len() {
        return Err(format!(
            "found the vertex {vertex}; \"{name}\" has {}, counted from 0",
            vertices.len()
        ));
    }
    Ok(Parameter::Place(Movable::Vertex {
        object,
        vertex: *vertex,
    }))
}

fn curved_object(name: &str, objects: &[Object]) -> Result<Parameter, String> {
    let index = object(name, objects)?;
    match objects[index].shape {
        Shape::Sphere { .. } | Shape::Bezier { .. } => Ok(Parameter::Divisions(index)),
        _ => Err(format!(
            "found \"{name}\", which is no curved object; spheres and Bézier patches can be divided"
        )),
    }
}
