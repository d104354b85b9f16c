//! When parameters are moved, every lesson runs, and no verdict is wrong: a question whose conditions do not decide has no answer.

use super::file::AnswerFile;
use super::narrated::Question;
use super::{Answer, Change, Coefficient, Lesson, Parameter, builtins};
use crate::algorithms::hierarchical;
use crate::language::Language;
use crate::record::{RecordingLimit, Value};
use crate::replay::query::{self, number_of};
use crate::replay::{Operand, Run, Walk};
use crate::scene::document::Keyed;
use glam::DVec3;
use std::collections::BTreeSet;
use std::sync::Arc;

fn lessons() -> impl Iterator<Item = Lesson> {
    let lessons = builtins().iter().map(|builtin| builtin.read().unwrap());
    lessons.filter(|lesson| !lesson.parameters.is_empty())
}

/// Values all over the range of a parameter: near and far, on all sides, at the ends.
fn values(parameter: Parameter, lesson: &Lesson) -> Vec<Change> {
    let around = |center: DVec3, make: &dyn Fn(DVec3) -> Change| {
        let offsets = [-5.0, -1.0, 0.4, 3.0];
        let moved = offsets
            .into_iter()
            .flat_map(|offset| DVec3::AXES.map(|axis| make(center + offset * axis)));
        moved.chain([make(-center)]).collect()
    };
    match lesson.value(parameter, &[]).unwrap() {
        Change::ByPath { parameter, .. } => {
            let sampled = lesson.by_path[parameter].sampled().into_iter();
            sampled
                .map(|value| Change::ByPath { parameter, value })
                .collect()
        }
        Change::Place { of, position } => {
            around(position, &|position| Change::Place { of, position })
        }
        Change::Divisions { object, .. } => [2, 3, 5, 24, 64]
            .map(|divisions| Change::Divisions { object, divisions })
            .into(),
        Change::Coefficient {
            material,
            coefficient,
            ..
        } => {
            let values = match coefficient {
                Coefficient::Shininess => [0.0, 1.0, 5.0, 60.0, 1000.0],
                _ => [0.0, 0.05, 0.3, 0.7, 1.0],
            };
            values
                .map(|value| Change::Coefficient {
                    material,
                    coefficient,
                    value,
                })
                .into()
        }
    }
}

/// What a question of a lesson is about, put in other words than its conditions; by the lesson and the step of the answer. The
/// option that is right then; none where the ratio is not a number.
fn other_words(lesson: &str, at: &str, walk: &dyn Walk, question: &Question) -> Option<usize> {
    let number = |step: usize, name: &str| number_of(&walk.fields(step), name).unwrap();
    let before = |kind: &str| {
        (0..question.step)
            .rev()
            .find(|&step| walk.kind(step) == kind)
    };
    let ratio = |name: &str| {
        let before = before(walk.kind(question.step)).unwrap();
        let before = number(before, name);
        // Of what is not positive there is no multiple to speak of.
        if before > 0.0 {
            number(question.step, name) / before
        } else {
            f64::NAN
        }
    };
    let one_of = |ratio: f64, limits: [f64; 2]| {
        let above = limits.iter().filter(|&&limit| ratio > limit).count();
        (!ratio.is_nan()).then_some(above)
    };
    match (lesson, at) {
        ("illumination-model", "Specular") => {
            // Of k_s what R·V to the power n_s leaves
            let cosine = number(question.step, "R_dot_V").max(0.0);
            let left = cosine.powf(number(question.step, "n_s"));
            (number(question.step, "k_s.r") > 0.0)
                .then(|| one_of(left, [0.5, 0.9]).map(|above| 2 - above))
                .flatten()
        }
        ("illumination-model", "LightAdded") => {
            let [specular, diffuse] = ["I_s.b", "I_d.b"].map(|name| number(question.step, name));
            Some(usize::from(specular <= diffuse))
        }
        ("distance", "Diffuse light=1") => one_of(ratio("slide_factor"), [0.5, 1.5]),
        ("flat-shading", "Illuminated object=1") => {
            let side = one_of(ratio("I"), [0.98, 1.02])?;
            Some([1, 0, 2][side])
        }
        ("depth-attenuation", "PixelColored") => {
            let local = number(before("Illuminated").unwrap(), "I");
            let more = local * (2.0_f64 / 3.0).powi(7) / number(question.step, "color");
            Some(2 - one_of(more, [0.01, 0.1])?)
        }
        _ => match question.answer {
            Answer::Choice { right, .. } => Some(right),
            _ => None,
        },
    }
}

