//! Patches in space: what they are coloured by, which one the pointer is on, and what passes between two of them.

use super::super::radiosity::exchange::Exchange;
use super::super::radiosity::pair::in_words as between;
use super::sketch::Sketch;
use super::surfaces::{faces_viewer, light_from};
use crate::algorithms::enclosure::Enclosure;
use crate::color::Rgb;
use crate::figure::{Space, elided};
use crate::panels::PanelInput;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::Run;
use glam::{DVec3, Vec2};

/// The light of each patch so far, as the eye is exposed; of a form factor, what the surfaces look like.
pub(super) fn colors(input: &PanelInput, space: &Space, room: &Enclosure) -> Vec<Rgb> {
    let Run::Radiosity(_, replay) = input.run else {
        return shaded(space, room);
    };
    let state = replay.state();
    let exposure = state.solved.as_ref().map_or(1.0, |solved| solved.exposure);
    let light = state.light(room).into_iter();
    light.map(|radiosity| radiosity * exposure).collect()
}

/// The reflectances as a lamp at the viewer shows them.
fn shaded(space: &Space, room: &Enclosure) -> Vec<Rgb> {
    let patches = room.patches.iter().zip(&room.reflectance);
    let shaded = patches
        .map(|(patch, &reflectance)| reflectance * light_from(space, patch.center, patch.normal));
    shaded.collect()
}

/// Lays invisible outlines over the patches in sight, far ones first, so that each can be pointed at.
pub(super) fn targets(picture: &mut Picture, space: &Space, room: &Enclosure) {
    let mut fronts: Vec<(f64, usize, &[DVec3])> = Vec::new();
    for patch in 0..room.patches.len() {
        for piece in room.patches.pieces(patch) {
            if faces_viewer(space, piece.corners[0], piece.normal) {
                let center = piece.corners.iter().sum::<DVec3>() / piece.corners.len() as f64;
                fronts.push((space.seen_from(center).z, patch, piece.corners));
            }
        }
    }
    fronts.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
    for (_, patch, corners) in fronts {
        let outline = space.polygon(corners).into_iter();
        let outline: Vec<Vec2> = outline.map(|(_, seen)| seen.at).collect();
        picture.tagged(Tag::Patch(patch), |picture| {
            picture.polygon(outline, Ink::Surface.fill().opacity(0.0));
        });
    }
}

impl Sketch<'_> {
    /// The two patches that are selected, a line between them, and the form factors in a corner.
    pub fn pair(&mut self, room: &Enclosure, [i, j]: [usize; 2]) {
        for patch in [i, j] {
            for piece in room.patches.pieces(patch) {
                self.outline(piece.corners, Ink::Linked.stroke(2.5));
            }
        }
        let [from, to] = [i, j].map(|patch| room.patches[patch].center);
        self.line(from, to, Ink::Linked.stroke(1.75));
        let style = Style::LabelBold.size(self.text).ink(Ink::Linked);
        let text = between(self.input, [i, j]);
        let corner = self.space.area.min() + 6.0;
        let ground = Rect::new(
            corner.x,
            corner.y,
            style.width(&text) + 8.0,
            1.6 * self.text,
        );
        let ground = ground.intersection(&self.space.area);
        self.labels.reserve(ground);
        self.picture
            .rounded_rect(ground, 2.0, Ink::Surface.fill().opacity(0.85));
        elided(self.picture, ground.grown(-4.0), &text, style);
    }

    pub fn exchange(&mut self, room: &Enclosure) {
        let Some(exchange) = Exchange::of(self.input.run, self.input.focus) else {
            return;
        };
        let other = exchange.j.filter(|&j| j != exchange.i);
        let drawn = other.and_then(|j| self.light(room, &exchange, j));
        let marks = [
            (other, Ink::Linked, "j"),
            (Some(exchange.i), Ink::This, "i"),
        ];
        for (patch, ink, letter) in marks {
            let Some(patch) = patch else { continue };
            for piece in room.patches.pieces(patch) {
                self.outline(piece.corners, ink.stroke(2.5));
            }
            let paint = ink.fill().outlined(Ink::Surface.stroke(1.5));
            if let Some(at) = self.disc(room.patches[patch].center, 4.0, paint) {
                self.name(at, 4.0, Vec2::NEG_Y, letter, ink);
            }
        }
        let value = exchange.recorded(self.input.language);
        if let (Some([from, to]), Some(value)) = (drawn, value) {
            self.name(
                from.lerp(to, 0.5),
                3.0,
                (to - from).perp(),
                &value,
                Ink::Text,
            );
        }
    }

    /// From the patch that gives to the one that takes.
    fn light(&mut self, room: &Enclosure, exchange: &Exchange, j: usize) -> Option<[Vec2; 2]> {
        let [from, to] = match exchange.outward {
            true => [exchange.i, j],
            false => [j, exchange.i],
        };
        let [from, to] = [from, to].map(|patch| room.patches[patch].center);
        let tag = Tag::FormFactor { i: exchange.i, j };
        self.arrow(tag, from, to, Ink::This.stroke(2.5))
    }
}
