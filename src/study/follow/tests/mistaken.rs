//! Which mistakes are named for a value that differs.

use super::*;
use crate::algorithms::radiosity::Solver;
use crate::color::Rgb;
use glam::DVec3;

/// A bright and glossy glass ball, half a metre before a triangle whose back is seen, with lamps in front and behind.
const GLOSSY: &str = r#"{ "schema": 1, "background": [0.2, 0.3, 0.4],
    "camera": { "eye": [0.2, 0.3, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
    "materials": {
        "glass": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.3, 0.2, 0.1], "specular": 0.5, "shininess": 2, "highlight": "phong", "reflection": 0.2, "transmission": 0.8, "ior": 1.5 },
        "wall": { "ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.5, 0.4], "specular": 0.3, "shininess": 5 } },
    "objects": [
        { "name": "ball", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 0.8 } },
        { "name": "wall", "material": "wall", "polygon": { "vertices": [[-9, -9, -2], [0, 12, -2.5], [9, -9, -2]] } },
        { "name": "roof", "material": "wall", "sphere": { "center": [2.9, 4.3, 4], "radius": 0.5 } } ],
    "lights": [ { "point": { "position": [2, 3, 3], "color": [1, 0.9, 0.8], "attenuation": [0.6, 0.1, 0.02] } },
        { "point": { "position": [-2, 3, -6], "color": [0.5, 0.6, 0.7] } } ] }"#;

/// Two quadrilaterals of unequal area that face each other.
const ROOM: &str = r#"{ "schema": 1,
    "camera": { "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
    "materials": { "red": { "reflectance": [0.8, 0.4, 0.2] }, "lamp": { "emission": [2, 1.5, 1], "reflectance": [0.3, 0.4, 0.5] } },
    "objects": [
        { "name": "floor", "material": "red", "polygon": { "vertices": [[0, 0, 2], [2, 0, 2], [2, 0, 0], [0, 0, 0]] } },
        { "name": "lamp", "material": "lamp", "polygon": { "vertices": [[0, 1, 0], [1, 1, 0], [1, 1, 1], [0, 1, 1]] } } ],
    "lights": [] }"#;

/// A run of a scene, and the names of the mistakes for each value that differs.
struct Case {
    setup: Arc<Setup>,
    run: Run,
    focus: Focus,
}

impl Case {
    fn new(scene: &str, method: Method, focus: Focus, solver: Solver) -> Self {
        let setup = setup_of(scene, [32, 24]);
        let radiosity = crate::algorithms::enclosure::Settings {
            solver,
            ..setup.settings.get()
        };
        let settings = setup.settings.clone().with(radiosity);
        let setup = Arc::new(Setup::new(setup.prepared, settings));
        let run = Run::record(setup.clone(), method, focus, RecordingLimit::default());
        Case { setup, run, focus }
    }

    fn named(&self, trace: &[TraceLine]) -> Vec<Mistake> {
        let followed = follow(self.run.walk(), trace, TOLERANCE).unwrap();
        let with = (TOLERANCE, &followed);
        explained_by(&self.setup, (&self.run, self.focus), trace, with)
    }

    /// Follows the trace of a program that is right up to the first step of the kind where `wrong` gives another value.
    fn is_named(
        &self,
        mistake: Mistake,
        kind: &str,
        field: &str,
        wrong: impl Fn(&Case, &At) -> Option<Value>,
    ) {
        self.is_named_by(mistake, kind, field, &wrong);
    }

