use super::super::fixture::Fixture;
use super::super::fixtures::{self, all_views, assert_legible, assert_steps_are_legible};
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::radiosity::Solver;
use crate::language::Language;
use crate::picture::Shape;

const WIDE: Vec2 = Vec2::new(800.0, 500.0);

fn state(fixture: &Fixture) -> &State {
    match &fixture.run {
        Run::Hierarchical(_, replay) => replay.state(),
        _ => panic!("the sample has links"),
    }
}

/// The texts of a picture, formulas as they are written.
fn texts(picture: &Picture) -> Vec<&str> {
    let items = picture.items.iter();
    let texts = items.filter_map(|item| match &item.shape {
        Shape::Text { text, .. } => Some(text.as_str()),
        _ => None,
    });
    texts.collect()
}

#[test]
fn every_step_is_legible_at_every_size() {
    let mut views = all_views();
    views.push((Vec2::new(200.0, 150.0), Language::Indonesian));
    assert_steps_are_legible(&mut fixtures::linked(), 211, &views, draw);
}

#[test]
fn other_runs_and_panels_without_room_say_why_there_is_nothing_to_see() {
    let links = fixtures::linked();
    let one_by_one = Fixture::room(Solver::Auto, Focus::Frame);
    let polygons = fixtures::fixtures(crate::render::Method::Gouraud);
    let nothing = [
        (draw(&one_by_one.input(), WIDE), NO_LINKS),
        (draw(&polygons.input(), WIDE), NO_PATCHES),
        (draw(&links.input(), Vec2::new(120.0, 90.0)), TOO_SMALL),
    ];
    for (picture, why) in nothing {
        assert_eq!(picture.alt, why.text(Language::English));
    }
    let picture = draw(&links.input(), Vec2::new(200.0, 150.0));
    assert_ne!(picture.alt, TOO_SMALL.text(Language::English));
    assert_legible(&picture, "the smallest panel");
}

/// A link brings one to the step that made it.
#[test]
fn an_element_that_gathers_is_shown_with_every_link_that_brings_it_light() {
    let mut fixture = fixtures::linked();
    fixture.go_to("LinkGathered", 3);
    let shown = Shown::of(state(&fixture));
    let Chosen::Toward(p) = shown.chosen else {
        panic!("{:?}", shown.chosen)
    };
    let path = state(&fixture).path(p);
    assert!(path.len() <= 3 && !shown.links.is_empty());
    let picture = draw(&fixture.input(), WIDE);
    for (_, link) in state(&fixture).links() {
        let is_its = path.contains(&link.p) || path.contains(&link.q);
        let is_current = shown.is_current(&link);
        let tag = Tag::Step(link.step as usize);
        assert_eq!(picture.tagged_bounds(tag).is_some(), is_its && !is_current);
    }
}

/// Every pair of patches that see each other is covered by one link, so that there are no more links than pairs.
#[test]
fn the_levels_add_up_to_the_links_that_the_run_has_recorded() {
    let mut fixture = fixtures::linked();
    fixture.go_to("HierarchyDone", 0);
    let walk = fixture.walk();
    let Some(crate::record::Value::Integer(links)) = walk.own_fields(walk.position()).get("links")
    else {
        panic!("the last event has the links")
    };
    let levels = state(&fixture).links_by_level();
    assert!(levels.len() > 1);
    assert_eq!(levels.iter().sum::<usize>() as i64, links);
    let picture = draw(&fixture.input(), WIDE);
    let total = format!("links: {}", Language::English.number(links as f64));
    assert!(texts(&picture).iter().any(|text| text.contains(&total)));
}

#[test]
fn the_pair_that_is_refined_is_drawn_with_its_form_factor() {
    let mut fixture = fixtures::linked();
    fixture.go_to("Refining", 0);
    let picture = draw(&fixture.input(), WIDE);
    let walk = fixture.walk();
    let Some(crate::record::Value::Number(f)) = walk.own_fields(walk.position()).get("F_pq") else {
        panic!("the pair has a form factor")
    };
    let value = format!("F_{{pq}} = {}", Language::English.significant(f, 3));
    assert!(texts(&picture).contains(&&*value), "{:?}", texts(&picture));
    assert!(picture.alt.contains("Links between"), "{}", picture.alt);
}
