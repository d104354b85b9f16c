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
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn condition(field: &str, comparison: Comparison, value: Operand) -> Condition {
        Condition {
            field: field.to_owned(),
            comparison,
            value,
        }
    }

    #[test]
    fn what_a_user_types() {
        let parse = |text: &str| text.parse::<Query>().expect(text);
        let edge = parse("EdgeInterpolated y=15 I_4>0.5");
        assert_eq!(edge.kind.as_deref(), Some("EdgeInterpolated"));
        assert_eq!(
            edge.conditions,
            [
                condition("y", Comparison::Equal, Operand::Number(15.0)),
                condition("I_4", Comparison::Above, Operand::Number(0.5)),
            ]
        );
        assert_eq!(
            parse("DepthTested nearer=false").conditions,
            [condition(
                "nearer",
                Comparison::Equal,
                Operand::Truth(false)
            )]
        );
        assert_eq!(
            parse("  y ==  15  N.z<=-1e-3 why!=\"no coefficient\""),
            Query {
                kind: None,
                conditions: vec![
                    condition("y", Comparison::Equal, Operand::Number(15.0)),
                    condition("N.z", Comparison::AtMost, Operand::Number(-1e-3)),
                    condition(
                        "why",
                        Comparison::NotEqual,
                        Operand::Word("no coefficient".to_owned())
                    ),
                ],
            }
        );
        assert_eq!(parse("y=15"), parse(" y = 15 "));
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        let cases = [
            (
                "",
                "column 1: expected a kind of event or a condition, such as y=15, found the end",
            ),
            (
                "  ",
                "column 3: expected a kind of event or a condition, such as y=15, found the end",
            ),
            (
                "15",
                "column 1: expected a kind of event or a condition, such as y=15, found `15`",
            ),
            (
                "Ray Hit",
                "column 8: expected a comparison: =, !=, <, <=, > or >=, found the end",
            ),
            (
                "Ray y 15",
                "column 7: expected a comparison: =, !=, <, <=, > or >=, found `15`",
            ),
            (
                "y=15 Ray",
                "column 9: expected a comparison: =, !=, <, <=, > or >=, found the end",
            ),
            (
                "Ray ! y",
                "column 5: expected a condition, such as y=15, found `!`",
            ),
            (
                "y=",
                "column 3: expected a number, true, false or a word, found the end",
            ),
            (
                "y=1e400",
                "column 3: expected a number, true, false or a word, found `1e400`",
            ),
            (
                "y=+inf",
                "column 3: expected a number, true, false or a word, found `+inf`",
            ),
            (
                "y=1.2.3",
                "column 3: expected a number, true, false or a word, found `1.2.3`",
            ),
            (
                "Ray y>high",
                "column 7: expected a number after <, <=, > or >=, found `high`",
            ),
            (
                "I>2*",
                "column 3: expected multiples of fields, such as 0.5*I, 0.5*I@Illuminated or 2*I-1*I@(Illuminated light=0), found `2*`",
            ),
            (
                "I>2*I@3",
                "column 3: expected multiples of fields, such as 0.5*I, 0.5*I@Illuminated or 2*I-1*I@(Illuminated light=0), found `2*I@3`",
            ),
            (
                "I>2*I@(Ray I>1*I@(Ray))",
                "column 3: expected multiples of fields, such as 0.5*I, 0.5*I@Illuminated or 2*I-1*I@(Illuminated light=0), found `2*I@(Ray`",
            ),
            (
                "why=\"no",
                "column 8: expected a closing quotation mark, found the end",
            ),
            (
                "N.w=1",
                "column 1: expected .r, .g or .b of a colour, .x, .y or .z of a vector, found `N.w`",
            ),
            (
                "µ=é",
                "column 1: expected the name of a field, such as I_4, found `µ`",
            ),
            (
                "=3",
                "column 1: expected the name of a field, such as I_4, found `=3`",
            ),
        ];
        for (text, message) in cases {
            let error = text.parse::<Query>().expect_err(text);
            assert_eq!(error.to_string(), message, "{text}");
        }
    }

    proptest! {
        #[test]
        fn what_is_shown_can_be_typed(
            kind in prop::option::of("[A-Za-z_][A-Za-z0-9_]{0,9}"),
            conditions in prop::collection::vec(("[a-zA-Z_]{1,4}(\\.[rgbxyz])?", 0..6_usize, operand()), 1..4),
        ) {
            let comparisons = SIGNS[1..].iter().map(|&(_, comparison)| comparison);
            let equal_only = |value: &Operand| matches!(value, Operand::Truth(_) | Operand::Word(_));
            let conditions = conditions.into_iter().map(|(field, index, value)| Condition {
                comparison: if equal_only(&value) { Comparison::NotEqual } else { comparisons.clone().nth(index).expect("six") },
                field,
                value,
            });
            let query = Query { kind, conditions: conditions.collect() };
            prop_assert_eq!(query.to_string().parse(), Ok(query));
        }

        #[test]
        fn no_text_makes_it_panic(text in "\\PC{0,20}|[a-z.=<>! \"0-9µ]{0,20}") {
            if let Err(error) = text.parse::<Query>() {
                prop_assert!(error.column <= text.chars().count() + 1);
            }
        }
    }

    fn operand() -> impl Strategy<Value = Operand> {
        prop_oneof![
            prop::num::f64::NORMAL.prop_map(Operand::Number),
            any::<bool>().prop_map(Operand::Truth),
            "[^\"]{0,8}".prop_map(Operand::Word),
            prop::collection::vec(multiple(), 1..3).prop_map(Operand::Multiples),
        ]
    }

    fn multiple() -> impl Strategy<Value = Multiple> {
        let at = prop::option::of("[A-Z]{1,4}( [a-z]{1,4}(=|>=)[0-9])?");
        (prop::num::f64::NORMAL, "[a-z_]{1,4}(\\.[rgb])?", at).prop_map(|(factor, field, at)| {
            let at = at.map(|at| at.parse().expect(&at));
            Multiple { factor, field, at }
        })
    }
}
