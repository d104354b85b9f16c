use super::super::fixture::Fixture;
use super::super::fixtures::{SIZES, assert_steps_are_legible, views_in_turn};
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
        for panel in PANELS {
            assert_steps_are_legible(&mut fixture, stride, &views_in_turn(), |input, size| {
                draw(panel, input, size)
            });
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

#[test]
fn titles_are_whole_and_pictures_as_large_as_any_grid_makes_them() {
    let fixture = compare(Fixture::triangle(Method::Gouraud));
    let all = fixture.finished.compared.pictures();
    let like = &all[0].frame;
    let pixels = Vec2::new(like.width as f32, like.rows.len() as f32);
    for size in SIZES {
        let picture = draw(Panel::Comparison, &fixture.input(), size);
        let printed = super::super::fixtures::texts(&picture);
        for name in titles(all, Language::English) {
            assert!(
                printed.iter().any(|(text, _)| *text == name),
                "{name} at {size}"
            );
        }
        assert!(
            printed.iter().all(|(text, _)| !text.contains('…')),
            "{size}: {printed:?}"
        );
        let images = images(&picture);
        assert_eq!(images.len(), METHODS.len());
        // Of all grids with room for titles alone, what the best one gives.
        let best = (1..=METHODS.len()).map(|columns| {
            let rows = METHODS.len().div_ceil(columns) as f32;
            let room = size / Vec2::new(columns as f32, rows) - Vec2::new(5.0, 26.0);
            (room / pixels).min_element()
        });
        let best = best.fold(0.0, f32::max);
        let scale = images[0].width / pixels.x;
        assert!(scale >= 0.75 * best, "{scale} of {best} at {size}");
    }
}

/// Where the pictures lie, beyond what is seen of them too.
fn images(picture: &Picture) -> Vec<Rect> {
    let items = picture.items.iter();
    let images = items.filter_map(|item| match &item.shape {
        Shape::Image {
            rect,
            first_pixel: Some(_),
            ..
        } => Some(*rect),
        _ => None,
    });
    images.collect()
}

#[test]
fn all_pictures_are_enlarged_about_the_same_place() {
    let mut fixture = compare(Fixture::triangle(Method::Gouraud));
    fixture.go_to("PixelColored", 40);
    for panel in [Panel::Comparison, Panel::Difference] {
        let size = Vec2::new(640.0, 460.0);
        let whole = images(&draw(panel, &fixture.input(), size))[0];
        let input = PanelInput {
            image: crate::panels::ImageView {
                shown: crate::figure::View::WHOLE.zoomed(4.0),
                ..crate::panels::ImageView::WHOLE
            },
            ..fixture.input()
        };
        let picture = draw(panel, &input, size);
        let cells: Vec<Rect> = picture
            .items
            .iter()
            .filter(|item| {
                matches!(
                    item.shape,
                    Shape::Image {
                        first_pixel: Some(_),
                        ..
                    }
                )
            })
            .map(|item| item.clip.expect("only a part is seen"))
            .collect();
        let offsets: Vec<Vec2> = images(&picture)
            .iter()
            .zip(&cells)
            .map(|(whole, seen)| seen.min() - whole.min())
            .collect();
        assert!((images(&picture)[0].width - 4.0 * whole.width).abs() < 0.1);
        assert!(
            offsets.iter().all(|by| by.distance(offsets[0]) < 0.01),
            "{offsets:?}"
        );
        // The pixel that the run is at stays in sight.
        let cursor = Cursor::of(&input);
        let (x, y) = (cursor.x.expect("a pixel"), cursor.y.expect("a pixel"));
        let seen = picture.tagged_bounds(Tag::Pixel { x, y }).expect("drawn");
        assert!(!seen.is_empty());
    }
}

#[test]
fn the_pointer_says_what_every_method_has() {
    let fixture = compare(Fixture::triangle(Method::Gouraud));
    let said = values(&fixture.input(), 23, 17).expect("a pixel");
    assert_eq!(said.lines().count(), 1 + METHODS.len(), "{said}");
    for compared in fixture.finished.compared.pictures() {
        let red = Language::English.fixed(compared.frame.pixel(23, 17).r, 3);
        assert!(said.contains(&red), "{red} in {said}");
    }
    let input = PanelInput {
        pending: Some(&[]),
        ..fixture.input()
    };
    let hidden = values(&input, 23, 17).expect("a pixel");
    assert!(
        hidden.lines().skip(1).all(|line| line.ends_with('?')),
        "{hidden}"
    );
}

#[test]
fn at_least_two_fifths_of_a_profile_are_plot_and_every_strip_has_its_numbers() {
    let mut fixture = compare(Fixture::pyramid(Method::Phong));
    fixture.go_to("PixelColored", 700);
    for size in SIZES {
        for language in Language::ALL {
            let picture = draw(Panel::Profile, &fixture.show_in(language), size);
            // The upright axes.
            let strips = picture.items.iter().filter_map(|item| match &item.shape {
                Shape::Polyline { points, stroke }
                    if stroke.ink == Ink::Muted
                        && points.len() == 2
                        && points[0].x == points[1].x =>
                {
                    Some((points[0], points[1].y - points[0].y))
                }
                _ => None,
            });
            let strips: Vec<(Vec2, f32)> = strips.collect();
            let plot: f32 = strips.iter().map(|(_, height)| height).sum();
            assert!(plot >= 0.4 * size.y, "{plot} of {size}");
            for (top, height) in &strips {
                let beside = super::super::fixtures::texts(&picture);
                let numbers = beside.iter().filter(|(_, at)| {
                    at.right() <= top.x
                        && (top.y - 9.0..top.y + height + 9.0).contains(&at.center().y)
                });
                assert!(numbers.count() >= 2, "{size}");
            }
        }
    }
}
