//! What a glTF file has that has no use here: counted, then taken out, so that nothing of it can be wrong.

use super::super::Remark;
use gltf::Semantic;
use gltf::json::Root;
use gltf::json::material::Material;
use gltf::json::validation::Checked;
use gltf::mesh::Mode;
use std::collections::BTreeSet;

/// Extensions that say nothing about the place of triangles, beside those of materials and textures.
const HARMLESS: [&str; 4] = [
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_xmp_json_ld",
    "KHR_animation_pointer",
];

/// Takes out of the file what is not read.
///
/// Errors: an extension that it needs and that is not supported, as a sentence.
pub(super) fn removed(json: &mut Root) -> Result<Vec<Remark>, String> {
    let is_harmless = |name: &String| {
        let is_about = |start: &str| name.starts_with(start);
        HARMLESS.contains(&name.as_str())
            || is_about("KHR_materials_")
            || is_about("KHR_texture_")
            || is_about("EXT_texture_")
    };
    let needed: Vec<String> = std::mem::take(&mut json.extensions_required);
    let needed: Vec<String> = needed
        .into_iter()
        .filter(|name| !is_harmless(name))
        .collect();
    if !needed.is_empty() {
        return Err(format!(
            "the file needs what is not supported: {}; export it without compression",
            needed.join(", ")
        ));
    }
    let mut remarks = Vec::new();
    let mut remark = |count: usize, [one, many]: [&str; 2], why| {
        if count > 0 {
            let things = if count == 1 { one } else { many };
            remarks.push(Remark::new(format!("{count} {things}"), why));
        }
    };
    remark(
        json.animations.len(),
        ["animation", "animations"],
        "not used: the mesh stands still",
    );
    remark(
        json.skins.len(),
        ["skin", "skins"],
        "not used: the mesh is taken as modelled",
    );
    remark(
        json.images.len(),
        ["image", "images"],
        "not used: textures come from the scene file",
    );
    remark(
        json.cameras.len(),
        ["camera", "cameras"],
        "not used: the scene file has the camera",
    );
    remark(
        json.scenes.len().saturating_sub(1),
        ["scene more", "scenes more"],
        "not used: the default scene is read",
    );
    let mut primitives = (0, 0, BTreeSet::new());
    for primitive in json.meshes.iter_mut().flat_map(|mesh| &mut mesh.primitives) {
        let (lines, targets, attributes) = &mut primitives;
        let is_line = matches!(
            primitive.mode,
            Checked::Valid(Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip)
        );
        *lines += usize::from(is_line);
        *targets += primitive.targets.take().map_or(0, |targets| targets.len());
        primitive.material = None;
        primitive.attributes.retain(|semantic, _| match semantic {
            Checked::Valid(Semantic::Positions | Semantic::Normals | Semantic::TexCoords(0)) => {
                true
            }
            Checked::Valid(other) => {
                attributes.insert(other.to_string());
                false
            }
            Checked::Invalid => {
                attributes.insert("attributes of other names".into());
                false
            }
        });
    }
    let (lines, targets, attributes) = primitives;
    remark(
        lines,
        ["list of points or lines", "lists of points or lines"],
        "only triangles are drawn",
    );
    remark(
        targets,
        ["morph target", "morph targets"],
        "not used: the mesh is taken as modelled",
    );
    let list = |names: &mut dyn Iterator<Item = String>| names.collect::<Vec<_>>().join(", ");
    if !attributes.is_empty() {
        let what = list(&mut attributes.into_iter());
        remarks.push(Remark::new(
            what,
            "not used: positions, normals and TEXCOORD_0 are",
        ));
    }
    if !json.materials.is_empty() {
        const SHOWN: usize = 4;
        let shown = json
            .materials
            .iter()
            .take(SHOWN)
            .enumerate()
            .map(base_color);
        let more = json.materials.len().saturating_sub(SHOWN);
        let more = (more > 0).then(|| format!("{more} more"));
        let what = list(&mut shown.chain(more));
        let why = "not used: an object takes its material from the scene file";
        remarks.push(Remark::new(format!("materials ({what})"), why));
    }
    if !json.extensions_used.is_empty() {
        let what = list(&mut std::mem::take(&mut json.extensions_used).into_iter());
        remarks.push(Remark::new(format!("extensions ({what})"), "not used"));
    }
    json.animations.clear();
    json.skins.clear();
    json.cameras.clear();
    json.materials.clear();
    json.textures.clear();
    json.samplers.clear();
    json.images.clear();
    for node in &mut json.nodes {
        (node.skin, node.camera) = (None, None);
    }
    Ok(remarks)
}

/// What a material is called, and its base colour, so that a scene can say the same.
fn base_color((number, material): (usize, &Material)) -> String {
    let name = match &material.name {
        Some(name) => format!("{name:?}"),
        None => number.to_string(),
    };
    let [red, green, blue, _] = material.pbr_metallic_roughness.base_color_factor.0;
    format!("{name} of base colour [{red}, {green}, {blue}]")
}
