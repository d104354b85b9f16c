use super::*;
use crate::algorithms::phong::phong;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::scan_line::Pixel;
use crate::color::Rgb;
use crate::numeric::{LinearNormal, Quadratic};
use crate::record::{Event as _, Recording, RecordingLimit, Unrecorded, Value};
use crate::scene::{self, Limits, View};
use glam::DVec3;
use std::f64::consts::TAU;

/// The largest errors against normalised Phong along an edge whose end normals are `degrees` apart: diffuse N·L, specular (N·L)^20.
#[derive(Debug)]
struct Errors {
    /// N·L interpolated, then clamped: an edge on which no vertex is dark.
    interpolated: f64,
    /// Intensities, clamped at the vertices as the model does, interpolated.
    gouraud: [f64; 2],
    fast_phong: [f64; 2],
}

/// Over unit L of the hemisphere: 24 azimuths by 7 elevations from the horizon to the pole.
fn errors_along_an_edge(degrees: f64) -> Errors {
    const SAMPLES: u32 = 400;
    let half = 0.5 * degrees.to_radians();
    let ends = [-half, half].map(|angle| DVec3::new(angle.sin(), 0.0, angle.cos()));
    let normal = LinearNormal {
        n_0: (ends[0] + ends[1]) / 2.0,
        n_x: ends[1] - ends[0],
        n_y: DVec3::ZERO,
    };
    let clamped = |cosine: f64| cosine.clamp(0.0, 1.0);
    let mut largest = Errors {
        interpolated: 0.0,
        gouraud: [0.0; 2],
        fast_phong: [0.0; 2],
    };
    for (azimuth, elevation) in (0..24).flat_map(|a| (0..7).map(move |e| (a, e))) {
        let (sin_a, cos_a) = (TAU * f64::from(azimuth) / 24.0).sin_cos();
        let (sin_e, cos_e) = (0.25 * TAU * f64::from(elevation) / 6.0).sin_cos();
        let to_light = DVec3::new(cos_e * cos_a, cos_e * sin_a, sin_e);
        let series = Quadratic::of_cosine(&normal, to_light);
        let at_ends = ends.map(|end| end.dot(to_light));
        for sample in 0..=SAMPLES {
            let s = f64::from(sample) / f64::from(SAMPLES);
            let between = |a: f64, b: f64| (1.0 - s) * a + s * b;
            let exact = clamped(normal.at(s - 0.5, 0.0).normalize().dot(to_light));
            let fast = clamped(series.at(s - 0.5, 0.0));
            let [one, two] = at_ends.map(clamped);
            let record = |largest: &mut f64, found: f64, exact: f64| {
                *largest = largest.max((found - exact).abs());
            };
            let linear = clamped(between(at_ends[0], at_ends[1]));
            record(&mut largest.interpolated, linear, exact);
            record(&mut largest.gouraud[0], between(one, two), exact);
            record(&mut largest.fast_phong[0], fast, exact);
            let highlight = exact.powi(20);
            let gouraud = between(one.powi(20), two.powi(20));
            record(&mut largest.gouraud[1], gouraud, highlight);
            record(&mut largest.fast_phong[1], fast.powi(20), highlight);
        }
    }
    largest
}

#[test]
fn the_error_grows_with_the_angle_between_the_normals_as_known() {
    // Angle; Gouraud's diffuse and specular error, Fast Phong's, each to its printed digits.
    for (degrees, gouraud, fast_phong) in [
        (10.0, ["0.0038", "0.073"], ["0.00033", "0.001"]),
        (30.0, ["0.034", "0.50"], ["0.009", "0.032"]),
        (60.0, ["0.134", "0.94"], ["0.078", "0.45"]),
        (90.0, ["0.293", "1"], ["0.306", "1"]),
    ] {
        let found = errors_along_an_edge(degrees);
        for (error, printed) in [
            (found.interpolated, gouraud[0]),
            (found.gouraud[1], gouraud[1]),
            (found.fast_phong[0], fast_phong[0]),
            (found.fast_phong[1], fast_phong[1]),
        ] {
            let digits = printed.split_once('.').map_or(0, |(_, after)| after.len());
            assert_eq!(
                format!("{error:.digits$}"),
                printed,
                "{degrees}°: {found:?}"
            );
        }
        // Where N·L stays positive the linear cosine is off by 1 − cos(θ/2), under a light above the middle.
        let half = 0.5 * f64::to_radians(degrees);
        assert!((found.interpolated - (1.0 - half.cos())).abs() < 1e-12);
    }
}

