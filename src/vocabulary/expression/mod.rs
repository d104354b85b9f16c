//! Formulas as expressions over named values: parsed once, set with symbols or with numbers, and evaluated.

mod evaluate;
mod parse;

pub use evaluate::{Rounded, Term, evaluate};

use super::quantity::find;
use super::scene_value::SceneValue;

/// A formula: a value alone, or two sides.
#[derive(Clone, PartialEq, Debug)]
pub struct Equation {
    pub left: Expression,
    pub right: Option<(Relation, Expression)>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Relation {
    Equal,
    /// The left side is a name that the formulas after it use; no event records it.
    Defined,
    Less,
    AtLeast,
}

impl Relation {
    pub fn sign(self) -> &'static str {
        match self {
            Relation::Equal | Relation::Defined => "=",
            Relation::Less => "<",
            Relation::AtLeast => "≥",
        }
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum Expression {
    /// As it is written, and its value.
    Number(&'static str, f64),
    Value(Reference),
    /// Σ of all values that a reference finds.
    Sum(Reference),
    /// Mathematics that has no value here, in the notation of [`math`](crate::picture::math()).
    Notation(&'static str),
    Parentheses(Box<Expression>),
    Negative(Box<Expression>),
    Operation(Box<Expression>, Operator, Box<Expression>),
    /// With a bar.
    Fraction(Box<Expression>, Box<Expression>),
    Power(Box<Expression>, Box<Expression>),
    Call(Function, Vec<Expression>),
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    Plus,
    Minus,
    /// `·`: of two vectors the dot product.
    Dot,
    /// `×`: of two vectors the cross product.
    Cross,
    /// A product without a sign.
    Space,
    /// A quotient on the line.
    Slash,
}

impl Operator {
    pub fn sign(self) -> &'static str {
        match self {
            Operator::Plus => " + ",
            Operator::Minus => " − ",
            Operator::Dot => " · ",
            Operator::Cross => " × ",
            Operator::Space => " ",
            Operator::Slash => " / ",
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Function {
    Max,
    Min,
    /// Of a number between −1 and 1, in degrees; rounding beyond is cut off.
    Arccos,
    Arcsin,
    /// Of y and x: the angle from the axis x toward y, in degrees from 0 to 360.
    Atan2,
    /// Of an angle in degrees.
    Sin,
    Cos,
    Tan,
    Root,
    /// |…|: of a vector its length.
    Length,
    Floor,
    Ceiling,
}

impl Function {
    /// What stands before and behind its arguments.
    pub fn signs(self) -> [&'static str; 2] {
        match self {
            Function::Max => ["max(", ")"],
            Function::Min => ["min(", ")"],
            Function::Arccos => ["arccos ", ""],
            Function::Arcsin => ["arcsin ", ""],
            Function::Atan2 => ["atan2(", ")"],
            Function::Sin => ["sin ", ""],
            Function::Cos => ["cos ", ""],
            Function::Tan => ["tan ", ""],
            Function::Root => ["√", ""],
            Function::Length => ["|", "|"],
            Function::Floor => ["⌊", "⌋"],
            Function::Ceiling => ["⌈", "⌉"],
        }
    }

    const ALL: [Function; 12] = [
        Function::Max,
        Function::Min,
        Function::Arccos,
        Function::Arcsin,
        Function::Atan2,
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Root,
        Function::Length,
        Function::Floor,
        Function::Ceiling,
    ];
}

/// A named value of a formula, and where it is looked up.
#[derive(Clone, PartialEq, Debug)]
pub struct Reference {
    /// The symbol that stands here for the quantity's own.
    pub other_symbol: Option<&'static str>,
    pub name: &'static str,
    pub source: Source,
}

impl Reference {
    /// In the notation of [`math`](crate::picture::math()).
    pub fn symbol(&self) -> &'static str {
        let recorded = || find(self.name).map(|quantity| quantity.symbol);
        let of_scene = || SceneValue::named(self.name).map(|value| value.symbol);
        self.other_symbol
            .or_else(recorded)
            .or_else(of_scene)
            .unwrap_or(self.name)
    }
}

/// Where a value comes from.
#[derive(Clone, PartialEq, Debug)]
pub enum Source {
    /// The value recorded last, or one that the scene gives.
    Last,
    /// The value recorded last before the step, in the same scope. With a start it is 0 at the beginning of the scope, and after
    /// each step of the kind that the start names.
    Before(Option<&'static str>),
    /// The value recorded last before the step, in the same scope or one around it.
    Around,
    /// The values of the scope's steps up to this one.
    All,
    /// The first of them that is not zero.
    First,
    /// The one recorded last before each step of the kind but the first, in the same scope, and the last one of all: what each part
    /// came to that such a step begins.
    Parts(&'static str),
    /// Those that the scopes inside recorded at their end.
    Inside,
    /// The value recorded beside `key`, where that equals the value of `by`, or the word in quotation marks; without a key, by the
    /// nearest scope before.
    Beside { key: &'static str, by: &'static str },
    /// The value recorded last before the step, in this scope or one like it, under one of the names and where its keys agree;
    /// with a start as above. Closed scopes are looked into where they are of a kind `within`, and without one, of a kind that
    /// is around the step.
    Earlier {
        options: Vec<(&'static str, Vec<Key>)>,
        start: Option<&'static str>,
        within: Vec<&'static str>,
    },
}

/// A value that an earlier step shares with this one: its `name` there equals `by` here, plus `offset`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Key {
    pub name: &'static str,
    pub by: &'static str,
    pub offset: i64,
}

impl Equation {
    /// All values that take part, from left to right.
    pub fn references(&self) -> Vec<&Reference> {
        let mut found = self.left.references();
        if let Some((_, right)) = &self.right {
            found.extend(right.references());
        }
        found
    }

    /// Whether everything in it has a value.
    pub fn is_computable(&self) -> bool {
        let mut computable = true;
        let mut look = |inner: &Expression| computable &= !matches!(inner, Expression::Notation(_));
        self.left.each(&mut look);
        if let Some((_, right)) = &self.right {
            right.each(&mut look);
        }
        computable
    }

    /// The value that the formula is about: its left side, where that is one value.
    pub fn subject(&self) -> Option<&Reference> {
        match &self.left {
            Expression::Value(reference) => Some(reference),
            _ => None,
        }
    }
}

impl Expression {
    /// Calls `look` with this expression and each one in it, from left to right.
    fn each<'a>(&'a self, look: &mut impl FnMut(&'a Expression)) {
        look(self);
        match self {
            Expression::Parentheses(inner) | Expression::Negative(inner) => inner.each(look),
            Expression::Operation(a, _, b)
            | Expression::Fraction(a, b)
            | Expression::Power(a, b) => {
                a.each(look);
                b.each(look);
            }
            Expression::Call(_, arguments) => arguments.iter().for_each(|inner| inner.each(look)),
            Expression::Number(..)
            | Expression::Value(_)
            | Expression::Sum(_)
            | Expression::Notation(_) => {}
        }
    }

    /// All values that take part, from left to right.
    pub fn references(&self) -> Vec<&Reference> {
        let mut found = Vec::new();
        self.each(&mut |inner| {
            if let Expression::Value(reference) | Expression::Sum(reference) = inner {
                found.push(reference);
            }
        });
        found
    }
}

#[cfg(test)]
mod tests;
