//! A renderer on the CPU: what egui hands to a graphics card, rasterised here, so that the window can be looked at without one.

use egui::epaint::{ImageData, Mesh, Primitive};
use egui::{Color32, ColorImage, TextureId, TexturesDelta};
use egui_kittest::TestRenderer;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;
use tiny_skia::Pixmap;

/// The textures that egui asked for; clones share them.
#[derive(Clone, Default)]
pub struct Textures(Rc<RefCell<HashMap<TextureId, ColorImage>>>);

impl TestRenderer for Textures {
    fn handle_delta(&mut self, delta: &mut TexturesDelta) {
        let mut textures = self.0.borrow_mut();
        for (id, deltas) in delta.set.drain() {
            for delta in deltas {
                let ImageData::Color(image) = &delta.image;
                match delta.pos {
                    None => drop(textures.insert(id, (**image).clone())),
                    Some([left, top]) => {
                        let whole = textures.get_mut(&id).expect("a patch follows its texture");
                        for y in 0..image.height() {
                            for x in 0..image.width() {
                                whole[(left + x, top + y)] = image[(x, y)];
                            }
                        }
                    }
                }
            }
        }
        for id in delta.free.drain() {
            textures.remove(&id);
        }
    }
}

impl Textures {
    /// The window as it would be on a screen of `size` pixels.
    pub fn paint(&self, ctx: &egui::Context, output: &egui::FullOutput, size: [u32; 2]) -> Pixmap {
        let mut pixmap = Pixmap::new(size[0], size[1]).expect("a size");
        let scale = output.pixels_per_point;
        for primitive in ctx.tessellate(output.shapes.clone(), scale) {
            let clip = primitive.clip_rect * scale;
            if let Primitive::Mesh(mesh) = primitive.primitive {
                let textures = self.0.borrow();
                for corners in mesh.indices.chunks_exact(3) {
                    triangle(
                        &mut pixmap,
                        &mesh,
                        corners,
                        scale,
                        clip,
                        &textures[&mesh.texture_id],
                    );
                }
            }
        }
        pixmap
    }
}

/// Barycentric, sampled at pixel centres; the texture is read at the nearest texel, colours are premultiplied.
fn triangle(
    pixmap: &mut Pixmap,
    mesh: &Mesh,
    corners: &[u32],
    scale: f32,
    clip: egui::Rect,
    texture: &ColorImage,
) {
    let [a, b, c] = [0, 1, 2].map(|i| mesh.vertices[corners[i] as usize]);
    let [pa, pb, pc] = [a, b, c].map(|vertex| vertex.pos * scale);
    let cross = |p: egui::Pos2, q: egui::Pos2, r: egui::Pos2| {
        (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)
    };
    let area = cross(pa, pb, pc);
    if area == 0.0 {
        return;
    }
    let bounds = egui::Rect::from_points(&[pa, pb, pc]).intersect(clip);
    let within = |value: f32, end: u32| (value.round().max(0.0) as u32).min(end);
    let (width, height) = (pixmap.width(), pixmap.height());
    for y in within(bounds.min.y, height)..within(bounds.max.y, height) {
        for x in within(bounds.min.x, width)..within(bounds.max.x, width) {
            let p = egui::pos2(x as f32 + 0.5, y as f32 + 0.5);
            let weights = [
                cross(pb, pc, p) / area,
                cross(pc, pa, p) / area,
                cross(pa, pb, p) / area,
            ];
            if weights.iter().any(|&weight| weight < 0.0) {
                continue;
            }
            let mix = |f: fn(&egui::epaint::Vertex) -> f32| {
                weights[0] * f(&a) + weights[1] * f(&b) + weights[2] * f(&c)
            };
            let texel = |share: f32, count: usize| ((share * count as f32) as usize).min(count - 1);
            let at = (
                texel(mix(|v| v.uv.x), texture.width()),
                texel(mix(|v| v.uv.y), texture.height()),
            );
            let tint = [
                mix(|v| v.color.r().into()),
                mix(|v| v.color.g().into()),
                mix(|v| v.color.b().into()),
                mix(|v| v.color.a().into()),
            ];
            over(pixmap, (y * width + x) as usize * 4, texture[at], tint);
        }
    }
}

fn over(pixmap: &mut Pixmap, index: usize, texel: Color32, tint: [f32; 4]) {
    let texel = texel.to_array().map(f32::from);
    let alpha = texel[3] * tint[3] / 255.0 / 255.0;
    for channel in 0..4 {
        let below = f32::from(pixmap.data()[index + channel]);
        let above = texel[channel] * tint[channel] / 255.0;
        pixmap.data_mut()[index + channel] = (above + below * (1.0 - alpha)).round() as u8;
    }
}
