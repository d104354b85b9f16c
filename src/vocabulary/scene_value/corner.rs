//! The polygon of the step and its corners, as the scene has them.

use super::{Given, Recorded, SceneValue, index, one, value};
use crate::algorithms::prepared_scene::{Polygon, PreparedVertex};
use crate::algorithms::scan_line::{Kept, kept};
use crate::record::Value;
use crate::scene::Material;
use glam::{DVec2, DVec3};

pub(super) const VALUES: &[SceneValue] = &[
    value("polygon_corners", "P_k", |given, recorded| {
        let polygon = polygon(given, recorded)?;
        let positions = polygon
            .corners()
            .map(|(vertex, _)| polygon.mesh.position(vertex));
        Some(positions.map(Value::from).collect())
    }),
    value("corner_count", "n", |given, recorded| {
        one(polygon(given, recorded)?.corner_count() as f64)
    }),
    value("corner_position", "P", |given, recorded| {
        one(corner_position(given, recorded)?)
    }),
    value("face_normal", "N_{face}", |given, recorded| {
        let polygon = polygon(given, recorded)?;
        one(polygon.mesh.normal(polygon.face))
    }),
    value("from_position", "A", |given, recorded| {
        one(vertex(given, recorded, "from")?.0)
    }),
    value("to_position", "B", |given, recorded| {
        one(vertex(given, recorded, "to")?.0)
    }),
    value("from_is_seen", "A", |given, recorded| {
        one(vertex(given, recorded, "from")?.1)
    }),
    value("to_is_seen", "B", |given, recorded| {
        one(vertex(given, recorded, "to")?.1)
    }),
    value(
        "face_fan",
        "(P_i − P_0) × (P_{i+1} − P_0)",
        |given, recorded| {
            let object = index(recorded, "object")?;
            let mesh = given.prepared.tessellation.meshes.get(object)?;
            let face = mesh.face(index(recorded, "face")?);
            let first = mesh.position(*face.first()?);
            let from_first = |vertex: u32| mesh.position(vertex) - first;
            let pairs = face[1..].windows(2);
            Some(
                pairs
                    .map(|pair| Value::from(from_first(pair[0]).cross(from_first(pair[1]))))
                    .collect(),
            )
        },
    ),
    value("material_k_d", "k_d", |given, recorded| {
        one(material(given, recorded)?.diffuse)
    }),
    value("material_k_s", "k_s", |given, recorded| {
        one(material(given, recorded)?.specular)
    }),
    value("hidden_x", "x_h", |given, recorded| {
        one(cut(given, recorded)?[0].x)
    }),
    value("hidden_y", "y_h", |given, recorded| {
        one(cut(given, recorded)?[0].y)
    }),
    value("hidden_z", "z_h", |given, recorded| {
        one(cut(given, recorded)?[0].z)
    }),
    value("seen_x", "x_s", |given, recorded| {
        one(cut(given, recorded)?[1].x)
    }),
    value("seen_y", "y_s", |given, recorded| {
        one(cut(given, recorded)?[1].y)
    }),
    value("seen_z", "z_s", |given, recorded| {
        one(cut(given, recorded)?[1].z)
    }),
];

pub(super) fn polygon<'a>(given: Given<'a>, recorded: Recorded) -> Option<Polygon<'a>> {
    given.prepared.polygon(index(recorded, "polygon")?)
}

/// A vertex of the polygon, and whether it is within the picture.
fn vertex(given: Given, recorded: Recorded, name: &str) -> Option<(DVec3, bool)> {
    let polygon = polygon(given, recorded)?;
    let number = index(recorded, name)?;
    let (vertex, placed) = polygon
        .corners()
        .find(|(vertex, _)| *vertex as usize == number)?;
    let view = &given.prepared.view;
    let size = DVec2::new(view.width.into(), view.height.into());
    let is_seen = placed.camera.z >= view.near
        && placed.screen.cmpge(DVec2::ZERO).all()
        && placed.screen.cmple(size).all();
    Some((polygon.mesh.position(vertex), is_seen))
}

pub(super) fn material<'a>(given: Given<'a>, recorded: Recorded) -> Option<&'a Material> {
    let scene = &given.prepared.scene;
    let object = scene.objects.get(index(recorded, "object")?)?;
    scene.materials.get(object.material)
}

/// A corner of a polygon that the near plane may have cut, by the numbers of the polygon's own corners.
pub(super) enum Corner {
    Own(usize),
    /// Between two of them.
    Cut {
        hidden: usize,
        seen: usize,
    },
}

/// The corner of the step: of the polygon, or of one triangle of it.
pub(super) fn corner(given: Given, recorded: Recorded) -> Option<Corner> {
    let polygon = polygon(given, recorded)?;
    let placed: Vec<PreparedVertex> = polygon.corners().map(|(_, placed)| placed).collect();
    let mut corners: Vec<usize> = (0..placed.len()).collect();
    let is_triangle = recorded("triangle").is_some();
    if is_triangle {
        let of_triangle = ["a", "b", "c"].map(|name| index(recorded, name));
        let chosen = of_triangle.map(|corner| corner.filter(|&corner| corner < placed.len()));
        corners = chosen.into_iter().collect::<Option<_>>()?;
    }
    let near = given.prepared.view.near;
    let inside = |corner: usize| placed[corners[corner]].camera.z - near;
    // The pieces of a triangle that is cut are triangles again, and no longer numbered as its corners are.
    if is_triangle && (0..corners.len()).any(|corner| inside(corner) < 0.0) {
        return None;
    }
    let kept = kept(corners.len(), inside).nth(index(recorded, "corner")?)?;
    Some(match kept {
        Kept::Corner(corner) => Corner::Own(corners[corner]),
        Kept::Cut { hidden, seen } => Corner::Cut {
            hidden: corners[hidden],
            seen: corners[seen],
        },
    })
}

/// Where the corner of the step is in the world, which is not cut.
pub(super) fn corner_position(given: Given, recorded: Recorded) -> Option<DVec3> {
    let Corner::Own(corner) = corner(given, recorded)? else {
        return None;
    };
    let polygon = polygon(given, recorded)?;
    let (vertex, _) = polygon.corners().nth(corner)?;
    Some(polygon.mesh.position(vertex))
}

/// The hidden and the seen end of the edge that the corner of the step cuts.
fn cut(given: Given, recorded: Recorded) -> Option<[DVec3; 2]> {
    let Corner::Cut { hidden, seen } = corner(given, recorded)? else {
        return None;
    };
    let polygon = polygon(given, recorded)?;
    let placed: Vec<PreparedVertex> = polygon.corners().map(|(_, placed)| placed).collect();
    Some([hidden, seen].map(|corner| placed[corner].camera))
}
