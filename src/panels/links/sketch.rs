//! The elements of the room and the lines between them.

use super::shown::{Chosen, Shown};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::color::Rgb;
use crate::figure::{Fit, Labels, Series, within};
use crate::language::Message;
use crate::panels::PanelInput;
use crate::panels::list::radiosity::exchange::lay_over;
use crate::panels::list::radiosity::overlapping;
use crate::panels::list::radiosity::room_view::RoomView;
use crate::picture::{Ink, Picture, Rect, Stroke, Style, Tag};
use crate::replay::hierarchical::{LinkNow, Solved, State};
use glam::{DVec3, Vec2};

const ELEMENT: Message = Message("links-element");

/// How much of the light shows through: the links are to be read.
const LIGHT: f32 = 0.2;
/// Elements that are smaller on average have no outlines, in square points.
const SMALLEST: f32 = 30.0;
/// With more lines than that, each is thin.
const FEW: usize = 60;

pub struct Sketch<'a> {
    input: &'a PanelInput<'a>,
    room: &'a Enclosure,
    state: &'a State,
    solved: &'a Solved,
    view: RoomView<'a>,
    fit: Fit,
    area: Rect,
}

impl<'a> Sketch<'a> {
    pub fn new(
        input: &'a PanelInput<'a>,
        prepared: &PreparedScene,
        room: &'a Enclosure,
        (state, solved): (&'a State, &'a Solved),
        area: Rect,
    ) -> Self {
        let view = RoomView::new(prepared, room);
        Sketch {
            input,
            room,
            state,
            solved,
            fit: view.fit(area),
            view,
            area,
        }
    }

    pub fn of_patch(&self, patch: usize) -> Option<Vec2> {
        let center = self.view.center(patch)?;
        Some(self.fit.place(center))
    }

    /// The patches that show their fronts, dimly in their light, under the outlines of the smallest elements.
    pub fn elements(&self, picture: &mut Picture) {
        let leaves: Vec<u32> = self.state.leaves().map(|(leaf, _)| leaf).collect();
        let mut leaf_of = vec![None; self.room.patches.len()];
        for &leaf in &leaves {
            for patch in self.state.patches(self.room, leaf) {
                leaf_of[patch] = Some(leaf);
            }
        }
        let mut left = vec![0_usize; self.state.elements.len()];
        for leaf in self.view.seen.iter().filter_map(|seen| leaf_of[seen.patch]) {
            left[leaf as usize] += 1;
        }
        let outlined = SMALLEST * (leaves.len() as f32) < self.area.width * self.area.height;
        let (light, exposure) = self.input.run.light().unwrap_or_default();
        for seen in &self.view.seen {
            let color = light.get(seen.patch).map_or(Rgb::BLACK, |b| *b * exposure);
            picture.tagged(Tag::Patch(seen.patch), |picture| {
                for piece in &seen.pieces {
                    let corners: Vec<Vec2> =
                        piece.iter().map(|&corner| self.fit.place(corner)).collect();
                    let corners = overlapping(&corners);
                    picture.polygon(corners.iter().copied(), Ink::Surface);
                    picture.polygon(corners, Ink::Rgb(color).fill().opacity(LIGHT));
                }
            });
            // What is nearer is painted over the outline.
            let Some(leaf) = leaf_of[seen.patch] else {
                continue;
            };
            left[leaf as usize] -= 1;
            if left[leaf as usize] == 0 && outlined {
                self.outline(picture, leaf, Ink::Muted.stroke(0.75));
            }
        }
    }

    fn outline(&self, picture: &mut Picture, element: u32, stroke: Stroke) {
        for polygon in self.solved.tree.polygons(&self.room.patches, element) {
            let corners = self.view.on_screen(&polygon.corners);
            if corners.len() > 2 {
                let corners = corners.into_iter().map(|corner| self.fit.place(corner));
                picture.polygon(corners, stroke);
            }
        }
    }

    /// The middle of an element.
    fn center(&self, element: u32) -> Option<Vec2> {
        let polygons = self.solved.tree.polygons(&self.room.patches, element);
        let area: f64 = polygons.iter().map(|polygon| polygon.area).sum();
        let moment: DVec3 = polygons
            .iter()
            .map(|polygon| polygon.area * polygon.center)
            .sum();
        let center = self.view.point(moment / area)?;
        Some(self.fit.place(center))
    }