/// The run of a lesson after one change; none where the change cannot be had.
fn changed(lesson: &Lesson, change: Change) -> Option<Run> {
    let (scene, settings) = lesson.changed(&[change]).ok()?;
    let setup = Arc::new(lesson.setup(scene, settings)?);
    setup.check(lesson.focus).ok()?;
    let limit = RecordingLimit::default();
    Some(Run::record(setup, lesson.method, lesson.focus, limit))
}

/// The verdicts of a lesson after one change: how many questions have an answer; none where the change cannot be had. Wrong ones are
/// faults.
fn verdicts(lesson: &Lesson, change: Change, faults: &mut BTreeSet<String>) -> Option<usize> {
    let run = changed(lesson, change)?;
    let narrated = lesson.narrate_changed(&run).ok()?;
    let mut decided = 0;
    for said in &narrated {
        let step = &lesson.steps[said.index];
        let (Some(question), Some(Keyed(file))) = (&said.question, &step.question) else {
            continue;
        };
        let place = format!("{} {}: {change:?}", lesson.id, file.at);
        let AnswerFile::Choice(options) = &file.answer else {
            continue;
        };
        let walk = run.walk();
        let holds = |index: usize| {
            let at = question.step..question.step + 1;
            query::matches(walk, &options[index].when, at)
                .next()
                .is_some()
        };
        let holding: Vec<usize> = (0..options.len()).filter(|&index| holds(index)).collect();
        match question.answer {
            Answer::Choice { right, .. } => {
                let expected = other_words(&lesson.id, &file.at.to_string(), walk, question);
                if holding != [right] || expected.unwrap_or(right) != right {
                    faults.insert(format!("{place}: {right} of {holding:?}, not {expected:?}"));
                }
                decided += 1;
            }
            _ if question.step != said.step && holding.len() == 1 => {
                faults.insert(format!("{place}: no verdict, and {holding:?} holds"));
            }
            _ => {}
        }
    }
    Some(decided)
}

#[test]
fn moved_parameters_make_no_verdict_wrong() {
    let mut faults = BTreeSet::new();
    for lesson in lessons() {
        let parameters = lesson.parameters.iter();
        let changes = parameters.flat_map(|&parameter| values(parameter, &lesson));
        let decided: usize = changes
            .filter_map(|change| verdicts(&lesson, change, &mut faults))
            .sum();
        let asks = |step: &super::file::StepFile| {
            let question = step.question.as_ref();
            question.is_some_and(|question| matches!(question.0.answer, AnswerFile::Choice(_)))
        };
        assert!(
            decided > 0 || !lesson.steps.iter().any(asks),
            "{}",
            lesson.id
        );
    }
    assert_eq!(faults, BTreeSet::new());
}

#[test]
fn every_lesson_has_two_parameters_that_may_have_any_value_of_their_ranges() {
    let mut faults = Vec::new();
    for builtin in builtins() {
        let lesson = builtin.read().unwrap();
        if lesson.parameters.len() < 2 {
            faults.push(format!("{}: {}", lesson.id, lesson.parameters.len()));
        }
        if let Err(error) = lesson.check_parameters() {
            faults.push(format!("{}: {error}", lesson.id));
        }
    }
    assert_eq!(faults, Vec::<String>::new());
}

/// Whole numbers count or name things: they are no limits.
#[test]
fn a_typed_limit_is_one_that_the_option_says() {
    let mut faults = BTreeSet::new();
    for lesson in lessons() {
        let run = lesson.clone().open().unwrap();
        for (said, step) in run.narrated.iter().zip(&lesson.steps) {
            let (Some(question), Some(Keyed(file))) = (&said.question, &step.question) else {
                continue;
            };
            let AnswerFile::Choice(options) = &file.answer else {
                continue;
            };
            // Of what is not known there (no object, where nothing was hit), the kind of value that other steps have.
            let walk = run.run.walk();
            let is_whole = |name: &str| {
                let mut steps = std::iter::once(question.step).chain(0..walk.len());
                let value = steps.find_map(|step| walk.fields(step).get(name));
                matches!(value, Some(Value::Integer(_)))
            };
            for option in options {
                for condition in &option.when.conditions {
                    let Operand::Number(limit) = condition.value else {
                        continue;
                    };
                    let said = option
                        .text
                        .in_language(Language::English)
                        .contains(&limit.to_string());
                    if limit != 0.0 && !said && !is_whole(&condition.field) {
                        faults.insert(format!("{} {}: {condition}", lesson.id, file.at));
                    }
                }
            }
        }
    }
    assert_eq!(faults, BTreeSet::new());
}

