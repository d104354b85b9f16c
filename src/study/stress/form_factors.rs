//! Form factors against closed forms: near and far, touching and folded, slivers, discs, and what each method makes of its worst pair.

use super::case::{Case, Measured, Ran, degrades, holds};
use super::squares::{
    ADJACENT, EXACT, OPPOSITE, X, Y, Z, between, by, discs, enclosure, far, fold, folded, hemicube,
    parallel, perpendicular, relative, square, textbook,
};
use crate::algorithms::form_factor::{
    Blockers, FormFactors, Method, Report, area_to_area, contour, element_to_polygon,
};
use crate::record::Unrecorded;
use crate::scene::patches::Patches;
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

const SERIES: &str =
    "(1 − 2/(3d²))/(πd²): the mean of the kernel over both squares, to the order of 1/d⁴";

pub const CASES: &[Case] = &[
    Case {
        name: "form-factors/parallel-0.1",
        asks: "unit squares facing each other at distance 0.1",
        expects: "0.826994522397256578",
        because: "Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11, at 30 digits",
        run: || relative(parallel(0.1), 0.826_994_522_397_256_6),
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/parallel-1e-3",
        asks: "unit squares facing each other at distance 10⁻³",
        expects: "0.99800…, by the closed form, in which nothing cancels there",
        because: "Howell C-11; near contact the integrand is a spike of width 10⁻³",
        run: || relative(parallel(1e-3), textbook(1e-3)),
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/parallel-1e3",
        asks: "unit squares facing each other at distance 10³",
        expects: "3.18309673977380257·10⁻⁷",
        because: "Howell C-11 at 30 digits",
        run: || relative(parallel(1e3), 3.183_096_739_773_803e-7),
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/parallel-1e6",
        asks: "unit squares facing each other at distance 10⁶",
        expects: "3.1830988618…·10⁻¹³",
        because: SERIES,
        run: || relative(parallel(1e6), far(1e6)),
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/textbook-1e3",
        asks: "the same at 10³ by the textbook's formula of logarithms and arc tangents",
        expects: "3.18309673977380257·10⁻⁷",
        because: "terms of size 10⁶ cancel to 10⁻⁷: the condition number of the sum is 10¹²",
        run: || Ok(Ran::from(Measured::relative(textbook(1e3), far(1e3))).conditioned(1e12)),
        recorded: degrades(EXACT, 1e-3),
    },
    Case {
        name: "form-factors/fold-30",
        asks: "unit squares with a common edge, folded to 30°",
        expects: "0.619028323090803253",
        because: "Howell C-16 at 30 digits; the integrand is singular along the edge",
        run: || relative(folded(30.0), 0.619_028_323_090_803_3),
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/fold-90",
        asks: "unit squares with a common edge at a right angle",
        expects: "0.200043776075403154",
        because: "Howell C-14 at 30 digits",
        run: || relative(folded(90.0), ADJACENT),
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/fold-150",
        asks: "unit squares with a common edge, opened to 150°",
        expects: "0.0213453254126893704",
        because: "Howell C-16 at 30 digits",
        run: || relative(folded(150.0), 0.021_345_325_412_689_37),
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/fold-1-long",
        asks: "strips 10⁶ long and 1 wide with a common edge, folded to 1°",
        expects: "1 − sin 0.5°",
        because: "crossed strings (Hottel 1954); what leaves at the ends is of the order of the gap over the length",
        run: || {
            let (sin, cos) = 1.0_f64.to_radians().sin_cos();
            let (floor, lid) = (square(DVec3::ZERO, 1e6 * X, Y), cos * Y + sin * Z);
            let found = between(&floor, &square(DVec3::ZERO, lid, 1e6 * X), EXACT);
            relative(found, 1.0 - 0.5_f64.to_radians().sin())
        },
        recorded: holds(1e-7),
    },
    Case {
        name: "form-factors/corner-only",
        asks: "perpendicular unit squares that share one corner and no edge",
        expects: "F of 2×1 to 2×1 with a common edge, less F of one pair with a common edge",
        because: "the algebra of form factors: A F of the whole is twice each of the two, all 1 in area; Hamilton & Morgan 1952",
        run: || {
            let found = between(&square(DVec3::ZERO, X, Y), &square(X, Z, X), EXACT);
            relative(found, perpendicular(0.5, 0.5) - ADJACENT)
        },
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/near-parallel",
        asks: "unit squares at distance 1, one of them turned about its middle by 10⁻⁸ rad",
        expects: "as of parallel ones, 0.199824895698387383: the change is of second order",
        because: "symmetry; the closed form of Schröder & Hanrahan 1993 divides by sin²α and loses 8 % there",
        run: || {
            let turn = DMat3::from_rotation_x(1e-8);
            let middle = 0.5 * (X + Y);
            let above = square(Z, Y, X).map(|p| turn * (p - middle - Z) + middle + Z);
            relative(between(&square(DVec3::ZERO, X, Y), &above, EXACT), OPPOSITE)
        },
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/slivers-1e-6",
        asks: "parallel strips 1 long and w = 10⁻⁶ wide at distance 1",
        expects: "w/4 (1 + O(w²))",
        because: "w/π ∫∫ ds dt/(1 + (s − t)²)² over the unit square, which is π/4",
        run: || {
            let w = 1e-6;
            let found = between(&square(DVec3::ZERO, X, w * Y), &square(Z, w * Y, X), EXACT);
            relative(found, 0.25 * w)
        },
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/discs",
        asks: "coaxial discs of radius 1 at distance 1, as the limit of polygons of 32 and 64 sides",
        expects: "2/(3 + √5) = 0.381966011250105152",
        because: "Howell C-41 in the form that does not cancel; n sides are off by 1/n², which two of them take away",
        run: || {
            let limit = (4.0 * discs(64) - discs(32)) / 3.0;
            relative(limit, 2.0 / (3.0 + 5.0_f64.sqrt()))
        },
        recorded: holds(1e-5),
    },
    Case {
        name: "form-factors/corner-rectangle",
        asks: "an element of 10⁻⁴ under the corner of a parallel unit square at distance 1",
        expects: "atan(1/√2)/(π√2) = 0.138531605994892997",
        because: "Howell B-3 with a = b = c = 1; the element's size enters with its square",
        run: || {
            let small = 1e-4;
            let element = square(-0.5 * small * (X + Y), small * X, small * Y);
            let exact = 0.5_f64.sqrt().atan() / (PI * 2.0_f64.sqrt());
            relative(between(&element, &square(Z, Y, X), EXACT), exact)
        },
        recorded: holds(1e-8),
    },
    Case {
        name: "form-factors/below-the-horizon",
        asks: "an element beside a wall, of which nine tenths lie below the element's plane",
        expects: "as of the part above, which is another wall",
        because: "what lies below the horizon is clipped, not counted as negative",
        run: || {
            let element = square(DVec3::ZERO, 1e-3 * X, 1e-3 * Y);
            let wall = |low: f64| square(-4.0 * X + low * Z - Y, (3.0 - low) * Z, 8.0 * X);
            let above = between(&element, &wall(0.0), EXACT);
            relative(between(&element, &wall(-27.0), EXACT), above)
        },
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/one-to-1e8",
        asks: "a unit floor, and a wall of 10⁻⁴ × 10⁻⁴ on it: F of one times 10⁸ over F of the other",
        expects: "1: reciprocity",
        because: "A_i F_ij = A_j F_ji",
        run: || {
            let floor = square(DVec3::ZERO, X, Y);
            let small = square(0.5 * X, 1e-4 * Z, 1e-4 * X);
            let [there, back] = [
                between(&floor, &small, EXACT),
                between(&small, &floor, EXACT),
            ];
            relative(there * 1e8 / back, 1.0)
        },
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/one-plane",
        asks: "squares side by side in one tilted plane",
        expects: "0, exactly, although rounding moves corners off the plane",
        because: "a slack of 16 ε around each plane",
        run: || {
            let turn = DMat3::from_rotation_x(0.7) * DMat3::from_rotation_z(0.4);
            let [i, j] =
                [DVec3::ZERO, X].map(|origin| square(origin, X, Y).map(|p| turn * p + 0.1));
            Ok(Measured::absolute(between(&i, &j, EXACT), 0.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "form-factors/scales-1e-6-to-1e6",
        asks: "the fold of 30° 10⁻⁶ and 10⁶ as large, turned, away from the origin: the larger error",
        expects: "0: a form factor has no unit",
        because: "the logarithm of the unit cancels as edges close up",
        run: || {
            let exact = 0.619_028_323_090_803_3;
            let turn = DMat3::from_rotation_x(0.3) * DMat3::from_rotation_y(1.0);
            let worst = [1e-6, 1e6].map(|scale| {
                let [i, j] = fold(30.0)
                    .map(|square| square.map(|p| scale * (turn * p + DVec3::new(0.3, 4.0, 1.0))));
                between(&i, &j, EXACT) / exact
            });
            let far_from_1 = |a: f64, b: f64| {
                if (a - 1.0).abs() > (b - 1.0).abs() {
                    a
                } else {
                    b
                }
            };
            relative(far_from_1(worst[0], worst[1]), 1.0)
        },
        recorded: holds(EXACT),
    },
    Case {
        name: "form-factors/cube-rows",
        asks: "the row sum farthest from 1 in a closed cube of 3×3 patches a face, at 10⁷ from the origin",
        expects: "1: no light leaves a closed room",
        because: "Σ_j F_ij = 1",
        run: || {
            let patches =
                Patches::of(&enclosure("", 3, 1e7)?, 1000).map_err(|error| error.to_string())?;
            let method = Method::Auto { tolerance: EXACT };
            let matrix = FormFactors::new(&patches, method, None).matrix();
            let [low, high] =
                Report::of(&patches.areas(), &matrix, &vec![true; patches.len()]).row_sums;
            relative(if 1.0 - low > high - 1.0 { low } else { high }, 1.0)
        },
        recorded: holds(1e-7),
    },
    Case {
        name: "form-factors/hidden",
        asks: "opposite walls of a cube with a screen right through it",
        expects: "0, exactly",
        because: "no line of sight passes an unbroken screen",
        run: || {
            let screen = r#", { "name": "screen", "material": "m", "polygon": { "vertices": [[0,0,0.5],[1,0,0.5],[1,1,0.5],[0,1,0.5]] } }"#;
            let scene = enclosure(screen, 1, 0.0)?;
            let patches = Patches::of(&scene, 1000).map_err(|error| error.to_string())?;
            let blockers = Blockers::of(&scene, &patches);
            let method = Method::Auto { tolerance: 1e-6 };
            let factors = FormFactors::new(&patches, method, Some(&blockers));
            Ok(Measured::absolute(factors.pair(0, 1, &mut Unrecorded), 0.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "form-factors/area-touching",
        asks: "area to area at 8⁴ Gauss points, squares with a common edge at a right angle",
        expects: "0.200043776075403154; the method is off by a third where patches touch",
        because: "the kernel 1/r² is singular along the edge",
        run: || {
            by(90.0, |i, j| {
                area_to_area::exchange(i, j, [8, 8], &mut Unrecorded)
            })
        },
        recorded: degrades(1e-6, 0.4),
    },
    Case {
        name: "form-factors/element-touching",
        asks: "element to polygon at 8² Gauss points, squares folded to 30°",
        expects: "0.619028323090803253; the method is off by some 10⁻⁴ there",
        because: "the element's view changes without bounds toward the edge",
        run: || {
            by(30.0, |i, j| {
                element_to_polygon::exchange(i, j, 8, &mut 0, &mut Unrecorded)
            })
        },
        recorded: degrades(1e-6, 1e-3),
    },
    Case {
        name: "form-factors/contour-touching",
        asks: "the contour integral, squares folded to 30°",
        expects: "0.619028323090803253",
        because: "∫∫ ln|s − t| = L² ln L − 3L²/2 along the common edge, exactly",
        run: || by(30.0, |i, j| contour::exchange(i, j, 1e-12, &mut Unrecorded)),
        recorded: holds(1e-10),
    },
    Case {
        name: "form-factors/hemicube-centre",
        asks: "a hemicube of 128 pixels at the centre, opposite walls of a cube",
        expects: "0.199824895698387383; it is off by a fifth at any resolution",
        because: "what the centre sees is not what the patch sees (the proximity assumption)",
        run: || hemicube(128, 1),
        recorded: degrades(1e-3, 0.25),
    },
    Case {
        name: "form-factors/hemicube-4x4",
        asks: "hemicubes of 128 pixels at 4×4 points, opposite walls of a cube",
        expects: "0.199824895698387383, to about a hundredth",
        because: "the mean over points is what the patch sees",
        run: || hemicube(128, 4),
        recorded: degrades(1e-3, 0.02),
    },
];
