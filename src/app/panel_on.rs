//! A panel on the screen, and what the pointer does to it.

use super::panel_view::{self, PanelView, Scale};
use super::session::{Command, Session};
use super::{drag, image_controls, inspector_controls, space_controls, tree_controls};
use crate::panels::{Panel, step_at};
use crate::picture::Tag;
use egui::{Key, Rect, Response, Ui};

/// What came of showing a panel.
pub struct PanelResponse {
    pub command: Option<Command>,
    pub under: Option<Tag>,
    /// Whether a place that shows nothing was clicked twice.
    pub filled: bool,
}

/// Whether a click is that of the enter key.
pub(super) fn entered(response: &Response, ui: &Ui) -> bool {
    response.has_focus() && ui.input(|input| input.key_pressed(Key::Enter))
}

/// Shows a panel in `rect` and reads clicks: plain ones select, double ones and the enter key go there; with shift they go to the scan
/// line, with Ctrl to the polygon. The time line is there to go, and a value leads to the step that recorded it.
pub fn panel_on(
    session: &Session,
    panel: Panel,
    view: &mut PanelView,
    rect: Rect,
    ui: &mut Ui,
) -> PanelResponse {
    let (response, under) = view.show(session, panel, rect, Scale::Full, ui);
    let mut command = None;
    let went = response.double_clicked() || entered(&response, ui);
    if response.clicked() {
        let held = ui.input(|input| input.modifiers);
        let goes = went || matches!(panel, Panel::TimeLine | Panel::Inspector);
        command = under.map(|tag| match tag {
            Tag::Pixel { x, y } if held.command => Command::FocusOnPolygonAt { x, y },
            Tag::Pixel { y, .. } if held.shift => Command::Go(Tag::ScanLine(y as i32)),
            tag if goes => Command::Go(tag),
            tag => Command::Click(tag),
        });
    }
    if panel == Panel::TimeLine && (response.dragged() || response.clicked() && command.is_none()) {
        // The track spans the whole run: dragging along it walks through all of it.
        let at = response
            .interact_pointer_pos()
            .map_or(0.0, |at| at.x - response.rect.min.x);
        let size = glam::Vec2::new(response.rect.width(), response.rect.height());
        let step = step_at(&session.panel_input(), size, at);
        command = (step != session.step()).then_some(Command::Seek(step));
    }
    // What the pointer holds is moved, and the view stays as it is.
    let holds = match panel {
        Panel::Vectors if session.arrow_asked().is_some() => {
            command = drag::turned(session, &response).or(command);
            false
        }
        Panel::Space | Panel::Vectors | Panel::Image | Panel::ScanLine => {
            drag::dragged(session, panel, &response, &mut command, ui)
        }
        _ => false,
    };
    if panel == Panel::Space && !holds && !(went && command.is_some()) {
        command = space_controls::pointed(session, &response, ui).or(command);
    }
    // A double click on a node goes there, and does not fit the tree; so it is in the scene.
    if panel == Panel::RayTree && !(went && command.is_some()) {
        command = tree_controls::pointed(session, &response, ui).or(command);
    }
    if panel == Panel::Inspector {
        command = inspector_controls::pointed(session, &response, ui).or(command);
    }
    let is_image = matches!(panel, Panel::Image | Panel::Comparison | Panel::Difference);
    if is_image && !holds {
        command = image_controls::pointed(session, panel, &response, ui).or(command);
    }
    if panel == Panel::Image {
        // The menu is about the place where it was opened, not where the pointer went since.
        let id = response.id.with("menu");
        if response.secondary_clicked() {
            ui.data_mut(|data| data.insert_temp(id, under));
        }
        response.context_menu(|ui| {
            let tag = ui.data(|data| data.get_temp::<Option<Tag>>(id)).flatten();
            command = panel_view::menu(session, tag, ui).or(command.take());
        });
    }
    // A double click into the ray tree or the scene fits it.
    let fits = matches!(panel, Panel::RayTree | Panel::Space);
    let filled = response.double_clicked() && under.is_none() && !fits;
    PanelResponse {
        command,
        under,
        filled,
    }
}
