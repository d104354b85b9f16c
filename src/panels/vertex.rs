//! The point that is being lit: the faces around it with their normals, their mean N_v, the vectors of the illumination model,
//! and the terms that add up to its intensity.
//!
//! Seen from the side, 30° above the surface, in parallel projection: normals point up, and what leans toward the eye leans to
//! the right.

mod arrows;
mod terms;

use super::message::{NO_POLYGONS, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties};
use crate::language::Message;
use crate::picture::{Picture, Rect};
use crate::replay::Run;
use crate::replay::shading::State;
use glam::Vec2;

const NOTHING: Message = Message("vertex-nothing");
const WIREFRAME: Message = Message("vertex-wireframe");

pub const PANEL: Properties = Properties::titled(Message("app-vertex"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    let mut picture = match input.run {
        Run::Shading(_, replay) => of_state(input, replay.state(), size),
        Run::Wireframe(_) => message(WIREFRAME, input.language, size),
        Run::Rays(..) | Run::Radiosity(..) | Run::FormFactor(..) | Run::Hierarchical(..) => {
            message(NO_POLYGONS, input.language, size)
        }
    };
    picture.alt = format!("{} {}", step_as_sentence(input), picture.alt);
    picture
}

fn of_state(input: &PanelInput, state: &State, size: Vec2) -> Picture {
    if state.vertex.is_none() && state.point.is_none() {
        return message(NOTHING, input.language, size);
    }
    let walk = input.run.walk();
    let kind = walk.kind(walk.position());
    let mut picture = Picture::new(size.x, size.y);
    let (left, right) = halves(size);
    arrows::draw(&mut picture, state, kind, left);
    terms::draw(&mut picture, state, input.language, right);
    picture
}

/// Where the vectors are drawn, and where the values stand: beside them, or under them in a narrow, high panel.
fn halves(size: Vec2) -> (Rect, Rect) {
    let whole = Rect::new(0.0, 0.0, size.x, size.y).grown(-4.0);
    if size.x < 340.0 && size.y > 320.0 {
        let values = 150.0;
        let top = Rect::new(whole.x, whole.y, whole.width, whole.height - values);
        let below = Rect::new(whole.x, top.bottom(), whole.width, values);
        return (top, below);
    }
    let values = (0.42 * size.x).clamp(152.0, 260.0);
    let left = Rect::new(whole.x, whole.y, whole.width - values, whole.height);
    let right = Rect::new(left.right(), whole.y, values, whole.height);
    (left, right)
}

#[cfg(test)]
mod tests {
    use super::super::fixture::Fixture;
    use super::super::fixtures::{SIZES, fixtures, nothing, texts};
    use super::super::strings::Language;
    use super::super::values::short;
    use super::*;
    use crate::picture::Tag;
    use crate::render::Method;

    #[test]
    fn nothing_overlaps_or_is_cut_at_any_step_and_size() {
        for mut fixture in [
            Fixture::pyramid(Method::Gouraud),
            fixtures(Method::Gouraud),
            fixtures(Method::Flat),
            fixtures(Method::Phong),
            fixtures(Method::Wireframe),
            nothing(),
        ] {
            // Every step of the first vertices, then some of the rest.
            for step in (0..90).chain((90..fixture.run.walk().len()).step_by(1009)) {
                fixture.run.walk_mut().seek(step);
                for (size, language) in SIZES.into_iter().zip(Language::ALL.into_iter().cycle()) {
                    let input = PanelInput {
                        language,
                        ..fixture.input()
                    };
                    let picture = draw(&input, size);
                    let texts = texts(&picture);
                    for (i, (text, place)) in texts.iter().enumerate() {
                        assert!(
                            picture.bounds().encloses(place),
                            "step {step}, {size}: “{text}” is cut"
                        );
                        for (other, other_place) in &texts[..i] {
                            let common = place.intersection(other_place);
                            assert!(
                                common.width < 0.5 || common.height < 0.5,
                                "step {step}, {size}: “{text}” covers “{other}”"
                            );
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn values_are_those_of_the_events() {
        let mut fixture = Fixture::pyramid(Method::Gouraud);
        for (kind, name) in [
            ("ToLight", "N_dot_L"),
            ("Mirrored", "R_dot_V"),
            ("Ambient", "I_a"),
            ("Diffuse", "I_d"),
            ("Specular", "I_s"),
            ("Illuminated", "I"),
        ] {
            fixture.go_to(kind, 1);
            let walk = fixture.run.walk();
            let recorded = walk.own_fields(walk.position()).get(name).unwrap();
            let picture = draw(&fixture.input(), Vec2::new(560.0, 360.0));
            let shown = short(recorded, 3, Language::English);
            let found = texts(&picture).iter().any(|(text, _)| *text == shown);
            assert!(found, "{name} = {shown}");
            assert!(picture.tagged_bounds(Tag::Field(name)).is_some());
            assert!(
                picture
                    .alt
                    .contains(&crate::panels::kind_name(kind, Language::English))
            );
        }
    }

    #[test]
    fn each_face_added_has_its_arrow() {
        let mut fixture = Fixture::pyramid(Method::Gouraud);
        for faces in 1..=4 {
            fixture.go_to("FaceNormalAdded", faces - 1);
            let picture = draw(&fixture.input(), Vec2::new(560.0, 360.0));
            let arrows = (1..=4).filter(|k| {
                let name = format!("N_{k}");
                texts(&picture).iter().any(|(text, _)| *text == name)
            });
            assert_eq!(arrows.count(), faces);
        }
    }
}
