//! `lightwalk stress`: the stiff and extreme cases, each with what was expected, what came out and a verdict.

use super::failure::Failure;
use super::progress::Progress;
use crate::study::stress::{Report, json, nearest_names, select, statement, table};
use std::io::Write;

#[derive(clap::Args)]
pub struct Arguments {
    /// Cases, or the beginning of their names, such as `rays`: all of them unless given
    names: Vec<String>,
    /// As a JSON array of objects with everything that is known of each case
    #[arg(long)]
    json: bool,
}

pub fn run(arguments: Arguments) -> Result<(), Failure> {
    let cases = select(&arguments.names).map_err(unknown)?;
    let progress = Progress::new("running the stress cases");
    let reports = cases.iter().enumerate().map(|(done, case)| {
        progress.show(done, cases.len());
        case.report()
    });
    let reports: Vec<Report> = reports.collect();
    drop(progress);
    let mut out = std::io::stdout().lock();
    write_reports(&mut out, &reports, arguments.json)?;
    out.flush()?;
    verdict(&reports)
}

/// Every statement and then the table, or the array.
fn write_reports(out: &mut impl Write, reports: &[Report], as_json: bool) -> Result<(), Failure> {
    if as_json {
        let reports: Vec<_> = reports.iter().map(json).collect();
        serde_json::to_writer_pretty(&mut *out, &reports).map_err(std::io::Error::from)?;
        writeln!(out)?;
        return Ok(());
    }
    for report in reports {
        writeln!(out, "{}", statement(report))?;
    }
    write!(out, "{}", table(reports))?;
    Ok(())
}

/// Errors: verdicts that are worse than recorded.
fn verdict(reports: &[Report]) -> Result<(), Failure> {
    let short: Vec<&str> = reports
        .iter()
        .filter(|report| report.fell_short())
        .map(|report| report.case.name)
        .collect();
    match short.is_empty() {
        true => Ok(()),
        false => Err(Failure::Failed(format!("fell short: {}", short.join(", ")))),
    }
}

fn unknown(name: &str) -> Failure {
    Failure::Wrong(format!(
        "{name:?} is no stress case, nor the beginning of one; near it are {}",
        nearest_names(name).join(", ")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::stress::{Case, Known, catalogue};

    #[test]
    fn a_bound_that_is_not_kept_fails_with_status_1() {
        let mut cases = catalogue();
        cases.truncate(2);
        let good: Vec<Report> = cases.iter().map(Case::report).collect();
        assert!(verdict(&good).is_ok());
        cases[1].recorded.in_f64 = Known::Holds { within: -1.0 };
        let sabotaged: Vec<Report> = cases.iter().map(Case::report).collect();
        let failure = verdict(&sabotaged).unwrap_err();
        assert_eq!(failure.status(), 1);
        assert_eq!(
            failure.to_string(),
            format!("fell short: {}", cases[1].name)
        );
        let mut out = Vec::new();
        write_reports(&mut out, &sabotaged, false).unwrap();
        assert!(String::from_utf8(out).unwrap().contains("FELL SHORT"));
    }

    #[test]
    fn an_unknown_name_is_refused_with_what_is_near() {
        let names = ["ilumination".to_owned()];
        let failure = select(&names).map_err(unknown).unwrap_err();
        assert_eq!(failure.status(), 2);
        assert!(
            failure.to_string().contains("near it are illumination"),
            "{failure}"
        );
    }
}
