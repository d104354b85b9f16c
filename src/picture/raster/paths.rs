//! Paths that tiny-skia fills and strokes, cut off at the clip by a mask where they leave it.

use super::super::blit::{PixelRect, Rgba};
use super::super::ink::{Paint, Stroke};
use super::{Canvas, rgba};
use tiny_skia::{Color, FillRule, LineCap, LineJoin, Mask, Path, StrokeDash, Transform};

impl Canvas<'_> {
    pub(super) fn path(&mut self, path: Option<Path>, paint: &Paint) {
        if let Some(fill) = paint.fill {
            let color = rgba(self.theme, fill.ink, fill.opacity);
            self.fill_path(path.clone(), color);
        }
        if let Some(stroke) = paint.stroke {
            self.stroke_path(path, &stroke, stroke.width * self.scale);
        }
    }

    /// `path` is in pixels; none is drawn as nothing.
    pub(super) fn fill_path(&mut self, path: Option<Path>, color: Rgba) {
        let Some(path) = path else { return };
        self.need_mask(path.bounds(), 1.0);
        self.pixmap.fill_path(
            &path,
            &paint(color),
            FillRule::Winding,
            Transform::identity(),
            mask_for(&self.mask, self.clip),
        );
    }

    /// `path` and `width` are in pixels.
    pub(super) fn stroke_path(&mut self, path: Option<Path>, stroke: &Stroke, width: f32) {
        let Some(path) = path else { return };
        self.need_mask(path.bounds(), width + 1.0);
        let lengths = stroke
            .dash
            .lengths()
            .map(|lengths| lengths.map(|length| length * self.scale).to_vec());
        let style = tiny_skia::Stroke {
            width,
            line_cap: LineCap::Butt,
            line_join: LineJoin::Round,
            dash: lengths.and_then(|lengths| StrokeDash::new(lengths, 0.0)),
            ..Default::default()
        };
        self.pixmap.stroke_path(
            &path,
            &paint(rgba(self.theme, stroke.ink, stroke.opacity)),
            &style,
            Transform::identity(),
            mask_for(&self.mask, self.clip),
        );
    }

    /// Makes the clip's mask if a path with these bounds leaves the clip.
    fn need_mask(&mut self, bounds: tiny_skia::Rect, margin: f32) {
        let all = PixelRect::whole(self.pixmap);
        let clip = self.clip;
        let leaves = bounds.left() - margin < clip.left as f32
            || bounds.top() - margin < clip.top as f32
            || bounds.right() + margin > clip.right as f32
            || bounds.bottom() + margin > clip.bottom as f32;
        if clip == all || !leaves {
            self.mask = self.mask.take().filter(|(of, _)| *of == clip);
            return;
        }
        if self.mask.as_ref().is_some_and(|(of, _)| *of == clip) {
            return;
        }
        self.mask = Mask::new(all.right as u32, all.bottom as u32).map(|mut mask| {
            let width = all.right as usize;
            for y in clip.top..clip.bottom {
                let row = &mut mask.data_mut()[y as usize * width..];
                row[clip.left as usize..clip.right as usize].fill(255);
            }
            (clip, mask)
        });
    }
}

/// The mask, if it is the one of this clip.
fn mask_for(mask: &Option<(PixelRect, Mask)>, clip: PixelRect) -> Option<&Mask> {
    mask.as_ref()
        .filter(|(of, _)| *of == clip)
        .map(|(_, mask)| mask)
}

fn paint([r, g, b, a]: Rgba) -> tiny_skia::Paint<'static> {
    let mut paint = tiny_skia::Paint::default();
    paint.set_color(Color::from_rgba8(r, g, b, a));
    paint
}
