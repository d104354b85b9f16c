//! The whole window, in a function of `&mut Ui`: it needs no screen, and tests show it as the screen would.

use super::cards::inside;
use super::layout::{self, GAP, Layout, TRANSPORT, Wishes, column_widths, is_narrow, layout};
use super::panel_on::panel_on;
use super::session::{Command, Drawer, Session, Sheet};
use super::window_state::Window;
use super::{
    cards, finished, forget, home, key_sheet, mistakes_page, narration, narrow, notice, outline,
    presentation, pressed, skipped, strings, study_view, style, top_bar, transport, unsaved,
};
use crate::panels::{Panel, time_line_heights};
use crate::picture::Tag;
use egui::{CursorIcon, Popup, Pos2, Rect, Sense, Stroke, Ui, Vec2, ViewportCommand};
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
    window.open_files(session, &ctx);
    window.open_chosen(session, &ctx);
    session.take_picture();
    session.take_findings();
    session.take_comparison();
    session.take_mistakes();
    if session.awaits_picture()
        || session.draws_mistakes()
        || session.against().is_some_and(|a| a.percent().is_some())
    {
        ctx.request_repaint_after(LOOK_AGAIN);
    }
    window.save_what_is_made(session, &ctx);
    unsaved::ask(session, window, &ctx);
    window.keep_up(session, &ctx);

    // Where another lesson takes its place meanwhile, the text is shown in it again.
    if session.is_on_page() || session.look.editing || !session.is_written() {
        window.author.documents.close();
    }
    let mut commands = Vec::new();
    if session.look.home {
        top_bar::show(session, &mut commands, ui);
        let notice = window.notice.as_deref();
        home::show(session, &mut window.home, notice, &mut commands, ui);
        window.mistakes.close();
        return window.finish(session, commands, &ctx);
    }
    window.home.close();
    let corner = ui.max_rect().max - Vec2::splat(2.0 * GAP);
    if session.look.mistakes {
        top_bar::show(session, &mut commands, ui);
        mistakes_page::show(session, &mut window.mistakes, &mut commands, ui);
        notice::show(session, window, corner, ui);
        return window.finish(session, commands, &ctx);
    }
    window.mistakes.close();
    if session.studying().is_open {
        top_bar::show(session, &mut commands, ui);
        study_view::show(session, &mut window.study_plot, &mut commands, ui);
        notice::show(session, window, corner, ui);
        return window.finish(session, commands, &ctx);
    }
    if session.look.editing
        && let Some(opened) = &window.opened
    {
        let readers = opened.readers();
        top_bar::show(session, &mut commands, ui);
        if let Err(why) = window.scene_page.show(session, readers, &mut commands, ui) {
            window.notice = Some(why);
        }
        notice::show(session, window, corner, ui);
        return window.finish(session, commands, &ctx);
    }
    window.scene_page.documents.close();
    let whole = ui.max_rect();
    let mut ui = ui.new_child(egui::UiBuilder::new().max_rect(whole));
    let between_cards = ui.visuals().panel_fill;
    ui.painter().rect_filled(whole, 0.0, between_cards);
    let under_pointer = if session.is_filled() {
        let filled = Layout::filled(whole.size());
        let filled = filled.shifted(whole.min.to_vec2());
        notice::show(session, window, whole.max - Vec2::splat(2.0 * GAP), &ui);
        cards::show(session, &mut window.views, &filled, &mut commands, &mut ui)
    } else if session.look.presenting {
        notice::show(session, window, whole.max - Vec2::splat(2.0 * GAP), &ui);
        presentation::show(session, window, whole, &mut commands, &mut ui)
    } else {
        let mut whole = whole;
        match window.embedded {
            // As if the bar stood above the window.
            true => whole.min.y -= top_bar::height(&ctx),
            false => top_bar::show(session, &mut commands, &mut ui),
        }
        let body = match style::is_for_fingers(&ctx) {
            true => narrow::show,
            false => cards_and_time_line,
        };
        body(session, window, whole, &mut commands, &mut ui)
    };
    if under_pointer != session.hovered() {
        commands.push(Command::Hover(under_pointer));
    }
    window.finish(session, commands, &ctx);
}

