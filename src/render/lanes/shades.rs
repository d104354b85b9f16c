//! What each method does in a span, in lanes. Vertices and directions are found in f64, as by the textbook bodies.

use super::triangle::{Along, Setup, Triangle};
use super::{LANES, Lanes, Shade};
use crate::algorithms::fast_phong::{ExpandedNormal, middle_of};
use crate::algorithms::gouraud::Event;
use crate::algorithms::illumination::{SurfacePoint, illuminate, incidence};
use crate::algorithms::prepared_scene::{Polygon, PreparedScene};
use crate::algorithms::vertex_normal::vertex_normal;
use crate::color::Rgb;
use crate::numeric::{Plane, Quadratic};
use crate::record::Unrecorded;
use crate::scene::{Object, View};
use glam::{DVec2, DVec3};

/// What the corners of polygons carry.
pub enum Values {
    OnePolygon(Vec<DVec3>),
    /// By object, then by vertex of its mesh.
    OneVertex(Vec<Vec<DVec3>>),
}

impl Values {
    pub fn at(&self, polygon: &Polygon, vertex: u32) -> DVec3 {
        match self {
            Values::OnePolygon(values) => values[polygon.number],
            Values::OneVertex(values) => values[polygon.object][vertex as usize],
        }
    }
}

/// The intensity of each polygon, at the mean of its vertices.
pub fn middles(prepared: &PreparedScene) -> Values {
    let intensity = |polygon: Polygon| {
        let positions = polygon.corners().map(|(v, _)| polygon.mesh.position(v));
        let middle = positions.sum::<DVec3>() / 3.0;
        let normal = polygon.mesh.normal(polygon.face);
        lit(prepared, polygon.object, middle, normal)
    };
    let polygons = (0..prepared.tessellation.polygon_count()).filter_map(|i| prepared.polygon(i));
    Values::OnePolygon(polygons.map(intensity).collect())
}

/// The intensity at each vertex.
pub fn lit_vertices(prepared: &PreparedScene) -> Values {
    at_vertices(prepared, |object, position, normal| {
        lit(prepared, object, position, normal)
    })
}

/// The normal at each vertex.
pub fn normals(prepared: &PreparedScene) -> Values {
    at_vertices(prepared, |_, _, normal| normal)
}

/// What `find` says of each vertex: its object, its position and the normal there.
fn at_vertices(prepared: &PreparedScene, find: impl Fn(usize, DVec3, DVec3) -> DVec3) -> Values {
    let meshes = prepared.tessellation.meshes.iter().enumerate();
    let values = meshes.map(|(object, mesh)| {
        let found = |vertex| {
            let normal = vertex_normal::<Event>(mesh, vertex, &mut Unrecorded);
            find(object, mesh.position(vertex), normal)
        };
        (0..mesh.vertex_count() as u32).map(found).collect()
    });
    Values::OneVertex(values.collect())
}

/// The intensity at a point of an object.
fn lit(prepared: &PreparedScene, object: usize, position: DVec3, normal: DVec3) -> DVec3 {
    let material = &prepared.scene.materials[prepared.scene.objects[object].material];
    let point = SurfacePoint {
        position,
        normal,
        to_eye: (prepared.view.eye - position).normalize_or_zero(),
        material,
        diffuse: material.diffuse,
    };
    let (lighting, recorder) = (prepared.lighting(), &mut Unrecorded);
    vector(illuminate::<Event, _>(&point, &lighting, recorder, |_, _| true).whole)
}

fn vector(color: Rgb) -> DVec3 {
    color.channels().into()
}

/// One colour a triangle.
#[derive(Default)]
pub struct Flat {
    color: [f32; 3],
}

impl Shade for Flat {
    fn triangle(&mut self, triangle: &Triangle, _: &Setup) {
        self.color = triangle.values[0].as_vec3().to_array();
    }

    fn span(&mut self, _: f64, _: f64) {}

    #[inline(always)]
    fn colors(&self, _: &Lanes, color: &mut [Lanes; 3]) {
        *color = self.color.map(|channel| [channel; LANES]);
    }
}

/// The colours of the vertices, interpolated.
#[derive(Default)]
pub struct Gouraud {
    color: Plane<DVec3>,
    along: [Along; 3],
}

impl Shade for Gouraud {
    fn triangle(&mut self, triangle: &Triangle, setup: &Setup) {
        self.color = setup.plane(triangle.values);
    }

    #[inline]
    fn span(&mut self, x: f64, y: f64) {
        self.along = Along::of(&self.color, x, y);
    }

    #[inline(always)]
    fn colors(&self, offset: &Lanes, color: &mut [Lanes; 3]) {
        for (channel, along) in color.iter_mut().zip(&self.along) {
            along.at(offset, channel);
        }
    }
}

/// The light that falls on an object of one material.
pub struct Surface {
    ambient: [f32; 3],
    lights: Vec<Arriving>,
}

struct Arriving {
    /// L
    to_light: DVec3,
    /// k_d · I_light
    color: [f32; 3],
}

/// By object.
pub fn surfaces(prepared: &PreparedScene) -> Vec<Surface> {
    let scene = &prepared.scene;
    let surface = |object: &Object| {
        let material = &scene.materials[object.material];
        let f32s = |color: Rgb| vector(color).as_vec3().to_array();
        let lights = scene.lights.iter().map(|light| {
            // Of a directional light, the same from everywhere
            let incidence = incidence(light, DVec3::ZERO);
            Arriving {
                to_light: incidence.to_light,
                color: f32s(material.diffuse * incidence.color),
            }
        });
        Surface {
            ambient: f32s(material.ambient * scene.ambient),
            lights: lights.collect(),
        }
    };
    scene.objects.iter().map(surface).collect()
}

