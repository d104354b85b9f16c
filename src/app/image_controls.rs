//! How the picture is enlarged and moved, and what is shown of its pixels.

use super::button;
use super::session::{Command, Session};
use super::strings;
use super::tree_controls::looked_at;
use crate::figure::View;
use crate::panels::{
    ImageView, Panel, PixelLayer, comparison_place, difference_place, image_middle, image_place,
};
use egui::{Key, Response, RichText, Ui};
use glam::Vec2;

/// How much a press of a button enlarges.
const PRESS: f32 = 2.0;
/// Points that a key moves it.
const MOVE: f32 = 40.0;

/// The whole picture, larger and smaller; pictures that are compared are enlarged together.
pub fn buttons(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 4.0;
    let view = session.image();
    for (sign, shown, name) in [
        (
            session.localize(strings::TREE_FIT),
            View::WHOLE,
            strings::WHOLE_PICTURE,
        ),
        ("+", view.shown.zoomed(PRESS), strings::LARGER_PICTURE),
        (
            "−",
            view.shown.zoomed(1.0 / PRESS),
            strings::SMALLER_PICTURE,
        ),
    ] {
        let command = Command::ViewImage(ImageView { shown, ..view });
        button::sign(session, sign, name, command, commands, ui);
    }
}

/// The menu of what is shown.
pub fn menu(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let view = session.image();
    let title = session.localize(view.layer.title());
    ui.menu_button(RichText::new(format!("{title} ▾")).size(13.0), |ui| {
        for layer in layers(session) {
            let name = session.localize(layer.title());
            if ui.radio(layer == view.layer, name).clicked() {
                commands.push(Command::ViewImage(ImageView { layer, ..view }));
                ui.close();
            }
        }
    });
}

fn by_keys(view: View, middle: impl Fn() -> Vec2, size: Vec2, ui: &Ui) -> Option<View> {
    let changed = ui.input(|input| {
        let presses = |key| input.num_presses(key) as f32;
        let toward = |less, more| presses(more) - presses(less);
        let zoom = toward(Key::Minus, Key::Plus) + presses(Key::Equals);
        let view = view.zoomed(PRESS.powf(zoom));
        let across = toward(Key::ArrowLeft, Key::ArrowRight);
        let down = toward(Key::ArrowUp, Key::ArrowDown);
        match input.modifiers.alt {
            true => view.dragged(-MOVE * Vec2::new(across, down), middle(), size),
            false => view,
        }
    });
    (changed != view).then_some(changed)
}

/// What can be shown of the pixels: only some methods follow rays.
fn layers(session: &Session) -> impl Iterator<Item = PixelLayer> {
    let follows = session.panel_input().run.method().follows_rays();
    let all = PixelLayer::ALL.into_iter();
    all.filter(move |&layer| follows || layer != PixelLayer::Rays)
}

/// What the pointer and the keys do in the picture: the wheel, a pinch, + and − enlarge it; dragging, and Alt with the arrows, move it.
pub fn pointed(session: &Session, panel: Panel, response: &Response, ui: &Ui) -> Option<Command> {
    let input = session.panel_input();
    let view = session.image();
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let at = response.hover_pos().map_or(0.5 * size, |at| {
        let at = at - response.rect.min;
        Vec2::new(at.x, at.y)
    });
    let place = match panel {
        Panel::Comparison => comparison_place(&input, size, at)?,
        Panel::Difference => difference_place(&input, size, at)?,
        _ => image_place(&input, size),
    };
    let middle = || image_middle(&input);
    let shown = match response.has_focus() {
        true => by_keys(view.shown, middle, Vec2::new(place.width, place.height), ui),
        false => None,
    };
    let shown = shown.or_else(|| looked_at(view.shown, || Some(middle()), place, response, ui))?;
    Some(Command::ViewImage(ImageView { shown, ..view }))
}
