use super::super::fixtures::{self, SIZES, assert_legible, texts};
use super::super::strings::Language;
use super::*;
use crate::render::Method;

#[test]
fn every_step_is_legible_at_every_size() {
    for method in Method::ALL {
        let mut fixture = fixtures::fixtures(method);
        for step in fixture.some_steps(997) {
            fixture.seek(step);
            for size in SIZES {
                for language in Language::ALL {
                    let picture = draw(&fixture.show_in(language), size);
                    let what = format!("{} {step} at {size}", fixture.walk().kind(step));
                    assert_legible(&picture, &what);
                }
            }
        }
    }
}

#[test]
fn all_names_are_there_once_or_counted_as_more() {
    let mut fixture = fixtures::fixtures(Method::Gouraud);
    for step in fixture.some_steps(997) {
        fixture.seek(step);
        let names = known(fixture.walk(), step);
        for size in SIZES {
            let picture = draw(&fixture.input(), size);
            let more = texts(&picture).into_iter().find_map(|(text, _)| {
                let count = text.strip_prefix("… ")?.strip_suffix(" more")?;
                count.parse::<usize>().ok()
            });
            let mut rows: Vec<&str> = picture
                .items
                .iter()
                .filter_map(|item| match item.tag {
                    Some(Tag::Field(name)) => Some(name),
                    _ => None,
                })
                .collect();
            rows.dedup();
            assert_eq!(
                rows.len() + more.unwrap_or(0),
                names.len(),
                "{step} at {size}"
            );
        }
    }
}

#[test]
fn the_inner_word_holds_and_own_values_come_first() {
    let mut fixture = fixtures::fixtures(Method::Gouraud);
    let step = fixture.first("EdgeInterpolated");
    let known = known(fixture.seek(step).walk(), step);
    assert_eq!(known[0].field.name, "I_4");
    assert_eq!(known[0].step, step);
    let fields = fixture.walk().fields(step);
    for recorded in &known {
        assert_eq!(fields.get(recorded.field.name), Some(recorded.field.value));
    }
}

#[test]
fn objects_and_lights_are_called_by_their_names() {
    let mut fixture = fixtures::rays(Method::RayTracing, 1);
    fixture.go_to("BetweenTested", 0);
    let picture = draw(&fixture.input(), SIZES[5]);
    for value in ["0 · floor", "0 · point light"] {
        assert!(
            texts(&picture).iter().any(|(text, _)| *text == value),
            "{value}"
        );
    }
}

#[test]
fn nothing_recorded_is_said() {
    let fixture = fixtures::nothing();
    for language in Language::ALL {
        assert_legible(&draw(&fixture.show_in(language), SIZES[0]), "empty");
    }
}
