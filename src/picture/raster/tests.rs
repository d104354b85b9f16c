use super::*;
use crate::picture::{Image, Style};

const INK: [u8; 3] = [0, 0, 0];

/// Draws on projector white, in projector black: what is anti-aliased is neither.
fn drawn(scale: f32, draw: impl FnOnce(&mut Picture)) -> Pixmap {
    let mut picture = Picture::new(40.0, 30.0);
    draw(&mut picture);
    rasterize(&picture, Theme::Projector, scale).unwrap()
}

fn at(pixmap: &Pixmap, x: u32, y: u32) -> [u8; 3] {
    let pixel = pixmap.pixel(x, y).unwrap();
    [pixel.red(), pixel.green(), pixel.blue()]
}

/// The box of all pixels that are not white: left, top, right, bottom, the last two outside.
fn inked(pixmap: &Pixmap) -> Option<[u32; 4]> {
    let (width, height) = (pixmap.width(), pixmap.height());
    (0..height)
        .flat_map(|y| (0..width).map(move |x| (x, y)))
        .filter(|&(x, y)| at(pixmap, x, y) != [255; 3])
        .map(|(x, y)| [x, y, x + 1, y + 1])
        .reduce(|a, b| {
            [
                a[0].min(b[0]),
                a[1].min(b[1]),
                a[2].max(b[2]),
                a[3].max(b[3]),
            ]
        })
}

fn has_only_ink_and_paper(pixmap: &Pixmap) -> bool {
    let [left, top, right, bottom] = inked(pixmap).expect("something was drawn");
    (top..bottom)
        .flat_map(|y| (left..right).map(move |x| (x, y)))
        .all(|(x, y)| [INK, [255; 3]].contains(&at(pixmap, x, y)))
}

#[test]
fn rules_and_frames_are_crisp_wherever_they_lie() {
    for scale in [1.0, 1.25, 1.5, 2.0] {
        for offset in [0.0, 0.3, 0.5, 0.77] {
            let rule = drawn(scale, |picture| {
                picture.line(
                    (5.0, 10.0 + offset),
                    (35.0, 10.0 + offset),
                    Ink::Text.stroke(1.0),
                );
            });
            let [_, top, _, bottom] = inked(&rule).unwrap();
            assert_eq!(bottom - top, scale.round() as u32);
            assert!(has_only_ink_and_paper(&rule));
            let frame = drawn(scale, |picture| {
                let rect = Rect::new(4.0 + offset, 5.0 + offset, 20.0, 12.0);
                picture.rect(rect, Ink::Text.stroke(1.0));
            });
            assert!(has_only_ink_and_paper(&frame));
            let [left, top, right, bottom] = inked(&frame).unwrap();
            let size = (scale * 20.0, scale * 12.0);
            assert_eq!(((right - left) as f32, (bottom - top) as f32), size);
        }
    }
}

#[test]
fn a_frame_lies_inside_its_rectangle() {
    let frame = drawn(1.0, |picture| {
        picture.rect(picture.bounds(), Ink::Text.stroke(1.0));
    });
    assert_eq!(at(&frame, 0, 0), INK);
    assert_eq!(at(&frame, 39, 29), INK);
    assert_eq!(at(&frame, 1, 1), [255; 3]);
    let rounded = drawn(2.0, |picture| {
        picture.rounded_rect(picture.bounds(), 6.0, Ink::Text.stroke(1.0));
    });
    assert_eq!(at(&rounded, 40, 0), INK);
    assert_eq!(at(&rounded, 40, 1), INK);
    assert_eq!(at(&rounded, 40, 2), [255; 3]);
    assert_eq!(at(&rounded, 0, 0), [255; 3]);
}

#[test]
fn text_fills_the_width_that_was_measured() {
    // An H begins and ends with the same stem, as far from the ends of its own box.
    let mut picture = Picture::new(300.0, 60.0);
    for style in [
        Style::Body,
        Style::Bold,
        Style::Mono,
        Style::Label,
        Style::Formula,
    ] {
        for scale in [1.0, 1.5, 2.0] {
            let set = style.size(20.0);
            let mut ink = |text| {
                picture.items.clear();
                picture.text((10.5, 40.0), text, set);
                let pixmap = rasterize(&picture, Theme::Projector, scale).unwrap();
                let [left, top, right, bottom] = inked(&pixmap).unwrap().map(|at| at as f32);
                let bounds = set.bounds((10.5, 40.0), text);
                assert!(top >= bounds.y * scale - 1.0, "{text}");
                assert!(bottom <= bounds.bottom() * scale + 1.0, "{text}");
                let centre = 0.5 * (left + right);
                assert!((centre - bounds.center().x * scale).abs() <= 1.0, "{text}");
                (right - left) - set.width(text) * scale
            };
            assert!(
                (ink("HH 0.514 = x_4 HH") - ink("HH")).abs() <= 1.0,
                "{style:?}"
            );
        }
    }
}

