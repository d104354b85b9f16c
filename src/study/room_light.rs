//! The radiosities of another program against ours: the first patch that differs, and what the whole looks like.

use super::mistakes::gathered_with;
use super::numbers::rows;
use crate::algorithms::enclosure::Enclosure;
use crate::color::Rgb;
use crate::methods::Mistake;
use serde::Serialize;
use std::f64::consts::PI;

/// What radiosities are instead of B, for all patches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RadiosityForm {
    /// E alone.
    EmissionOnly,
    /// B − E.
    EmissionForgotten,
    /// What was gathered once: E + ρ·Σ F_ij·E_j.
    GatheredOnce,
    /// (B − E)/ρ, which arrives.
    Arriving,
    /// B/π, which is radiance.
    OverPi,
    /// π·B.
    TimesPi,
    /// A·B, which is power.
    TimesArea,
    /// Red and blue changed places.
    ChannelsSwapped,
    /// What satisfies the equation with F_ji for F_ij, without ρ, or with F/π.
    FormFactorTransposed,
    ReflectanceForgotten,
    PiTwice,
}

impl RadiosityForm {
    const ALL: [RadiosityForm; 11] = [
        RadiosityForm::EmissionOnly,
        RadiosityForm::EmissionForgotten,
        RadiosityForm::GatheredOnce,
        RadiosityForm::Arriving,
        RadiosityForm::OverPi,
        RadiosityForm::TimesPi,
        RadiosityForm::TimesArea,
        RadiosityForm::ChannelsSwapped,
        RadiosityForm::FormFactorTransposed,
        RadiosityForm::ReflectanceForgotten,
        RadiosityForm::PiTwice,
    ];

    pub fn in_words(self) -> &'static str {
        match self {
            RadiosityForm::EmissionOnly => "it is E: no light was exchanged",
            RadiosityForm::EmissionForgotten => "it is B − E: what a patch emits itself is missing",
            RadiosityForm::GatheredOnce => {
                "it is E + ρ·Σ F_ij·E_j: light was gathered once; go on until nothing changes"
            }
            RadiosityForm::Arriving => {
                "it is (B − E)/ρ, the light that arrives: B = E + ρ times that"
            }
            RadiosityForm::OverPi => "it is B/π, the radiance: B itself is asked for",
            RadiosityForm::TimesPi => {
                "it is π·B: the form factors lack their division by π, or B was a radiance"
            }
            RadiosityForm::TimesArea => "it is A·B, the power: divide by the area of the patch",
            RadiosityForm::ChannelsSwapped => "red and blue changed places",
            RadiosityForm::FormFactorTransposed => {
                "it solves B_i = E_i + ρ_i·Σ F_ji·B_j: F_ji stands at the place of F_ij"
            }
            RadiosityForm::ReflectanceForgotten => {
                "it solves B_i = E_i + Σ F_ij·B_j: ρ_i is missing"
            }
            RadiosityForm::PiTwice => {
                "it solves B_i = E_i + ρ_i·Σ F_ij·B_j/π: F is divided by π already"
            }
        }
    }

    /// What a patch would have if all were like this; of the wrong equations, their right side with `mine` in it.
    fn light(self, enclosure: &Enclosure, matrix: &[f64], ours: &[Rgb], mine: &[Rgb]) -> Vec<Rgb> {
        let each = |of: &dyn Fn(usize) -> Rgb| (0..ours.len()).map(of).collect();
        let emission = &enclosure.emission;
        let reflected = |i: usize| ours[i] - emission[i];
        match self {
            RadiosityForm::EmissionOnly => emission.clone(),
            RadiosityForm::EmissionForgotten => each(&reflected),
            RadiosityForm::GatheredOnce => gathered_with(None, enclosure, matrix, emission),
            RadiosityForm::Arriving => each(&|i| {
                let (b, rho) = (reflected(i).channels(), enclosure.reflectance[i].channels());
                Rgb::from([0, 1, 2].map(|c| if rho[c] > 0.0 { b[c] / rho[c] } else { 0.0 }))
            }),
            RadiosityForm::OverPi => each(&|i| ours[i] / PI),
            RadiosityForm::TimesPi => each(&|i| ours[i] * PI),
            RadiosityForm::TimesArea => each(&|i| ours[i] * enclosure.patches[i].area),
            RadiosityForm::ChannelsSwapped => each(&|i| Rgb::new(ours[i].b, ours[i].g, ours[i].r)),
            RadiosityForm::FormFactorTransposed
            | RadiosityForm::ReflectanceForgotten
            | RadiosityForm::PiTwice => {
                let mistake = match self {
                    RadiosityForm::FormFactorTransposed => Mistake::FormFactorTransposed,
                    RadiosityForm::ReflectanceForgotten => Mistake::ReflectanceForgotten,
                    _ => Mistake::PiTwice,
                };
                gathered_with(Some(mistake), enclosure, matrix, mine)
            }
        }
    }
}

