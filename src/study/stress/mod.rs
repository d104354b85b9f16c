//! Stress cases: what each algorithm makes of what is stiff, extreme or wrong, against a closed form or a bound.
//!
//! A case is data: what is asked, what must come out and why, the run, and the verdict that is known. f64 is what everything shown is
//! computed in; f32 runs of the same generic kernels show what goes wrong in it.

mod aimed;
mod case;
mod form_factors;
mod illumination;
mod measured;
mod nearest;
mod output;
mod radiosity;
mod ramps;
mod rays;
mod refraction;
mod refusals;
mod scan;
mod scenes;
mod screen;
mod squares;
mod systems;

pub use case::{Case, Judged, Known, Measured, Ran, Recorded, Report, Unit, Verdict};
pub use nearest::nearest_names;
pub use output::{json, statement, table};

const FAMILIES: [&[Case]; 8] = [
    illumination::CASES,
    ramps::CASES,
    scan::CASES,
    rays::CASES,
    refraction::CASES,
    form_factors::CASES,
    radiosity::CASES,
    refusals::CASES,
];

/// All cases, family by family.
pub fn catalogue() -> Vec<Case> {
    FAMILIES.concat()
}

/// The cases that the names select, each a case or the beginning of some; all where there are no names.
///
/// Errors: the first name that selects nothing.
pub fn select(names: &[String]) -> Result<Vec<Case>, &str> {
    let cases = catalogue();
    let selects = |name: &String, case: &Case| case.name.starts_with(name.as_str());
    for name in names {
        if !cases.iter().any(|case| selects(name, case)) {
            return Err(name);
        }
    }
    let chosen = |case: &Case| names.is_empty() || names.iter().any(|name| selects(name, case));
    Ok(cases.into_iter().filter(chosen).collect())
}

#[cfg(test)]
pub(in crate::study) mod tests {
    use super::*;
    use std::sync::OnceLock;

    /// The whole catalogue, run once for all tests.
    pub(in crate::study) fn reports() -> &'static [Report] {
        static REPORTS: OnceLock<Vec<Report>> = OnceLock::new();
        REPORTS.get_or_init(|| catalogue().iter().map(Case::report).collect())
    }

    #[test]
    fn names_are_unique_short_and_of_their_family() {
        let cases = catalogue();
        for (index, case) in cases.iter().enumerate() {
            assert!(
                case.name.contains('/') && case.name.len() <= 32,
                "{}",
                case.name
            );
            let other = cases[..index].iter().find(|other| other.name == case.name);
            assert!(other.is_none(), "{} is there twice", case.name);
            for said in [case.asks, case.expects, case.because] {
                assert!(!said.is_empty(), "{}", case.name);
            }
        }
    }

    #[test]
    fn every_verdict_is_as_recorded() {
        let reports = reports();
        let table = table(reports);
        println!("{table}");
        let short: Vec<&str> = reports
            .iter()
            .filter(|report| report.fell_short())
            .map(|report| report.case.name)
            .collect();
        assert!(short.is_empty(), "fell short: {short:?}\n{table}");
        // What is recorded as degraded must not quietly have been mended: then it is to be recorded so.
        let better: Vec<&str> = reports
            .iter()
            .filter(|report| {
                let degraded = |known| matches!(known, Known::Degrades { .. });
                let holds = |judged: Judged| judged.verdict == Verdict::Holds;
                let recorded = report.case.recorded;
                degraded(recorded.in_f64) && holds(report.in_f64)
                    || recorded.in_f32.is_some_and(degraded) && report.in_f32.is_some_and(holds)
            })
            .map(|report| report.case.name)
            .collect();
        assert!(
            better.is_empty(),
            "better than recorded: {better:?}\n{table}"
        );
    }

    #[test]
    fn a_run_that_says_something_in_f32_is_recorded_in_f32() {
        for report in reports() {
            if let Ok(ran) = &report.ran {
                let (said, known) = (ran.in_f32.is_some(), report.case.recorded.in_f32.is_some());
                assert_eq!(said, known, "{}", report.case.name);
            }
        }
    }

    #[test]
    fn a_name_selects_a_case_or_all_that_begin_with_it() {
        let count = |names: &[&str]| {
            let names: Vec<String> = names.iter().map(|&name| name.into()).collect();
            select(&names)
                .map(|cases| cases.len())
                .map_err(str::to_owned)
        };
        let all = catalogue();
        assert_eq!(count(&[]), Ok(all.len()));
        assert_eq!(count(&[all[0].name]), Ok(1));
        let family = all.iter().filter(|case| case.family() == "ramps").count();
        assert_eq!(count(&["ramps"]), Ok(family));
        assert_eq!(count(&["ramps", all[0].name]), Ok(family + 1));
        assert_eq!(count(&["ramps", "rumps"]), Err("rumps".into()));
    }
}