    /// Once for all formulas, of which there are many.
    fn is_named_by(
        &self,
        mistake: Mistake,
        kind: &str,
        field: &str,
        wrong: &dyn Fn(&Case, &At) -> Option<Value>,
    ) {
        let walk = self.run.walk();
        let otherwise = |step: usize| {
            let is_of_kind = walk.kind(step) == kind;
            let at = At { walk, step };
            let value = TraceValue::from(wrong(self, is_of_kind.then_some(&at)?)?);
            let ours = TraceValue::from(at.value(field)?);
            (!value.agrees(&ours, 1e-3)).then_some((step, value))
        };
        let found = (0..walk.len()).find_map(otherwise);
        let (step, value) = found.unwrap_or_else(|| panic!("{}: {kind}", mistake.name()));
        let mut trace = trace(walk);
        trace.truncate(step + 1);
        let traced = trace[step]
            .values
            .iter_mut()
            .find(|(name, _)| name == field);
        traced.unwrap().1 = value;
        let named = self.named(&trace);
        let followed = follow(walk, &trace, TOLERANCE).unwrap().difference;
        assert!(
            named.contains(&mistake),
            "{} of {kind}: {named:?}, {followed:?}",
            mistake.name()
        );
    }
}

/// The values that are known at a step: of itself, of the scopes around it, or recorded last before it.
struct At<'a> {
    walk: &'a dyn Walk,
    step: usize,
}

impl At<'_> {
    fn value(&self, name: &str) -> Option<Value> {
        let before = || {
            (0..self.step)
                .rev()
                .find_map(|step| self.walk.own_fields(step).get(name))
        };
        self.walk.fields(self.step).get(name).or_else(before)
    }

    fn number(&self, name: &str) -> Option<f64> {
        match self.value(name)? {
            Value::Number(number) => Some(number),
            Value::Integer(integer) => Some(integer as f64),
            _ => None,
        }
    }

    fn vector(&self, name: &str) -> Option<DVec3> {
        match self.value(name)? {
            Value::Vector(vector) => Some(vector),
            _ => None,
        }
    }

    fn color(&self, name: &str) -> Option<Rgb> {
        match self.value(name)? {
            Value::Rgb(color) => Some(color),
            _ => None,
        }
    }
}

fn rays() -> Case {
    Case::new(GLOSSY, METHOD, FOCUS, Solver::GaussSeidel)
}

#[test]
fn mistakes_that_a_wrong_input_makes_are_named_first() {
    let case = rays();
    let inputs = Mistake::ALL
        .into_iter()
        .filter(|mistake| mistake.concerns(METHOD));
    let mut named = 0;
    for mistake in inputs {
        let Some(wrong) = mistake.wrong_input(&case.setup) else {
            continue;
        };
        let wrong = Run::record(Arc::new(wrong), METHOD, FOCUS, RecordingLimit::default());
        let trace = trace(wrong.walk());
        let followed = follow(case.run.walk(), &trace, TOLERANCE).unwrap();
        // One level too many records what the run does not reach, and another depth nothing else here.
        if followed.difference.is_none() {
            continue;
        }
        assert_eq!(case.named(&trace).first(), Some(&mistake), "{followed:?}");
        named += 1;
    }
    assert!(named >= 11, "{named}");
}

#[test]
fn mistakes_of_primary_rays_and_normals_are_named_for_the_value_that_differs() {
    let case = rays();
    let through = |x: f64, y: f64, change: fn(f64, f64) -> [f64; 2]| {
        move |case: &Case, _: &At| {
            let view = &case.setup.prepared.view;
            let [x, y] = change(x, y);
            let direction =
                view.focal * view.forward + (x - 16.0) * view.right + (12.0 - y) * view.up;
            Some(Value::Vector(direction.normalize()))
        }
    };
    let (x, y) = (18.5, 10.5);
    case.is_named(
        Mistake::HalfPixelOff,
        "Ray",
        "u",
        through(x, y, |x, y| [x - 0.5, y - 0.5]),
    );
    case.is_named(
        Mistake::FlipY,
        "Ray",
        "u",
        through(x, y, |x, y| [x, 24.0 - y]),
    );
    case.is_named(
        Mistake::MirrorX,
        "Ray",
        "u",
        through(x, y, |x, y| [32.0 - x, y]),
    );
    case.is_named(Mistake::HalfPixelOff, "Through", "x_P", |_, _| {
        Some(Value::Number(18.0))
    });
    case.is_named(Mistake::FlipY, "Through", "y_P", |_, _| {
        Some(Value::Number(13.5))
    });
    case.is_named(Mistake::MirrorX, "Through", "x_P", |_, _| {
        Some(Value::Number(13.5))
    });
    case.is_named(
        Mistake::NormalNotNormalized,
        "SurfaceMet",
        "N_geometric",
        |_, at| Some(Value::Vector(at.vector("P")?)),
    );
    case.is_named(Mistake::NormalNotFlipped, "Faced", "N", |_, at| {
        let is_leaving = at.value("entering") == Some(Value::Truth(false));
        is_leaving.then_some(Value::Vector(-at.vector("N")?))
    });
}

