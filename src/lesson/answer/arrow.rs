//! A direction at a point, shown by an arrow that is turned in the plane in which the vectors there are seen.

use super::Answer;
use crate::language::{Language, Message};
use crate::record::Value;
use crate::replay::{Run, VectorPlane};
use std::ops::RangeInclusive;

const CLOCKWISE: Message = Message("arrow-clockwise");
const COUNTERCLOCKWISE: Message = Message("arrow-counterclockwise");
const TURN_ON: Message = Message("hint-turn-clockwise");
const TURN_BACK: Message = Message("hint-turn-counterclockwise");

/// Where the arrow points before it is turned: along the surface, where no answer lies.
pub const START: f64 = 90.0;
/// Exact enough to tell one direction from another, and not too exact for a hand.
const TOLERANCES: RangeInclusive<f64> = 1.0..=30.0;
/// The least part of the direction that must lie in the plane.
const LEAST_PART: f32 = 0.5;

/// The direction that `step` itself records under `field`, at the surface that the window shows when the question is asked.
pub(in crate::lesson) fn read(
    run: &Run,
    asked_at: usize,
    step: usize,
    field: &str,
    tolerance: f64,
) -> Result<Answer, String> {
    if !TOLERANCES.contains(&tolerance) {
        let (least, most) = TOLERANCES.into_inner();
        return Err(format!(
            "found a tolerance of {tolerance} degrees; allowed are {least} to {most}"
        ));
    }
    let kind = run.walk().kind(step);
    let fields = run.walk().own_fields(step);
    let recorded = fields.iter().find(|recorded| recorded.name == field);
    let (name, direction) = match recorded.map(|recorded| (recorded.name, recorded.value)) {
        Some((name, Value::Vector(direction))) if direction.is_normalized() => (name, direction),
        _ => {
            return Err(format!(
                "`{field}` is no unit vector that the step of the answer, {kind}, records itself"
            ));
        }
    };
    let plane = VectorPlane::at(run, step);
    let plane = plane.filter(|_| plane == VectorPlane::at(run, asked_at));
    let plane =
        plane.ok_or("the question and its answer must be about the same point of a surface")?;
    if plane.project(direction).length() < LEAST_PART {
        return Err(format!(
            "`{field}` leans too far out of the plane in which the arrow is turned"
        ));
    }
    Ok(Answer::Arrow {
        name,
        plane,
        direction,
        tolerance,
    })
}

/// By how many degrees an arrow must be turned on to point in the other direction: from −180 to 180.
pub(super) fn turn(from: f64, to: f64) -> f64 {
    let turn = (to - from).rem_euclid(360.0);
    if turn > 180.0 { turn - 360.0 } else { turn }
}

/// So many degrees from the normal, on which side.
pub(super) fn in_words(degrees: f64, language: Language) -> String {
    let side = match degrees < 0.0 {
        true => COUNTERCLOCKWISE,
        false => CLOCKWISE,
    };
    let degrees = language.fixed(degrees.abs(), 0);
    side.format(language, &[("degrees", &degrees)])
}

/// Which way it is nearer to the right direction.
pub(super) fn hint(right: f64, guess: f64, language: Language) -> String {
    let way = match turn(guess, right) < 0.0 {
        true => TURN_BACK,
        false => TURN_ON,
    };
    way.text(language).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::{Guess, builtin};

    fn steps(run: &Run, kind: &str) -> usize {
        let walk = run.walk();
        let mut steps = 0..walk.len();
        steps.find(|&step| walk.kind(step) == kind).unwrap()
    }

    /// What is asked at the first step of one kind and answered at the first of another, in the lesson on reflection.
    fn answer(asked_at: &str, at: &str, field: &str, tolerance: f64) -> Result<Answer, String> {
        let lesson = builtin("reflection").unwrap().read().unwrap();
        let run = lesson.open().unwrap().run;
        let [asked_at, step] = [asked_at, at].map(|kind| steps(&run, kind));
        read(&run, asked_at, step, field, tolerance)
    }

    #[test]
    fn the_right_arrow_makes_the_angle_of_incidence_with_the_normal() {
        let lesson = builtin("reflection").unwrap().read().unwrap();
        let run = lesson.open().unwrap().run;
        let faced = run.walk().own_fields(steps(&run, "Faced"));
        let Some(Value::Number(theta)) = faced.get("theta_i_degrees") else {
            panic!("an angle")
        };
        let answer = answer("Faced", "Reflection", "R", 5.0).unwrap();
        // u comes from the left, so R goes to the right.
        for (degrees, right) in [
            (theta, true),
            (theta + 4.9, true),
            (theta - 4.9, true),
            (theta + 5.1, false),
            (theta - 5.1, false),
            (-theta, false),
            (theta + 360.0, true),
        ] {
            assert_eq!(answer.judge(&Guess::Arrow(degrees)), Ok(right), "{degrees}");
        }
        let words = format!("{theta:.0}° clockwise from straight up");
        assert_eq!(answer.in_words(Language::English), words);
        let hint = |degrees| answer.hint(&Guess::Arrow(degrees), Language::English);
        assert_eq!(hint(theta - 20.0), "Turn it further clockwise.");
        assert_eq!(hint(theta + 20.0), "Turn it further counterclockwise.");
    }

    #[test]
    fn the_shorter_way_round_is_taken() {
        assert_eq!(turn(170.0, -170.0), 20.0);
        assert_eq!(turn(-170.0, 170.0), -20.0);
        assert_eq!(turn(10.0, 10.0), 0.0);
    }

    #[test]
    fn what_is_no_direction_at_the_point_is_refused() {
        assert_eq!(
            answer("Faced", "Reflection", "k_r", 5.0).unwrap_err(),
            "`k_r` is no unit vector that the step of the answer, Reflection, records itself"
        );
        assert_eq!(
            answer("Faced", "Reflection", "R", 0.5).unwrap_err(),
            "found a tolerance of 0.5 degrees; allowed are 1 to 30"
        );
        // Before the surface is met, there is no plane.
        assert_eq!(
            answer("Ray", "Reflection", "R", 5.0).unwrap_err(),
            "the question and its answer must be about the same point of a surface"
        );
    }
}
