use super::super::fixtures::{SIZES, assert_legible, form_factors, nothing, texts};
use super::super::strings::Language;
use super::*;
use crate::picture::Tag;

#[test]
fn every_step_is_legible_at_every_size() {
    for mut fixture in form_factors() {
        for step in fixture.some_steps(97) {
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
fn at_the_end_the_value_stands_beside_the_reference() {
    for mut fixture in form_factors() {
        let last = fixture.walk().len() - 1;
        fixture.seek(last);
        let fields = fixture.walk().own_fields(last);
        let Some(crate::record::Value::Number(f)) = fields.get("F_ij") else {
            panic!("the last step tells F");
        };
        let picture = draw(&fixture.input(), Vec2::new(800.0, 500.0));
        let printed: Vec<&str> = texts(&picture).into_iter().map(|(text, _)| text).collect();
        let value = format!("F_i_j = {}", Language::English.number(f));
        assert!(printed.contains(&value.as_str()), "{value}: {printed:?}");
        assert!(printed.iter().any(|text| text.starts_with("reference: ")));
    }
}

#[test]
fn the_current_point_of_view_can_be_pointed_at() {
    let mut samples = form_factors();
    let has = |fixture: &&mut super::super::fixture::Fixture| {
        (0..fixture.walk().len()).any(|step| fixture.walk().kind(step) == "Seen")
    };
    let fixture = samples.iter_mut().find(has).expect("a pair is parted");
    let step = fixture.first("Seen") + 3;
    fixture.seek(step);
    let picture = draw(&fixture.input(), Vec2::new(800.0, 500.0));
    assert!(picture.tagged_bounds(Tag::Step(step)).is_some());
}

#[test]
fn without_a_pair_that_is_said() {
    assert_legible(&draw(&nothing().input(), SIZES[0]), "no pair");
}
