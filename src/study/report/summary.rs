//! All studies of a run in words: which method to pick for which error, or how work grows.

use super::strings::{bytes, error, seconds};
use crate::language::Language;
use crate::study::fit::{Fit, Law};
use crate::study::form::Axes;
use crate::study::harness::{Choice, Failed, Findings, Line, Part, Point};
use crate::study::machine::Machine;
use std::fmt::Write;

/// A Markdown file. `skipped` names studies that say nothing about the scene, with the reason.
pub fn summary(found: &[Findings], skipped: &[(&str, String)], machine: &Machine) -> String {
    let mut text = String::from("# Error against run time\n\n");
    text += &format!("Measured on {}, one thread. ", machine.strings());
    text += "A time is the median of runs in alternating order after a warm-up; two settings tie where their quartiles overlap. \
             Errors are root mean squares unless said otherwise.\n";
    if !machine.optimised {
        text += "\n**A debug build: its times say nothing about the algorithms.**\n";
    }
    for findings in found {
        study(&mut text, findings);
    }
    if !skipped.is_empty() {
        text += "\n## Left out\n\n";
        for (name, why) in skipped {
            text += &format!("- `{name}`: {why}\n");
        }
    }
    text
}

fn study(text: &mut String, findings: &Findings) {
    let study = findings.study;
    let name = study.name;
    *text += &format!(
        "\n## {}\n\n{}\n",
        study.title.text(Language::English),
        study.about.text(Language::English)
    );
    *text += &format!("\n![{}]({name}.png)\n", study.title.text(Language::English));
    for part in &findings.parts {
        if findings.parts.len() > 1 {
            *text += &format!("\n### {}\n", part.title.name());
        }
        describe(text, part);
    }
}

fn describe(text: &mut String, part: &Part) {
    let reference = &part.reference;
    if part.axes != Axes::TimeOverSize {
        *text += &format!(
            "\nReference: {}; its own error is {} ({}).\n",
            reference.what.name(),
            error(reference.error),
            reference.known_by.name()
        );
    }
    *text += &format!("Memory: {}.\n\n", part.memory.text(Language::English));
    match part.axes {
        Axes::ErrorOverTime => picks(text, part),
        Axes::ErrorOverSize => reached(text, part),
        Axes::TimeOverSize => growth(text, part),
    }
    for line in &part.lines {
        if let Some(sentence) = convergence(line, part) {
            *text += &format!("- {sentence}\n");
        }
    }
    // A curve's failures, where they have one reason, are one.
    let alike = |a: &Failed, b: &Failed| (&a.curve, &a.why) == (&b.curve, &b.why);
    for failed in part.failed.chunk_by(alike) {
        let first = &failed[0];
        let (curve, setting, why) = (first.curve.name(), first.setting.name(), &first.why);
        let on = if failed.len() > 1 { " and finer" } else { "" };
        *text += &format!("- {curve}, {setting}{on}: no result: {why}.\n");
    }
}

/// A bound on the error, the pick for it, and what ties with that.
type Row<'a> = (f64, Choice<'a>, Vec<Choice<'a>>);

/// Which setting to pick for which error.
fn picks(text: &mut String, part: &Part) {
    *text += "| for an error of at most | pick | its error | time | memory | ties |\n|---|---|---|---|---|---|\n";
    // Of the bounds that one setting is the pick for, the tightest.
    let mut rows: Vec<Row> = Vec::new();
    for exponent in 0..=15 {
        let bound = 10_f64.powi(-exponent);
        if bound < part.reference.error {
            break;
        }
        let Some((best, ties)) = part.pick(bound) else {
            break;
        };
        rows.pop_if(|(_, recorded, _)| std::ptr::eq(recorded.1, best.1));
        rows.push((bound, best, ties));
    }
    let short = in_short(&rows, part.lines.len() > 1);
    for (bound, (line, point), ties) in rows {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            error(bound),
            named(line, point),
            point
                .errors
                .map_or(String::new(), |errors| error(errors.rms)),
            time(point),
            bytes(point.bytes, Language::English),
            tied(&ties)
        );
    }
    *text += &format!("\n{short}");
    if let Some((line, best)) = most_exact(part) {
        let reached = best.errors.map_or(0.0, |errors| errors.rms);
        *text += &format!(
            " No setting here is more exact than {} ({} in {}).\n\n",
            named(line, best),
            error(reached),
            seconds(best.seconds.median, Language::English)
        );
    }
}

/// Which method to take down to which error; which setting, where there is one method.
fn in_short(rows: &[Row], several: bool) -> String {
    let name = |&(line, point): &Choice| match several {
        true => line.name.name(),
        false => point.setting.name(),
    };
    let same = |a: &Row, b: &Row| name(&a.1) == name(&b.1);
    let recorded = rows.chunk_by(same).filter_map(|rows| {
        let (_, choice, _) = rows.last()?;
        let reached = error(choice.1.errors?.rms);
        Some(format!("{} down to an error of {reached}", name(choice)))
    });
    let recorded: Vec<String> = recorded.collect();
    match recorded.is_empty() {
        true => "No setting has an error of 1 or less.".into(),
        false => format!("In short, take {}.", recorded.join("; then ")),
    }
}

