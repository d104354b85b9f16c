//! What the picture's method leaves out of this scene: what, why, where and how much of it, and a box to have it done all the same.

use super::session::{Command, Session};
use super::{strings, style};
use crate::language::Message;
use crate::scene::{LeftOut, Part};
use egui::{Id, Modal, RichText, ScrollArea, Ui};

pub fn show(session: &Session, commands: &mut Vec<Command>, ctx: &egui::Context) {
    let frame = style::card_frame(session.look.theme);
    let modal = Modal::new(Id::unique("left out"))
        .frame(frame)
        .show(ctx, |ui| {
            let room = ctx.content_rect().size();
            ui.set_width((room.x - 80.0).min(640.0));
            ui.horizontal(|ui| {
                ui.label(style::strong(session.localize(strings::LEFT_OUT), 17.0));
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    if ui.button(session.localize(strings::CLOSE)).clicked() {
                        commands.push(Command::Skipped);
                    }
                });
            });
            ui.separator();
            // As of the sheet of keys: the list's own idea of its height knows nothing of the window.
            ScrollArea::vertical()
                .max_height(room.y - 150.0)
                .show(ui, |ui| list(session, commands, ui));
        });
    if modal.should_close() {
        commands.push(Command::Skipped);
    }
}

fn list(session: &Session, commands: &mut Vec<Command>, ui: &mut Ui) {
    let method = session.lesson().method;
    let skipped = session.skipped();
    let tessellation = &session.prepared().tessellation;
    let planes: &[usize] = match method.converts_polygons() {
        true => &tessellation.skipped,
        false => &[],
    };
    if skipped.is_empty() && planes.is_empty() {
        ui.label(session.localize(strings::NOTHING_LEFT_OUT));
    }
    if !skipped.is_empty() {
        ui.label(session.localize(strings::LEFT_OUT_ABOUT));
        ui.add_space(6.0);
    }
    for part in Part::ALL {
        let of_part: Vec<&LeftOut> = skipped.iter().filter(|one| one.part == part).collect();
        if !of_part.is_empty() {
            entry(session, part, &of_part, commands, ui);
        }
    }
    for &object in planes {
        let (scene, language) = (&session.prepared().scene, session.look.language);
        let name = scene.called(&scene.objects[object].name, language);
        ui.label(PLANE.format(language, &[("object", name)]));
    }
    if !session.setup().forced().is_empty() {
        ui.separator();
        ui.label(times(session));
    }
}

/// A part with its box, and where the scene says that it is not needed.
fn entry(
    session: &Session,
    part: Part,
    skipped: &[&LeftOut],
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) {
    let mut forced = session.setup().forced().has(part);
    let [what, why] = words_of(part);
    let name = style::strong(session.localize(what), 14.0);
    if ui.checkbox(&mut forced, name).clicked() {
        commands.push(Command::Force(part));
    }
    ui.indent(what.0, |ui| {
        ui.label(session.localize(why));
        for skipped in skipped {
            ui.label(RichText::new(place(skipped, session)).monospace());
        }
    });
    ui.add_space(4.0);
}

/// Where, and for how many of how many.
fn place(skipped: &LeftOut, session: &Session) -> String {
    let LeftOut { part, place, share } = skipped;
    let share = share.map_or(String::new(), |[some, all]| {
        let counted = match part {
            Part::BlackRows => PATCHES,
            Part::FacingAway | Part::SightTests => PAIRS,
            _ => OBJECTS,
        };
        let [some, all] = [some, all].map(|count| count.to_string());
        let counted = counted.format(session.look.language, &[("some", &some), ("all", &all)]);
        format!(": {counted}")
    });
    format!("{place}{share}")
}

/// Both run times, once they are measured.
fn times(session: &Session) -> String {
    match session.times() {
        None => session.localize(strings::TIMES_MEASURED).into(),
        Some(Err(_)) => session.localize(strings::TIMES_NONE).into(),
        Some(Ok([without, with])) => {
            let language = session.look.language;
            let [a, b] =
                [without, with].map(|time| format!("{} ms", language.fixed(1e3 * time.median, 2)));
            let times = match with.ties(without) {
                true => strings::TIMES_TIE,
                false => strings::TIMES,
            };
            times.format(language, &[("without", &a), ("with", &b)])
        }
    }
}

/// What it is, and why it is not needed.
fn words_of(part: Part) -> [Message; 2] {
    let [what, why] = match part {
        Part::ReflectedRays => ["skipped-reflected-rays", "skipped-reflected-rays-because"],
        Part::TransmittedRays => [
            "skipped-transmitted-rays",
            "skipped-transmitted-rays-because",
        ],
        Part::TextureCoordinates => [
            "skipped-texture-coordinates",
            "skipped-texture-coordinates-because",
        ],
        Part::Highlights => ["skipped-highlights", "skipped-highlights-because"],
        Part::LightBalls => ["skipped-light-balls", "skipped-light-balls-because"],
        Part::PathAttenuation => [
            "skipped-path-attenuation",
            "skipped-path-attenuation-because",
        ],
        Part::ShadowRays => ["skipped-shadow-rays", "skipped-shadow-rays-because"],
        Part::DarkChannels => ["skipped-dark-channels", "skipped-dark-channels-because"],
        Part::EqualChannels => ["skipped-equal-channels", "skipped-equal-channels-because"],
        Part::BlackRows => ["skipped-black-rows", "skipped-black-rows-because"],
        Part::FacingAway => ["skipped-facing-away", "skipped-facing-away-because"],
        Part::SightTests => ["skipped-sight-tests", "skipped-sight-tests-because"],
    };
    [Message(what), Message(why)]
}

const PLANE: Message = Message("app-skipped-plane");
const OBJECTS: Message = Message("app-skipped-objects");
const PATCHES: Message = Message("app-skipped-patches");
const PAIRS: Message = Message("app-skipped-pairs");
