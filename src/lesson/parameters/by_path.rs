//! Parameters by the path of their value in the lesson's document: of its scene, or of the settings of its method.
//!
//! A changed document is read and checked again as a whole, so that a value can do no more than one that is written in the file.

use super::super::error::{LessonError, problem};
use super::super::text::Text;
use crate::scene::Limits;
use crate::scene::document::{Keyed, present};
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use std::ops::RangeInclusive;

/// A number as a parameter, as it is written in a lesson file.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct NumberFile {
    /// Of a number, or of a colour, whose largest channel it is; either this or `places`.
    #[serde(default, deserialize_with = "present")]
    pub path: Option<String>,
    /// Several numbers that follow from this one.
    #[serde(default, deserialize_with = "present")]
    pub places: Option<Vec<Keyed<PlaceFile>>>,
    pub name: Text,
    pub from: f64,
    pub to: f64,
    /// Steps of whole numbers.
    #[serde(default, deserialize_with = "present")]
    pub whole: Option<bool>,
    /// Equal ratios at equal distances on the slider.
    #[serde(default, deserialize_with = "present")]
    pub logarithmic: Option<bool>,
    #[serde(default, deserialize_with = "present")]
    pub unit: Option<Text>,
}

/// A number of the document that is `times` the parameter `plus` something.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlaceFile {
    pub path: String,
    #[serde(default, deserialize_with = "present")]
    pub times: Option<f64>,
    #[serde(default, deserialize_with = "present")]
    pub plus: Option<f64>,
}

/// One of several values as a parameter.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ChoiceFile {
    pub path: String,
    pub name: Text,
    pub options: Vec<Keyed<ValueFile>>,
}

#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ValueFile {
    pub value: Value,
    pub name: Text,
}

/// A value of the document that may be changed.
#[derive(Clone, Debug)]
pub struct ByPath {
    places: Vec<Place>,
    pub name: Text,
    pub kind: Kind,
    /// The lesson's own value.
    pub value: PathValue,
}

/// Where a parameter stands in the document, and what it is there.
#[derive(Clone, Debug)]
struct Place {
    path: Path,
    times: f64,
    plus: f64,
    /// The lesson's own value.
    own: Value,
}

impl Place {
    /// A number there; of a colour, whose channels keep their ratios, the largest channel.
    fn written(&self, number: f64, whole: bool) -> Value {
        let number = self.times * number + self.plus;
        let one = |number: f64| match whole {
            true => Value::from(number.round() as i64),
            false => Value::from(number),
        };
        let Some(channels) = channels(&self.own) else {
            return one(number);
        };
        let largest = largest(&channels);
        let scaled = |channel: f64| match largest > 0.0 {
            true => channel * (number / largest),
            false => number,
        };
        Value::from_iter(channels.into_iter().map(|channel| one(scaled(channel))))
    }

    /// The parameter that has the lesson's own value there; none where that is no number.
    fn parameter(&self) -> Option<f64> {
        let number = match channels(&self.own) {
            Some(channels) => largest(&channels),
            None => self.own.as_f64()?,
        };
        Some((number - self.plus) / self.times)
    }
}

/// The numbers of a list of nothing else.
fn channels(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}

fn largest(channels: &[f64]) -> f64 {
    channels.iter().copied().fold(0.0, f64::max)
}

#[derive(Clone, Debug)]
pub enum Kind {
    Number {
        range: RangeInclusive<f64>,
        whole: bool,
        logarithmic: bool,
        unit: Option<Text>,
    },
    /// Values with their names.
    Choice(Vec<(Value, Text)>),
}

/// A value of such a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathValue {
    Number(f64),
    /// By its index among the options.
    Option(usize),
}

impl ByPath {
    /// As at a place in the document; none where the parameter does not have such a value.
    fn written(&self, place: &Place, value: PathValue) -> Option<Value> {
        match (&self.kind, value) {
            (Kind::Number { range, whole, .. }, PathValue::Number(number)) => {
                let fits = range.contains(&number);
                fits.then(|| place.written(number, *whole))
            }
            (Kind::Choice(options), PathValue::Option(index)) => {
                options.get(index).map(|(value, _)| value.clone())
            }
            _ => None,
        }
    }

    /// Values all over its range, both ends among them; all options.
    pub fn sampled(&self) -> Vec<PathValue> {
        match &self.kind {
            Kind::Choice(options) => (0..options.len()).map(PathValue::Option).collect(),
            Kind::Number {
                range,
                whole,
                logarithmic,
                ..
            } => {
                let (from, to) = (*range.start(), *range.end());
                let shares = [0.0, 0.15, 0.4, 0.7, 1.0].into_iter();
                let mut values: Vec<f64> = shares
                    .map(|share| match logarithmic {
                        _ if share == 1.0 => to,
                        true => from * (to / from).powf(share),
                        false => from + share * (to - from),
                    })
                    .map(|value| if *whole { value.round() } else { value })
                    .collect();
                values.dedup();
                values.into_iter().map(PathValue::Number).collect()
            }
        }
    }
}

/// Keys and indices, as in `objects[2].material`.
#[derive(Clone, Debug, PartialEq)]
struct Path(Vec<Segment>);

#[derive(Clone, Debug, PartialEq)]
enum Segment {
    Key(String),
    Index(usize),
}

impl Path {
    /// None where the text is no path.
    fn parse(text: &str) -> Option<Self> {
        let mut segments = Vec::new();
        for part in text.split('.') {
            let mut pieces = part.split('[');
            let key = pieces.next().filter(|key| !key.is_empty())?;
            segments.push(Segment::Key(key.to_owned()));
            for index in pieces {
                let index = index.strip_suffix(']')?.parse().ok()?;
                segments.push(Segment::Index(index));
            }
        }
        Some(Path(segments))
    }

