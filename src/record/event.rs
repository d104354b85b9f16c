//! What every event provides: its kind, its line in the pseudocode, its values by name.

use crate::color::Rgb;
use crate::language::{Language, Message};
use glam::DVec3;

/// A typed event of one algorithm. Small and `Copy`: bulk data stays in the scene and is named by index.
pub trait Event: Copy + Send + Sync + 'static {
    /// The event's name, as search, lessons and `steps` write it: `EdgeInterpolated`.
    fn kind(&self) -> &'static str;
    /// The line of pseudocode that this event carries out.
    fn line(&self) -> Line;
    /// Whether the values of a plain step at the head of a scope hold for the rest of the scope too. A test of one candidate after
    /// another does not.
    fn holds_on(&self) -> bool {
        true
    }
    /// Appends the event's own values, named as in the literature.
    fn fields(&self, fields: &mut Fields);
}

/// Pseudocode as a textbook prints it.
#[derive(PartialEq, Eq, Debug)]
pub struct Listing {
    pub name: &'static str,
    /// Each line after the labels, apart by spaces, by which events name it. Words stand in the catalogues of the languages,
    /// under the keys in braces.
    pub lines: &'static [(&'static str, &'static str)],
}

impl Listing {
    /// The text of a line, counted from 0.
    pub fn text(&self, number: usize, language: Language) -> String {
        let mut rest = self.lines[number].1;
        let mut text = String::new();
        while let Some((before, (key, after))) = rest
            .split_once('{')
            .and_then(|(before, after)| Some((before, after.split_once('}')?)))
        {
            text += before;
            text += Message(key).text(language);
            rest = after;
        }
        text + rest
    }

    /// The line of that label.
    pub fn labelled(&'static self, label: &str) -> Option<Line> {
        let has = |labels: &str| labels.split(' ').any(|own| own == label);
        let number = self.lines.iter().position(|(labels, _)| has(labels))?;
        Some(Line {
            listing: self,
            number,
        })
    }

    /// The line of that label, which the listing must have.
    pub fn line(&'static self, label: &str) -> Line {
        self.labelled(label)
            .unwrap_or_else(|| panic!("the listing {} has no line {label}", self.name))
    }
}

/// A line of a listing, counted from 0.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Line {
    pub listing: &'static Listing,
    pub number: usize,
}

/// A value of an event.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Value {
    Number(f64),
    Integer(i64),
    Rgb(Rgb),
    Vector(DVec3),
    Truth(bool),
    Word(&'static str),
}

/// A value with its name. Names are ASCII, with `_` before a subscript (`I_4`, `x_P`, `k_d`).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Field {
    pub name: &'static str,
    pub value: Value,
}

/// Named values, in the order in which they were pushed.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Fields(pub Vec<Field>);

impl Fields {
    pub fn push(&mut self, name: &'static str, value: impl Into<Value>) -> &mut Self {
        self.0.push(Field {
            name,
            value: value.into(),
        });
        self
    }

    /// The value pushed last under `name`: that of an inner scope goes before that of an outer one.
    pub fn get(&self, name: &str) -> Option<Value> {
        self.0
            .iter()
            .rev()
            .find(|field| field.name == name)
            .map(|field| field.value)
    }

    pub fn iter(&self) -> impl Iterator<Item = &Field> {
        self.0.iter()
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Value::Number(number)
    }
}
impl From<u32> for Value {
    fn from(integer: u32) -> Self {
        Value::Integer(integer.into())
    }
}
impl From<u16> for Value {
    fn from(integer: u16) -> Self {
        Value::Integer(integer.into())
    }
}
impl From<i32> for Value {
    fn from(integer: i32) -> Self {
        Value::Integer(integer.into())
    }
}
impl From<Rgb> for Value {
    fn from(color: Rgb) -> Self {
        Value::Rgb(color)
    }
}
impl From<DVec3> for Value {
    fn from(vector: DVec3) -> Self {
        Value::Vector(vector)
    }
}
impl From<bool> for Value {
    fn from(truth: bool) -> Self {
        Value::Truth(truth)
    }
}
impl From<&'static str> for Value {
    fn from(word: &'static str) -> Self {
        Value::Word(word)
    }
}
