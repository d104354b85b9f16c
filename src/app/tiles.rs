//! The lesson's panels in the middle of the window, as tiles whose borders can be dragged.

use super::panel_view::{self, PanelView};
use super::session::{Command, Session};
use super::{drag, strings, style, tree_controls};
use crate::panels::{Panel, step_at};
use crate::picture::{Ink, Tag};
use egui::{Rect, Ui, WidgetText};
use egui_tiles::{Behavior, Container, Linear, LinearDir, TileId, Tiles, Tree, UiResponse};
use std::collections::HashMap;

/// Height of a card's title.
const TITLE: f32 = 34.0;
/// Between cards, and around them.
pub const GAP: f32 = 10.0;
/// Between a card's frame and its picture.
const MARGIN: f32 = 4.0;

/// The arrangement, which a user may have changed.
pub struct Arrangement {
    panels: Vec<Panel>,
    tree: Tree<Panel>,
}

impl Default for Arrangement {
    fn default() -> Self {
        Arrangement {
            panels: Vec::new(),
            tree: Tree::empty(egui::Id::unique("panels")),
        }
    }
}

impl Arrangement {
    /// Shows the session's panels, in their usual arrangement when others were shown before.
    pub fn show(
        &mut self,
        session: &Session,
        views: &mut HashMap<Panel, PanelView>,
        commands: &mut Vec<Command>,
        under_pointer: &mut Option<Tag>,
        ui: &mut Ui,
    ) {
        let panels = session.panels();
        if self.panels != panels {
            self.tree = arrange(&panels);
            self.panels = panels;
        }
        self.tree.ui(
            &mut Cards {
                session,
                views,
                commands,
                under_pointer,
            },
            ui,
        );
    }
}

fn arrange(panels: &[Panel]) -> Tree<Panel> {
    if panels.contains(&Panel::RayTree) {
        beside_the_tree(panels)
    } else if panels.contains(&Panel::Illumination) {
        beside_the_terms(panels)
    } else {
        in_rows(panels)
    }
}

/// Two columns: the ray tree needs room, so it has the wider one, with the rays in the scene under it.
fn beside_the_tree(panels: &[Panel]) -> Tree<Panel> {
    let mut tiles = Tiles::default();
    let is_wide = |panel: &Panel| matches!(panel, Panel::RayTree | Panel::Rays);
    let mut wide: Vec<Panel> = panels.iter().copied().filter(is_wide).collect();
    wide.sort_by_key(|&panel| panel != Panel::RayTree);
    let narrow = panels.iter().copied().filter(|panel| !is_wide(panel));
    let narrow: Vec<TileId> = narrow.map(|panel| tiles.insert_pane(panel)).collect();
    let wide: Vec<TileId> = wide
        .into_iter()
        .map(|panel| tiles.insert_pane(panel))
        .collect();
    let right = match wide[..] {
        [tree, rays] => {
            let rows = Linear::new_binary(LinearDir::Vertical, [tree, rays], 0.62);
            tiles.insert_container(Container::Linear(rows))
        }
        _ => tiles.insert_vertical_tile(wide),
    };
    let root = if narrow.is_empty() {
        right
    } else {
        let left = tiles.insert_vertical_tile(narrow);
        let columns = Linear::new_binary(LinearDir::Horizontal, [left, right], 0.42);
        tiles.insert_container(Container::Linear(columns))
    };
    Tree::new(egui::Id::unique("panels"), root, tiles)
}

/// Two columns: the others, and beside them the terms with their curves, which need height.
fn beside_the_terms(panels: &[Panel]) -> Tree<Panel> {
    let mut tiles = Tiles::default();
    let (terms, others): (Vec<Panel>, Vec<Panel>) = panels
        .iter()
        .partition(|&&panel| panel == Panel::Illumination);
    let mut column = |panels: Vec<Panel>| {
        let panes = panels.into_iter().map(|panel| tiles.insert_pane(panel));
        let panes: Vec<TileId> = panes.collect();
        tiles.insert_vertical_tile(panes)
    };
    let columns = [others, terms].map(&mut column);
    let columns = Linear::new_binary(LinearDir::Horizontal, columns, 0.55);
    let root = tiles.insert_container(Container::Linear(columns));
    Tree::new(egui::Id::unique("panels"), root, tiles)
}

