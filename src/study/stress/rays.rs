//! Where rays meet: spheres from far away, surfaces that are left, edges that are shared, coordinates of all sizes.

use super::aimed::{
    BALLS, ball, corner_leaks, edge_leaks, lost_hits, offset, polygon_self_hits, self_hits,
    spheres, toward, wrong_hits,
};
use super::case::{Case, Measured, Ran, degrades, holds};
use super::scenes::{ROOM, alone, differing, look, moved, picture, scene, staged};
use crate::numeric::{plain_sphere_roots, sphere_roots};
use crate::render::Method;
use crate::scene::Shape;
use crate::scene::primitives::{Ray, leaving};
use glam::DVec3;

const SIZE: [u32; 2] = [48, 36];

const STABLE: &str = "b² − c from the perpendicular distance, the smaller root as c/q (Haines, Günther & Akenine-Möller 2019)";
const PLAIN: &str = "b² and c are D², and the radius is lost in them where D² is above 1/ε";
const LOST: &str = "b² − c is a multiple of the ulp of D², 8 in f32 at 10⁴ and 2 in f64 at 10⁸; what is not lost is off by the radius";

pub const CASES: &[Case] = &[
    Case {
        name: "rays/sphere-1e3-plain",
        asks: "10⁴ rays at the unit sphere from 10³ away, by the textbook's roots b ± √(b² − c)",
        expects: "no nearest hit lost, or off by more than a tenth of the radius",
        because: PLAIN,
        run: || spheres(1e3, plain_sphere_roots, plain_sphere_roots),
        recorded: holds(0.0).f32_degrades(0.0, 0.09),
    },
    Case {
        name: "rays/sphere-1e3-stable",
        asks: "the same rays from 10³ away, by the stable roots",
        expects: "no nearest hit lost, or off by more than a tenth of the radius",
        because: STABLE,
        run: || spheres(1e3, sphere_roots, sphere_roots),
        recorded: holds(0.0).f32_holds(0.0),
    },
    Case {
        name: "rays/sphere-1e4-plain",
        asks: "the same rays from 10⁴ away, by the textbook's roots: hits that are lost altogether",
        expects: "none",
        because: LOST,
        run: || {
            let double = lost_hits::<f64>(1e4, plain_sphere_roots);
            let single = lost_hits::<f32>(1e4, plain_sphere_roots);
            Ok(Ran::from(double).and_f32(single).conditioned(1e8))
        },
        recorded: holds(0.0).f32_degrades(0.0, 0.25),
    },
    Case {
        name: "rays/sphere-1e5-stable",
        asks: "the same rays from 10⁵ away, by the stable roots",
        expects: "no nearest hit lost, or off by more than a tenth of the radius",
        because: STABLE,
        run: || spheres(1e5, sphere_roots, sphere_roots),
        recorded: holds(0.0).f32_holds(0.0),
    },
    Case {
        name: "rays/sphere-1e8-plain",
        asks: "the same rays from 10⁸ away, by the textbook's roots: hits that are lost altogether",
        expects: "none",
        because: LOST,
        run: || Ok(Ran::from(lost_hits::<f64>(1e8, plain_sphere_roots)).conditioned(1e16)),
        recorded: degrades(0.0, 0.25),
    },
    Case {
        name: "rays/sphere-1e8-stable",
        asks: "the same rays from 10⁸ away, by the stable roots",
        expects: "no nearest hit lost, or off by more than a tenth of the radius",
        because: STABLE,
        run: || Ok(Ran::from(wrong_hits::<f64>(1e8, sphere_roots)).conditioned(1e16)),
        recorded: holds(0.0),
    },
    Case {
        name: "rays/sphere-of-1e74",
        asks: "a sphere of radius 10⁷⁴ around (0, 0, 10⁷⁵), met along z",
        expects: "t = 9·10⁷⁴",
        because: "D − r; squares are 10¹⁵⁰, and no fourth power is taken",
        run: || {
            let primitives = ball(1e75 * DVec3::Z, 1e74);
            let hit = primitives.nearest(&Ray {
                origin: DVec3::ZERO,
                direction: DVec3::Z,
            });
            let t = hit.ok_or("the ray missed")?.t;
            Ok(Measured::ulps(t, 9e74).into())
        },
        recorded: holds(2.0),
    },
    Case {
        name: "rays/self-hits-sphere",
        asks: "12000 rays that leave a sphere outward, of radius 10⁻⁶, 1 and 10⁶, at the origin and 10⁷ away",
        expects: "none meets the sphere again",
        because: "the origin is moved past the error bound of the position (Pharr, Jakob & Humphreys 2016, §3.9.5)",
        run: || Ok(self_hits(&BALLS, leaving).into()),
        recorded: holds(0.0),
    },
    Case {
        name: "rays/self-hits-no-offset",
        asks: "the same rays, started where the surface was met",
        expects: "about half meet it again: what rounding leaves is inside as often as outside",
        because: "the position is off the sphere by an ulp or so to either side",
        run: || Ok(self_hits(&BALLS, |surface, direction| offset(surface, direction, 0.0)).into()),
        recorded: degrades(0.0, 0.6),
    },
    Case {
        name: "rays/self-hits-epsilon",
        asks: "rays that leave a sphere of radius 10⁹, started 10⁻⁹ above the surface",
        expects: "some meet it again: a fixed ε is right for one scale",
        because: "positions are known to 10⁻⁷ there",
        run: || {
            let large = [(DVec3::ZERO, 1e9)];
            Ok(self_hits(&large, |surface, direction| {
                offset(surface, direction, 1e-9)
            })
            .into())
        },
        recorded: degrades(0.0, 0.6),
    },
    Case {
        name: "rays/self-hits-polygon",
        asks: "12000 rays that leave a tilted quadrilateral to either side, of sizes 10⁻⁶ to 10⁶, up to 10⁷ away",
        expects: "none meets it again",
        because: "as for spheres; the error bound holds the position and the shear of the next test",
        run: || Ok(polygon_self_hits().into()),
        recorded: holds(0.0),
    },
    Case {
        name: "rays/watertight-edge",
        asks: "20000 rays aimed at the diagonal of random quadrilaterals, which two triangles share",
        expects: "none passes between the triangles",
        because: "the sign of the area with an edge is exact, and 0 is inside on both sides (Woop, Benthin & Wald 2013)",
        run: || Ok(edge_leaks().into()),
        recorded: holds(0.0),
    },
    Case {
        name: "rays/watertight-corner",
        asks: "5000 rays aimed at the corner that seven triangles share",
        expects: "none passes between them",
        because: "all seven tests see the corner at the same sheared place",
        run: || Ok(corner_leaks().into()),
        recorded: holds(0.0),
    },
    Case {
        name: "rays/sliver-1e-12",
        asks: "1000 rays aimed into a triangle 1 long and 10⁻¹² high",
        expects: "all meet it",
        because: "a ray is aimed to 10⁻¹⁶ at distance 1",
        run: || {
            let corners = [DVec3::ZERO, DVec3::X, DVec3::new(0.5, 1e-12, 0.0)];
            let primitives = alone(Shape::Polygon {
                vertices: corners.to_vec(),
            });
            let lost = (0..1000).filter(|&i| {
                let aimed_at = DVec3::new(0.4 + 2e-4 * f64::from(i), 3e-13, 0.0);
                let origin = DVec3::new(0.5, 0.2, -1.0);
                primitives.nearest(&toward(origin, aimed_at)).is_none()
            });
            Ok(Measured::share(lost.count(), 1000).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "rays/in-the-plane",
        asks: "a ray that runs in a plane and in a polygon, both of which shine",
        expects: "it meets neither: the background, exactly",
        because: "t = 0/0 is no meeting",
        run: || {
            let color = look(
                r#"{ "name": "floor", "material": "lit", "plane": { "point": [0, 0, 0], "normal": [0, 1, 0] } },
                   { "name": "sheet", "material": "lit", "polygon": { "vertices": [[-1, 0, 1], [1, 0, 1], [1, 0, 2], [-1, 0, 2]] } }"#,
                r#""lit": { "emission": [1, 1, 1] }"#,
                r#""background": [0.25, 0.25, 0.25],"#,
                5,
            )?;
            Ok(Measured::ulps(color.r, 0.25).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "rays/unit-of-length",
        asks: "a room of balls, mirror and glass with lengths times 2⁻²⁰⁰ and 2²⁰⁰ (10⁻⁶⁰ and 10⁶⁰)",
        expects: "the same bits in every pixel",
        because: "a power of two changes no digit of any number of the run",
        run: || {
            let [one, small, large] = [0, -200, 200].map(|exponent| {
                let scaled = moved(scene(ROOM)?, 2.0_f64.powi(exponent), DVec3::ZERO);
                Ok::<_, String>(picture(&staged(scaled, SIZE, 6)?, Method::RayTracing))
            });
            let one = one?;
            let wrong = differing(&one, &small?, 0.0) + differing(&one, &large?, 0.0);
            Ok(Measured::share(wrong, 2 * one.len()).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "rays/coordinates-1e7",
        asks: "the same room moved by (10⁷, −10⁷, 10⁷): pixels that change by more than 10⁻⁵",
        expects: "none but those where an edge passes over the pixel's centre",
        because: "places are known to 2·10⁻⁹ there, and a path over glass and mirror makes some hundred times more of it",
        run: || {
            let by = DVec3::new(1e7, -1e7, 1e7);
            let [near, far] = [DVec3::ZERO, by].map(|by| {
                let setup = staged(moved(scene(ROOM)?, 1.0, by), SIZE, 6)?;
                Ok::<_, String>(picture(&setup, Method::RayTracing))
            });
            let (near, far) = (near?, far?);
            Ok(Measured::share(differing(&near, &far, 1e-5), near.len()).into())
        },
        recorded: holds(0.0),
    },
];
