//! The current hemicube, its faces folded down into a cross: the pixels that show j.

use super::Layout;
use crate::picture::{Image, Ink, Picture, Rect, Style, Tag};

/// sRGB of the blue in which j is drawn, readable on every theme.
const BLUE: [u8; 3] = [0x2a, 0x8c, 0xc8];
const TEXT: f32 = 11.0;

pub fn draw(picture: &mut Picture, layout: &Layout, place: Rect) {
    let Some(resolution) = layout.state.resolution else {
        return;
    };
    let quarter = 0.25 * place.width;
    let middle = place.grown(-quarter);
    // The top, and four halves around it.
    for face in [
        middle,
        Rect {
            height: quarter,
            ..middle.shifted([0.0, -quarter].into())
        },
        Rect {
            height: quarter,
            ..middle.shifted([0.0, 2.0 * quarter].into())
        },
        Rect {
            width: quarter,
            ..middle.shifted([-quarter, 0.0].into())
        },
        Rect {
            width: quarter,
            ..middle.shifted([2.0 * quarter, 0.0].into())
        },
    ] {
        picture.rect(face, Ink::Faint);
        picture.rect(face, Ink::Rule.stroke(1.0));
    }
    let side = 2 * resolution;
    let mut bytes = vec![0; 4 * (side * side) as usize];
    let (pixels, _) = bytes.as_chunks_mut::<4>();
    let largest = layout
        .state
        .pixels
        .iter()
        .fold(0.0, |most: f64, pixel| most.max(pixel.3));
    let mut newest = None;
    for &(face, column, row, delta, step) in layout.state.pixels.iter() {
        let (x, y) = unfolded(face, column, row, resolution);
        let [r, g, b] = BLUE;
        let opacity = (90.0 + 165.0 * delta / largest) as u8;
        if let Some(pixel) = pixels.get_mut((y * side + x) as usize) {
            *pixel = [r, g, b, opacity];
        }
        newest = Some((x, y, step));
    }
    picture.image(place, Image::new(side, side, bytes));
    if let Some((x, y, step)) = newest {
        let size = place.width / side as f32;
        let (x, y) = (place.x + x as f32 * size, place.y + y as f32 * size);
        let pixel = Rect::new(x, y, size, size).grown((2.5 - 0.5 * size).max(0.0));
        picture.tagged(Tag::Step(step), |picture| {
            picture.rect(pixel, Ink::This);
        });
    }
    let corner = Rect::new(place.x, place.y, quarter, TEXT + 4.0);
    let strings = format!("{resolution}^2");
    let set = Style::Label.size(TEXT).ink(Ink::Muted);
    if set.width(&strings) <= quarter {
        picture.text_in(corner, strings, set);
    }
}

/// Where a pixel lies in the square around the cross, from its upper left corner. Face 0 is the top, with columns to the right and
/// rows upward; the others follow counter-clockwise from the one above it, their horizon outward.
fn unfolded(face: u32, column: u32, row: u32, resolution: u32) -> (u32, u32) {
    let last = resolution - 1;
    let half = resolution / 2;
    // From the edge of the top outward.
    let out = last - row.min(last);
    let (along, back) = (half + column, half + last - column.min(last));
    match face {
        0 => (along, half + last - row.min(last)),
        1 => (along, half.saturating_sub(out + 1)),
        2 => (half.saturating_sub(out + 1), back),
        3 => (back, half + resolution + out),
        _ => (half + resolution + out, along),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn every_pixel_above_the_horizon_has_a_place_of_its_own_in_the_cross() {
        let resolution = 8;
        let mut places = HashSet::new();
        for face in 0..5 {
            for row in if face == 0 { 0 } else { resolution / 2 }..resolution {
                for column in 0..resolution {
                    let (x, y) = unfolded(face, column, row, resolution);
                    assert!(x < 2 * resolution && y < 2 * resolution);
                    assert!(places.insert((x, y)), "{face} {column} {row}");
                }
            }
        }
        assert_eq!(places.len() as u32, 3 * resolution * resolution);
        // The sides meet the top where they are highest: its upper edge, and its right one.
        assert_eq!(unfolded(1, 0, 7, 8).1 + 1, unfolded(0, 0, 7, 8).1);
        assert_eq!(unfolded(4, 0, 7, 8).0, unfolded(0, 7, 0, 8).0 + 1);
    }
}
