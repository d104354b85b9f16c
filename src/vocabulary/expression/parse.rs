//! Reads formulas.
//!
//! Names of quantities stand for their values: `I_d = k_d · max(0, N_dot_L)`. `[a; b]` is a fraction with a bar, `|x|` a length,
//! `'…'` notation without a value. Braces say more about a value: `{n=n_s}` shows another symbol for it. Where it is looked up
//! follows the name: `{x_1=x@corner:upper}` is the `x` recorded together with a `corner` equal to `upper`, and `{I@}` the `I` of
//! the nearest scope before; `{I_sum<}` is the one before the step in the same scope, `{sum<0}` the same, but 0 at its
//! beginning, and `{sum<0/Pieces}` 0 after each step of that kind; `{P^}` is the one before in this scope or one around it;
//! `Σ{sum/Pieces}` adds what each part came to that a step of that kind began; `{c<<light,x-1}` is the one of an earlier step with the
//! same `light` at this `x` − 1, `{unshot_j<<j|unshot_i<<i:j}` that or the one whose `i` is this `j`, whichever is later, and
//! `{F<<0}` any earlier one, else 0; `{L<<light in Illumination,Light}` looks into scopes of these kinds. `{T_0@cosine:"N_dot_L"}`
//! has that word beside it. `Σ{*N_k}` sums all of the scope up to the step,
//! `Σ{+I_added}` the results of the scopes inside, and `{N_k!}` is the first that is not zero. `a := b` names `b` for the
//! formulas that follow.

use super::{Equation, Expression, Function, Key, Operator, Reference, Relation, Source};
use std::collections::HashMap;
use std::sync::{LazyLock, PoisonError, RwLock};

type Parsed<T> = Result<T, String>;

impl Equation {
    /// Of a text of the program's own, which is right; it is read once, however often it is asked for.
    pub fn of(text: &'static str) -> &'static Equation {
        static READ: LazyLock<RwLock<HashMap<&'static str, &'static Equation>>> =
            LazyLock::new(RwLock::default);
        let read = READ.read().unwrap_or_else(PoisonError::into_inner);
        if let Some(equation) = read.get(text) {
            return equation;
        }
        drop(read);
        let equation = Equation::parse(text).unwrap_or_else(|error| panic!("{error}"));
        let mut read = READ.write().unwrap_or_else(PoisonError::into_inner);
        read.entry(text)
            .or_insert_with(|| Box::leak(Box::new(equation)))
    }

    /// Errors: what is wrong, and where.
    pub fn parse(text: &'static str) -> Parsed<Equation> {
        let mut parser = Parser { text, rest: text };
        let left = parser.sum()?;
        parser.space();
        let relations = [
            (":=", Relation::Defined),
            ("=", Relation::Equal),
            ("<", Relation::Less),
            ("≥", Relation::AtLeast),
        ];
        let relation = relations
            .into_iter()
            .find(|(sign, _)| parser.skip(sign))
            .map(|(_, relation)| relation);
        let right = match relation {
            Some(relation) => Some((relation, parser.sum()?)),
            None => None,
        };
        parser.space();
        match parser.rest {
            "" => Ok(Equation { left, right }),
            _ => Err(parser.unexpected("an operator or the end")),
        }
    }
}

struct Parser {
    text: &'static str,
    rest: &'static str,
}

impl Parser {
    fn unexpected(&self, wanted: &str) -> String {
        let at = self.text.len() - self.rest.len();
        format!("{}: at byte {at} stands no {wanted}", self.text)
    }

    fn skip(&mut self, sign: &str) -> bool {
        let rest = self.rest.strip_prefix(sign);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn space(&mut self) {
        self.rest = self.rest.trim_start();
    }

    fn expect(&mut self, sign: &str) -> Parsed<()> {
        self.space();
        match self.skip(sign) {
            true => Ok(()),
            false => Err(self.unexpected(sign)),
        }
    }

    /// Cuts off what is before `end`, and `end`.
    fn until(&mut self, end: char) -> Parsed<&'static str> {
        let (inside, rest) = self
            .rest
            .split_once(end)
            .ok_or_else(|| self.unexpected(&end.to_string()))?;
        self.rest = rest;
        Ok(inside)
    }

    fn sum(&mut self) -> Parsed<Expression> {
        let mut sum = self.product()?;
        loop {
            self.space();
            let operator = if self.skip("+") {
                Operator::Plus
            } else if self.skip("−") {
                Operator::Minus
            } else {
                return Ok(sum);
            };
            let next = self.product()?;
            sum = Expression::Operation(Box::new(sum), operator, Box::new(next));
        }
    }

    fn product(&mut self) -> Parsed<Expression> {
        let mut product = self.factor()?;
        loop {
            self.space();
            let operator = if self.skip("·") {
                Operator::Dot
            } else if self.skip("×") {
                Operator::Cross
            } else if self.skip("/") {
                Operator::Slash
            } else if self.rest.starts_with(begins_value) {
                Operator::Space
            } else {
                return Ok(product);
            };
            let next = self.factor()?;
            product = Expression::Operation(Box::new(product), operator, Box::new(next));
        }
    }