#[test]
fn images_are_not_blurred() {
    let image = Image::new(2, 1, vec![255, 0, 0, 0, 0, 255]);
    let pixmap = drawn(2.0, |picture| {
        picture.image(Rect::new(5.2, 5.2, 8.0, 4.0), image);
    });
    assert_eq!(inked(&pixmap), Some([10, 10, 26, 18]));
    for y in 10..18 {
        for x in 10..26 {
            let expected = if x < 18 { [255, 0, 0] } else { [0, 0, 255] };
            assert_eq!(at(&pixmap, x, y), expected);
        }
    }
}

#[test]
fn nothing_leaves_its_clip() {
    let clip = Rect::new(10.0, 8.0, 12.0, 9.0);
    let pixmap = drawn(2.0, |picture| {
        picture.clipped(clip, |picture| {
            let line = Ink::Text.stroke(3.0);
            picture.line((0.0, 0.0), (40.0, 30.0), line);
            picture.line((0.0, 12.0), (40.0, 12.0), line.dashed());
            picture.circle((15.0, 12.0), 9.0, Ink::Text);
            picture.text((0.0, 16.0), "Text text", Style::Body.size(14.0));
            picture.rect(Rect::new(20.0, 0.0, 9.0, 30.0), Ink::Text);
            let image = Image::new(1, 1, vec![0; 3]);
            picture.image(Rect::new(0.0, 0.0, 40.0, 9.0), image);
        });
    });
    assert_eq!(inked(&pixmap), Some([20, 16, 44, 34]));
}

#[test]
fn sizes_are_rounded_and_bounded() {
    let raster = |width, height, scale| {
        rasterize(&Picture::new(width, height), Theme::Light, scale)
            .map(|pixmap| (pixmap.width(), pixmap.height()))
    };
    assert_eq!(raster(33.3, 10.0, 1.5), Ok((50, 15)));
    assert_eq!(raster(0.0, -5.0, 1.0), Ok((1, 1)));
    assert!(matches!(
        raster(20_000.0, 1.0, 1.0),
        Err(RasterError::TooLarge { .. })
    ));
    assert!(matches!(
        raster(9000.0, 9000.0, 1.0),
        Err(RasterError::TooLarge { .. })
    ));
    assert!(matches!(
        raster(10.0, 10.0, f32::NAN),
        Err(RasterError::NotFinite { .. })
    ));
}

#[test]
fn wild_coordinates_draw_nothing_and_break_nothing() {
    for wild in [f32::NAN, f32::INFINITY, -1e30, 3e9] {
        drawn(1.5, |picture| {
            let (rect, ink) = (Rect::new(wild, 1.0, wild, 5.0), Ink::This.stroke(wild));
            picture.rounded_rect(rect, wild, Ink::Text.fill().outlined(ink.dashed()));
            picture.line((wild, 3.0), (5.0, wild), ink.dashed());
            picture.line((wild, 3.0), (5.0, 3.0), ink.dotted());
            picture.arrow((0.0, wild), (5.0, 5.0), ink);
            picture.circle((wild, 5.0), wild, ink);
            picture.text((wild, 5.0), "wild", Style::Body.size(wild));
            picture.image(rect, Image::new(1, 1, vec![0; 3]));
        });
    }
}

#[test]
fn the_same_picture_gives_the_same_bytes() {
    let draw = || {
        drawn(1.3, |picture| {
            picture.text((2.3, 20.0), "∇I_4", Style::Formula.size(13.0));
            picture.arrow((3.0, 3.0), (36.0, 20.0), Ink::This.stroke(1.5).dashed());
            picture.circle((20.0, 15.0), 6.5, Ink::Linked.fill().opacity(0.3));
        })
    };
    let (first, second) = (draw(), draw());
    assert_eq!(first.data(), second.data());
    assert!(first.pixels().iter().all(|pixel| pixel.alpha() == 255));
    assert_eq!(to_png(&first), to_png(&second));
}