/// The last value that a lesson records at such a step, with its first parameter at that number.
fn recorded_with(lesson: &Lesson, number: f64, at: &str, field: &str) -> f64 {
    let change = lesson.change(lesson.parameters[0], &[number]).unwrap();
    let run = changed(lesson, change).unwrap();
    let walk = run.walk();
    let at = at.parse().unwrap();
    let step = query::matches(walk, &at, 0..walk.len()).next_back();
    number_of(&walk.fields(step.unwrap()), field).unwrap()
}

#[test]
fn light_leaks_under_a_wall_less_the_finer_the_patches_as_the_lesson_says() {
    let lesson = super::builtin("light-leak").unwrap().read().unwrap();
    let leak = |patches| recorded_with(&lesson, patches, "Gathered i=5", "B_i");
    let says = [
        (1.0, 0.0515),
        (3.0, 0.0247),
        (5.0, 0.0162),
        (9.0, 0.0096),
        (15.0, 0.0060),
    ];
    for (patches, said) in says {
        let leak = leak(patches);
        assert!((leak - said).abs() <= 0.00005, "{patches}: {leak}");
    }
    // A border of the floor lies at the wall.
    for patches in [2.0, 8.0] {
        assert_eq!(leak(patches), 0.0);
    }
}

#[test]
fn a_turned_quadrilateral_changes_and_two_triangles_do_not() {
    let lesson = super::builtin("turned-quadrilateral").unwrap();
    let lesson = lesson.read().unwrap();
    let middle = |degrees, at| recorded_with(&lesson, degrees, at, "I_P");
    // Of the corners, whose intensities are 0.05 + 0.8 cos 0° and 0.05 + 0.8 cos 75°: of one pair, of all, of the other pair.
    let (bright, dark) = (0.85, 0.05 + 0.8 * 75.0_f64.to_radians().cos());
    let means = [(-45.0, bright), (0.0, 0.5 * (bright + dark)), (45.0, dark)];
    for (degrees, mean) in means {
        let quadrilateral = middle(degrees, "SpanInterpolated object=1 x=61");
        assert!(
            (quadrilateral - mean).abs() < 1e-5,
            "{degrees}: {quadrilateral}"
        );
    }
    for degrees in [-45.0, -20.0, 0.0, 33.0, 45.0] {
        let triangles = middle(degrees, "SpanInterpolated object=3 x=143");
        assert!((triangles - bright).abs() < 1e-5, "{degrees}: {triangles}");
    }
}

/// The links at the end, and the brightest leaf that does not shine itself.
fn links_and_brightest(lesson: &Lesson, links: hierarchical::Settings) -> (usize, f64) {
    let settings = lesson.settings.clone().with(links);
    let setup = lesson.setup(lesson.scene.clone(), settings).unwrap();
    let limit = RecordingLimit::default();
    let mut run = Run::record(Arc::new(setup), lesson.method, lesson.focus, limit);
    let last = run.walk().len() - 1;
    run.walk_mut().seek(last);
    let Run::Hierarchical(_, replay) = &run else {
        panic!("the lesson links elements")
    };
    let state = replay.state();
    let elements = &state.solved.as_ref().unwrap().tree.elements;
    let lit = state.leaves().filter_map(|(leaf, now)| {
        let emission = elements[leaf as usize].emission.max_channel();
        (emission == 0.0).then_some(now.b.r)
    });
    let brightest = lit.fold(0.0, f64::max);
    (state.links().count(), brightest)
}

#[test]
fn fewer_links_leave_larger_errors_as_the_lesson_says() {
    let lesson = super::builtin("hierarchical-radiosity").unwrap();
    let lesson = lesson.read().unwrap();
    let own: hierarchical::Settings = lesson.settings.get();
    let carrying = |link_light| hierarchical::Settings { link_light, ..own };
    let all = hierarchical::Settings {
        link_size: 0.0,
        ..own
    };
    let says = [
        (all, 4608, 0.380),
        (own, 300, 0.369),
        (carrying(0.05), 114, 0.273),
        (carrying(0.001), 618, 0.379),
    ];
    for (settings, links, said) in says {
        let (count, brightest) = links_and_brightest(&lesson, settings);
        assert_eq!(count, links, "{settings:?}");
        assert!((brightest - said).abs() <= 0.0005, "{links}: {brightest}");
    }
}
