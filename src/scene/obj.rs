//! Wavefront OBJ files: positions, texture coordinates (`vt`) and faces of any size. Normals, groups, materials, lines and points
//! are passed over: a mesh has one material, that of its object.

use super::Mesh;
use super::obj_lines::Lines;
use glam::{DAffine3, DVec2, DVec3};

/// A mesh file that was found right.
#[derive(Clone, Debug, PartialEq)]
pub struct Obj {
    /// Those that faces refer to, in the order in which they first do.
    positions: Vec<DVec3>,
    /// Face `f` has the corners `starts[f]..starts[f + 1]`.
    starts: Vec<u32>,
    /// Indices into `positions`.
    corners: Vec<u32>,
    /// One a corner, or none at all.
    uvs: Vec<DVec2>,
    triangles: u64,
}

impl Obj {
    /// Reads an OBJ file. Where some corners have texture coordinates, those without take (0, 0).
    ///
    /// Errors: the first line that is wrong, no faces at all, or more than `max_triangles`, as a sentence.
    pub fn read(bytes: &[u8], max_triangles: u64) -> Result<Obj, String> {
        let lines = Lines::read(bytes, max_triangles)?;
        const UNUSED: u32 = u32::MAX;
        let mut numbers = vec![UNUSED; lines.positions.len()];
        let mut positions = Vec::new();
        let corners = lines.corners.iter().map(|&[position, _]| {
            let number = &mut numbers[position as usize];
            if *number == UNUSED {
                *number = positions.len() as u32;
                positions.push(lines.positions[position as usize]);
            }
            *number
        });
        let corners = corners.collect();
        let mut uvs = Vec::new();
        if lines.corners.iter().any(|&[_, uv]| uv > 0) {
            uvs.extend((lines.corners.iter()).map(|&[_, uv]| lines.uvs[uv as usize]));
        }
        Ok(Obj {
            positions,
            starts: lines.starts,
            corners,
            uvs,
            triangles: lines.triangles,
        })
    }

    /// Σ (corners − 2) over the faces.
    pub fn triangles(&self) -> u64 {
        self.triangles
    }

