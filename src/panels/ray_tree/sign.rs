//! The sign under a node that collapses and expands what is below, and how many rays are hidden there.

use super::arrange::Detail;
use super::node::Describer;
use super::pick::Node;
use super::strings::RAYS;
use crate::picture::{Ink, Picture, Rect, Style, Tag};
use crate::replay::rays::RayState;
use glam::Vec2;

/// Its radius.
const SIGN: f32 = 6.0;

/// Under a node what collapses it, or how many rays are hidden below.
pub(super) fn draw(
    picture: &mut Picture,
    describer: &Describer,
    ray: &RayState,
    node: &Node,
    (rect, detail): (Rect, Detail),
    area: Rect,
) {
    let bottom = Vec2::new(rect.center().x, rect.bottom());
    let center = bottom + Vec2::Y * (SIGN - 1.0);
    if node.hidden > 0 && detail == Detail::Dot {
        let tip = bottom + Vec2::new(0.0, 5.0);
        let points = [bottom - Vec2::X * 4.0, bottom + Vec2::X * 4.0, tip];
        if area.encloses(&Rect::between(points[0], tip)) {
            picture.polygon(points, Ink::Muted);
        }
        return;
    }
    if node.hidden > 0 {
        let set = Style::Bold.size(11.0).middle();
        let text = format!("+{}", counted_rays(describer, node.hidden));
        let width = set.width(&text) + 12.0;
        let pill = Rect::new(bottom.x - 0.5 * width, bottom.y + 2.0, width, 16.0);
        if !area.encloses(&pill) {
            return;
        }
        // What the viewer collapsed can be expanded; what there is no room for is gone to.
        let tag = if node.collapsed {
            Tag::Fold(ray.step)
        } else {
            Tag::Scope(ray.step)
        };
        picture.tagged(tag, |picture| {
            let paint = Ink::LinkedTint.fill().outlined(Ink::Linked.stroke(1.0));
            picture.rounded_rect(pill, 8.0, paint);
        });
        picture.text_in(pill, text, set);
        return;
    }
    if node.children == [None; 2] || detail == Detail::Dot {
        return;
    }
    if !area.encloses(&Rect::between(center, center).grown(SIGN + 1.0)) {
        return;
    }
    picture.tagged(Tag::Fold(ray.step), |picture| {
        let paint = Ink::Surface.fill().outlined(Ink::Muted.stroke(1.0));
        picture.circle(center, SIGN, paint);
    });
    let arm = Vec2::X * (SIGN - 3.0);
    picture.line(center - arm, center + arm, Ink::Text.stroke(1.5));
}

pub(super) fn counted_rays(describer: &Describer, count: usize) -> String {
    describer.format(RAYS, &[("count", &count.to_string())])
}
