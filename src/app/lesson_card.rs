//! A lesson in the list: its picture, what it is about, and how far one has come.

use super::prose::{prose, set};
use super::session::{Listed, Session};
use super::thumbnails::Thumbnail;
use super::{strings, style};
use crate::picture::Ink;
use egui::epaint::RectShape;
use egui::text::LayoutJob;
use egui::{
    Color32, CornerRadius, FontId, Pos2, Rect, Response, Role, Sense, Stroke, StrokeKind, Ui,
    WidgetInfo,
};

/// Of the words under the picture.
const WORDS: f32 = 142.0;
/// Between the frame and the words.
const MARGIN: f32 = 10.0;
/// Of the line under the picture that shows how far one has come.
const BAR: f32 = 4.0;

/// Of a card, by its width.
pub fn height(width: f32) -> f32 {
    (0.75 * width).round() + WORDS
}

/// Shows a card that fills `rect`.
pub fn show(
    session: &Session,
    listed: &Listed,
    thumbnail: Option<&Thumbnail>,
    rect: Rect,
    ui: &mut Ui,
) -> Response {
    let id = ui.scope_id().with(&listed.id);
    let response = ui.interact(rect, id, Sense::click());
    let language = session.look.language as usize;
    let (title, summary) = (&listed.title[language], &listed.summary[language]);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, title));
    let [reached, score] = state(session, listed);
    let description = [summary, &reached, &score].map(String::as_str).join(". ");
    ui.ctx()
        .accesskit_node_builder(response.id, |node| node.set_description(description));
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let theme = session.look.theme;
    style::card(theme, rect, ui);
    let mut above = rect.shrink(1.0);
    above.max.y = rect.max.y - WORDS;
    picture(session, thumbnail, above, ui);
    bar(session, listed, above, ui);

    let words = Rect::from_min_max(above.left_bottom(), rect.max).shrink(MARGIN);
    let bold = FontId::new(14.0, style::bold());
    let job = set(session, title, bold, Ink::Text);
    let title_height = text(job, 2, words, words.min, ui);
    let below = words.min + egui::vec2(0.0, title_height + 2.0);
    let lines = if title_height > 28.0 { 3 } else { 4 };
    text(
        said(session, listed, 12.5, Ink::Muted),
        lines,
        words,
        below,
        ui,
    );
    let small = FontId::proportional(12.0);
    let line = words.max.y - 15.0;
    let reached = set(session, &reached, small.clone(), Ink::Text);
    text(reached, 1, words, Pos2::new(words.min.x, line), ui);
    let score = set(session, &score, small, Ink::Text);
    let score = ui.ctx().fonts_mut(|fonts| fonts.layout_job(score));
    let right = Pos2::new(words.max.x - score.size().x, line);
    ui.painter().galley(right, score, Color32::PLACEHOLDER);

    if response.hovered() || response.has_focus() {
        let width = if response.has_focus() { 3.0 } else { 1.5 };
        let stroke = Stroke::new(width, style::color(theme, Ink::Linked));
        ui.painter()
            .rect_stroke(rect, 6.0, stroke, StrokeKind::Inside);
    }
    response
        .on_hover_cursor(egui::CursorIcon::PointingHand)
        .on_hover_text(said(session, listed, 13.0, Ink::Text))
}

/// What the lesson is about, or what is wrong with it: what that quotes of the file is no notation.
fn said(session: &Session, listed: &Listed, size: f32, ink: Ink) -> LayoutJob {
    let summary = &listed.summary[session.look.language as usize];
    if !listed.has_errors {
        return prose(session, summary, size, ink);
    }
    let warn = style::color(session.look.theme, Ink::Warn);
    LayoutJob::simple(
        summary.clone(),
        FontId::proportional(size),
        warn,
        f32::INFINITY,
    )
}

/// How far one has come, and the score, in words.
fn state(session: &Session, listed: &Listed) -> [String; 2] {
    let language = session.look.language;
    if listed.has_errors {
        let errors = strings::HAS_ERRORS.text(language);
        return [errors.to_owned(), String::new()];
    }
    let count = listed.explanations.to_string();
    let Some(progress) = session.progress_in(&listed.id) else {
        let whole = strings::EXPLANATIONS.format(language, &[("count", &count)]);
        return [whole, String::new()];
    };
    let number = progress.reached.to_string();
    let reached =
        strings::EXPLANATION_OF.format(language, &[("number", &number), ("count", &count)]);
    if progress.answers.is_empty() {
        return [reached, String::new()];
    }
    let [right, asked] = [progress.right(), listed.questions].map(|count| count.to_string());
    let score = strings::SCORE.format(language, &[("right", &right), ("count", &asked)]);
    [reached, score]
}

fn picture(session: &Session, thumbnail: Option<&Thumbnail>, rect: Rect, ui: &Ui) {
    let corners = CornerRadius {
        nw: 5,
        ne: 5,
        ..CornerRadius::ZERO
    };
    let Some(thumbnail) = thumbnail else {
        let faint = style::color(session.look.theme, Ink::Faint);
        ui.painter().rect_filled(rect, corners, faint);
        return;
    };
    ui.painter()
        .rect_filled(rect, corners, thumbnail.background);
    let size = thumbnail.texture.size_vec2();
    let [across, down] = [rect.width() / size.x, rect.height() / size.y];
    // What nearly fills the card fills it, and loses a little at two sides.
    let mut scale = across.max(down);
    if scale > 1.1 * across.min(down) {
        scale = across.min(down);
    }
    let place = Rect::from_center_size(rect.center(), scale * size).intersect(rect);
    let shown = place.size() / (scale * size);
    let part = Rect::from_center_size(Pos2::new(0.5, 0.5), shown);
    let corners = match place == rect {
        true => corners,
        false => CornerRadius::ZERO,
    };
    let image = RectShape::filled(place, corners, Color32::WHITE);
    ui.painter()
        .add(image.with_texture(thumbnail.texture.id(), part));
}

/// How far one has come, as a line along the bottom of the picture.
fn bar(session: &Session, listed: &Listed, picture: Rect, ui: &Ui) {
    let Some(progress) = session.progress_in(&listed.id) else {
        return;
    };
    let theme = session.look.theme;
    let mut bar = picture;
    bar.min.y = picture.max.y - BAR;
    ui.painter()
        .rect_filled(bar, 0.0, style::color(theme, Ink::Rule));
    let part = progress.reached.min(listed.explanations) as f32 / listed.explanations.max(1) as f32;
    bar.max.x = bar.min.x + part * bar.width();
    ui.painter()
        .rect_filled(bar, 0.0, style::color(theme, Ink::Linked));
}

/// Sets at most so many lines at `at`, as wide as `within`; returns their height.
fn text(mut job: LayoutJob, lines: usize, within: Rect, at: Pos2, ui: &Ui) -> f32 {
    job.wrap.max_width = within.width();
    job.wrap.max_rows = lines;
    let galley = ui.ctx().fonts_mut(|fonts| fonts.layout_job(job));
    let height = galley.size().y;
    ui.painter().galley(at, galley, Color32::PLACEHOLDER);
    height
}
