//! What a study says of a point.

use super::session::{Session, name_of_point};
use super::strings;
use crate::language::Message;
use crate::study::harness::{Line, Point};
use crate::study::report::strings as report;

/// Everything about a point, a line each.
pub fn recorded(session: &Session, line: &Line, point: &Point) -> String {
    let localize = |strings| session.localize(strings);
    let mut recorded = name_of_point(line, point, session.look.language);
    if let Some(errors) = point.errors {
        let [rms, largest, relative] = [errors.rms, errors.largest, errors.relative]
            .map(|error| session.look.language.significant(error, 2));
        recorded += "\n";
        recorded += &Message("app-point-errors").format(
            session.look.language,
            &[
                ("rms", &rms),
                ("largest", &largest),
                ("relative", &relative),
            ],
        );
    }
    let timing = &point.seconds;
    let [median, lower, upper] = [timing.median, timing.lower, timing.upper]
        .map(|seconds| report::seconds(seconds, session.look.language));
    recorded += "
";
    recorded += &Message("app-point-time").format(
        session.look.language,
        &[
            ("median", &median),
            ("lower", &lower),
            ("upper", &upper),
            ("runs", &timing.runs.to_string()),
        ],
    );
    let mut counts: Vec<String> = Vec::new();
    for operations in &point.operations {
        counts.push(operations.text(session.look.language));
    }
    let bytes = report::bytes(point.bytes, session.look.language);
    counts.push(strings::MEMORY_IS.format(session.look.language, &[("bytes", &bytes)]));
    recorded += &format!("\n{}", counts.join(", "));
    if point.on_front {
        recorded += &format!("\n{}", localize(strings::ON_THE_FRONT));
    }
    match (&point.drawn, session.studying().command_line()) {
        (Some(_), _) => recorded += &format!("\n{}", localize(strings::CLICK_OPENS_IT)),
        (None, Some(command)) => {
            recorded += "\n";
            recorded +=
                &strings::MEASURED_AGAIN_BY.format(session.look.language, &[("command", &command)]);
        }
        (None, None) => {}
    }
    recorded
}
