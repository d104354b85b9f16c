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

const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn read(text: &str) -> Result<MeshData, String> {
    obj::read(text.as_bytes(), 1000)
}

fn remarks(text: &str) -> Vec<String> {
    let remarks = read(text).unwrap().remarks;
    remarks.into_iter().map(|remark| remark.what).collect()
}

#[test]
fn polygons_of_any_size_keep_their_texture_coordinates() {
    let data = read(HOUSE).unwrap();
    assert_eq!(data.triangles(), 5);
    let mesh = data.mesh(&DAffine3::from_translation(DVec3::X), false);
    assert_eq!((mesh.face_count(), mesh.vertex_count()), (2, 7));
    let place = |face: usize, corner: usize| mesh.position(mesh.face(face)[corner]).to_array();
    assert_eq!(place(0, 3), [2.0, 2.0, 0.0]);
    assert_eq!(place(1, 2), [1.0, 0.0, 2.0]);
    assert_eq!(place(1, 3), [5.0, 0.0, 4.0]);
    assert_eq!(mesh.normal(0), DVec3::Z);
    assert_eq!(mesh.face_uvs(0)[1], DVec2::new(1.0, 0.5));
    assert_eq!(mesh.face_uvs(1), [DVec2::ZERO; 4]);
    let without = read(&format!("{CORNERS}vt 1 1\nf 1 2 3")).unwrap();
    assert!(!without.mesh(&DAffine3::IDENTITY, false).has_uvs());
}

#[test]
fn corners_without_texture_coordinates_take_the_origin() {
    let data = read(&format!(
        "{CORNERS}f 1 2 3\nvt 5 6\nf 1 2/1 3\nf 1/1 2 3/1\n"
    ))
    .unwrap();
    let mesh = data.mesh(&DAffine3::IDENTITY, false);
    let (none, given) = (DVec2::ZERO, DVec2::new(5.0, 6.0));
    assert_eq!(mesh.face_uvs(0), [none, none, none]);
    assert_eq!(mesh.face_uvs(1), [none, given, none]);
    assert_eq!(mesh.face_uvs(2), [given, none, given]);
}

#[test]
fn the_teapot_has_992_triangles_over_welded_vertices() {
    let teapot = include_bytes!("../../../lessons/meshes/teapot.obj");
    let data = obj::read(teapot, 992).unwrap();
    assert_eq!(data.triangles(), 992);
    let mesh = data.mesh(&DAffine3::IDENTITY, false);
    assert_eq!(mesh.face_count(), 992);
    assert!(mesh.vertex_count() < 792);
    let message = obj::read(teapot, 991).unwrap_err();
    assert_eq!(
        message,
        "found 992 triangles; at most 991 are allowed (--max-triangles)"
    );
}

#[test]
fn coordinates_keep_all_their_digits() {
    let data = read("v 0.1 1e-9 123456789.12345678\nv 1 0 0\nv 0 1 0\nf 1 2 3").unwrap();
    assert_eq!(
        data.positions[0].to_array(),
        [0.1, 1e-9, 123_456_789.123_456_78]
    );
}

