//! The page of classic mistakes: of each a right and a wrong picture, what is wrong, and what to look for. A click makes it in a walk.

use super::background::{Job, Work};
use super::prose::set;
use super::session::{Command, Session};
use super::{strings, style};
use crate::language::called;
use crate::methods::Mistake;
use crate::picture::Ink;
use crate::render::{Cancelled, render_unless};
use crate::study::against::{screen_pixels, with_mistake};
use crate::study::mistakes::Workers;
use egui::epaint::Galley;
use egui::{
    Color32, ColorImage, Context, CursorIcon, FontId, Frame, Margin, Rect, Role, ScrollArea, Sense,
    Stroke, StrokeKind, TextureHandle, TextureOptions, Ui, WidgetInfo, vec2,
};
use std::collections::HashMap;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Between cards.
const GAP: f32 = 12.0;
/// Between what a card shows and its frame.
const MARGIN: f32 = 8.0;
/// A card is at least this wide.
const CARD: f32 = 290.0;
/// Of a picture, in pixels.
const SIZE: [u32; 2] = [192, 144];
/// Of the names of the two pictures.
const NAMES: f32 = 18.0;

/// What the page keeps from frame to frame.
#[derive(Default)]
pub struct MistakesPage {
    /// Right and wrong.
    made: HashMap<Mistake, [TextureHandle; 2]>,
    making: Option<Work<DrawnMistake>>,
}

struct DrawnMistake {
    mistake: Mistake,
    /// Right and wrong.
    pictures: [ColorImage; 2],
}

impl MistakesPage {
    /// Takes what has been drawn, and lets what is missing be drawn.
    fn bring_on(&mut self, ctx: &Context) {
        let making = self.making.get_or_insert_with(|| {
            let all = Mistake::GROUPS.iter().flat_map(|(_, group)| *group);
            let missing = all.filter(|mistake| !self.made.contains_key(mistake));
            let jobs = missing.map(|&mistake| job(mistake, ctx.clone()));
            Work::begin_all("mistakes", jobs.collect())
        });
        for DrawnMistake { mistake, pictures } in making.take() {
            let textures = pictures
                .map(|picture| ctx.load_texture(mistake.name(), picture, TextureOptions::LINEAR));
            self.made.insert(mistake, textures);
        }
    }

    /// Draws no more for now: other pictures are wanted sooner.
    pub fn close(&mut self) {
        self.making = None;
    }

    /// Waits until all pictures are drawn.
    #[cfg(test)]
    pub fn wait(&mut self, ctx: &Context) {
        self.bring_on(ctx);
        let made = self.making.as_mut().map(Work::wait);
        let all = made.into_iter().flatten();
        let textures = all.map(|made| {
            let load = |picture| ctx.load_texture("made", picture, TextureOptions::LINEAR);
            (made.mistake, made.pictures.map(load))
        });
        self.made.extend(textures.collect::<Vec<_>>());
    }

    #[cfg(test)]
    pub fn drawn(&self) -> usize {
        self.made.len()
    }
}

/// Draws the example of a mistake.
fn job(mistake: Mistake, ctx: Context) -> Job<DrawnMistake> {
    Box::new(move |worker| {
        if let Some(pictures) = pictures(mistake, &|| worker.go_on()) {
            worker.send(DrawnMistake { mistake, pictures });
            ctx.request_repaint();
        }
    })
}

/// None where they are called off.
fn pictures(
    mistake: Mistake,
    go_on: &(dyn Fn() -> Result<(), Cancelled> + Sync),
) -> Option<[ColorImage; 2]> {
    let (setup, method) = mistake.example(SIZE)?;
    let threads = NonZeroUsize::MIN;
    let right = render_unless(&setup, method, threads, |_, _| go_on()).ok()?;
    let workers = Workers { threads, go_on };
    let (wrong, found) = with_mistake(mistake, (&setup, method), &right, 0.0, workers)?;
    let image = |pixels: &[[f64; 3]]| {
        let bytes = screen_pixels(pixels, false);
        ColorImage::from_rgb(SIZE.map(|side| side as usize), bytes.as_flattened())
    };
    Some([image(&found.reference), image(&wrong.pixels)])
}

pub fn show(session: &Session, page: &mut MistakesPage, commands: &mut Vec<Command>, ui: &mut Ui) {
    page.bring_on(ui.ctx());
    let frame = Frame::new().inner_margin(Margin::symmetric(18, 0));
    egui::CentralPanel::no_frame().frame(frame).show(ui, |ui| {
        ui.add_space(14.0);
        let language = session.look.language;
        ui.label(style::strong(session.localize(strings::MISTAKES), 19.0));
        ui.label(session.localize(strings::MISTAKES_HOW));
        ui.add_space(4.0);
        ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            for (group, mistakes) in Mistake::GROUPS {
                ui.add_space(8.0);
                let title = called("mistake-group", group, language).unwrap_or_default();
                ui.label(style::strong(title, 16.0));
                ui.add_space(4.0);
                cards(session, page, mistakes, commands, ui);
            }
            ui.add_space(GAP);
        });
    });
}

