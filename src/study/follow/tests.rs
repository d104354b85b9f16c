use super::*;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::methods::Settings;
use crate::scene::{Limits, View, read};

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
    let scene = read(
        SCENE.as_bytes(),
        &Limits::default(),
        &mut |_| unreachable!(),
    )
    .unwrap();
    let view = View::new(&scene.camera.unwrap(), 32, 24);
    Setup::new(PreparedScene::new(scene, view), Settings::default())
}

fn run(setup: Setup) -> Run {
    Run::record(Arc::new(setup), METHOD, FOCUS, RecordingLimit::default())
}

/// The trace of a program that does just the same: own values alone.
fn trace(walk: &dyn Walk) -> Vec<Told> {
    let told = |step: usize| Told {
        line: step + 1,
        kind: walk.kind(step).to_owned(),
        values: walk
            .own_fields(step)
            .iter()
            .map(|field| (field.name.to_owned(), field.value.into()))
            .collect(),
    };
    (0..walk.len()).map(told).collect()
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
    trace.retain(|told| told.line % 2 == 0);
    for (_, value) in trace.iter_mut().flat_map(|told| &mut told.values) {
        if let ToldValue::Number(Some(number)) = value {
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
fn the_first_value_that_differs_is_told_with_ours() {
    let run = run(setup());
    let mut trace = trace(run.walk());
    let at = trace
        .iter()
        .position(|told| told.kind == "Diffuse")
        .unwrap();
    let (field, right) = trace[at].values.last().unwrap().clone();
    let wrong = ToldValue::Three([0.25, 0.5, 0.75]);
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
    let told = |line, kind: &str, values: &[(&str, ToldValue)]| Told {
        line,
        kind: kind.into(),
        values: values
            .iter()
            .map(|(name, value)| (name.to_string(), value.clone()))
            .collect(),
    };
    let twice = [told(1, "FrameDone", &[]), told(2, "FrameDone", &[])];
    let difference = follow(run.walk(), &twice, 0.0).unwrap().difference;
    let (line, kind, count) = (2, "FrameDone".to_owned(), 1);
    assert_eq!(difference, Some(Difference::More { line, kind, count }));

    let unknown = follow(run.walk(), &[told(7, "Difuse", &[])], 0.0).unwrap_err();
    let message = unknown.to_string();
    assert!(message.starts_with("line 7: the run has no step of the kind \"Difuse\""));
    assert!(message.contains("Diffuse"));
    let value = ToldValue::Truth(true);
    let unknown = follow(run.walk(), &[told(3, "Shadow", &[("blokced", value)])], 0.0);
    let message = unknown.unwrap_err().to_string();
    assert!(
        message.starts_with("line 3: Shadow has no value \"blokced\""),
        "{message}"
    );
    assert!(message.contains("blocked"));
}

#[test]
fn the_mistake_that_would_give_the_other_values_is_named() {
    let right = setup();
    let correct = run(setup());
    for mistake in [
        Mistake::EtaInverted,
        Mistake::NoAttenuation,
        Mistake::FovVertical,
        Mistake::FovHalfAngle,
    ] {
        let wrong = run(mistake.wrong_input(&right).unwrap());
        let trace = trace(wrong.walk());
        let followed = follow(correct.walk(), &trace, TOLERANCE).unwrap();
        assert!(followed.difference.is_some(), "{}", mistake.name());
        let explained = explained_by(&right, METHOD, FOCUS, &trace, (TOLERANCE, followed.agree));
        assert_eq!(explained.first(), Some(&mistake));
    }
}
