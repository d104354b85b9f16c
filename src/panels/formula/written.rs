//! Formulas of a step as lines of text: with symbols, and with this step's numbers.

use super::pieces::pieces;
use super::set::{Voice, set_pieces};
use super::{Known, entry, formulas};
use crate::language::Language;
use crate::picture::plain;
use crate::replay::Run;
use crate::vocabulary::expression::{Equation, Expression};

/// A line a formula; of colours the numbers of one channel.
pub fn written(run: &Run, step: usize, channel: usize, language: Language) -> Vec<String> {
    let mut known = Known::at(run, step);
    let Some(entry) = entry(run.walk().declared(step), &known) else {
        return Vec::new();
    };
    let formulas = formulas(entry, &mut known);
    let side = |expression: &Expression, voice| {
        let atoms = set_pieces(&pieces(expression), voice, &known, language, 1.0, false);
        let texts = atoms.iter().map(|atom| {
            let space = if atom.space > 0.0 { " " } else { "" };
            format!("{space}{}", atom.written())
        });
        texts.collect::<String>()
    };
    let line = |equation: &'static Equation| {
        let (relation, right) = equation.right.as_ref()?;
        let left = side(&equation.left, Voice::Symbols);
        let [symbols, numbers] =
            [Voice::Symbols, Voice::Numbers(channel)].map(|voice| side(right, voice));
        let sign = relation.sign();
        Some(match symbols == numbers {
            true => format!("{left} {sign} {symbols}"),
            false => format!("{left} {sign} {symbols} = {numbers}"),
        })
    };
    let lines = formulas
        .iter()
        .filter_map(|formula| line(formula.equation()));
    lines.map(|line| plain(&line)).collect()
}
