//! `lightwalk stress`.

use crate::{lightwalk, refused, succeeded, text};
use serde_json::Value;
use std::path::Path;

fn folder() -> &'static Path {
    Path::new(env!("CARGO_TARGET_TMPDIR"))
}

#[test]
fn a_family_is_explained_and_then_summed_up_in_a_table() {
    let output = succeeded(folder(), "stress ramps rays/eta-1");
    let recorded = text(&output.stdout);
    let lines: Vec<&str> = recorded.lines().collect();
    assert!(lines.iter().all(|line| line.chars().count() <= 120));
    let header = lines.iter().position(|line| line.starts_with("case "));
    let (statements, table) = lines.split_at(header.expect("a table"));
    for part in ["ramps/1e6-additions", "rays/eta-1"] {
        assert!(statements.contains(&part), "{part}");
        assert!(table.iter().any(|line| line.starts_with(part)), "{part}");
    }
    let additions = table
        .iter()
        .find(|line| line.starts_with("ramps/1e6-additions"));
    assert!(additions.is_some_and(|line| line.ends_with("degrades")));
    assert!(!recorded.contains("radiosity/"));
}

#[test]
fn as_json_every_field_is_there() {
    let stress = "stress --json rays/critical-angle refusals/patches-1e18";
    let output = succeeded(folder(), stress);
    let cases: Vec<Value> = serde_json::from_slice(&output.stdout).expect("an array");
    let [below, above, patches] = &cases[..] else {
        panic!("{} cases", cases.len());
    };
    assert_eq!(below["name"], "rays/critical-angle-below");
    assert_eq!(above["family"], "rays");
    for key in ["asks", "expects", "because"] {
        assert!(
            below[key].as_str().is_some_and(|said| !said.is_empty()),
            "{key}"
        );
    }
    assert_eq!(
        (&below["verdict"], &below["verdict_f32"]),
        (&"holds".into(), &"degrades".into())
    );
    assert_eq!(below["f64"]["error"], 0.0);
    assert!(
        below["f32"]["error"]
            .as_f64()
            .is_some_and(|share| share > 0.1)
    );
    assert!(
        below["condition"]
            .as_f64()
            .is_some_and(|condition| condition > 1e11)
    );
    assert_eq!(below["recorded"]["f64"]["verdict"], "holds");
    assert_eq!(patches["verdict"], "refused");
    assert!(
        patches["message"]
            .as_str()
            .is_some_and(|message| message.contains("--max-patches"))
    );
    assert!(cases.iter().all(|case| case["fell_short"] == false));
}

#[test]
fn an_unknown_name_is_refused_with_the_names_near_it() {
    let output = lightwalk(folder(), "stress rays radiositty");
    let message = refused(&output, "radiositty");
    assert!(
        message.contains("\"radiositty\" is no stress case"),
        "{message}"
    );
    assert!(message.contains("near it are radiosity"), "{message}");
    assert!(output.stdout.is_empty());
}
