mod taken;

use super::super::fixture::{self, Fixture};
use super::super::fixtures::{
    self, SIZES, all_views, assert_legible, assert_steps_are_legible, texts,
};
use super::*;
use crate::algorithms::enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::radiosity::{Solver, Stop};
use crate::algorithms::texture::Mapping;
use crate::picture::Tag;
use crate::record::Fields;
use crate::render::Method;
use crate::vocabulary::FAMILIES;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

/// Every step of the crowd, by every method, of rays among spheres, of every solver and method of form factors.
fn each_step(mut look: impl FnMut(&'static Kind, &mut Known, &PreparedScene)) {
    let crowds = Method::ALL.map(fixtures::fixtures);
    let of_file = Fixture::pyramid_with_normals(Method::Gouraud);
    let rays = [
        fixtures::rays(Method::RayCasting, 2),
        fixtures::rays(Method::RayTracing, 1),
        Fixture::rays(Method::RayTracing, fixture::BALL, 5),
        Fixture::rays(Method::RayTracing, fixture::SPARK, 5),
    ];
    let textured = [
        fixtures::textured(Method::Gouraud, Mapping::Perspective),
        fixtures::textured(Method::Flat, Mapping::Perspective),
        fixtures::textured(Method::Phong, Mapping::Linear),
        fixtures::textured(Method::Exact, Mapping::Perspective),
        fixtures::textured(Method::FastPhong, Mapping::Perspective),
        fixtures::textured_under(Vec::new(), Method::FastPhong, Mapping::Perspective),
    ];
    let cancelling = [Fixture::cancelling_normals(Method::FastPhong)];
    let behind =
        [Method::Wireframe, Method::Gouraud, Method::FastPhong].map(fixtures::behind_the_eye);
    let rays = rays
        .into_iter()
        .chain([Method::RayTracing, Method::Exact].map(fixtures::shapes))
        .chain(textured)
        .chain(cancelling)
        .chain(behind);
    let light = fixtures::solvers()
        .into_iter()
        .chain(fixtures::form_factors())
        .chain([
            fixtures::hinge(),
            fixtures::crossing(),
            fixtures::crowded(),
            fixtures::linked(),
            iterated(),
        ])
        .chain([Solver::GaussSeidel, Solver::OverRelaxation].map(of_one_patch));
    for fixture in crowds.into_iter().chain([of_file]).chain(rays).chain(light) {
        for step in 0..fixture.walk().len() {
            let prepared = fixture.run.prepared();
            let mut known = Known::at(&fixture.run, step);
            look(fixture.walk().declared(step), &mut known, prepared);
        }
    }
}

/// More iterations of Chebyshev than [`fixtures::solvers`] takes.
fn iterated() -> Fixture {
    let settings = enclosure::Settings {
        solver: Solver::Chebyshev,
        stop: Stop {
            tolerance: 1e-9,
            max_iterations: 100,
        },
        ..enclosure::Settings::default()
    };
    fixtures::open_room(settings, Focus::Frame)
}

/// Iterations of which the exchanges of one patch alone are recorded.
fn of_one_patch(solver: Solver) -> Fixture {
    let settings = enclosure::Settings {
        solver,
        ..enclosure::Settings::default()
    };
    fixtures::open_room(settings, Focus::Patch(fixtures::FLOOR[0]))
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
        for formula in formulas(entry, known) {
            used.insert(formula.text);
        }
        used.insert(entry.sentence.0);
    });
    let declared = FAMILIES.into_iter().flatten();
    let mut unused = BTreeSet::new();
    for (kind, entry) in
        declared.flat_map(|kind| kind.entries.iter().map(move |entry| (kind, entry)))
    {
        assert!(
            used.contains(entry.sentence.0),
            "{}: {}",
            kind.name,
            entry.sentence.0
        );
        let formulas = entry.formulas.iter().map(|formula| formula.text);
        unused.extend(formulas.filter(|text| !used.contains(text)));
    }
    assert!(unused.is_empty(), "{unused:#?}");
}

