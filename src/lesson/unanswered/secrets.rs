//! What must not be read before a question is answered.

use crate::language::Language;
use crate::lesson::file::{AnswerFile, QuestionFile};
use crate::lesson::{Answer, OpenLesson, Thing};
use crate::panels::{AskedArrow, named_by, word_name};
use crate::record::{Fields, Value};
use crate::replay::query::number_of;
use crate::replay::{Condition, Operand, VectorPlane, Walk};
use glam::DVec3;

/// Something that must not be read before the answer.
#[derive(Clone, Debug)]
pub(super) enum Secret {
    /// A number as near as that to the right one, written with as many digits as it takes to answer.
    Number {
        value: f64,
        tolerance: f64,
    },
    /// A whole number, by itself.
    Whole(i64),
    /// The right name, and those of the wrong options: where all occur, none is given away.
    Name {
        right: String,
        wrong: Vec<String>,
    },
    /// A word of the program, which occurs in other texts too: as a value by itself.
    Word(String),
    Pixel {
        x: u32,
        y: u32,
    },
    /// Texts one after the other.
    Sequence(Vec<String>),
    /// Where an arrow points, within so many degrees.
    Direction {
        arrow: AskedArrow,
        tolerance: f64,
    },
}

/// What is decisive for the right answer.
pub(super) fn secrets(open: &OpenLesson, index: usize, language: Language) -> Vec<Secret> {
    let asked = open.narrated[index].question.as_ref().unwrap();
    let file = open.lesson.steps[index].question.as_ref().unwrap();
    let fields = open.run.walk().fields(asked.step);
    match (&asked.answer, &file.0.answer) {
        (&Answer::Pixel { x, y, .. }, _) => vec![Secret::Pixel { x, y }],
        (&Answer::Number { value, tolerance }, AnswerFile::Number { field, .. }) => {
            match fields.get(field) {
                Some(Value::Integer(whole)) => vec![Secret::Whole(whole)],
                _ => vec![Secret::Number { value, tolerance }],
            }
        }
        (
            &Answer::Pick {
                thing,
                ref names,
                right,
            },
            _,
        ) => match thing {
            Thing::Patch => vec![Secret::Whole(right as i64)],
            Thing::Object => {
                let name = |number: usize| names[number][language as usize].clone();
                let others = (0..names.len()).filter(|&number| number != right);
                vec![Secret::Name {
                    right: name(right),
                    wrong: others.map(name).collect(),
                }]
            }
        },
        (Answer::Order { items, right }, _) => {
            let text = |&item: &usize| items[item][language as usize].to_lowercase();
            vec![Secret::Sequence(right.iter().map(text).collect())]
        }
        (
            &Answer::Arrow {
                name,
                plane,
                direction,
                tolerance,
            },
            _,
        ) => {
            let step = open.narrated[index].step;
            direction_of(name, plane, direction, tolerance, open.run.walk(), step)
        }
        (&Answer::Choice { right, .. }, _) => decisive(open, &file.0, &fields, right, language),
        _ => unreachable!("an answer is of the kind that its file gives"),
    }
}

/// A direction as it is drawn, its components, and its angle with the normal, unless a vector that is known by `step` makes the
/// same angle: to see that is what is asked.
fn direction_of(
    field: &'static str,
    plane: VectorPlane,
    direction: DVec3,
    tolerance: f64,
    walk: &dyn Walk,
    step: usize,
) -> Vec<Secret> {
    let arrow = AskedArrow {
        field,
        point: plane.point,
        own: direction,
        right: None,
        is_right: false,
    };
    let cosine = direction.dot(plane.normal);
    let mut known = (0..=step).flat_map(|step| walk.own_fields(step).0);
    let is_known = known.any(|field| match field.value {
        Value::Vector(vector) => {
            vector.is_normalized() && (vector.dot(plane.normal).abs() - cosine.abs()).abs() < 1e-9
        }
        _ => false,
    });
    let angle = cosine.acos().to_degrees();
    let angles = [angle, 180.0 - angle].into_iter().filter(|_| !is_known);
    let components = direction.to_array().into_iter();
    let numbers = components
        .filter(|component| *component != 0.0)
        .map(|value| (value, 0.01 * value.abs()))
        .chain(angles.map(|degrees| (degrees, 1.0)));
    let numbers = numbers.map(|(value, tolerance)| Secret::Number { value, tolerance });
    let drawn = Secret::Direction { arrow, tolerance };
    std::iter::once(drawn).chain(numbers).collect()
}

/// The values by which the right option holds; of objects and words, their names.
fn decisive(
    open: &OpenLesson,
    file: &QuestionFile,
    fields: &Fields,
    right: usize,
    language: Language,
) -> Vec<Secret> {
    let AnswerFile::Choice(options) = &file.answer else {
        return Vec::new();
    };
    let prepared = &open.setup.prepared;
    let conditions = options[right].when.conditions.iter();
    let secret = conditions.filter_map(|condition| {
        let name = condition.field.as_str();
        let called = |value| named_by(prepared, name, value, language).map(str::to_owned);
        let value = fields.get(name.split('.').next()?)?;
        if let Some(right) = called(value) {
            let same = |other: &&Condition| other.field == condition.field;
            let others = options.iter().flat_map(|option| &option.when.conditions);
            let values = others.filter(same).filter_map(|other| match other.value {
                Operand::Number(number) => Some(Value::Integer(number as i64)),
                _ => None,
            });
            let wrong = values.filter_map(called).filter(|name| *name != right);
            let wrong = wrong.collect();
            return Some(Secret::Name { right, wrong });
        }
        match value {
            Value::Integer(whole) => Some(Secret::Whole(whole)),
            Value::Word(word) => Some(Secret::Word(word_name(word, language))),
            _ => number_of(fields, name)
                .filter(|&value| value != 0.0)
                .map(|value| Secret::Number {
                    value,
                    tolerance: 0.01 * value.abs(),
                }),
        }
    });
    secret.collect()
}
