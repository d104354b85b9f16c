//! The whole window, in a function of `&mut Ui`: it needs no screen, and tests show it as the screen would.

use super::session::{Command, Session};
use super::tiles::{GAP, panel_on};
use super::window_state::Window;
use super::{
    forget, home, key_sheet, narration, parameter_card, pressed, skipped, strings, study_view,
    style, top_bar, transport,
};
use crate::panels::Panel;
use egui::{CursorIcon, Frame, Id, Margin, Popup, Rect, Sense, Stroke, Ui, ViewportCommand};
use std::time::Duration;

/// How long to wait before looking whether more of the whole picture has come in.
const LOOK_AGAIN: Duration = Duration::from_millis(30);

/// Shows the window, and carries out what the user does in it.
pub fn ui(session: &mut Session, window: &mut Window, ui: &mut Ui) {
    let ctx = ui.ctx().clone();
    for command in pressed::pressed(session, &ctx) {
        window.carry_out(session, command);
    }
    close_menus(&ctx);
    window.play_on(session, &ctx);
    session.take_picture();
    session.take_findings();
    if session.awaits_picture() {
        ctx.request_repaint_after(LOOK_AGAIN);
    }
    window.keep_up(session, &ctx);

    let mut commands = Vec::new();
    let mut under_pointer = None;
    let size = ui.available_size();
    top_bar::show(session, &mut commands, ui);
    if session.look.home {
        let notice = window.notice.as_deref();
        home::show(session, &mut window.home, notice, &mut commands, ui);
        return window.finish(session, commands, &ctx);
    }
    window.home.close();
    if session.studying().is_open {
        study_view::show(session, &mut window.study_plot, &mut commands, ui);
        return window.finish(session, commands, &ctx);
    }
    let margin = Margin::same(GAP as i8);

    let height = (0.24 * size.y).clamp(150.0, 210.0);
    egui::Panel::bottom("time line")
        .exact_size(height)
        .frame(Frame::new().inner_margin(Margin { top: 0, ..margin }))
        .show_separator_line(false)
        .show(ui, |ui| {
            ui.set_min_size(ui.available_size());
            style::card(session.look.theme, ui.max_rect(), ui);
            let mut rect = ui.max_rect();
            rect.max.y = transport::show(session, window, &mut commands, rect, ui);
            let rect = Rect::from_min_max(rect.left_bottom(), ui.max_rect().max).shrink(4.0);
            let view = window.views.entry(Panel::TimeLine).or_default();
            let shown = panel_on(session, Panel::TimeLine, view, rect, ui);
            commands.extend(shown.command);
            under_pointer = shown.under.or(under_pointer);
        });

    // A small window may narrow the column for a while; what was chosen stays.
    let usual = (0.27 * size.x).clamp(250.0, 460.0);
    let limits = 230.0..=(0.45 * size.x).max(230.0);
    let width = window.layout.column.unwrap_or(usual);
    let column = egui::Panel::left("narration")
        .resizable(false)
        .exact_size(width.clamp(*limits.start(), *limits.end()))
        .frame(Frame::new().inner_margin(Margin {
            right: (GAP / 2.0) as i8,
            ..margin
        }))
        .show_separator_line(false)
        .show(ui, |ui| {
            let under = narration::show(session, window, &mut commands, ui);
            under_pointer = under.or(under_pointer);
        });

    egui::CentralPanel::no_frame()
        .frame(Frame::new().inner_margin(Margin {
            left: (GAP / 2.0) as i8,
            ..margin
        }))
        .show(ui, |ui| {
            let whole = ui.max_rect();
            if let Some(height) = parameter_card::height(session, whole.width()) {
                let card = Rect::from_min_size(whole.min, egui::vec2(whole.width(), height));
                parameter_card::show(session, &mut commands, card, ui);
                ui.allocate_space(egui::vec2(whole.width(), height + GAP));
            }
            window.arrangement.show(
                session,
                &mut window.views,
                &mut commands,
                &mut under_pointer,
                ui,
            );
        });
    if let Some(width) = dragged_border(column.response.rect, ui) {
        window.layout.column = Some(width.clamp(*limits.start(), *limits.end()));
    }
    if under_pointer != session.hovered() {
        commands.push(Command::Hover(under_pointer));
    }
    window.finish(session, commands, &ctx);
}

