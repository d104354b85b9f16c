//! The cosines of one triangle as Taylor series about its middle, and their values along its spans.

use super::event::{Cosine, Event};
use crate::algorithms::illumination;
use crate::algorithms::incidence::Incidence;
use crate::algorithms::prepared_scene::{Polygon, PreparedScene};
use crate::algorithms::scan_line::{Corner, Pixel};
use crate::color::Rgb;
use crate::numeric::{Differences, LinearNormal, PowerTable, Quadratic, slopes};
use crate::record::Recorder;
use crate::scene::{Highlight, View};
use glam::{DVec2, DVec3};

/// Below this length N_0 points nowhere: vertex normals that cancel out.
const VANISHED: f64 = 1e-6;

/// Phong's model over one triangle of the screen.
#[derive(Default)]
pub struct Expansion {
    /// The point of expansion, on the screen.
    middle: DVec2,
    ambient: Rgb,
    /// Two for each light: those of its diffuse and of its specular term.
    lights: Vec<[Term; 2]>,
    /// The pixel that the differences have reached.
    at: Option<(u32, u32)>,
}

/// The diffuse or the specular term of one light.
struct Term {
    cosine: Cosine,
    /// k · I_light · f_att
    factor: Rgb,
    series: Quadratic,
    running: Differences<f64>,
    exact: Exact,
}

/// A cosine at any place of the triangle, with a normal of unit length there.
#[derive(Clone, Copy)]
struct Exact {
    normal: LinearNormal,
    /// L or H
    toward: DVec3,
    /// V, for R·V.
    mirrored_to: Option<DVec3>,
}

impl Expansion {
    /// Expands the cosines of every light about `middle`, usually that of the triangle of `polygon`, given the unit normals at its
    /// corners.
    pub fn expand<R: Recorder<Event>>(
        &mut self,
        triangle: &[Corner<DVec3>; 3],
        middle: Middle,
        polygon: &Polygon,
        prepared: &PreparedScene,
        recorder: &mut R,
    ) {
        let screen = triangle.map(|corner| prepared.view.to_screen(corner.position));
        self.middle = middle.screen;
        let position = prepared.view.from_screen(middle.screen, middle.depth);
        let to_eye = (prepared.view.eye - position).normalize_or_zero();
        let ExpandedNormal {
            normal,
            vanished,
            turned,
        } = ExpandedNormal::over(
            screen,
            triangle.map(|corner| corner.value),
            middle.screen,
            polygon.mesh.normal(polygon.face),
            to_eye,
        );
        self.at = None;
        self.lights.clear();
        let LinearNormal { n_0, n_x, n_y } = normal;
        for (number, corner) in (0..).zip(triangle) {
            recorder.step(|| Event::TriangleCorner {
                number,
                place: screen[number as usize],
                depth: corner.position.z,
                normal: corner.value,
            });
        }
        recorder.step(|| Event::NormalAtMiddle {
            middle: self.middle,
            depth: middle.depth,
            n_0,
            vanished,
            turned,
            cut: middle.of_pieces,
        });
        recorder.step(|| Event::NormalSlopes { n_x, n_y });
        recorder.step(|| Event::NormalSquared {
            squared: normal.unit().squared(),
        });
        let unit = n_0.normalize_or_zero();
        recorder.enter(|| {
            let normal = unit;
            illumination::Event::Illumination { position, normal }.into()
        });
        recorder.step(|| illumination::Event::Viewer { to_eye, turned }.into());
        let k_a = polygon.material.ambient;
        self.ambient = k_a * prepared.scene.ambient;
        let term = self.ambient;
        recorder.step(|| illumination::Event::Ambient { k_a, term }.into());

        for (light, source) in prepared.scene.lights.iter().enumerate() {
            let incidence = Incidence::of(light, source, position);
            let to_light = incidence.to_light;
            let n_dot_l = unit.dot(to_light);
            recorder.enter(|| illumination::Event::light(&incidence, n_dot_l).into());
            recorder.step(|| illumination::Event::ToLight { to_light, n_dot_l }.into());
            let arriving = incidence.color * incidence.attenuation;
            let diffuse = Exact {
                normal,
                toward: to_light,
                mirrored_to: None,
            };
            let (cosine, specular) = highlight(polygon, diffuse, to_eye, recorder);
            let material = polygon.material;
            self.lights.push([
                Term::new(Cosine::NDotL, material.diffuse * arriving, diffuse),
                Term::new(cosine, material.specular * arriving, specular),
            ]);
            for term in &self.lights[light] {
                term.exact.expanded(term.cosine, recorder);
                recorder.step(|| Event::Series {
                    cosine: term.cosine,
                    series: term.series,
                });
            }
            recorder.leave(|| Event::LightExpanded);
        }
        recorder.leave(|| Event::Expanded);
    }

