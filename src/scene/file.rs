//! A scene file as it is written: keys and types only. What the values mean is for [`super::validate`].

use super::document::{Keyed, Schema, present};
use super::values::{ByName, Coefficient, Count, Number, PatchCounts, Triple};
use serde::Deserialize;

/// A scene as written, also as a part of another document. See [`SceneFile::check`].
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// Required in a scene file, optional where the scene is part of another document.
    #[serde(default, deserialize_with = "present")]
    pub schema: Option<Schema>,
    #[serde(default, deserialize_with = "present")]
    pub(super) background: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub(super) ambient: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub(super) path_attenuation: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub(super) camera: Option<Keyed<CameraFile>>,
    pub(super) materials: ByName<Keyed<MaterialFile>>,
    pub(super) objects: Vec<Keyed<ObjectFile>>,
    #[serde(default)]
    pub(super) lights: Vec<Keyed<LightFile>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraFile {
    pub eye: Triple,
    pub target: Triple,
    pub up: Triple,
    pub fov_x_degrees: Number,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialFile {
    #[serde(default, deserialize_with = "present")]
    pub ambient: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub diffuse: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub specular: Option<Coefficient>,
    #[serde(default, deserialize_with = "present")]
    pub shininess: Option<Number>,
    #[serde(default, deserialize_with = "present")]
    pub highlight: Option<String>,
    #[serde(default, deserialize_with = "present")]
    pub reflection: Option<Coefficient>,
    #[serde(default, deserialize_with = "present")]
    pub transmission: Option<Coefficient>,
    #[serde(default, deserialize_with = "present")]
    pub ior: Option<Number>,
    #[serde(default, deserialize_with = "present")]
    pub emission: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub reflectance: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub texture: Option<Keyed<TextureFile>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TextureFile {
    pub checker: Keyed<CheckerFile>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckerFile {
    pub colors: Vec<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub scale: Option<Number>,
}

/// One shape of the six is there, once the object was checked.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectFile {
    pub name: String,
    pub material: String,
    #[serde(default, deserialize_with = "present")]
    pub sphere: Option<Keyed<SphereFile>>,
    #[serde(default, deserialize_with = "present")]
    pub plane: Option<Keyed<PlaneFile>>,
    #[serde(default, deserialize_with = "present")]
    pub polygon: Option<Keyed<PolygonFile>>,
    #[serde(default, deserialize_with = "present")]
    pub cylinder: Option<Keyed<CylinderFile>>,
    #[serde(default, deserialize_with = "present")]
    pub bezier: Option<Keyed<BezierFile>>,
    #[serde(default, deserialize_with = "present")]
    pub mesh: Option<Keyed<MeshFile>>,
    #[serde(default, deserialize_with = "present")]
    pub patches: Option<PatchCounts>,
    #[serde(default, deserialize_with = "present")]
    pub divisions: Option<Count>,
    #[serde(default, deserialize_with = "present")]
    pub casts_shadow: Option<bool>,
    #[serde(default, deserialize_with = "present")]
    pub normals: Option<String>,
    #[serde(default, deserialize_with = "present")]
    pub crease_degrees: Option<Number>,
    #[serde(default, deserialize_with = "present")]
    pub transform: Option<Keyed<TransformFile>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SphereFile {
    pub center: Triple,
    pub radius: Number,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PlaneFile {
    pub point: Triple,
    pub normal: Triple,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PolygonFile {
    pub vertices: Vec<Triple>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CylinderFile {
    pub base: Triple,
    pub axis: Triple,
    pub radius: Number,
    pub height: Number,
    #[serde(default, deserialize_with = "present")]
    pub capped: Option<bool>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BezierFile {
    pub patches: Vec<Vec<Triple>>,
    pub divisions: Count,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshFile {
    pub file: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct TransformFile {
    #[serde(default, deserialize_with = "present")]
    pub translate: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub rotate_degrees: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub scale: Option<Number>,
}

/// One of the two is there, once the light was checked.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LightFile {
    #[serde(default, deserialize_with = "present")]
    pub point: Option<Keyed<PointFile>>,
    #[serde(default, deserialize_with = "present")]
    pub directional: Option<Keyed<DirectionalFile>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PointFile {
    pub position: Triple,
    #[serde(default, deserialize_with = "present")]
    pub color: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub attenuation: Option<Triple>,
    #[serde(default, deserialize_with = "present")]
    pub radius: Option<Number>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DirectionalFile {
    pub toward: Triple,
    #[serde(default, deserialize_with = "present")]
    pub color: Option<Triple>,
}
