//! The user's own picture beside ours: how far off it is, what explains that, and where. A click on a pixel walks our run of it.

use super::prose::prose;
use super::session::{Against, Command, Session};
use super::tree_controls::looked_at;
use super::{strings, style};
use crate::algorithms::focus::Focus;
use crate::language::{Language, Message};
use crate::panels::{ImageView, image_middle};
use crate::picture::{self, Ink, Tag};
use crate::study::against::{Comparison, Worst, difference, screen_pixels};
use egui::{
    Button, ColorImage, Pos2, ProgressBar, Rect, Response, RichText, ScrollArea, Sense,
    TextureHandle, TextureOptions, Ui, UiBuilder, Vec2, WidgetInfo,
};
use glam::Vec2 as Point;

const TEXT: f32 = 13.0;

/// One of the three pictures, with its pixels.
type Named = (Message, fn(&Against, &Comparison) -> Vec<[u8; 3]>);

const MINE: Named = (strings::COMPARE_MINE, |against, _| {
    screen_pixels(&against.mine.pixels, against.mine.is_float)
});
const REFERENCE: Named = (strings::COMPARE_REFERENCE, |against, found| {
    screen_pixels(&found.reference, against.mine.is_float)
});
const DIFFERENCE: Named = (strings::COMPARE_DIFFERENCE, |against, found| {
    difference(&against.mine.pixels, found)
});

/// Shows the comparison in `rect`.
pub fn show(session: &Session, commands: &mut Vec<Command>, rect: Rect, ui: &mut Ui) {
    let Some(against) = session.against() else {
        return;
    };
    let mut ui = ui.new_child(UiBuilder::new().max_rect(rect.shrink2(egui::vec2(8.0, 2.0))));
    ScrollArea::vertical()
        .auto_shrink(false)
        .show(&mut ui, |ui| {
            ui.spacing_mut().item_spacing.y = 4.0;
            ui.label(style::strong(&against.name, TEXT));
            if session.panel_input().is_pending() {
                ui.label(session.localize(strings::AFTER_YOUR_ANSWER));
                return;
            }
            let Some(found) = &against.found else {
                ui.label(session.localize(strings::COMPARE_DRAWING));
                return;
            };
            figures(session, found, ui);
            mistakes(session, against, found, ui);
            pictures(session, (against, found), commands, ui);
            worst(session, found, commands, ui);
        });
}

/// Size, encoding, and how far off it is.
fn figures(session: &Session, found: &Comparison, ui: &mut Ui) {
    let language = session.look.language;
    let [width, height] = found.size;
    let size = format!("{width} × {height}");
    let encoding = match found.encoding {
        "linear" => session.localize(strings::COMPARE_LINEAR),
        _ => "sRGB",
    };
    let words = [("size", size.as_str()), ("encoding", encoding)];
    let mut said = strings::COMPARE_SIZE_IS.format(language, &words);
    said.push(' ');
    said += &match found.off {
        0 => session.localize(strings::COMPARE_EQUAL).to_owned(),
        off => {
            let [off, pixels] = [off, found.pixels].map(|count| count.to_string());
            let [largest, rms] =
                [found.largest, found.rms].map(|value| language.significant(value, 3));
            let words = [
                ("off", off.as_str()),
                ("pixels", &pixels),
                ("largest", &largest),
                ("rms", &rms),
            ];
            strings::COMPARE_OFF.format(language, &words)
        }
    };
    ui.label(prose(session, &said, TEXT, Ink::Text));
}

/// What explains the difference, best first.
fn mistakes(session: &Session, against: &Against, found: &Comparison, ui: &mut Ui) {
    if let Some(percent) = against.percent() {
        let percent_written = percent.to_string();
        let words = [("percent", percent_written.as_str())];
        let said = strings::COMPARE_TRYING.format(session.look.language, &words);
        ui.add(ProgressBar::new(percent as f32 / 100.0).text(RichText::new(said).size(TEXT)));
        return;
    }
    if found.off > 0 && found.mistakes.is_empty() {
        ui.label(session.localize(strings::COMPARE_NO_MISTAKE));
    }
    for mistake in &found.mistakes {
        let name = mistake.mistake.in_words(session.look.language);
        let [explains, of] = [mistake.explains, mistake.of].map(|count| count.to_string());
        let words = [
            ("mistake", name.as_str()),
            ("explains", &explains),
            ("of", &of),
        ];
        let said = strings::COMPARE_EXPLAINS.format(session.look.language, &words);
        ui.label(prose(session, &said, TEXT, Ink::This));
    }
}