#[test]
fn from_86_degrees_fast_phong_is_worse_than_linear_cosines_and_from_97_than_gouraud() {
    let worse = |degrees: f64, gouraud: fn(&Errors) -> f64| {
        let errors = errors_along_an_edge(degrees);
        errors.fast_phong[0] > gouraud(&errors)
    };
    let first = |gouraud: fn(&Errors) -> f64| (10..180).find(|&d| worse(f64::from(d), gouraud));
    // Where both vertices are lit, and where the light may be below the horizon of one
    assert_eq!(first(|errors| errors.interpolated), Some(86));
    assert_eq!(first(|errors| errors.gouraud[0]), Some(97));
}

fn prepared(json: &str, width: u32, height: u32) -> PreparedScene {
    let mut no_files = |_: &str| Err("no files".to_owned());
    let scene = scene::read(json.as_bytes(), &Limits::default(), &mut no_files).unwrap();
    let view = View::new(&scene.camera.unwrap(), width, height);
    PreparedScene::new(scene, view)
}

fn draw<R: Recorder<Event>>(prepared: &PreparedScene, focus: Focus, recorder: &mut R) -> Frame {
    let mut frame = Frame::new(
        prepared.view.width,
        0..prepared.view.height,
        prepared.scene.background,
    );
    fast_phong(&ShadedScene::of(prepared), focus, &mut frame, recorder);
    frame
}

fn recorded(prepared: &PreparedScene, focus: Focus) -> (Frame, Recording<Event>) {
    let mut recording = Recording::new(RecordingLimit::default());
    let frame = draw(prepared, focus, &mut recording);
    (frame, recording)
}

fn number(event: &Event, name: &str) -> f64 {
    let mut fields = Default::default();
    event.fields(&mut fields);
    match fields.get(name) {
        Some(Value::Number(number)) => number,
        other => panic!("{name}: {other:?}"),
    }
}

/// A ball beside a concave polygon, one that the eye stands in, and lights of both kinds.
const SCENE: &str = r#"{ "schema": 1, "background": [0.1, 0.2, 0.3],
  "camera": { "eye": [0, 0, 6], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 60 },
  "materials": {
    "blue": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.2, 0.3, 0.7], "specular": 0.4, "shininess": 20, "highlight": "phong" },
    "grey": { "diffuse": [0.5, 0.5, 0.5], "specular": 0.3, "shininess": 40 } },
  "objects": [
    { "name": "ball", "material": "blue", "sphere": { "center": [1, 0.5, 0], "radius": 1.4 } },
    { "name": "arrow", "material": "grey", "polygon": { "vertices": [[-3, -2, 0], [-1, 0, 0], [-3, 2, 0], [-2.4, 0.2, 0], [-2.3, 0, 0]] } },
    { "name": "floor", "material": "grey", "polygon": { "vertices": [[-9, -2, 9], [9, -2, 9], [9, -2, -9], [-9, -2, -9]] } } ],
  "lights": [
    { "point": { "position": [4, 5, 6], "color": [1, 0.9, 0.8], "attenuation": [0.5, 0.05, 0] } },
    { "directional": { "toward": [1, -1, -1], "color": [0.3, 0.3, 0.4] } } ] }"#;

#[test]
fn what_is_recorded_is_what_is_drawn_whatever_is_looked_at() {
    let prepared = prepared(SCENE, 80, 60);
    let whole = draw(&prepared, Focus::Frame, &mut Unrecorded);
    assert!(recorded(&prepared, Focus::Frame).0 == whole);
    for (x, y) in [(50, 25), (45, 20), (20, 30), (40, 50)] {
        let (pixel, recording) = recorded(&prepared, Focus::Pixel { x, y });
        assert_ne!(pixel.pixel(x, y), prepared.scene.background);
        assert_eq!(pixel.pixel(x, y), whole.pixel(x, y), "({x}, {y})");
        assert!(recording.len() > 10);
    }
    let (row, _) = recorded(&prepared, Focus::ScanLine(25));
    for x in 0..80 {
        assert_eq!(row.pixel(x, 25), whole.pixel(x, 25));
    }
}