/// A patch that differs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Patch {
    pub patch: usize,
    pub mine: [f64; 3],
    pub reference: [f64; 3],
}

#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LightComparison {
    pub patches: usize,
    /// Patches with a channel that is off by more than the tolerance.
    pub off: usize,
    pub first: Option<Patch>,
    /// The largest difference, relative to the largest radiosity.
    pub largest: f64,
    pub looks: Option<RadiosityForm>,
}

/// Compares the radiosities of all patches. The tolerance is relative to the largest of ours.
pub fn compare(
    mine: &[Rgb],
    ours: &[Rgb],
    enclosure: &Enclosure,
    matrix: &[f64],
    tolerance: f64,
) -> LightComparison {
    let whole = largest(ours.iter().map(|patch| patch.channels()));
    let whole = whole.max(f64::MIN_POSITIVE);
    let distance = |a: Rgb, b: Rgb| largest([(a - b).channels()]) / whole;
    let differs = |&patch: &usize| distance(mine[patch], ours[patch]) > tolerance;
    let off = (0..ours.len()).filter(differs).count();
    let first = (0..ours.len()).find(differs).map(|patch| Patch {
        patch,
        mine: mine[patch].channels(),
        reference: ours[patch].channels(),
    });
    let is = |looks: &RadiosityForm| {
        let light = looks.light(enclosure, matrix, ours, mine);
        let mut pairs = mine.iter().zip(&light);
        pairs.all(|(&mine, &light)| distance(mine, light) <= tolerance)
    };
    let pairs = mine.iter().zip(ours);
    LightComparison {
        patches: ours.len(),
        off,
        first,
        largest: pairs.map(|(&a, &b)| distance(a, b)).fold(0.0, f64::max),
        looks: RadiosityForm::ALL
            .into_iter()
            .find(|looks| off > 0 && is(looks)),
    }
}

fn largest(channels: impl IntoIterator<Item = [f64; 3]>) -> f64 {
    let channels = channels.into_iter().flatten();
    channels.map(f64::abs).fold(0.0, f64::max)
}

