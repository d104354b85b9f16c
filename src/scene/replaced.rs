//! Round shapes that polygons stand in for.

use super::tessellation::CYLINDER_SIDES;
use super::{Note, Object, Scene, Shape};

/// A note on each kind of shape that is drawn as polygons by `whom` (the name of a method), with how many.
///
/// `by_patches`: spheres as their patches, not as their divisions. `is_replaced` says which shapes are: of spheres, cylinders and Bézier surfaces; planes, polygons and meshes are what they are.
pub fn replaced(
    scene: &Scene,
    whom: &str,
    by_patches: bool,
    is_replaced: impl Fn(&Shape) -> bool,
) -> Vec<Note> {
    let mut kinds: Vec<([&str; 2], String, Vec<usize>)> = Vec::new();
    for (number, object) in scene.objects.iter().enumerate() {
        let Some((names, polygons)) =
            polygons_for(object, by_patches).filter(|_| is_replaced(&object.shape))
        else {
            continue;
        };
        let same = |kind: &&mut ([&str; 2], String, _)| kind.0 == names && kind.1 == polygons;
        match kinds.iter_mut().find(same) {
            Some((.., objects)) => objects.push(number),
            None => kinds.push((names, polygons, vec![number])),
        }
    }
    let note =
        |([one, several], polygons, objects): ([&str; 2], String, Vec<usize>)| match objects[..] {
            [number] => Note::new(
                format_args!("objects[{number}]"),
                format!("a {one}"),
                format!("{whom} draws it as {polygons}"),
            ),
            _ => Note::new(
                "objects",
                format!("{} {several}", objects.len()),
                format!("{whom} draws each as {polygons}"),
            ),
        };
    kinds.into_iter().map(note).collect()
}

/// The name of a round shape, of one and of several, and what it is divided into.
fn polygons_for(object: &Object, by_patches: bool) -> Option<([&'static str; 2], String)> {
    match &object.shape {
        Shape::Sphere { .. } => {
            let [around, along] = match by_patches {
                true => object.patches,
                false => [2 * object.divisions, object.divisions],
            };
            Some((
                ["sphere", "spheres"],
                format!("{around}x{along} quadrilaterals"),
            ))
        }
        Shape::Cylinder { .. } => Some((
            ["cylinder", "cylinders"],
            format!("{CYLINDER_SIDES} flat sides"),
        )),
        Shape::Bezier { divisions, .. } => Some((
            ["Bézier surface", "Bézier surfaces"],
            format!("{divisions}x{divisions} quadrilaterals a patch"),
        )),
        Shape::Plane { .. } | Shape::Polygon { .. } | Shape::Mesh(_) => None,
    }
}