/// Adds to a colour, by channel, what a light of `color` gives where its cosine is positive.
#[inline(always)]
fn add_light(sum: &mut [Lanes; 3], cosine: &Lanes, color: [f32; 3]) {
    for (sum, color) in sum.iter_mut().zip(color) {
        *sum = std::array::from_fn(|i| {
            let positive = if cosine[i] > 0.0 { cosine[i] } else { 0.0 };
            sum[i] + color * positive
        });
    }
}

#[inline(always)]
fn dot(a: &[Lanes; 3], b: &[Lanes; 3]) -> Lanes {
    std::array::from_fn(|i| a[0][i] * b[0][i] + a[1][i] * b[1][i] + a[2][i] * b[2][i])
}

/// From the eye through a place of the screen.
fn ray(view: &View, x: f64, y: f64) -> DVec3 {
    let (width, height) = (f64::from(view.width), f64::from(view.height));
    view.focal * view.forward + (x - 0.5 * width) * view.right - (y - 0.5 * height) * view.up
}

/// The normals of the vertices, interpolated and brought to unit length at every pixel.
pub struct Phong<'a> {
    view: &'a View,
    surfaces: &'a [Surface],
    object: usize,
    normal: Plane<DVec3>,
    along: [Along; 3],
    /// From the eye through the pixels of the span.
    ray: [Along; 3],
}

impl<'a> Phong<'a> {
    pub fn new(view: &'a View, surfaces: &'a [Surface]) -> Self {
        Phong {
            view,
            surfaces,
            object: 0,
            normal: Plane::default(),
            along: Default::default(),
            ray: Default::default(),
        }
    }
}

impl Shade for Phong<'_> {
    fn triangle(&mut self, triangle: &Triangle, setup: &Setup) {
        self.object = triangle.object;
        self.normal = setup.plane(triangle.values);
    }

    #[inline]
    fn span(&mut self, x: f64, y: f64) {
        self.along = Along::of(&self.normal, x, y);
        let start = ray(self.view, x, y).as_vec3().to_array();
        let step = self.view.right.as_vec3().to_array();
        self.ray = std::array::from_fn(|i| Along {
            start: start[i],
            step: step[i],
        });
    }

    #[inline(always)]
    fn colors(&self, offset: &Lanes, color: &mut [Lanes; 3]) {
        let (mut normal, mut ray) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
        for i in 0..3 {
            self.along[i].at(offset, &mut normal[i]);
            self.ray[i].at(offset, &mut ray[i]);
        }
        let (squared, away) = (dot(&normal, &normal), dot(&normal, &ray));
        // Of unit length, and on the side of the eye
        let scale: Lanes = std::array::from_fn(|i| {
            let side = if away[i] > 0.0 { -1.0 } else { 1.0 };
            side / squared[i].sqrt()
        });
        let surface = &self.surfaces[self.object];
        *color = surface.ambient.map(|channel| [channel; LANES]);
        for light in &surface.lights {
            let [x, y, z] = light.to_light.as_vec3().to_array();
            let cosine: Lanes = std::array::from_fn(|i| {
                (normal[0][i] * x + normal[1][i] * y + normal[2][i] * z) * scale[i]
            });
            add_light(color, &cosine, light.color);
        }
    }
}

/// The cosines as Taylor series over a triangle.
pub struct FastPhong<'a> {
    view: &'a View,
    surfaces: &'a [Surface],
    object: usize,
    /// The point of expansion, and a series for each light.
    middle: DVec2,
    series: Vec<Quadratic>,
    /// Of each light, along the span: c_0 + c_1·s + c_2·s²
    along: Vec<[f32; 3]>,
}

impl<'a> FastPhong<'a> {
    pub fn new(view: &'a View, surfaces: &'a [Surface]) -> Self {
        FastPhong {
            view,
            surfaces,
            object: 0,
            middle: DVec2::ZERO,
            series: Vec::new(),
            along: Vec::new(),
        }
    }
}

impl Shade for FastPhong<'_> {
    fn triangle(&mut self, triangle: &Triangle, setup: &Setup) {
        self.object = triangle.object;
        self.middle = middle_of(triangle.corners);
        let to_eye = -ray(self.view, self.middle.x, self.middle.y);
        let ExpandedNormal { normal, .. } =
            ExpandedNormal::over(setup, triangle.values, triangle.face_normal, to_eye);
        self.series.clear();
        let lights = self.surfaces[self.object].lights.iter();
        self.series
            .extend(lights.map(|light| Quadratic::of_cosine(&normal, light.to_light)));
    }

    #[inline]
    fn span(&mut self, x: f64, y: f64) {
        let (x, y) = (x - self.middle.x, y - self.middle.y);
        let along = |series: &Quadratic| series.along_x(x, y).map(|c| c as f32);
        self.along.clear();
        self.along.extend(self.series.iter().map(along));
    }

    #[inline(always)]
    fn colors(&self, offset: &Lanes, color: &mut [Lanes; 3]) {
        let surface = &self.surfaces[self.object];
        *color = surface.ambient.map(|channel| [channel; LANES]);
        for (&[c_0, c_1, c_2], light) in self.along.iter().zip(&surface.lights) {
            let cosine = offset.map(|s| (c_2 * s + c_1) * s + c_0);
            add_light(color, &cosine, light.color);
        }
    }
}
