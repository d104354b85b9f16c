//! Which mistakes explain how a picture differs from the reference.

use super::{Explanation, differing, rms};
use crate::color::StoredImage;
use crate::methods::Mistake;

/// A mistake that explains a smaller share of the differing pixels, beyond those that others explain, is not named.
const EXPLAINED: f64 = 0.1;
/// With a mistake that explains something, the picture as a whole is nearer: at most this share of the rms difference is left.
const LEFT: f64 = 0.95;
/// For each pixel that it explains, a mistake may put wrong at most so many that were right.
const SPOILT: f64 = 0.1;

/// The reference with a mistake, as a file would have it.
pub type Mistaken = (Mistake, Vec<[f64; 3]>);

/// A mistake that may explain a difference.
struct Suspect {
    explanation: Explanation,
    /// By pixel, whether it differs from the reference, and not from the reference with the mistake.
    explained: Vec<bool>,
}

impl Suspect {
    fn adds(&self, left: &[bool]) -> usize {
        let pairs = self.explained.iter().zip(left);
        pairs
            .filter(|&(&explained, &left)| explained && left)
            .count()
    }

    /// Whether the picture is the same with this mistake and with the other, as far as is known.
    fn is_like(&self, other: &Suspect) -> bool {
        self.explained == other.explained
            && self.explanation.rms_after == other.explanation.rms_after
    }
}

/// The one that explains most first, then always the one that explains most of what is left, until the rest explain too little of it: two
/// mistakes at once stand first where they touch different pixels. Mistakes that give the same picture stand together.
pub fn explanations(
    mine: &StoredImage,
    tolerance: f64,
    reference: &[[f64; 3]],
    mistaken: &[Mistaken],
) -> Vec<Explanation> {
    let mut left = differing(&mine.pixels, reference, tolerance);
    let enough = EXPLAINED * left.iter().filter(|&&differs| differs).count() as f64;
    let mut suspects: Vec<Suspect> = mistaken
        .iter()
        .filter_map(|mistaken| suspect(mine, tolerance, reference, &left, mistaken))
        .collect();
    let mut found = Vec::new();
    loop {
        suspects.retain(|suspect| suspect.adds(&left) as f64 >= enough.max(1.0));
        suspects.sort_by(|a, b| {
            let adds_more = b.adds(&left).cmp(&a.adds(&left));
            let explains_more = b.explanation.explains.cmp(&a.explanation.explains);
            let fits_better = a.explanation.rms_after.total_cmp(&b.explanation.rms_after);
            adds_more.then(explains_more).then(fits_better)
        });
        let Some(best) = suspects.first() else {
            return found;
        };
        for (left, explained) in left.iter_mut().zip(&best.explained) {
            *left &= !explained;
        }
        let alike = suspects.iter().take_while(|suspect| suspect.is_like(best));
        found.extend(alike.map(|suspect| suspect.explanation.clone()));
    }
}

/// None where the mistake does not bring the reference nearer to the picture.
fn suspect(
    mine: &StoredImage,
    tolerance: f64,
    reference: &[[f64; 3]],
    differs: &[bool],
    (mistake, wrong): &Mistaken,
) -> Option<Suspect> {
    let still = differing(&mine.pixels, wrong, tolerance);
    let count = |was: bool, is: bool| {
        let pairs = differs.iter().zip(&still);
        pairs.filter(|&pair| pair == (&was, &is)).count()
    };
    let (explains, spoilt) = (count(true, false), count(false, true));
    let rms_after = rms(&mine.pixels, wrong);
    let is_nearer = rms_after <= LEFT * rms(&mine.pixels, reference);
    let explained = differs.iter().zip(&still).map(|(&was, &is)| was && !is);
    (is_nearer && spoilt as f64 <= SPOILT * explains as f64).then(|| Suspect {
        explanation: Explanation {
            name: mistake.name(),
            mistake: *mistake,
            explains,
            of: count(true, true) + explains,
            rms_after,
        },
        explained: explained.collect(),
    })
}
