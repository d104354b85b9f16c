//! Scan conversion: slivers, edges on pixel centres, polygons seen from the edge or far larger than the screen, normals that cancel.

use super::case::{Case, Measured, Ran, degrades, holds};
use super::ramps::Single;
use super::scenes::{ROOM, differing, moved, picture, scene, staged};
use super::screen::{
    PIXELS, SIZE, add, covered, drawn, drift, fan, fill, floor, larger, place, sum,
};
use crate::algorithms::frame::Frame;
use crate::algorithms::scan_line::Corner;
use crate::algorithms::vertex_normal::{self, FaceCorner, vertex_normal};
use crate::color::Rgb;
use crate::record::Unrecorded;
use crate::render::Method;
use crate::scene::{Mesh, VertexNormals};
use glam::DVec3;

pub const CASES: &[Case] = &[
    Case {
        name: "scan/no-area",
        asks: "triangles whose corners lie on a slanting line, on a row of pixel centres, and in one centre: their pixels",
        expects: "none",
        because: "half-open spans; a horizontal edge (y_1 = y_2) is in no edge table, so that nothing is divided by y_2 − y_1",
        run: || {
            let line = [(2.0, 2.0), (20.0, 9.0), (11.0, 5.5)];
            let row = [(2.0, 5.5), (20.0, 5.5), (9.0, 5.5)];
            let count = [&line, &row, &[(5.5, 5.5); 3]].map(|polygon| covered(polygon));
            Ok(Measured::absolute(count.map(sum).iter().sum(), 0.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/sliver-1e-9",
        asks: "a sliver 10⁻⁹ pixels wide and 10 high over the centres of a column: its pixels",
        expects: "10",
        because: "a pixel belongs to a polygon when its centre is inside, however little else is",
        run: || {
            let (left, right) = (7.5 - 5e-10, 7.5 + 5e-10);
            let sliver = [(left, 2.0), (right, 2.0), (right, 12.0), (left, 12.0)];
            Ok(Measured::absolute(sum(covered(&sliver)), 10.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/corner-on-a-centre",
        asks: "four squares of 8×8 that meet in a pixel's centre, their edges on centres: pixels drawn not once",
        expects: "none",
        because: "spans and edges are half-open: left and top belong, right and bottom do not",
        run: || {
            let mut count = vec![0; PIXELS];
            for (x, y) in [(4.5, 4.5), (12.5, 4.5), (4.5, 12.5), (12.5, 12.5)] {
                let square = [(x, y), (x + 8.0, y), (x + 8.0, y + 8.0), (x, y + 8.0)];
                add(&mut count, &covered(&square));
            }
            let inside = |pixel: usize| {
                let within = |place: u32| (4..20).contains(&place);
                within(pixel as u32 % SIZE) && within(pixel as u32 / SIZE)
            };
            let wrong = (0..PIXELS).filter(|&pixel| count[pixel] != u32::from(inside(pixel)));
            Ok(Measured::share(wrong.count(), PIXELS).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/fan-on-half-pixels",
        asks: "200 stars cut into a fan of triangles, all corners on half pixels: pixels drawn more or less often than by the star",
        expects: "none",
        because: "an edge is the same from both sides, and each centre on it belongs to one of them",
        run: || {
            let wrong: usize = (0..200).map(fan).sum();
            Ok(Measured::share(wrong, 200 * PIXELS).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/polygon-1e6-screens",
        asks: "the largest error of a value from 0 to 1 down a polygon 10⁶ times as large as the screen",
        expects: "(y − y_1)/(y_2 − y_1)",
        because: "the first row of the screen is found directly, and 24 additions follow",
        run: || larger(1e6),
        recorded: holds(1e-14),
    },
    Case {
        name: "scan/polygon-1e12-screens",
        asks: "the same, 10¹² times as large as the screen",
        expects: "(y − y_1)/(y_2 − y_1)",
        because: "the first row of the screen is found directly, and 24 additions follow",
        run: || larger(1e12),
        recorded: holds(1e-14),
    },
    Case {
        name: "scan/drift-of-a-long-span",
        asks: "the largest difference of a value by increments and directly on the longest span, 16384 pixels",
        expects: "0; at most 16384 of half an ulp",
        because: "one addition a pixel, each rounded",
        run: || {
            let double = drift(Rgb::BLACK, Rgb::WHITE, |color| color.r);
            let single = drift(Single(0.0), Single(1.0), |value| value.0.into());
            Ok(Ran::from(Measured::absolute(double, 0.0)).and_f32(Measured::absolute(single, 0.0)))
        },
        recorded: degrades(2.3e-16, 16384.0 * 1.2e-16).f32_degrades(1.2e-7, 16384.0 * 6e-8),
    },
    Case {
        name: "scan/depth-1e-12-apart",
        asks: "two polygons at depths 1 and 1 + 10⁻¹², the farther one drawn last: pixels that show it",
        expects: "none",
        because: "1/depth of both differs by 10⁻¹², and a span's increments are off by 10⁻¹⁵",
        run: || {
            let square = [(2.0, 2.0), (22.0, 3.0), (21.0, 22.0), (3.0, 20.0)];
            let mut frame = Frame::new(SIZE, 0..SIZE, Rgb::BLACK);
            for (depth, value) in [(1.0, 0.0), (1.0 + 1e-12, 1.0)] {
                let corners = square.map(|(x, y)| Corner {
                    position: depth * place(x, y),
                    value: Rgb::splat(value),
                });
                fill(&corners, &mut frame, |_, _| {});
            }
            let wrong = frame.color.iter().filter(|color| color.r > 0.0).count();
            Ok(Ran::from(Measured::share(wrong, PIXELS)).conditioned(1e12))
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/edge-on",
        asks: "a slanting polygon whose plane holds the eye: its pixels",
        expects: "none",
        because: "on the screen it is a line, but for rounding, which reaches no centre",
        run: || {
            let sheet = r#"[[-1, -0.37, 2], [1, 0.37, 2], [3, 1.11, 9], [-3, -1.11, 9]]"#;
            drawn(sheet).map(|count| Measured::absolute(count, 0.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/behind-the-eye-1e4",
        asks: "a floor 1 below the eye that reaches from 10⁴ behind it to 10⁴ before it: its pixels of 24×24",
        expects: "all below the horizon: 288",
        because: "it is clipped at the near plane before the division by depth; its far edge is 10⁻³ pixels below the horizon",
        run: || floor("1e4"),
        recorded: holds(0.0),
    },
    Case {
        name: "scan/behind-the-eye-1e6",
        asks: "the same floor from 10⁶ behind the eye to 10⁶ before it",
        expects: "all below the horizon: 288",
        because: "the near plane stands at a millionth of the distance to the nearest vertex or plane of a polygon, whichever is less",
        run: || floor("1e6"),
        recorded: holds(0.0),
    },
    Case {
        name: "scan/wall-1e7",
        asks: "a wall at distance 1 that reaches 10⁷ to all sides: its pixels of 24×24",
        expects: "all 576, as rays see it",
        because: "the near plane stands at a millionth of the distance to the nearest vertex or plane of a polygon, whichever is less",
        run: || {
            let wall = "[[-1e7, -1e7, 1], [-1e7, 1e7, 1], [1e7, 1e7, 1], [1e7, -1e7, 1]]";
            drawn(wall).map(|count| Measured::absolute(count, 576.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/opposite-normals",
        asks: "the length of the normal at a vertex of two faces back to back, whose sum is 0",
        expects: "1: the normal of the first face, as stated",
        because: "0/|0| is no direction",
        run: || {
            let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
            let mesh = Mesh::new(&corners, [[0, 1, 2], [2, 1, 0]], &[]);
            let (mesh, face, corner) = (&mesh, 0, 0);
            let at = FaceCorner { mesh, face, corner };
            let normals = VertexNormals::AVERAGED;
            let normal = vertex_normal::<vertex_normal::Event>(at, normals, &mut Unrecorded);
            Ok(Measured::ulps(normal.length(), 1.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/unit-of-length",
        asks: "the room by Gouraud's method with lengths times 2⁻²⁰⁰ and 2²⁰⁰: pixels that change",
        expects: "none, to the bit",
        because: "a power of two changes no digit; the near plane goes with the nearest vertex",
        run: || {
            let [one, small, large] = [0, -200, 200].map(|exponent| {
                let scaled = moved(scene(ROOM)?, 2.0_f64.powi(exponent), DVec3::ZERO);
                Ok::<_, String>(picture(&staged(scaled, [48, 36], 1)?, Method::Gouraud))
            });
            let one = one?;
            let wrong = differing(&one, &small?, 0.0) + differing(&one, &large?, 0.0);
            Ok(Measured::share(wrong, 2 * one.len()).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "scan/coordinates-1e7",
        asks: "the same room moved by (10⁷, −10⁷, 10⁷): pixels that change by more than 10⁻⁶",
        expects: "none but those where an edge passes over the pixel's centre",
        because: "places are known to 2·10⁻⁹ there",
        run: || {
            let by = DVec3::new(1e7, -1e7, 1e7);
            let [near, far] = [DVec3::ZERO, by].map(|by| {
                let setup = staged(moved(scene(ROOM)?, 1.0, by), [48, 36], 1)?;
                Ok::<_, String>(picture(&setup, Method::Gouraud))
            });
            let (near, far) = (near?, far?);
            Ok(Measured::share(differing(&near, &far, 1e-6), near.len()).into())
        },
        recorded: holds(0.0),
    },
];