#[test]
fn differences_stay_with_their_polynomial_and_it_with_the_cosine_where_facets_are_small() {
    let prepared = prepared(SCENE, 320, 240);
    let (_, recording) = recorded(&prepared, Focus::Frame);
    let (mut drift, mut error, mut count) = (0_f64, 0_f64, 0);
    for event in recording
        .events()
        .filter(|event| event.kind() == "CosineEvaluated")
    {
        drift = drift.max(number(event, "difference").abs());
        error = error.max(number(event, "error").abs());
        count += 1;
    }
    assert!(count > 10_000);
    assert!(drift < 1e-12, "{drift:e}");
    // Normals of a triangle of the ball span 16°, the diagonal of a cell of 11.25° by 11.25°: R turns twice as far as N.
    assert!((1e-4..1e-2).contains(&error), "{error:e}");
}

#[test]
fn far_from_light_and_eye_it_is_near_phongs_picture() {
    let json = r#"{ "schema": 1,
      "camera": { "eye": [0, 0, 200], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 0.7 },
      "materials": { "white": { "diffuse": [0.7, 0.7, 0.7], "specular": 0.3, "shininess": 20 } },
      "objects": [ { "name": "ball", "material": "white", "sphere": { "center": [0, 0, 0], "radius": 1 } } ],
      "lights": [ { "directional": { "toward": [1, -1, -1] } } ] }"#;
    let prepared = prepared(json, 160, 160);
    let fast = draw(&prepared, Focus::Frame, &mut Unrecorded);
    let mut exact = Frame::new(160, 0..160, Rgb::BLACK);
    phong(
        &ShadedScene::of(&prepared),
        Focus::Frame,
        &mut exact,
        &mut Unrecorded,
    );
    // On the outline Phong turns N pixel by pixel, where it points away from the eye by a little; a triangle is turned once.
    let seen = |x: u32, y: u32| exact.inverse_depth[exact.index(x, y)] > 0.0;
    let (mut turned, mut largest) = (0, 0_f64);
    for (x, y) in (1..159).flat_map(|y| (1..159).map(move |x| (x, y))) {
        let error = (fast.pixel(x, y).r - exact.pixel(x, y).r).abs();
        let inside = seen(x - 1, y) && seen(x + 1, y) && seen(x, y - 1) && seen(x, y + 1);
        if inside {
            largest = largest.max(error);
        } else {
            turned += u32::from(error > 0.01);
        }
    }
    assert!((5e-4..1.5e-3).contains(&largest), "{largest:e}");
    assert!(turned <= 8, "{turned}");
}

#[test]
fn a_polygon_whose_corners_have_one_normal_takes_the_light_of_its_middle() {
    let prepared = prepared(SCENE, 80, 60);
    let arrow = prepared.tessellation.first_polygon(1);
    let (frame, recording) = recorded(&prepared, Focus::Polygon(arrow));
    let triangles = recording
        .events()
        .filter(|event| event.kind() == "Triangle");
    assert_eq!(triangles.count(), 3, "five corners, ears cut");
    let mut colors: Vec<Rgb> = frame.color.clone();
    colors.retain(|&color| color != prepared.scene.background);
    colors.sort_by(|a, b| a.r.total_cmp(&b.r));
    colors.dedup_by(|a, b| (a.r - b.r).abs() < 1e-14);
    assert!(colors.len() <= 3, "{colors:?}");
}