    /// From the middle of one element to that of another, as far as that is seen.
    fn line(&self, [p, q]: [u32; 2]) -> Option<[Vec2; 2]> {
        within([self.center(p)?, self.center(q)?], self.area.grown(-3.0))
    }

    fn shows(&self, element: u32) -> bool {
        let patches = self.state.patches(self.room, element);
        patches.into_iter().any(|patch| self.view.shows(patch))
    }

    /// The links, the elements at their far ends where light comes over them to one, and the pair of the step on top.
    pub fn links(&self, picture: &mut Picture, shown: &Shown) {
        let few = shown.links.len() <= FEW;
        if let Chosen::Toward(p) = shown.chosen
            && few
        {
            let path = self.state.path(p);
            for link in &shown.links {
                let other = if path.contains(&link.p) {
                    link.q
                } else {
                    link.p
                };
                let ink = Series::of(link.level as usize).ink;
                self.outline(picture, other, ink.stroke(1.5));
            }
        }
        let lines = shown.links.iter().filter_map(|link| {
            let line = self.line([link.p, link.q])?;
            (!shown.is_current(link)).then_some((link, line))
        });
        let lines: Vec<(&LinkNow, [Vec2; 2])> = lines.collect();
        for &(link, ends) in &lines {
            let series = Series::of(link.level as usize);
            picture.tagged(Tag::Step(link.step as usize), |picture| match few {
                true => {
                    halo(picture, ends, 3.5);
                    picture.line(ends[0], ends[1], series.stroke);
                    for end in ends {
                        series.mark.draw(picture, end, 2.5, series.ink);
                    }
                }
                false => {
                    let stroke = Stroke {
                        width: 1.25,
                        ..series.stroke.opacity(0.85)
                    };
                    picture.line(ends[0], ends[1], stroke);
                }
            });
        }
        self.current(picture, shown, lines.iter().map(|&(_, ends)| ends));
    }

    /// The elements of the step with their names, the line between them, broken where they are not linked, and its form factor.
    fn current(
        &self,
        picture: &mut Picture,
        shown: &Shown,
        others: impl Iterator<Item = [Vec2; 2]>,
    ) {
        let mut marks = Vec::new();
        if let Some([p, q]) = shown.current {
            marks.extend([("q", q, Ink::Linked), ("p", p, Ink::This)]);
        }
        marks.extend(shown.alone.map(|p| ("p", p, Ink::This)));
        for &(_, element, ink) in &marks {
            let stroke = match self.shows(element) {
                true => ink.stroke(2.5),
                false => ink.stroke(2.0).dashed(),
            };
            self.outline(picture, element, stroke);
        }
        let mut labels = Labels::new(self.area);
        others.for_each(|[from, to]| labels.avoid(from, to));
        let text = (0.035 * self.area.width.min(1.3 * self.area.height))
            .clamp(11.0, 15.0)
            .round();
        let mut over = Picture::new(picture.width, picture.height);
        if let Some([from, to]) = shown.current.and_then(|pair| self.line(pair)) {
            halo(picture, [from, to], 6.0);
            let stroke = Ink::This.stroke(3.0);
            let is_linked = shown.links.iter().any(|link| shown.is_current(link));
            picture.line(from, to, if is_linked { stroke } else { stroke.dashed() });
            labels.avoid(from, to);
            if let Some(f) = self.state.form_factor {
                let value = format!("F_{{pq}} = {}", self.input.language.significant(f, 3));
                let style = Style::LabelBold.size(text).ink(Ink::This);
                let middle = (from.lerp(to, 0.5), 3.0);
                labels.put(&mut over, middle, (to - from).perp(), &value, style);
            }
        }
        for &(name, element, ink) in marks.iter().rev() {
            let center = self.center(element).filter(|&at| self.area.contains(at));
            let (Some(at), Some(now)) = (center, self.state.elements.get(element as usize)) else {
                continue;
            };
            let [number, level] = [element, now.level].map(|number| number.to_string());
            let arguments = [("name", name), ("number", &*number), ("level", &level)];
            let name = ELEMENT.format(self.input.language, &arguments);
            let style = Style::Bold.size(text).ink(ink);
            labels.put(&mut over, (at, 8.0), Vec2::Y, &name, style);
        }
        lay_over(picture, over);
    }
}

/// Sets a line off from what it crosses.
fn halo(picture: &mut Picture, [from, to]: [Vec2; 2], width: f32) {
    picture.line(from, to, Ink::Surface.stroke(width).opacity(0.7));
}
