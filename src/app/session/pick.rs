//! Questions for a thing of the scene, which is clicked where a picture shows it.

use super::{Refused, Session, Standing};
use crate::algorithms::focus::Focus;
use crate::algorithms::primary::middle_ray;
use crate::app::strings;
use crate::lesson::{Answer, Guess, Thing};
use crate::picture::Tag;
use crate::record::Value;
use crate::scene::Shape;
use glam::DVec3;

impl Session {
    /// The kind of thing that a click answers the current question with.
    pub fn thing_asked(&self) -> Option<Thing> {
        match self.question()? {
            (question, Standing::Open) => match question.answer {
                Answer::Pick { thing, .. } => Some(thing),
                _ => None,
            },
            _ => None,
        }
    }

    /// Answers with the object that is seen at a pixel.
    pub(super) fn pick_object_at(&mut self, x: u32, y: u32) -> Result<(), Refused> {
        let pixel = self.record(Focus::Pixel { x, y });
        let walk = pixel.walk();
        // The first ray is the one from the eye; polygons hide those that were drawn before.
        let seen = match pixel.rays() {
            Some(_) => (0..walk.len()).find(|&step| walk.kind(step) == "Found"),
            None => (0..walk.len()).rfind(|&step| walk.kind(step) == "PixelColored"),
        };
        let fields = seen.map(|step| match pixel.rays() {
            Some(_) => walk.own_fields(step),
            None => walk.fields(step),
        });
        match fields.and_then(|fields| fields.get("object")) {
            Some(Value::Integer(number)) => self.answer(&Guess::Pick(number as usize)),
            _ => Err(strings::NOTHING_DRAWN_THERE.into()),
        }
    }

    /// Goes to the patch that is seen at a pixel.
    pub(super) fn go_to_patch_at(&mut self, x: u32, y: u32) -> Result<(), Refused> {
        let ray = middle_ray(&self.prepared().view, (x, y));
        let enclosure = self.setup().enclosure();
        let enclosure = enclosure.map_err(|error| Refused::Error(error.to_string()))?;
        let seen = enclosure.primitives.nearest(&ray);
        let (patch, _) = seen.ok_or(strings::NOTHING_DRAWN_THERE)?;
        self.go_to_thing(Tag::Patch(patch))
            .or_else(|_| self.focus_on(Focus::Patch(patch as u32)))
    }

    /// What stands for a thing in pictures: a patch itself, and the pixel in the middle of an object; none for one without end or
    /// outside the picture.
    pub(super) fn place_of(&self, thing: Thing, number: usize) -> Option<Tag> {
        if thing == Thing::Patch {
            return Some(Tag::Patch(number));
        }
        let prepared = &self.open.setup.prepared;
        let middle = match prepared.scene.objects.get(number)?.shape {
            Shape::Sphere { center, .. } => center,
            _ => {
                let mesh = prepared.tessellation.meshes.get(number)?;
                let count = mesh.vertex_count() as u32;
                let places = (0..count).map(|vertex| mesh.position(vertex));
                places.sum::<DVec3>() / f64::from(count)
            }
        };
        let view = &prepared.view;
        let middle = view.to_camera(middle);
        let at = view.to_screen(middle).floor();
        let inside = |at: f64, size: u32| (0.0..f64::from(size)).contains(&at);
        let shown = middle.z > 0.0 && inside(at.x, view.width) && inside(at.y, view.height);
        shown.then_some(Tag::Pixel {
            x: at.x as u32,
            y: at.y as u32,
        })
    }
}
