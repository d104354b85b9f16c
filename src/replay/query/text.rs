//! Queries as a user types them: a kind, then conditions, apart by spaces.

use super::{Comparison, Condition, Multiple, Operand, Query, check_field, is_name};
use std::fmt;
use std::str::FromStr;

/// Where a query went wrong, and what would be right there.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("column {column}: expected {expected}, found {found}")]
pub struct QueryError {
    /// In characters, counted from 1.
    pub column: usize,
    pub expected: &'static str,
    /// What stands there, in quotation marks, or `the end`.
    pub found: String,
}

/// Longer signs before the shorter ones that they begin with.
const SIGNS: [(&str, Comparison); 7] = [
    ("==", Comparison::Equal),
    ("!=", Comparison::NotEqual),
    ("<=", Comparison::AtMost),
    (">=", Comparison::AtLeast),
    ("=", Comparison::Equal),
    ("<", Comparison::Below),
    (">", Comparison::Above),
];

impl FromStr for Query {
    type Err = QueryError;

    fn from_str(text: &str) -> Result<Self, QueryError> {
        let mut scanner = Scanner { text, at: 0 };
        let mut query = Query::default();
        while !scanner.rest().is_empty() {
            let start = scanner.at;
            let name = scanner.word();
            if let Some(comparison) = scanner.sign() {
                check_field(name).map_err(|expected| scanner.error(start, expected))?;
                query.conditions.push(Condition {
                    field: name.to_owned(),
                    comparison,
                    value: scanner.operand(comparison)?,
                });
            } else if query.kind.is_some() || !query.conditions.is_empty() {
                let at = if name.is_empty() { start } else { scanner.at };
                let expected = if name.is_empty() {
                    "a condition, such as y=15"
                } else {
                    "a comparison: =, !=, <, <=, > or >="
                };
                return Err(scanner.error(at, expected));
            } else if is_name(name) {
                query.kind = Some(name.to_owned());
            } else {
                return Err(scanner.error(start, KIND_OR_CONDITION));
            }
        }
        if query == Query::default() {
            return Err(scanner.error(scanner.at, KIND_OR_CONDITION));
        }
        Ok(query)
    }
}

const KIND_OR_CONDITION: &str = "a kind of event or a condition, such as y=15";

const MULTIPLES: &str =
    "multiples of fields, such as 0.5*I, 0.5*I@Illuminated or 2*I-1*I@(Illuminated light=0)";

struct Scanner<'a> {
    text: &'a str,
    /// In bytes, at the start of a character.
    at: usize,
}

impl<'a> Scanner<'a> {
    /// What is left after spaces.
    fn rest(&mut self) -> &'a str {
        let rest = self.text[self.at..].trim_start();
        self.at = self.text.len() - rest.len();
        rest
    }

    /// Up to the next space or sign; empty where one of them stands.
    fn word(&mut self) -> &'a str {
        let rest = self.rest();
        let end = rest.find(ends_word).unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    /// As a word, in which there may be spaces and signs in parentheses.
    fn sum(&mut self) -> &'a str {
        let rest = self.rest();
        let mut inside = false;
        let end = rest.find(|c| {
            inside = c == '(' || inside && c != ')';
            !inside && ends_word(c)
        });
        let end = end.unwrap_or(rest.len());
        self.at += end;
        &rest[..end]
    }

    fn sign(&mut self) -> Option<Comparison> {
        let rest = self.rest();
        let (sign, comparison) = SIGNS.iter().find(|(sign, _)| rest.starts_with(sign))?;
        self.at += sign.len();
        Some(*comparison)
    }

    fn operand(&mut self, comparison: Comparison) -> Result<Operand, QueryError> {
        let rest = self.rest();
        let start = self.at;
        let operand = if let Some(quoted) = rest.strip_prefix('"') {
            let Some(end) = quoted.find('"') else {
                return Err(self.error(self.text.len(), "a closing quotation mark"));
            };
            self.at += end + 2;
            Operand::Word(quoted[..end].to_owned())
        } else {
            match self.word() {
                "true" => Operand::Truth(true),
                "false" => Operand::Truth(false),
                word if is_name(word) => Operand::Word(word.to_owned()),
                word if word.contains('*') => {
                    self.at = start;
                    let multiples = Multiple::parse_sum(self.sum());
                    Operand::Multiples(multiples.ok_or_else(|| self.error(start, MULTIPLES))?)
                }
                word => match word.parse::<f64>() {
                    Ok(number) if number.is_finite() && !word.ends_with(char::is_alphabetic) => {
                        Operand::Number(number)
                    }
                    _ => {
                        return Err(self.error(start, "a number, true, false or a word"));
                    }
                },
            }
        };
        let ordered = !matches!(comparison, Comparison::Equal | Comparison::NotEqual);
        if ordered && !matches!(operand, Operand::Number(_) | Operand::Multiples(_)) {
            return Err(self.error(start, "a number after <, <=, > or >="));
        }
        Ok(operand)
    }

    fn error(&self, at: usize, expected: &'static str) -> QueryError {
        let rest = &self.text[at..];
        let end = rest
            .char_indices()
            .skip(1)
            .find(|&(_, c)| ends_word(c))
            .map_or(rest.len(), |(end, _)| end);
        QueryError {
            column: self.text[..at].chars().count() + 1,
            expected,
            found: if rest.is_empty() {
                "the end".to_owned()
            } else {
                format!("`{}`", &rest[..end])
            },
        }
    }
}

fn ends_word(c: char) -> bool {
    c.is_whitespace() || matches!(c, '=' | '!' | '<' | '>')
}

/// As it would be typed.
impl fmt::Display for Query {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut separator = "";
        if let Some(kind) = &self.kind {
            f.write_str(kind)?;
            separator = " ";
        }
        for condition in &self.conditions {
            write!(f, "{separator}{condition}")?;
            separator = " ";
        }
        Ok(())
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.field, self.comparison, self.value)
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Comparison::Equal => "=",
            Comparison::NotEqual => "!=",
            Comparison::Below => "<",
            Comparison::AtMost => "<=",
            Comparison::Above => ">",
            Comparison::AtLeast => ">=",
        })
    }
}

impl fmt::Display for Operand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Operand::Number(number) => write!(f, "{number}"),
            Operand::Truth(truth) => write!(f, "{truth}"),
            Operand::Word(word) if is_name(word) && word != "true" && word != "false" => {
                f.write_str(word)
            }
            Operand::Word(word) => write!(f, "\"{word}\""),
            Operand::Multiples(multiples) => {
                for (index, multiple) in multiples.iter().enumerate() {
                    let plus = index > 0 && multiple.factor.is_sign_positive();
                    write!(f, "{}{multiple}", if plus { "+" } else { "" })?;
                }
                Ok(())
            }
        }
    }
}

#[cfg(test)]
mod tests;
