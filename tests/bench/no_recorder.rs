//! Gouraud shading with the recorder calls taken out by hand, for measuring what they cost and nothing else.
//! It follows `algorithms::{gouraud, scan_line, illumination, vertex_normal}` line by line.

use glam::DVec3;
use lightwalk::algorithms::focus::{Focus, Region};
use lightwalk::algorithms::frame::Frame;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::color::Rgb;
use lightwalk::numeric::Ramp;
use lightwalk::scene::{Highlight, Light, Material, Mesh, View};

pub fn gouraud(prepared: &PreparedScene, focus: Focus, frame: &mut Frame) {
    let region = focus.region(frame);
    let mut scan_line = ScanLine::default();
    let mut corners = Vec::new();
    let mut lit: Vec<Option<Rgb>> = Vec::new();
    let mut object = None;
    for polygon in prepared.polygons(focus, &region) {
        if object != Some(polygon.object) {
            object = Some(polygon.object);
            lit.clear();
            lit.resize(polygon.mesh.vertex_count(), None);
        }
        corners.clear();
        for (vertex, place) in polygon.corners() {
            let value = *lit[vertex as usize].get_or_insert_with(|| {
                let position = polygon.mesh.position(vertex);
                let normal = vertex_normal(polygon.mesh, vertex);
                illuminate(position, normal, polygon.material, prepared)
            });
            corners.push(Corner {
                position: place.camera,
                value,
            });
        }
        scan_line.fill(&corners, &prepared.view, &region, frame, |_, _, value| {
            value
        });
    }
}

fn vertex_normal(mesh: &Mesh, vertex: u32) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for &face in mesh.faces_around(vertex) {
        sum += mesh.normal(face as usize);
    }
    let length = sum.length();
    if length > 1e-12 {
        sum / length
    } else {
        let mut normals = mesh
            .faces_around(vertex)
            .iter()
            .map(|&face| mesh.normal(face as usize));
        normals
            .find(|&normal| normal != DVec3::ZERO)
            .unwrap_or(DVec3::Z)
    }
}

fn illuminate(
    position: DVec3,
    normal: DVec3,
    material: &Material,
    prepared: &PreparedScene,
) -> Rgb {
    let to_eye = (prepared.view.eye - position).normalize_or_zero();
    let normal = if normal.dot(to_eye) < 0.0 {
        -normal
    } else {
        normal
    };
    let mut intensity = material.ambient * prepared.scene.ambient;
    for light in &prepared.scene.lights {
        intensity += illuminate_by(light, position, normal, to_eye, material);
    }
    intensity
}

fn illuminate_by(
    light: &Light,
    position: DVec3,
    normal: DVec3,
    to_eye: DVec3,
    material: &Material,
) -> Rgb {
    let (to_light, attenuation, color) = match *light {
        Light::Point {
            position: source,
            color,
            attenuation: [a0, a1, a2],
            ..
        } => {
            let distance = source.distance(position);
            let divisor = (a0 + distance * (a1 + a2 * distance)).max(f64::MIN_POSITIVE);
            (
                (source - position).normalize_or_zero(),
                1.0 / divisor,
                color,
            )
        }
        Light::Directional { toward, color } => (-toward, 1.0, color),
    };
    let n_dot_l = normal.dot(to_light);
    let diffuse = if n_dot_l > 0.0 {
        material.diffuse * color * (attenuation * n_dot_l)
    } else {
        Rgb::BLACK
    };
    let cosine = match material.highlight {
        Highlight::Phong => (2.0 * n_dot_l * normal - to_light).dot(to_eye),
        Highlight::Blinn => normal.dot((to_light + to_eye).normalize_or_zero()),
    };
    let specular = if n_dot_l > 0.0 {
        material.specular * color * (attenuation * cosine.max(0.0).powf(material.shininess))
    } else {
        Rgb::BLACK
    };
    diffuse + specular
}

#[derive(Clone, Copy)]
struct Corner {
    position: DVec3,
    value: Rgb,
}

#[derive(Clone, Copy)]
struct ScreenCorner {
    x: f64,
    y: f64,
    inverse_depth: f64,
    value: Rgb,
}

#[derive(Clone, Copy)]
struct Edge {
    x_1: f64,
    y_1: f64,
    first: u32,
    end: u32,
    slope: f64,
    x_4: f64,
    value: Ramp<Rgb>,
    inverse_depth: Ramp<f64>,
}

impl Edge {
    fn between(corners: &[ScreenCorner], from: usize, to: usize, height: u32) -> Option<Self> {
        let (upper, lower) = if corners[from].y <= corners[to].y {
            (from, to)
        } else {
            (to, from)
        };
        let (upper, lower) = (corners[upper], corners[lower]);
        let first = first_centre(upper.y, height);
        let end = first_centre(lower.y, height);
        if first >= end {
            return None;
        }
        let y_4 = f64::from(first) + 0.5;
        let mut edge = Edge {
            x_1: upper.x,
            y_1: upper.y,
            first,
            end,
            slope: (lower.x - upper.x) / (lower.y - upper.y),
            x_4: upper.x,
            value: Ramp::start(upper.value, upper.y, lower.value, lower.y, y_4),
            inverse_depth: Ramp::start(
                upper.inverse_depth,
                upper.y,
                lower.inverse_depth,
                lower.y,
                y_4,
            ),
        };
        edge.cut(y_4);
        Some(edge)
    }

