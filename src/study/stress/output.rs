//! Reports as a reader wants them, and as a program does.

use super::case::{Known, Measured, Report, Unit, Verdict};
use crate::language::Language;
use serde_json::{Value as Json, json};
use std::fmt::Write;

/// The longest line, in columns.
const WIDTH: usize = 120;

const LEGEND: &str = "off: the relative error; or in units in the last place (ulp), absolute (abs), or the share of answers that are wrong (%)";

/// All reports in one table.
pub fn table(reports: &[Report]) -> String {
    let mut out = String::new();
    row(
        &mut out,
        [
            "case", "expected", "f64", "off", "f32", "off", "cond.", "verdict",
        ]
        .map(str::to_owned),
    );
    for report in reports {
        let case = report.case.name.to_owned();
        match &report.ran {
            Ok(ran) => {
                let single = ran.in_f32.as_ref();
                let columns = [
                    case,
                    Language::English.number(ran.in_f64.expected),
                    Language::English.number(ran.in_f64.found),
                    error_of(&ran.in_f64),
                    single.map_or("–".into(), |measured| {
                        Language::English.number(measured.found)
                    }),
                    single.map_or("–".into(), error_of),
                    ran.condition.map_or("–".into(), |c| format!("{c:.0e}")),
                    verdict(report),
                ];
                row(&mut out, columns);
            }
            Err(message) => {
                let dash = || "–".to_owned();
                let columns = [case, dash(), dash(), dash(), dash(), dash(), dash()];
                let [a, b, c, d, e, f, g] = columns;
                row(&mut out, [a, b, c, d, e, f, g, verdict(report)]);
                wrapped(&mut out, "    ", message);
            }
        }
    }
    let short = reports.iter().filter(|report| report.fell_short()).count();
    let count = |verdict| {
        let found = reports
            .iter()
            .filter(|report| report.in_f64.verdict == verdict);
        found.count()
    };
    wrapped(&mut out, "", LEGEND);
    let [holds, degrades, refused] =
        [Verdict::Holds, Verdict::Degrades, Verdict::Refused].map(count);
    let recorded = format!(
        "{} cases; in f64 {holds} hold, {degrades} degrade, {refused} are refused; {short} fell short of what is recorded",
        reports.len()
    );
    wrapped(&mut out, "", &recorded);
    out
}

/// What a case asks, and why its answer is known.
pub fn statement(report: &Report) -> String {
    let case = &report.case;
    let mut out = format!("{}\n", case.name);
    for (word, said) in [
        ("  asks     ", case.asks),
        ("  expects  ", case.expects),
        ("  because  ", case.because),
    ] {
        wrapped(&mut out, word, said);
    }
    out
}

/// Everything that is known of a case and came out of it.
pub fn json(report: &Report) -> Json {
    let case = &report.case;
    let measured = |measured: &Measured| json!({ "found": measured.found, "expected": measured.expected, "error": measured.error, "unit": measured.unit.name() });
    let known = |known: Known| match known {
        Known::Holds { within } => json!({ "verdict": "holds", "within": within }),
        Known::Degrades { within, most } => {
            json!({ "verdict": "degrades", "within": within, "most": most })
        }
        Known::Refused { saying } => json!({ "verdict": "refused", "saying": saying }),
    };
    let ran = report.ran.as_ref();
    let single = ran.ok().and_then(|ran| ran.in_f32.as_ref());
    json!({
        "name": case.name,
        "family": case.family(),
        "asks": case.asks,
        "expects": case.expects,
        "because": case.because,
        "recorded": { "f64": known(case.recorded.in_f64), "f32": case.recorded.in_f32.map(known) },
        "f64": ran.ok().map(|ran| measured(&ran.in_f64)),
        "f32": single.map(measured),
        "condition": ran.ok().and_then(|ran| ran.condition),
        "message": ran.err(),
        "verdict": report.in_f64.verdict.name(),
        "verdict_f32": report.in_f32.map(|judged| judged.verdict.name()),
        "fell_short": report.fell_short(),
    })
}

fn row(
    out: &mut String,
    [case, expected, f64, off_64, f32, off_32, condition, verdict]: [String; 8],
) {
    let line = format!(
        "{case:<32} {expected:>14} {f64:>14} {off_64:>9} {f32:>14} {off_32:>9} {condition:>5}  {verdict}"
    );
    out.push_str(line.trim_end());
    out.push('\n');
}

/// `said` behind `word`, in lines of at most [`WIDTH`] columns.
fn wrapped(out: &mut String, word: &str, said: &str) {
    let indent = word.chars().count();
    let mut column = indent;
    out.push_str(word);
    for (index, part) in said.split_whitespace().enumerate() {
        let length = part.chars().count();
        if index > 0 && column + 1 + length > WIDTH {
            let _ = write!(out, "\n{:indent$}", "");
            column = indent;
        } else if index > 0 {
            out.push(' ');
            column += 1;
        }
        out.push_str(part);
        column += length;
    }
    out.push('\n');
}

/// An error with its unit, in at most nine columns.
fn error_of(measured: &Measured) -> String {
    let error = measured.error;
    let short = |v: f64| match v {
        0.0 => "0".to_owned(),
        v if (0.1..1000.0).contains(&v) => format!("{v:.1}"),
        v => format!("{v:.0e}"),
    };
    match measured.unit {
        Unit::Relative if error == 0.0 => "0".into(),
        Unit::Relative => format!("{error:.1e}"),
        Unit::Absolute => format!("{} abs", short(error)),
        Unit::Ulps => format!("{} ulp", short(error)),
        Unit::Share => format!("{} %", short(100.0 * error)),
    }
}

fn verdict(report: &Report) -> String {
    let double = report.in_f64.verdict.name();
    match report.in_f32 {
        _ if report.fell_short() => "FELL SHORT".into(),
        Some(single) if single.verdict != report.in_f64.verdict => {
            format!("{double}, {}", single.verdict.name())
        }
        _ => double.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::case;
    use super::super::tests::reports;
    use super::*;

    #[test]
    fn every_line_fits_the_width() {
        let reports = reports();
        let statements = reports.iter().map(statement).collect::<String>();
        for line in table(reports).lines().chain(statements.lines()) {
            assert!(line.chars().count() <= WIDTH, "{line}");
        }
    }

    #[test]
    fn what_fell_short_says_so_in_both_forms() {
        let mut case = super::super::catalogue()[0];
        case.recorded = case::refused("it");
        let report = case.report();
        assert!(table(std::slice::from_ref(&report)).contains("FELL SHORT"));
        assert_eq!(json(&report)["fell_short"], true);
        assert_eq!(json(&report)["verdict"], "taken");
    }
}
