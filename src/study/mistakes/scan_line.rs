//! Flat, Gouraud and Phong shading as a student writes them in one evening, with one classic mistake or none. With none they draw what
//! the reference draws.

use super::inclusive;
use super::model::Model;
use super::{Mistake, normals};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::illumination::SurfacePoint;
use crate::algorithms::intensity::Intensity;
use crate::algorithms::prepared_scene::{Polygon, PreparedScene};
use crate::algorithms::scan_line::{self, Corner, EdgeTable, Varying};
use crate::algorithms::texture::{self, PolygonTexture};
use crate::algorithms::vertex_normal::{self, vertex_normal};
use crate::color::Rgb;
use crate::methods::{Method, Setup};
use crate::record::Unrecorded;
use crate::scene::VertexNormals;
use glam::{DVec2, DVec3};

pub struct ScanConverter<'a> {
    setup: &'a Setup,
    prepared: &'a PreparedScene,
    method: Method,
    model: Model<'a>,
}

impl<'a> ScanConverter<'a> {
    /// `method` is flat, Gouraud or Phong shading.
    pub fn new(setup: &'a Setup, method: Method, mistake: Option<Mistake>) -> Self {
        let prepared = &setup.prepared;
        let scene = &prepared.scene;
        ScanConverter {
            setup,
            prepared,
            method,
            model: Model { scene, mistake },
        }
    }

    pub fn picture(&self) -> Frame {
        match self.method {
            Method::Phong => self.converted(
                |polygon, corner| self.normal_at(polygon, corner),
                |polygon, texture, position, (n_p, uv)| {
                    let normal = match self.model.errs(Mistake::NormalNotNormalized) {
                        true => n_p,
                        false => n_p
                            .try_normalize()
                            .unwrap_or(polygon.mesh.normal(polygon.face)),
                    };
                    let mut point = self.point(polygon, position, normal);
                    if let Some(texture) = texture {
                        point.diffuse = color_at(texture, position, uv) * point.diffuse;
                    }
                    self.model.intensity(&point, |_| true).whole
                },
            ),
            _ => self.converted(
                |polygon, corner| match self.method {
                    Method::Flat => self.lit_in_the_middle(polygon),
                    _ => self.lit_at(polygon, corner),
                },
                |_, texture, position, (intensity, uv)| match texture {
                    None => intensity.whole,
                    Some(texture) => {
                        let [rest, diffuse] = intensity.parts();
                        rest + color_at(texture, position, uv) * diffuse
                    }
                },
            ),
        }
    }

    /// All polygons, each with a value at its corners that its pixels interpolate.
    fn converted<V: Varying>(
        &self,
        value: impl Fn(&Polygon, usize) -> V,
        color: impl Fn(&Polygon, Option<&PolygonTexture>, DVec3, (V, DVec2)) -> Rgb,
    ) -> Frame {
        let mut frame = self.prepared.empty_frame();
        let (region, view) = (Focus::Frame.region(&frame), &self.prepared.view);
        let shaded = self.setup.shaded_scene();
        let mut edge_table = EdgeTable::new(view, &region);
        for polygon in self.prepared.polygons(Focus::Frame, &region) {
            let texture = shaded.texture(&polygon);
            let uvs = texture.as_ref().map_or(&[][..], PolygonTexture::corners);
            let places = polygon.corners().enumerate();
            let corners = places.map(|(corner, (_, place))| Corner {
                position: place.camera,
                value: (
                    value(&polygon, corner),
                    uvs.get(corner).copied().unwrap_or_default(),
                ),
            });
            let color = |position, value| color(&polygon, texture.as_ref(), position, value);
            if self.model.errs(Mistake::InclusiveScanRule) {
                inclusive::fill(corners, view, &mut frame, color);
            } else {
                edge_table.fill::<scan_line::Event<V::Recorded>, _>(
                    corners,
                    &mut frame,
                    &mut Unrecorded,
                    |_, pixel, value| color(pixel.position(view), value),
                );
            }
        }
        frame
    }

    fn point<'b>(&self, polygon: &Polygon<'b>, position: DVec3, normal: DVec3) -> SurfacePoint<'b> {
        let eye = self.prepared.view.eye;
        let point = SurfacePoint::seen_from(eye, position, normal, polygon.material);
        SurfacePoint {
            normal: self.model.turned(normal, point.to_eye),
            ..point
        }
    }

    fn lit(&self, polygon: &Polygon, position: DVec3, normal: DVec3) -> Intensity {
        let point = self.point(polygon, position, normal);
        self.model.intensity(&point, |_| true)
    }

    fn lit_in_the_middle(&self, polygon: &Polygon) -> Intensity {
        let vertices = polygon.mesh.face(polygon.face);
        let places = vertices.iter().map(|&vertex| polygon.mesh.position(vertex));
        let mut normal = polygon.mesh.normal(polygon.face);
        if self.model.errs(Mistake::NormalNotNormalized) {
            normal *= 2.0 * normals::area(polygon.mesh, polygon.face);
        }
        self.lit(
            polygon,
            places.sum::<DVec3>() / vertices.len() as f64,
            normal,
        )
    }

    fn lit_at(&self, polygon: &Polygon, corner: usize) -> Intensity {
        let vertex = polygon.mesh.face(polygon.face)[corner];
        let is_averaged = polygon.vertex_normals == VertexNormals::AVERAGED;
        let normal = if is_averaged && self.model.errs(Mistake::NormalNotNormalized) {
            let around = polygon.mesh.faces_around(vertex).iter();
            around.map(|&face| polygon.mesh.normal(face as usize)).sum()
        } else {
            self.normal_at(polygon, corner)
        };
        self.lit(polygon, polygon.mesh.position(vertex), normal)
    }

    fn normal_at(&self, polygon: &Polygon, corner: usize) -> DVec3 {
        let (at, normals) = (polygon.corner(corner), polygon.vertex_normals);
        vertex_normal::<vertex_normal::Event>(at, normals, &mut Unrecorded)
    }
}

fn color_at(texture: &PolygonTexture, position: DVec3, uv: DVec2) -> Rgb {
    texture.color_at::<texture::Event>(position, uv, &mut Unrecorded)
}