#[test]
fn the_result_is_printed_as_the_field_is() {
    let mut fixture = fixtures::fixtures(Method::Gouraud);
    for step in fixture.some_steps(997) {
        fixture.seek(step);
        let picture = draw(&fixture.input(), SIZES[5]);
        let mut known = Known::at(&fixture.run, step);
        let kind = fixture.walk().declared(step);
        let entry = entry(kind, &known).expect("every step has one");
        for equation in formulas(entry, &mut known)
            .iter()
            .map(|formula| formula.equation())
        {
            let Some(value) = result(equation, &known) else {
                continue;
            };
            let right = equation.right.as_ref().map(|(_, right)| right);
            let has_numbers = right.is_some_and(|right| has_numbers(right, &known));
            let coloured = is_coloured(equation, &known) && has_numbers;
            for channel in 0..if coloured { 3 } else { 1 } {
                let expected = if coloured {
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
        assert_steps_are_legible(&mut fixture, 2011, &all_views(), draw);
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
        let value = fields.get(name).expect("a recorded field");
        assert!(
            printed.contains(&shown(value, 4, Language::English)),
            "{name} in {printed}"
        );
    }
}

#[test]
fn where_one_channel_is_worked_out_it_is_the_largest_until_another_is_chosen() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("BranchAdded", 0);
    let walk = fixture.walk();
    let Some(Value::Rgb(sum)) = walk.fields(walk.position()).get("I_sum") else {
        panic!("the sum is a colour");
    };
    let printed = |channel: usize| set::number_text(Value::Rgb(sum), channel, Language::English);
    let largest = (0..3).max_by(|&a, &b| sum.channels()[a].total_cmp(&sum.channels()[b]));
    let largest = largest.expect("three channels");
    let other = (largest + 1) % 3;
    assert_ne!(printed(largest), printed(other));
    for (chosen, worked) in [(None, largest), (Some(other), other)] {
        let input = PanelInput {
            channel: chosen,
            ..fixture.input()
        };
        // At some height there is room for one channel's numbers.
        let heights = (60..400_u16).step_by(10).map(f32::from);
        let pictures: Vec<Picture> = heights
            .map(|height| draw(&input, Vec2::new(320.0, height)))
            .collect();
        let is_alone = |picture: &Picture, channel: usize| {
            let has = |channel| {
                texts(picture)
                    .iter()
                    .any(|(text, _)| *text == printed(channel))
            };
            (0..3).all(|other| has(other) == (other == channel))
        };
        let of_worked: Vec<&Picture> = pictures
            .iter()
            .filter(|picture| is_alone(picture, worked))
            .collect();
        assert!(!of_worked.is_empty(), "{chosen:?}");
        for channel in 0..3 {
            let tag = Tag::Channel(channel);
            let is_shown = |picture: &&Picture| picture.tagged_bounds(tag).is_some();
            assert!(of_worked.iter().all(is_shown), "{chosen:?}: {channel}");
            let alone = pictures.iter().any(|picture| is_alone(picture, channel));
            assert_eq!(alone, channel == worked, "{chosen:?}: {channel}");
        }
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
    assert!(alt.contains(" θ_r in ° = "), "{alt}");
}

#[test]
fn of_a_thousand_values_recorded_before_the_last_one_counts() {
    let rays = 1024;
    let settings = enclosure::Settings {
        form_factors: crate::algorithms::form_factor::Method::MonteCarlo { rays, seed: 0 },
        ..Default::default()
    };
    let [i, j] = [fixtures::LAMP, fixtures::FLOOR[0]];
    let fixture = fixtures::open_room(settings, Focus::FormFactor { i, j });
    let walk = fixture.walk();
    let last = (0..walk.len()).rfind(|&step| walk.kind(step) == "RaysCast");
    let known = Known::at(&fixture.run, last.expect("batches end"));
    let (Some(Value::Number(f)), Some(Value::Integer(hits))) =
        (known.value("F_mean"), known.value("hits"))
    else {
        panic!("the end of the last batch knows both");
    };
    assert_eq!(f, hits as f64 / f64::from(rays));
}

/// How often a formula was evaluated, and how often a value was not known.
#[derive(Default)]
struct Tally {
    evaluated: usize,
    unknown: usize,
}

#[test]
fn both_sides_of_every_formula_agree() {
    let mut tallies: HashMap<&str, Tally> = HashMap::new();
    let mut wrong: HashMap<&str, (usize, String)> = HashMap::new();
    each_step(|kind, known, _| {
        let entry = entry(kind, known).expect("every step has one");
        for evaluated in evaluated::of_entry(entry, known) {
            let formula = evaluated.formula;
            let tally = tallies.entry(formula.text).or_default();
            match evaluated.holds() {
                Some(true) => tally.evaluated += 1,
                Some(false) => {
                    tally.evaluated += 1;
                    let sides = format!(
                        "{}: {:?} and {:?}",
                        kind.name, evaluated.left, evaluated.right
                    );
                    wrong.entry(formula.text).or_insert((0, sides)).0 += 1;
                }
                None => tally.unknown += 1,
            }
        }
    });
    assert!(wrong.is_empty(), "{wrong:#?}");
    let mut unused = BTreeSet::new();
    let declared = FAMILIES.into_iter().flatten().flat_map(|kind| kind.entries);
    for formula in declared.flat_map(|entry| entry.formulas) {
        let Some(tally) = tallies.get(formula.text) else {
            if formula.equation().right.is_some() {
                unused.insert(formula.text);
            }
            continue;
        };
        println!(
            "{:7} of {:7}: {}",
            tally.evaluated,
            tally.evaluated + tally.unknown,
            formula.text
        );
        // What is not evaluated says why; what is evaluated sometimes is so at most steps.
        let is_evaluated = formula.unevaluated.is_none();
        if is_evaluated != (tally.evaluated > 0)
            || is_evaluated != formula.equation().is_computable()
        {
            unused.insert(formula.text);
        }
    }
    assert!(unused.is_empty(), "{unused:#?}");
}

#[test]
fn a_broken_formula_is_seen() {
    let fixture = fixtures::fixtures(Method::Phong);
    for (kind, broken) in [
        (
            "Light",
            "f_att = [1; light_a_0 + light_a_1 · d − light_a_2 · d^2]",
        ),
        ("Viewer", "V = [eye − P; |eye + P|]"),
        ("ToLight", "N_dot_L = N · V"),
        ("Diffuse", "I_d = k_d · I_light · max(0, N_dot_L)"),
        ("Specular", "I_s = k_s · I_light · f_att · N_dot_L^n_s"),
        ("Illuminated", "I = I_a + I_a"),
        (
            "Edge",
            "x_4 = {x_1=x@corner:lower} + (y_4 − y_1) · {dx_dy@edge:edge}",
        ),
        (
            "SpanInterpolated",
            "N_P = [x_5 − x_P; x_5 − x_4] · N_5 + [x_P − x_4; x_5 − x_4] · N_4",
        ),
    ] {
        let equation = Equation::parse(broken).expect("it parses");
        let (relation, right) = equation.right.as_ref().expect("two sides");
        let steps = (0..fixture.walk().len()).filter(|&step| fixture.walk().kind(step) == kind);
        let seen = steps.take(30).any(|step| {
            let known = Known::at(&fixture.run, step);
            let value = |side| evaluate(side, &|reference| known.terms(reference));
            let (left, right) = (value(&equation.left), value(right));
            let (left, right) = (left.expect("recorded"), right.expect("known"));
            !evaluated::agree(*relation, left, right)
        });
        assert!(seen, "{broken}");
    }
}

/// In a presentation nobody can enlarge the panel.
#[test]
fn what_is_presented_is_what_the_explanation_speaks_of_and_nothing_is_announced() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("ToLight", 0);
    let spoken = ["N_dot_L".to_string()];
    // One formula with its numbers, and a line.
    let height = least_height(&fixture.input(), 300.0) + 20.0;
    let printed = |presented| {
        let input = PanelInput {
            presented,
            ..fixture.input()
        };
        let picture = draw(&input, Vec2::new(300.0, height));
        let texts = texts(&picture).into_iter().map(|(text, _)| text);
        texts.collect::<Vec<_>>().join(" ")
    };
    let usual = printed(None);
    assert!(usual.contains(" more below"), "{usual}");
    for spoken in [&spoken[..], &[]] {
        let presented = printed(Some(spoken));
        assert!(!presented.contains(" more below"), "{presented}");
        assert_eq!(presented.contains("N·L"), !spoken.is_empty(), "{presented}");
    }
}
