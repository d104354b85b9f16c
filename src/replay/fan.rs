//! The rays of many pixels at once: each pixel's run to its end.

use super::Run;
use crate::algorithms::focus::Focus;
use crate::algorithms::ray_tree::RayKind;
use crate::algorithms::visible::Intersection;
use crate::methods::{Method, Setup};
use crate::record::RecordingLimit;
use glam::DVec3;
use std::sync::Arc;

/// More steps than this are not followed for one pixel.
const MOST_STEPS: usize = 200_000;

/// A ray among those of many pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FanRay {
    pub pixel: (u32, u32),
    pub kind: RayKind,
    pub level: u16,
    pub origin: DVec3,
    /// Unit.
    pub direction: DVec3,
    /// Infinite where the ray meets nothing.
    pub length: f64,
}

/// The rays of the pixels; none where the method follows no rays.
pub fn fan(setup: &Arc<Setup>, method: Method, pixels: &[(u32, u32)]) -> Vec<FanRay> {
    let rays = pixels.iter().flat_map(|&(x, y)| {
        let limit = RecordingLimit(MOST_STEPS);
        let mut run = Run::record(setup.clone(), method, Focus::Pixel { x, y }, limit);
        let last = run.walk().len().saturating_sub(1);
        run.walk_mut().seek(last);
        let rays = run.rays().map(|state| {
            let rays = state.rays.iter().map(|ray| FanRay {
                pixel: (x, y),
                kind: ray.kind,
                level: ray.level,
                origin: ray.ray.origin,
                direction: ray.ray.direction,
                length: match ray.met {
                    Some(Intersection::Object(hit)) => hit.t,
                    Some(Intersection::Light { t, .. }) => t,
                    Some(Intersection::Nothing) | None => f64::INFINITY,
                },
            });
            rays.collect::<Vec<_>>()
        });
        rays.unwrap_or_default()
    });
    rays.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::prepared_scene::PreparedScene;
    use crate::algorithms::primary::Settings;
    use crate::scene::{Limits, View, read};

    #[test]
    fn rays_of_a_mirror_ball_meet_it_and_are_mirrored_at_its_normal() {
        let scene = br#"{ "schema": 1,
            "camera": { "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 40 },
            "materials": { "mirror": { "reflection": 0.5 } },
            "objects": [{ "name": "ball", "material": "mirror", "sphere": { "center": [0, 0, 0], "radius": 1 } }],
            "lights": [{ "point": { "position": [0, 9, 0], "color": [1, 1, 1] } }]
        }"#;
        let scene = read(scene, &Limits::default(), &mut |_| panic!("no other file")).unwrap();
        let view = View::new(&scene.camera.unwrap(), 9, 9);
        let setup = Setup::new(PreparedScene::new(scene, view), Settings::default());
        let pixels = [(4, 4), (3, 4), (0, 0)];
        let rays = fan(&Arc::new(setup), Method::RayTracing, &pixels);
        let of = |pixel| rays.iter().filter(move |ray| ray.pixel == pixel);
        assert_eq!(of((0, 0)).count(), 1, "beside the ball there is one ray");
        assert!(of((0, 0)).all(|ray| ray.length.is_infinite()));
        for pixel in [(4, 4), (3, 4)] {
            let [primary, mirrored] = of(pixel).collect::<Vec<_>>()[..] else {
                panic!("two rays of {pixel:?}");
            };
            let normal = primary.origin + primary.length * primary.direction;
            assert!((normal.length() - 1.0).abs() < 1e-12);
            assert!((mirrored.origin - normal).length() < 1e-9);
            let across = primary.direction + mirrored.direction;
            assert!(across.dot(normal).abs() < 1e-12);
            assert_eq!((primary.level, mirrored.level), (1, 2));
        }
    }
}
