//! Numbers as a report writes them.

use crate::language::{Language, Message};
use crate::study::fit::{Fit, Law};

/// `3.2 ms`, to two or three digits.
pub fn seconds(seconds: f64, language: Language) -> String {
    let units = [(1.0, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")];
    let fitting = units.into_iter().find(|(unit, _)| seconds >= *unit);
    let (unit, name) = fitting.unwrap_or((1e-9, "ns"));
    format!("{} {name}", three_digits(seconds / unit, language))
}

/// `4.7 MB`
pub fn bytes(bytes: u64, language: Language) -> String {
    let bytes = bytes as f64;
    let units = [(1e9, "GB"), (1e6, "MB"), (1e3, "kB")];
    match units.into_iter().find(|(unit, _)| bytes >= *unit) {
        Some((unit, name)) => format!("{} {name}", three_digits(bytes / unit, language)),
        None => format!("{bytes} B"),
    }
}

/// `2.3e-4`; an exact zero is `0`.
pub fn error(error: f64) -> String {
    match error {
        0.0 => "0".into(),
        error => format!("{error:.1e}"),
    }
}

fn three_digits(value: f64, language: Language) -> String {
    let decimals = match value {
        99.95.. => 0,
        9.995.. => 1,
        _ => 2,
    };
    language.fixed(value, decimals)
}

/// `∝ n^−2.0`, or `×0.52 a step`; where nothing changes, or the points lie on no line, nothing.
pub fn law(fit: &Fit, language: Language) -> Option<String> {
    (fit.is_clean() && !fit.is_level()).then(|| match fit.law {
        Law::Power => format!("∝ n^{{{}}}", language.fixed(fit.rate, 1)),
        Law::Geometric => {
            let factor = language.fixed(fit.rate, 2);
            Message("study-law-a-step").format(language, &[("factor", &factor)])
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_suit_the_size() {
        assert_eq!(seconds(0.003_24, Language::English), "3.24 ms");
        assert_eq!(seconds(12.34, Language::English), "12.3 s");
        assert_eq!(seconds(5.6e-7, Language::English), "560 ns");
        assert_eq!(seconds(2e-11, Language::English), "0.02 ns");
        assert_eq!(
            (
                bytes(999, Language::English),
                bytes(4_700_000, Language::English)
            ),
            ("999 B".into(), "4.70 MB".into())
        );
        assert_eq!((error(0.0), error(2.34e-4)), ("0".into(), "2.3e-4".into()));
    }

    #[test]
    fn only_what_lies_on_a_line_is_called_a_law() {
        let fit = |r_squared| Fit {
            law: Law::Power,
            rate: -1.96,
            factor: 1.0,
            r_squared,
            points: 4,
        };
        let law = |r_squared, language| law(&fit(r_squared), language);
        assert_eq!(law(0.999, Language::English).as_deref(), Some("∝ n^{−2.0}"));
        assert_eq!(
            law(0.999, Language::Indonesian).as_deref(),
            Some("∝ n^{−2,0}")
        );
        assert_eq!(law(0.5, Language::English), None);
    }
}
