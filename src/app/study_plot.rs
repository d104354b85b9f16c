//! The plot of a part of a study, to be pointed at, clicked, zoomed and dragged.

use super::picture_place::Place;
use super::picture_view::PictureView;
use super::said_beside::said_beside;
use super::session::{PointAt, Session};
use super::{strings, study_words, tree_controls};
use crate::figure::View;
use crate::language::Language;
use crate::picture::Tag;
use crate::study::harness::Part;
use crate::study::plot::{field, plot_part};
use egui::{Sense, Ui};

/// What is kept of the plot from frame to frame.
#[derive(Default)]
pub struct StudyPlot {
    picture: PictureView<Key>,
    /// How much is looked at of which part of which study.
    looked_at: Option<(&'static str, usize, View)>,
}

/// All that the plot depends on.
#[derive(PartialEq)]
struct Key {
    study: &'static str,
    part: usize,
    /// A part that is measured anew has another length of time.
    measured: Vec<u64>,
    language: Language,
    view: View,
}

/// What the pointer does to the points of a plot.
#[derive(Default)]
pub struct Pointed {
    pub at: Option<PointAt>,
    pub clicked: bool,
}

impl StudyPlot {
    /// Shows the part, `lit` brought out.
    pub fn show(
        &mut self,
        session: &Session,
        part: &Part,
        lit: Option<PointAt>,
        ui: &mut Ui,
    ) -> Pointed {
        let studying = session.studying();
        let study = studying.of.map(|(study, _)| study.name).unwrap_or_default();
        let view = match self.looked_at {
            Some((of, index, view)) if (of, index) == (study, studying.part) => view,
            _ => View::WHOLE,
        };
        let place = Place::on_pixels(ui.available_rect_before_wrap(), session.look.theme, ui);
        let language = session.look.language;
        let key = Key {
            study,
            part: studying.part,
            measured: part
                .points()
                .map(|(_, point)| point.seconds.median.to_bits())
                .collect(),
            language,
            view,
        };
        let lit = lit.filter(|at| at.part == studying.part);
        let lit = lit.map(|PointAt { line, point, .. }| Tag::Point { curve: line, point });
        let lit = lit.into_iter().collect();
        self.picture.draw(place, key, lit, ui, |size| {
            plot_part(part, language, size, view)
        });
        let response = ui.allocate_rect(place.rect, Sense::click_and_drag());
        let name = session.localize(strings::STUDY_PLOT);
        let under = self.picture.paint(place, name, &response, ui);
        let size = glam::Vec2::new(place.rect.width(), place.rect.height());
        let changed = match response.double_clicked() {
            true => Some(View::WHOLE),
            false => field(part, language, size, view).and_then(|field| {
                tree_controls::looked_at(view, || Some(view.middle()), field, &response, ui)
            }),
        };
        if let Some(view) = changed {
            self.looked_at = Some((study, studying.part, view));
            ui.ctx().request_repaint();
        }
        let Some(Tag::Point { curve, point }) = under else {
            return Pointed::default();
        };
        let at = PointAt {
            part: studying.part,
            line: curve,
            point,
        };
        let clicked = response.clicked();
        if let Some((_, line, point)) = studying.point(at) {
            let text = study_words::recorded(session, line, point);
            said_beside(&response, None, text);
        }
        Pointed {
            at: Some(at),
            clicked,
        }
    }
}
