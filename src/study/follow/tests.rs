use super::*;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::methods::Method;
use crate::methods::Settings;
use crate::scene::{self, Limits, View};

/// Two lights on a glass ball before a wall.
const SCENE: &str = r#"{ "schema": 1,
    "camera": { "eye": [0.2, 0.3, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
    "materials": { "glass": { "diffuse": [0.1, 0.1, 0.1], "transmission": 0.8, "ior": 1.5 }, "wall": { "diffuse": [0.6, 0.5, 0.4] } },
    "objects": [
        { "name": "ball", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 1 } },
        { "name": "wall", "material": "wall", "plane": { "point": [0, 0, -3], "normal": [0, 0, 1] } } ],
    "lights": [ { "point": { "position": [2, 3, 3], "color": [1, 0.9, 0.8], "attenuation": [0.6, 0.1, 0.02] } },
        { "directional": { "toward": [1, -1, -1], "color": [0.5, 0.6, 0.7] } } ] }"#;

const FOCUS: Focus = Focus::Pixel { x: 18, y: 10 };
const METHOD: Method = Method::RayTracing;
const TOLERANCE: f64 = 1e-5;

fn setup() -> Setup {
    setup_of(SCENE, [32, 24])
}

fn setup_of(scene: &str, [width, height]: [u32; 2]) -> Setup {
    let scene = scene.as_bytes();
    let scene = scene::read(scene, &Limits::default(), &mut |_| unreachable!()).unwrap();
    let view = View::new(&scene.camera.unwrap(), width, height);
    Setup::new(PreparedScene::new(scene, view), Settings::default())
}

fn run(setup: Setup) -> Run {
    Run::record(Arc::new(setup), METHOD, FOCUS, RecordingLimit::default())
}

/// The trace of a program that does just the same: own values alone.
fn trace(walk: &dyn Walk) -> Vec<TraceLine> {
    let traced = |step: usize| TraceLine {
        line: step + 1,
        kind: walk.kind(step).to_owned(),
        values: walk
            .own_fields(step)
            .iter()
            .map(|field| (field.name.to_owned(), field.value.into()))
            .collect(),
    };
    (0..walk.len()).map(traced).collect()
}

#[test]
fn a_program_that_does_the_same_is_followed_to_its_end() {
    let run = run(setup());
    let mut trace = trace(run.walk());
    let all = Followed {
        agree: trace.len(),
        difference: None,
    };
    assert!(trace.len() > 60);
    assert_eq!(follow(run.walk(), &trace, 0.0), Ok(all));

    // Every second step untold, and the last digits lost
    trace.retain(|traced| traced.line % 2 == 0);
    for (_, value) in trace.iter_mut().flat_map(|traced| &mut traced.values) {
        if let TraceValue::Number(Some(number)) = value {
            *number = number.to_string()[..number.to_string().len().min(9)]
                .parse()
                .unwrap_or(*number);
        }
    }
    let followed = follow(run.walk(), &trace, TOLERANCE).unwrap();
    assert_eq!(followed.difference, None);
}

#[test]
fn steps_of_a_scope_may_come_in_any_order() {
    let run = run(setup());
    let mut trace = trace(run.walk());
    let lights: Vec<usize> = (0..trace.len())
        .filter(|&i| trace[i].kind == "Light")
        .collect();
    trace.swap(lights[0], lights[1]);
    assert_ne!(trace[lights[0]].values, trace[lights[1]].values);
    assert_eq!(follow(run.walk(), &trace, 0.0).unwrap().difference, None);
}

#[test]
fn the_first_value_that_differs_is_reported_with_ours() {
    let run = run(setup());
    let mut trace = trace(run.walk());
    let at = trace
        .iter()
        .position(|traced| traced.kind == "Diffuse")
        .unwrap();
    let (field, right) = trace[at].values.last().unwrap().clone();
    let wrong = TraceValue::Three([0.25, 0.5, 0.75]);
    trace[at].values.last_mut().unwrap().1 = wrong.clone();
    let followed = follow(run.walk(), &trace, TOLERANCE).unwrap();
    let difference = Difference::Value(OtherValue {
        line: at + 1,
        step: at,
        kind: "Diffuse",
        field,
        theirs: wrong,
        ours: Some(right),
    });
    assert_eq!(
        (followed.agree, followed.difference),
        (at, Some(difference))
    );
}

