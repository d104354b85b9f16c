use super::super::fixture::{BALL, FLOOR, Fixture, rays_scene};
use super::super::fixtures;
use super::*;
use crate::algorithms::primary::Settings;
use crate::figure::View;
use crate::methods::Setup;
use crate::picture::{Shape, Tag, Theme, rasterize};
use crate::render::{Method, layers};
use std::convert::Infallible;

/// The frame that the picture's pixels fill.
fn frame(picture: &Picture) -> Rect {
    let image = |item: &crate::picture::Item| match &item.shape {
        Shape::Image { rect, .. } => Some(*rect),
        _ => None,
    };
    picture.items.iter().find_map(image).unwrap()
}

#[test]
fn the_centre_of_a_pixel_is_that_pixel() {
    for fixture in [
        Fixture::triangle(Method::Gouraud).go_to("SpanInterpolated", 40),
        Fixture::pyramid(Method::Flat).go_to("PixelColored", 700),
        Fixture::triangle(Method::Wireframe).go_to("PixelPlotted", 30),
    ] {
        for size in [[260.0, 180.0], [460.0, 380.0], [1400.0, 900.0]] {
            let picture = draw(&fixture.input(), Vec2::from(size));
            let (width, height) = (
                fixture.finished.picture.width,
                fixture.finished.picture.rows.end,
            );
            let frame = frame(&picture);
            assert!(picture.bounds().encloses(&frame));
            let pixel = Vec2::new(frame.width / width as f32, frame.height / height as f32);
            for (x, y) in [(0, 0), (width / 3, height / 2), (width - 1, height - 1)] {
                let centre = frame.min() + pixel * (Vec2::new(x as f32, y as f32) + 0.5);
                assert_eq!(picture.hit(centre), Some(Tag::Pixel { x, y }), "{size:?}");
            }
        }
    }
}

#[test]
fn what_is_to_come_is_fainter_than_what_is_drawn() {
    let mut fixture = Fixture::triangle(Method::Gouraud);
    let size = Vec2::new(480.0, 380.0);
    // Within the frame, before anything is drawn, and once the whole run is over.
    let opening = draw(&fixture.input(), size);
    fixture.run.walk_mut().seek(1);
    let ghost = draw(&fixture.input(), size);
    let last = fixture.run.walk().len() - 1;
    fixture.run.walk_mut().seek(last);
    let drawn = draw(&fixture.input(), size);
    let color = |picture: &Picture, x: u32, y: u32| {
        let frame = frame(picture);
        let scale = frame.width / fixture.finished.picture.width as f32;
        let at = frame.min() + scale * (Vec2::new(x as f32, y as f32) + 0.5);
        let pixels = rasterize(picture, Theme::Light, 1.0).unwrap();
        let color = pixels.pixel(at.x as u32, at.y as u32).unwrap();
        [color.red(), color.green(), color.blue()]
    };
    let finished = fixture.finished.picture.pixel(22, 16).to_srgb8();
    assert_eq!(color(&drawn, 22, 16), finished);
    assert_eq!(color(&opening, 22, 16), finished);
    // A ghost is nearer to the background than to the finished colour, and not the background.
    let background = fixture.finished.picture.pixel(2, 33).to_srgb8();
    let faint = color(&ghost, 22, 16)[0];
    assert!(faint.abs_diff(background[0]) * 2 < faint.abs_diff(finished[0]));
    assert!(faint.abs_diff(background[0]) > 10);
    assert_eq!(color(&ghost, 2, 33), background);
    assert_eq!(color(&drawn, 2, 33), background);
}