    fn cut(&mut self, y_4: f64) {
        self.x_4 = self.x_1 + (y_4 - self.y_1) * self.slope;
    }

    fn advance(&mut self) {
        self.value.advance();
        self.inverse_depth.advance();
    }
}

#[derive(Default)]
struct ScanLine {
    clipped: Vec<Corner>,
    corners: Vec<ScreenCorner>,
    edge_table: Vec<Edge>,
    active: Vec<usize>,
}

impl ScanLine {
    fn fill(
        &mut self,
        polygon: &[Corner],
        view: &View,
        region: &Region,
        frame: &mut Frame,
        mut shade: impl FnMut(u32, u32, Rgb) -> Rgb,
    ) {
        clip_near(polygon, view.near, &mut self.clipped);
        self.corners.clear();
        self.corners.extend(self.clipped.iter().map(|corner| {
            let screen = view.to_screen(corner.position);
            ScreenCorner {
                x: screen.x,
                y: screen.y,
                inverse_depth: 1.0 / corner.position.z,
                value: corner.value,
            }
        }));
        let count = self.corners.len();
        self.edge_table.clear();
        for from in 0..count {
            if let Some(edge) = Edge::between(&self.corners, from, (from + 1) % count, view.height)
            {
                self.edge_table.push(edge);
            }
        }
        self.edge_table.sort_by_key(|edge| edge.first);
        let first = self
            .edge_table
            .iter()
            .map(|edge| edge.first)
            .min()
            .unwrap_or(0);
        let end = self
            .edge_table
            .iter()
            .map(|edge| edge.end)
            .max()
            .unwrap_or(0)
            .min(region.rows.end);
        self.active.clear();
        let mut next = 0;
        for y in first..end {
            while next < self.edge_table.len() && self.edge_table[next].first == y {
                self.active.push(next);
                next += 1;
            }
            self.active.retain(|&edge| self.edge_table[edge].end > y);
            if region.rows.contains(&y) {
                let y_4 = f64::from(y) + 0.5;
                for &active in &self.active {
                    self.edge_table[active].cut(y_4);
                }
                self.active
                    .sort_by(|&a, &b| self.edge_table[a].x_4.total_cmp(&self.edge_table[b].x_4));
                for pair in self.active.chunks_exact(2) {
                    fill_span(
                        y,
                        &self.edge_table[pair[0]],
                        &self.edge_table[pair[1]],
                        region,
                        frame,
                        &mut shade,
                    );
                }
            }
            for &edge in &self.active {
                self.edge_table[edge].advance();
            }
        }
    }
}

fn fill_span(
    y: u32,
    left: &Edge,
    right: &Edge,
    region: &Region,
    frame: &mut Frame,
    shade: &mut impl FnMut(u32, u32, Rgb) -> Rgb,
) {
    let (x_4, x_5) = (left.x_4, right.x_4);
    let first = first_centre(x_4, frame.width);
    let end = first_centre(x_5, frame.width);
    if first < end {
        let start = f64::from(first) + 0.5;
        let mut value = Ramp::start(left.value.value, x_4, right.value.value, x_5, start);
        let mut inverse_depth = Ramp::start(
            left.inverse_depth.value,
            x_4,
            right.inverse_depth.value,
            x_5,
            start,
        );
        for x in first..end.min(region.columns.end) {
            if x >= region.columns.start {
                let index = frame.index(x, y);
                if inverse_depth.value > frame.inverse_depth[index] {
                    let color = shade(x, y, value.value);
                    frame.inverse_depth[index] = inverse_depth.value;
                    frame.color[index] = color;
                }
            }
            value.advance();
            inverse_depth.advance();
        }
    }
}

fn clip_near(polygon: &[Corner], near: f64, clipped: &mut Vec<Corner>) {
    clipped.clear();
    for (index, &corner) in polygon.iter().enumerate() {
        let previous = polygon[(index + polygon.len() - 1) % polygon.len()];
        if (previous.position.z < near) != (corner.position.z < near) {
            let (hidden, seen) = if corner.position.z < near {
                (corner, previous)
            } else {
                (previous, corner)
            };
            let t = (near - hidden.position.z) / (seen.position.z - hidden.position.z);
            let position = hidden.position + (seen.position - hidden.position) * t;
            let value = hidden.value + (seen.value - hidden.value) * t;
            clipped.push(Corner {
                position: DVec3::new(position.x, position.y, near),
                value,
            });
        }
        if corner.position.z >= near {
            clipped.push(corner);
        }
    }
}

fn first_centre(edge: f64, size: u32) -> u32 {
    ((edge - 0.5).ceil() as u32).min(size)
}