#[test]
fn a_texture_multiplies_the_diffuse_part_alone() {
    let checker = r#""texture": { "checker": { "colors": [[0, 1, 1], [0, 1, 1]], "scale": 1 } }"#;
    let json = SCENE.replace(
        r#""shininess": 20"#,
        &format!(r#""shininess": 20, {checker}"#),
    );
    let (plain, textured) = (prepared(SCENE, 80, 60), prepared(&json, 80, 60));
    let without_red = SCENE.replace("[0.2, 0.3, 0.7]", "[0, 0.3, 0.7]");
    let [plain, textured, expected] = [plain, textured, prepared(&without_red, 80, 60)]
        .map(|prepared| draw(&prepared, Focus::Frame, &mut Unrecorded));
    assert!(plain != textured);
    for (found, expected) in textured.color.iter().zip(&expected.color) {
        assert!(
            (found.r - expected.r).abs() < 1e-14,
            "{found:?} {expected:?}"
        );
        assert!((found.g - expected.g).abs() < 1e-14);
    }
}

#[test]
fn a_triangle_cut_by_the_near_plane_is_drawn_in_pieces_without_a_gap() {
    let prepared = prepared(SCENE, 80, 60);
    let floor = prepared.tessellation.first_polygon(2);
    let (frame, _) = recorded(&prepared, Focus::Polygon(floor));
    for x in 0..80 {
        assert!(frame.inverse_depth[frame.index(x, 59)] > 0.0, "column {x}");
        assert!(frame.pixel(x, 59).g.is_finite());
    }
}

#[test]
fn a_floor_below_the_eye_is_lit_without_a_seam() {
    // The light stands high over a floor that reaches behind the eye: along every row the light changes a little from pixel to pixel, also
    // where one triangle ends and the next begins.
    let json = r#"{ "schema": 1, "camera": { "eye": [0.3, 1, -2], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 60 },
      "materials": { "floor": { "diffuse": [1, 1, 1] } },
      "objects": [ { "name": "floor", "material": "floor",
        "polygon": { "vertices": [[-9, 0, -9], [-9, 0, 11], [9, 0, 11], [9, 0, -9]] } } ],
      "lights": [ { "point": { "position": [2, 6, 3] } } ] }"#;
    let prepared = prepared(json, 80, 60);
    let frame = draw(&prepared, Focus::Frame, &mut Unrecorded);
    let mut drawn = 0;
    for y in 0..60 {
        for x in 1..80 {
            let [left, right] = [x - 1, x].map(|x| frame.index(x, y));
            if frame.inverse_depth[left] > 0.0 && frame.inverse_depth[right] > 0.0 {
                let step = frame.color[right].r - frame.color[left].r;
                assert!(step.abs() < 1e-3, "({x}, {y}): {step}");
                assert!(frame.color[right].r > 0.5);
                drawn += 1;
            }
        }
    }
    assert!(drawn > 3000, "{drawn}");
}

#[test]
fn vertex_normals_that_cancel_out_give_way_to_the_normal_of_the_face() {
    let prepared = prepared(SCENE, 80, 60);
    let polygon = prepared
        .polygon(prepared.tessellation.first_polygon(1))
        .unwrap();
    let face: Vec<Corner<DVec3>> = polygon
        .corners()
        .map(|(_, place)| Corner {
            position: place.camera,
            value: polygon.mesh.normal(polygon.face),
        })
        .collect();
    let triangle = [face[0], face[1], face[2]];
    let around = [0.0, 1.0, 2.0].map(|third| {
        let (sin, cos) = (TAU * third / 3.0).sin_cos();
        DVec3::new(cos, sin, 0.0)
    });
    let cancelling: [_; 3] = std::array::from_fn(|i| Corner {
        value: around[i],
        ..triangle[i]
    });
    let color = |triangle: [Corner<DVec3>; 3]| {
        let mut expansion = Expansion::default();
        let middle = Middle::of(&triangle, &prepared.view);
        expansion.expand(&triangle, middle, &polygon, &prepared, &mut Unrecorded);
        let pixel = Pixel {
            x: 20,
            y: 20,
            first: 15,
            inverse_depth: 1.0,
            depth_error: 0.0,
        };
        expansion
            .shade(pixel, &PowerTable::new(40.0), &mut Unrecorded)
            .into_iter()
            .sum::<Rgb>()
    };
    let (found, flat) = (color(cancelling), color(triangle));
    assert!(
        (found.r - flat.r).abs() < 1e-12 && found.r > 0.1,
        "{found:?} {flat:?}"
    );
}