/// Everything below the bar; returns what lies under the pointer.
fn cards_and_time_line(
    session: &mut Session,
    window: &mut Window,
    whole: Rect,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let heights = time_line_heights(session.walk());
    let wishes = Wishes {
        column: window.borders.column,
        time_line: window.borders.time_line,
        time_line_heights: [*heights.start(), *heights.end()],
        others: session.other_panels().len(),
        drawer: session.look.drawer.map(|drawer| match drawer {
            Drawer::Author => layout::WRITING,
            _ => layout::DRAWER,
        }),
    };
    let placed = layout(whole.size(), wishes).shifted(whole.min.to_vec2());

    let mut under = narration::show(session, window, placed.column, commands, ui);
    let of_cards = cards::show(session, &mut window.views, &placed, commands, ui);
    under = of_cards.or(under);
    if let Some(rect) = placed.drawer {
        window.write_lesson(session, rect, ui);
    }

    let mut line = placed.time_line;
    style::card(session.look.theme, line, ui);
    let row = Rect::from_min_size(line.min, egui::vec2(line.width(), TRANSPORT));
    transport::show(session, window, commands, row, ui);
    line.min.y = row.max.y;
    let view = window.views.entry(Panel::TimeLine).or_default();
    let rows = line.shrink2(egui::vec2(4.0, 2.0));
    let shown = panel_on(session, Panel::TimeLine, view, rows, ui);
    commands.extend(shown.command);
    under = shown.under.or(under);

    let corner = placed.time_line.right_top() - Vec2::new(GAP, 2.0 * GAP);
    notice::show(session, window, corner, ui);

    // A small window may narrow the column for a while; what was chosen stays.
    let x = placed.column.right() + GAP / 2.0;
    let border = Rect::from_x_y_ranges(x - GAP / 2.0..=x + GAP / 2.0, placed.column.y_range());
    if let Some(at) = dragged_border(border, CursorIcon::ResizeHorizontal, ui) {
        let widths = column_widths(whole.width());
        let width = at.x - placed.column.left();
        window.borders.column = Some(width.clamp(*widths.start(), *widths.end()));
    }
    let y = placed.time_line.top() - GAP / 2.0;
    let border = Rect::from_x_y_ranges(placed.time_line.x_range(), y - GAP / 2.0..=y + GAP / 2.0);
    if let Some(at) = dragged_border(border, CursorIcon::ResizeVertical, ui) {
        let height = placed.time_line.bottom() - TRANSPORT - at.y;
        window.borders.time_line = Some(height.clamp(*heights.start(), *heights.end()));
    }
    under
}

impl Window {
    /// Shows what is written in the drawer `rect`, where that is open.
    pub(super) fn write_lesson(&mut self, session: &mut Session, rect: Rect, ui: &mut Ui) {
        let Some(opened) = self.opened.as_ref() else {
            return;
        };
        if session.look.drawer != Some(Drawer::Author) {
            return;
        }
        let readers = opened.readers();
        if let Err(why) = self.author.show(session, readers, inside(rect, ui), ui) {
            self.notice = Some(why);
        }
    }

    /// Shows what lies over everything, and carries out what the user did.
    fn finish(&mut self, session: &mut Session, mut commands: Vec<Command>, ctx: &egui::Context) {
        if session.look.keys {
            key_sheet::show(session, &mut commands, ctx);
        }
        if session.look.skipped {
            skipped::show(session, &mut commands, ctx);
        }
        match session.look.sheet {
            Some(Sheet::Forget) => forget::show(session, &mut commands, ctx),
            Some(Sheet::Outline) => outline::show(session, &mut commands, ctx),
            Some(Sheet::Finished) => finished::show(session, &mut commands, ctx),
            None => {}
        }
        let acted = !commands.is_empty();
        for command in commands {
            self.carry_out(session, command);
        }
        session.follow_pixels();
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
        if matches!(command, Command::Undo | Command::Redo) && session.is_edited() {
            let documents = match session.look.editing {
                true => &mut self.scene_page.documents,
                false => &mut self.author.documents,
            };
            return documents.go_back(session, command == Command::Redo);
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
        // A large text is no reason for large buttons.
        let size = ctx.content_rect().size() * ctx.zoom_factor();
        let styled = Some((look.theme, is_narrow(size)));
        if self.styled != styled {
            style::apply(ctx, look.theme, is_narrow(size));
            self.styled = styled;
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
        self.serve_wishes(session, ctx);
        if let Some(command) = session.shared.take() {
            let shared = match &self.address {
                Some(address) if session.has_link() => format!("{address}#{}", session.link()),
                _ => command,
            };
            let said = strings::SHARED.format(session.look.language, &[("command", &shared)]);
            self.notice = Some(said);
            ctx.copy_text(shared);
        }
    }
}

/// Lets the border between two cards be dragged; returns where the pointer holds it.
fn dragged_border(border: Rect, cursor: CursorIcon, ui: &mut Ui) -> Option<Pos2> {
    let vertical = cursor == CursorIcon::ResizeHorizontal;
    let response = ui
        .interact(
            border,
            ui.scope_id().with(("border", vertical)),
            Sense::DRAG,
        )
        .on_hover_and_drag_cursor(cursor);
    if response.hovered() || response.dragged() {
        let stroke = Stroke::new(2.0, ui.visuals().selection.stroke.color);
        let middle = border.center();
        match vertical {
            true => ui.painter().vline(middle.x, border.y_range(), stroke),
            false => ui.painter().hline(border.x_range(), middle.y, stroke),
        };
    }
    let pointer = response.interact_pointer_pos();
    pointer.filter(|_| response.dragged())
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
