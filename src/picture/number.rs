//! Numbers as a reader wants them: six significant digits, a real minus sign, powers of ten written out.

/// Beyond this magnitude a fixed number of decimals says nothing.
const LARGEST_FIXED: f64 = 1e9;

/// `v` to six significant digits, trailing zeros trimmed: `0.514`, `−12.5`, `3.2·10⁻¹⁷`, `∞`. Only an exact zero is `0`.
pub fn number(v: f64) -> String {
    if let Some(word) = special(v) {
        return word;
    }
    // Rounding comes first: 999999.7 has the exponent of 1000000.
    let scientific = format!("{v:.5e}");
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if (-4..6).contains(&exponent) {
        let decimals = (5 - exponent) as usize;
        typeset(trimmed(&format!("{v:.decimals$}")))
    } else {
        typeset(&format!(
            "{}·10{}",
            trimmed(mantissa),
            superscript(exponent)
        ))
    }
}

/// `v` with `digits` decimals, so that columns align: `−0.034`, `0.500`. What rounds to zero has no sign; beyond 10⁹ as [`number`].
pub fn fixed(v: f64, digits: usize) -> String {
    if v.abs() >= LARGEST_FIXED || v.is_nan() {
        return number(v);
    }
    let text = format!("{v:.digits$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_string(),
        _ => typeset(&text),
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

fn special(v: f64) -> Option<String> {
    let word = match v {
        0.0 => "0",
        f64::INFINITY => "∞",
        f64::NEG_INFINITY => "−∞",
        v if v.is_nan() => "NaN",
        _ => return None,
    };
    Some(word.to_string())
}

fn trimmed(decimal: &str) -> &str {
    if decimal.contains('.') {
        decimal.trim_end_matches('0').trim_end_matches('.')
    } else {
        decimal
    }
}

fn typeset(ascii: &str) -> String {
    ascii.replace('-', "−")
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
            assert_eq!(number(v), text, "{v:e}");
        }
        assert_eq!(
            [-12, 0, 1, 3].map(power_of_ten),
            ["10⁻¹²", "1", "10", "10³"]
        );
    }

    #[test]
    fn decimals_are_kept_and_minus_zero_is_not() {
        assert_eq!(fixed(0.5, 3), "0.500");
        assert_eq!(fixed(-0.034, 3), "−0.034");
        assert_eq!(fixed(-0.0004, 3), "0.000");
        assert_eq!(fixed(-0.0, 1), "0.0");
        assert_eq!(fixed(1e300, 2), "1·10³⁰⁰");
        assert_eq!(fixed(f64::NEG_INFINITY, 2), "−∞");
    }
}
