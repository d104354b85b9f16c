//! Formulas as templates: symbols and numbers come from the same text, so they cannot disagree.
//!
//! `{I_4}` is a value told under that name; `{cos φ=N_dot_L}` shows another symbol for it; `{x_1=x@corner:upper}` is the `x`
//! told together with a `corner` equal to the value of `upper`, and `{I@}` the `I` told last by a scope before; `{I=I_sum<}` is
//! the `I_sum` told last before the step, in the same scope; `{ΣN_k=*N_k}`
//! are all values told under the name, and `{+I_added}` those told at the end of each scope inside, joined by plus signs.
//! `[a; b]` is a fraction. All else stands for itself, in the notation of [`math`](crate::picture::math()).

use crate::picture::symbol;
use crate::record::{Fields, Value};
use crate::replay::{RecordedField, Walk};

/// A piece of a template.
#[derive(Clone, PartialEq, Debug)]
pub enum Piece {
    Text(String),
    Place(Place),
    Fraction(Vec<Piece>, Vec<Piece>),
}

/// A placeholder.
#[derive(Clone, PartialEq, Debug)]
pub struct Place {
    pub symbol: String,
    pub name: String,
    source: Source,
}

#[derive(Clone, PartialEq, Debug)]
enum Source {
    /// The value told last.
    Last,
    /// The value told last in the same scope, before the step.
    Before,
    /// All values told.
    All,
    /// Those that the scopes inside told at their end.
    Inside,
    /// The value told beside `key`, where that equals the value of `by`.
    Beside { key: String, by: String },
}

/// The pieces of a template.
pub fn parse(template: &str) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut rest = template;
    while let Some(at) = rest.find(['{', '[']) {
        if at > 0 {
            pieces.push(Piece::Text(rest[..at].to_string()));
        }
        let inner = &rest[at + 1..];
        let end = closing(inner, rest.as_bytes()[at]);
        let body = &inner[..end];
        pieces.push(if rest.as_bytes()[at] == b'{' {
            Piece::Place(place(body))
        } else {
            let (above, below) = body.split_once(';').unwrap_or((body, ""));
            Piece::Fraction(parse(above.trim()), parse(below.trim()))
        });
        rest = inner.get(end + 1..).unwrap_or_default();
    }
    if !rest.is_empty() {
        pieces.push(Piece::Text(rest.to_string()));
    }
    pieces
}

/// Where the bracket closes that was opened before `text`; its end where it never does.
fn closing(text: &str, open: u8) -> usize {
    let close = if open == b'{' { b'}' } else { b']' };
    let mut depth = 1;
    for (at, byte) in text.bytes().enumerate() {
        depth += i32::from(byte == open) - i32::from(byte == close);
        if depth == 0 {
            return at;
        }
    }
    text.len()
}

fn place(body: &str) -> Place {
    let (shown, source) = match body.split_once('=') {
        Some((shown, source)) => (Some(shown), source),
        None => (None, body),
    };
    let (name, source) = if let Some(name) = source.strip_prefix('*') {
        (name, Source::All)
    } else if let Some(name) = source.strip_prefix('+') {
        (name, Source::Inside)
    } else if let Some(name) = source.strip_suffix('<') {
        (name, Source::Before)
    } else if let Some((name, beside)) = source.split_once('@') {
        let (key, by) = beside.split_once(':').unwrap_or(("", ""));
        let (key, by) = (key.to_string(), by.to_string());
        (name, Source::Beside { key, by })
    } else {
        (source, Source::Last)
    };
    Place {
        symbol: shown.map_or_else(|| symbol(name), str::to_string),
        name: name.to_string(),
        source,
    }
}

/// Scopes that are looked through for a value, at each level around a step: enough for an edge table behind a polygon's
/// vertices, and never a whole run.
const MOST_SCOPES: usize = 64;

/// Steps of the same scope that are looked through for a value: enough for what a ray does, and never a whole frame.
const MOST_SIBLINGS: usize = 256;

/// What is known at a step.
pub struct Known<'a> {
    walk: &'a dyn Walk,
    step: usize,
    recorded: Vec<RecordedField>,
}

impl<'a> Known<'a> {
    pub fn at(walk: &'a dyn Walk, step: usize) -> Self {
        Known {
            walk,
            step,
            recorded: walk.recorded(step),
        }
    }

    /// The value told last under `name`: by the step and the headings around it, else earlier in the same scope.
    pub fn get(&self, name: &str) -> Option<RecordedField> {
        let mut recorded = self.recorded.iter().rev();
        let recorded = recorded
            .find(|recorded| recorded.field.name == name)
            .copied();
        recorded.or_else(|| self.before(name))
    }

