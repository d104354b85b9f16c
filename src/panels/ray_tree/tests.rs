use super::super::fixture::{BALL, FLOOR, Fixture, SKY, SPARK, rays_scene};
use super::super::fixtures::{assert_steps_are_legible, fixtures, nothing, texts, views_in_turn};
use super::super::strings::Language;
use super::*;
use crate::picture::{Shape, Tag};
use crate::record::Value;
use crate::render::Method;

pub(super) fn all_words(picture: &Picture) -> String {
    let strings: Vec<&str> = texts(picture).into_iter().map(|(text, _)| text).collect();
    strings.join("\n")
}

#[test]
fn nothing_overlaps_or_is_cut_at_any_step_and_size() {
    let samples = [
        (Fixture::rays(Method::RayTracing, BALL, 5), 97),
        (Fixture::rays(Method::RayTracing, SPARK, 3), 997),
        (Fixture::rays(Method::RayTracing, SKY, 5), 997),
        (Fixture::rays(Method::RayCasting, FLOOR, 5), 997),
        (fixtures(Method::Gouraud), 10_000),
        (nothing(), 1),
    ];
    for (mut fixture, stride) in samples {
        assert_steps_are_legible(&mut fixture, stride, &views_in_turn(), draw);
    }
}

pub(super) fn rays_of(fixture: &Fixture) -> &State {
    fixture.run.rays().expect("the sample follows rays")
}

#[test]
fn sums_and_light_are_those_recorded() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 5);
    let size = Vec2::new(900.0, 700.0);
    for (kind, name) in [
        ("BranchAdded", "I_sum"),
        ("Local", "I_local"),
        ("Returned", "I"),
    ] {
        for n in 0..5 {
            fixture.go_to(kind, n);
            let walk = fixture.walk();
            let recorded = walk.own_fields(walk.position()).get(name).unwrap();
            let Value::Rgb(recorded) = recorded else {
                panic!("{name} is a colour")
            };
            let said = all_words(&draw(&fixture.input(), size));
            assert!(
                said.contains(&node::color(recorded, Language::English)),
                "{kind} {n}: {recorded:?} in {said}"
            );
        }
    }
}

#[test]
fn the_way_of_the_light_is_an_equation_of_recorded_values() {
    let mut scene = rays_scene();
    scene.path_attenuation = [1.0, 0.5, 0.0];
    let mut fixture = Fixture::rays_of(scene, Method::RayTracing, FLOOR, 5);
    fixture.go_to("BranchAdded", 0);
    let fields = fixture.walk().fields(fixture.first("Attenuated"));
    let Some(Value::Number(divisor)) = fields.get("divisor") else {
        panic!("a divisor is recorded")
    };
    let size = Vec2::new(900.0, 700.0);
    let said = all_words(&draw(&fixture.input(), size)).replace('\n', " ");
    let state = rays_of(&fixture);
    let describer = Describer {
        state,
        language: Language::English,
    };
    let [floor, ball] = [0, 1].map(|index| state.rays.get(index).unwrap());
    let light = node::bracketed(ball.returned.unwrap().0, Language::English);
    let expected = format!("+ 0.2·{light}/{}", Language::English.short(divisor, 2));
    assert!(said.contains(&expected), "{expected} in {said}");
    assert!(card::sections::sum(&describer, floor)[0].starts_with("floor → "));
    assert!(
        said.contains(&card::sections::sum(&describer, ball).join(" ")),
        "{said}"
    );
}

#[test]
fn a_blocked_light_names_what_blocks_it() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 5);
    let blocked = (0..fixture.walk().len())
        .find(|&step| {
            let fields = fixture.walk().own_fields(step);
            fixture.walk().kind(step) == "Shadow"
                && fields.get("blocked") == Some(Value::Truth(true))
        })
        .unwrap();
    fixture.seek(blocked);
    let fields = fixture.walk().own_fields(blocked);
    let Some(Value::Number(t)) = fields.get("t") else {
        panic!("t is recorded")
    };
    for (language, strings) in Language::ALL
        .into_iter()
        .zip(["blocked by", "terhalang oleh"])
    {
        let picture = draw(&fixture.show_in(language), Vec2::new(900.0, 700.0));
        let said = all_words(&picture);
        let name = rays_of(&fixture).prepared.scene.objects[3].name.clone();
        assert!(
            said.contains(&format!("{strings} {name}, t {}", language.short(t, 2))),
            "{said}"
        );
        assert!(picture.alt.contains(&name), "{}", picture.alt);
        assert!(picture.tagged_bounds(Tag::Step(blocked)).is_some());
    }
}

#[test]
fn total_internal_reflection_is_marked() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 5);
    fixture.go_to("TotalInternalReflection", 0);
    let picture = draw(&fixture.input(), Vec2::new(1400.0, 900.0));
    let said = all_words(&picture);
    assert!(
        said.contains("no transmitted ray") && said.contains("not traced yet"),
        "{said}"
    );
    assert!(picture.alt.contains("total internal reflection"));
    // Its ray, once it is traced, hangs on an edge of its own kind.
    let step = fixture.walk().position() + 1;
    fixture.seek(step);
    let picture = draw(&fixture.input(), Vec2::new(900.0, 700.0));
    let edge = picture.items.iter().find(|item| {
        let stroke = match &item.shape {
            Shape::Polyline { stroke, .. } => *stroke,
            _ => return false,
        };
        item.tag == Some(Tag::Scope(step)) && stroke == line(RayKind::TotalInternalReflection)
    });
    assert!(edge.is_some());
    assert!(all_words(&picture).contains("TIR"));
}

#[test]
fn leaves_say_why_they_end() {
    let said = |pixel, depth| {
        let mut fixture = Fixture::rays(Method::RayTracing, pixel, depth);
        let last = fixture.walk().len() - 1;
        all_words(&draw(&fixture.seek(last).input(), Vec2::new(1400.0, 900.0)))
    };
    assert!(said(BALL, 5).contains("depth reached"));
    assert!(said(BALL, 5).contains("leaves the scene"));
    assert!(said(SPARK, 3).contains("light 0"));
    assert!(said(FLOOR, 5).contains("T: no coefficient"));
}

#[test]
fn a_node_and_its_edge_lead_to_the_step_that_opened_the_ray() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 5);
    let last = fixture.walk().len() - 1;
    fixture.seek(last);
    let picture = draw(&fixture.input(), Vec2::new(690.0, 620.0));
    for ray in rays_of(&fixture).rays.iter() {
        let tag = Tag::Scope(ray.step);
        let items = picture.items.iter().filter(|item| item.tag == Some(tag));
        // A primary ray has no edge.
        assert!(items.count() >= if ray.parent.is_some() { 2 } else { 1 });
    }
}
