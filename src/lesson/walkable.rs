//! What can be walked through, from the bytes of a file.

use super::kind::is_lesson;
use super::link::{pack, unpack};
use super::resolve::Lesson;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::scene::document::Problem;
use crate::scene::{self, Limits, ReadFile, Scene, SceneError, is_mesh};

impl Lesson {
    /// What the file of that name holds: a lesson, or a walk through a scene, or through a mesh, which gets a camera and a light.
    /// `read_file` reads what the file names. Errors: what is wrong with it, one problem a line.
    pub fn of_file(name: &str, bytes: &[u8], read_file: &mut ReadFile) -> Result<Lesson, String> {
        let limits = Limits::default();
        if !is_mesh(name) && is_lesson(bytes) {
            let lesson = Lesson::read(bytes, &limits, read_file);
            return lesson.map_err(|error| error.to_string());
        }
        if !is_mesh(name) {
            let read = Lesson::of_scene_text(name, bytes, read_file);
            return read.map_err(|problems| SceneError { problems }.to_string());
        }
        let scene = scene::scene_of_mesh(name, &limits, &mut |wanted| match wanted == name {
            true => Ok(bytes.to_vec()),
            false => read_file(wanted),
        });
        Lesson::through(name, scene.map_err(|error| error.to_string())?)
    }

    /// A walk through the scene whose packed text an address holds. Errors: what is wrong with it.
    pub fn of_packed_scene(name: &str, packed: &str) -> Result<Lesson, String> {
        let nothing: &mut ReadFile = &mut |_| Err("an address holds no other files".into());
        Lesson::of_file(name, &unpack(packed)?, nothing)
    }

    /// A walk through the scene of that name whose text is given. Errors: what is wrong with it, and where.
    pub fn of_scene_text(
        name: &str,
        text: &[u8],
        read_file: &mut ReadFile,
    ) -> Result<Lesson, Vec<Problem>> {
        let mut alone = true;
        let scene = scene::read(text, &Limits::default(), &mut |path| {
            alone = false;
            read_file(path)
        });
        let scene = scene.map_err(|error| error.problems)?;
        // What is wrong with all of it has no place.
        let walk = Lesson::through(name, scene).map_err(|message| {
            vec![Problem {
                place: String::new(),
                line: None,
                column: None,
                message,
            }]
        })?;
        let packed = pack(text).filter(|_| alone).map(Into::into);
        Ok(Lesson { packed, ..walk })
    }

    /// A walk through a scene. Errors: why no picture can be made of it.
    fn through(name: &str, scene: Scene) -> Result<Lesson, String> {
        let prepared = PreparedScene::of_size(scene, Lesson::SIZE_OF_A_WALK)?;
        Ok(Lesson::of_scene(name, prepared))
    }
}