/// The difference large, and the two pictures above it.
fn pictures(
    session: &Session,
    of: (&Against, &Comparison),
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    const GAP: f32 = 6.0;
    let [width, height] = of.1.size.map(|length| length as f32);
    let whole = ui.available_width();
    let size = |width_shown: f32| egui::vec2(width_shown, width_shown * height / width);
    let half = (whole - GAP) / 2.0;
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = GAP;
        for named in [MINE, REFERENCE] {
            ui.allocate_ui(egui::vec2(half, 0.0), |ui| {
                ui.vertical(|ui| one(session, of, named, size(half), commands, ui));
            });
        }
    });
    one(session, of, DIFFERENCE, size(whole), commands, ui);
}

/// A picture under its name: the wheel and dragging move all three and the image panel.
fn one(
    session: &Session,
    of: (&Against, &Comparison),
    (name, pixels): Named,
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
        let share = Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / pixels_of(of.1);
        let at = rect.min + (share - part.min.to_vec2()) / part.size() * rect.size();
        let stroke = egui::Stroke::new(2.0, style::color(theme, Ink::This));
        ui.painter()
            .with_clip_rect(rect)
            .circle_stroke(at, 5.0, stroke);
    }
    let area = picture::Rect::new(0.0, 0.0, rect.width(), rect.height());
    let shown = looked_at(view.shown, || Some(middle), area, &response, ui);
    commands.extend(shown.map(|shown| Command::ViewImage(ImageView { shown, ..view })));
    let Some((x, y)) = pixel_under(&response, part, of.1) else {
        return;
    };
    if response.clicked() {
        commands.push(Command::Go(Tag::Pixel { x, y }));
    }
    let index = (y * of.1.size[0] + x) as usize;
    let here = Worst {
        x,
        y,
        mine: of.0.mine.pixels[index],
        reference: of.1.reference[index],
    };
    response.on_hover_text_at_pointer(values(&here, session.look.language));
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

/// Uploaded when the comparison has brought something new.
fn texture(
    (against, found): (&Against, &Comparison),
    name: &str,
    pixels: fn(&Against, &Comparison) -> Vec<[u8; 3]>,
    ui: &Ui,
) -> TextureHandle {
    let id = egui::Id::unique(("against", name));
    let known: Option<(u64, TextureHandle)> = ui.data(|data| data.get_temp(id));
    if let Some((version, texture)) = known
        && version == against.version
    {
        return texture;
    }
    let size = found.size.map(|length| length as usize);
    let image = ColorImage::from_rgb(size, pixels(against, found).as_flattened());
    let texture = ui.ctx().load_texture(name, image, TextureOptions::NEAREST);
    ui.data_mut(|data| data.insert_temp(id, (against.version, texture.clone())));
    texture
}

/// The pixels that are furthest off, as ways to their runs.
fn worst(session: &Session, found: &Comparison, commands: &mut Vec<Command>, ui: &mut Ui) {
    if found.worst.is_empty() {
        return;
    }
    ui.label(style::strong(
        session.localize(strings::COMPARE_WORST),
        12.0,
    ));
    let linked = style::color(session.look.theme, Ink::Linked);
    for worst in &found.worst {
        let text = values(worst, session.look.language);
        let text = RichText::new(text).size(12.0).color(linked);
        let row = Button::new(text).frame_when_inactive(false).wrap();
        if ui.add(row).clicked() {
            let (x, y) = (worst.x, worst.y);
            commands.push(Command::Go(Tag::Pixel { x, y }));
        }
    }
}

/// A pixel in both pictures, in the numbers of the file.
fn values(pixel: &Worst, language: Language) -> String {
    let [mine, reference] = [pixel.mine, pixel.reference]
        .map(|color| language.list(color.map(|channel| language.fixed(channel, 3))));
    let [x, y] = [pixel.x, pixel.y].map(|place| place.to_string());
    let words = [
        ("x", x.as_str()),
        ("y", &y),
        ("mine", &mine),
        ("reference", &reference),
    ];
    strings::COMPARE_PIXEL.format(language, &words)
}
