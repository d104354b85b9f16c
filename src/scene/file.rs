//! A scene file as it is written: keys and types only. What the values mean is for [`super::validate`].

use super::document::{Keyed, Schema, present};
use super::values::{ByName, Coefficient, Count, Number, PatchCounts, Triple};
use super::{Highlight, NormalsFrom};
use schemars::JsonSchema;
use serde::Deserialize;

/// A scene: what is drawn, and from where. Directions need no length of 1, colours are linear RGB.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "Lightwalk scene")]
pub struct SceneFile {
    /// Where the JSON Schema of this file is, for editors.
    #[serde(default, rename = "$schema", deserialize_with = "present")]
    pub described_at: Option<String>,
    /// The version of the format; a scene in a lesson need not say it.
    #[serde(default, deserialize_with = "present")]
    pub schema: Option<Schema>,
    /// The colour where a ray meets nothing; black unless given.
    #[serde(default, deserialize_with = "present")]
    pub(super) background: Option<Triple>,
    /// The light that is the same everywhere; [1, 1, 1] unless given.
    #[serde(default, deserialize_with = "present")]
    pub(super) ambient: Option<Triple>,
    /// [a0, a1, a2]: the light of a secondary ray of length d is divided by a0 + a1·d + a2·d²; [1, 0, 0] unless given.
    #[serde(default, deserialize_with = "present")]
    pub(super) path_attenuation: Option<Triple>,
    /// Needed where a picture is made.
    #[serde(default, deserialize_with = "present")]
    pub(super) camera: Option<Keyed<CameraFile>>,
    /// By names of your choice.
    pub(super) materials: ByName<Keyed<MaterialFile>>,
    pub(super) objects: Vec<Keyed<ObjectFile>>,
    /// Point lights and directional lights.
    #[serde(default)]
    pub(super) lights: Vec<Keyed<LightFile>>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CameraFile {
    /// Where the viewer is.
    pub eye: Triple,
    /// What the middle of the picture shows.
    pub target: Triple,
    /// Any direction that is not along the view.
    pub up: Triple,
    /// The whole horizontal angle: more than 0, less than 180.
    pub fov_x_degrees: Number,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MaterialFile {
    /// k_a, by which the scene's ambient light is multiplied; 0 unless given.
    #[serde(default, deserialize_with = "present")]
    pub ambient: Option<Triple>,
    /// k_d; 0 unless given.
    #[serde(default, deserialize_with = "present")]
    pub diffuse: Option<Triple>,
    /// k_s; 0 unless given.
    #[serde(default, deserialize_with = "present")]
    pub specular: Option<Coefficient>,
    /// n_s, the exponent of the highlight; 1 unless given.
    #[serde(default, deserialize_with = "present")]
    pub shininess: Option<Number>,
    /// N·H (blinn, unless given) or R·V (phong).
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<Highlight>")]
    pub highlight: Option<String>,
    /// The share of the reflected ray; 0 unless given.
    #[serde(default, deserialize_with = "present")]
    pub reflection: Option<Coefficient>,
    /// The share of the transmitted ray; 0 unless given.
    #[serde(default, deserialize_with = "present")]
    pub transmission: Option<Coefficient>,
    /// η, the index of refraction inside; 1 unless given.
    #[serde(default, deserialize_with = "present")]
    pub ior: Option<Number>,
    /// Of radiosity: the light that the surface gives off; 0 unless given.
    #[serde(default, deserialize_with = "present")]
    pub emission: Option<Triple>,
    /// Of radiosity: ρ, from 0 to 1; the smaller of `diffuse` and 1 unless given.
    #[serde(default, deserialize_with = "present")]
    pub reflectance: Option<Triple>,
    /// Multiplies `diffuse`.
    #[serde(default, deserialize_with = "present")]
    pub texture: Option<Keyed<TextureFile>>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct TextureFile {
    pub checker: Keyed<CheckerFile>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckerFile {
    /// Two colours.
    pub colors: Vec<Triple>,
    /// The side of a square, in (u, v); 1 unless given.
    #[serde(default, deserialize_with = "present")]
    pub scale: Option<Number>,
}

/// It has exactly one of the six shapes.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct ObjectFile {
    /// Unique in the scene.
    pub name: String,
    /// The name of one of the materials.
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
    /// Of radiosity: [nu, nv] cells of a quadrilateral, [longitudes, latitudes] of a sphere, n parts of each edge of triangles.
    #[serde(default, deserialize_with = "present")]
    pub patches: Option<PatchCounts>,
    /// Of a sphere, where polygons are needed: into so many parts from pole to pole; 16 unless given.
    #[serde(default, deserialize_with = "present")]
    pub divisions: Option<Count>,
    /// True unless given.
    #[serde(default, deserialize_with = "present")]
    pub casts_shadow: Option<bool>,
    /// What the scan-line methods take for the normal at a vertex; `averaged` unless given.
    #[serde(default, deserialize_with = "present")]
    #[schemars(with = "Option<NormalsFrom>")]
    pub normals: Option<String>,
    /// With averaged normals: only faces that meet at no more than this angle are averaged; 180 unless given.
    #[serde(default, deserialize_with = "present")]
    pub crease_degrees: Option<Number>,
    /// Of a mesh.
    #[serde(default, deserialize_with = "present")]
    pub transform: Option<Keyed<TransformFile>>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct SphereFile {
    pub center: Triple,
    pub radius: Number,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PlaneFile {
    pub point: Triple,
    pub normal: Triple,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PolygonFile {
    /// Three or more, in one plane, counter-clockwise seen from the front.
    pub vertices: Vec<Triple>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CylinderFile {
    /// The middle of its base.
    pub base: Triple,
    /// The direction from the base to the top.
    pub axis: Triple,
    pub radius: Number,
    pub height: Number,
    /// Whether it is closed by discs; true unless given.
    #[serde(default, deserialize_with = "present")]
    pub capped: Option<bool>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct BezierFile {
    /// Bicubic patches of 16 points each, row by row.
    pub patches: Vec<Vec<Triple>>,
    /// Into so many parts each side of a patch is divided where polygons are needed.
    pub divisions: Count,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshFile {
    /// The path of an .obj, .gltf or .glb file, relative to this file and not outside its folder.
    pub file: String,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct TransformFile {
    /// Done last.
    #[serde(default, deserialize_with = "present")]
    pub translate: Option<Triple>,
    /// About x, then y, then z.
    #[serde(default, deserialize_with = "present")]
    pub rotate_degrees: Option<Triple>,
    /// Done first.
    #[serde(default, deserialize_with = "present")]
    pub scale: Option<Number>,
}

/// Either a point light or a directional light.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LightFile {
    #[serde(default, deserialize_with = "present")]
    pub point: Option<Keyed<PointFile>>,
    #[serde(default, deserialize_with = "present")]
    pub directional: Option<Keyed<DirectionalFile>>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct PointFile {
    pub position: Triple,
    /// [1, 1, 1] unless given.
    #[serde(default, deserialize_with = "present")]
    pub color: Option<Triple>,
    /// [a0, a1, a2] of 1/(a0 + a1·d + a2·d²); [1, 0, 0] unless given.
    #[serde(default, deserialize_with = "present")]
    pub attenuation: Option<Triple>,
    /// Of the ball that rays see; 0, none, unless given.
    #[serde(default, deserialize_with = "present")]
    pub radius: Option<Number>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct DirectionalFile {
    /// The direction in which the light travels.
    pub toward: Triple,
    /// [1, 1, 1] unless given.
    #[serde(default, deserialize_with = "present")]
    pub color: Option<Triple>,
}