#[test]
fn more_steps_than_the_run_has_differ_and_unknown_names_are_errors() {
    let run = run(setup());
    let traced = |line, kind: &str, values: &[(&str, TraceValue)]| TraceLine {
        line,
        kind: kind.into(),
        values: values
            .iter()
            .map(|(name, value)| (name.to_string(), value.clone()))
            .collect(),
    };
    let twice = [traced(1, "FrameDone", &[]), traced(2, "FrameDone", &[])];
    let difference = follow(run.walk(), &twice, 0.0).unwrap().difference;
    let (line, kind, count) = (2, "FrameDone".to_owned(), 1);
    assert_eq!(difference, Some(Difference::More { line, kind, count }));

    let unknown = follow(run.walk(), &[traced(7, "Difuse", &[])], 0.0).unwrap_err();
    let message = unknown.to_string();
    assert!(
        message
            .starts_with("line 7: there is no step of the kind \"Difuse\" (did you mean Diffuse?)")
    );
    assert!(message.contains("Diffuse"));
    let value = TraceValue::Truth(true);
    let unknown = follow(
        run.walk(),
        &[traced(3, "Shadow", &[("blokced", value)])],
        0.0,
    );
    let message = unknown.unwrap_err().to_string();
    assert!(
        message.starts_with("line 3: Shadow has no value \"blokced\" (did you mean blocked?)"),
        "{message}"
    );
    assert!(message.contains("blocked"));
}

#[test]
fn a_value_of_another_type_is_an_error_and_a_kind_that_the_run_lacks_a_difference() {
    let run = run(setup());
    let line = |kind: &str, field: &str, value| TraceLine {
        line: 4,
        kind: kind.into(),
        values: vec![(field.into(), value)],
    };
    let red = TraceValue::Word("red".into());
    let error = follow(run.walk(), &[line("Diffuse", "I_d", red)], 0.0).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 4: I_d is a word; of Diffuse it is a list of three numbers"
    );
    let mirrored = line("Mirrored", "R_dot_V", TraceValue::Number(Some(0.5)));
    let followed = follow(run.walk(), &[mirrored], 0.0).unwrap();
    let (line, kind, count) = (4, "Mirrored".to_owned(), 0);
    assert_eq!(
        followed.difference,
        Some(Difference::More { line, kind, count })
    );
}

/// The scopes of two rays that leave one surface, recorded the other way round, and recorded without the rays themselves.
#[test]
fn rays_of_a_surface_may_be_followed_in_any_order() {
    let glass = SCENE.replace("\"transmission\"", "\"reflection\": 0.3, \"transmission\"");
    let run = run(setup_of(&glass, [32, 24]));
    let walk = run.walk();
    let of_level_2 = |step: usize| {
        walk.kind(step) == "Ray" && walk.fields(step).get("level") == Some(Value::Integer(2))
    };
    let rays: Vec<usize> = (0..walk.len()).filter(|&step| of_level_2(step)).collect();
    let [reflected, transmitted] = rays[..] else {
        panic!("two rays leave the ball: {rays:?}")
    };
    let trace = trace(walk);
    let part = |ray: usize| trace[ray..=walk.outline().last(ray)].iter().cloned();
    let mut swapped: Vec<TraceLine> = part(transmitted).chain(part(reflected)).collect();
    assert_eq!(follow(walk, &swapped, 0.0).unwrap().difference, None);

    // The first wrong value stands in the transmitted part, and is held against that part.
    let wrong = TraceValue::Three([9.0, 9.0, 9.0]);
    let met = |traced: &&mut TraceLine| traced.kind == "SurfaceMet";
    let traced = swapped.iter_mut().find(met).unwrap();
    let line = traced.line;
    let position = traced.values.iter_mut().find(|(name, _)| name == "P");
    position.unwrap().1 = wrong;
    let followed = follow(walk, &swapped, 0.0).unwrap();
    let Some(Difference::Value(other)) = followed.difference else {
        panic!("{followed:?}")
    };
    assert_eq!((other.line, other.step), (line, line - 1));
}

mod mistaken;
