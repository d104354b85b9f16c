//! Two pictures of the same scene and their difference: a click on a pixel walks our run of it.

use super::said_beside::said_beside;
use super::session::{Command, Session};
use super::tree_controls::looked_at;
use super::{strings, style};
use crate::algorithms::focus::Focus;
use crate::color::StoredImage;
use crate::language::{Language, Message};
use crate::panels::{ImageView, image_middle};
use crate::picture::{self, Ink, Tag};
use crate::study::against::{Comparison, Worst, difference, screen_pixels};
use egui::{
    Button, ColorImage, Pos2, Rect, Response, RichText, Sense, TextureHandle, TextureOptions, Ui,
    Vec2, WidgetInfo,
};
use glam::Vec2 as Point;

/// What is compared with ours, and how it is called.
#[derive(Clone, Copy)]
pub struct Compared<'a> {
    pub mine: &'a StoredImage,
    pub found: &'a Comparison,
    /// Another one for other pixels.
    pub version: u64,
    pub names: &'a Names,
}

/// What the pictures are called, and how a pixel of both is written.
pub struct Names {
    pub mine: Message,
    pub reference: Message,
    pub difference: Message,
    pub pixel: Message,
}

/// The pixels of one of the three pictures.
type Pixels = fn(&Compared) -> Vec<[u8; 3]>;

fn mine(of: &Compared) -> Vec<[u8; 3]> {
    screen_pixels(&of.mine.pixels, of.mine.is_float)
}

fn reference(of: &Compared) -> Vec<[u8; 3]> {
    screen_pixels(&of.found.reference, of.mine.is_float)
}

fn signed_difference(of: &Compared) -> Vec<[u8; 3]> {
    difference(&of.mine.pixels, of.found)
}

/// A share in percent.
pub fn percent(some: usize, all: usize, language: Language) -> String {
    language.significant(100.0 * some as f64 / all.max(1) as f64, 2)
}

/// How many pixels are off, and by how much.
pub fn figures(found: &Comparison, language: Language) -> String {
    let [off, pixels] = [found.off, found.pixels].map(|count| count.to_string());
    let [largest, rms] = [found.largest, found.rms].map(|value| language.significant(value, 3));
    let share = percent(found.off, found.pixels, language);
    let words = [
        ("off", off.as_str()),
        ("share", &share),
        ("pixels", &pixels),
        ("largest", &largest),
        ("rms", &rms),
    ];
    strings::COMPARE_OFF.format(language, &words)
}

/// The difference large, and the two pictures above it.
pub fn pictures(session: &Session, of: Compared, commands: &mut Vec<Command>, ui: &mut Ui) {
    const GAP: f32 = 6.0;
    let [width, height] = of.found.size.map(|length| length as f32);
    let whole = ui.available_width();
    let size = |width_shown: f32| egui::vec2(width_shown, width_shown * height / width);
    let half = (whole - GAP) / 2.0;
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        let names = of.names;
        for named in [(names.mine, mine as Pixels), (names.reference, reference)] {
            ui.allocate_ui(egui::vec2(half, 0.0), |ui| {
                ui.vertical(|ui| one(session, of, named, size(half), commands, ui));
            });
        }
    });
    let named = (of.names.difference, signed_difference as Pixels);
    one(session, of, named, size(whole), commands, ui);
}

