use super::super::crowd::{SIZES, assert_legible, form_factors, nothing, texts};
use super::super::words::Language;
use super::*;
use crate::picture::Tag;

#[test]
fn every_step_is_legible_at_every_size() {
    for mut sample in form_factors() {
        for step in sample.some_steps(97) {
            sample.seek(step);
            for size in SIZES {
                for language in Language::ALL {
                    let picture = draw(&sample.show_in(language), size);
                    let what = format!("{} {step} at {size}", sample.walk().kind(step));
                    assert_legible(&picture, &what);
                }
            }
        }
    }
}

#[test]
fn at_the_end_the_value_stands_beside_the_reference() {
    for mut sample in form_factors() {
        let last = sample.walk().len() - 1;
        sample.seek(last);
        let fields = sample.walk().own_fields(last);
        let Some(crate::record::Value::Number(f)) = fields.get("F_ij") else {
            panic!("the last step tells F");
        };
        let picture = draw(&sample.show(), Vec2::new(800.0, 500.0));
        let printed: Vec<&str> = texts(&picture).into_iter().map(|(text, _)| text).collect();
        let value = format!("F_i_j = {}", number(f));
        assert!(printed.contains(&value.as_str()), "{value}: {printed:?}");
        assert!(printed.iter().any(|text| text.starts_with("reference: ")));
    }
}

#[test]
fn the_line_of_sight_in_hand_can_be_pointed_at() {
    let mut samples = form_factors();
    let has = |sample: &&mut super::super::sample::Sample| {
        (0..sample.walk().len()).any(|step| sample.walk().kind(step) == "Sight")
    };
    let sample = samples.iter_mut().find(has).expect("a pair is parted");
    let step = sample.first("Sight") + 3;
    sample.seek(step);
    let picture = draw(&sample.show(), Vec2::new(800.0, 500.0));
    assert!(picture.tagged_bounds(Tag::Step(step)).is_some());
}

#[test]
fn without_a_pair_that_is_said() {
    assert_legible(&draw(&nothing().show(), SIZES[0]), "no pair");
}