#[test]
fn the_same_triangle_is_read_however_it_is_written() {
    let same = |text: &[u8]| {
        let data = obj::read(text, 1000).unwrap();
        let mesh = data.mesh(&DAffine3::IDENTITY, false);
        let corners: Vec<[f64; 3]> = mesh
            .face(0)
            .iter()
            .map(|&vertex| mesh.position(vertex).to_array())
            .collect();
        assert_eq!(
            corners,
            [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            "{}",
            String::from_utf8_lossy(text)
        );
    };
    let text = format!("{CORNERS}f 1 2 3");
    same(text.as_bytes());
    same(text.replace('\n', "\r").as_bytes());
    same(text.replace('\n', "\r\n").as_bytes());
    same(format!("\u{feff}{text}").as_bytes());
    let utf16: Vec<u8> = format!("\u{feff}{text}")
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    same(&utf16);
    for face in [
        "f 1 \\\n2 3",
        "f -3 -2 -1",
        "fo 1 2 3",
        "f 1/1 2/2 3/3",
        "f 1//1 2//2 3//3",
        "f 1/1/1 2/-5/-5 3/0/0",
        "vt 0.5\nf 1/1 2/1 3/1",
        "vt nan 1\nf 1/1 2/1 3/1",
        "vn -nan(ind) -nan(ind) -nan(ind)\nf 1//1 2//1 3//1",
        "vn 1.#QNAN 1.#QNAN 1.#QNAN\nf 1//1 2//1 3//1",
        "vn 0 0 0\nvn 1e400 0 0\nvn 1 2\nf 1//1 2//2 3//3",
        "f 1 2\nf\nf 1 2 3",
        "l 1 2\np 3\nusemtl red\ng a\ncurv 0 1 1 2\nwhatever\nf 1 2 3",
        "f 1 2 3\r\r\n\r\r\n",
    ] {
        same(format!("{CORNERS}{face}\n").as_bytes());
    }
    same(b"v 0 0 0 0.5\nv 1 0 0 0\nv 0 1 0 1\nf 1 2 3");
    same(b"v 0 0 0 1 1 1\nv 1 0 0 0.5 nan 0\nv 0 1 0 1 1 1 1\nf 1 2 3");
    same(format!("{CORNERS}v 1e308 0 0\nf 1 2 3").as_bytes());
    same(b"f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
}

#[test]
fn normals_of_the_file_are_of_unit_length_and_belong_to_corners() {
    let data = read(&format!(
        "{CORNERS}vn 0 0 2\nvn -5e300 0 0\nf 1//1 2//2 3\n"
    ))
    .unwrap();
    let corners: Vec<DVec3> = data
        .corners
        .iter()
        .map(|corner| data.normals[corner[2] as usize])
        .collect();
    assert_eq!(corners, [DVec3::Z, DVec3::NEG_X, DVec3::ZERO]);
    assert_eq!(data.corners_without_normal(), 1);
    let turned = DAffine3::from_rotation_y(std::f64::consts::FRAC_PI_2);
    let mesh = data.mesh(&(DAffine3::from_scale(DVec3::splat(3.0)) * turned), true);
    let expected = [DVec3::X, DVec3::Z, DVec3::ZERO];
    for (found, expected) in mesh.face_normals(0).iter().zip(expected) {
        assert!(found.distance(expected) < 1e-15);
    }
}

#[test]
fn what_has_no_effect_is_remarked_once_with_its_count() {
    assert_eq!(
        remarks(HOUSE),
        [
            "1 vertex with a fourth number, the first in line 10",
            "1 vertex with a colour, the first in line 9",
            "1 line of materials (`usemtl`, `mtllib`), the first is line 2",
            "2 lines of groups (`g`, `o`, `s`), the first is line 3",
            "1 line of lines and points (`l`, `p`), the first is line 14",
        ]
    );
    let broken = format!("{CORNERS}f 1/1/7 2/-3/8 3\nf 1 2\nvn nan 0 0\nvt inf\nhello\ncurv 0\n");
    assert_eq!(
        remarks(&broken),
        [
            "1 face of fewer than three corners, the first in line 5",
            "1 corner with a `vt` that the file lacks, the first in line 4",
            "1 `vt` that is no number, the first in line 7",
            "2 corners with a `vn` that the file lacks, the first in line 4",
            "1 `vn` without a direction, the first in line 6",
            "1 line of curves and surfaces (`curv`, `surf` and the like), the first is line 9",
            "1 line without a known first word, the first is line 8",
        ]
    );
    assert_eq!(remarks(&format!("{CORNERS}f 1 2 3")), [""; 0]);
}

#[test]
fn other_files_are_called_by_their_names() {
    for (start, kind) in [
        (&b"<!DOCTYPE html>\n<html>"[..], "found a web page (HTML)"),
        (b"\n <HTML lang=en>", "found a web page (HTML)"),
        (
            b"version https://git-lfs.github.com/spec/v1\noid sha256:aa\nsize 9\n",
            "found a Git LFS pointer",
        ),
        (b"PK\x03\x04\0\0", "found a zip archive"),
        (b"glTF\x02\0\0\0", "found a binary glTF file"),
        (b"{ \"asset\": {} }", "found JSON"),
        (b"ply\nformat ascii 1.0\n", "found a PLY file"),
        (b"solid cube\n facet normal", "found an STL file"),
        (b"\x89PNG\r\n", "found a PNG image"),
        (b"\xff\xd8\xff\xe0", "found a JPEG image"),
    ] {
        let message = obj::read(start, 1000).unwrap_err();
        assert!(message.starts_with(kind), "{message}");
    }
    for (text, end) in [
        ("", "at least one"),
        (
            "v 0 0 0\nl 1 1\n",
            "it has lines and points (`l`, `p`) only",
        ),
        ("cstype bspline\nsurf 0 1\n", "are not supported"),
        ("Dear reader,\n", "the first is line 1"),
    ] {
        let message = read(text).unwrap_err();
        assert!(
            message.starts_with("found no faces") && message.ends_with(end),
            "{message}"
        );
    }
}

#[test]
fn a_wrong_line_is_named() {
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
        ("f 1/2/3/4 2 3", "line 4: found the corner \"1/2/3/4\""),
        (
            "vt 0 0\nf /1 2 3",
            "line 5: found the corner \"/1\" without a vertex",
        ),
        ("f 1 2 x", "line 4: found \"x\" as an index"),
        ("f 1/x 2 3", "line 4: found \"x\" as an index of `vt`"),
        ("f 1 \\\n2 \\\nx", "line 4: found \"x\" as an index"),
        ("v nan 0 0", "line 4: found nan"),
        ("v 0 0 1e400", "line 4: found 1e400"),
        ("v 1.#INF 0 0", "line 4: found 1.#INF"),
        (
            "v 0 1e76 0\nf 1 2 4",
            "line 4: found a vertex of a face too far away",
        ),
        ("v 0,5 0 0", "line 4: found \"0,5\""),
        ("v 0 0", "line 4: found too few numbers"),
        ("v 0 0 0 1 2", "line 4: found 5 numbers"),
        ("v 0 0 0 1 2 3 4 5", "line 4: found 8 numbers"),
        ("v 0 0 0 w", "line 4: found \"w\""),
        ("vt", "line 4: found no number"),
        ("vn 1 2 z", "line 4: found \"z\""),
        ("l 1 2 3", "found no faces"),
        ("f 1 2", "found no faces"),
    ] {
        let found = read(&format!("{CORNERS}{line}\n")).unwrap_err();
        assert!(found.starts_with(message), "{line}: {found}");
    }
}

proptest! {
    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = obj::read(&bytes, 1000);
    }

    #[test]
    fn what_is_read_from_a_spoilt_file_is_whole(
        cut in 0..HOUSE.len(),
        word in "(f|v|vt|vn|l|o|g|usemtl|mtllib|-?[0-9]{1,20}|[0-9]/|//|-|nan|\\\\|\n|\r| ){1,8}",
        rest in 0..HOUSE.len(),
    ) {
        let text = format!("{}{word}{}", &HOUSE[..cut], &HOUSE[rest..]);
        if let Ok(data) = read(&text) {
            prop_assert_eq!(data.corners.len() as u64, data.triangles() + 2 * data.face_count() as u64);
            prop_assert!(data.corners.iter().all(|corner| data.positions[corner[0] as usize].is_finite()));
            prop_assert!(data.uvs.iter().all(|uv| uv.is_finite()));
            prop_assert!(data.normals.iter().all(|normal| normal.is_finite()));
            prop_assert!(data.mesh(&DAffine3::IDENTITY, false).face_count() <= data.face_count());
        }
    }
}
