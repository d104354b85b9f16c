//! Bad input: refused with its place and what is allowed, and what is too large before it takes memory.
//!
//! Each case breaks one thing in a scene that is otherwise right. What would be larger than any memory could not be refused afterwards.

use super::case::{Case, Measured, Ran, refused};
use super::scenes::scene;
use crate::scene::{Limits, patches::Patches, read};

pub const CASES: &[Case] = &[
    Case {
        name: "refusals/patches-1e18",
        asks: "a wall of 10⁹ × 10⁹ patches",
        expects: "refused with the count, what is allowed, and the option that allows more",
        because: "at most 100 000 patches unless --max-patches says otherwise; 10¹⁸ would take 10²⁰ bytes",
        run: || taken(&with_wall(r#""patches": [1000000000, 1000000000]"#)),
        recorded: refused(
            "objects[0].patches: found [1000000000, 1000000000], which makes 1000000000000000000 patches here and 1000000000000000000 so far; at most 100000 are allowed in a scene (--max-patches)",
        ),
    },
    Case {
        name: "refusals/patches-2-to-the-64",
        asks: "a wall of (2⁶⁴ − 1)² patches, whose count no 64 bits hold",
        expects: "refused: the count must not wrap around to something small",
        because: "(2⁶⁴ − 1)² mod 2⁶⁴ is 1",
        run: || taken(&with_wall(r#""patches": 18446744073709551615"#)),
        recorded: refused("at most 100000 are allowed in a scene (--max-patches)"),
    },
    Case {
        name: "refusals/divisions-4e9",
        asks: "a Bézier patch of 4·10⁹ divisions",
        expects: "refused with the count of triangles",
        because: "at most 5 million triangles unless --max-triangles says otherwise; 3.2·10¹⁹ are asked for",
        run: || {
            let points = vec!["[0,0,0]"; 16].join(",");
            taken(&with_objects(&format!(
                r#"{{ "name": "sheet", "material": "m", "bezier": {{ "divisions": 4000000000, "patches": [[{points}]] }} }}"#
            )))
        },
        recorded: refused("at most 5000000 are allowed in a scene (--max-triangles)"),
    },
    Case {
        name: "refusals/mesh-over-the-limit",
        asks: "a mesh of two triangles where one is allowed",
        expects: "refused with the mesh, its count and the limit",
        because: "limits hold for the whole scene, and to the last triangle",
        run: || {
            let mesh = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
            let limits = Limits {
                max_triangles: 1,
                ..Limits::default()
            };
            let text = with_objects(
                r#"{ "name": "pot", "material": "m", "mesh": { "file": "pot.obj" } }"#,
            );
            let read = read(text.as_bytes(), &limits, &mut |_| Ok(mesh.into()));
            answer(read.map_err(|error| error.to_string()))
        },
        recorded: refused("found 2 triangles; at most 1 are allowed (--max-triangles)"),
    },
    Case {
        name: "refusals/brackets-1e5",
        asks: "10⁵ opening brackets where a wall is expected",
        expects: "refused at the first, with the stack untouched",
        because: "nothing recurses into what has the wrong type",
        run: || taken(&with_objects(&"[".repeat(100_000))),
        recorded: refused("objects[0]: found a list; expected an object"),
    },
    Case {
        name: "refusals/number-1e400",
        asks: "a background of 10⁴⁰⁰, which no f64 holds",
        expects: "refused with line and column",
        because: "it is not to become an infinity",
        run: || {
            taken(r#"{ "schema": 1, "background": [0, 0, 1e400], "materials": {}, "objects": [] }"#)
        },
        recorded: refused("background[2]"),
    },
    Case {
        name: "refusals/coordinate-1e76",
        asks: "a wall with a corner at 10⁷⁶",
        expects: "refused with the corner and the range",
        because: "up to 10⁷⁵ fourth powers stay finite",
        run: || taken(&with_wall(r#""patches": 1"#).replace("[1,1,0]", "[1e76,1,0]")),
        recorded: refused("allowed are numbers from -1e75 to 1e75"),
    },
    Case {
        name: "refusals/polygon-on-a-line",
        asks: "a polygon whose corners lie on a line, no coordinate of which is exact in binary",
        expects: "refused: a polygon has an area",
        because: "what rounding leaves of the area is none",
        run: || {
            let line = "[0.1,0.1,0.1],[0.2,0.2,0.2],[0.7,0.7,0.7]";
            taken(&with_wall(r#""patches": 1"#).replace("[0,0,0],[1,0,0],[1,1,0],[0,1,0]", line))
        },
        recorded: refused("objects[0].polygon.vertices: found vertices on one line"),
    },
    Case {
        name: "refusals/reflectance-above-1",
        asks: "a reflectance one ulp above 1",
        expects: "refused: it would make light",
        because: "reflectances lie in [0, 1], both ends included",
        run: || {
            let above = format!(r#""reflectance": [1, 1, {:?}]"#, 1.0_f64.next_up());
            taken(&with_wall(r#""patches": 1"#).replace(r#""reflectance": [1, 1, 1]"#, &above))
        },
        recorded: refused(
            "materials.m.reflectance[2]: found 1.0000000000000002; allowed are numbers from 0 to 1",
        ),
    },
    Case {
        name: "refusals/radiosity-of-a-plane",
        asks: "the patches of an infinite plane",
        expects: "refused with the object and what stands in its place",
        because: "an infinite plane has infinitely many patches of one size",
        run: || {
            divided(
                r#"{ "name": "floor", "material": "m", "plane": { "point": [0,0,0], "normal": [0,1,0] } }"#,
                100,
            )
        },
        recorded: refused("objects[0]: found the plane \"floor\", which has no end"),
    },
    Case {
        name: "refusals/patches-of-one-scene",
        asks: "three spheres of 128 patches where 300 are allowed, none of them asked for by a key",
        expects: "refused at the third, counted before it is divided",
        because: "the limit holds for what the scene makes, asked for or not",
        run: || {
            let ball = |i: u32| {
                format!(
                    r#"{{ "name": "{i}", "material": "m", "sphere": {{ "center": [0,0,0], "radius": 1 }} }}"#
                )
            };
            divided(&[0, 1, 2].map(ball).join(","), 300)
        },
        recorded: refused("makes 128 patches here and 384 so far; at most 300 are allowed"),
    },
];

/// A scene of these objects, of one material.
fn with_objects(objects: &str) -> String {
    format!(
        r#"{{ "schema": 1, "materials": {{ "m": {{ "reflectance": [1, 1, 1] }} }}, "objects": [{objects}] }}"#
    )
}

/// A scene of one quadrilateral.
fn with_wall(key: &str) -> String {
    with_objects(&format!(
        r#"{{ "name": "wall", "material": "m", "polygon": {{ "vertices": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }}, {key} }}"#
    ))
}

fn taken(text: &str) -> Result<Ran, String> {
    answer(scene(text))
}

fn divided(objects: &str, most: u64) -> Result<Ran, String> {
    let scene = scene(&with_objects(objects))?;
    answer(Patches::of(&scene, most).map_err(|error| error.to_string()))
}

/// What was taken ought to have been refused.
fn answer<T>(taken: Result<T, String>) -> Result<Ran, String> {
    taken.map(|_| Measured::share(1, 1).into())
}