#[test]
fn mistakes_of_the_illumination_model_are_named_for_the_value_that_differs() {
    let case = rays();
    let l = |factor: fn(f64) -> f64| {
        move |_: &Case, at: &At| Some(Value::Vector(factor(at.number("d")?) * at.vector("L")?))
    };
    case.is_named(Mistake::LightToPoint, "ToLight", "L", l(|_| -1.0));
    case.is_named(Mistake::LightNotNormalized, "ToLight", "L", l(|d| d));
    let diffuse = |factor: fn(f64, f64) -> f64| {
        move |_: &Case, at: &At| {
            let (k_d, light) = (at.color("k_d")?, at.color("I_light")?);
            let factor = factor(at.number("N_dot_L")?, at.number("d")?);
            Some(Value::Rgb(k_d * light * (at.number("f_att")? * factor)))
        }
    };
    // Wherever L and N·L are not traced.
    case.is_named(
        Mistake::CosNotClamped,
        "Diffuse",
        "I_d",
        diffuse(|n_dot_l, _| n_dot_l),
    );
    case.is_named(
        Mistake::LightToPoint,
        "Diffuse",
        "I_d",
        diffuse(|n_dot_l, _| f64::max(0.0, -n_dot_l)),
    );
    case.is_named(
        Mistake::LightNotNormalized,
        "Diffuse",
        "I_d",
        diffuse(|n_dot_l, d| d * f64::max(0.0, n_dot_l)),
    );
    // Where the ball is seen from the side, the lamp behind it has a highlight.
    let rim = Focus::Pixel { x: 22, y: 12 };
    let rim = Case::new(GLOSSY, METHOD, rim, Solver::GaussSeidel);
    rim.is_named(Mistake::SpecularWithoutNdotl, "Specular", "I_s", |_, at| {
        let (k_s, light) = (at.color("k_s")?, at.color("I_light")?);
        let is_ball = k_s == Rgb::splat(0.5);
        let cosine = at.number(if is_ball { "R_dot_V" } else { "N_dot_H" })?;
        let power = cosine.max(0.0).powf(at.number("n_s")?);
        Some(Value::Rgb(k_s * light * (at.number("f_att")? * power)))
    });
    case.is_named(Mistake::ReflectSign, "Mirrored", "R", |_, at| {
        let (n, l) = (at.vector("N")?, at.vector("L")?);
        Some(Value::Vector(l + 2.0 * n.dot(l) * n))
    });
    case.is_named(
        Mistake::ShadowIgnoresLightDistance,
        "Shadow",
        "blocked",
        |_, at| (at.number("light")? == 0.0).then_some(Value::Truth(true)),
    );
    let without_roof = GLOSSY.replace("[2.9, 4.3, 4]", "[9, 4.3, 4]");
    let without_roof = Case::new(&without_roof, METHOD, FOCUS, Solver::GaussSeidel);
    without_roof.is_named(Mistake::NoShadowOffset, "Shadow", "blocked", |_, at| {
        (at.number("light")? == 0.0).then_some(Value::Truth(true))
    });
}

