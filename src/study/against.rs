//! A picture of another program against the reference: how far off it is, and which classic mistakes explain the difference.

mod explained;

use super::mistakes::{Encoding, Workers};
use crate::algorithms::frame::Frame;
use crate::color::{Rgb, StoredImage};
use crate::figure::diverging;
use crate::methods::{Method, Mistake, Setup};
use crate::render::{Cancelled, render_unless};
use explained::{Mistaken, explanations};
use serde::Serialize;
use std::num::NonZeroUsize;

/// Pixels that are named as the worst.
const WORST: usize = 5;

/// What was found. Differences are in the numbers of the file, from 0 to 1 where those are integers.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    pub size: [u32; 2],
    /// `linear` or `srgb`: as the format of the file says, unless the first mistake explains most of the difference, and is one of
    /// the encoding.
    pub encoding: &'static str,
    /// The largest difference of a channel.
    pub largest: f64,
    /// Over all channels.
    pub rms: f64,
    /// How many pixels have a channel that is off by more than the tolerance.
    pub off: usize,
    pub pixels: usize,
    /// The worst first.
    pub worst: Vec<Worst>,
    /// The one that explains most first, then the one that explains most of what is left, and so on.
    pub mistakes: Vec<Explanation>,
    #[serde(skip)]
    pub reference: Vec<[f64; 3]>,
}

#[derive(Clone, Debug, Serialize)]
pub struct Worst {
    pub x: u32,
    pub y: u32,
    pub mine: [f64; 3],
    pub reference: [f64; 3],
}

/// A mistake that would make the picture what it is, at some of its pixels.
#[derive(Clone, Debug, Serialize)]
pub struct Explanation {
    pub name: &'static str,
    #[serde(skip)]
    pub mistake: Mistake,
    /// How many of the differing pixels are then as in the reference with the mistake.
    pub explains: usize,
    pub of: usize,
    pub rms_after: f64,
}

/// Compares a picture, of the size of the set-up's view, with what `method` draws of it.
///
/// `progress` is called with the pictures done and the pictures in all, the right one and one a mistake; an error of it ends the work. `first` takes what is known before the mistakes are tried.
pub fn compare<E: Send>(
    mine: &StoredImage,
    setup: &Setup,
    method: Method,
    tolerance: f64,
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) -> Result<(), E> + Sync),
    first: impl FnOnce(&Comparison),
) -> Result<Comparison, E> {
    let frame = render_unless(setup, method, threads, |_, _| progress(0, 1))?;
    // Integers are for the screen, floats are light.
    let right = match mine.is_float {
        true => Encoding::Linear,
        false => Encoding::Srgb,
    };
    let reference = encoded(&frame, right, mine.is_float);
    let mut found = Comparison::of(mine, reference, right, tolerance);
    first(&found);
    if found.off > 0 {
        let stored = (right, mine.is_float);
        let progress = |done, all| progress(1 + done, 1 + all);
        let mistaken = mistaken(setup, method, &frame, stored, threads, &progress)?;
        found.mistakes = explanations(mine, tolerance, &found.reference, &mistaken);
        let best = found.mistakes.first();
        let best = best.filter(|best| 2 * best.explains > found.off);
        found.encoding = match best.map(|best| best.mistake) {
            Some(Mistake::NoSrgb) => Encoding::Linear.name(),
            Some(Mistake::SrgbTwice) => Encoding::Srgb.name(),
            _ => right.name(),
        };
    }
    Ok(found)
}

impl Comparison {
    /// Of a picture with ours as a file would have it, before any mistake is tried.
    fn of(
        mine: &StoredImage,
        reference: Vec<[f64; 3]>,
        right: Encoding,
        tolerance: f64,
    ) -> Comparison {
        let differs = differing(&mine.pixels, &reference, tolerance);
        let mut worst: Vec<usize> = (0..mine.pixels.len()).filter(|&at| differs[at]).collect();
        let by = |at: &usize| distance(mine.pixels[*at], reference[*at]);
        worst.sort_by(|a, b| by(b).total_cmp(&by(a)));
        let off = worst.len();
        let all = 0..mine.pixels.len();
        Comparison {
            size: [mine.width, mine.height],
            encoding: right.name(),
            largest: all.map(|at| by(&at)).fold(0.0, f64::max),
            rms: rms(&mine.pixels, &reference),
            off,
            pixels: mine.pixels.len(),
            worst: worst
                .into_iter()
                .take(WORST)
                .map(|at| Worst {
                    x: at as u32 % mine.width,
                    y: at as u32 / mine.width,
                    mine: mine.pixels[at],
                    reference: reference[at],
                })
                .collect(),
            mistakes: Vec::new(),
            reference,
        }
    }
}

