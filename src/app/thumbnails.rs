//! Small pictures of all lessons, each drawn by the lesson's own method, in the background and one after the other.

use super::background::{Job, Work};
use super::session::Session;
use crate::algorithms::frame::Frame;
use crate::lesson::{Lesson, builtin};
use crate::render::{Cancelled, preview};
use egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions};
use std::collections::HashMap;
use std::num::NonZeroUsize;

/// The pictures fit in this many pixels.
const LARGEST: [u32; 2] = [288, 216];

/// A picture on the graphics card.
pub struct Thumbnail {
    pub texture: TextureHandle,
    /// Of the scene, for what lies beside the picture.
    pub background: Color32,
}

/// The pictures made so far.
#[derive(Default)]
pub struct Thumbnails {
    made: HashMap<String, Thumbnail>,
    /// Dropped, it ends within milliseconds.
    making: Option<Work<DrawnThumbnail>>,
}

struct DrawnThumbnail {
    id: String,
    image: ColorImage,
    background: Color32,
}

impl Thumbnails {
    /// Takes what has been made, and lets what is missing be made: first what stands near the open lesson in the list.
    pub fn bring_on(&mut self, session: &Session, ctx: &Context) {
        let making = self.making.get_or_insert_with(|| {
            let ids: Vec<&String> = session.all_lessons().map(|listed| &listed.id).collect();
            let here = ids.iter().position(|&id| *id == session.lesson().id);
            let missing = ids.into_iter().enumerate();
            let missing = missing.filter(|(_, id)| !self.made.contains_key(*id));
            let mut missing: Vec<(usize, &String)> = missing.collect();
            missing.sort_by_key(|(index, _)| index.abs_diff(here.unwrap_or(0)));
            let missing = missing.into_iter().map(|(_, id)| {
                let own = session.own_lesson(id);
                let own = own.and_then(|own| own.lesson.clone().ok());
                (id.clone(), own)
            });
            let jobs = missing.map(|(id, own)| job(id, own, ctx.clone()));
            Work::begin_all("thumbnails", jobs.collect())
        });
        for DrawnThumbnail {
            id,
            image,
            background,
        } in making.take()
        {
            let texture = ctx.load_texture(&id, image, TextureOptions::LINEAR);
            let thumbnail = Thumbnail {
                texture,
                background,
            };
            self.made.insert(id, thumbnail);
        }
    }

    /// Makes no more for now: other pictures are wanted sooner.
    pub fn pause(&mut self) {
        self.making = None;
    }

    pub fn of(&self, id: &str) -> Option<&Thumbnail> {
        self.made.get(id)
    }
}

/// Makes the picture of a lesson, which is one of the program's own unless given.
fn job(id: String, own: Option<Lesson>, ctx: Context) -> Job<DrawnThumbnail> {
    Box::new(move |worker| {
        if let Some(made) = make(id, own, &|| worker.go_on()) {
            worker.send(made);
            ctx.request_repaint();
        }
    })
}

/// Errors of `go_on` end the work.
type GoOn<'a> = dyn Fn() -> Result<(), Cancelled> + Sync + 'a;

/// None where the lesson cannot be drawn, or the work was cancelled.
fn make(id: String, own: Option<Lesson>, go_on: &GoOn) -> Option<DrawnThumbnail> {
    let read = || builtin(&id)?.read().ok();
    let lesson = own.or_else(read)?;
    let background = color(lesson.scene.background);
    let image = draw(lesson, go_on)?;
    Some(DrawnThumbnail {
        id,
        image,
        background,
    })
}

/// The lesson's picture in small. None where it cannot be drawn, or the work was cancelled.
fn draw(mut lesson: Lesson, go_on: &GoOn) -> Option<ColorImage> {
    lesson.size = fitted(lesson.size);
    let setup = lesson.setup(lesson.scene.clone(), lesson.settings.clone())?;
    setup.check_for(lesson.method).ok()?;
    let (progress, one) = (|_, _| go_on(), NonZeroUsize::MIN);
    let frame = preview(&setup, lesson.method, one, progress, &mut |_| {}).ok()?;
    Some(image(&frame))
}

/// The largest size of these proportions that fits.
fn fitted([width, height]: [u32; 2]) -> [u32; 2] {
    let [most_wide, most_high] = LARGEST.map(f64::from);
    let (width, height) = (f64::from(width), f64::from(height));
    let scale = (most_wide / width).min(most_high / height);
    [width, height].map(|side| (scale * side).round().max(1.0) as u32)
}

fn image(frame: &Frame) -> ColorImage {
    let size = [frame.width as usize, frame.rows.len()];
    ColorImage::new(size, frame.color.iter().map(|&rgb| color(rgb)).collect())
}

fn color(rgb: crate::color::Rgb) -> Color32 {
    let [r, g, b] = rgb.to_srgb8();
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_keep_their_proportions() {
        assert_eq!(fitted([640, 480]), [288, 216]);
        assert_eq!(fitted([48, 36]), [288, 216]);
        assert_eq!(fitted([160, 60]), [288, 108]);
        assert_eq!(fitted([480, 480]), [216, 216]);
        assert_eq!(fitted([1, 10_000]), [1, 216]);
    }

    #[test]
    fn a_lesson_is_drawn_by_its_own_method_unless_that_is_cancelled() {
        for id in ["gouraud-triangle", "form-factors"] {
            let draw = |go_on: Result<(), Cancelled>| {
                let lesson = builtin(id).unwrap().read().unwrap();
                super::draw(lesson, &|| go_on)
            };
            let image = draw(Ok(())).expect("a picture");
            assert_eq!(image.size, [288, 216]);
            let first = image.pixels[0];
            assert!(image.pixels.iter().any(|&pixel| pixel != first), "{id}");
            assert!(draw(Err(Cancelled)).is_none(), "{id}");
        }
    }
}
