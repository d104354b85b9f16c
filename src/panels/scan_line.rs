//! The current polygon, large: its corners and edges, the scan line with the points where it cuts them, the pixels of the
//! span; and under it the interpolation of the step as bars.

mod bars;
mod corners;
mod line;
mod polygon;

use super::grip::Sight;
use super::message::{NO_POLYGONS, message};
use super::values::step_as_sentence;
use super::{PanelInput, Properties};
use crate::language::Message;
use crate::picture::{Picture, Rect};
use crate::replay::Run;
use crate::replay::shading::State;
use glam::Vec2;

const NO_POLYGON: Message = Message("scan-line-no-polygon");
const NO_WEIGHTS: Message = Message("scan-line-no-weights");
const NO_LINE: Message = Message("scan-line-no-line");

pub const PANEL: Properties = Properties::titled(Message("app-scan-line"));

pub fn draw(input: &PanelInput, size: Vec2) -> Picture {
    match input.run {
        Run::Shading(_, replay) => of_state(input, replay.state(), size),
        Run::Wireframe(replay) => match replay.state().line {
            Some(ends) => {
                let mut picture = Picture::new(size.x, size.y);
                line::draw(&mut picture, replay, ends, input.language);
                picture.alt = step_as_sentence(input);
                picture
            }
            None => silent(input, NO_LINE, size),
        },
        Run::Rays(..) | Run::Radiosity(..) | Run::FormFactor(..) | Run::Hierarchical(..) => {
            message(NO_POLYGONS, input.language, size)
        }
    }
}

fn of_state(input: &PanelInput, state: &State, size: Vec2) -> Picture {
    if state.polygon.is_none() {
        return silent(input, NO_POLYGON, size);
    }
    let mut picture = Picture::new(size.x, size.y);
    let area = room(state, size);
    polygon::draw(&mut picture, state, input.language, area);
    let bars = size.y - area.bottom();
    if bars > 0.0 {
        let area = Rect::new(0.0, area.bottom(), size.x, bars).grown(-2.0);
        match bars::Interpolation::current(state) {
            Some(interpolation) => interpolation.draw(&mut picture, area, input.language),
            None if area.height >= 36.0 => {
                let hint = message(
                    NO_WEIGHTS,
                    input.language,
                    Vec2::new(area.width, area.height),
                );
                picture.place(area.min(), hint);
            }
            None => {}
        }
    }
    picture.alt = step_as_sentence(input);
    picture
}

/// Where the polygon stands, above the bars of that step.
fn room(state: &State, size: Vec2) -> Rect {
    // The bars keep their place whether they are filled or not, so that the polygon stands still.
    let bars = match state.names {
        Some(names) => bars::height(names.zero, size),
        None => 0.0,
    };
    Rect::new(0.0, 0.0, size.x, size.y - bars)
}

/// The object of the current polygon.
pub fn object(input: &PanelInput) -> Option<usize> {
    let Run::Shading(_, replay) = input.run else {
        return None;
    };
    let state = replay.state();
    let polygon = state.polygon?.polygon as usize;
    Some(state.prepared.polygon(polygon)?.object)
}

/// How the polygon is seen in a panel of that size.
pub fn sight(input: &PanelInput, size: Vec2) -> Option<Sight> {
    let Run::Shading(_, replay) = input.run else {
        return None;
    };
    let state = replay.state();
    let area = room(state, size);
    Some(Sight::Camera {
        view: state.prepared.view,
        fit: polygon::fit(&corners::corners(state), area)?,
        area,
    })
}

/// Says why there is nothing to see.
fn silent(input: &PanelInput, strings: Message, size: Vec2) -> Picture {
    let mut picture = message(strings, input.language, size);
    picture.alt = format!("{} {}", step_as_sentence(input), picture.alt);
    picture
}

#[cfg(test)]
mod tests {
    use super::super::fixture::Fixture;
    use super::super::fixtures::{SIZES, fixtures, nothing, texts};
    use super::*;
    use crate::picture::Tag;
    use crate::render::Method;

