//! Rays that go on: the critical angle, glass that is not there, slabs and bubbles, trees that are deep or large.

use super::case::{Case, Measured, Ran, holds};
use super::scenes::{look, picture, scene, staged};
use crate::numeric::Random;
use crate::numeric::{refracted, refraction_radicand};
use crate::render::{Method, render_counted};
use glam::DVec3;
use num_traits::Float;
use std::num::NonZeroUsize;

pub const CASES: &[Case] = &[
    Case {
        name: "rays/critical-angle-below",
        asks: "1000 indices from 1.05 to 2.5, met from inside 10⁻¹² rad below the critical angle: which turn back",
        expects: "none",
        because: "cos²θ_r = 1 − η² sin²θ_i is 2·10⁻¹² η cos θ_i there, known to 10⁻¹⁶ in f64 and to 10⁻⁷ in f32",
        run: || Ok(critical(-1e-12)),
        recorded: holds(0.0).f32_degrades(0.0, 0.7),
    },
    Case {
        name: "rays/critical-angle-above",
        asks: "the same 10⁻¹² rad above the critical angle: which pass",
        expects: "none",
        because: "the same with the other sign: total internal reflection, marked as such",
        run: || Ok(critical(1e-12)),
        recorded: holds(0.0).f32_degrades(0.0, 0.7),
    },
    Case {
        name: "rays/eta-1",
        asks: "the largest |T − u| of 3000 directions at any angle, also grazing by 10⁻³⁰⁰, with η = 1",
        expects: "0: straight through, exactly",
        because: "(1 − η)(1 + η) is 0, and √(x·x) is x in binary arithmetic",
        run: || {
            Ok(Ran::from(Measured::absolute(bend::<f64>(1e-300), 0.0))
                .and_f32(Measured::absolute(bend::<f32>(1e-30), 0.0)))
        },
        recorded: holds(0.0).f32_holds(0.0),
    },
    Case {
        name: "rays/snell-grazing",
        asks: "the sine inside glass of 1.5 of a ray that grazes it by 10⁻⁹ rad",
        expects: "sin θ_i / 1.5 = 2/3",
        because: "Snell's law; cos θ_i, 10⁻⁹, has no part in it",
        run: || {
            let (cos, sin) = 1e-9_f64.sin_cos();
            Ok(Ran::from(Measured::ulps(inside(sin, cos)[0], sin / 1.5))
                .and_f32(Measured::ulps(inside(sin as f32, cos as f32)[0], sin / 1.5)))
        },
        recorded: holds(2.0).f32_holds(2.0),
    },
    Case {
        name: "rays/slab-shift",
        asks: "how far a slab of thickness 1 and index 1.5 shifts a ray at 45° sideways",
        expects: "0.3291423081773203",
        because: "(1 − tan θ_r) cos 45° with sin θ_r = sin 45°/1.5",
        run: || {
            let exact = 0.329_142_308_177_320_3;
            Ok(Ran::from(Measured::ulps(shift::<f64>(), exact))
                .and_f32(Measured::ulps(shift::<f32>(), exact)))
        },
        recorded: holds(4.0).f32_holds(4.0),
    },
    Case {
        name: "rays/air-bubble",
        asks: "a bubble of radius 1 that shines, in glass of 1.5 and radius 2, seen at heights 1 ± 10⁻⁶ and 1.5 ± 10⁻⁶",
        expects: "its light twice, once, once, not at all",
        because: "sin θ = h/1.5 at the bubble: refracted into it below h = 1, turned back up to 1.5, passed by beyond",
        run: || {
            let seen = [
                (0.999_999, 2.0),
                (1.000_001, 1.0),
                (1.499_999, 1.0),
                (1.500_001, 0.0),
            ];
            let mut wrong = 0;
            for (height, expected) in seen {
                wrong += usize::from(bubble(height)? != expected);
            }
            Ok(Measured::share(wrong, seen.len()).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "rays/depth-64-plates",
        asks: "two mirrors of 0.5 that give off 1 face each other; 64 levels, as many as there may be",
        expects: "2 − 2⁻⁶³, that is 2",
        because: "1 + 1/2 + 1/4 + …, whose sums are exact in f64 up to the last, which rounds to 2",
        run: || {
            let color = look(
                r#"{ "name": "ahead", "material": "mirror", "plane": { "point": [0, 0, 1], "normal": [0, 0, -1] } },
                   { "name": "behind", "material": "mirror", "plane": { "point": [0, 0, -1], "normal": [0, 0, 1] } }"#,
                r#""mirror": { "emission": [1, 1, 1], "reflection": 0.5 }"#,
                "",
                64,
            )?;
            Ok(Measured::ulps(color.r, 2.0).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "rays/depth-64-ball",
        asks: "inside a ball of mirrors of 0.98 that give off 0.01, 64 levels: every reflection met by rounding's leave",
        expects: "0.01 (1 − 0.98⁶⁴)/(1 − 0.98) = 0.36278…",
        because: "the geometric series; no ray may leak out of the ball or meet it twice",
        run: || {
            let color = look(
                r#"{ "name": "ball", "material": "mirror", "sphere": { "center": [0.1, 0.2, 0], "radius": 3 } }"#,
                r#""mirror": { "emission": [0.01, 0.01, 0.01], "reflection": 0.98 }"#,
                "",
                64,
            )?;
            let exact = 0.01 * (1.0 - 0.98_f64.powi(64)) / 0.02;
            Ok(Measured::relative(color.r, exact).into())
        },
        recorded: holds(1e-14),
    },
    Case {
        name: "rays/a-million-rays",
        asks: "a tree of 20 levels between 40 plates that reflect 0.5, let 0.5 pass and give off 1: its rays",
        expects: "2²⁰ − 1 rays, which carry 20, exactly",
        because: "each ray meets a plate, and has two children; each level carries 1",
        run: || {
            let plate = |k: i32| {
                let z = f64::from(k) - 19.5;
                format!(
                    r#"{{ "name": "{k}", "material": "m", "plane": {{ "point": [0, 0, {z}], "normal": [0, 0, 1] }} }}"#
                )
            };
            let plates: Vec<String> = (0..40).map(plate).collect();
            let text = format!(
                r#"{{ "schema": 1, "camera": {{ "eye": [0, 0, 0], "target": [0, 0, 1], "up": [0, 1, 0], "fov_x_degrees": 1 }},
                     "materials": {{ "m": {{ "emission": [1, 1, 1], "reflection": 0.5, "transmission": 0.5 }} }}, "objects": [ {} ] }}"#,
                plates.join(",")
            );
            let setup = staged(scene(&text)?, [1, 1], 20)?;
            let (method, one) = (Method::RayTracing, NonZeroUsize::MIN);
            let (frame, rays) = render_counted(&setup, method, setup.needs(), one, &|_, _| {});
            if frame.color[0].r != 20.0 {
                return Err(format!("the rays carry {}", frame.color[0].r));
            }
            let count = rays.primary + rays.reflected + rays.transmitted;
            Ok(Measured::relative(count as f64, f64::from((1 << 20) - 1)).into())
        },
        recorded: holds(0.0),
    },
    Case {
        name: "rays/light-without-bounds",
        asks: "a glass ball that reflects 10³⁰⁰ of a background of 10³⁰⁰: colours that are no finite numbers",
        expects: "none",
        because: "sums are held within the range of f64",
        run: || {
            let text = r#"{ "schema": 1, "background": [1e300, 1e300, 1e300],
              "camera": { "eye": [0, 0, -4], "target": [0.1, 0.07, 0], "up": [0, 1, 0], "fov_x_degrees": 30 },
              "materials": { "glass": { "reflection": [1e300, 0, 1e-300], "transmission": 0.6, "ior": 1.5 } },
              "objects": [ { "name": "a", "material": "glass", "sphere": { "center": [0, 0, 0], "radius": 1 } } ] }"#;
            let colors = picture(&staged(scene(text)?, [16, 16], 8)?, Method::RayTracing);
            let is_finite = |channel: f64| channel.is_finite();
            let wrong = colors
                .iter()
                .filter(|color| !color.channels().into_iter().all(is_finite));
            Ok(Measured::share(wrong.count(), colors.len()).into())
        },
        recorded: holds(0.0),
    },
];

/// Of 1000 indices, met from inside at the critical angle and `beside` it, the share on the wrong side of it.
fn critical(beside: f64) -> Ran {
    const COUNT: u32 = 1000;
    let mut wrong = [0; 2];
    for i in 0..COUNT {
        let eta = 1.05 + 1.45 * f64::from(i) / f64::from(COUNT);
        let cos_i = ((1.0 / eta).asin() + beside).cos();
        let passes = beside < 0.0;
        wrong[0] += usize::from((refraction_radicand(eta, cos_i) >= 0.0) != passes);
        let single = refraction_radicand(eta as f32, cos_i as f32);
        wrong[1] += usize::from((single >= 0.0) != passes);
    }
    let [double, single] = wrong.map(|wrong| Measured::share(wrong, COUNT as usize));
    // Of the radicand at η = 1.5: 2η²sin²θ over 2·10⁻¹² η cos θ
    Ran::from(double)
        .and_f32(single)
        .conditioned(1.0 / (beside.abs() * 1.25_f64.sqrt()))
}

/// The largest |T − u| where η is 1.
fn bend<F: Float + Into<f64>>(flattest: f64) -> f64 {
    let rounded = |v: DVec3| v.to_array().map(|x| F::from(x).unwrap_or_else(F::nan));
    let mut random = Random(8);
    let mut most = 0.0_f64;
    for i in 0..3000 {
        let n = random.direction();
        let along = n.any_orthonormal_vector();
        let rise = match i % 3 {
            0 => flattest,
            1 => 1e-9,
            _ => random.number().abs(),
        };
        let u = rounded((along - rise * n).normalize());
        let n = rounded(n);
        let cos_i = F::from(rise).unwrap_or_else(F::nan);
        let t = refracted(u, n, F::one(), cos_i, refraction_radicand(F::one(), cos_i));
        for axis in 0..3 {
            most = most.max((t[axis] - u[axis]).abs().into());
        }
    }
    most
}

/// The direction inside glass of 1.5, in the plane of a ray that meets it from above, along x and −z.
fn inside<F: Float>(sin: F, cos: F) -> [F; 3] {
    let (zero, one) = (F::zero(), F::one());
    let eta = (one + one) / (one + one + one);
    let radicand = refraction_radicand(eta, cos);
    refracted([sin, zero, -cos], [zero, zero, one], eta, cos, radicand)
}

/// By how much a slab of thickness 1 shifts a ray at 45° sideways.
fn shift<F: Float>() -> F {
    let one = F::one();
    let root = (one / (one + one)).sqrt();
    let [x, _, z] = inside(root, root);
    (one + x / z) * root
}

/// What a ray sees at a height beside the middle of the bubble.
fn bubble(height: f64) -> Result<f64, String> {
    let text = format!(
        r#"{{ "schema": 1, "camera": {{ "eye": [{height:?}, 0, -9], "target": [{height:?}, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 1e-9 }},
             "materials": {{ "glass": {{ "transmission": 1, "ior": 1.5 }}, "air": {{ "transmission": 1, "ior": 1, "emission": [1, 1, 1] }} }},
             "objects": [ {{ "name": "glass", "material": "glass", "sphere": {{ "center": [0, 0, 0], "radius": 2 }} }},
                          {{ "name": "bubble", "material": "air", "sphere": {{ "center": [0, 0, 0], "radius": 1 }} }} ] }}"#
    );
    let setup = staged(scene(&text)?, [1, 1], 5)?;
    Ok(picture(&setup, Method::RayTracing)[0].r)
}
