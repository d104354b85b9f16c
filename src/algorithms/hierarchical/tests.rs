use super::*;
use crate::algorithms::enclosure::{self, Enclosure};
use crate::algorithms::fixtures::{Cuboid, polygon, scene};
use crate::algorithms::radiosity::{Solver, Stop};
use crate::color::Rgb;
use crate::record::{Recording, RecordingLimit, Unrecorded};
use crate::scene::{Limits, Parts, Scene, read};
use std::convert::Infallible;

const GREY: &str = r#""reflectance": [0.5, 0.5, 0.5], "emission": [2, 2, 2]"#;

/// A unit cube of n × n patches a wall, whose ceiling shines; with further objects.
fn lit_cube(n: u32, more: &[String]) -> Scene {
    let walls = Cuboid::UNIT.corners(false);
    let mut objects: Vec<String> = (0..)
        .zip(walls)
        .map(|(number, wall)| polygon(&format!("wall{number}"), &wall, n))
        .collect();
    objects[5] = objects[5].replace(r#""material": "m""#, r#""material": "lamp""#);
    objects.extend_from_slice(more);
    let text = format!(
        r#"{{"schema": 1, "materials": {{ "m": {{"reflectance": [0.7, 0.5, 0.3]}}, "lamp": {{"emission": [1, 1, 1]}} }}, "objects": [{}]}}"#,
        objects.join(", ")
    );
    read(text.as_bytes(), &Limits::default(), &mut |_| unreachable!()).unwrap()
}

fn enclosure(scene: &Scene, tolerance: f64) -> Enclosure {
    let stop = Stop {
        tolerance,
        ..Stop::default()
    };
    let settings = enclosure::Settings {
        stop,
        solver: Solver::ConjugateGradients,
        ..Default::default()
    };
    Enclosure::of(scene, settings, Parts::NONE).unwrap()
}

fn solved(enclosure: &Enclosure, settings: Settings) -> Hierarchy<'_> {
    let mut hierarchy = Hierarchy::new(enclosure, settings);
    let Ok(settled) = hierarchy.solve(&mut Unrecorded, || Ok::<(), Infallible>(()));
    settled.unwrap();
    hierarchy
}

/// √(Σ A (B − B*)² / Σ A B*²), by the patches of the full solution.
fn error(hierarchy: &Hierarchy) -> f64 {
    let enclosure = hierarchy.enclosure;
    let matrix = enclosure.matrix_or(|| enclosure.form_factors().estimated());
    let full = &enclosure.light(matrix).unwrap().radiosity;
    let (mut off, mut all) = (0.0, 0.0);
    for ((b, right), patch) in hierarchy
        .by_patch()
        .iter()
        .zip(full)
        .zip(enclosure.patches.iter())
    {
        for (b, right) in b.channels().into_iter().zip(right.channels()) {
            off += patch.area * (b - right).powi(2);
            all += patch.area * right * right;
        }
    }
    (off / all).sqrt()
}

/// In a closed room of one material every point gets what it gives: B = E + ρB. Where patches gather as one, each of them gets their mean.
/// Its cylinder is made of polygons without area, which are left out.
#[test]
fn an_object_without_patches_changes_nothing() {
    let rod = r#"{"material": "m", "name": "rod", "cylinder": {"base": [0.5, 0.2, 0.5], "axis": [0, 1, 0], "height": 0.5, "radius": 1e-300}}"#;
    let [with, without] = [&[rod.to_string()][..], &[]].map(|more| {
        let enclosure = enclosure(&lit_cube(2, more), 1e-6);
        solved(&enclosure, Settings::default()).by_patch()
    });
    assert_eq!(with, without);
}

#[test]
fn a_furnace_comes_to_its_closed_form_as_links_are_refined() {
    let room = enclosure(&scene(GREY, &Cuboid::UNIT.room("wall", [8; 6])), 1e-9);
    let errors = [1e-2, 1e-3, 1e-4, 0.0].map(|link_light| {
        let settings = Settings {
            link_light,
            ..Settings::default()
        };
        let light = solved(&room, settings).by_patch();
        let off = light.iter().map(|b| (b.r / 4.0 - 1.0).abs());
        off.fold(0.0, f64::max)
    });
    assert!(
        errors.is_sorted_by(|coarse, fine| coarse > fine),
        "{errors:?}"
    );
    assert!(errors[3] < 1e-6, "{errors:?}");
}

#[test]
fn links_between_all_patches_give_the_full_solution() {
    let room = enclosure(&lit_cube(4, &[]), 1e-9);
    let hierarchy = solved(
        &room,
        Settings {
            link_size: 0.0,
            ..Settings::default()
        },
    );
    assert_eq!(hierarchy.link_count(), 6 * 5 / 2 * 16 * 16);
    assert!(error(&hierarchy) < 1e-4, "{}", error(&hierarchy));
}