    fn factor(&mut self) -> Parsed<Expression> {
        self.space();
        if self.skip("−") {
            return Ok(Expression::Negative(Box::new(self.factor()?)));
        }
        let base = self.value()?;
        if !self.skip("^") {
            return Ok(base);
        }
        let exponent = self.value()?;
        Ok(Expression::Power(Box::new(base), Box::new(exponent)))
    }

    fn value(&mut self) -> Parsed<Expression> {
        self.space();
        for function in Function::ALL {
            let [before, after] = function.signs();
            if self.skip(before) {
                return self.arguments(function, after);
            }
        }
        if self.skip("(") {
            let inner = self.sum()?;
            self.expect(")")?;
            return Ok(Expression::Parentheses(Box::new(inner)));
        }
        if self.skip("[") {
            let above = self.sum()?;
            self.expect(";")?;
            let below = self.sum()?;
            self.expect("]")?;
            return Ok(Expression::Fraction(Box::new(above), Box::new(below)));
        }
        if self.skip("'") {
            return self.until('\'').map(Expression::Notation);
        }
        if self.skip("Σ{") {
            return Ok(Expression::Sum(self.reference()?));
        }
        if self.skip("{") {
            return Ok(Expression::Value(self.reference()?));
        }
        if self.skip("π") {
            return Ok(Expression::Number("π", std::f64::consts::PI));
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit()) {
            let number = self.take(|c| c.is_ascii_digit() || c == '.');
            let value = number.parse().map_err(|_| self.unexpected("number"))?;
            return Ok(Expression::Number(number, value));
        }
        match self.take(|c| c.is_ascii_alphanumeric() || c == '_') {
            "" => Err(self.unexpected("value")),
            name => Ok(Expression::Value(Reference {
                other_symbol: None,
                name,
                source: Source::Last,
            })),
        }
    }

    /// What follows as far as it is `of` a kind.
    fn take(&mut self, of: impl Fn(char) -> bool) -> &'static str {
        let end = self.rest.find(|c| !of(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }

    fn arguments(&mut self, function: Function, after: &str) -> Parsed<Expression> {
        // What ends by itself takes one value.
        if after.is_empty() {
            return Ok(Expression::Call(function, vec![self.value()?]));
        }
        let mut arguments = vec![self.sum()?];
        self.space();
        while self.skip(",") {
            arguments.push(self.sum()?);
            self.space();
        }
        self.expect(after)?;
        Ok(Expression::Call(function, arguments))
    }

    /// The inside of braces.
    fn reference(&mut self) -> Parsed<Reference> {
        let mut depth = 1;
        let end = self.rest.find(|c| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            depth == 0
        });
        let end = end.ok_or_else(|| self.unexpected("}"))?;
        let inside = &self.rest[..end];
        self.rest = &self.rest[end + 1..];
        let (other_symbol, source) = match inside.rsplit_once('=') {
            Some((symbol, source)) => (Some(symbol), source),
            None => (None, inside),
        };
        let (name, source) = if let Some(name) = source.strip_prefix('*') {
            (name, Source::All)
        } else if let Some(name) = source.strip_prefix('+') {
            (name, Source::Inside)
        } else if let Some(name) = source.strip_suffix('^') {
            (name, Source::Around)
        } else if let Some(name) = source.strip_suffix('!') {
            (name, Source::First)
        } else if let Some((name, _)) = source.split_once("<<") {
            (name, earlier(source))
        } else if let Some((name, start)) = source.split_once('<') {
            (name, Source::Before(start_of(start)))
        } else if let Some((name, kind)) = source.split_once('/') {
            (name, Source::Parts(kind))
        } else if let Some((name, beside)) = source.split_once('@') {
            let (key, by) = beside.split_once(':').unwrap_or(("", ""));
            (name, Source::Beside { key, by })
        } else {
            (source, Source::Last)
        };
        Ok(Reference {
            other_symbol,
            name,
            source,
        })
    }
}

/// `name<<keys` or `name<<keys|other name<<keys`; `name<<0/Kind` has no keys.
fn earlier(text: &'static str) -> Source {
    let (text, within) = match text.split_once(" in ") {
        Some((text, kinds)) => (text, kinds.split(',').collect()),
        None => (text, Vec::new()),
    };
    let mut start = None;
    let mut options = Vec::new();
    for option in text.split('|') {
        let (name, keys) = option.split_once("<<").unwrap_or((option, ""));
        start = start_of(keys);
        let keys = match start {
            Some(_) => Vec::new(),
            None => keys.split(',').map(key).collect(),
        };
        options.push((name, keys));
    }
    Source::Earlier {
        options,
        start,
        within,
    }
}

/// `0` or `0/Kind`: where a running sum begins.
fn start_of(text: &'static str) -> Option<&'static str> {
    let kind = text.strip_prefix('0')?;
    Some(kind.trim_start_matches('/'))
}

/// `light`, `x-1` or `i:j`.
fn key(text: &'static str) -> Key {
    if let Some((name, by)) = text.split_once(':') {
        return Key {
            name,
            by,
            offset: 0,
        };
    }
    let (name, offset) = match text.strip_suffix("-1") {
        Some(name) => (name, -1),
        None => (text, 0),
    };
    Key {
        name,
        by: name,
        offset,
    }
}

/// Whether a value can begin so, without an operator before it.
fn begins_value(c: char) -> bool {
    c.is_ascii_alphanumeric() || "([{'√π⌊⌈Σ".contains(c)
}
