//! Scenes of boxes for the tests of radiosity.

use crate::scene::{Limits, Scene, read};

/// The faces of the box from `low` to `high`, each divided into n × n patches.
pub struct Cuboid {
    pub low: [f64; 3],
    pub high: [f64; 3],
}

impl Cuboid {
    pub const UNIT: Cuboid = Cuboid {
        low: [0.0; 3],
        high: [1.0; 3],
    };

    /// A room: its walls face inward. As objects of a scene file, with the material `m`.
    pub fn room(&self, name: &str, divisions: [u32; 6]) -> Vec<String> {
        self.faces(name, divisions, false)
    }

    /// A block: its faces look outward.
    pub fn block(&self, name: &str, n: u32) -> Vec<String> {
        self.faces(name, [n; 6], true)
    }

    fn faces(&self, name: &str, divisions: [u32; 6], is_block: bool) -> Vec<String> {
        let faces = self.corners(is_block).into_iter().zip(divisions);
        faces
            .enumerate()
            .map(|(face, (corners, n))| polygon(&format!("{name}{face}"), &corners, n))
            .collect()
    }

    /// The corners of its faces, which look outward in a block and else inward.
    pub fn corners(&self, is_block: bool) -> [[[f64; 3]; 4]; 6] {
        let corner = |bits: usize| -> [f64; 3] {
            std::array::from_fn(|axis| match bits >> axis & 1 {
                1 => self.high[axis],
                _ => self.low[axis],
            })
        };
        const FACES: [[usize; 4]; 6] = [
            [0, 1, 3, 2],
            [5, 4, 6, 7],
            [4, 0, 2, 6],
            [1, 5, 7, 3],
            [4, 5, 1, 0],
            [2, 3, 7, 6],
        ];
        FACES.map(|face| {
            let mut corners = face.map(corner);
            if is_block {
                corners.reverse();
            }
            corners
        })
    }
}

/// A polygon as an object of a scene file, with the material `m`.
pub fn polygon(name: &str, corners: &[[f64; 3]], n: u32) -> String {
    format!(
        r#"{{"name": "{name}", "material": "m", "polygon": {{"vertices": {corners:?}}}, "patches": {n}}}"#
    )
}

/// A scene of one material `m`, whose keys are `material`.
pub fn scene(material: &str, objects: &[String]) -> Scene {
    let text = format!(
        r#"{{"schema": 1, "materials": {{"m": {{{material}}}}}, "objects": [{}]}}"#,
        objects.join(", ")
    );
    read(text.as_bytes(), &Limits::default(), &mut |_| {
        Err("no such file".into())
    })
    .unwrap()
}
