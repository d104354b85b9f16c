//! A study as JSON: all that was measured, with the machine and the settings.

use crate::language::Language;
use crate::study::fit::{Fit, Law};
use crate::study::harness::{Findings, Line, Part, Point};
use crate::study::machine::{Machine, SEED};
use serde_json::{Map, Value as Json, json};

pub fn json(findings: &Findings, machine: &Machine, quick: bool, scene: Option<&str>) -> Json {
    json!({
        "schema": 1,
        "study": findings.study.name,
        "title": findings.study.title.text(Language::English),
        "about": findings.study.about.text(Language::English),
        "version": env!("CARGO_PKG_VERSION"),
        "machine": machine.json(),
        "settings": { "quick": quick, "scene": scene, "threads": 1, "seed": SEED },
        "parts": findings.parts.iter().map(part).collect::<Vec<_>>(),
    })
}

fn part(part: &Part) -> Json {
    let failed = part
        .failed
        .iter()
        .map(|failed| json!({ "curve": failed.curve.name(), "setting": failed.setting.name(), "why": failed.why }));
    json!({
        "title": part.title.name(),
        "quantity": part.quantity.text(Language::English),
        "size": part.size.text(Language::English),
        "reference": {
            "what": part.reference.what.name(),
            "error": part.reference.error,
            "known_by": part.reference.known_by.name(),
        },
        "memory": part.memory.text(Language::English),
        "curves": part.lines.iter().map(line).collect::<Vec<_>>(),
        "failed": failed.collect::<Vec<_>>(),
    })
}

fn line(line: &Line) -> Json {
    json!({
        "name": line.name.name(),
        "convergence": line.convergence.map(fit),
        "growth_of_time": line.growth.map(fit),
        "growth_of_memory": line.memory_growth.map(fit),
        "points": line.points.iter().map(point).collect::<Vec<_>>(),
    })
}

fn fit(fit: Fit) -> Json {
    let (law, rate) = match fit.law {
        Law::Power => ("c x^p", "p"),
        Law::Geometric => ("c q^x", "q"),
    };
    json!({ "law": law, rate: fit.rate, "c": fit.factor, "r_squared": fit.r_squared, "points": fit.points })
}

/// An error without bounds is null.
fn point(point: &Point) -> Json {
    let operations = point.operations.iter();
    let operations: Map<String, Json> = operations
        .map(|operations| (operations.of.to_string(), operations.count.into()))
        .collect();
    let seconds = &point.seconds;
    json!({
        "setting": point.setting.name(),
        "size": point.size,
        "error": point.errors.map(|errors| json!({
            "rms": errors.rms, "largest": errors.largest, "relative": errors.relative,
        })),
        "seconds": {
            "median": seconds.median, "quartiles": [seconds.lower, seconds.upper], "runs": seconds.runs,
        },
        "bytes": point.bytes,
        "operations": operations,
        "on_pareto_front": point.on_front,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::tests::findings;

    #[test]
    fn what_is_written_reads_back_the_same() {
        let findings = findings();
        let machine = Machine::this(Some("a \"processor\"".into()));
        let written = json(&findings, &machine, true, Some("room.json")).to_string();
        let read: Json = serde_json::from_str(&written).unwrap();
        assert_eq!(read["machine"]["cpu"], "a \"processor\"");
        let curve = &read["parts"][0]["curves"][0];
        let point = &findings.parts[0].lines[0].points[1];
        let seconds = curve["points"][1]["seconds"]["median"].as_f64();
        assert_eq!(seconds, Some(point.seconds.median));
        let rms = curve["points"][1]["error"]["rms"].as_f64();
        assert_eq!(rms, point.errors.map(|errors| errors.rms));
        assert!(curve["convergence"]["p"].as_f64().is_some());
    }
}