/// Two rows, the upper one higher; the first panel, which shows the picture, stands in the upper one.
fn in_rows(panels: &[Panel]) -> Tree<Panel> {
    let mut tiles = Tiles::default();
    let ids: Vec<TileId> = panels
        .iter()
        .map(|&panel| tiles.insert_pane(panel))
        .collect();
    let (upper, lower) = ids.split_at(if ids.len() <= 2 {
        ids.len()
    } else {
        ids.len() / 2
    });
    let upper = tiles.insert_horizontal_tile(upper.to_vec());
    if lower.is_empty() {
        return Tree::new(egui::Id::unique("panels"), upper, tiles);
    }
    let lower = tiles.insert_horizontal_tile(lower.to_vec());
    let rows = Linear::new_binary(LinearDir::Vertical, [upper, lower], 0.6);
    let root = tiles.insert_container(Container::Linear(rows));
    Tree::new(egui::Id::unique("panels"), root, tiles)
}

/// Each tile is a card: title, caption, picture.
struct Cards<'a> {
    session: &'a Session,
    views: &'a mut HashMap<Panel, PanelView>,
    commands: &'a mut Vec<Command>,
    under_pointer: &'a mut Option<Tag>,
}

impl Behavior<Panel> for Cards<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, _: TileId, panel: &mut Panel) -> UiResponse {
        let theme = self.session.look.theme;
        let rect = ui.max_rect();
        style::card(theme, rect, ui);
        let title = Rect::from_min_size(rect.min, egui::vec2(rect.width(), TITLE))
            .shrink2(egui::vec2(12.0, 4.0));
        card_title(self.session, *panel, self.commands, title, ui);
        let mut inside = rect.shrink(MARGIN);
        inside.min.y = rect.min.y + TITLE;
        let view = self.views.entry(*panel).or_default();
        let shown = panel_on(self.session, *panel, view, inside, ui);
        self.commands.extend(shown.command);
        *self.under_pointer = shown.under.or(*self.under_pointer);
        UiResponse::None
    }

    fn tab_title_for_pane(&mut self, panel: &Panel) -> WidgetText {
        self.session.localize(panel.title()).into()
    }

    fn gap_width(&self, _: &egui::Style) -> f32 {
        GAP
    }

    fn min_size(&self) -> f32 {
        120.0
    }

    fn resize_stroke(&self, style: &egui::Style, state: egui_tiles::ResizeState) -> egui::Stroke {
        match state {
            egui_tiles::ResizeState::Idle => egui::Stroke::NONE,
            _ => egui::Stroke::new(2.0, style.visuals.selection.stroke.color),
        }
    }
}

/// The title at the left; the caption at the right, as much of it as there is room for.
fn card_title(
    session: &Session,
    panel: Panel,
    commands: &mut Vec<Command>,
    rect: Rect,
    ui: &mut Ui,
) {
    let mut ui = ui.new_child(
        egui::UiBuilder::new()
            .max_rect(rect)
            .layout(egui::Layout::left_to_right(egui::Align::Center)),
    );
    ui.label(style::strong(session.localize(panel.title()), 15.0));
    let muted = style::color(session.look.theme, Ink::Muted);
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        if panel == Panel::RayTree {
            tree_controls::buttons(session, commands, ui);
        }
        if panel == Panel::Radiosity {
            let strings = session.localize(strings::SMOOTH);
            let text = egui::RichText::new(strings).size(13.0);
            let button = egui::Button::new(text).selected(session.look.smooth);
            let name = session.localize(strings::SMOOTH_ROOM);
            super::button::button(session, button, name, Command::Smooth, commands, ui);
        }
        let caption = egui::RichText::new(panel_view::caption(session, panel))
            .size(13.0)
            .color(muted);
        ui.add(egui::Label::new(caption).truncate().selectable(false));
    });
}

/// What came of showing a panel.
pub struct Shown {
    pub command: Option<Command>,
    pub under: Option<Tag>,
}

/// Shows a panel in `rect` and reads clicks: plain ones go there, with shift to the scan line, with Ctrl to the polygon.
pub fn panel_on(
    session: &Session,
    panel: Panel,
    view: &mut PanelView,
    rect: Rect,
    ui: &mut Ui,
) -> Shown {
    let (response, under) = view.show(session, panel, rect, ui);
    let mut command = None;
    if response.clicked() {
        let held = ui.input(|input| input.modifiers);
        command = under.map(|tag| match tag {
            Tag::Pixel { x, y } if held.command => Command::FocusOnPolygonAt { x, y },
            Tag::Pixel { y, .. } if held.shift => Command::Click(Tag::ScanLine(y as i32)),
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
    if matches!(panel, Panel::Rays | Panel::Vectors) {
        command = drag::dragged(session, panel, &response, ui).or(command);
    }
    if panel == Panel::RayTree {
        command = tree_controls::pointed(session, &response, ui).or(command);
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
    Shown { command, under }
}
