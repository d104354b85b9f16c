use super::super::fixture::Fixture;
use super::super::fixtures::{
    self, SIZES, all_views, assert_legible, assert_steps_are_legible, texts,
};
use super::super::strings::Language;
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::radiosity::Solver;
use crate::render::Method;

#[test]
fn every_step_is_legible_at_every_size() {
    for method in Method::ALL {
        assert_steps_are_legible(&mut fixtures::fixtures(method), 997, &all_views(), draw);
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
fn values_stand_under_the_step_that_recorded_them() {
    let mut fixture = fixtures::fixtures(Method::Gouraud);
    let step = fixture.first("SpanInterpolated");
    fixture.seek(step);
    let input = fixture.input();
    let known = known(fixture.walk(), step);
    let mut under = step;
    let mut values = 0;
    for line in values::lines(&known, step, &input, 4) {
        match line {
            Line::Heading { step, .. } => under = step,
            Line::Value(value) => {
                assert_eq!(value.recorded.step, under);
                values += 1;
            }
        }
    }
    assert_eq!(values, known.len());
    let picture = draw(&input, SIZES[5]);
    let link = picture.tagged_bounds(Tag::Step(under)).unwrap();
    assert_eq!(picture.hit(link.center()), Some(Tag::Step(under)));
}

#[test]
fn few_short_values_leave_their_heading_whole() {
    let mut fixture = Fixture::room(Solver::GaussSeidel, Focus::Frame);
    fixture.go_to("RoomDone", 0);
    let picture = draw(&fixture.input(), Vec2::new(240.0, 160.0));
    let texts = texts(&picture);
    assert!(
        texts.iter().any(|(text, _)| *text == "Room · step 0"),
        "{texts:?}"
    );
}

#[test]
fn a_search_leaves_the_values_that_have_the_text() {
    let mut fixture = fixtures::fixtures(Method::Gouraud);
    fixture.go_to("SpanInterpolated", 0);
    let search = |text: &str| {
        let view = InspectorView {
            search: text.to_string(),
            first: 0,
        };
        let input = PanelInput {
            inspector: &view,
            ..fixture.input()
        };
        let step = shown_step(&input);
        let lines = values::lines(&known(fixture.walk(), step), step, &input, 4);
        let values = lines.iter().filter(|line| matches!(line, Line::Value(_)));
        values.count()
    };
    let all = search("");
    let some = search("scan LINE");
    assert!(0 < some && some < all, "{some} of {all}");
    assert_eq!(search("I_4"), 1);
    assert_eq!(search("no value is called so"), 0);
}

#[test]
fn a_list_that_is_scrolled_shows_every_value_in_turn_and_ends_with_the_last() {
    let mut fixture = fixtures::rays(Method::RayTracing, 3);
    fixture.go_to("BetweenTested", 0);
    for size in SIZES {
        let mut seen = Vec::new();
        let mut last = None;
        for first in 0..100 {
            let view = InspectorView {
                search: String::new(),
                first,
            };
            let input = PanelInput {
                inspector: &view,
                ..fixture.input()
            };
            let picture = draw(&input, size);
            assert_legible(&picture, &format!("{first} at {size}"));
            seen.extend(picture.items.iter().filter_map(|item| match item.tag {
                Some(Tag::Field(name)) => Some(name),
                _ => None,
            }));
            let start = scrolled(&input, size, first);
            assert!(start <= first);
            if start < first {
                last = Some(picture);
                break;
            }
        }
        seen.sort_unstable();
        seen.dedup();
        let all = known(fixture.walk(), fixture.walk().position());
        assert_eq!(seen.len(), all.len(), "{size}");
        let last = last.expect("the end is reached");
        let more = texts(&last)
            .into_iter()
            .any(|(text, _)| text.ends_with("more"));
        assert!(!more, "{size}");
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
