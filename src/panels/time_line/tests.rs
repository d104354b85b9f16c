use super::super::fixture::{self, Fixture};
use super::super::fixtures::{self, SIZES, assert_legible, texts};
use super::rows::{NARROWEST, bars};
use super::*;
use crate::record::{Outline, Recorder, Recording, RecordingLimit, Value};
use crate::render::Method;
use std::collections::HashSet;

#[test]
fn every_step_is_legible_and_bars_never_overlap() {
    for method in Method::ALL {
        let mut fixture = fixtures::fixtures(method);
        for step in fixture.some_steps(997) {
            fixture.seek(step);
            for size in SIZES {
                let what = format!("{} {step} at {size}", fixture.walk().kind(step));
                let picture = draw(&fixture.show_in(Language::Indonesian), size);
                assert_legible(&picture, &what);
                let rows = rows(fixture.walk(), size);
                assert!(!rows.is_empty(), "{what}");
                for row in &rows {
                    assert!(row.bars.len() as f64 <= f64::from(size.x) / NARROWEST);
                    for pair in row.bars.windows(2) {
                        let (a, b) = (row.bar(&pair[0]), row.bar(&pair[1]));
                        assert!(a.right() <= b.x, "{what}: {a:?} and {b:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn what_rays_meet_is_not_named_beyond_the_next_question() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::FLOOR, 2);
    let found = fixture.first("Found");
    fixture.go_to("Through", 0);
    let named = |waiting| {
        let input = PanelInput {
            waiting,
            ..fixture.input()
        };
        let picture = draw(&input, Vec2::new(1400.0, 120.0));
        let said = texts(&picture).into_iter().map(|(text, _)| text.to_owned());
        let said: Vec<String> = said.filter(|text| text.contains('→')).collect();
        said
    };
    assert!(!named(None).is_empty(), "nothing hides what is ahead");
    assert_eq!(named(Some(found - 1)), Vec::<String>::new());
    let first = named(Some(found));
    assert!(
        first.iter().all(|text| text.contains("→ floor")),
        "{first:?}"
    );
    assert!(!first.is_empty());
}

#[test]
fn every_scope_lies_in_exactly_one_bar_of_its_row() {
    let fixture = Fixture::triangle(Method::Gouraud);
    let outline = fixture.walk().outline();
    for width in [200.0, 900.0, 1e5] {
        let span = Span::new(0..outline.len(), Rect::new(0.0, 0.0, width, 20.0));
        for depth in 0..5 {
            let bars = bars(outline, &span, depth);
            let scopes = (0..outline.len())
                .filter(|&step| outline.opens(step) && outline.depth(step) == depth);
            for scope in scopes {
                let wide = (outline.last(scope) + 1 - scope) as f64 * span.scale >= 2.0 * NARROWEST;
                let within = bars.iter().filter(|bar| bar.steps.contains(&scope)).count();
                assert!(
                    within == 1 || !wide && within == 0,
                    "{scope} at depth {depth}"
                );
            }
        }
    }
}

#[test]
fn the_current_scope_of_each_row_is_named_and_no_two_bars_of_a_scope_read_the_same() {
    let lit = Method::ALL.map(fixtures::fixtures);
    let others = [fixtures::rays(Method::RayTracing, 2), fixtures::hinge()];
    for mut fixture in lit.into_iter().chain(others).chain(fixtures::solvers()) {
        for step in fixture.some_steps(997) {
            fixture.seek(step);
            for (size, language) in SIZES
                .into_iter()
                .flat_map(|size| Language::ALL.map(|l| (size, l)))
            {
                let what = format!("{} {step} at {size}", fixture.walk().kind(step));
                let picture = draw(&fixture.show_in(language), size);
                let texts = texts(&picture);
                for row in rows(fixture.walk(), size) {
                    let within =
                        |rect: &Rect| row.place.y <= rect.y && rect.bottom() <= row.place.bottom();
                    let here = texts.iter().filter(|(_, rect)| within(rect));
                    let mut seen = HashSet::new();
                    let mut named = false;
                    for (text, rect) in here {
                        let bar = row
                            .bars
                            .iter()
                            .find(|bar| row.bar(bar).contains(rect.center()));
                        let scope = bar.map(|bar| bar.steps.start);
                        if let Some(scope) = scope {
                            let around = fixture.walk().outline().parent(scope);
                            assert!(seen.insert((around, *text)), "{what}: a second {text}");
                        }
                        // A long word may be shortened to the left of the bars.
                        let begins = text.trim_end_matches('…');
                        named |= row.current.is_some_and(|current| {
                            let names =
                                names::scope_known_at(&fixture.run, current, usize::MAX, language);
                            scope.is_none_or(|scope| scope == current)
                                && names.iter().any(|name| name.starts_with(begins))
                        });
                    }
                    assert!(
                        named || row.current.is_none(),
                        "{what}: the current scope has no name"
                    );
                }
            }
        }
    }
}

#[test]
fn a_click_at_the_cursor_stays() {
    let mut fixture = Fixture::triangle(Method::Gouraud);
    let size = Vec2::new(900.0, 140.0);
    for step in 0..fixture.walk().len() {
        fixture.seek(step);
        let input = fixture.input();
        let span = Span::new(0..fixture.walk().len(), track(size));
        assert_eq!(step_at(&input, size, span.middle(step)), step);
    }
    let last = fixture.walk().len() - 1;
    assert_eq!(step_at(&fixture.input(), size, -50.0), 0);
    assert_eq!(step_at(&fixture.input(), size, 5000.0), last);
    assert_eq!(step_at(&fixtures::nothing().input(), size, 300.0), 0);
}

#[test]
fn a_million_scopes_are_few_bars_that_together_hold_all_of_them() {
    let mut recording = Recording::new(RecordingLimit::default());
    for _ in 0..1_000_000 {
        recording.enter(|| ());
        recording.step(|| ());
        recording.leave(|| ());
    }
    let outline = Outline::of(&recording);
    let span = Span::new(0..outline.len(), Rect::new(0.0, 0.0, 1200.0, 20.0));
    let bars = bars(&outline, &span, 0);
    assert!(bars.len() <= 400, "{}", bars.len());
    assert_eq!(bars[0].steps.start, 0);
    assert_eq!(bars[bars.len() - 1].steps.end, outline.len());
    assert!(
        bars.windows(2)
            .all(|pair| pair[0].steps.end == pair[1].steps.start)
    );
}

#[test]
fn marks_keep_their_distance() {
    let span = Span::new(0..1000, Rect::new(0.0, 0.0, 500.0, 20.0));
    assert_eq!(apart(&[0, 3, 14, 20, 999, 5000], &span, 7.0), [0, 14, 999]);
}

#[test]
fn nothing_recorded_is_said() {
    let fixture = fixtures::nothing();
    for language in Language::ALL {
        assert_legible(&draw(&fixture.show_in(language), SIZES[0]), "empty");
    }
}

#[test]
fn iterations_and_gathering_patches_show_their_numbers() {
    for fixture in fixtures::solvers() {
        let walk = fixture.walk();
        for step in (0..walk.len()).filter(|&step| walk.outline().opens(step)) {
            let (field, kind) = match walk.kind(step) {
                "Iteration" => ("k", "iteration"),
                "Gathering" | "Shooting" => ("i", "patch"),
                _ => continue,
            };
            let Some(Value::Integer(number)) = walk.own_fields(step).get(field) else {
                panic!("{kind} has {field}");
            };
            let shown = names::scope_number(walk, step, Language::English);
            assert_eq!(shown, Some(number.to_string()));
            assert_eq!(
                names::scope_kind(walk.declared(step), Language::English),
                kind
            );
        }
    }
}

#[test]
fn every_scope_of_every_method_has_a_name_and_its_line_a_label() {
    let shaded = Method::ALL.map(fixtures::fixtures);
    let rays = [
        fixtures::rays(Method::RayCasting, 2),
        fixtures::rays(Method::RayTracing, 1),
    ];
    let light = fixtures::solvers()
        .into_iter()
        .chain(fixtures::form_factors());
    for fixture in shaded.into_iter().chain(rays).chain(light) {
        let walk = fixture.walk();
        for step in 0..walk.len() {
            let line = walk.line(step);
            assert!(
                !line.listing.lines[line.number].0.is_empty(),
                "{}",
                walk.kind(step)
            );
            if walk.outline().opens(step) {
                assert!(
                    walk.declared(step).scope.is_some(),
                    "{} has no name",
                    walk.kind(step)
                );
            }
        }
    }
}
