//! How the scene in space is turned, moved and enlarged: by the pointer, by keys, and by a choice of places to look from.

use super::button;
use super::session::{Command, Session};
use super::strings;
use crate::algorithms::ray_tree::RayKind;
use crate::language::Message;
use crate::panels::{Orbit, Pixels, Preset, RayChoice, SpaceView, ray_kind_name};
use crate::render::Method;
use egui::{Key, PointerButton, Response, RichText, Ui};
use glam::Vec2;
use std::f32::consts::PI;

/// How much a press of a button zooms.
const PRESS: f32 = 1.3;
/// Points of the wheel that zoom to e times the size.
const WHEEL: f32 = 300.0;
/// How far a key turns, in radians.
const TURN: f32 = PI / 24.0;

const PLACES: [(Preset, Message); 6] = [
    (Preset::Overview, strings::FROM_OVERVIEW),
    (Preset::Eye, strings::FROM_THE_EYE),
    (Preset::Side, strings::FROM_THE_SIDE),
    (Preset::Above, strings::FROM_ABOVE),
    (Preset::Incidence, strings::ACROSS_INCIDENCE),
    (Preset::Ray, strings::ALONG_THE_RAY),
];

const PIXELS: [(Pixels, Message); 4] = [
    (Pixels::Current, strings::RAYS_OF_THE_PIXEL),
    (Pixels::Block, strings::RAYS_OF_A_BLOCK),
    (Pixels::Row, strings::RAYS_OF_A_ROW),
    (Pixels::Grid, strings::RAYS_OF_A_GRID),
];
/// Levels that can be chosen by number.
const LEVELS: u16 = 5;

/// Buttons for smaller and larger, and the menus of places to look from and of rays.
pub fn buttons(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    ui.spacing_mut().item_spacing.x = 4.0;
    let view = session.space();
    let orbit = view.orbit;
    for (sign, factor, name) in [
        ("−", 1.0 / PRESS, strings::SMALLER_SCENE),
        ("+", PRESS, strings::LARGER_SCENE),
    ] {
        let command = looked_at(session, orbit.zoomed(factor, Vec2::ZERO));
        button::sign(session, sign, name, command, commands, ui);
    }
    let has_rays = session.panel_input().run.rays().is_some();
    let current = PLACES.iter().find(|(place, _)| *place == orbit.from);
    let current = current.map_or("", |(_, name)| session.localize(*name));
    ui.menu_button(RichText::new(format!("{current} ▾")).size(13.0), |ui| {
        for (place, name) in PLACES {
            let needs_ray = matches!(place, Preset::Incidence | Preset::Ray);
            if needs_ray && !has_rays {
                continue;
            }
            if ui.button(session.localize(name)).clicked() {
                commands.push(looked_at(session, Orbit::preset(place)));
                ui.close();
            }
        }
    });
    if has_rays {
        ui.menu_button(
            RichText::new(format!("{} ▾", session.localize(strings::WHICH_RAYS))).size(13.0),
            |ui| which_rays(session, commands, ui),
        );
    }
}

/// The pixels, kinds and levels of the rays that are shown.
fn which_rays(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let view = session.space();
    let mut rays = view.rays;
    for (pixels, name) in PIXELS {
        ui.radio_value(&mut rays.pixels, pixels, session.localize(name));
    }
    // Ray casting has primary rays alone.
    if session.lesson().method == Method::RayTracing {
        kinds_and_levels(session, &mut rays, ui);
    }
    if rays != view.rays {
        commands.push(Command::ViewSpace(SpaceView { rays, ..view }));
    }
}

fn kinds_and_levels(session: &Session, rays: &mut RayChoice, ui: &mut Ui) {
    ui.separator();
    for kind in RayKind::ALL {
        let mut is_shown = rays.shows_kind(kind);
        let (name, letters) = ray_kind_name(kind.name(), session.look.language);
        if ui
            .checkbox(&mut is_shown, format!("{letters}  {name}"))
            .changed()
        {
            *rays = rays.toggled(kind);
        }
    }
    ui.separator();
    ui.horizontal(|ui| {
        ui.label(session.localize(strings::LEVELS));
        for level in 1..=LEVELS {
            let text = level.to_string();
            ui.radio_value(&mut rays.last_level, Some(level), text);
        }
        ui.radio_value(
            &mut rays.last_level,
            None,
            session.localize(strings::ALL_LEVELS),
        );
    });
}

fn looked_at(session: &Session, orbit: Orbit) -> Command {
    Command::ViewSpace(SpaceView {
        orbit,
        ..session.space()
    })
}

/// What the pointer and the keys do in the panel: dragging turns, with Shift or the right button it moves; the wheel and a
/// pinch zoom about the pointer; a double click shows the preset again; Alt and the arrows turn, + and − zoom.
pub fn pointed(session: &Session, response: &Response, ui: &Ui) -> Option<Command> {
    let view = session.space();
    let orbit = view.orbit;
    let size = Vec2::new(response.rect.width(), response.rect.height());
    let delta = response.drag_delta();
    let delta = Vec2::new(delta.x, delta.y);
    let (wheel, pinch, shift) = ui.input(|input| {
        (
            input.smooth_scroll_delta().y,
            input.zoom_delta(),
            input.modifiers.shift,
        )
    });
    let factor = pinch * (wheel / WHEEL).exp();
    let changed = if response.double_clicked() {
        Orbit::preset(orbit.from)
    } else if let Some(at) = response.hover_pos().filter(|_| factor != 1.0) {
        let from_middle = at - response.rect.center();
        orbit.zoomed(factor, Vec2::new(from_middle.x, from_middle.y) / size)
    } else if delta != Vec2::ZERO && (shift || response.dragged_by(PointerButton::Secondary)) {
        orbit.moved(delta / size)
    } else if delta != Vec2::ZERO {
        orbit.turned(PI * delta / size.min_element())
    } else if response.has_focus() {
        by_keys(orbit, ui)
    } else {
        orbit
    };
    (changed != orbit).then(|| looked_at(session, changed))
}

fn by_keys(orbit: Orbit, ui: &Ui) -> Orbit {
    ui.input(|input| {
        let presses = |key| input.num_presses(key) as f32;
        let toward = |less, more| presses(more) - presses(less);
        let zoom = toward(Key::Minus, Key::Plus) + presses(Key::Equals);
        let orbit = orbit.zoomed(PRESS.powf(zoom), Vec2::ZERO);
        if !input.modifiers.alt {
            return orbit;
        }
        let across = toward(Key::ArrowLeft, Key::ArrowRight);
        let down = toward(Key::ArrowUp, Key::ArrowDown);
        orbit.turned(TURN * Vec2::new(across, down))
    })
}
