//! A plain scalar scan converter in f32: edges and spans interpolated one after another, pixel by pixel, as most would write it.

use glam::{DVec2, DVec3, Vec3};
use lightwalk::algorithms::fast_phong::{ExpandedNormal, middle_of};
use lightwalk::algorithms::gouraud::Event;
use lightwalk::algorithms::illumination::{SurfacePoint, illuminate};
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::vertex_normal::vertex_normal;
use lightwalk::numeric::{Quadratic, Setup};
use lightwalk::record::Unrecorded;
use lightwalk::render::Method;
use lightwalk::scene::Light;

#[derive(Clone, Copy)]
struct Vertex {
    x: f32,
    y: f32,
    inverse_depth: f32,
    /// Its colour, or its normal.
    value: Vec3,
}

pub struct PlainFrame {
    width: usize,
    height: usize,
    color: Vec<[f32; 3]>,
    inverse_depth: Vec<f32>,
}

impl PlainFrame {
    pub fn new(width: u32, height: u32) -> Self {
        let pixels = (width * height) as usize;
        PlainFrame {
            width: width as usize,
            height: height as usize,
            color: vec![[0.0; 3]; pixels],
            inverse_depth: vec![0.0; pixels],
        }
    }

    fn pixels(&self, span: &Span) -> std::ops::Range<usize> {
        let row = span.y * self.width;
        row + span.first..row + span.end
    }

    pub fn pixel(&self, x: u32, y: u32) -> [f32; 3] {
        self.color[y as usize * self.width + x as usize]
    }
}

/// A scene of one material and one directional light, made ready.
pub struct Plain<'a> {
    prepared: &'a PreparedScene,
    method: Method,
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
    /// By triangle, for flat shading.
    colors: Vec<Vec3>,
    /// Unit, from each triangle.
    to_eye: Vec<Vec3>,
    to_light: Vec3,
    diffuse: Vec3,
    ambient: Vec3,
}

impl<'a> Plain<'a> {
    pub fn new(prepared: &'a PreparedScene, method: Method) -> Self {
        let (scene, mesh) = (&prepared.scene, &prepared.tessellation.meshes[0]);
        let material = &scene.materials[0];
        let lit = |position: DVec3, normal: DVec3| {
            let point = SurfacePoint {
                position,
                normal,
                to_eye: (prepared.view.eye - position).normalize(),
                material,
                diffuse: material.diffuse,
            };
            let color =
                illuminate::<Event, _>(&point, &prepared.lighting(), &mut Unrecorded, |_, _| true);
            DVec3::from(color.whole.channels()).as_vec3()
        };
        let vertex = |vertex: u32| {
            let position = mesh.position(vertex);
            let camera = prepared.view.to_camera(position);
            let screen = prepared.view.to_screen(camera).as_vec2();
            let normal = vertex_normal::<Event>(mesh, vertex, &mut Unrecorded);
            Vertex {
                x: screen.x,
                y: screen.y,
                inverse_depth: (1.0 / camera.z) as f32,
                value: match method {
                    Method::Gouraud => lit(position, normal),
                    _ => normal.as_vec3(),
                },
            }
        };
        let faces = 0..mesh.face_count();
        let middle = |face: usize| {
            let corners = mesh.face(face).iter();
            corners.map(|&v| mesh.position(v)).sum::<DVec3>() / 3.0
        };
        let Light::Directional { toward, color } = scene.lights[0] else {
            panic!("the light of the benchmark is directional");
        };
        let vector = |color: lightwalk::color::Rgb| DVec3::from(color.channels()).as_vec3();
        Plain {
            prepared,
            method,
            vertices: (0..mesh.vertex_count() as u32).map(vertex).collect(),
            triangles: (faces.clone())
                .map(|face| [0, 1, 2].map(|i| mesh.face(face)[i]))
                .collect(),
            colors: (faces.clone())
                .map(|face| lit(middle(face), mesh.normal(face)))
                .collect(),
            to_eye: (faces.clone())
                .map(|face| (prepared.view.eye - middle(face)).normalize().as_vec3())
                .collect(),
            to_light: -toward.as_vec3(),
            diffuse: vector(material.diffuse * color),
            ambient: vector(material.ambient * scene.ambient),
        }
    }

