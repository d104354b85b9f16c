use super::super::pick::{self, Rays};
use super::super::places::Places;
use super::super::tests::{all_words, rays_of};
use super::super::{draw, node_near};
use super::*;
use crate::panels::PanelInput;
use crate::panels::fixture::{BALL, Fixture};
use crate::panels::fixtures::{SIZES, assert_legible, texts};
use crate::picture::Tag;
use crate::render::Method;
use crate::replay::rays::Outcome;

/// A tree of 200 rays and more: between the faces of the glass cube.
fn large() -> Fixture {
    let mut fixture = Fixture::rays(Method::RayTracing, (150, 260), 16);
    let last = fixture.walk().len() - 1;
    fixture.seek(last);
    fixture
}

/// All rays of `large`.
fn steps(fixture: &Fixture) -> Vec<usize> {
    rays_of(fixture).rays.iter().map(|ray| ray.step).collect()
}

#[test]
fn a_large_tree_is_legible_at_any_step_zoom_and_size() {
    let mut fixture = large();
    assert!(rays_of(&fixture).rays.len() > 200);
    let last = fixture.walk().len() - 1;
    for step in (0..=last).step_by(last / 5) {
        fixture.seek(step);
        for size in SIZES {
            for zoom in [1.0, 3.0, 20.0] {
                let tree = TreeView::WHOLE.zoomed(zoom, None);
                let input = PanelInput {
                    tree: &tree,
                    ..fixture.input()
                };
                let what = format!("step {step}, {size}, zoom {zoom}");
                assert_legible(&draw(&input, size), &what);
            }
        }
    }
}

#[test]
fn every_ray_is_drawn_or_counted_as_hidden() {
    let fixture = large();
    let count = rays_of(&fixture).rays.len();
    for size in SIZES {
        let rays = Rays::new(rays_of(&fixture));
        let tree = Places::new(&rays, TreeView::whole(), size).1.tree;
        assert_eq!(tree.nodes.len() + tree.hidden, count, "{size}");
        let said = all_words(&draw(&fixture.input(), size));
        assert_eq!(
            said.contains(&format!("{} not shown", tree.hidden)),
            tree.hidden > 0,
            "{said}"
        );
    }
}

#[test]
fn a_collapsed_ray_hides_what_is_below_and_counts_it() {
    let mut fixture = Fixture::rays(Method::RayTracing, BALL, 5);
    let last = fixture.walk().len() - 1;
    fixture.seek(last);
    let root = rays_of(&fixture).rays.get(0).unwrap().step;
    let size = Vec2::new(690.0, 620.0);
    let whole = draw(&fixture.input(), size);
    assert_eq!(
        whole.hit(whole.tagged_bounds(Tag::Fold(root)).unwrap().center()),
        Some(Tag::Fold(root))
    );
    let tree = TreeView::WHOLE.toggled(root);
    let folded = draw(
        &PanelInput {
            tree: &tree,
            ..fixture.input()
        },
        size,
    );
    assert!(all_words(&folded).contains("+13 rays"));
    assert!(folded.items.len() < whole.items.len());
    assert!(folded.tagged_bounds(Tag::Fold(root)).is_some());
}

#[test]
fn the_current_ray_stays_in_view_until_a_node_is_held() {
    let mut fixture = large();
    let size = Vec2::new(420.0, 320.0);
    let follow = TreeView::WHOLE.zoomed(6.0, None);
    for n in (0..200).step_by(40) {
        fixture.go_to("Local", n);
        let tag = Tag::Scope(rays_of(&fixture).ray().unwrap().step);
        let input = PanelInput {
            tree: &follow,
            ..fixture.input()
        };
        let rays = Rays::new(rays_of(&fixture));
        let area = Places::new(&rays, &follow, size).0.tree;
        let node = draw(&input, size).tagged_bounds(tag).unwrap();
        assert!(area.grown(1.0).encloses(&node), "{n}");
    }
    // A node of another branch is held, and the walk goes on.
    let held = HeldNode {
        ray: steps(&fixture)[1],
        at: Vec2::new(-20.0, 30.0),
    };
    let fixed = TreeView::WHOLE.zoomed(6.0, Some(held));
    for n in [120, 160] {
        fixture.go_to("Local", n);
        let input = PanelInput {
            tree: &fixed,
            ..fixture.input()
        };
        let near = node_near(&input, size, 0.5 * size).unwrap();
        let rays = Rays::new(rays_of(&fixture));
        let (places, arrangement) = Places::new(&rays, &fixed, size);
        let nodes = arrangement.tree.nodes.iter().zip(&arrangement.rects);
        let seen = nodes.filter(|(_, rect)| places.tree.encloses(rect));
        let steps: Vec<usize> = seen
            .filter_map(|(node, _)| Some(rays.ray(node)?.step))
            .collect();
        assert!(steps.contains(&held.ray), "{n}: {steps:?}, near {near:?}");
    }
}

