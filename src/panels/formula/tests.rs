use super::super::fixture::{self, Fixture};
use super::super::fixtures::{self, SIZES, assert_legible, texts};
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::mapping::Mapping;
use crate::render::Method;
use crate::vocabulary::FAMILIES;
use std::collections::HashSet;

/// Every step of the crowd, by every method, of rays among spheres, of every solver and method of form factors.
fn each_step(mut look: impl FnMut(&'static Kind, &Known, &PreparedScene)) {
    let crowds = Method::ALL.map(fixtures::fixtures);
    let rays = [
        fixtures::rays(Method::RayCasting, 2),
        fixtures::rays(Method::RayTracing, 1),
        Fixture::rays(Method::RayTracing, fixture::BALL, 5),
        Fixture::rays(Method::RayTracing, fixture::SPARK, 5),
    ];
    let textured = [
        fixtures::textured(Method::Flat, Mapping::Perspective),
        fixtures::textured(Method::Phong, Mapping::Linear),
        fixtures::textured(Method::Exact, Mapping::Perspective),
    ];
    let rays = rays.into_iter().chain(textured);
    let light = fixtures::solvers()
        .into_iter()
        .chain(fixtures::form_factors());
    for fixture in crowds.into_iter().chain(rays).chain(light) {
        for step in 0..fixture.walk().len() {
            let known = Known::at(fixture.walk(), step);
            look(
                fixture.walk().declared(step),
                &known,
                fixture.run.prepared(),
            );
        }
    }
}

#[test]
fn every_step_has_an_entry_and_every_entry_and_formula_is_used_with_all_its_values() {
    let mut used = HashSet::new();
    each_step(|kind, known, prepared| {
        let entry = entry(kind, known).unwrap_or_else(|| panic!("{} has no entry", kind.name));
        for language in Language::ALL {
            let says = filled(entry.sentence, known, prepared, language);
            assert!(!says.contains("{$"), "{}: {says}", kind.name);
        }
        for formula in entry
            .formulas
            .iter()
            .filter(|formula| holds(formula.when, known))
        {
            for place in places(&parse(formula.template)) {
                let values = known.values(place);
                assert!(
                    values.is_some(),
                    "{}: nobody told {}",
                    kind.name,
                    place.name
                );
            }
            used.insert(formula.template);
        }
        used.insert(entry.sentence.0);
    });
    let declared = FAMILIES.into_iter().flatten();
    for (kind, entry) in
        declared.flat_map(|kind| kind.entries.iter().map(move |entry| (kind, entry)))
    {
        assert!(
            used.contains(entry.sentence.0),
            "{}: {}",
            kind.name,
            entry.sentence.0
        );
        for formula in entry.formulas {
            assert!(used.contains(formula.template), "{}", formula.template);
        }
    }
}

#[test]
fn the_result_is_printed_as_the_field_is() {
    let mut fixture = fixtures::fixtures(Method::Gouraud);
    for step in fixture.some_steps(997) {
        fixture.seek(step);
        let picture = draw(&fixture.input(), SIZES[5]);
        let known = Known::at(fixture.walk(), step);
        let kind = fixture.walk().declared(step);
        let entry = entry(kind, &known).expect("every step has one");
        for formula in formulas(entry, &known) {
            let Some(value) = formula.result(&known) else {
                continue;
            };
            let coloured = formula.is_coloured(&known) && !formula.right.is_empty();
            for channel in 0..if coloured { 3 } else { 1 } {
                let expected = if coloured && !places(&formula.right).is_empty() {
                    set::number_text(value, channel, Language::English)
                } else {
                    shown(value, 4, Language::English)
                };
                let found = texts(&picture).iter().any(|(text, _)| *text == expected);
                assert!(found, "{}: {expected}", kind.name);
            }
        }
    }
}

#[test]
fn every_step_is_legible_at_every_size() {
    let crowds = Method::ALL.map(fixtures::fixtures);
    let light = fixtures::solvers()
        .into_iter()
        .chain(fixtures::form_factors());
    for mut fixture in crowds.into_iter().chain(light) {
        for step in fixture.some_steps(2011) {
            fixture.seek(step);
            for size in SIZES {
                for language in Language::ALL {
                    let picture = draw(&fixture.show_in(language), size);
                    let what = format!("{} {step} at {size}", fixture.walk().kind(step));
                    assert_legible(&picture, &what);
                    assert!(!picture.items.is_empty(), "{what}");
                }
            }
        }
    }
}

#[test]
fn the_interpolated_edge_has_symbols_numbers_and_result() {
    let mut fixture = Fixture::triangle(Method::Gouraud);
    fixture.go_to("EdgeInterpolated", 4);
    let picture = draw(&fixture.input(), Vec2::new(500.0, 300.0));
    let printed: String = texts(&picture).into_iter().map(|(text, _)| text).collect();
    let fields = fixture.walk().fields(fixture.walk().position());
    for name in ["y_4", "y_2", "y_1", "I_1", "I_2", "I_4", "difference"] {
        let value = fields.get(name).expect("told");
        assert!(
            printed.contains(&shown(value, 4, Language::English)),
            "{name} in {printed}"
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

#[test]
fn words_name_symbols_as_the_formula_sets_them() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("Refraction", 0);
    let alt = draw(&fixture.input(), Vec2::new(380.0, 280.0)).alt;
    assert!(alt.contains(" cos^2 θ_r = "), "{alt}");
    assert!(alt.contains(" θ_r degrees = "), "{alt}");
}

#[test]
fn of_a_thousand_values_recorded_before_the_last_one_counts() {
    let rays = 1024;
    let settings = crate::algorithms::enclosure::Settings {
        form_factors: crate::algorithms::form_factor::Method::MonteCarlo { rays, seed: 0 },
        ..Default::default()
    };
    let [i, j] = [fixtures::LAMP, fixtures::FLOOR[0]];
    let fixture = fixtures::open_room(settings, Focus::FormFactor { i, j });
    let known = Known::at(fixture.walk(), fixture.walk().len() - 1);
    let value = |name: &str| known.get(name).map(|recorded| recorded.field.value);
    let (Some(Value::Number(f)), Some(Value::Integer(hits))) = (value("F_ij"), value("hits"))
    else {
        panic!("the last step knows both");
    };
    assert_eq!(f, hits as f64 / f64::from(rays));
}
