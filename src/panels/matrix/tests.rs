use super::super::fixture::Fixture;
use super::super::fixtures::{
    SIZES, all_views, assert_legible, assert_steps_are_legible, nothing, open_room, solvers, texts,
};
use super::super::patches::form_factor_values;
use super::*;
use crate::algorithms::enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::form_factor::Method;
use crate::algorithms::radiosity::Solver;
use crate::picture::Tag;

fn solved(solver: Solver) -> Fixture {
    let settings = enclosure::Settings {
        solver,
        ..enclosure::Settings::default()
    };
    open_room(settings, Focus::Frame)
}

fn at(fixture: &mut Fixture, kind: &str, size: [f32; 2]) -> Picture {
    let step = fixture.first(kind) + 1;
    fixture.seek(step);
    draw(&fixture.input(), size.into())
}

#[test]
fn every_step_is_legible_at_every_size() {
    for mut fixture in solvers() {
        assert_steps_are_legible(&mut fixture, 211, &all_views(), draw);
    }
}

#[test]
fn gathering_marks_a_row_and_shooting_a_column() {
    let size = [500.0, 400.0];
    for (solver, kind) in [
        (Solver::Jacobi, "Gathering"),
        (Solver::Shooting, "Shooting"),
    ] {
        let mut fixture = solved(solver);
        let picture = at(&mut fixture, kind, size);
        let Run::Radiosity(_, replay) = &fixture.run else {
            panic!("it is a run of radiosity");
        };
        let hand = Hand::of(replay.state()).expect("a patch is current");
        let line = picture.items.iter().find(|item| {
            let bounds = item.shape.bounds();
            item.tag == Some(Tag::Patch(hand.i)) && bounds.width.max(bounds.height) > 150.0
        });
        let bounds = line.expect("its line is marked").shape.bounds();
        assert_eq!(bounds.height > bounds.width, solver == Solver::Shooting);
    }
}

#[test]
fn a_cell_can_be_pointed_at_and_the_row_in_hand_is_written_out() {
    let mut fixture = solved(Solver::Jacobi);
    let picture = at(&mut fixture, "Gathering", [500.0, 400.0]);
    let cell = Tag::FormFactor { i: 3, j: 5 };
    let bounds = picture.tagged_bounds(cell).expect("the cell is there");
    assert_eq!(picture.hit(bounds.center()), Some(cell));
    let printed: Vec<&str> = texts(&picture).into_iter().map(|(text, _)| text).collect();
    assert!(printed.contains(&"E_i"), "{printed:?}");
    // A closed part of the diagonal: flat patches see nothing of themselves.
    assert!(printed.contains(&"1.000"), "{printed:?}");
}

#[test]
fn the_matrix_fills_its_panel_with_numbered_rows_and_columns_and_nothing_is_cut() {
    let mut fixture = solved(Solver::Jacobi);
    let step = fixture.first("Gathering") + 1;
    fixture.seek(step);
    let n = fixture.run.enclosure().expect("an enclosure").patches.len();
    for size in SIZES {
        let picture = draw(&fixture.input(), size);
        let cell = |i, j| {
            picture
                .tagged_bounds(Tag::FormFactor { i, j })
                .expect("a cell")
        };
        let map = cell(0, 0).union(&cell(n - 1, n - 1));
        let share = map.width * map.height / (size.x * size.y);
        assert!(share >= 0.25, "{share} of {size}");
        if size.min_element() >= 170.0 {
            assert!(share >= 0.4, "{share} of {size}");
        }
        let printed = texts(&picture);
        assert!(
            printed.iter().all(|(text, _)| !text.contains('…')),
            "{printed:?}"
        );
        for number in 0..n {
            let written = number.to_string();
            let beside = printed.iter().any(|(text, at)| {
                *text == written && at.right() <= map.x + 4.0 && map.height >= 15.0 * n as f32
            });
            let above = printed
                .iter()
                .any(|(text, at)| *text == written && at.bottom() <= map.y + 2.0);
            assert!(
                above && (beside || map.height < 15.0 * n as f32),
                "{number} at {size}"
            );
        }
    }
}

#[test]
fn a_cell_says_its_form_factor_unless_a_question_hides_it() {
    let fixture = solved(Solver::Jacobi);
    let room = fixture.run.enclosure().expect("an enclosure");
    let f = room.matrix().expect("a matrix")[3 * room.patches.len() + 4];
    let said = form_factor_values(&fixture.input(), [3, 4]).expect("a cell");
    assert!(said.starts_with(&format!(
        "F_{{3, 4}} = {}",
        Language::English.significant(f, 4)
    )));
    assert!(said.ends_with("j = 4: lamp"), "{said}");
    let input = PanelInput {
        pending: Some(&[]),
        ..fixture.input()
    };
    let hidden = form_factor_values(&input, [3, 4]).expect("a cell");
    assert!(hidden.starts_with("F_{3, 4} = ?"), "{hidden}");
}

#[test]
fn without_a_matrix_that_is_said() {
    let form_factors = Method::AreaToArea { points: 2 };
    let settings = enclosure::Settings {
        form_factors,
        ..enclosure::Settings::default()
    };
    for fixture in [
        nothing(),
        open_room(settings, Focus::FormFactor { i: 0, j: 2 }),
    ] {
        assert_legible(&draw(&fixture.input(), SIZES[0]), "no matrix");
    }
}

#[test]
fn the_row_in_question_is_said_with_its_form_factors() {
    let mut fixture = solved(Solver::Jacobi);
    let picture = at(&mut fixture, "Gathering", [500.0, 400.0]);
    let Run::Radiosity(_, replay) = &fixture.run else {
        panic!("it is a run of radiosity");
    };
    let hand = Hand::of(replay.state()).expect("a patch is in hand");
    let room = fixture.run.enclosure().expect("an enclosure");
    let n = room.patches.len();
    let row = &room.matrix().expect("a matrix")[hand.i * n..(hand.i + 1) * n];
    let prepared = fixture.run.prepared();
    let largest = (0..n).max_by(|&a, &b| row[a].total_cmp(&row[b]));
    let j = largest.expect("patches");
    let name = super::super::names::patch(prepared, room, j, Language::English);
    let said = format!("{name} {}", Language::English.number(row[j]));
    assert!(
        picture.alt.contains(&said),
        "{} without {said}",
        picture.alt
    );
}
