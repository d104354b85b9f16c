use super::super::fixture::Fixture;
use super::super::fixtures::{SIZES, assert_legible};
use super::super::strings::Language;
use super::super::{Panel, draw};
use super::*;
use crate::algorithms::focus::Focus;
use crate::methods::{Settings, Setup};
use crate::picture::Rect;
use crate::picture::{Shape, Tag};
use crate::render::Method;
use crate::render::compare::compare_on;

const METHODS: [Method; 4] = [
    Method::Wireframe,
    Method::Flat,
    Method::Gouraud,
    Method::Phong,
];
const PANELS: [Panel; 3] = [Panel::Comparison, Panel::Difference, Panel::Profile];

/// On a clock that ticks a microsecond each time it is looked at.
fn compare(mut fixture: Fixture) -> Fixture {
    let mut ticks = 0.0;
    let mut clock = || {
        ticks += 1e-6;
        ticks
    };
    let setup = Setup::new(fixture.run.prepared().clone(), Settings::default());
    let methods = METHODS.into_iter();
    fixture.finished.compared = methods
        .map(|method| compare_on(&setup, method, &mut clock))
        .collect();
    fixture
}

#[test]
fn every_step_is_legible_at_every_size() {
    // Of the large one a few steps are enough.
    for (mut fixture, stride) in [
        (compare(Fixture::triangle(Method::Gouraud)), 1499),
        (compare(Fixture::pyramid(Method::Phong)), 300_007),
    ] {
        for step in fixture.some_steps(stride) {
            fixture.seek(step);
            for (size, language) in SIZES.into_iter().zip(Language::ALL.into_iter().cycle()) {
                for panel in PANELS {
                    let picture = draw(panel, &fixture.show_in(language), size);
                    let what = format!("{} {step} at {size}", panel.name());
                    assert_legible(&picture, &what);
                    assert!(!picture.alt.is_empty(), "{what}");
                }
            }
        }
    }
}

#[test]
fn the_cursor_goes_with_the_pixel_of_the_run_in_every_picture() {
    let mut fixture = compare(Fixture::triangle(Method::Gouraud));
    let circles = |fixture: &Fixture| {
        let picture = draw(Panel::Comparison, &fixture.input(), Vec2::new(640.0, 460.0));
        let circles = picture.items.iter().filter_map(|item| match item.shape {
            Shape::Circle { center, .. } => Some(center),
            _ => None,
        });
        circles.collect::<Vec<_>>()
    };
    fixture.go_to("PixelColored", 3);
    let before = circles(&fixture);
    assert_eq!(before.len(), METHODS.len());
    fixture.go_to("PixelColored", 4);
    let after = circles(&fixture);
    let moved: Vec<Vec2> = before.iter().zip(&after).map(|(b, a)| a - b).collect();
    assert!(moved[0].length() > 1.0);
    assert!(moved.iter().all(|by| by.distance(moved[0]) < 1e-3));
}

#[test]
fn every_picture_answers_the_pointer_with_its_pixels() {
    let fixture = compare(Fixture::triangle(Method::Gouraud));
    for panel in [Panel::Comparison, Panel::Difference] {
        let picture = draw(panel, &fixture.input(), Vec2::new(640.0, 460.0));
        let images: Vec<Rect> = picture
            .items
            .iter()
            .filter_map(|item| match &item.shape {
                Shape::Image {
                    rect,
                    first_pixel: Some(_),
                    ..
                } => Some(*rect),
                _ => None,
            })
            .collect();
        assert!(images.len() >= 2);
        for rect in images {
            let tag = picture.hit(rect.center());
            assert!(
                matches!(
                    tag,
                    Some(Tag::Pixel {
                        x: 23..=24,
                        y: 17..=18
                    })
                ),
                "{tag:?}"
            );
        }
    }
}

#[test]
fn phong_costs_more_than_gouraud_and_flat_least() {
    let fixture = compare(Fixture::pyramid(Method::Phong));
    let [_, flat, gouraud, phong] = fixture.finished.compared.pictures() else {
        panic!("four methods");
    };
    assert_eq!(flat.operations.pixels, gouraud.operations.pixels);
    assert_eq!(flat.operations.illuminations, 4);
    assert_eq!(gouraud.operations.illuminations, 5);
    assert_eq!(phong.operations.illuminations, phong.operations.pixels);
    assert_eq!(phong.operations.unit_normals, phong.operations.pixels);
    assert_eq!(flat.operations.interpolations, 0);
    assert_eq!(
        gouraud.operations.interpolations,
        phong.operations.interpolations
    );
}

#[test]
fn nothing_to_compare_says_so() {
    let fixture = Fixture::triangle(Method::Gouraud);
    assert_eq!(fixture.run.method(), Method::Gouraud);
    assert_eq!(fixture.input().focus, Focus::Polygon(0));
    for panel in PANELS {
        let picture = draw(panel, &fixture.input(), Vec2::new(300.0, 200.0));
        assert!(picture.alt.starts_with("The pictures"), "{}", picture.alt);
    }
}