    /// The intensity of a pixel, but for I_d, and I_d: apart, so that a texture does not take away what was added. Pixels of a triangle come row by row, from left to right.
    #[inline]
    pub fn shade<R: Recorder<Event>>(
        &mut self,
        pixel: Pixel,
        powers: &PowerTable,
        recorder: &mut R,
    ) -> [Rgb; 2] {
        let Pixel { x, y, first, .. } = pixel;
        let on_screen = |x: u32| DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5) - self.middle;
        let steps = match self.at {
            Some((before, row)) if row == y => x - before,
            _ => {
                let start = on_screen(first);
                for (light, terms) in self.lights.iter_mut().enumerate() {
                    for term in terms {
                        term.running = term.series.differences(start.x, start.y);
                        recorder.step(|| term.started(light));
                    }
                }
                x - first
            }
        };
        self.at = Some((x, y));

        let place = on_screen(x);
        let (mut rest, mut diffuse_sum) = (self.ambient, Rgb::BLACK);
        for (light, [diffuse, specular]) in self.lights.iter_mut().enumerate() {
            for term in [&mut *diffuse, &mut *specular] {
                (0..steps).for_each(|_| term.running.advance());
                recorder.step(|| term.evaluated(light, place));
            }
            if diffuse.running.value > 0.0 {
                let power = powers.power(specular.running.value);
                let i_d = diffuse.factor * diffuse.running.value;
                let i_s = specular.factor * power;
                recorder.step(|| Event::LightSummed { power, i_d, i_s });
                rest += i_s;
                diffuse_sum += i_d;
            }
        }
        [rest, diffuse_sum]
    }
}

impl Term {
    fn new(cosine: Cosine, factor: Rgb, exact: Exact) -> Self {
        let series = exact.series();
        Term {
            cosine,
            factor,
            series,
            running: series.differences(0.0, 0.0),
            exact,
        }
    }

    fn started(&self, light: usize) -> Event {
        Event::DifferencesStarted {
            light: light as u16,
            cosine: self.cosine,
            running: self.running,
        }
    }

    fn evaluated(&self, light: usize, place: DVec2) -> Event {
        Event::CosineEvaluated {
            light: light as u16,
            cosine: self.cosine,
            running: self.running,
            direct: self.series.at(place.x, place.y),
            exact: self.exact.at(place),
        }
    }
}

impl Exact {
    fn at(&self, place: DVec2) -> f64 {
        let n = self.normal.at(place.x, place.y).normalize_or_zero();
        let cosine = n.dot(self.toward);
        match self.mirrored_to {
            None => cosine,
            Some(to_eye) => 2.0 * cosine * n.dot(to_eye) - self.toward.dot(to_eye),
        }
    }

    /// Tells what the series is made of: the dot product with N, or of R·V the series of N·V beside that of N·L.
    fn expanded<R: Recorder<Event>>(&self, cosine: Cosine, recorder: &mut R) {
        let unit = self.normal.unit();
        let Some(to_eye) = self.mirrored_to else {
            recorder.step(|| Event::DotProduct {
                cosine,
                along: unit.along(self.toward),
            });
            return;
        };
        let cosine = Cosine::NDotV;
        recorder.step(|| Event::DotProduct {
            cosine,
            along: unit.along(to_eye),
        });
        recorder.step(|| Event::Series {
            cosine,
            series: Quadratic::of_cosine(&self.normal, to_eye),
        });
    }

    /// R·V is 2(N·L)(N·V) − L·V, so that its series comes from those of N·L and N·V.
    fn series(&self) -> Quadratic {
        if self.normal.n_0 == DVec3::ZERO {
            return Quadratic::constant(0.0);
        }
        let series = Quadratic::of_cosine(&self.normal, self.toward);
        match self.mirrored_to {
            None => series,
            Some(to_eye) => series
                .product(Quadratic::of_cosine(&self.normal, to_eye))
                .scaled(2.0, -self.toward.dot(to_eye)),
        }
    }
}

