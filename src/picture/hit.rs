//! From the pointer to what is under it, and from a tag to where it is shown.

use std::borrow::Cow;

use glam::Vec2;

use super::Picture;
use super::ink::{Ink, Paint};
use super::rect::Rect;
use super::shape::{Image, Item, Shape};
use super::tag::Tag;

/// How near the pointer must be to a line or a point, in points.
const TOLERANCE: f32 = 4.0;
/// Distance and width of the outline around what is highlighted, in points.
const HALO: f32 = 2.0;

impl Picture {
    /// What the topmost tagged item at a place shows. Areas count where they are filled, lines and outlines within 4 points.
    pub fn hit(&self, at: impl Into<Vec2>) -> Option<Tag> {
        let at = at.into();
        self.items.iter().rev().find_map(|item| item.hit(at))
    }

    /// The smallest rectangle around all that shows `tag`, in points; none if nothing does.
    pub fn tagged_bounds(&self, tag: Tag) -> Option<Rect> {
        self.items
            .iter()
            .filter_map(|item| {
                let bounds = item.shown(tag)?.bounds();
                Some(item.clip.map_or(bounds, |clip| clip.intersection(&bounds)))
            })
            .reduce(|all, bounds| all.union(&bounds))
    }

    /// Outlines, in [`Ink::Linked`], of all that shows `tag`: to be drawn over the picture with
    /// [`draw_over`](super::draw_over). They carry no tags.
    pub fn highlight(&self, tag: Tag) -> Vec<Item> {
        self.items
            .iter()
            .filter_map(|item| {
                Some(Item {
                    shape: outline(item.shown(tag)?.as_ref()),
                    tag: None,
                    clip: item.clip,
                })
            })
            .collect()
    }
}

impl Item {
    fn hit(&self, at: Vec2) -> Option<Tag> {
        if self.clip.is_some_and(|clip| !clip.contains(at)) {
            return None;
        }
        let pixel = match &self.shape {
            Shape::Image {
                rect,
                image,
                first_pixel: Some(first),
            } => pixel_at(*rect, image, *first, at),
            _ => None,
        };
        pixel.or_else(|| self.tag.filter(|_| touches(&self.shape, at)))
    }

    /// The shape, or the part of an image, that shows `tag`.
    fn shown(&self, tag: Tag) -> Option<Cow<'_, Shape>> {
        if self.tag == Some(tag) {
            return Some(Cow::Borrowed(&self.shape));
        }
        match &self.shape {
            Shape::Image {
                rect,
                image,
                first_pixel: Some(first),
            } => Some(Cow::Owned(Shape::Rect {
                rect: part_of_image(*rect, image, *first, tag)?,
                radius: 0.0,
                paint: Paint::default(),
            })),
            _ => None,
        }
    }
}

/// Size of a pixel of an image drawn into `rect`, in points.
fn pixel_size(rect: Rect, image: &Image) -> Vec2 {
    Vec2::new(
        rect.width / image.width() as f32,
        rect.height / image.height() as f32,
    )
}

fn pixel_at(rect: Rect, image: &Image, first: (u32, u32), at: Vec2) -> Option<Tag> {
    rect.contains(at).then(|| {
        let within = (at - rect.min()) / pixel_size(rect, image);
        Tag::Pixel {
            x: first.0 + (within.x as u32).min(image.width() - 1),
            y: first.1 + (within.y as u32).min(image.height() - 1),
        }
    })
}

/// Where an image shows a pixel or a scan line.
fn part_of_image(rect: Rect, image: &Image, first: (u32, u32), tag: Tag) -> Option<Rect> {
    let size = pixel_size(rect, image);
    let row = |y: i64| {
        let y = y - i64::from(first.1);
        let top = rect.y + y as f32 * size.y;
        (0..i64::from(image.height()))
            .contains(&y)
            .then(|| Rect::new(rect.x, top, rect.width, size.y))
    };
    match tag {
        Tag::ScanLine(y) => row(y.into()),
        Tag::Pixel { x, y } => {
            let x = x.checked_sub(first.0).filter(|&x| x < image.width())?;
            let row = row(y.into())?;
            Some(Rect::new(
                rect.x + x as f32 * size.x,
                row.y,
                size.x,
                row.height,
            ))
        }
        _ => None,
    }
}

fn touches(shape: &Shape, at: Vec2) -> bool {
    match shape {
        Shape::Rect { rect, paint, .. } if paint.fill.is_some() => rect.contains(at),
        Shape::Rect { rect, .. } => {
            rect.grown(TOLERANCE).contains(at) && !rect.grown(-TOLERANCE).contains(at)
        }
        Shape::Polyline { points, stroke } => {
            near(points, at, TOLERANCE.max(0.5 * stroke.width), false)
        }
        Shape::Polygon { points, paint } if paint.fill.is_some() => winding(points, at) != 0,
        Shape::Polygon { points, .. } => near(points, at, TOLERANCE, true),
        Shape::Circle {
            center,
            radius,
            paint,
        } => {
            let distance = center.distance(at);
            distance <= radius + TOLERANCE
                && (paint.fill.is_some() || distance >= radius - TOLERANCE)
        }
        Shape::Text { .. } | Shape::Image { .. } => shape.bounds().contains(at),
    }
}