/// The picture that a program with the mistake would store in 8 bits, and how it differs from `frame`, which is the right one. None where
/// no pixel is off by more than the tolerance, or the picture is called off.
pub fn with_mistake(
    mistake: Mistake,
    (setup, method): (&Setup, Method),
    frame: &Frame,
    tolerance: f64,
    workers: Workers,
) -> Option<(StoredImage, Comparison)> {
    let right = Encoding::Srgb;
    let (wrong, encoding) = mistake.picture(setup, method, frame, right, workers)?;
    let mine = StoredImage {
        width: frame.width,
        height: frame.rows.len() as u32,
        pixels: encoded(&wrong, encoding, false),
        is_float: false,
    };
    let found = Comparison::of(&mine, encoded(frame, right, false), right, tolerance);
    (found.off > 0).then_some((mine, found))
}

/// What the file would have with each mistake that a program can make by that method, and that changes the picture.
fn mistaken<E>(
    setup: &Setup,
    method: Method,
    frame: &Frame,
    (right, is_float): (Encoding, bool),
    threads: NonZeroUsize,
    progress: &(impl Fn(usize, usize) -> Result<(), E> + Sync),
) -> Result<Vec<Mistaken>, E> {
    let possible = Mistake::ALL.into_iter();
    let possible: Vec<Mistake> = possible
        .filter(|mistake| mistake.concerns(method))
        .collect();
    let mut mistaken = Vec::new();
    for (done, &mistake) in possible.iter().enumerate() {
        let heard = || progress(done, possible.len());
        heard()?;
        let go_on = || heard().map_err(|_| Cancelled);
        let workers = Workers {
            threads,
            go_on: &go_on,
        };
        let wrong = mistake.picture(setup, method, frame, right, workers);
        heard()?;
        mistaken
            .extend(wrong.map(|(wrong, encoding)| (mistake, encoded(&wrong, encoding, is_float))));
    }
    Ok(mistaken)
}

/// The numbers that a file would have; integers are rounded to 8 bits.
fn encoded(frame: &Frame, encoding: Encoding, is_float: bool) -> Vec<[f64; 3]> {
    let byte = |byte: u8| f64::from(byte) / 255.0;
    let one = |color: &Rgb| match (encoding, is_float) {
        (Encoding::Linear, true) => color.channels(),
        (Encoding::Linear, false) => color
            .channels()
            .map(|channel| byte((255.0 * channel.clamp(0.0, 1.0)).round() as u8)),
        (Encoding::Srgb, _) => color.to_srgb8().map(byte),
        (Encoding::SrgbTwice, _) => Rgb::from(color.to_srgb8().map(byte)).to_srgb8().map(byte),
    };
    frame.color.iter().map(one).collect()
}

/// Pixels as they look on the screen: integers as they are, light encoded.
pub fn screen_pixels(pixels: &[[f64; 3]], is_float: bool) -> Vec<[u8; 3]> {
    let byte = |channel: f64| (255.0 * channel.clamp(0.0, 1.0)).round() as u8;
    let one = |pixel: &[f64; 3]| match is_float {
        true => Rgb::from(*pixel).to_srgb8(),
        false => pixel.map(byte),
    };
    pixels.iter().map(one).collect()
}

/// The signed difference of the channels' mean from the reference as a picture: orange where yours is brighter, blue where darker.
pub fn difference(mine: &[[f64; 3]], found: &Comparison) -> Vec<[u8; 3]> {
    let largest = found.largest.max(f64::MIN_POSITIVE);
    let mean = |pixel: &[f64; 3]| pixel.iter().sum::<f64>() / 3.0;
    let pairs = mine.iter().zip(&found.reference);
    pairs
        .map(|(mine, reference)| diverging((mean(mine) - mean(reference)) / largest).to_srgb8())
        .collect()
}

/// The largest difference of a channel.
fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

/// Where a channel is differs by more; half a thousandth of the tolerance is rounding.
fn differing(mine: &[[f64; 3]], reference: &[[f64; 3]], tolerance: f64) -> Vec<bool> {
    let differs = |(&a, &b): (&[f64; 3], &[f64; 3])| distance(a, b) > tolerance * 1.0005;
    mine.iter().zip(reference).map(differs).collect()
}

fn rms(mine: &[[f64; 3]], reference: &[[f64; 3]]) -> f64 {
    let squares = mine
        .iter()
        .zip(reference)
        .flat_map(|(a, b)| (0..3).map(move |c| (a[c] - b[c]).powi(2)));
    let count = 3 * mine.len().max(1);
    (squares.sum::<f64>() / count as f64).sqrt()
}

#[cfg(test)]
mod tests;