impl Window {
    /// Shows what lies over everything, and carries out what the user did.
    fn finish(&mut self, session: &mut Session, mut commands: Vec<Command>, ctx: &egui::Context) {
        if session.look.keys {
            key_sheet::show(session, &mut commands, ctx);
        }
        if session.look.skipped {
            skipped::show(session, &mut commands, ctx);
        }
        if session.look.forgetting {
            forget::show(session, &mut commands, ctx);
        }
        let acted = !commands.is_empty();
        for command in commands {
            self.carry_out(session, command);
        }
        if acted {
            ctx.request_repaint();
        }
        self.keep(session, ctx);
    }

    fn carry_out(&mut self, session: &mut Session, command: Command) {
        let quiet = matches!(command, Command::Hover(_));
        if command == Command::Forget
            && let Some(keeper) = &mut self.keeper
        {
            keeper.forget();
        }
        let step = (session.recording(), session.step());
        let result = session.update(command);
        if !quiet {
            self.notice = result
                .err()
                .map(|refused| refused.in_language(session.look.language).to_owned());
        }
        if step != (session.recording(), session.step()) {
            self.answer.clear();
            self.misread = false;
        }
    }

    /// Lets playing go on by the time that has passed.
    fn play_on(&mut self, session: &mut Session, ctx: &egui::Context) {
        let now = ctx.input(|input| input.time);
        let passed = self.time.map_or(0.0, |time| now - time);
        self.time = session.playing().is_some().then_some(now);
        session.advance(passed);
        if session.playing().is_some() {
            ctx.request_repaint_after(Duration::from_secs_f64(1.0 / session.speed().min(60.0)));
        }
    }

    /// Tells egui and the system what has changed in the session.
    fn keep_up(&mut self, session: &mut Session, ctx: &egui::Context) {
        let look = session.look;
        if self.styled != Some(look.theme) {
            style::apply(ctx, look.theme);
            self.styled = Some(look.theme);
        }
        if ctx.zoom_factor() != look.zoom() {
            ctx.set_zoom_factor(look.zoom());
        }
        if self.full_screen != look.presenting {
            self.full_screen = look.presenting;
            ctx.send_viewport_cmd(ViewportCommand::Fullscreen(look.presenting));
        }
        let title = session.window_title();
        if self.title != title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
        if let Some(command) = session.shared.take() {
            let shared = strings::SHARED.format(session.look.language, &[("command", &command)]);
            self.notice = Some(shared);
            ctx.copy_text(command);
        }
    }
}

/// Lets the right border of the column be dragged, as those between the tiles can be; returns the width it is dragged to.
fn dragged_border(column: Rect, ui: &mut Ui) -> Option<f32> {
    let x = column.right();
    let border = Rect::from_x_y_ranges(x - GAP / 2.0..=x + GAP / 2.0, column.y_range());
    let response = ui
        .interact(border, Id::unique("column border"), Sense::DRAG)
        .on_hover_and_drag_cursor(CursorIcon::ResizeHorizontal);
    if response.hovered() || response.dragged() {
        let color = ui.visuals().selection.stroke.color;
        ui.painter()
            .vline(x, column.y_range(), Stroke::new(2.0, color));
    }
    let pointer = response
        .interact_pointer_pos()
        .filter(|_| response.dragged())?;
    Some(pointer.x - column.left())
}

/// Closes open menus when the pointer is let go elsewhere: egui itself does so for short clicks only.
fn close_menus(ctx: &egui::Context) {
    let let_go = ctx.input(|input| {
        let pointer = &input.pointer;
        (pointer.any_released() && !pointer.any_click()).then(|| pointer.interact_pos())
    });
    let layer = let_go.flatten().and_then(|pos| ctx.layer_id_at(pos));
    if layer.is_some_and(|layer| layer.order <= egui::Order::Middle) {
        Popup::close_all(ctx);
    }
}
