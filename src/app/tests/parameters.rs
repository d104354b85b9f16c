//! Lights that the pointer drags, and the card of parameters.

use super::*;
use crate::panels::{Panel, draw, vector_grip};
use crate::picture::Shape;
use crate::scene::{Light, Movable};
use egui::Role;
use glam::DVec3;

/// A ball under two lights, of which the first may be moved.
fn ball() -> Screen {
    let json = r#"{ "schema": 1, "id": "ball", "number": 1, "topics": [],
        "title": { "en": "T", "id": "T" }, "summary": { "en": "S", "id": "S" },
        "scene": { "schema": 1, "materials": { "chalk": { "diffuse": [1, 1, 1] } },
            "camera": { "eye": [0, 1, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
            "objects": [{ "name": "ball", "material": "chalk", "sphere": { "center": [0, 0, 0], "radius": 1 } }],
            "lights": [{ "point": { "position": [1, 2, 1] } }, { "point": { "position": [-2, 2, -2] } }] },
        "method": "ray-tracing", "size": [24, 18], "focus": { "pixel": [12, 9] }, "panels": ["space"], "parameters": [{ "light": 0 }],
        "steps": [{ "at": { "kind": "Diffuse" }, "say": { "en": "Lit", "id": "Terang" } }] }"#;
    let lesson = Lesson::read(
        json.as_bytes(),
        &Default::default(),
        &mut |_| unreachable!(),
    );
    screen_of(lesson.expect("a right lesson"), [1280, 800], 1.0, [])
}

#[test]
fn no_parameter_of_any_lesson_sticks_out_of_the_drawer() {
    let mut faults = Vec::new();
    for builtin in crate::lesson::builtins() {
        let mut screen = screen(builtin.id, [1280, 800], 1.0, [Command::Parameters]);
        for language in Language::ALL {
            screen.session_mut().look.language = language;
            screen.harness.run();
            for role in [Role::Button, Role::SpinButton, Role::Slider, Role::Label] {
                for node in screen.harness.query_all_by_role(role) {
                    let label = node.accesskit_node().label().unwrap_or_default();
                    if node.rect().right() > 1280.0 {
                        let code = language.code();
                        faults.push(format!(
                            "{} {code}: {label} ends at {}",
                            builtin.id,
                            node.rect().right()
                        ));
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn lights(screen: &Screen) -> [DVec3; 2] {
    let input = screen.session().panel_input();
    let lights = &input.run.prepared().scene.lights;
    [0, 1].map(|number| match lights[number] {
        Light::Point { position, .. } => position,
        Light::Directional { .. } => unreachable!("both are point lights"),
    })
}

/// Where a light is on the screen, in the first view that shows it.
fn place(screen: &Screen, light: usize) -> egui::Pos2 {
    let panel = screen
        .harness
        .get_by_role_and_label(Role::Image, Panel::Space.title().text(Language::English));
    let rect = panel.rect();
    let size = glam::Vec2::new(rect.width(), rect.height());
    let picture = draw(Panel::Space, &screen.session().panel_input(), size);
    // Its L may be drawn too.
    let item = picture.items.iter().find(|item| {
        item.tag == Some(Tag::Light(light)) && matches!(item.shape, Shape::Circle { .. })
    });
    let at = item.expect("the light is drawn").shape.bounds().center();
    rect.min + egui::vec2(at.x, at.y)
}

fn drag(screen: &mut Screen, from: egui::Pos2, by: egui::Vec2) {
    screen.harness.hover_at(from);
    screen.harness.run();
    screen.harness.drag_at(from);
    screen.harness.run();
    for part in [0.5, 1.0] {
        screen.harness.hover_at(from + part * by);
        screen.harness.run();
    }
    screen.harness.drop_at(from + by);
    screen.harness.run();
}

#[test]
fn a_light_is_dragged_where_the_lesson_allows_it() {
    let mut screen = ball();
    let before = lights(&screen);
    let (free, fixed) = (place(&screen, 0), place(&screen, 1));
    drag(&mut screen, free, egui::vec2(24.0, -12.0));
    let moved = lights(&screen)[0];
    // Up on the screen is up in the scene.
    assert!(moved.y > before[0].y, "{moved}");
    assert!(place(&screen, 0).distance(free + egui::vec2(24.0, -12.0)) < 1.0);
    screen.keep("dragged-light");

    drag(&mut screen, fixed, egui::vec2(24.0, -12.0));
    assert_eq!(lights(&screen)[1], before[1]);
}

#[test]
fn a_focused_slider_keeps_its_arrows_and_the_picture_follows() {
    let mut screen = ball();
    screen.press(Modifiers::NONE, Key::P);
    let step = screen.session().step();
    let before = lights(&screen);
    let name = strings::DISTANCE.format(Language::English, &[("thing", "light 0")]);
    let slider = screen.harness.get_by_role_and_label(Role::Slider, &name);
    slider.focus();
    screen.harness.run();
    for _ in 0..3 {
        screen.press(Modifiers::NONE, Key::ArrowRight);
    }
    let after = lights(&screen)[0];
    assert!(after.length() > before[0].length(), "{after}");
    let turned = after.normalize().angle_between(before[0].normalize());
    assert!(turned < 1e-6, "it moves straight away from the target");
    assert_eq!(screen.session().step(), step);
    assert!(screen.session().is_changed());
    screen.keep("parameters");

    screen.click(strings::LESSONS_VALUES.text(Language::English));
    assert_eq!(lights(&screen), before);
    screen.press(Modifiers::NONE, Key::ArrowRight);
    assert_eq!(screen.session().step(), step + 1);
}

#[test]
fn where_nothing_can_be_changed_no_drawer_opens() {
    let mut lesson = builtin("gouraud-triangle").unwrap().read().unwrap();
    lesson.parameters.clear();
    let mut screen = screen_of(lesson, [1280, 800], 1.0, []);
    screen.press(Modifiers::NONE, Key::P);
    assert_eq!(screen.session().look.drawer, None);
    let why = strings::NO_PARAMETERS.text(Language::English);
    screen.harness.get_by_label(why);
}

#[test]
fn the_eye_is_dragged_by_its_vector_and_stays_as_far_away() {
    let mut commands = vec![Command::NextNarrated; 3];
    commands.push(Command::Key(Panel::Vectors));
    let mut screen = screen("illumination-model", [1280, 800], 1.0, commands);
    let panel = screen
        .harness
        .get_by_role_and_label(Role::Image, Panel::Vectors.title().text(Language::English));
    let rect = panel.rect();
    let size = glam::Vec2::new(rect.width(), rect.height());
    let places =
        (0..rect.height() as u32).flat_map(|y| (0..rect.width() as u32).map(move |x| [x, y]));
    let mut places = places.map(|at| glam::Vec2::from(at.map(|x| x as f32)));
    let input = screen.session().panel_input();
    let held = |at| vector_grip(&input, size, at).is_some_and(|grip| grip.held == Movable::Eye);
    let at = places.find(|&at| held(at)).expect("the eye can be held");
    let eye = |screen: &Screen| screen.session().prepared().view.eye;
    let target = DVec3::new(0.48, 0.64, 0.6);
    let before = eye(&screen);
    let from = rect.min + egui::vec2(at.x, at.y);
    drag(&mut screen, from, egui::vec2(-60.0, 60.0));
    let after = eye(&screen);
    assert!(before.distance(after) > 0.1, "{before} {after}");
    let distances = [before, after].map(|eye| eye.distance(target));
    assert!((distances[0] - distances[1]).abs() < 1e-6, "{distances:?}");
    assert!(screen.session().is_changed());
}

/// Where a panel draws the first thing with that tag, on the screen.
fn drawn_at(screen: &Screen, panel: Panel, tag: Tag) -> egui::Pos2 {
    let node = screen
        .harness
        .get_by_role_and_label(Role::Image, panel.title().text(Language::English));
    let rect = node.rect();
    let size = glam::Vec2::new(rect.width(), rect.height());
    let picture = draw(panel, &screen.session().panel_input(), size);
    let at = picture.tagged_bounds(tag).expect("it is drawn").center();
    rect.min + egui::vec2(at.x, at.y)
}

#[test]
fn a_vertex_is_dragged_in_the_scan_line_panel_and_the_run_follows() {
    let commands = vec![Command::NextNarrated, Command::Key(Panel::ScanLine)];
    let mut screen = screen("gouraud-triangle", [1280, 800], 1.0, commands);
    let vertex = Movable::Vertex {
        object: 0,
        vertex: 0,
    };
    let place = |screen: &Screen| vertex.position(&screen.session().prepared().scene).unwrap();
    let (before, recording) = (place(&screen), screen.session().recording());
    let from = drawn_at(&screen, Panel::ScanLine, Tag::Vertex(0));
    screen.harness.hover_at(from);
    screen.harness.run();
    screen.keep("vertex-handles");
    drag(&mut screen, from, egui::vec2(40.0, 30.0));
    let after = place(&screen);
    // To the right and down, and in the plane of the picture.
    assert!(after.x > before.x && after.y < before.y, "{before} {after}");
    assert!((after.z - before.z).abs() < 1e-9);
    assert!(screen.session().recording() > recording);
    screen.keep("dragged-vertex");
    screen.press(Modifiers::COMMAND, Key::Z);
    assert_eq!(place(&screen), before);
}

#[test]
fn an_object_is_dragged_in_the_picture_of_a_scene_that_was_opened() {
    let json = r#"{ "schema": 1, "materials": { "chalk": { "diffuse": [1, 1, 1] } },
        "camera": { "eye": [0, 0, 4], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
        "objects": [{ "name": "ball", "material": "chalk", "sphere": { "center": [0, 0, 0], "radius": 0.3 } }],
        "lights": [{ "point": { "position": [1, 2, 1] } }] }"#;
    let scene = crate::scene::read(
        json.as_bytes(),
        &Default::default(),
        &mut |_| unreachable!(),
    );
    let scene = scene.unwrap();
    let [width, height] = Lesson::SIZE_OF_A_WALK;
    let view = crate::scene::View::new(&scene.camera.unwrap(), width, height);
    let walk = Lesson::of_scene(
        "own",
        crate::algorithms::prepared_scene::PreparedScene::new(scene, view),
    );
    let mut screen = screen_of(walk, [1280, 800], 1.0, [Command::Key(Panel::Image)]);
    let middle = screen
        .harness
        .get_by_role_and_label(Role::Image, Panel::Image.title().text(Language::English))
        .rect()
        .center();
    // The caption takes a row at the bottom.
    drag(
        &mut screen,
        middle - egui::vec2(0.0, 10.0),
        egui::vec2(60.0, -40.0),
    );
    let at = Movable::Object(0)
        .position(&screen.session().prepared().scene)
        .unwrap();
    assert!(at.x > 0.1 && at.y > 0.05 && at.z.abs() < 1e-9, "{at}");
    assert!(screen.session().is_changed());
    screen.keep("dragged-ball");
}
