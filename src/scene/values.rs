//! The kinds of values in scene files, each with the words that name it in a message.

use serde::Deserialize;
use serde::de::{Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use std::collections::HashSet;
use std::fmt;
use std::marker::PhantomData;

/// A finite number.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number(pub f64);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct AnyNumber;
        impl Visitor<'_> for AnyNumber {
            type Value = Number;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a number")
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Number, E> {
                Ok(Number(value))
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Number, E> {
                Ok(Number(value as f64))
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Number, E> {
                Ok(Number(value as f64))
            }
        }
        deserializer.deserialize_any(AnyNumber)
    }
}

/// A number of things.
#[derive(Clone, Copy, Debug)]
pub(super) struct Count(pub u64);

impl<'de> Deserialize<'de> for Count {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Whole;
        impl Visitor<'_> for Whole {
            type Value = Count;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a whole number of 0 or more, written without a point")
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Count, E> {
                Ok(Count(value))
            }
        }
        deserializer.deserialize_any(Whole)
    }
}

/// Three numbers: a point, a direction, a colour.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triple(pub [f64; 3]);

impl<'de> Deserialize<'de> for Triple {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Three;
        impl<'de> Visitor<'de> for Three {
            type Value = Triple;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a list of three numbers")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Triple, A::Error> {
                exactly(list, &self).map(|numbers: [Number; 3]| Triple(numbers.map(|n| n.0)))
            }
        }
        deserializer.deserialize_any(Three)
    }
}

/// A coefficient: one number for all channels, or one a channel.
#[derive(Clone, Copy, Debug)]
pub(super) enum Coefficient {
    Grey(Number),
    Color(Triple),
}

impl<'de> Deserialize<'de> for Coefficient {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OneOrThree;
        impl<'de> Visitor<'de> for OneOrThree {
            type Value = Coefficient;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a number or a list of three numbers")
            }

            fn visit_f64<E: Error>(self, value: f64) -> Result<Coefficient, E> {
                Ok(Coefficient::Grey(Number(value)))
            }

            fn visit_i64<E: Error>(self, value: i64) -> Result<Coefficient, E> {
                self.visit_f64(value as f64)
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<Coefficient, E> {
                self.visit_f64(value as f64)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Coefficient, A::Error> {
                exactly(list, &self)
                    .map(|numbers: [Number; 3]| Coefficient::Color(Triple(numbers.map(|n| n.0))))
            }
        }
        deserializer.deserialize_any(OneOrThree)
    }
}

/// Into how many patches an object is divided.
#[derive(Clone, Copy, Debug)]
pub(super) enum PatchCounts {
    Each(u64),
    Grid([u64; 2]),
}

impl<'de> Deserialize<'de> for PatchCounts {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct OneOrTwo;
        impl<'de> Visitor<'de> for OneOrTwo {
            type Value = PatchCounts;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a whole number, or a list of two whole numbers")
            }

            fn visit_u64<E: Error>(self, value: u64) -> Result<PatchCounts, E> {
                Ok(PatchCounts::Each(value))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<PatchCounts, A::Error> {
                exactly(list, &self)
                    .map(|counts: [Count; 2]| PatchCounts::Grid(counts.map(|n| n.0)))
            }
        }
        deserializer.deserialize_any(OneOrTwo)
    }
}

/// `N` elements, not one fewer or more.
fn exactly<'de, A: SeqAccess<'de>, T: Deserialize<'de> + Copy, const N: usize>(
    mut list: A,
    expected: &dyn serde::de::Expected,
) -> Result<[T; N], A::Error> {
    let mut elements = Vec::with_capacity(N);
    while elements.len() < N {
        match list.next_element()? {
            Some(element) => elements.push(element),
            None => return Err(A::Error::invalid_length(elements.len(), expected)),
        }
    }
    let mut length = N;
    while list.next_element::<IgnoredAny>()?.is_some() {
        length += 1;
    }
    match <[T; N]>::try_from(elements) {
        Ok(elements) if length == N => Ok(elements),
        _ => Err(A::Error::invalid_length(length, expected)),
    }
}

/// Values under names of the author's choice, in the order of the file, each name once.
#[derive(Clone, Debug)]
pub struct ByName<T>(pub Vec<(String, T)>);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for ByName<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Names<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Names<T> {
            type Value = ByName<T>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object { \"name\": …, … }")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<ByName<T>, A::Error> {
                let mut taken = HashSet::new();
                let mut entries = Vec::new();
                while let Some(name) = map.next_key::<String>()? {
                    if !taken.insert(name.clone()) {
                        return Err(A::Error::custom(format!(
                            "the name {name:?} is given twice; each may stand once"
                        )));
                    }
                    entries.push((name, map.next_value()?));
                }
                Ok(ByName(entries))
            }
        }
        deserializer.deserialize_map(Names(PhantomData))
    }
}
