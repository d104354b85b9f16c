//! A study as comma-separated values (RFC 4180): one line a setting.

use crate::study::harness::{Findings, Part};

const HEAD: [&str; 14] = [
    "part",
    "curve",
    "setting",
    "size",
    "rms_error",
    "largest_error",
    "relative_error",
    "seconds_median",
    "seconds_lower_quartile",
    "seconds_upper_quartile",
    "runs",
    "bytes",
    "on_pareto_front",
    "operations",
];

pub fn csv(findings: &Findings) -> String {
    let mut text = line(HEAD.map(String::from));
    for part in &findings.parts {
        rows(part, &mut text);
    }
    text
}

fn rows(part: &Part, text: &mut String) {
    for (curve, point) in part.points() {
        let error = |of: fn(crate::study::errors::Errors) -> f64| {
            point
                .errors
                .map_or(String::new(), |errors| number(of(errors)))
        };
        let operations = point.operations.iter();
        let operations: Vec<String> = operations
            .map(|operations| format!("{}={}", operations.of, operations.count))
            .collect();
        text.push_str(&line([
            part.title.name(),
            curve.name.name(),
            point.setting.name(),
            number(point.size),
            error(|errors| errors.rms),
            error(|errors| errors.largest),
            error(|errors| errors.relative),
            number(point.seconds.median),
            number(point.seconds.lower),
            number(point.seconds.upper),
            point.seconds.runs.to_string(),
            point.bytes.to_string(),
            point.on_front.to_string(),
            operations.join(" "),
        ]));
    }
}

/// As short as reads back the same.
fn number(value: f64) -> String {
    format!("{value:e}")
}

fn line(fields: [String; HEAD.len()]) -> String {
    fields.map(quoted).join(",") + "\r\n"
}

/// In quotes where the field would break the line otherwise.
fn quoted(field: String) -> String {
    match field.contains(['"', ',', '\n', '\r']) {
        true => format!("\"{}\"", field.replace('"', "\"\"")),
        false => field,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::tests::findings;

    #[test]
    fn every_line_has_as_many_fields_as_the_head_and_numbers_read_back() {
        let text = csv(&findings());
        let mut lines = text.split_terminator("\r\n");
        assert_eq!(lines.next(), Some(HEAD.join(",").as_str()));
        let lines: Vec<&str> = lines.collect();
        assert_eq!(lines.len(), 6);
        for line in lines {
            let fields: Vec<&str> = line.split(',').collect();
            assert_eq!(fields.len(), HEAD.len(), "{line}");
            for field in &fields[3..12] {
                assert!(field.parse::<f64>().is_ok(), "{field} in {line}");
            }
        }
    }

    #[test]
    fn fields_that_would_break_a_line_are_quoted() {
        assert_eq!(quoted("a \"b\", c".into()), "\"a \"\"b\"\", c\"");
        assert_eq!(quoted("plain".into()), "plain");
    }
}