#[test]
fn a_fine_room_is_within_one_percent_of_its_full_solution() {
    let room = enclosure(&lit_cube(12, &[]), 1e-7);
    let hierarchy = solved(&room, Settings::default());
    let pairs = room.patches.len() * (room.patches.len() - 1) / 2;
    assert!(error(&hierarchy) < 0.01, "{}", error(&hierarchy));
    assert!((hierarchy.link_count() as usize) < pairs / 2);
}

#[test]
fn what_stands_between_casts_its_shadow() {
    let block = Cuboid {
        low: [0.3, 0.2, 0.3],
        high: [0.7, 0.5, 0.7],
    };
    let room = enclosure(&lit_cube(8, &block.block("block", 4)), 1e-7);
    let hierarchy = solved(
        &room,
        Settings {
            link_light: 3e-5,
            ..Settings::default()
        },
    );
    assert!(error(&hierarchy) < 0.01, "{}", error(&hierarchy));
}

/// The tolerance of the form factor says how small an element is seen from another, and with it how many others an element is linked to.
#[test]
fn there_are_as_many_links_as_elements_times_a_constant() {
    let per_leaf = [8, 16, 32, 64].map(|n: u32| {
        let room = enclosure(&lit_cube(n, &[]), 1e-2);
        let finest = 1.0 / f64::from(n * n);
        // Divided until every pair of touching elements is of patches.
        let settings = Settings {
            link_size: 0.05,
            smallest_area: finest,
            passes: 0,
            ..Settings::default()
        };
        let hierarchy = solved(&room, settings);
        let leaves = hierarchy.tree.leaves().count();
        f64::from(hierarchy.link_count()) / leaves as f64
    });
    assert!(per_leaf[3] < 1.2 * per_leaf[1], "{per_leaf:?}");
}

#[test]
fn push_and_pull_keep_the_light_of_every_element() {
    let room = enclosure(&lit_cube(8, &[]), 1e-6);
    let hierarchy = solved(&room, Settings::default());
    let mut divided = 0;
    for (number, element) in hierarchy.tree.elements.iter().enumerate() {
        if element.children.is_none() {
            continue;
        }
        let of_children: Rgb = element
            .children()
            .map(|child| hierarchy.b[child as usize] * hierarchy.element(child).area)
            .sum();
        let whole = hierarchy.b[number] * element.area;
        let off = (of_children.r - whole.r).abs();
        assert!(
            off <= 4.0 * f64::EPSILON * whole.r,
            "{off:e} of {}",
            whole.r
        );
        divided += 1;
    }
    assert!(divided > 20);
}

#[test]
fn a_recorded_run_is_the_same_to_the_bit() {
    let room = enclosure(&lit_cube(4, &[]), 1e-6);
    let quiet = solved(&room, Settings::default());
    let mut recording = Recording::<Event>::new(RecordingLimit::default());
    let mut recorded = Hierarchy::new(&room, Settings::default());
    let Ok(settled) = recorded.solve(&mut recording, || Ok::<(), Infallible>(()));
    assert_eq!(settled, Ok(()));
    assert_eq!(recorded.b, quiet.b);
    assert!(recording.len() > 1000);
}

/// Links that are coarse keep no row of form factors at 1: those of early passes may gain light where little is lost.
#[test]
fn a_furnace_that_loses_little_light_settles_or_is_refused() {
    for (rho, loses) in [(0.99, true), (0.999, true), (1.0, false)] {
        let material = format!(r#""reflectance": [{rho}, {rho}, {rho}], "emission": [1, 1, 1]"#);
        let room = enclosure(&scene(&material, &Cuboid::UNIT.room("wall", [4; 6])), 1e-6);
        let mut hierarchy = Hierarchy::new(&room, Settings::default());
        let Ok(settled) = hierarchy.solve(&mut Unrecorded, || Ok::<(), Infallible>(()));
        assert_eq!(settled.is_ok(), loses, "{rho}: {settled:?}");
        assert!(hierarchy.sweeps < 20_000, "{rho}: {}", hierarchy.sweeps);
        for b in hierarchy.by_patch().iter().filter(|_| loses) {
            let exact = 1.0 / (1.0 - rho);
            assert!((b.r / exact - 1.0).abs() < 1e-2, "{rho}: {}", b.r);
        }
    }
}

#[test]
fn light_that_is_never_lost_does_not_settle() {
    let material = r#""reflectance": [1, 1, 1], "emission": [1, 1, 1]"#;
    let mut room = enclosure(&scene(material, &Cuboid::UNIT.room("wall", [2; 6])), 1e-6);
    room.settings.stop.max_iterations = 40;
    let mut hierarchy = Hierarchy::new(&room, Settings::default());
    let Ok(settled) = hierarchy.solve(&mut Unrecorded, || Ok::<(), Infallible>(()));
    assert!(matches!(
        settled,
        Err(Unsolved::Unsettled { sweeps: 40.., change }) if change > 1e-3
    ));
}
