//! The value of an expression, with a bound on what rounding may have done to it.
//!
//! The bound is the first-order running error analysis of Wilkinson (1963): each operation adds one rounding unit of its result
//! to what its operands bring along. Values that go in are exact.

use super::{Expression, Function, Operator, Reference};
use crate::color::Rgb;
use crate::record::Value;
use glam::DVec3;
use std::f64::consts::TAU;

/// A number, and its rounding error at most, in rounding units.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Rounded {
    pub value: f64,
    pub error: f64,
}

impl Rounded {
    fn exact(value: f64) -> Self {
        Rounded { value, error: 0.0 }
    }

    /// The result of an operation whose operands bring `error` along.
    fn new(value: f64, error: f64) -> Self {
        Rounded {
            value,
            error: error + value.abs(),
        }
    }

    fn negative(self) -> Self {
        Rounded {
            value: -self.value,
            ..self
        }
    }

    fn plus(self, other: Self) -> Self {
        Rounded::new(self.value + other.value, self.error + other.error)
    }

    fn times(self, other: Self) -> Self {
        let error = self.value.abs() * other.error + other.value.abs() * self.error;
        Rounded::new(self.value * other.value, error)
    }

    fn over(self, other: Self) -> Self {
        let value = self.value / other.value;
        let error = (self.error + value.abs() * other.error) / other.value.abs();
        Rounded::new(value, error)
    }

    fn power(self, exponent: Self) -> Self {
        let value = self.value.powf(exponent.value);
        let slope = exponent.value * self.value.powf(exponent.value - 1.0);
        // 0^0 has no slope, nor does an exact base need one.
        let error = if self.error == 0.0 {
            0.0
        } else {
            slope.abs() * self.error
        };
        Rounded::new(value, error)
    }

    /// An angle in degrees, of which `slope` is the derivative in radians.
    fn angle(radians: f64, slope: f64, error: f64) -> Self {
        let error = if error == 0.0 { 0.0 } else { slope * error };
        Rounded::new(radians.to_degrees(), error.to_degrees())
    }

    /// The angle of the direction (x, y), from 0 to 360 degrees.
    fn atan2(y: Self, x: Self) -> Self {
        let value = y.value.atan2(x.value).rem_euclid(TAU);
        let square = x.value * x.value + y.value * y.value;
        let error = x.value.abs() * y.error + y.value.abs() * x.error;
        Rounded::angle(value, 1.0 / square, error)
    }

    /// Of an angle in degrees.
    fn sin(self) -> Self {
        let (value, slope) = self.value.to_radians().sin_cos();
        Rounded::new(value, slope.abs() * self.error.to_radians())
    }

    /// Of an angle in degrees.
    fn cos(self) -> Self {
        let (slope, value) = self.value.to_radians().sin_cos();
        Rounded::new(value, slope.abs() * self.error.to_radians())
    }

    /// Of an angle in degrees.
    fn tan(self) -> Self {
        let value = self.value.to_radians().tan();
        let slope = 1.0 + value * value;
        Rounded::new(value, slope * self.error.to_radians())
    }

    fn root(self) -> Self {
        let value = self.value.sqrt();
        let error = if self.error == 0.0 {
            0.0
        } else {
            0.5 * self.error / value
        };
        Rounded::new(value, error)
    }
}

/// What an expression amounts to.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Term {
    Number(Rounded),
    /// Its products are componentwise.
    Color([Rounded; 3]),
    Vector([Rounded; 3]),
}

impl Term {
    /// The components: one, or three.
    pub fn components(&self) -> &[Rounded] {
        match self {
            Term::Number(number) => std::slice::from_ref(number),
            Term::Color(components) | Term::Vector(components) => components,
        }
    }

    fn map(self, change: impl Fn(Rounded) -> Rounded) -> Term {
        match self {
            Term::Number(number) => Term::Number(change(number)),
            Term::Color(components) => Term::Color(components.map(change)),
            Term::Vector(components) => Term::Vector(components.map(change)),
        }
    }

    fn number(self) -> Option<Rounded> {
        match self {
            Term::Number(number) => Some(number),
            _ => None,
        }
    }

    fn plus(self, other: Term) -> Option<Term> {
        let sum =
            |a: [Rounded; 3], b: [Rounded; 3]| std::array::from_fn(|axis| a[axis].plus(b[axis]));
        Some(match (self, other) {
            (Term::Number(a), Term::Number(b)) => Term::Number(a.plus(b)),
            // Where a sum begins, of whatever kind it is.
            (Term::Number(start), other) if start == Rounded::exact(0.0) => other,
            (Term::Color(a), Term::Color(b)) => Term::Color(sum(a, b)),
            (Term::Vector(a), Term::Vector(b)) => Term::Vector(sum(a, b)),
            _ => return None,
        })
    }

    fn times(self, other: Term) -> Option<Term> {
        Some(match (self, other) {
            (Term::Number(a), b) => b.map(|b| a.times(b)),
            (a, Term::Number(b)) => a.map(|a| a.times(b)),
            (Term::Color(a), Term::Color(b)) => {
                Term::Color(std::array::from_fn(|axis| a[axis].times(b[axis])))
            }
            (Term::Vector(a), Term::Vector(b)) => {
                let [x, y, z] = std::array::from_fn(|axis| a[axis].times(b[axis]));
                Term::Number(x.plus(y).plus(z))
            }
            _ => return None,
        })
    }