/// B of n patches: three numbers each, or one for all channels. Errors: what is wrong, with its row.
pub fn read(bytes: &[u8], n: usize) -> Result<Vec<Rgb>, String> {
    let rows = rows(bytes, "radiosity")?;
    if rows.len() != n {
        let found = rows.len();
        return Err(format!("it has {found} rows; the scene has {n} patches"));
    }
    let patch = |(row, numbers): (usize, Vec<f64>)| match numbers[..] {
        [gray] => Ok(Rgb::from([gray; 3])),
        [r, g, b] => Ok(Rgb::new(r, g, b)),
        _ => Err(format!(
            "row {row} has {} numbers; allowed are 1 and 3 (red, green, blue)",
            numbers.len()
        )),
    };
    rows.into_iter().enumerate().map(patch).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::enclosure::Settings;
    use crate::scene::{Limits, Parts, read as read_scene};

    /// Two parallel rectangles of unequal size and colour that light each other. Were the lamp's area 1, what F_ji gives would be A·B.
    const SQUARES: &str = r#"{ "schema": 1,
      "materials": { "lamp": { "emission": [2, 1, 0.5], "reflectance": [0.3, 0.2, 0.1] },
        "wall": { "reflectance": [0.8, 0.6, 0.4] } },
      "objects": [
        { "name": "lamp", "material": "lamp", "polygon": { "vertices": [[0, 0, 1], [0.5, 0, 1], [0.5, 0, 0], [0, 0, 0]] } },
        { "name": "wall", "material": "wall", "polygon": { "vertices": [[0, 1, 0], [2, 1, 0], [2, 1, 1], [0, 1, 1]] } } ] }"#;

    fn enclosure() -> Enclosure {
        let scene = read_scene(
            SQUARES.as_bytes(),
            &Limits::default(),
            &mut |_| unreachable!(),
        );
        Enclosure::of(&scene.unwrap(), Settings::default(), Parts::NONE).unwrap()
    }

    /// Both patches by Cramer's rule, of B_0 = E_0 + ρ_0·f_01·B_1 and B_1 = ρ_1·f_10·B_0.
    fn solved(enclosure: &Enclosure, rho: [[f64; 3]; 2], [f01, f10]: [f64; 2]) -> Vec<Rgb> {
        let emission = enclosure.emission[0].channels();
        let both = [0, 1, 2].map(|c| {
            let b0 = emission[c] / (1.0 - rho[0][c] * f01 * rho[1][c] * f10);
            (b0, rho[1][c] * f10 * b0)
        });
        vec![Rgb::from(both.map(|b| b.0)), Rgb::from(both.map(|b| b.1))]
    }

    #[test]
    fn what_radiosities_look_like_is_recognized() {
        let enclosure = enclosure();
        let matrix = enclosure.form_factors().matrix();
        let f = [matrix[1], matrix[2]];
        let rho = [0, 1].map(|patch| enclosure.reflectance[patch].channels());
        let ours = solved(&enclosure, rho, f);
        let found = |mine: &[Rgb]| compare(mine, &ours, &enclosure, &matrix, 1e-6);
        assert_eq!((found(&ours).off, found(&ours).looks), (0, None));
        let scaled = |by: f64| ours.iter().map(|&b| b * by).collect::<Vec<Rgb>>();
        let e = &enclosure.emission;
        let once = Rgb::from([0, 1, 2].map(|c| rho[1][c] * f[1] * e[0].channels()[c]));
        for (mine, looks) in [
            (e.clone(), RadiosityForm::EmissionOnly),
            (
                vec![ours[0] - e[0], ours[1]],
                RadiosityForm::EmissionForgotten,
            ),
            (vec![e[0], once], RadiosityForm::GatheredOnce),
            (scaled(1.0 / PI), RadiosityForm::OverPi),
            (scaled(PI), RadiosityForm::TimesPi),
            (vec![ours[0] * 0.5, ours[1] * 2.0], RadiosityForm::TimesArea),
            (
                solved(&enclosure, rho, [f[1], f[0]]),
                RadiosityForm::FormFactorTransposed,
            ),
            (
                solved(&enclosure, [[1.0; 3]; 2], f),
                RadiosityForm::ReflectanceForgotten,
            ),
            (
                solved(&enclosure, rho, f.map(|f| f / PI)),
                RadiosityForm::PiTwice,
            ),
            (
                ours.iter().map(|b| Rgb::new(b.b, b.g, b.r)).collect(),
                RadiosityForm::ChannelsSwapped,
            ),
            (
                [0, 1]
                    .map(|i| {
                        let b = (ours[i] - e[i]).channels();
                        Rgb::from([0, 1, 2].map(|c| b[c] / rho[i][c]))
                    })
                    .to_vec(),
                RadiosityForm::Arriving,
            ),
        ] {
            assert_eq!(found(&mine).looks, Some(looks));
        }
    }

    #[test]
    fn the_first_patch_that_differs_is_reported_with_both_values() {
        let enclosure = enclosure();
        let matrix = [0.0; 4];
        let ours = [Rgb::new(4.0, 2.0, 1.0), Rgb::new(1.0, 1.0, 1.0)];
        let mine = [ours[0], Rgb::new(1.0, 1.2, 1.0)];
        let found = compare(&mine, &ours, &enclosure, &matrix, 1e-3);
        let first = Patch {
            patch: 1,
            mine: [1.0, 1.2, 1.0],
            reference: [1.0; 3],
        };
        assert_eq!(
            (found.off, found.first, found.looks),
            (1, Some(first), None)
        );
        // Relative to the largest, which is 4.
        assert!((found.largest - 0.05).abs() < 1e-12);
    }

    #[test]
    fn one_number_is_all_channels_and_other_counts_are_refused() {
        let read = |text: &str| read(text.as_bytes(), 2);
        let gray = Ok(vec![Rgb::from([0.5; 3]), Rgb::from([1.0; 3])]);
        assert_eq!(read("0.5\n1"), gray);
        assert_eq!(read("[[0.5, 0.5, 0.5], 1]"), gray);
        for (text, expected) in [
            ("1 2 3", "it has 1 rows; the scene has 2 patches"),
            (
                "1 2 3\n1 2",
                "row 1 has 2 numbers; allowed are 1 and 3 (red, green, blue)",
            ),
            ("1 2 3\n1 2 x", "row 1: \"x\" is not a number"),
        ] {
            assert_eq!(read(text), Err(expected.to_owned()));
        }
    }
}
