//! A panel on the screen: its picture, drawn anew only when what it depends on has changed, with the pointer on it.

use super::session::{Command, Session};
use super::strings;
use super::style;
use crate::algorithms::focus::Focus;
use crate::language::Language;
use crate::panels::{Panel, TreeView, draw};
use crate::picture::{Ink, Picture, Tag, Theme, draw_over, rasterize};
use crate::record::Value;
use egui::{
    ColorImage, Pos2, Rect, Response, Role, Sense, TextureHandle, TextureOptions, Ui, WidgetInfo,
};
use tiny_skia::Pixmap;

/// All that a panel's pixels depend on, highlights aside.
#[derive(Clone, PartialEq)]
struct Key {
    recording: u64,
    /// Of what is made in the background; always 0 where a panel does not show it.
    pictures: u64,
    step: usize,
    /// In physical pixels.
    size: [u32; 2],
    /// Pixels a point.
    scale: f32,
    theme: Theme,
    language: Language,
    breakpoints: Vec<usize>,
    /// Of the ray tree alone.
    tree: Option<TreeView>,
    /// Of the room alone.
    smooth: bool,
}

/// What is kept of a panel from frame to frame.
#[derive(Default)]
pub struct PanelView {
    key: Option<Key>,
    picture: Picture,
    /// Without highlights.
    pixels: Option<Pixmap>,
    highlighted: Vec<Tag>,
    texture: Option<TextureHandle>,
}

impl PanelView {
    /// What the picture says, in words.
    pub fn alt(&self) -> &str {
        &self.picture.alt
    }

    /// Shows the panel in `rect`. Returns the response, and what lies under the pointer.
    pub fn show(
        &mut self,
        session: &Session,
        panel: Panel,
        rect: Rect,
        ui: &mut Ui,
    ) -> (Response, Option<Tag>) {
        // Where a card cannot hold a texture of that size, the picture is a little coarser.
        let largest =
            ui.input(|input| input.max_texture_side) as f32 / rect.width().max(rect.height());
        let scale = ui.pixels_per_point().min(largest);
        // Whole pixels: each of the texture's covers one of the screen's.
        let corner = (rect.min.to_vec2() * scale).round() / scale;
        let size = (rect.size() * scale).floor().max(egui::Vec2::splat(1.0));
        let rect = Rect::from_min_size(corner.to_pos2(), size / scale);
        let key = Key {
            recording: session.recording(),
            pictures: match panel {
                Panel::Image | Panel::Race => session.pictures(),
                _ if panel.compares() => session.pictures(),
                _ => 0,
            },
            step: session.step(),
            size: [size.x as u32, size.y as u32],
            scale,
            theme: session.look.theme,
            language: session.look.language,
            breakpoints: session.breakpoints().to_vec(),
            tree: (panel == Panel::RayTree).then(|| session.tree().clone()),
            smooth: panel == Panel::Radiosity && session.look.smooth,
        };
        let mut highlighted: Vec<Tag> = session
            .hovered()
            .into_iter()
            .chain(session.lit())
            .flat_map(alike)
            .collect();
        highlighted.retain(|&tag| {
            self.picture.items.iter().any(|item| item.tag == Some(tag)) || is_place(tag)
        });
        if self.key.as_ref() != Some(&key) {
            self.picture = draw(
                panel,
                &session.panel_input(),
                glam::Vec2::new(rect.width(), rect.height()),
            );
            self.pixels = rasterize(&self.picture, key.theme, scale).ok();
            self.key = Some(key);
            self.upload(highlighted, panel, session.look.theme, scale, ui);
        } else if self.highlighted != highlighted {
            self.upload(highlighted, panel, session.look.theme, scale, ui);
        }

        let sense = if matches!(
            panel,
            Panel::TimeLine | Panel::RayTree | Panel::Rays | Panel::Vectors
        ) {
            Sense::click_and_drag()
        } else {
            Sense::click()
        };
        let response = ui.interact(rect, ui.scope_id().with(panel.name()), sense);
        let name = session.localize(panel.title());
        response.widget_info(|| WidgetInfo::labeled(Role::Image, true, name));
        ui.ctx()
            .accesskit_node_builder(response.id, |node| node.set_description(spoken(self.alt())));
        if let Some(texture) = &self.texture {
            let whole = Rect::from_min_max(Pos2::ZERO, Pos2::new(1.0, 1.0));
            ui.painter()
                .image(texture.id(), rect, whole, egui::Color32::WHITE);
        }
        if response.has_focus() {
            let stroke = egui::Stroke::new(2.0, style::color(session.look.theme, Ink::Linked));
            ui.painter()
                .rect_stroke(rect, 2.0, stroke, egui::StrokeKind::Inside);
        }
        let under = response.hover_pos().and_then(|at| {
            let at = at - rect.min;
            self.picture.hit(glam::Vec2::new(at.x, at.y))
        });
        if under.is_some() {
            ui.ctx().set_cursor_icon(egui::CursorIcon::PointingHand);
        }
        (response, under)
    }