#[test]
fn mistakes_of_reflection_and_refraction_are_named_for_the_value_that_differs() {
    let case = rays();
    case.is_named(Mistake::ReflectSign, "Reflection", "R", |_, at| {
        let (u, n) = (at.vector("u")?, at.vector("N")?);
        Some(Value::Vector(u + 2.0 * u.dot(n) * n))
    });
    case.is_named(Mistake::EtaInverted, "Refraction", "eta_i", |_, at| {
        (at.number("eta_i")? == 1.0).then_some(Value::Number(1.5))
    });
    case.is_named(
        Mistake::EtaNotSwappedOnLeaving,
        "Refraction",
        "eta_i",
        |_, at| (at.number("eta_i")? == 1.5).then_some(Value::Number(1.0)),
    );
    let bent = |at: &At| {
        let (u, n) = (at.vector("u")?, at.vector("N")?);
        let eta = at.number("eta_r")? / at.number("eta_i")?;
        let cos_i = at.number("cos_theta_i")?;
        let cos_r = (1.0 - eta * eta * (1.0 - cos_i * cos_i)).sqrt();
        Some(Value::Vector(eta * u - (cos_r - eta * cos_i) * n))
    };
    case.is_named(Mistake::EtaInverted, "Transmission", "T", |_, at| bent(at));
}

#[test]
fn mistakes_of_scan_conversion_are_named_for_the_value_that_differs() {
    let focus = Focus::ScanLine(12);
    let case = Case::new(GLOSSY, Method::Gouraud, focus, Solver::GaussSeidel);
    case.is_named(Mistake::InclusiveScanRule, "Span", "end", |_, at| {
        Some(Value::Number(at.number("x_5")?.ceil() + 1.0))
    });
    case.is_named(
        Mistake::NormalNotNormalized,
        "VertexNormal",
        "N_v",
        |_, at| Some(Value::Vector(at.number("length")? * at.vector("N_v")?)),
    );
    case.is_named(Mistake::NormalNotFlipped, "Illumination", "N", |_, at| {
        let (n, n_v) = (at.vector("N")?, at.vector("N_v")?);
        (n.dot(n_v) < 0.0).then_some(Value::Vector(n_v))
    });
    let case = Case::new(GLOSSY, Method::Phong, focus, Solver::GaussSeidel);
    case.is_named(Mistake::NormalNotNormalized, "PixelNormal", "N", |_, at| {
        Some(Value::Vector(at.number("length")? * at.vector("N")?))
    });
}

#[test]
fn mistakes_of_radiosity_are_named_for_the_value_that_differs() {
    let gathered = Case::new(ROOM, Method::Radiosity, Focus::Frame, Solver::GaussSeidel);
    let times = |field: &'static str, factor: f64| {
        move |_: &Case, at: &At| Some(Value::Number(factor * at.number(field)?))
    };
    let over_pi = std::f64::consts::FRAC_1_PI;
    gathered.is_named(
        Mistake::PiTwice,
        "Exchanged",
        "F_ij",
        times("F_ij", over_pi),
    );
    gathered.is_named(
        Mistake::ReflectanceForgotten,
        "Gathering",
        "rho_i",
        |_, _| Some(Value::Number(1.0)),
    );
    // From the floor, of area 4, to the lamp, of area 1
    gathered.is_named(
        Mistake::FormFactorTransposed,
        "Exchanged",
        "F_ij",
        |_, at| {
            let factor = if at.number("i")? == 0.0 { 4.0 } else { 0.25 };
            Some(Value::Number(factor * at.number("F_ij")?))
        },
    );
    let shot = Case::new(ROOM, Method::Radiosity, Focus::Frame, Solver::Shooting);
    shot.is_named(Mistake::PiTwice, "Received", "F_ji", times("F_ji", over_pi));
    shot.is_named(
        Mistake::ReflectanceForgotten,
        "Received",
        "rho_j",
        |_, _| Some(Value::Number(1.0)),
    );
    shot.is_named(
        Mistake::FormFactorTransposed,
        "Received",
        "F_ji",
        times("F_ji", 4.0),
    );
}