    /// The mesh in world coordinates, its vertices welded.
    pub fn mesh(&self, to_world: &DAffine3) -> Mesh {
        let positions: Vec<DVec3> = self
            .positions
            .iter()
            .map(|&position| to_world.transform_point3(position))
            .collect();
        let faces = self
            .starts
            .windows(2)
            .map(|ends| &self.corners[ends[0] as usize..ends[1] as usize]);
        Mesh::new(&positions, faces, &self.uvs)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const HOUSE: &str = "\
# a wall of five corners, and a floor that leans on it
mtllib none.mtl
o house
v 0 0 0
v 2 0 0
v 2 1 0
v 1 2 0 # ridge
v 0 1 0
v 0 0 2 1 0.5 0.5
v 4 0 4 2
vt 0 0
vt 1 0.5
f 1/1 2/2 3/2 4/2 5/1
l 1 2 3
g floor
f 2 1 -2 -1
";

    fn read(text: &str) -> Result<Obj, String> {
        Obj::read(text.as_bytes(), 1000)
    }

    #[test]
    fn polygons_of_any_size_keep_their_texture_coordinates() {
        let obj = read(HOUSE).unwrap();
        assert_eq!(obj.triangles(), 5);
        let mesh = obj.mesh(&DAffine3::from_translation(DVec3::X));
        assert_eq!((mesh.face_count(), mesh.vertex_count()), (2, 7));
        let place = |face: usize, corner: usize| mesh.position(mesh.face(face)[corner]).to_array();
        assert_eq!(place(0, 3), [2.0, 2.0, 0.0]);
        assert_eq!(place(1, 2), [1.0, 0.0, 2.0]);
        assert_eq!(place(1, 3), [3.0, 0.0, 2.0]);
        assert_eq!(mesh.normal(0), DVec3::Z);
        assert_eq!(mesh.face_uvs(0)[1], DVec2::new(1.0, 0.5));
        assert_eq!(mesh.face_uvs(1), [DVec2::ZERO; 4]);
        assert!(
            read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 1 1\nf 1 2 3")
                .unwrap()
                .uvs
                .is_empty()
        );
    }

    #[test]
    fn corners_without_texture_coordinates_take_the_origin() {
        let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        let obj = read(&format!(
            "{corners}f 1 2 3\nvt 5 6\nf 1 2/1 3\nf 1/1 2 3/1\n"
        ))
        .unwrap();
        let (none, given) = (DVec2::ZERO, DVec2::new(5.0, 6.0));
        let expected = [none, none, none, none, given, none, given, none, given];
        assert_eq!(obj.uvs, expected);
    }

    #[test]
    fn the_teapot_has_992_triangles_over_welded_vertices() {
        let teapot = include_bytes!("../../lessons/meshes/teapot.obj");
        let obj = Obj::read(teapot, 992).unwrap();
        assert_eq!(obj.triangles(), 992);
        let mesh = obj.mesh(&DAffine3::IDENTITY);
        assert_eq!(mesh.face_count(), 992);
        assert!(mesh.vertex_count() < 792);
        let message = Obj::read(teapot, 991).unwrap_err();
        assert_eq!(
            message,
            "found 992 triangles; at most 991 are allowed (--max-triangles)"
        );
    }

    #[test]
    fn coordinates_keep_all_their_digits() {
        let obj = read("v 0.1 1e-9 123456789.12345678\nv 1 0 0\nv 0 1 0\nf 1 2 3").unwrap();
        assert_eq!(
            obj.positions[0].to_array(),
            [0.1, 1e-9, 123_456_789.123_456_78]
        );
    }

    #[test]
    fn a_wrong_line_is_named() {
        let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
        for (line, message) in [
            (
                "f 1 2 4",
                "line 4: a face refers to `v` number 4; the file has 3 lines `v`",
            ),
            ("f 1 2 0", "line 4: found \"0\" as an index"),
            (
                "f 1 2 -4",
                "line 4: found \"-4\" as an index of `v`; allowed is at least -3",
            ),
            ("f 1/-5 2 3", "line 4: found \"-5\" as an index of `vt`"),
            ("f 1//9 2 3", "line 4: a face refers to `vn` number 9"),
            ("f 1 2", "line 4: found a face of 2 corners"),
            ("f", "line 4: found a face of 0 corners"),
            ("f 1/2/3/4 2 3", "line 4: found the corner \"1/2/3/4\""),
            (
                "vt 0 0\nf /1 2 3",
                "line 5: found the corner \"/1\" without a vertex",
            ),
            ("f 1 2 x", "line 4: found \"x\" as an index"),
            ("f 1 2 \\\n3", "line 4: a line that goes on"),
            ("v nan 0 0", "line 4: found nan"),
            ("v 0 0 1e400", "line 4: found 1e400"),
            ("v 0 0", "line 4: found too few numbers"),
            ("v 0 0 0 0", "line 4: found the weight 0.0"),
            ("v 0 0 0 1 2 3 4", "line 4: found 7 or more numbers"),
            ("vt 1", "line 4: found too few numbers"),
            ("vn 1 2 z", "line 4: found \"z\""),
            ("l 1 2 3", "found no faces"),
        ] {
            let found = read(&format!("{corners}{line}\n")).unwrap_err();
            assert!(found.starts_with(message), "{line}: {found}");
        }
    }

    proptest! {
        #[test]
        fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let _ = Obj::read(&bytes, 1000);
        }

        #[test]
        fn what_is_read_from_a_spoilt_file_is_whole(
            cut in 0..HOUSE.len(),
            word in "(f|v|vt|vn|l|o|g|usemtl|mtllib|-?[0-9]{1,20}|[0-9]/|//|-|nan|\\\\|\n| ){1,8}",
            rest in 0..HOUSE.len(),
        ) {
            let text = format!("{}{word}{}", &HOUSE[..cut], &HOUSE[rest..]);
            if let Ok(obj) = read(&text) {
                prop_assert_eq!(obj.corners.len() as u64, obj.triangles() + 2 * (obj.starts.len() as u64 - 1));
                prop_assert!(obj.uvs.is_empty() || obj.uvs.len() == obj.corners.len());
                prop_assert!(obj.mesh(&DAffine3::IDENTITY).face_count() < obj.starts.len());
            }
        }
    }
}
