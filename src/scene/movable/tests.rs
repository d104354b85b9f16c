use super::*;
use crate::scene::read;

fn scene() -> Scene {
    let json = r#"{ "schema": 1,
        "camera": { "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
        "materials": { "red": {} },
        "objects": [
            { "name": "ball", "material": "red", "sphere": { "center": [1, 2, 3], "radius": 1 } },
            { "name": "floor", "material": "red", "plane": { "point": [0, -1, 0], "normal": [0, 1, 0] } },
            { "name": "sheet", "material": "red", "polygon": { "vertices": [[0, 0, 0], [3, 0, 0], [0, 3, 0]] } },
            { "name": "pipe", "material": "red", "cylinder": { "base": [2, 0, 0], "axis": [0, 1, 0], "radius": 1, "height": 2 } } ],
        "lights": [
            { "point": { "position": [4, 6, 5] } },
            { "directional": { "toward": [0, -1, 0] } } ] }"#;
    read(
        json.as_bytes(),
        &Default::default(),
        &mut |_| unreachable!(),
    )
    .unwrap()
}

#[test]
fn whatever_has_a_place_is_put_where_it_was_wanted() {
    let opened = scene();
    let all: Vec<Movable> = Movable::all(&opened).collect();
    // A light, the eye, four objects and three vertices.
    assert_eq!(all.len(), 9);
    assert!(!all.contains(&Movable::Light(1)));
    for movable in all {
        let mut moved = opened.clone();
        let to = DVec3::new(0.5, -4.0, 2.25);
        movable.put(&mut moved, &opened, to).unwrap();
        let at = movable.position(&moved).unwrap();
        assert!(at.distance(to) < 1e-14, "{movable:?} at {at}");
        assert!(moved != opened, "{movable:?}");
        let back = movable.position(&opened).unwrap();
        movable.put(&mut moved, &opened, back).unwrap();
        let at = movable.position(&moved).unwrap();
        assert!(at.distance(back) < 1e-14, "{movable:?} back at {at}");
    }
}

#[test]
fn a_polygon_keeps_its_form_when_it_is_moved_as_a_whole() {
    let opened = scene();
    let mut moved = opened.clone();
    let sheet = Movable::Object(2);
    sheet
        .put(&mut moved, &opened, DVec3::new(11.0, 1.0, -5.0))
        .unwrap();
    let Shape::Polygon { vertices } = &moved.objects[2].shape else {
        panic!("a polygon")
    };
    let expected = [[10.0, 0.0, -5.0], [13.0, 0.0, -5.0], [10.0, 3.0, -5.0]];
    for (&vertex, expected) in vertices.iter().zip(expected) {
        assert!(vertex.distance(expected.into()) < 1e-14, "{vertex}");
    }
}

#[test]
fn what_a_file_would_be_refused_for_is_refused_and_changes_nothing() {
    let opened = scene();
    let mut scene = opened.clone();
    let corner = Movable::Vertex {
        object: 2,
        vertex: 2,
    };
    for (movable, position) in [
        (corner, DVec3::new(7.0, 0.0, 0.0)),
        (Movable::Object(2), DVec3::new(1e60, 0.0, 0.0)),
    ] {
        let refused = movable.put(&mut scene, &opened, position);
        assert!(matches!(refused, Err(NoRoom::Refused(why)) if why.contains("on one line")));
    }
    for (movable, position, why) in [
        (corner, DVec3::new(0.0, 2e75, 0.0), NoRoom::TooFar),
        (Movable::Object(0), DVec3::NAN, NoRoom::TooFar),
        (Movable::Eye, DVec3::ZERO, NoRoom::NoView),
        (Movable::Eye, DVec3::Y, NoRoom::NoView),
    ] {
        assert_eq!(movable.put(&mut scene, &opened, position), Err(why));
    }
    assert_eq!(scene, opened);
}
