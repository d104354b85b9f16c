//! Options and values that several commands share.

use super::failure::Failure;
use super::notes;
use crate::algorithms::primary::Settings;
use crate::language::Language;
use crate::methods::Method;
use crate::panels::Panel;
use crate::picture::Theme;
use crate::scene::Note;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use std::fmt::Display;
use std::num::NonZeroU32;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// How large a scene may be.
#[derive(Args, Clone, Copy)]
pub struct LimitArguments {
    /// The most radiosity patches that a scene may ask for
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = parse_whole::<u64>, default_value_t = crate::scene::Limits::default().max_patches)]
    pub max_patches: u64,
    /// The most triangles that its meshes may have
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = parse_whole::<u64>, default_value_t = crate::scene::Limits::default().max_triangles)]
    pub max_triangles: u64,
}

/// How far the ray methods go.
#[derive(Args, Clone, Copy)]
pub struct RayArguments {
    /// Ray tracing shades rays up to this level; the primary ray is level 1
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = |text: &str| parse_within(text, 1..=Settings::DEEPEST))]
    pub depth: Option<u32>,
    /// A pixel is the mean of N×N rays
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = |text: &str| parse_within(text, 1..=Settings::MOST_SAMPLES))]
    pub samples: Option<u32>,
}

impl RayArguments {
    /// The options given, and for the rest those of `unless`.
    pub fn or(self, unless: Settings) -> Settings {
        Settings {
            depth: self.depth.and_then(NonZeroU32::new).unwrap_or(unless.depth),
            samples: self
                .samples
                .and_then(NonZeroU32::new)
                .unwrap_or(unless.samples),
        }
    }

    pub fn is_given(self) -> bool {
        self.depth.is_some() || self.samples.is_some()
    }

    /// Notes on the options given that `method` has no use for.
    pub fn notes(self, method: Method) -> Vec<Note> {
        let depth = self.depth.map(|_| "--depth");
        let samples = self.samples.map(|_| "--samples");
        let is_sampled = |method: Method| !method.converts_polygons();
        [
            notes::without_effect(depth, method, |method| method == Method::RayTracing),
            notes::without_effect(samples, method, is_sampled),
        ]
        .concat()
    }
}

impl From<LimitArguments> for crate::scene::Limits {
    fn from(arguments: LimitArguments) -> Self {
        crate::scene::Limits {
            max_patches: arguments.max_patches,
            max_triangles: arguments.max_triangles,
        }
    }
}

/// A whole number, of what is counted from 0.
pub fn parse_whole<T: FromStr>(text: &str) -> Result<T, String> {
    let number = text.parse();
    number.map_err(|_| "allowed are whole numbers of 0 or more".into())
}

/// A whole number of a range.
pub fn parse_within<T: FromStr + PartialOrd + Display>(
    text: &str,
    range: RangeInclusive<T>,
) -> Result<T, String> {
    let number = text.parse().ok().filter(|number| range.contains(number));
    number.ok_or_else(|| {
        let (least, most) = range.into_inner();
        format!("allowed are whole numbers from {least} to {most}")
    })
}

pub fn parse_number(text: &str) -> Result<f64, String> {
    let number = text.parse();
    number.map_err(|_| "allowed are numbers, such as 0.5 or 1e-6".into())
}

/// `640x480`
pub fn parse_size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once(['x', 'X', '×'])
        .and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    let Some([width, height]) = sides else {
        return Err("a size is written as 640x480".into());
    };
    let pixels = u64::from(width) * u64::from(height);
    if width == 0
        || height == 0
        || width > crate::render::MAX_SIDE
        || height > crate::render::MAX_SIDE
        || pixels > crate::render::MAX_PIXELS
    {
        return Err(format!(
            "a picture has sides from 1 to {} and at most {} pixels",
            crate::render::MAX_SIDE,
            crate::render::MAX_PIXELS
        ));
    }
    Ok([width, height])
}

/// `3..10`: from 3 up to, but without, 10.
pub fn parse_range(text: &str) -> Result<std::ops::Range<usize>, String> {
    let ends = text
        .split_once("..")
        .and_then(|(start, end)| Some((start.parse().ok()?, end.parse().ok()?)));
    match ends {
        Some((start, end)) if start < end => Ok(start..end),
        Some(_) => Err("the range is empty; A..B includes A and excludes B".into()),
        None => Err("a range is written as 3..10; it counts from 0".into()),
    }
}

/// Pixels to a point.
pub fn parse_scale(text: &str) -> Result<f32, String> {
    let scale = text
        .parse()
        .ok()
        .filter(|scale| (1.0..=4.0).contains(scale));
    scale.ok_or_else(|| "allowed are numbers from 1 to 4".into())
}

pub fn panel_names() -> PossibleValuesParser {
    Panel::ALL.map(Panel::name).into()
}

pub fn theme_names() -> PossibleValuesParser {
    Theme::ALL.map(Theme::name).into()
}

/// A language by its code.
pub fn languages() -> impl TypedValueParser<Value = Language> {
    let codes: PossibleValuesParser = Language::ALL.map(Language::code).into();
    codes.map(|code| Language::of_tag(&code).unwrap_or_default())
}

pub fn method_names() -> PossibleValuesParser {
    Method::ALL.map(Method::name).into()
}

pub fn method(name: &str) -> Result<Method, Failure> {
    Method::from_name(name)
        .ok_or_else(|| Failure::Wrong(format!("--method {name}: there is no such method")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_ranges_are_read_strictly() {
        assert_eq!(parse_size("640x480"), Ok([640, 480]));
        for wrong in [
            "",
            "640",
            "0x5",
            "-1x5",
            "1e9x1",
            "8193x8193",
            "99999999999x1",
            "4294967295x4294967295",
        ] {
            assert!(parse_size(wrong).is_err(), "{wrong}");
        }
        assert_eq!(parse_range("0..3"), Ok(0..3));
        for wrong in ["", "3", "3..3", "4..3", "..", "a..b", "-1..2"] {
            assert!(parse_range(wrong).is_err(), "{wrong}");
        }
    }
}
