//! The polygon in hand, large: its corners and edges, the scan line with the points where it cuts them, the pixels of the
//! span; and under it the interpolation of the step as bars.

mod bars;
mod line;
mod polygon;

use super::Show;
use super::message::message;
use super::values::told_in_words;
use super::words::Words;
use crate::algorithms::scan_line::Carried;
use crate::picture::{Picture, Rect};
use crate::replay::Run;
use crate::replay::shading::State;
use glam::Vec2;

const NO_POLYGON: Words = Words::new(
    "No polygon is in hand at this step. Go on (→) to the next polygon: its edges, the scan line and the span stand here.",
    "Tidak ada poligon pada langkah ini. Lanjutkan (→) ke poligon berikutnya: sisi, garis scan, dan rentangnya tampil di sini.",
);
const NO_LINE: Words = Words::new(
    "No edge is being drawn at this step. Go on (→) to the next edge: its line and the pixels that it takes stand here.",
    "Tidak ada sisi yang digambar pada langkah ini. Lanjutkan (→) ke sisi berikutnya: garis dan pikselnya tampil di sini.",
);

pub fn draw(show: &Show, size: Vec2) -> Picture {
    match show.run {
        Run::Gouraud(replay) => of_state(show, replay.state(), size),
        Run::Flat(replay) => of_state(show, replay.state(), size),
        Run::Wireframe(replay) => match replay.state().line {
            Some(ends) => {
                let mut picture = Picture::new(size.x, size.y);
                line::draw(&mut picture, replay, ends);
                picture.alt = told_in_words(show);
                picture
            }
            None => silent(show, NO_LINE, size),
        },
    }
}

fn of_state<A: Carried>(show: &Show, state: &State<A>, size: Vec2) -> Picture {
    if state.polygon.is_none() {
        return silent(show, NO_POLYGON, size);
    }
    let mut picture = Picture::new(size.x, size.y);
    // The bars keep their place whether they are filled or not, so that the polygon stands still.
    let bars = if A::NAMES.is_some() {
        bars::height(size)
    } else {
        0.0
    };
    let area = Rect::new(0.0, 0.0, size.x, size.y - bars);
    polygon::draw(&mut picture, state, area);
    if bars > 0.0
        && let Some(interpolation) = bars::Interpolation::in_hand(state)
    {
        let area = Rect::new(0.0, area.bottom(), size.x, bars).grown(-2.0);
        interpolation.draw(&mut picture, area, show.language);
    }
    picture.alt = told_in_words(show);
    picture
}

/// Says why there is nothing to see.
fn silent(show: &Show, words: Words, size: Vec2) -> Picture {
    let mut picture = message(words, show.language, size);
    picture.alt = format!("{} {}", told_in_words(show), picture.alt);
    picture
}
