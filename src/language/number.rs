//! Numbers as a reader of the language wants them: its decimal separator, a real minus sign, powers of ten written out.

use super::Language;

/// Beyond this magnitude a fixed number of decimals says nothing.
const LARGEST_FIXED: f64 = 1e9;

impl Language {
    /// `v` to six significant digits, trailing zeros trimmed: `0.514`, `−12.5`, `3.2·10⁻¹⁷`, `∞`. Only an exact zero is `0`.
    pub fn number(self, v: f64) -> String {
        self.typeset(&to_six_digits(v))
    }

    /// `v` with `digits` decimals, so that columns align: `−0.034`, `0.500`. What rounds to zero has no sign; beyond 10⁹
    /// as [`Language::number`].
    pub fn fixed(self, v: f64, digits: usize) -> String {
        if v.abs() >= LARGEST_FIXED || v.is_nan() {
            return self.number(v);
        }
        let text = format!("{v:.digits$}");
        match text.strip_prefix('-') {
            Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => {
                self.typeset(rest)
            }
            _ => self.typeset(&text),
        }
    }

    /// `v` with at most `digits` decimals: no trailing zeros.
    pub fn short(self, v: f64, digits: usize) -> String {
        let fixed = self.fixed(v, digits);
        trimmed(&fixed, self.separator()).to_string()
    }

    /// `v` to so many significant digits, written as [`Language::number`] does.
    pub fn significant(self, v: f64, digits: usize) -> String {
        let decimals = digits.saturating_sub(1);
        self.number(format!("{v:.decimals$e}").parse().unwrap_or(v))
    }

    /// `0.25, 0.5`; after a decimal comma a semicolon stands between the numbers: `0,25; 0,5`.
    pub fn list<const N: usize>(self, numbers: [String; N]) -> String {
        match self.separator() {
            ',' => numbers.join("; "),
            _ => numbers.join(", "),
        }
    }

    fn separator(self) -> char {
        match self {
            Language::Indonesian => ',',
            _ => '.',
        }
    }

    /// A number in ASCII with the signs of the language.
    pub fn typeset(self, ascii: &str) -> String {
        ascii
            .chars()
            .map(|c| match c {
                '-' => '−',
                '.' => self.separator(),
                c => c,
            })
            .collect()
    }
}

fn to_six_digits(v: f64) -> String {
    match v {
        0.0 => return "0".to_string(),
        f64::INFINITY => return "∞".to_string(),
        f64::NEG_INFINITY => return "−∞".to_string(),
        v if v.is_nan() => return "NaN".to_string(),
        _ => {}
    }
    // Rounding comes first: 999999.7 has the exponent of 1000000.
    let scientific = format!("{v:.5e}");
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let decimals = (5 - exponent) as usize;
        trimmed(&format!("{v:.decimals$}"), '.').to_string()
    } else {
        format!("{}·10{}", trimmed(mantissa, '.'), superscript(exponent))
    }
}

/// `10⁻³`; 1 and 10 are written as they are.
pub fn power_of_ten(exponent: i32) -> String {
    match exponent {
        0 => "1".to_string(),
        1 => "10".to_string(),
        _ => format!("10{}", superscript(exponent)),
    }
}

fn trimmed(decimal: &str, separator: char) -> &str {
    if decimal.contains(separator) {
        decimal.trim_end_matches('0').trim_end_matches(separator)
    } else {
        decimal
    }
}

fn superscript(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|c| match c.to_digit(10) {
            Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
            None => '⁻',
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_significant_digits() {
        for (v, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.514, "0.514"),
            (-0.034, "−0.034"),
            (1.0 / 3.0, "0.333333"),
            (15.0, "15"),
            (-12.5, "−12.5"),
            (123_456.4, "123456"),
            (999_999.7, "1·10⁶"),
            (61_440_000.0, "6.144·10⁷"),
            (0.000_123_456_7, "0.000123457"),
            (0.000_099_999_96, "0.0001"),
            (3.2e-17, "3.2·10⁻¹⁷"),
            (-4e300, "−4·10³⁰⁰"),
            (f64::INFINITY, "∞"),
            (f64::NEG_INFINITY, "−∞"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(Language::English.number(v), text, "{v:e}");
        }
        assert_eq!(
            [-12, 0, 1, 3].map(power_of_ten),
            ["10⁻¹²", "1", "10", "10³"]
        );
    }

    #[test]
    fn decimals_are_kept_and_minus_zero_is_not() {
        assert_eq!(Language::English.fixed(0.5, 3), "0.500");
        assert_eq!(Language::English.fixed(-0.034, 3), "−0.034");
        assert_eq!(Language::English.fixed(-0.0004, 3), "0.000");
        assert_eq!(Language::English.fixed(-0.0, 1), "0.0");
        assert_eq!(Language::English.fixed(1e300, 2), "1·10³⁰⁰");
        assert_eq!(Language::English.fixed(f64::NEG_INFINITY, 2), "−∞");
    }

    #[test]
    fn the_separator_is_the_languages() {
        let indonesian = Language::Indonesian;
        assert_eq!(indonesian.number(-3.2e-17), "−3,2·10⁻¹⁷");
        assert_eq!(indonesian.fixed(0.5, 3), "0,500");
        assert_eq!(indonesian.short(0.5, 3), "0,5");
        assert_eq!(indonesian.significant(2.23e-16, 2), "2,2·10⁻¹⁶");
        let numbers = || [0.25, 0.5].map(|v| indonesian.number(v));
        assert_eq!(indonesian.list(numbers()), "0,25; 0,5");
        assert_eq!(Language::English.list(["1", "2"].map(String::from)), "1, 2");
    }
}
