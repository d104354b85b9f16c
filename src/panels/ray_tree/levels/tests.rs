use super::super::draw;
use super::super::tests::{all_words, rays_of};
use super::*;
use crate::language::Language;
use crate::panels::fixture::{BALL, FLOOR, Fixture, SPARK, rays_scene};
use crate::panels::fixtures::{assert_legible, rays, texts};
use crate::record::Value;
use crate::render::Method;
use glam::Vec2;

const KEY_PANEL: Vec2 = Vec2::new(728.0, 584.0);

fn sum_of(levels: &[Option<Rgb>]) -> Rgb {
    levels.iter().flatten().copied().sum()
}

fn assert_equal(a: Rgb, b: Rgb, what: &str) {
    let far = (a - b)
        .channels()
        .map(f64::abs)
        .into_iter()
        .fold(0.0, f64::max);
    assert!(far <= 1e-12, "{what}: {a:?} and {b:?}");
}

#[test]
fn levels_sum_to_the_light_of_the_primary_ray_at_every_step() {
    let samples = [
        Fixture::rays(Method::RayTracing, BALL, 5),
        Fixture::rays(Method::RayTracing, SPARK, 5),
        // Attenuated on the way, several pixels, several samples.
        rays(Method::RayTracing, 2),
    ];
    for mut fixture in samples {
        let mut compared = 0;
        let stride = fixture.walk().len().div_ceil(2000);
        for step in (0..fixture.walk().len()).step_by(stride) {
            fixture.seek(step);
            let state = rays_of(&fixture);
            let Some(primary) = state.rays.get(0) else {
                continue;
            };
            let so_far = primary.returned.map(|(light, _)| light).or(primary.sum);
            let sum = sum_of(&state.light_by_level());
            assert_equal(sum, so_far.unwrap_or(Rgb::BLACK), &format!("step {step}"));
            compared += 1;
        }
        assert!(compared > 100);
    }
}

#[test]
fn at_the_end_the_levels_sum_to_the_recorded_pixel() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 5);
    let colored = fixture.first("PixelColored");
    let pixel = fixture.walk().own_fields(colored).get("color");
    let Some(Value::Rgb(pixel)) = pixel else {
        panic!("the pixel's colour is recorded")
    };
    let levels = rays_of(fixture.seek(colored)).light_by_level();
    assert_eq!(levels.len(), 5);
    assert!(levels.iter().all(Option::is_some));
    assert_equal(sum_of(&levels), pixel, "the pixel");
}

/// The floor mirrors the ball: the second level gives k_r·I/(a_0 + a_1·d), from the recorded values.
#[test]
fn a_level_gives_its_light_times_what_is_on_its_way() {
    let mut scene = rays_scene();
    scene.path_attenuation = [1.0, 0.5, 0.0];
    let mut fixture = Fixture::rays_of(scene, Method::RayTracing, FLOOR, 2);
    let colors = |fixture: &Fixture, kind: &str, name: &str| {
        let steps = (0..fixture.walk().len()).filter(|&step| fixture.walk().kind(step) == kind);
        let values = steps.map(|step| fixture.walk().own_fields(step).get(name));
        values
            .map(|value| match value {
                Some(Value::Rgb(color)) => color,
                Some(Value::Number(number)) => Rgb::splat(number),
                other => panic!("{kind} records {name}: {other:?}"),
            })
            .collect::<Vec<_>>()
    };
    let local = colors(&fixture, "Local", "I_local");
    let [k] = colors(&fixture, "Reflection", "k_r")[..1] else {
        panic!("the floor reflects")
    };
    let [d] = colors(&fixture, "Attenuated", "d")[..] else {
        panic!("one ray comes back")
    };
    let last = fixture.walk().len() - 1;
    let levels = rays_of(fixture.seek(last)).light_by_level();
    assert_eq!(levels[0], Some(local[0]));
    let divisor = 1.0 + 0.5 * d.channels()[0];
    assert_equal(levels[1].unwrap(), k * local[1] / divisor, "level 2");
}

#[test]
fn the_row_writes_each_level_and_a_dash_until_its_light_has_come() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 4);
    let last = fixture.walk().len() - 1;
    for (step, known) in [(fixture.first("BranchAdded") - 1, 1), (last, 4)] {
        fixture.seek(step);
        let levels = rays_of(&fixture).light_by_level();
        assert_eq!(levels.iter().flatten().count(), known, "step {step}");
        let picture = draw(&fixture.input(), KEY_PANEL);
        let top = texts(&picture)
            .into_iter()
            .find(|(text, _)| *text == "light from level")
            .map(|(_, place)| place.y)
            .expect("the row has a name");
        let row: Vec<&str> = texts(&picture)
            .into_iter()
            .filter(|(_, place)| (top - 2.0..top + 3.0 * LINE).contains(&place.y))
            .map(|(text, _)| text)
            .collect();
        for light in levels.iter().flatten() {
            assert!(row.contains(&&*color(*light, Language::English)), "{row:?}");
        }
        assert_eq!(row.contains(&NOT_KNOWN), known < levels.len(), "{row:?}");
    }
}

#[test]
fn many_levels_share_the_row_and_the_last_names_those_below() {
    let mut fixture = Fixture::rays(Method::RayTracing, (150, 260), 16);
    let last = fixture.walk().len() - 1;
    fixture.seek(last);
    assert!(rays_of(&fixture).light_by_level().len() > 10);
    for language in Language::ALL {
        let input = fixture.show_in(language);
        let picture = draw(&input, Vec2::new(320.0, 560.0));
        assert_legible(&picture, "a narrow row");
        assert!(all_words(&picture).contains('–'));
    }
}

#[test]
fn a_run_of_one_level_has_no_row() {
    for (method, depth) in [(Method::RayCasting, 5), (Method::RayTracing, 1)] {
        let mut fixture = Fixture::rays(method, FLOOR, depth);
        let last = fixture.walk().len() - 1;
        let picture = draw(&fixture.seek(last).input(), KEY_PANEL);
        assert!(!all_words(&picture).contains("light from level"));
    }
}
