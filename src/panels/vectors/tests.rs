use super::super::fixture::{self, Fixture};
use super::super::fixtures::{self, assert_steps_are_legible, texts, views_in_turn};
use super::super::names;
use super::super::strings::Language;
use super::*;
use crate::picture::Tag;
use crate::record::Value;
use crate::render::Method;

const LARGE: Vec2 = Vec2::new(700.0, 500.0);

fn printed(picture: &Picture) -> Vec<&str> {
    texts(picture).into_iter().map(|(text, _)| text).collect()
}

#[test]
fn every_step_is_legible_at_every_size() {
    for mut fixture in [
        Fixture::rays(Method::RayTracing, fixture::BALL, 5),
        Fixture::rays(Method::RayTracing, fixture::SPARK, 5),
        fixtures::rays(Method::RayTracing, 1),
        fixtures::rays(Method::RayCasting, 1),
        fixtures::fixtures(Method::Gouraud),
        fixtures::nothing(),
    ] {
        assert_steps_are_legible(&mut fixture, 251, &views_in_turn(), draw);
    }
}

#[test]
fn what_the_ray_tree_names_is_met_here_too() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    let found = fixture.first("Found");
    let words = |fixture: &Fixture| printed(&draw(&fixture.input(), LARGE)).join(" ");
    assert!(words(fixture.seek(found - 1)).contains("has met no surface yet"));
    let said = words(fixture.seek(found));
    let hit = fixture.run.rays().unwrap().ray().unwrap().met.unwrap();
    let t = Language::English.number(hit.t());
    assert!(
        said.contains(&format!("meets glass ball, at t {t}.")),
        "{said}"
    );
}

#[test]
fn indices_of_refraction_have_the_decimal_sign_of_the_language() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("Refraction", 0);
    for (language, index) in [
        (Language::English, "η 1.5"),
        (Language::Indonesian, "η 1,5"),
    ] {
        let picture = draw(&fixture.show_in(language), LARGE);
        let said = printed(&picture);
        assert!(said.iter().any(|text| text.ends_with(index)), "{said:?}");
    }
}

#[test]
fn angles_are_those_of_the_steps() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    for (kind, n, name) in [
        ("Faced", 0, "theta_i_degrees"),
        ("Refraction", 0, "theta_r_degrees"),
        ("Refraction", 1, "theta_c_degrees"),
    ] {
        fixture.go_to(kind, n);
        let recorded = fixture
            .walk()
            .own_fields(fixture.walk().position())
            .get(name);
        let Some(Value::Number(angle)) = recorded else {
            panic!("{kind} {n} has {name}")
        };
        let shown = format!("{}°", Language::English.short(angle, 1));
        let picture = draw(&fixture.input(), LARGE);
        assert!(
            printed(&picture).contains(&shown.as_str()),
            "{name} = {shown}"
        );
        assert!(picture.tagged_bounds(Tag::Field(name)).is_some());
    }
}

#[test]
fn where_nothing_passes_there_is_no_transmitted_ray() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    fixture.go_to("TotalInternalReflection", 0);
    let picture = draw(&fixture.input(), LARGE);
    let printed = printed(&picture);
    assert!(printed.contains(&"no T") && printed.contains(&"TIR"));
    assert!(!printed.contains(&"T"));
    assert!(
        picture.alt.contains("total internal reflection"),
        "{}",
        picture.alt
    );
}

#[test]
fn a_mirrored_direction_leaves_at_the_angle_at_which_the_ray_came() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::FLOOR, 5);
    fixture.go_to("Reflection", 0);
    let state = fixture.run.rays().expect("a ray tracer's run");
    let surface = SurfaceInSight::of(state).expect("the floor");
    let u = surface.project(surface.ray.ray.direction);
    let sent = surface.ray.branches[0]
        .and_then(|branch| branch.branch)
        .expect("mirrored");
    let r = surface.project(sent.direction);
    // y is down: the ray comes from above and leaves upward.
    assert!(u.y > 0.0 && (u.x - r.x).abs() < 1e-6 && (u.y + r.y).abs() < 1e-6);
    assert!(surface.lean(sent.direction) < 1e-6);
}

#[test]
fn media_are_named_outside_and_inside() {
    let mut fixture = Fixture::rays(Method::RayTracing, fixture::BALL, 5);
    for n in [0, 1] {
        fixture.go_to("Refraction", n);
        let picture = draw(&fixture.input(), LARGE);
        let printed = printed(&picture);
        assert!(printed.contains(&"air  η 1"), "{printed:?}");
        assert!(printed.contains(&"glass ball  η 1.5"), "{printed:?}");
    }
}

#[test]
fn a_blocked_light_says_by_what() {
    let mut fixture = fixtures::rays(Method::RayTracing, 1);
    let walk = fixture.walk();
    let blocked = (0..walk.len())
        .find(|&step| walk.own_fields(step).get("blocked") == Some(Value::Truth(true)))
        .expect("a shadow");
    let fields = walk.own_fields(blocked);
    let Some(Value::Integer(object)) = fields.get("blocker") else {
        panic!("a blocker")
    };
    fixture.seek(blocked);
    let prepared = fixture.run.prepared();
    let name = names::object(prepared, object as u32, Language::English);
    let alt = draw(&fixture.input(), LARGE).alt;
    assert!(alt.contains(&format!("blocked by {name}")), "{alt}");
}