    fn assert_apart(picture: &Picture, what: &str) {
        let texts = texts(picture);
        for (i, (text, place)) in texts.iter().enumerate() {
            assert!(picture.bounds().encloses(place), "{what}: “{text}” is cut");
            for (other, other_place) in &texts[..i] {
                let common = place.intersection(other_place);
                assert!(common.is_empty(), "{what}: “{text}” covers “{other}”");
            }
        }
    }

    #[test]
    fn no_label_covers_another_at_any_step_and_size() {
        let mut samples = [
            (Fixture::triangle(Method::Gouraud), 1),
            (Fixture::triangle(Method::Flat), 3),
            (Fixture::triangle(Method::Wireframe), 1),
            (fixtures(Method::Gouraud), 37),
            (Fixture::triangle(Method::Phong), 3),
            (fixtures(Method::Phong), 97),
            (Fixture::triangle(Method::FastPhong), 3),
            (fixtures(Method::FastPhong), 97),
        ];
        for (fixture, stride) in &mut samples {
            for step in (0..fixture.run.walk().len()).step_by(*stride) {
                fixture.run.walk_mut().seek(step);
                for size in SIZES {
                    let picture = draw(&fixture.input(), size);
                    let kind = fixture.run.walk().kind(step);
                    assert_apart(&picture, &format!("step {step}, {kind}, {size}"));
                    assert!(picture.alt.contains(&crate::panels::kind_name(
                        kind,
                        crate::language::Language::English
                    )));
                }
            }
        }
    }

    #[test]
    fn what_the_step_is_about_is_always_labelled() {
        let mut fixture = Fixture::triangle(Method::Gouraud);
        for (kind, name) in [
            ("EdgeInterpolated", "I_4"),
            ("SpanInterpolated", "I_P"),
            ("Pixel", "x_P"),
        ] {
            for n in [0, 7, 16] {
                fixture.go_to(kind, n);
                for size in SIZES {
                    let picture = draw(&fixture.input(), size);
                    let found = picture.tagged_bounds(Tag::Field(name));
                    assert!(found.is_some(), "{name} at {kind} {n}, {size}");
                }
            }
        }
    }

    #[test]
    fn a_label_shows_what_the_event_recorded() {
        let mut fixture = Fixture::triangle(Method::Gouraud);
        fixture.go_to("EdgeInterpolated", 9);
        let walk = fixture.run.walk();
        let recorded = walk.own_fields(walk.position()).get("I_4_incremental");
        let expected = format!(
            "I_4 = {}",
            super::super::values::short(recorded.unwrap(), 3, crate::language::Language::English)
        );
        let picture = draw(&fixture.input(), Vec2::new(480.0, 400.0));
        assert!(
            texts(&picture).iter().any(|(text, _)| *text == expected),
            "{expected}"
        );
    }

    /// At the step that finds a normal, and at those that follow.
    #[test]
    fn a_normal_is_known_from_the_step_on_that_finds_it() {
        let mut fixture = Fixture::triangle(Method::Phong);
        let unknown = |fixture: &Fixture| {
            let picture = draw(&fixture.input(), Vec2::new(480.0, 400.0));
            let texts = texts(&picture).into_iter();
            texts.filter(|(text, _)| *text == "N = ?").count()
        };
        for n in 0..3 {
            fixture.go_to("Vertex", n);
            assert_eq!(unknown(&fixture), 3 - n);
            fixture.go_to("VertexNormal", n);
            assert_eq!(unknown(&fixture), 2 - n);
        }
    }

    #[test]
    fn without_a_polygon_a_sentence_says_so() {
        let picture = draw(&nothing().input(), Vec2::new(260.0, 180.0));
        assert!(
            picture.alt.contains("no polygon is drawn"),
            "{}",
            picture.alt
        );
        assert_apart(&picture, "nothing");
    }
}