/// A picture under its name: the wheel and dragging move all three and the image panel.
fn one(
    session: &Session,
    of: Compared,
    (name, pixels): (Message, Pixels),
    size: Vec2,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let name = session.localize(name);
    ui.label(style::strong(name, 12.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(egui::Role::Image, true, name));
    let input = session.panel_input();
    let view = session.image();
    let middle = image_middle(&input);
    let half = 0.5 / view.shown.zoom;
    let part = Rect::from_center_size(Pos2::new(middle.x, middle.y), Vec2::splat(2.0 * half));
    let texture = texture(of, name, pixels, ui);
    let white = egui::Color32::WHITE;
    ui.painter().image(texture.id(), rect, part, white);
    let theme = session.look.theme;
    if let Focus::Pixel { x, y } = session.focus() {
        let share = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / pixels_of(of.found);
        let at = rect.min + (share - part.min.to_vec2()) / part.size() * rect.size();
        let stroke = egui::Stroke::new(2.0, style::color(theme, Ink::This));
        ui.painter()
            .with_clip_rect(rect)
            .circle_stroke(at, 5.0, stroke);
    }
    let area = picture::Rect::new(0.0, 0.0, rect.width(), rect.height());
    let shown = looked_at(view.shown, || Some(middle), area, &response, ui);
    commands.extend(shown.map(|shown| Command::ViewImage(ImageView { shown, ..view })));
    let Some((x, y)) = pixel_under(&response, part, of.found) else {
        return;
    };
    if response.clicked() {
        commands.push(Command::Go(Tag::Pixel { x, y }));
    }
    let index = (y * of.found.size[0] + x) as usize;
    let here = Worst {
        x,
        y,
        mine: of.mine.pixels[index],
        reference: of.found.reference[index],
    };
    let text = values(&here, of.names, session.look.language);
    said_beside(&response, None, text);
}

fn pixels_of(found: &Comparison) -> Vec2 {
    let [width, height] = found.size.map(|length| length as f32);
    Vec2::new(width, height)
}

fn pixel_under(response: &Response, part: Rect, found: &Comparison) -> Option<(u32, u32)> {
    let at = response.interact_pointer_pos().or(response.hover_pos())?;
    let share = part.min.to_vec2() + (at - response.rect.min) / response.rect.size() * part.size();
    let pixel = share * pixels_of(found);
    let [width, height] = found.size;
    let inside = Point::new(pixel.x, pixel.y).cmpge(Point::ZERO).all();
    let (x, y) = (pixel.x as u32, pixel.y as u32);
    (inside && x < width && y < height).then_some((x, y))
}

/// Uploaded when there is something new.
fn texture(of: Compared, name: &str, pixels: Pixels, ui: &Ui) -> TextureHandle {
    let id = egui::Id::unique(("compared", name));
    let known: Option<(u64, TextureHandle)> = ui.data(|data| data.get_temp(id));
    if let Some((version, texture)) = known
        && version == of.version
    {
        return texture;
    }
    let size = of.found.size.map(|length| length as usize);
    let image = ColorImage::from_rgb(size, pixels(&of).as_flattened());
    let texture = ui.ctx().load_texture(name, image, TextureOptions::NEAREST);
    ui.data_mut(|data| data.insert_temp(id, (of.version, texture.clone())));
    texture
}

/// The pixels that are furthest off, as ways to their runs.
pub fn worst(session: &Session, of: Compared, commands: &mut Vec<Command>, ui: &mut Ui) {
    if of.found.worst.is_empty() {
        return;
    }
    ui.label(style::strong(
        session.localize(strings::COMPARE_WORST),
        12.0,
    ));
    let linked = style::color(session.look.theme, Ink::Linked);
    for worst in &of.found.worst {
        let text = values(worst, of.names, session.look.language);
        let text = RichText::new(text).size(12.0).color(linked);
        let row = Button::new(text).frame_when_inactive(false).wrap();
        if ui.add(row).clicked() {
            let (x, y) = (worst.x, worst.y);
            commands.push(Command::Go(Tag::Pixel { x, y }));
        }
    }
}

/// A pixel in both pictures, in the numbers of the file.
fn values(pixel: &Worst, names: &Names, language: Language) -> String {
    let [mine, reference] = [pixel.mine, pixel.reference]
        .map(|color| language.list(color.map(|channel| language.fixed(channel, 3))));
    let [x, y] = [pixel.x, pixel.y].map(|place| place.to_string());
    let words = [
        ("x", x.as_str()),
        ("y", &y),
        ("mine", &mine),
        ("reference", &reference),
    ];
    names.pixel.format(language, &words)
}