    fn find<'a>(&self, document: &'a mut Value) -> Option<&'a mut Value> {
        self.0
            .iter()
            .try_fold(document, |value, segment| match segment {
                Segment::Key(key) => value.get_mut(key),
                Segment::Index(index) => value.get_mut(index),
            })
    }
}

/// A lesson's document, with the files that belong to it.
#[derive(Clone, Debug)]
pub struct Source {
    document: Value,
    files: Vec<(String, Vec<u8>)>,
    pub limits: Limits,
}

impl Source {
    /// `files` are those that were read for the document.
    pub fn new(bytes: &[u8], mut files: Vec<(String, Vec<u8>)>, limits: &Limits) -> Option<Self> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut document: Value = serde_json::from_slice(bytes).ok()?;
        let keys = document.as_object_mut()?;
        // What reads the changed document has no parameters of its own to find.
        keys.remove("parameters");
        if let Some(Value::String(path)) = keys.remove("scene_file") {
            // The paths of a scene begin in its folder.
            let folder = path
                .rsplit_once('/')
                .map_or(0, |(folder, _)| folder.len() + 1);
            let (_, scene) = files.iter().find(|(name, _)| *name == path)?;
            keys.insert("scene".into(), serde_json::from_slice(scene).ok()?);
            files.retain(|(name, _)| *name != path);
            for (name, _) in &mut files {
                name.drain(..folder.min(name.len()));
            }
        }
        Some(Source {
            document,
            files,
            limits: *limits,
        })
    }

    /// The document with other values. Errors: a value that is out of its range.
    pub fn with<'a>(
        &self,
        values: impl Iterator<Item = (&'a ByPath, PathValue)>,
    ) -> Result<Vec<u8>, LessonError> {
        let mut document = self.document.clone();
        for (parameter, value) in values {
            for place in &parameter.places {
                let written = parameter.written(place, value);
                match (place.path.find(&mut document), written) {
                    (Some(found), Some(written)) => *found = written,
                    _ => return Err(problem("parameters", "found a value out of its range").into()),
                }
            }
        }
        Ok(serde_json::to_vec(&document).expect("a document is written as text"))
    }

    /// A file that belongs to it. Errors: it was not read with the lesson.
    pub fn file(&self, path: &str) -> Result<Vec<u8>, String> {
        let file = self.files.iter().find(|(name, _)| name == path);
        file.map(|(_, bytes)| bytes.clone())
            .ok_or_else(|| format!("{path} was not read with the lesson"))
    }
}

/// A number that the document gives. Errors: what is wrong with it.
pub fn number(file: &NumberFile, source: &Source) -> Result<ByPath, String> {
    let places = match (&file.path, &file.places) {
        (Some(path), None) => vec![given(path, source)?],
        (None, Some(files)) if !files.is_empty() => {
            let place = |Keyed(file): &Keyed<PlaceFile>| {
                let times = file.times.unwrap_or(1.0);
                if times == 0.0 {
                    return Err("found `times` 0; then the parameter would change nothing".into());
                }
                Ok(Place {
                    times,
                    plus: file.plus.unwrap_or(0.0),
                    ..given(&file.path, source)?
                })
            };
            files.iter().map(place).collect::<Result<_, String>>()?
        }
        _ => return Err("a number has exactly one of the keys `path` and `places`".into()),
    };
    let (from, to) = (file.from, file.to);
    let number = places[0]
        .parameter()
        .ok_or_else(|| format!("found {}, where a `number` changes a number", places[0].own))?;
    let logarithmic = file.logarithmic.unwrap_or(false);
    if from.partial_cmp(&to) != Some(std::cmp::Ordering::Less) || logarithmic && from <= 0.0 {
        return Err(format!(
            "found a range from {from} to {to}; it begins below its end, and above 0 where it is logarithmic"
        ));
    }
    if !(from..=to).contains(&number) {
        return Err(format!(
            "found a range from {from} to {to}, in which the lesson's own value {number} does not lie"
        ));
    }
    Ok(ByPath {
        places,
        name: file.name.clone(),
        kind: Kind::Number {
            range: from..=to,
            whole: file.whole.unwrap_or(false),
            logarithmic,
            unit: file.unit.clone(),
        },
        value: PathValue::Number(number),
    })
}

/// A value of the document among several. Errors: what is wrong with it.
pub fn choice(file: &ChoiceFile, source: &Source) -> Result<ByPath, String> {
    let place = given(&file.path, source)?;
    let mut options = file.options.iter();
    let own = options.position(|Keyed(option)| option.value == place.own);
    let own = own.ok_or_else(|| {
        format!(
            "`{}` is {}, which is none of the options",
            file.path, place.own
        )
    })?;
    let options = file.options.iter();
    let options = options.map(|Keyed(option)| (option.value.clone(), option.name.clone()));
    Ok(ByPath {
        places: vec![place],
        name: file.name.clone(),
        kind: Kind::Choice(options.collect()),
        value: PathValue::Option(own),
    })
}

/// The place of that path, which the document gives a value.
fn given(text: &str, source: &Source) -> Result<Place, String> {
    let path = Path::parse(text).ok_or_else(|| {
        format!("found the path \"{text}\"; a path is written like scene.objects[2].sphere.radius")
    })?;
    let mut document = source.document.clone();
    let found = path.find(&mut document).map(|value| value.clone());
    let found = found.ok_or_else(|| {
        format!("the lesson gives no value at `{text}`; write one there to change it")
    })?;
    Ok(Place {
        path,
        times: 1.0,
        plus: 0.0,
        own: found,
    })
}

#[cfg(test)]
mod tests;