    /// The value told last under `name` by the steps before in the same scope, and by the ends of the scopes in it.
    fn before(&self, name: &str) -> Option<RecordedField> {
        let outline = self.walk.outline();
        let scope = outline.parent(self.step)?;
        // Backward: before a step in the scope lies a step of it, or the end of a scope in it.
        let opener = |end: usize| {
            std::iter::successors(Some(end), |&step| outline.parent(step))
                .find(|&step| outline.parent(step) == Some(scope))
        };
        let before = |step: usize| Some(step - 1).filter(|&end| end > scope);
        let ends = std::iter::successors(before(self.step), |&end| before(opener(end)?));
        ends.take(MOST_SIBLINGS).find_map(|step| {
            let fields = self.walk.own_fields(step);
            let field = *fields.0.iter().rev().find(|field| field.name == name)?;
            Some(RecordedField { step, field })
        })
    }

    /// The values of a placeholder, one but for sums; none where nobody told it.
    pub fn values(&self, place: &Place) -> Option<Vec<Value>> {
        let values: Vec<Value> = match &place.source {
            Source::Last => vec![self.get(&place.name)?.field.value],
            Source::Before => vec![self.before(&place.name)?.field.value],
            Source::All => {
                let recorded = self.recorded.iter();
                recorded
                    .filter(|recorded| recorded.field.name == place.name)
                    .map(|recorded| recorded.field.value)
                    .collect()
            }
            Source::Inside => {
                let scope = self.walk.outline().parent(self.step)?;
                let ends = self
                    .scopes_in(scope)
                    .map(|(_, end)| self.walk.own_fields(end));
                ends.filter_map(|fields| fields.get(&place.name)).collect()
            }
            Source::Beside { key, by } => vec![self.beside(&place.name, key, by)?],
        };
        (!values.is_empty()).then_some(values)
    }

    fn beside(&self, name: &str, key: &str, by: &str) -> Option<Value> {
        let wanted = self.get(by).map(|recorded| recorded.field.value);
        let right =
            |fields: &Fields| key.is_empty() || wanted.is_some() && fields.get(key) == wanted;
        let look = |step: usize| {
            let fields = self.walk.own_fields(step);
            fields.get(name).filter(|_| right(&fields))
        };
        let mut tellers: Vec<usize> = self.recorded.iter().map(|recorded| recorded.step).collect();
        tellers.dedup();
        let recorded = tellers.into_iter().rev().find_map(look);
        let around = self.walk.outline().scopes(self.step);
        recorded.or_else(|| {
            around
                .flat_map(|scope| self.scopes_in(scope).collect::<Vec<_>>())
                .filter(|&(_, end)| end < self.step)
                .find_map(|(scope, end)| {
                    let heading = self.walk.heading(scope, end);
                    heading.chain([end]).find_map(look)
                })
        })
    }

    /// First and last step of the first scopes directly in `scope`.
    fn scopes_in(&self, scope: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let outline = self.walk.outline();
        let end = outline.last(scope);
        let first = (scope + 1 < end).then_some(scope + 1);
        std::iter::successors(first, move |&step| {
            Some(outline.last(step) + 1).filter(|&next| next < end)
        })
        .take(2 * MOST_SCOPES)
        .filter(move |&step| outline.opens(step))
        .take(MOST_SCOPES)
        .map(move |step| (step, outline.last(step)))
    }
}

/// All placeholders of a template, those in fractions too.
pub fn places(pieces: &[Piece]) -> Vec<&Place> {
    pieces
        .iter()
        .flat_map(|piece| match piece {
            Piece::Text(_) => Vec::new(),
            Piece::Place(place) => vec![place],
            Piece::Fraction(above, below) => [places(above), places(below)].concat(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn templates_have_text_places_and_fractions() {
        let pieces = parse("2 [{y_4} − {y_2}; {dy=h@edge:edge}]·{I_1}");
        assert_eq!(pieces[0], Piece::Text("2 ".to_string()));
        let Piece::Fraction(above, below) = &pieces[1] else {
            panic!("{pieces:?}");
        };
        assert_eq!((above.len(), below.len()), (3, 1));
        let names: Vec<(&str, &str)> = places(&pieces)
            .into_iter()
            .map(|place| (place.symbol.as_str(), place.name.as_str()))
            .collect();
        assert_eq!(
            names,
            [("y_4", "y_4"), ("y_2", "y_2"), ("dy", "h"), ("I_1", "I_1")]
        );
    }
}