/// The cosine of the specular term, for the light of `diffuse`.
fn highlight<R: Recorder<Event>>(
    polygon: &Polygon,
    diffuse: Exact,
    to_eye: DVec3,
    recorder: &mut R,
) -> (Cosine, Exact) {
    let shininess = polygon.material.shininess;
    let normal = diffuse.normal.n_0.normalize_or_zero();
    let to_light = diffuse.toward;
    match polygon.material.highlight {
        Highlight::Phong => {
            recorder.step(|| {
                let mirrored = 2.0 * normal.dot(to_light) * normal - to_light;
                let r_dot_v = mirrored.dot(to_eye);
                illumination::Event::Mirrored {
                    mirrored,
                    r_dot_v,
                    shininess,
                }
                .into()
            });
            let exact = Exact {
                mirrored_to: Some(to_eye),
                ..diffuse
            };
            (Cosine::RDotV, exact)
        }
        Highlight::Blinn => {
            let halfway = (to_light + to_eye).normalize_or_zero();
            recorder.step(|| {
                let n_dot_h = normal.dot(halfway);
                illumination::Event::Halfway {
                    halfway,
                    n_dot_h,
                    shininess,
                }
                .into()
            });
            let exact = Exact {
                toward: halfway,
                ..diffuse
            };
            (Cosine::NDotH, exact)
        }
    }
}

/// The point of expansion: a place on the screen, and the depth of what is seen there.
#[derive(Clone, Copy)]
pub struct Middle {
    screen: DVec2,
    depth: f64,
    /// Of all pieces of a triangle that was cut.
    of_pieces: bool,
}

impl Middle {
    /// Of a triangle, where 1/depth is the mean of the corners'.
    pub fn of<V>(triangle: &[Corner<V>; 3], view: &View) -> Self {
        let sum: f64 = triangle.iter().map(|c| 1.0 / c.position.z).sum();
        Middle {
            screen: middle_of(triangle.each_ref().map(|c| view.to_screen(c.position))),
            depth: 3.0 / sum,
            of_pieces: false,
        }
    }

    /// Of the pieces of one polygon together, by their areas on the screen. None where they have no area.
    pub fn of_pieces<V>(pieces: &[[Corner<V>; 3]], view: &View) -> Option<Self> {
        let (mut area, mut place, mut inverse_depth) = (0.0, DVec2::ZERO, 0.0);
        for piece in pieces {
            let [a, b, c] = piece.each_ref().map(|c| view.to_screen(c.position));
            let weight = (b - a).perp_dot(c - a).abs();
            let middle = Middle::of(piece, view);
            area += weight;
            place += weight * middle.screen;
            inverse_depth += weight / middle.depth;
        }
        (area > 0.0).then(|| Middle {
            screen: place / area,
            depth: area / inverse_depth,
            of_pieces: true,
        })
    }
}

fn middle_of([a, b, c]: [DVec2; 3]) -> DVec2 {
    (a + b + c) / 3.0
}

/// N over a triangle, linear on the screen.
struct ExpandedNormal {
    /// x and y count from the point of expansion.
    normal: LinearNormal,
    /// Whether the corners' normals cancel out there, so that the normal of the face is used.
    vanished: bool,
    /// Whether it was turned toward the eye.
    turned: bool,
}

impl ExpandedNormal {
    /// `to_eye` leads from the point of expansion to the eye, of any length.
    fn over(
        screen: [DVec2; 3],
        normals: [DVec3; 3],
        middle: DVec2,
        face: DVec3,
        to_eye: DVec3,
    ) -> Self {
        let [n_x, n_y] = slopes(screen, normals);
        let mut n_0 = (normals[0] + normals[1] + normals[2]) / 3.0;
        let beside = middle - middle_of(screen);
        if beside != DVec2::ZERO && n_x.is_finite() && n_y.is_finite() {
            n_0 += beside.x * n_x + beside.y * n_y;
        }
        let vanished = n_0.length() < VANISHED;
        // A triangle without area has no slopes, nor pixels to notice it.
        let linear = !vanished && n_x.is_finite() && n_y.is_finite();
        let normal = LinearNormal {
            n_0: if vanished { face } else { n_0 },
            n_x: if linear { n_x } else { DVec3::ZERO },
            n_y: if linear { n_y } else { DVec3::ZERO },
        };
        let turned = normal.n_0.dot(to_eye) < 0.0;
        ExpandedNormal {
            normal: if turned { normal.reversed() } else { normal },
            vanished,
            turned,
        }
    }
}
