//! The vectors where a ray meets a surface, in the plane of incidence: the plane of the incoming ray u and the normal.
//!
//! Outside (or the front) is up, inside (or the back) is down, and u goes from left to right. What leans out of the plane, as
//! directions to lights do, is drawn as its shadow in it: shortened.

mod angles;
mod arrows;
mod met;

use super::Show;
use super::message::{NO_RAYS, NO_STEPS, message};
use super::values::told_in_words;
use super::words::Words;
use crate::algorithms::visible::Met;
use crate::picture::{Picture, Rect};
use crate::replay::Run;
use crate::replay::rays::State;
use angles::Angles;
use glam::Vec2;
use met::SurfaceInSight;

const NOT_YET: Words = Words::new(
    "This ray has met no surface yet. Go on until the nearest object is found.",
    "Sinar ini belum mengenai permukaan. Lanjutkan sampai objek terdekat ditemukan.",
);
const NO_SURFACE: Words = Words::new(
    "This ray meets no surface: it takes the colour of the background, or of a light. Click an object in the image.",
    "Sinar ini tidak mengenai permukaan: mendapat warna latar belakang atau cahaya. Klik sebuah objek pada gambar.",
);

pub fn draw(show: &Show, size: Vec2) -> Picture {
    if show.run.walk().is_empty() {
        return message(NO_STEPS, show.language, size);
    }
    let state = match show.run {
        Run::RayCasting(replay) => replay.state(),
        Run::RayTracing(replay) => replay.state(),
        Run::Wireframe(_)
        | Run::Flat(_)
        | Run::Gouraud(_)
        | Run::Radiosity(..)
        | Run::FormFactor(..) => {
            return message(NO_RAYS, show.language, size);
        }
    };
    let Some(surface) = SurfaceInSight::of(state) else {
        let words = if over(state) { NO_SURFACE } else { NOT_YET };
        return message(words, show.language, size);
    };
    let walk = show.run.walk();
    let kind = walk.kind(walk.position());
    let text = (1.25 * small(size)).min(20.0).round();
    let angles = Angles::of(&surface, show.language);

    let mut picture = Picture::new(size.x, size.y);
    let lights = state.stage.scene.lights.len();
    let (drawing, table) = halves(size, lights);
    arrows::draw(&mut picture, &surface, kind, text, show.language, drawing);
    angles.draw(&mut picture, kind, small(size), table);
    picture.alt = format!("{} {}", told_in_words(show), angles.in_words());
    picture
}

/// Whether the ray in hand has found out that it meets no surface.
fn over(state: &State) -> bool {
    let met = state.ray().and_then(|ray| ray.met);
    matches!(met, Some(Met::Nothing | Met::Light { .. }))
}

/// Size of the text of the list.
fn small(size: Vec2) -> f32 {
    (0.033 * size.x.min(1.4 * size.y)).clamp(11.0, 16.0).round()
}

/// Where the vectors are drawn, and where the angles stand: beside or under them, whichever leaves the vectors more room. It
/// depends on no step, so that nothing jumps.
fn halves(size: Vec2, lights: usize) -> (Rect, Rect) {
    let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-6.0);
    let text = small(size);
    let width = (26.0 * text).min(0.54 * whole.width);
    let height = angles::height(lights, text).min(0.45 * whole.height);
    let left = Rect {
        width: whole.width - width - 8.0,
        ..whole
    };
    let upper = Rect {
        height: whole.height - height - 6.0,
        ..whole
    };
    let room = |area: Rect| area.width.min(area.height);
    if room(upper) > room(left) {
        let below = Rect::new(whole.x, whole.bottom() - height, whole.width, height);
        (upper, below)
    } else {
        let right = Rect::new(whole.right() - width, whole.y, width, whole.height);
        (left, right)
    }
}

#[cfg(test)]
mod tests;
