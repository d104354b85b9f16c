//! Which names a mistyped one is near.

use super::catalogue;

/// The cases and families nearest to `name`, at most three.
pub fn nearest_names(name: &str) -> Vec<&'static str> {
    const SHOWN: usize = 3;
    let cases = catalogue();
    let mut known: Vec<&str> = cases
        .iter()
        .flat_map(|case| [case.family(), case.name])
        .collect();
    known.sort();
    known.dedup();
    known.sort_by_key(|known| distance(name, known));
    known.truncate(SHOWN);
    known
}

/// The fewest letters to put in, take out or exchange that make `b` of `a` (Levenshtein 1966).
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = i;
        row[0] = i + 1;
        for j in 0..b.len() {
            let exchanged = diagonal + usize::from(letter != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = exchanged.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_counted_as_levenshtein_does() {
        for (a, b, count) in [
            ("", "", 0),
            ("rays", "rays", 0),
            ("", "rays", 4),
            ("kitten", "sitting", 3),
            ("ramps", "rays", 2),
        ] {
            assert_eq!(distance(a, b), count, "{a} {b}");
            assert_eq!(distance(b, a), count, "{b} {a}");
        }
    }

    #[test]
    fn a_mistyped_name_is_near_the_one_meant() {
        assert_eq!(nearest_names("rampz")[0], "ramps");
        assert_eq!(nearest_names("ilumination")[0], "illumination");
    }
}
