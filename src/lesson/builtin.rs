//! The lessons that come with the program, embedded in the binary with their scenes and meshes.

use super::{Lesson, LessonError};
use crate::scene::Limits;

/// A lesson of the program's own.
#[derive(Clone, Copy, Debug)]
pub struct Builtin {
    pub id: &'static str,
    json: &'static str,
}

/// By their ids, in the order of their numbers.
const BUILTINS: &[Builtin] = &[
    lesson(
        "illumination-model",
        include_str!("../../lessons/01-illumination-model.json"),
    ),
    lesson("distance", include_str!("../../lessons/02-distance.json")),
    lesson(
        "flat-shading",
        include_str!("../../lessons/03-flat-shading.json"),
    ),
    lesson(
        "gouraud-triangle",
        include_str!("../../lessons/04-gouraud-triangle.json"),
    ),
    lesson(
        "gouraud-teapot",
        include_str!("../../lessons/05-gouraud-teapot.json"),
    ),
    lesson(
        "mach-bands",
        include_str!("../../lessons/06-mach-bands.json"),
    ),
    lesson(
        "incremental-drift",
        include_str!("../../lessons/07-incremental-drift.json"),
    ),
    lesson(
        "phong-highlight",
        include_str!("../../lessons/08-phong-highlight.json"),
    ),
    lesson(
        "fast-phong",
        include_str!("../../lessons/09-fast-phong.json"),
    ),
    lesson(
        "side-by-side",
        include_str!("../../lessons/10-side-by-side.json"),
    ),
    lesson(
        "ray-casting",
        include_str!("../../lessons/11-ray-casting.json"),
    ),
    lesson("shadows", include_str!("../../lessons/12-shadows.json")),
    lesson(
        "reflection",
        include_str!("../../lessons/13-reflection.json"),
    ),
    lesson(
        "refraction",
        include_str!("../../lessons/14-refraction.json"),
    ),
    lesson("ray-tree", include_str!("../../lessons/15-ray-tree.json")),
    lesson(
        "depth-attenuation",
        include_str!("../../lessons/16-depth-attenuation.json"),
    ),
    lesson(
        "texture-transparency",
        include_str!("../../lessons/17-texture-transparency.json"),
    ),
    lesson(
        "form-factors",
        include_str!("../../lessons/18-form-factors.json"),
    ),
    lesson(
        "assumptions",
        include_str!("../../lessons/19-assumptions.json"),
    ),
    lesson(
        "linear-system",
        include_str!("../../lessons/20-linear-system.json"),
    ),
    lesson("gathering", include_str!("../../lessons/21-gathering.json")),
    lesson("shooting", include_str!("../../lessons/22-shooting.json")),
    lesson(
        "color-bleeding",
        include_str!("../../lessons/23-color-bleeding.json"),
    ),
    lesson(
        "cornell-box",
        include_str!("../../lessons/24-cornell-box.json"),
    ),
    lesson(
        "stiff-room",
        include_str!("../../lessons/25-stiff-room.json"),
    ),
    lesson(
        "error-against-time",
        include_str!("../../lessons/26-error-against-time.json"),
    ),
    lesson("needs", include_str!("../../lessons/27-needs.json")),
    lesson("extremes", include_str!("../../lessons/28-extremes.json")),
];

/// What those lessons name, by its path relative to them.
const FILES: &[(&str, &[u8])] = &[
    (
        "meshes/teapot.obj",
        include_bytes!("../../lessons/meshes/teapot.obj"),
    ),
    (
        "meshes/prism.obj",
        include_bytes!("../../lessons/meshes/prism.obj"),
    ),
    (
        "scenes/open-scene.json",
        include_bytes!("../../lessons/scenes/open-scene.json"),
    ),
    (
        "scenes/cornell-box.json",
        include_bytes!("../../lessons/scenes/cornell-box.json"),
    ),
];

const fn lesson(id: &'static str, json: &'static str) -> Builtin {
    Builtin { id, json }
}

/// All of them, in the order of their numbers.
pub fn builtins() -> &'static [Builtin] {
    BUILTINS
}

/// The lesson of this id.
pub fn builtin(id: &str) -> Option<Builtin> {
    BUILTINS.iter().copied().find(|lesson| lesson.id == id)
}

impl Builtin {
    /// Errors: none for a lesson that passed the tests.
    pub fn read(self) -> Result<Lesson, LessonError> {
        Lesson::read(self.json.as_bytes(), &Limits::default(), &mut |path| {
            let file = FILES.iter().find(|(name, _)| *name == path);
            file.map(|(_, bytes)| bytes.to_vec())
                .ok_or_else(|| format!("{path} is not among the files of the program"))
        })
    }
}
