use super::*;
use crate::scene::{Limits, read};

fn scene(objects: &str) -> Scene {
    let text = format!(r#"{{"schema": 1, "materials": {{"m": {{}}}}, "objects": [{objects}]}}"#);
    read(text.as_bytes(), &Limits::default(), &mut |_| {
        Ok(b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n".to_vec())
    })
    .unwrap()
}

fn patches(objects: &str) -> Patches {
    Patches::of(&scene(objects), 100_000).unwrap()
}

#[test]
fn a_quadrilateral_has_u_along_its_first_edge_and_v_along_its_last() {
    let patches = patches(
        r#"{"name": "a", "material": "m", "polygon": {"vertices": [[0,0,0],[4,0,0],[4,2,0],[0,2,0]]}, "patches": [4, 2]}"#,
    );
    assert_eq!(
        patches.surfaces,
        [Surface {
            grid: [4, 2],
            first: 0
        }]
    );
    assert_eq!(patches.len(), 8);
    let patch = &patches[4 + 3];
    assert_eq!((patch.cell, patch.area), ([3, 1], 1.0));
    assert_eq!(patch.center, DVec3::new(3.5, 1.5, 0.0));
    assert_eq!(patch.normal, DVec3::Z);
    assert_eq!(patches.pieces(7).len(), 1);
    assert_eq!(
        patches.pieces(7).next().unwrap().corners[0],
        DVec3::new(3.0, 1.0, 0.0)
    );
}

#[test]
fn a_cell_that_is_not_planar_is_two_triangles_and_a_concave_one_convex_pieces() {
    let patches = patches(
        r#"{"name": "bent", "material": "m", "polygon": {"vertices": [[0,0,0],[1,0,0],[1,1,0.5],[0,1,0]]}},
           {"name": "dart", "material": "m", "polygon": {"vertices": [[0,4,0],[3,3,0],[4,0,0],[4,4,0]]}},
           {"name": "letter", "material": "m", "polygon": {"vertices": [[0,0,0],[3,0,0],[3,1,0],[1,1,0],[1,3,0],[0,3,0]]}},
           {"name": "hexagon", "material": "m", "polygon": {"vertices": [[2,0,0],[1,2,0],[-1,2,0],[-2,0,0],[-1,-2,0],[1,-2,0]]}}"#,
    );
    let pieces: Vec<usize> = (0..4).map(|patch| patches.pieces(patch).len()).collect();
    assert_eq!(pieces, [2, 2, 4, 1]);
    assert!((patches[1].area - 4.0).abs() < 1e-14);
    assert!((patches[2].area - 5.0).abs() < 1e-14);
    assert_eq!(patches[3].area, 12.0);
}

#[test]
fn triangles_and_meshes_have_n_steps_an_edge() {
    let patches = patches(
        r#"{"name": "t", "material": "m", "polygon": {"vertices": [[0,0,0],[3,0,0],[0,3,0]]}, "patches": 3},
           {"name": "mesh", "material": "m", "mesh": {"file": "a.obj"}, "patches": 2}"#,
    );
    assert_eq!(patches.surfaces[0].grid, [9, 1]);
    assert_eq!(
        patches.surfaces[1],
        Surface {
            grid: [8, 1],
            first: 9
        }
    );
    assert!(
        patches
            .iter()
            .all(|patch| patch.area == 0.5 && patch.normal == DVec3::Z)
    );
    assert_eq!(patches[8].cell, [8, 0]);
    let centers: DVec3 = patches.iter().take(9).map(|patch| patch.center / 9.0).sum();
    assert!(centers.distance(DVec3::new(1.0, 1.0, 0.0)) < 1e-15);
}

#[test]
fn a_sphere_is_inscribed_facets_by_longitude_then_latitude() {
    let sphere = r#"{"name": "s", "material": "m", "sphere": {"center": [1,2,3], "radius": 2}}"#;
    let patches = patches(sphere);
    assert_eq!(patches.surfaces[0].grid, [16, 8]);
    assert_eq!(patches.len(), 128);
    for patch in patches.iter() {
        assert!(
            patch
                .normal
                .dot((patch.center - DVec3::new(1.0, 2.0, 3.0)).normalize())
                > 0.95
        );
    }
    assert!((0..128).all(|patch| patches.pieces(patch).len() == 1));
    // Longitudes from z toward x, latitudes from +y down
    let north = &patches[0];
    assert!(north.center.y > 3.8 && north.center.x > 1.0 && north.center.z > 3.0);
    assert!(patches[127].center.y < 0.2);
}

#[test]
fn closed_objects_are_divided_into_closed_surfaces() {
    let patches = patches(
        r#"{"name": "c", "material": "m", "cylinder": {"base": [0,0,0], "axis": [0,1,0], "radius": 1, "height": 2}, "patches": 2},
           {"name": "s", "material": "m", "sphere": {"center": [1,2,3], "radius": 2}, "patches": [5, 4]}"#,
    );
    for object in 0..2 {
        let vector: DVec3 = patches
            .iter()
            .filter(|patch| patch.object == object)
            .map(|patch| patch.area * patch.normal)
            .sum();
        assert!(vector.length() < 1e-13);
    }
    assert_eq!(patches.surfaces[0].grid, [4 * (64 + 60), 1]);
}

#[test]
fn planes_patches_without_area_and_too_many_are_refused_with_their_place() {
    let error = |objects: &str, most| Patches::of(&scene(objects), most).unwrap_err().to_string();
    let ball = r#"{"name": "ball", "material": "m", "sphere": {"center": [0,0,0], "radius": 1}}"#;
    let plane =
        r#"{"name": "floor", "material": "m", "plane": {"point": [0,0,0], "normal": [0,1,0]}}"#;
    assert!(
        error(&format!("{ball}, {plane}"), 1000)
            .starts_with("objects[1]: found the plane \"floor\"")
    );
    assert!(error(ball, 127).contains("128 patches here and 128 so far; at most 127"));
    let far =
        r#"{"name": "far", "material": "m", "sphere": {"center": [1e9,1e9,1e9], "radius": 1e-9}}"#;
    assert!(error(far, 1000).starts_with("objects[0]: patch [0, 0] of \"far\" has no area"));
}
