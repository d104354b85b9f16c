//! The current patches, what passes between them, and how that is drawn over a room.

use super::super::names;
use super::room_view::RoomView;
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::radiosity::SolverEvent;
use crate::figure::{Fit, Labels, within};
use crate::language::Language;
use crate::picture::{Dash, Ink, Picture, Rect, Shape, Stroke, Style, Tag};
use crate::record::Value;
use crate::replay::Run;
use crate::replay::radiosity::Focused;
use glam::Vec2;

/// The current patch, the other one, and the value between them.
pub struct Exchange {
    pub i: usize,
    pub j: Option<usize>,
    /// Whether light goes from i to j, or comes from there.
    pub outward: bool,
    /// Symbol and value, once it is recorded.
    value: Option<(&'static str, f64)>,
}

impl Exchange {
    /// None where no patch is current.
    pub fn of(run: &Run, focus: Focus) -> Option<Self> {
        match run {
            Run::Radiosity(_, replay) => replay
                .state()
                .focused
                .map(Exchange::of_iteration)
                .or_else(|| Exchange::of_step(run)),
            Run::FormFactor(_, replay) => {
                let state = replay.state();
                let (i, j) = match (state.pair, focus) {
                    (Some((i, j, ..)), _) | (None, Focus::FormFactor { i, j }) => (i, j),
                    _ => return None,
                };
                Some(Exchange {
                    i: i as usize,
                    j: Some(j as usize),
                    outward: true,
                    value: state.found.map(|(f, _)| ("F_{ij}", f)),
                })
            }
            _ => None,
        }
    }

    fn of_iteration(focused: Focused) -> Self {
        let (j, value) = match focused.exchange {
            Some((j, SolverEvent::Exchanged { product, .. })) => {
                (Some(j), Some(("F_{ij} B_j", product)))
            }
            Some((j, SolverEvent::Received { delta, .. })) => (Some(j), Some(("ΔB_j", delta))),
            _ => (None, None),
        };
        Exchange {
            i: focused.i as usize,
            j: j.map(|j| j as usize),
            outward: matches!(focused.recorded, SolverEvent::Shooting { .. }),
            value,
        }
    }

    /// A step about one patch alone.
    fn of_step(run: &Run) -> Option<Self> {
        let walk = run.walk();
        let step = Some(walk.position()).filter(|&step| step < walk.len())?;
        match walk.own_fields(step).get("i") {
            Some(Value::Integer(i)) => Some(Exchange {
                i: usize::try_from(i).ok()?,
                j: None,
                outward: false,
                value: None,
            }),
            _ => None,
        }
    }

    pub fn recorded(&self, language: Language) -> Option<String> {
        let (symbol, value) = self.value?;
        Some(format!("{symbol} = {}", language.significant(value, 3)))
    }

    pub fn in_words(
        &self,
        prepared: &PreparedScene,
        room: &Enclosure,
        language: Language,
    ) -> String {
        let name = |patch| names::patch(prepared, room, patch, language);
        let mut strings = format!("i = {}", name(self.i));
        if let Some(j) = self.j {
            let way = if self.outward { "→" } else { "←" };
            strings = format!("{strings} {way} j = {}", name(j));
        }
        match self.recorded(language) {
            Some(value) => format!("{strings}, {}.", value.replace(['{', '}'], "")),
            None => format!("{strings}."),
        }
    }

    /// Outlines, arrow and labels. A patch that turns its back on the viewer has a broken outline.
    pub fn draw(
        &self,
        picture: &mut Picture,
        (prepared, room): (&PreparedScene, &Enclosure),
        language: Language,
        view: &RoomView,
        fit: &Fit,
        area: Rect,
    ) {
        let mut marks = vec![('i', self.i, Ink::This)];
        if let Some(j) = self.j.filter(|&j| j != self.i) {
            marks.insert(0, ('j', j, Ink::Linked));
        }
        for &(_, patch, ink) in &marks {
            let stroke = match view.shows(patch) {
                true => ink.stroke(2.5),
                false => ink.stroke(2.0).dashed(),
            };
            outline(picture, view, patch, fit, stroke);
        }
        let center = |patch| view.center(patch).map(|center| fit.place(center));
        let mut labels = Labels::new(area);
        let text = (0.035 * area.width.min(1.3 * area.height))
            .clamp(11.0, 15.0)
            .round();
        let style = Style::Bold.size(text);
        let mut over = Picture::new(picture.width, picture.height);
        if let [(_, j, _), (_, i, _)] = marks[..]
            && let (Some(from), Some(to)) = (
                center(if self.outward { i } else { j }),
                center(if self.outward { j } else { i }),
            )
            && let Some([from, to]) = within([from, to], area.grown(-3.0))
        {
            picture.tagged(Tag::Patch(j), |picture| {
                picture.arrow(from, to, self.stroke());
            });
            labels.avoid(from, to);
            if let Some(value) = self.recorded(language) {
                let aside = (to - from).perp();
                let middle = (from.lerp(to, 0.5), 3.0);
                let style = Style::LabelBold.size(text).ink(Ink::This);
                labels.put(&mut over, middle, aside, &value, style);
            }
        }
        for (letter, patch, ink) in marks.into_iter().rev() {
            let Some(at) = center(patch).filter(|&at| area.contains(at)) else {
                continue;
            };
            let name = format!(
                "{letter} = {}",
                names::patch(prepared, room, patch, language)
            );
            labels.put(&mut over, (at, 10.0), Vec2::Y, &name, style.ink(ink));
        }
        lay_over(picture, over);
    }

    /// What brings nothing is drawn thin and broken.
    fn stroke(&self) -> Stroke {
        match self.value {
            Some((_, 0.0)) => Stroke {
                dash: Dash::Dashed,
                ..Ink::This.stroke(1.25)
            },
            _ => Ink::This.stroke(2.5),
        }
    }
}

pub(super) fn outline(
    picture: &mut Picture,
    view: &RoomView,
    patch: usize,
    fit: &Fit,
    stroke: Stroke,
) {
    for piece in view.outlines(patch) {
        picture.tagged(Tag::Patch(patch), |picture| {
            picture.polygon(piece.into_iter().map(|corner| fit.place(corner)), stroke);
        });
    }
}

/// Labels on plates, so that they can be read on any colour.
pub fn lay_over(picture: &mut Picture, labels: Picture) {
    for item in labels.items {
        if matches!(item.shape, Shape::Text { .. }) {
            let plate = item.shape.bounds();
            picture.rect(plate, Ink::Surface.fill().opacity(0.85));
        }
        picture.items.push(item);
    }
}