/// The cards of a group, in rows; those of a row are as high as the highest.
fn cards(
    session: &Session,
    page: &MistakesPage,
    mistakes: &[Mistake],
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    // The scroll bar lies over the right edge.
    let room = ui.available_width() - 8.0;
    let columns = (((room + GAP) / (CARD + GAP)) as usize).max(1);
    let width = ((room + GAP) / columns as f32 - GAP).floor();
    for row in mistakes.chunks(columns) {
        let words: Vec<Words> = row
            .iter()
            .map(|&mistake| Words::of(session, mistake, width - 2.0 * MARGIN, ui))
            .collect();
        let height = words.iter().map(Words::height).fold(0.0, f32::max);
        let height = picture_height(width) + NAMES + height + 3.0 * MARGIN;
        let (_, place) = ui.allocate_space(vec2(room, height));
        for (column, (&mistake, words)) in row.iter().zip(&words).enumerate() {
            let corner = place.min + vec2(column as f32 * (width + GAP), 0.0);
            let card = Rect::from_min_size(corner, vec2(width, height));
            let textures = page.made.get(&mistake);
            if one(session, (mistake, words), textures, card, ui) {
                commands.push(Command::ShowMistake(mistake));
            }
        }
        ui.add_space(GAP - ui.spacing().item_spacing.y);
    }
}

fn picture_width(card: f32) -> f32 {
    (card - 3.0 * MARGIN) / 2.0
}

fn picture_height(card: f32) -> f32 {
    (picture_width(card) * SIZE[1] as f32 / SIZE[0] as f32).round()
}

/// What stands under the pictures.
struct Words {
    title: Arc<Galley>,
    about: Arc<Galley>,
}

impl Words {
    fn of(session: &Session, mistake: Mistake, width: f32, ui: &Ui) -> Self {
        let language = session.look.language;
        let laid = |text: &str, font, ink| {
            let mut job = set(session, text, font, ink);
            job.wrap.max_width = width;
            ui.ctx().fonts_mut(|fonts| fonts.layout_job(job))
        };
        let bold = FontId::new(14.0, style::bold());
        Words {
            title: laid(&mistake.title(language), bold, Ink::Text),
            about: laid(
                &mistake.about(language),
                FontId::proportional(12.5),
                Ink::Muted,
            ),
        }
    }

    fn height(&self) -> f32 {
        self.title.size().y + 2.0 + self.about.size().y
    }
}

/// A card that fills `rect`; returns whether it is clicked.
fn one(
    session: &Session,
    (mistake, words): (Mistake, &Words),
    textures: Option<&[TextureHandle; 2]>,
    rect: Rect,
    ui: &mut Ui,
) -> bool {
    let response = ui.interact(rect, ui.scope_id().with(mistake), Sense::click());
    let language = session.look.language;
    let title = mistake.title(language);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &title));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_description(mistake.about(language));
    });
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    if !ui.is_rect_visible(rect) {
        return response.clicked();
    }
    let theme = session.look.theme;
    style::card(theme, rect, ui);
    let size = vec2(picture_width(rect.width()), picture_height(rect.width()));
    let names = [strings::WHAT_IF_RIGHT, strings::WHAT_IF_WRONG];
    for (index, name) in names.into_iter().enumerate() {
        let across = MARGIN + index as f32 * (size.x + MARGIN);
        let corner = rect.min + vec2(across, MARGIN);
        let font = FontId::proportional(11.5);
        let muted = style::color(theme, Ink::Muted);
        let name = session.localize(name).to_owned();
        let align = egui::Align2::LEFT_TOP;
        ui.painter().text(corner, align, name, font, muted);
        let place = Rect::from_min_size(corner + vec2(0.0, NAMES), size);
        match textures {
            None => {
                let faint = style::color(theme, Ink::Faint);
                ui.painter().rect_filled(place, 0.0, faint);
            }
            Some(textures) => {
                let whole = Rect::from_min_max(egui::Pos2::ZERO, egui::pos2(1.0, 1.0));
                let id = textures[index].id();
                ui.painter().image(id, place, whole, Color32::WHITE);
            }
        }
    }
    let below = rect.min + vec2(MARGIN, 2.0 * MARGIN + NAMES + size.y);
    let height = words.title.size().y + 2.0;
    let painter = ui.painter();
    painter.galley(below, words.title.clone(), Color32::PLACEHOLDER);
    painter.galley(
        below + vec2(0.0, height),
        words.about.clone(),
        Color32::PLACEHOLDER,
    );
    if response.hovered() || response.has_focus() {
        let width = if response.has_focus() { 3.0 } else { 1.5 };
        let stroke = Stroke::new(width, style::color(theme, Ink::Linked));
        painter.rect_stroke(rect, 6.0, stroke, StrokeKind::Inside);
    }
    response.on_hover_cursor(CursorIcon::PointingHand).clicked()
}