/// Those that tie, the most exact ones by name.
fn tied(ties: &[Choice]) -> String {
    const NAMED: usize = 3;
    let rms = |(_, point): &Choice| point.errors.map_or(f64::INFINITY, |errors| errors.rms);
    let mut ties = ties.to_vec();
    ties.sort_by(|a, b| rms(a).total_cmp(&rms(b)));
    let names = ties.iter().take(NAMED);
    let mut recorded: Vec<String> = names.map(|(line, point)| named(line, point)).collect();
    match ties.len().saturating_sub(NAMED) {
        0 if recorded.is_empty() => return "–".into(),
        0 => {}
        more => recorded.push(format!("{more} more")),
    }
    recorded.join("; ")
}

fn most_exact(part: &Part) -> Option<(&Line, &Point)> {
    let rms = |point: &Point| point.errors.map_or(f64::INFINITY, |errors| errors.rms);
    part.points().min_by(|a, b| {
        let by_error = rms(a.1).total_cmp(&rms(b.1));
        by_error.then(a.1.seconds.median.total_cmp(&b.1.seconds.median))
    })
}

/// What error each curve has at each size.
fn reached(text: &mut String, part: &Part) {
    *text += &format!(
        "| {} | setting | rms error | largest | relative | time |\n|---|---|---|---|---|---|\n",
        part.size.text(Language::English)
    );
    for (line, point) in part.points() {
        let Some(errors) = point.errors else { continue };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} | {} |",
            point.size,
            named(line, point),
            error(errors.rms),
            error(errors.largest),
            error(errors.relative),
            time(point)
        );
    }
    *text += "\n";
}

/// How time and memory grow.
fn growth(text: &mut String, part: &Part) {
    *text += "| method | from | to | time grows as | memory grows as |\n|---|---|---|---|---|\n";
    for line in &part.lines {
        let (Some(first), Some(last)) = (line.points.first(), line.points.last()) else {
            continue;
        };
        let end = |point: &Point| {
            let size = point.size;
            format!(
                "{size} {}: {}, {}",
                part.size.text(Language::English),
                time(point),
                bytes(point.bytes, Language::English)
            )
        };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            line.name.name(),
            end(first),
            end(last),
            exponent(line.growth),
            exponent(line.memory_growth)
        );
    }
    *text += "\n";
}

fn exponent(fit: Option<Fit>) -> String {
    match fit {
        None => "too few sizes".into(),
        Some(fit) if fit.is_level() => "stays the same".into(),
        Some(fit) if fit.is_clean() => {
            format!(
                "n^{:.2}: twice the size, {:.1} times as much",
                fit.rate,
                fit.rate.exp2()
            )
        }
        Some(fit) => format!(
            "no clean power (n^{:.2}, R² {:.2})",
            fit.rate, fit.r_squared
        ),
    }
}

/// How a curve's error falls, where it falls at all.
fn convergence(line: &Line, part: &Part) -> Option<String> {
    let fit = line.convergence?;
    let name = line.name.name();
    if fit.is_level() {
        let size = part.size.text(Language::English);
        return Some(format!(
            "{name}: its error does not change with the {size}."
        ));
    }
    if !fit.is_clean() {
        return Some(format!(
            "{name}: its error follows no clean law over the {} (R² {:.2}).",
            part.size.text(Language::English),
            fit.r_squared
        ));
    }
    Some(match fit.law {
        Law::Power => format!(
            "{name}: error ∝ n^{:.2}, n the {} (R² {:.3} of {} settings).",
            fit.rate,
            part.size.text(Language::English),
            fit.r_squared,
            fit.points
        ),
        Law::Geometric => format!(
            "{name}: one more of the {} multiplies the error by {:.3} (R² {:.3} of {} settings).",
            part.size.text(Language::English),
            fit.rate,
            fit.r_squared,
            fit.points
        ),
    })
}

fn named(line: &Line, point: &Point) -> String {
    format!("{}, {}", line.name.name(), point.setting.name())
}

fn time(point: &Point) -> String {
    let timing = &point.seconds;
    format!(
        "{} ({} to {})",
        seconds(timing.median, Language::English),
        seconds(timing.lower, Language::English),
        seconds(timing.upper, Language::English)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::tests::findings;

    #[test]
    fn the_summary_picks_the_quickest_setting_that_is_exact_enough_and_names_ties() {
        let machine = Machine::this(None);
        let skipped = [("shading", "the scene has no sphere".to_string())];
        let text = summary(&[findings()], &skipped, &machine);
        for recorded in [
            "| 1.0e0 | rough, n = 2 |",
            "rough, n = 4",
            "| 1.0e-4 | fine, n = 4 |",
            "rough: error ∝ n^-2.00",
            "`shading`: the scene has no sphere",
            "its own error is 1.0e-16",
            "In short, take rough down to an error of 6.2e-2; then fine down to an error of 4.8e-7.",
        ] {
            assert!(text.contains(recorded), "{recorded:?} is not in\n{text}");
        }
    }
}
