use super::super::fixture::Fixture;
use super::super::fixtures::{
    SIZES, WALLS, all_views, assert_legible, assert_steps_are_legible, crowded, form_factors,
    nothing, open_room, texts,
};
use super::super::names::scope_known_at;
use super::super::strings::Language;
use super::*;
use crate::algorithms::enclosure;
use crate::algorithms::form_factor::Method;
use crate::picture::{Dash, Shape, Tag};
use crate::replay::moves::next_scope;

#[test]
fn every_step_is_legible_at_every_size() {
    for mut fixture in form_factors() {
        assert_steps_are_legible(&mut fixture, 97, &all_views(), draw);
    }
}

#[test]
fn at_the_end_the_value_stands_beside_the_reference() {
    for mut fixture in form_factors() {
        let last = fixture.walk().len() - 1;
        fixture.seek(last);
        let fields = fixture.walk().own_fields(last);
        let Some(crate::record::Value::Number(f)) = fields.get("F_ij") else {
            panic!("the last step has F");
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
    let has = |fixture: &&mut Fixture| {
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

/// Rays from wall to wall of the open room, past the screen between them.
fn rays(count: u32) -> Fixture {
    let settings = enclosure::Settings {
        form_factors: Method::MonteCarlo {
            rays: count,
            seed: 0,
        },
        ..enclosure::Settings::default()
    };
    let [i, j] = WALLS;
    open_room(settings, Focus::FormFactor { i, j })
}

#[test]
fn batches_of_samples_have_scopes_of_their_own() {
    for (fixture, kind) in [(rays(100), "rays"), (crowded(), "lines of sight")] {
        let walk = fixture.walk();
        let scopes = (0..walk.len()).filter(|&step| matches!(walk.kind(step), "Rays" | "Sights"));
        let named =
            scopes.map(|step| scope_known_at(&fixture.run, step, usize::MAX, Language::English));
        let named: Vec<String> = named.map(|mut names| names.swap_remove(0)).collect();
        assert_eq!(
            named[..2],
            [format!("{kind} 1–16"), format!("{kind} 17–64")]
        );
        if kind == "rays" {
            assert_eq!(named[2..], [format!("{kind} 65–100")]);
        }
        // One move goes over all samples of a batch.
        let mut steps = 0..walk.len();
        let first = steps.find(|&step| matches!(walk.kind(step), "Rays" | "Sights"));
        let mut fixture = fixture;
        fixture.seek(first.expect("a batch"));
        let next = fixture.walk().target(next_scope).expect("another batch");
        assert!(matches!(fixture.walk().kind(next), "Rays" | "Sights"));
    }
}

#[test]
fn the_band_narrows_as_the_share_settles() {
    let mut fixture = rays(1024);
    let last = fixture.walk().len() - 1;
    let mut bands = |step| {
        fixture.seek(step);
        let picture = draw(&fixture.input(), Vec2::new(800.0, 500.0));
        let bands = picture.items.iter().filter_map(|item| match &item.shape {
            Shape::Polyline { points, stroke } if stroke.width == 2.0 => {
                let is_upright = points.len() == 2 && points[0].x == points[1].x;
                is_upright.then(|| (points[0].y - points[1].y).abs())
            }
            _ => None,
        });
        (bands.collect::<Vec<f32>>(), picture)
    };
    let (early, _) = bands(10);
    let (late, picture) = bands(last);
    assert!(early.is_empty(), "no batch is over: {early:?}");
    assert_eq!(late.len(), 4, "16, 64, 256, 1024");
    // Of the first rays none has met yet, and the formula says nothing of them.
    assert!(
        late[1..].windows(2).all(|pair| pair[1] < pair[0]),
        "{late:?}"
    );
    // The band is named, with its formula.
    let printed = texts(&picture);
    let has = |part: &str| printed.iter().any(|(text, _)| text.contains(part));
    assert!(
        has("standard error") && has("s = √(F (1 − F) / n)"),
        "{printed:?}"
    );
}

#[test]
fn old_sight_lines_fade_and_what_stands_between_is_drawn_over_them() {
    let mut fixture = rays(400);
    let last = (0..fixture.walk().len()).rfind(|&step| fixture.walk().kind(step) == "Ray");
    fixture.seek(last.expect("a ray"));
    let picture = draw(&fixture.input(), Vec2::new(800.0, 500.0));
    let lines = picture.items.iter().enumerate();
    let old: Vec<(usize, f32)> = lines
        .filter_map(|(at, item)| match (&item.shape, item.tag) {
            (Shape::Polyline { stroke, .. }, Some(Tag::Step(_)))
                if stroke.ink == Ink::Muted && stroke.dash == Dash::Dotted =>
            {
                Some((at, stroke.opacity))
            }
            _ => None,
        })
        .collect();
    assert!(old.len() > 20, "{}", old.len());
    let (first, last) = (old[0], old[old.len() - 1]);
    assert!(first.1 < 0.1 * last.1, "{first:?} {last:?}");
    let outline = picture.items.iter().rposition(|item| match &item.shape {
        Shape::Polyline { stroke, .. } => item.tag.is_none() && stroke.ink == Ink::Muted,
        _ => false,
    });
    assert!(outline.expect("the screen") > last.0);
}

#[test]
fn a_second_method_begins_anew_and_comes_near_the_first() {
    let rays = 1024;
    let settings = enclosure::Settings {
        form_factors: Method::AreaToArea { points: 2 },
        then_by: Some(Method::MonteCarlo { rays, seed: 0 }),
        ..enclosure::Settings::default()
    };
    let [i, j] = WALLS;
    let mut fixture = open_room(settings, Focus::FormFactor { i, j });
    let found = |fixture: &Fixture| match fixture.run {
        Run::FormFactor(_, ref replay) => replay.state().found.map(|(f, _)| f),
        _ => None,
    };
    fixture.go_to("FormFactorFound", 0);
    let first = found(&fixture).expect("a form factor");
    fixture.go_to("Rays", 0);
    assert_eq!(found(&fixture), None);
    let picture = draw(&fixture.input(), Vec2::new(800.0, 500.0));
    let printed = texts(&picture);
    let has_value = printed.iter().any(|(text, _)| text.starts_with("F_i_j "));
    assert!(!has_value, "{printed:?}");
    fixture.go_to("FormFactorFound", 1);
    let second = found(&fixture).expect("another");
    let error = (first * (1.0 - first) / f64::from(rays)).sqrt();
    assert!(
        second != first && (second - first).abs() < 4.0 * error,
        "{first} {second}"
    );
}