    fn cross(self, other: Term) -> Option<Term> {
        let (Term::Vector(a), Term::Vector(b)) = (self, other) else {
            return None;
        };
        Some(Term::Vector(std::array::from_fn(|axis| {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let product = a[next].times(b[last]);
            product.plus(a[last].times(b[next]).negative())
        })))
    }

    /// As a value, without its error.
    pub fn value(&self) -> Value {
        let vector = |parts: &[Rounded; 3]| parts.map(|part| part.value);
        match self {
            Term::Number(number) => Value::Number(number.value),
            Term::Color(parts) => {
                let [r, g, b] = vector(parts);
                Value::Rgb(Rgb { r, g, b })
            }
            Term::Vector(parts) => Value::Vector(DVec3::from_array(vector(parts))),
        }
    }

    /// The absolute value, or the length.
    fn length(self) -> Option<Rounded> {
        match self {
            Term::Number(a) => Some(Rounded {
                value: a.value.abs(),
                ..a
            }),
            Term::Vector(_) => self.times(self)?.number().map(Rounded::root),
            Term::Color(_) => None,
        }
    }
}

/// As a term; words and truths are none.
impl TryFrom<Value> for Term {
    type Error = ();

    fn try_from(value: Value) -> Result<Self, ()> {
        Ok(match value {
            Value::Number(v) => Term::Number(Rounded::exact(v)),
            Value::Integer(v) => Term::Number(Rounded::exact(v as f64)),
            Value::Rgb(color) => Term::Color(color.channels().map(Rounded::exact)),
            Value::Vector(vector) => Term::Vector(vector.to_array().map(Rounded::exact)),
            Value::Truth(_) | Value::Word(_) => return Err(()),
        })
    }
}

/// The value of an expression whose named values `look_up` finds; none where one is missing, or where kinds do not go together,
/// as in the sum of a number and a vector.
pub fn evaluate(
    expression: &Expression,
    look_up: &impl Fn(&Reference) -> Option<Vec<Term>>,
) -> Option<Term> {
    let of = |inner: &Expression| evaluate(inner, look_up);
    match expression {
        Expression::Number(_, value) => Some(Term::Number(Rounded::exact(*value))),
        Expression::Value(reference) => look_up(reference)?.first().copied(),
        Expression::Sum(reference) => {
            let mut terms = look_up(reference)?.into_iter();
            let first = terms.next()?;
            terms.try_fold(first, Term::plus)
        }
        Expression::Notation(_) => None,
        Expression::Parentheses(inner) => of(inner),
        Expression::Negative(inner) => Some(of(inner)?.map(Rounded::negative)),
        Expression::Operation(a, operator, b) => {
            let (a, b) = (of(a)?, of(b)?);
            match operator {
                Operator::Plus => a.plus(b),
                Operator::Minus => a.plus(b.map(Rounded::negative)),
                Operator::Dot | Operator::Space => a.times(b),
                Operator::Cross => a.cross(b),
                Operator::Slash => quotient(a, b),
            }
        }
        Expression::Fraction(above, below) => quotient(of(above)?, of(below)?),
        Expression::Power(base, exponent) => {
            let (base, exponent) = (of(base)?.number()?, of(exponent)?.number()?);
            Some(Term::Number(base.power(exponent)))
        }
        Expression::Call(function, arguments) => {
            let arguments: Option<Vec<Term>> = arguments.iter().map(of).collect();
            call(*function, &arguments?).map(Term::Number)
        }
    }
}

fn quotient(above: Term, below: Term) -> Option<Term> {
    let below = below.number()?;
    Some(above.map(|above| above.over(below)))
}

fn call(function: Function, arguments: &[Term]) -> Option<Rounded> {
    let first = *arguments.first()?;
    let extreme = |best: fn(f64, f64) -> bool| {
        let mut numbers = arguments.iter().map(|argument| argument.number());
        let first = numbers.next()??;
        numbers.try_fold(first, |chosen, next| {
            let next = next?;
            Some(if best(next.value, chosen.value) {
                next
            } else {
                chosen
            })
        })
    };
    let integral = |round: fn(f64) -> f64| Some(Rounded::exact(round(first.number()?.value)));
    // Both angles have this slope, but for the sign.
    let angle = |of: fn(f64) -> f64| {
        let Rounded { value, error } = first.number()?;
        let cut = value.clamp(-1.0, 1.0);
        let slope = 1.0 / ((1.0 - cut) * (1.0 + cut)).sqrt();
        Some(Rounded::angle(
            of(cut),
            slope.min(1.0 / f64::EPSILON),
            error,
        ))
    };
    match function {
        Function::Max => extreme(|a, b| a > b),
        Function::Min => extreme(|a, b| a < b),
        Function::Arccos => angle(f64::acos),
        Function::Arcsin => angle(f64::asin),
        Function::Atan2 => match arguments {
            [y, x] => Some(Rounded::atan2(y.number()?, x.number()?)),
            _ => None,
        },
        Function::Sin => Some(first.number()?.sin()),
        Function::Cos => Some(first.number()?.cos()),
        Function::Tan => Some(first.number()?.tan()),
        Function::Root => Some(first.number()?.root()),
        Function::Length => first.length(),
        Function::Floor => integral(f64::floor),
        Function::Ceiling => integral(f64::ceil),
    }
}
