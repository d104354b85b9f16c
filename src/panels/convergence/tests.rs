use super::super::fixture::Fixture;
use super::super::fixtures::{self, assert_steps_are_legible, views_in_turn};
use super::*;
use crate::algorithms::focus::Focus;
use crate::algorithms::radiosity::Solver;
use crate::picture::Shape;
use crate::render::Method;

const SIZE: Vec2 = Vec2::new(480.0, 320.0);

fn recorded(fixture: &Fixture) -> impl Iterator<Item = usize> {
    let walk = fixture.walk();
    (0..walk.len()).filter(|&step| walk.kind(step) == "IterationDone")
}

#[test]
fn every_step_is_legible_at_every_size() {
    let iterations = Focus::Iterations { start: 5, end: 9 };
    for mut fixture in [
        Fixture::room(Solver::GaussSeidel, Focus::Frame),
        Fixture::room(Solver::Shooting, iterations),
        Fixture::room(Solver::Auto, Focus::Frame),
        Fixture::room(Solver::Direct, Focus::Patch(3)),
        Fixture::room(
            Solver::Jacobi,
            Focus::Iterations {
                start: u32::MAX - 1,
                end: u32::MAX,
            },
        ),
        Fixture::room(Solver::Auto, Focus::FormFactor { i: 0, j: 60 }),
        fixtures::fixtures(Method::Gouraud),
    ] {
        assert_steps_are_legible(&mut fixture, 9973, &views_in_turn(), draw);
    }
}

#[test]
fn a_click_on_a_point_goes_to_the_end_of_its_iteration() {
    let mut fixture = Fixture::room(Solver::GaussSeidel, Focus::Frame);
    fixture.go_to("RoomDone", 0);
    let picture = draw(&fixture.input(), SIZE);
    let steps: Vec<usize> = recorded(&fixture).collect();
    assert!(steps.len() > 6, "{} iterations", steps.len());
    for step in steps {
        let marks = picture.items.iter().filter(|item| {
            item.tag == Some(Tag::Step(step)) && matches!(item.shape, Shape::Circle { .. })
        });
        assert_eq!(marks.count(), 2, "residual and bound of step {step}");
    }
}

#[test]
fn the_iteration_in_hand_is_marked_and_a_smaller_residual_stands_lower() {
    let mut fixture = Fixture::room(Solver::Jacobi, Focus::Frame);
    let mut before = 0.0;
    for n in 0..3 {
        fixture.go_to("IterationDone", n);
        let picture = draw(&fixture.input(), SIZE);
        let marks: Vec<f32> = picture
            .items
            .iter()
            .filter_map(|item| match item.shape {
                Shape::Circle { center, paint, .. } if paint == Ink::This.fill() => Some(center.y),
                _ => None,
            })
            .collect();
        let [y] = marks[..] else {
            panic!("{} marks", marks.len());
        };
        assert!(y > before, "{y} {before}");
        before = y;
    }
}

#[test]
fn many_iterations_make_few_lines_that_end_at_the_last_one() {
    let mut fixture = Fixture::room(Solver::Shooting, Focus::Frame);
    fixture.go_to("RoomDone", 0);
    let picture = draw(&fixture.input(), SIZE);
    let lines = picture.items.iter().map(|item| match &item.shape {
        Shape::Polyline { points, .. } => points.len() - 1,
        _ => 0,
    });
    assert!(recorded(&fixture).count() > 200);
    assert!(lines.sum::<usize>() < 500);
    let last = recorded(&fixture).last().expect("iterations");
    assert!(picture.tagged_bounds(Tag::Step(last)).is_some());
}

#[test]
fn the_axis_spans_the_iterations_that_are_looked_at() {
    let shares = |focus, ks: [f64; 2]| {
        let mut fixture = Fixture::room(Solver::Shooting, focus);
        fixture.go_to("IterationDone", 2);
        let Run::Radiosity(_, replay) = &fixture.run else {
            panic!("the sample is a room");
        };
        let whole = Rect::new(0.0, 0.0, SIZE.x, SIZE.y);
        let input = fixture.input();
        let tolerance = input.run.enclosure().unwrap().settings.stop.tolerance;
        let iterations = Iterations::new(tolerance, replay.state(), &input, whole);
        ks.map(|k| iterations.plot.x.scale.share(k))
    };
    let focus = Focus::Iterations { start: 5, end: 9 };
    assert_eq!(shares(focus, [5.0, 8.0]), [0.0, 1.0]);
    let [first, second] = shares(Focus::Frame, [0.0, 1.0]);
    assert!(first == 0.0 && second < 1.0 / 200.0, "{second}");
}