    pub fn draw(&self, frame: &mut PlainFrame) {
        frame.color.fill([0.0; 3]);
        frame.inverse_depth.fill(0.0);
        for number in 0..self.triangles.len() {
            let corners = self.triangles[number].map(|vertex| self.vertices[vertex as usize]);
            match self.method {
                Method::Flat => {
                    let color = self.colors[number].to_array();
                    spans(&corners, frame, |span, frame| {
                        let mut z = span.depth;
                        for i in frame.pixels(&span) {
                            if z > frame.inverse_depth[i] {
                                frame.inverse_depth[i] = z;
                                frame.color[i] = color;
                            }
                            z += span.depth_step;
                        }
                    });
                }
                Method::Gouraud => {
                    spans(&corners, frame, |span, frame| {
                        let (mut z, mut color) = (span.depth, span.value);
                        for i in frame.pixels(&span) {
                            if z > frame.inverse_depth[i] {
                                frame.inverse_depth[i] = z;
                                frame.color[i] = color.to_array();
                            }
                            z += span.depth_step;
                            color += span.step;
                        }
                    });
                }
                Method::Phong => {
                    let to_eye = self.to_eye[number];
                    spans(&corners, frame, |span, frame| {
                        let (mut z, mut normal) = (span.depth, span.value);
                        for i in frame.pixels(&span) {
                            if z > frame.inverse_depth[i] {
                                let mut n = normal / normal.length();
                                if n.dot(to_eye) < 0.0 {
                                    n = -n;
                                }
                                let n_dot_l = n.dot(self.to_light).max(0.0);
                                let color = self.ambient + self.diffuse * n_dot_l;
                                frame.inverse_depth[i] = z;
                                frame.color[i] = color.to_array();
                            }
                            z += span.depth_step;
                            normal += span.step;
                        }
                    });
                }
                _ => self.fast_phong(number, &corners, frame),
            }
        }
    }

    fn fast_phong(&self, number: usize, corners: &[Vertex; 3], frame: &mut PlainFrame) {
        let screen = corners.map(|corner| DVec2::new(corner.x.into(), corner.y.into()));
        let expanded = ExpandedNormal::over(
            &Setup::new(screen),
            corners.map(|corner| corner.value.as_dvec3()),
            self.prepared.tessellation.meshes[0].normal(number),
            self.to_eye[number].as_dvec3(),
        );
        let series = Quadratic::of_cosine(&expanded.normal, self.to_light.as_dvec3());
        let middle = middle_of(screen);
        spans(corners, frame, |span, frame| {
            let (x, y) = (span.first as f64 + 0.5, span.y as f64 + 0.5);
            let start = series.differences(x - middle.x, y - middle.y);
            let (mut c, mut first_difference) = (start.value as f32, start.first as f32);
            let second_difference = start.second as f32;
            let mut z = span.depth;
            for i in frame.pixels(&span) {
                if z > frame.inverse_depth[i] {
                    let color = self.ambient + self.diffuse * c.max(0.0);
                    frame.inverse_depth[i] = z;
                    frame.color[i] = color.to_array();
                }
                z += span.depth_step;
                c += first_difference;
                first_difference += second_difference;
            }
        });
    }
}

/// Columns `first..end` of row `y`: depth and value at the first, and what a column adds to each.
struct Span {
    y: usize,
    first: usize,
    end: usize,
    depth: f32,
    depth_step: f32,
    value: Vec3,
    step: Vec3,
}

/// Goes down the rows of a triangle.
#[inline(always)]
fn spans(
    corners: &[Vertex; 3],
    frame: &mut PlainFrame,
    mut fill: impl FnMut(Span, &mut PlainFrame),
) {
    let mut by_height = *corners;
    by_height.sort_by(|a, b| a.y.total_cmp(&b.y));
    let [top, middle, bottom] = by_height;
    let centre = |edge: f32, size: usize| ((edge - 0.5).ceil() as usize).min(size);
    for y in centre(top.y, frame.height)..centre(bottom.y, frame.height) {
        let y_4 = y as f32 + 0.5;
        let (from, to) = if y_4 < middle.y {
            (top, middle)
        } else {
            (middle, bottom)
        };
        let (a, b) = (on_edge(&top, &bottom, y_4), on_edge(&from, &to, y_4));
        let (left, right) = if a.x <= b.x { (a, b) } else { (b, a) };
        let (first, end) = (centre(left.x, frame.width), centre(right.x, frame.width));
        if first < end {
            let share = 1.0 / (right.x - left.x);
            let depth_step = (right.inverse_depth - left.inverse_depth) * share;
            let step = (right.value - left.value) * share;
            let ahead = first as f32 + 0.5 - left.x;
            let span = Span {
                y,
                first,
                end,
                depth: left.inverse_depth + depth_step * ahead,
                depth_step,
                value: left.value + step * ahead,
                step,
            };
            fill(span, frame);
        }
    }
}

fn on_edge(upper: &Vertex, lower: &Vertex, y: f32) -> Vertex {
    let t = (y - upper.y) / (lower.y - upper.y);
    Vertex {
        x: upper.x + (lower.x - upper.x) * t,
        y,
        inverse_depth: upper.inverse_depth + (lower.inverse_depth - upper.inverse_depth) * t,
        value: upper.value + (lower.value - upper.value) * t,
    }
}