#[test]
fn an_enlarged_picture_follows_the_pixel_and_numbers_its_columns_and_rows() {
    let mut fixture = Fixture::triangle(Method::Gouraud);
    fixture.go_to("PixelColored", 40);
    let size = Vec2::new(480.0, 380.0);
    let marks = |fixture: &Fixture| marks(&fixture.input()).unwrap().pixel.unwrap();
    let (x, y) = marks(&fixture);
    let enlarged = ImageView {
        shown: View::WHOLE.zoomed(6.0),
        ..ImageView::WHOLE
    };
    let input = PanelInput {
        image: enlarged,
        ..fixture.input()
    };
    let picture = draw(&input, size);
    let pixel = picture.tagged_bounds(Tag::Pixel { x, y }).unwrap();
    assert!(pixel.width > 40.0, "{pixel:?}");
    let texts: Vec<&str> = picture
        .items
        .iter()
        .filter_map(|item| match &item.shape {
            Shape::Text { text, .. } => Some(text.as_str()),
            _ => None,
        })
        .collect();
    for number in [x, y] {
        assert!(texts.contains(&&*number.to_string()), "{texts:?}");
    }
    // Every pixel that is seen lies inside of the frame, and a far one is not seen.
    assert_eq!(picture.hit(pixel.center()), Some(Tag::Pixel { x, y }));
    assert!(
        picture
            .tagged_bounds(Tag::Pixel { x: 0, y: 0 })
            .is_none_or(|far| far.is_empty())
    );
}

#[test]
fn the_depth_buffer_is_filled_step_by_step_and_says_what_the_run_recorded() {
    let mut fixture = Fixture::triangle(Method::Gouraud);
    let setup = Setup::new(fixture.run.prepared().clone(), Settings::default());
    let Ok(layers) = layers(&setup, Method::Gouraud, |_, _| Ok::<(), Infallible>(()));
    fixture.finished.layers = Some(layers);
    fixture.go_to("PixelColored", 40);
    let (x, y) = marks(&fixture.input()).unwrap().pixel.unwrap();
    let input = PanelInput {
        image: ImageView {
            layer: PixelLayer::Depth,
            ..ImageView::WHOLE
        },
        ..fixture.input()
    };
    let Run::Shading(_, replay) = input.run else {
        panic!("a scan-line method");
    };
    let (z, ..) = replay.state().pixel.as_ref().unwrap().depth.unwrap();
    let said = value(&input, x, y);
    assert!(said.ends_with(&Language::English.short(z, 4)), "{said}");
    assert!(value(&input, x + 1, y).ends_with("none"));
    let shown = ShownLayer::of(&input).unwrap();
    assert_ne!(shown.color(&input, x, y), shown.color(&input, x + 1, y));

    let asked = PanelInput {
        pending: Some(&[]),
        ..input
    };
    assert!(ShownLayer::of(&asked).is_none(), "a question waits");
}

#[test]
fn the_alternative_text_says_the_step() {
    let mut fixture = Fixture::triangle(Method::Gouraud);
    fixture.go_to("PixelColored", 3);
    let alt = draw(&fixture.input(), Vec2::new(300.0, 200.0)).alt;
    assert!(
        alt.contains("Pixel coloured") && alt.contains("so far: 4."),
        "{alt}"
    );
}

#[test]
fn the_pinned_pixel_has_a_pin_and_its_name_in_every_view_that_shows_it() {
    let [fixture, mut pinned] =
        Fixture::pixels_of(rays_scene(), Method::RayTracing, [BALL, FLOOR], 2);
    pinned.seek(pinned.walk().len() - 1);
    let Run::Rays(_, pinned) = &pinned.run else {
        panic!("rays");
    };
    let (x, y) = FLOOR;
    let name = format!("pinned: pixel ({x}, {y})");
    let names = |picture: &Picture| {
        let texts = fixtures::texts(picture).into_iter();
        texts.filter(|(text, _)| *text == name).count()
    };
    for size in [Vec2::new(260.0, 180.0), Vec2::new(900.0, 640.0)] {
        let plain = draw(&fixture.input(), size);
        assert_eq!((names(&plain), plain.alt.contains(&name)), (0, false));
        let input = PanelInput {
            pinned: Some(pinned.state()),
            ..fixture.input()
        };
        let picture = draw(&input, size);
        assert_eq!((names(&picture), picture.alt.contains(&name)), (1, true));
        let frame = frame(&picture);
        // The needle ends in the pixel, which is under the pointer as before.
        let scale = frame.width / fixture.finished.picture.width as f32;
        let at = frame.min() + scale * (Vec2::new(x as f32, y as f32) + 0.5);
        assert_eq!(picture.hit(at), Some(Tag::Pixel { x, y }));
        let ends_there = |item: &crate::picture::Item| match &item.shape {
            Shape::Polyline { points, .. } => points.iter().any(|point| point.distance(at) < 1e-3),
            _ => false,
        };
        assert!(picture.items.iter().any(ends_there), "{size}");
    }
}
