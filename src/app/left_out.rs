//! What the picture's method leaves out of this scene, with the reason: a part of the menu.

use super::session::Session;
use super::{style, words};
use crate::panels::words::Words;
use crate::scene::{LeftOut, Part};
use egui::Ui;

pub fn show(session: &Session, ui: &mut Ui) {
    let method = session.lesson().method;
    let stage = session.stage();
    let lines: Vec<String> = if method.follows_rays() {
        let left_out = stage.needs().left_out.iter();
        left_out
            .filter(|left_out| method.does(left_out.part))
            .map(|left_out| line(left_out, session))
            .collect()
    } else {
        let planes = stage.tessellation.left_out.iter();
        planes
            .map(|&object| {
                let name = &stage.scene.objects[object].name;
                format!("{name}: {}", session.say(PLANE))
            })
            .collect()
    };
    ui.label(style::strong(session.say(words::LEFT_OUT), 13.0));
    if lines.is_empty() {
        ui.label(session.say(words::NOTHING_LEFT_OUT));
    }
    for line in lines {
        ui.label(line);
    }
}

/// What, where, and for how many objects.
fn line(left_out: &LeftOut, session: &Session) -> String {
    let what = session.say(what(left_out.part));
    match (left_out.part, left_out.share) {
        (Part::ShadowRays, None) => format!("{what} ({})", left_out.place),
        (_, Some([some, all])) => {
            let of = session.say(OBJECTS_OF);
            format!("{what} ({}; {some} {of} {all})", left_out.place)
        }
        (_, None) => what.to_owned(),
    }
}

fn what(part: Part) -> Words {
    match part {
        Part::ReflectedRays => Words::new(
            "Reflected rays: nothing reflects",
            "Sinar pantul: tidak ada yang memantulkan",
        ),
        Part::TransmittedRays => Words::new(
            "Transmitted rays: nothing is transparent",
            "Sinar bias: tidak ada yang tembus cahaya",
        ),
        Part::TextureCoordinates => Words::new(
            "Texture coordinates: nothing has a texture",
            "Koordinat tekstur: tidak ada tekstur",
        ),
        Part::Highlights => Words::new(
            "Highlights: nothing is shiny",
            "Sorotan: tidak ada yang mengilap",
        ),
        Part::LightBalls => Words::new(
            "Light balls: no light has a radius",
            "Bola cahaya: tidak ada sumber cahaya berjari-jari",
        ),
        Part::PathAttenuation => Words::new(
            "Attenuation on the way: none is asked for",
            "Pelemahan di jalan: tidak diminta",
        ),
        Part::ShadowRays => Words::new(
            "Shadow rays: nothing can stand in the way",
            "Sinar bayangan: tidak ada yang dapat menghalangi",
        ),
        Part::DarkChannels => Words::new(
            "Dark channels: nothing emits in them, B = 0",
            "Kanal gelap: tidak ada yang memancar di dalamnya, B = 0",
        ),
        Part::EqualChannels => Words::new(
            "Equal channels: solved once",
            "Kanal yang sama: diselesaikan sekali",
        ),
        Part::BlackRows => Words::new(
            "Equations of black patches: they reflect nothing, B = E",
            "Persamaan patch hitam: tidak memantulkan, B = E",
        ),
        Part::FacingAway => Words::new(
            "Integrals of pairs in one plane or back to back: F = 0",
            "Integral pasangan sebidang atau saling membelakangi: F = 0",
        ),
        Part::SightTests => Words::new(
            "Rays between patches: nothing can stand between them",
            "Sinar antarpatch: tidak ada yang dapat menghalangi",
        ),
    }
}

const PLANE: Words = Words::new(
    "an infinite plane has no polygons",
    "bidang tak terhingga tidak punya poligon",
);
const OBJECTS_OF: Words = Words::new("objects of", "objek dari");
