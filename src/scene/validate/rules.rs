//! Which numbers are allowed, and the problems found so far.

use crate::color::Rgb;
use crate::scene::Note;
use crate::scene::document::{Place, Problem};
use crate::scene::values::{Number, Triple};
use glam::DVec3;

/// The largest coordinate and length that is taken: up to here, squares and products of squares stay finite.
pub const LARGEST: f64 = 1e75;

/// Below this length a vector is taken for zero: squares of squares would vanish.
pub const SMALLEST: f64 = 1e-75;

/// Which numbers are allowed, and how to say it.
pub type Rule = (fn(f64) -> bool, &'static str);

pub const NOT_NEGATIVE: Rule = (|x| x >= 0.0, "numbers of 0 or more");
pub const POSITIVE: Rule = (|x| x > 0.0, "numbers greater than 0");
pub const SHARE: Rule = (|x| (0.0..=1.0).contains(&x), "numbers from 0 to 1");
pub const FIELD_OF_VIEW: Rule = (
    |x| x > 0.0 && x < 180.0,
    "angles greater than 0 and less than 180",
);
pub const CREASE: Rule = (|x| (0.0..=180.0).contains(&x), "angles from 0 to 180");
pub const COORDINATE: Rule = (|x| x.abs() <= LARGEST, "numbers from -1e75 to 1e75");
pub const LENGTH: Rule = (
    |x| x > 0.0 && x <= LARGEST,
    "lengths greater than 0 and at most 1e75",
);
pub const RADIUS_OR_NONE: Rule = (
    |x| (0.0..=LARGEST).contains(&x),
    "0 or a radius greater than 0 and at most 1e75",
);

/// How many problems are kept; of the rest the number is enough.
const MAX_KEPT: usize = 1000;

/// The problems and notes found so far. Its methods hand on what is written also where it is wrong, so that checking goes on.
#[derive(Default)]
pub struct Check {
    /// The first of them.
    problems: Vec<Problem>,
    pub count: usize,
    pub notes: Vec<Note>,
}

impl Check {
    pub fn refuse(&mut self, place: &Place, message: String) {
        self.count += 1;
        if self.problems.len() < MAX_KEPT {
            self.problems.push(Problem {
                place: place.to_string(),
                line: None,
                column: None,
                message,
            });
        }
    }

    /// Notes what has no effect, and refuses nothing.
    pub fn note(&mut self, place: &Place, what: impl Into<String>, why: impl Into<String>) {
        self.notes.push(Note::new(place, what, why));
    }

    /// The problems kept, and how many there are beside them.
    pub fn placed(mut self, root: &Place) -> Vec<Problem> {
        let more = self.count - self.problems.len();
        if more > 0 {
            self.problems.push(Problem {
                place: root.to_string(),
                line: None,
                column: None,
                message: format!("and {more} more problems"),
            });
        }
        self.problems
    }

    pub fn number(&mut self, place: &Place, Number(value): Number, rule: Rule) -> f64 {
        let (is_allowed, allowed) = rule;
        if !is_allowed(value) {
            self.refuse(place, format!("found {value:?}; allowed are {allowed}"));
        }
        value
    }

    pub fn triple(&mut self, place: &Place, Triple(values): Triple, rule: Rule) -> [f64; 3] {
        for (i, &value) in values.iter().enumerate() {
            self.number(&place.index(i), Number(value), rule);
        }
        values
    }

    pub fn color(&mut self, place: &Place, written: Triple) -> Rgb {
        let color: Rgb = self.triple(place, written, NOT_NEGATIVE).into();
        let brightest = color.max_channel();
        if brightest > LARGEST {
            let why = "all that it reaches is white in a picture, and products of such numbers can be infinite";
            self.note(place, format!("a channel of {brightest:?}"), why);
        }
        color
    }

    pub fn point(&mut self, place: &Place, written: Triple) -> DVec3 {
        self.triple(place, written, COORDINATE).into()
    }

    /// Of unit length.
    pub fn direction(&mut self, place: &Place, Triple(written): Triple) -> DVec3 {
        let direction = unit(written.into());
        if direction.is_none() {
            self.refuse(
                place,
                "found [0, 0, 0], which has no direction; allowed is any vector but this".into(),
            );
        }
        direction.unwrap_or_default()
    }

    /// a0, a1, a2 of a0 + a1·d + a2·d².
    pub fn attenuation(&mut self, place: &Place, written: Option<Triple>) -> [f64; 3] {
        let Some(written) = written else {
            return [1.0, 0.0, 0.0];
        };
        let coefficients = self.triple(place, written, NOT_NEGATIVE);
        if coefficients == [0.0; 3] {
            self.refuse(
                place,
                "found [0, 0, 0], by which light would be divided; at least one number must be greater than 0"
                    .into(),
            );
        }
        coefficients
    }
}

/// The vector at unit length, also where its square would overflow or vanish; none of zero.
pub fn unit(vector: DVec3) -> Option<DVec3> {
    let largest = vector.abs().max_element();
    (largest > 0.0).then(|| (vector / largest).normalize())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_survive_the_ends_of_the_range() {
        assert_eq!(unit(DVec3::new(0.0, -1e300, 0.0)), Some(DVec3::NEG_Y));
        assert_eq!(unit(DVec3::new(1e-310, 0.0, 0.0)), Some(DVec3::X));
        assert_eq!(unit(DVec3::ZERO), None);
    }
}