#[test]
fn the_node_under_the_pointer_stays_there_when_it_zooms() {
    let fixture = large();
    let size = Vec2::new(728.0, 584.0);
    let at = Vec2::new(300.0, 120.0);
    let mut view = TreeView::WHOLE.zoomed(12.0, None);
    for factor in [1.3, 1.2, 0.9] {
        let input = PanelInput {
            tree: &view,
            ..fixture.input()
        };
        let near = node_near(&input, size, at).unwrap();
        let next = view.zoomed(factor, Some(near));
        let input = PanelInput {
            tree: &next,
            ..fixture.input()
        };
        let middle = {
            let rays = Rays::new(rays_of(&fixture));
            Places::new(&rays, &next, size).0.tree.center()
        };
        let after = node_near(&input, size, middle + near.at).unwrap();
        assert_eq!(after.ray, near.ray);
        view = next;
    }
}

#[test]
fn zoomed_and_dragged_anywhere_a_node_is_in_view() {
    let fixture = large();
    let far = [-1e5, -900.0, -150.0, 0.0, 150.0, 900.0, 1e5];
    for size in [SIZES[0], SIZES[2], Vec2::new(728.0, 584.0)] {
        for zoom in [1.0, 2.0, 5.0, 12.0, 32.0] {
            for ray in steps(&fixture).into_iter().step_by(60) {
                for at in far.into_iter().flat_map(|x| far.map(|y| Vec2::new(x, y))) {
                    let tree = TreeView::WHOLE.zoomed(zoom, Some(HeldNode { ray, at }));
                    let rays = Rays::new(rays_of(&fixture));
                    let (places, arrangement) = Places::new(&rays, &tree, size);
                    let area = places.tree.grown(0.5);
                    assert!(
                        arrangement.rects.iter().any(|rect| area.encloses(rect)),
                        "{size}, zoom {zoom}, ray {ray} at {at}"
                    );
                }
            }
        }
    }
}

#[test]
fn zoomed_in_nodes_say_all_they_have_to_say() {
    let fixture = large();
    let tree = TreeView::WHOLE.zoomed(32.0, None);
    let input = PanelInput {
        tree: &tree,
        ..fixture.input()
    };
    let picture = draw(&input, Vec2::new(728.0, 584.0));
    let said: Vec<&str> = texts(&picture).into_iter().map(|(text, _)| text).collect();
    let root = rays_of(&fixture).rays.get(0).unwrap();
    assert!(root.returned.is_some());
    for part in ["t ", "I_{local}", "I  "] {
        assert!(
            said.iter().any(|text| text.starts_with(part)),
            "{part}: {said:?}"
        );
    }
}

#[test]
fn a_whole_tree_is_not_dragged_and_fitting_keeps_what_is_collapsed() {
    let node = HeldNode {
        ray: 7,
        at: Vec2::ONE,
    };
    assert_eq!(TreeView::WHOLE.dragged(Vec2::X, node), TreeView::WHOLE);
    let zoomed = TreeView::WHOLE.toggled(7).zoomed(3.0, Some(node));
    assert_eq!(zoomed.dragged(Vec2::X, node).held.unwrap().at.x, 2.0);
    assert_eq!(zoomed.fitted(), TreeView::WHOLE.toggled(7));
    assert_eq!(zoomed.zoomed(0.1, Some(node)), zoomed.fitted());
}

#[test]
fn of_a_huge_tree_no_more_is_drawn_than_is_legible() {
    let fixture = Fixture::rays(Method::RayTracing, BALL, 5);
    let mut state = rays_of(&fixture).clone();
    let mut fixture = fixture;
    fixture.go_to("BranchAdded", 0);
    let model = rays_of(&fixture).rays.get(0).unwrap().clone();
    state.rays = Default::default();
    // A full binary tree in level order.
    const COUNT: usize = 100_000;
    for index in 0..COUNT {
        let mut ray = model.clone();
        ray.parent = index.checked_sub(1).map(|behind| behind / 2);
        ray.branches = [2 * index + 1, 2 * index + 2].map(|child| {
            let mut branch = model.branches[0]?;
            branch.outcome = Outcome::Ray(child);
            Some(branch).filter(|_| child < COUNT)
        });
        state.rays.push(ray);
    }
    state.current = Some(COUNT - 1);
    for zoom in [1.0, TreeView::LARGEST] {
        let view = TreeView::WHOLE.zoomed(zoom, None);
        let rays = Rays::new(&state);
        let tree = Places::new(&rays, &view, Vec2::new(690.0, 620.0)).1.tree;
        assert_eq!(tree.nodes.len() + tree.hidden, COUNT);
        assert!(tree.nodes.len() < 4000, "{} nodes", tree.nodes.len());
        assert_eq!(tree.nodes[tree.current].of, pick::Of::Ray(COUNT - 1));
    }
}