    fn upload(&mut self, highlighted: Vec<Tag>, panel: Panel, theme: Theme, scale: f32, ui: &Ui) {
        let Some(pixels) = &self.pixels else { return };
        let size = [pixels.width() as usize, pixels.height() as usize];
        let items: Vec<_> = highlighted
            .iter()
            .flat_map(|&tag| self.picture.highlight(tag))
            .collect();
        let image = if items.is_empty() {
            ColorImage::from_rgba_premultiplied(size, pixels.data())
        } else {
            let mut lit = pixels.clone();
            draw_over(&mut lit, &items, theme, scale);
            ColorImage::from_rgba_premultiplied(size, lit.data())
        };
        self.highlighted = highlighted;
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::NEAREST),
            None => {
                self.texture = Some(ui.ctx().load_texture(
                    panel.name(),
                    image,
                    TextureOptions::NEAREST,
                ))
            }
        }
    }
}

/// Tags that name the same thing: a step, and the scope that it opens.
fn alike(tag: Tag) -> impl Iterator<Item = Tag> {
    let other = match tag {
        Tag::Step(step) => Some(Tag::Scope(step)),
        Tag::Scope(step) => Some(Tag::Step(step)),
        _ => None,
    };
    std::iter::once(tag).chain(other)
}

/// Whether a tag can be found in an image's pixels, which carry no tags of their own.
fn is_place(tag: Tag) -> bool {
    matches!(tag, Tag::Pixel { .. } | Tag::ScanLine(_))
}

/// What else can be done at a place of a picture, as a menu.
pub fn menu(session: &Session, tag: Option<Tag>, ui: &mut Ui) -> Option<Command> {
    let mut choices: Vec<(String, Command)> = Vec::new();
    if let Some(Tag::Pixel { x, y }) = tag {
        choices.push((
            crate::panels::strings::focus(Focus::Pixel { x, y }, session.look.language),
            Command::Focus(Focus::Pixel { x, y }),
        ));
        choices.push((
            strings::LINE.format(session.look.language, &[("y", &y.to_string())]),
            Command::Focus(Focus::ScanLine(y)),
        ));
        choices.push((
            session.localize(strings::POLYGON).to_owned(),
            Command::FocusOnPolygonAt { x, y },
        ));
    }
    choices.push((
        session.localize(strings::FRAME).to_owned(),
        Command::Focus(Focus::Frame),
    ));
    if !session.follows_lesson() {
        choices.push((
            session.localize(strings::THE_LESSONS_PART).to_owned(),
            Command::Focus(session.lesson().focus),
        ));
    }
    ui.label(style::strong(session.localize(strings::FOCUS_ON), 13.0));
    let chosen = choices
        .into_iter()
        .find(|(label, _)| ui.button(label).clicked());
    chosen.map(|(_, command)| command)
}

/// The part of the run that is looked at, in words.
pub fn focus_words(session: &Session) -> String {
    crate::panels::strings::focus(session.focus(), session.look.language)
}

/// Without the braces that only tell how a symbol is set.
fn spoken(text: &str) -> String {
    text.replace(['{', '}'], "")
}

/// The quiet words at the right of a panel's title.
pub fn caption(session: &Session, panel: Panel) -> String {
    let walk = session.walk();
    let whole = |name| match walk.is_empty() {
        true => None,
        false => match walk.fields(session.step()).get(name) {
            Some(Value::Integer(value)) => Some(value),
            _ => None,
        },
    };
    match panel {
        Panel::Image => session
            .picture_percent()
            .map(|percent| {
                strings::MAKING_THE_PICTURE
                    .format(session.look.language, &[("percent", &percent.to_string())])
            })
            .unwrap_or_default(),
        Panel::ScanLine => whole("y").map(|y| format!("y = {y}")).unwrap_or_default(),
        Panel::ActiveEdges => session.localize(strings::CLICK_A_ROW).to_owned(),
        Panel::Vertex => whole("vertex")
            .map(|vertex| vertex.to_string())
            .unwrap_or_default(),
        _ => String::new(),
    }
}