/// Whether a line through points passes within `distance`.
fn near(points: &[Vec2], at: Vec2, distance: f32, closed: bool) -> bool {
    let closing = points.last().zip(points.first()).filter(|_| closed);
    points
        .iter()
        .zip(points.iter().skip(1))
        .chain(closing)
        .any(|(&a, &b)| {
            let along = b - a;
            let share = (at - a).dot(along) / along.length_squared().max(f32::MIN_POSITIVE);
            (a + share.clamp(0.0, 1.0) * along).distance(at) <= distance
        })
}

/// How often a closed polygon winds around a point.
fn winding(points: &[Vec2], at: Vec2) -> i32 {
    let closing = points.last().zip(points.first());
    points
        .iter()
        .zip(points.iter().skip(1))
        .chain(closing)
        .map(|(&a, &b)| {
            let left = (b - a).perp_dot(at - a);
            if a.y <= at.y && at.y < b.y && left > 0.0 {
                1
            } else if b.y <= at.y && at.y < a.y && left < 0.0 {
                -1
            } else {
                0
            }
        })
        .sum()
}

/// A line in the linked ink around a shape.
fn outline(shape: &Shape) -> Shape {
    let stroke = Ink::Linked.stroke(HALO);
    match shape {
        Shape::Polyline { points, stroke } => Shape::Polyline {
            points: points.clone(),
            stroke: Ink::Linked.stroke(stroke.width + HALO),
        },
        Shape::Polygon { points, .. } => Shape::Polygon {
            points: points.clone(),
            paint: stroke.into(),
        },
        Shape::Circle { center, radius, .. } => Shape::Circle {
            center: *center,
            radius: radius + HALO,
            paint: stroke.into(),
        },
        Shape::Rect { .. } | Shape::Text { .. } | Shape::Image { .. } => Shape::Rect {
            rect: shape.bounds().grown(HALO),
            radius: 0.0,
            paint: stroke.into(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Style;

    #[test]
    fn the_topmost_tagged_item_answers() {
        let mut picture = Picture::new(200.0, 100.0);
        picture.tagged(Tag::Polygon(0), |picture| {
            picture.polygon([[10.0, 10.0], [90.0, 10.0], [10.0, 90.0]], Ink::Faint);
        });
        picture.tagged(Tag::Edge(3), |picture| {
            picture.line((10.0, 10.0), (10.0, 90.0), Ink::Text.stroke(1.0));
        });
        picture.tagged(Tag::Step(7), |picture| {
            picture.rect(Rect::new(20.0, 20.0, 60.0, 60.0), Ink::This.stroke(1.0));
        });
        // Decoration that lies on top and says nothing.
        picture.rect(picture.bounds(), Ink::ThisTint.fill().opacity(0.1));

        for (at, tag) in [
            ((40.0, 35.0), Some(Tag::Polygon(0))),
            ((7.0, 50.0), Some(Tag::Edge(3))),
            ((13.5, 50.0), Some(Tag::Edge(3))),
            ((15.0, 50.0), Some(Tag::Polygon(0))),
            ((5.0, 50.0), None),
            ((80.0, 60.0), Some(Tag::Step(7))),
            ((70.0, 60.0), None),
        ] {
            assert_eq!(picture.hit(at), tag, "{at:?}");
        }
        assert_eq!(
            picture.tagged_bounds(Tag::Edge(3)),
            Some(Rect::new(9.5, 9.5, 1.0, 81.0))
        );
        assert_eq!(picture.tagged_bounds(Tag::Edge(4)), None);
    }

    #[test]
    fn pixels_of_an_image_answer_with_their_place() {
        let mut picture = Picture::new(200.0, 100.0);
        let image = Image::new(4, 2, vec![0; 24]);
        picture.pixels(Rect::new(10.0, 20.0, 40.0, 20.0), image, (100, 50));
        assert_eq!(
            picture.hit((49.9, 30.0)),
            Some(Tag::Pixel { x: 103, y: 51 })
        );
        assert_eq!(picture.hit((50.0, 30.0)), None);
        let pixel = Tag::Pixel { x: 101, y: 51 };
        let cell = Rect::new(20.0, 30.0, 10.0, 10.0);
        assert_eq!(picture.tagged_bounds(pixel), Some(cell));
        assert_eq!(picture.tagged_bounds(Tag::Pixel { x: 99, y: 50 }), None);
        let row = Rect::new(10.0, 20.0, 40.0, 10.0);
        assert_eq!(picture.tagged_bounds(Tag::ScanLine(50)), Some(row));
        assert_eq!(picture.tagged_bounds(Tag::ScanLine(-3)), None);
        assert_eq!(picture.highlight(pixel).len(), 1);
    }

    #[test]
    fn what_is_cut_off_cannot_be_hit() {
        let mut picture = Picture::new(100.0, 100.0);
        picture.clipped(Rect::new(0.0, 0.0, 50.0, 100.0), |picture| {
            picture.tagged(Tag::Field("I_4"), |picture| {
                picture.text((40.0, 50.0), "I_4 = 0.514", Style::Label.size(14.0));
            });
        });
        assert_eq!(picture.hit((45.0, 46.0)), Some(Tag::Field("I_4")));
        assert_eq!(picture.hit((60.0, 46.0)), None);
        let bounds = picture.tagged_bounds(Tag::Field("I_4")).unwrap();
        assert_eq!(bounds.right(), 50.0);
        let halo = &picture.highlight(Tag::Field("I_4"))[0];
        assert!(halo.tag.is_none() && halo.clip.is_some());
    }
}
