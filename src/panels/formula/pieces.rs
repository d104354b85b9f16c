//! Expressions as pieces that stand beside each other.

use crate::vocabulary::expression::{Expression, Function, Operator, Reference};

/// A part of a formula as it is set.
#[derive(Clone, PartialEq, Debug)]
pub enum Piece<'a> {
    Text(String),
    Value(&'a Reference),
    /// All values of a reference.
    Sum(&'a Reference),
    /// The exponent of what stands before.
    Raised(Vec<Piece<'a>>),
    Fraction(Vec<Piece<'a>>, Vec<Piece<'a>>),
}

/// The pieces of an expression.
pub fn pieces(expression: &Expression) -> Vec<Piece<'_>> {
    let mut written = Vec::new();
    write(expression, &mut written);
    written
}

fn text(written: &mut Vec<Piece>, more: &str) {
    match written.last_mut() {
        Some(Piece::Text(text)) => text.push_str(more),
        _ => written.push(Piece::Text(more.to_string())),
    }
}

fn write<'a>(expression: &'a Expression, written: &mut Vec<Piece<'a>>) {
    match expression {
        Expression::Number(number, _) => text(written, number),
        Expression::Notation(notation) => text(written, notation),
        Expression::Value(reference) => written.push(Piece::Value(reference)),
        Expression::Sum(reference) => written.push(Piece::Sum(reference)),
        Expression::Parentheses(inner) => {
            text(written, "(");
            write(inner, written);
            text(written, ")");
        }
        Expression::Negative(inner) => {
            text(written, "−");
            write(inner, written);
        }
        Expression::Operation(a, operator, b) => {
            write(a, written);
            let coefficient = matches!(
                (&**a, &**b),
                (Expression::Number(..), Expression::Number(..))
            );
            // 2π, but 2 u
            if !(coefficient && *operator == Operator::Space) {
                text(written, operator.sign());
            }
            write(b, written);
        }
        Expression::Fraction(above, below) => {
            written.push(Piece::Fraction(pieces(above), pieces(below)));
        }
        Expression::Power(base, exponent) => {
            write(base, written);
            written.push(Piece::Raised(pieces(exponent)));
        }
        Expression::Call(function, arguments) => call(*function, arguments, written),
    }
}

fn call<'a>(function: Function, arguments: &'a [Expression], written: &mut Vec<Piece<'a>>) {
    let [before, after] = function.signs();
    text(written, before);
    for (i, argument) in arguments.iter().enumerate() {
        if i > 0 {
            text(written, ", ");
        }
        write(argument, written);
    }
    text(written, after);
}
