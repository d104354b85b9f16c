//! What is known of the pixels of a picture beside their colours: what the first ray through each meets, and how many rays it takes.
//!
//! A method that follows rays records it in its own events. For the others a ray is cast through the centre of each pixel.

use super::tally::RayCounts;
use crate::algorithms::ray_tracing;
use crate::algorithms::surface;
use crate::algorithms::visible::Bvh;
use crate::methods::{Method, RayCasting, RayMethod, Setup, ShadingMethod, Visitor};
use crate::record::Recorder;
use glam::DVec3;

/// Of a whole picture, row by row from the top.
#[derive(Clone, Debug)]
pub struct Layers {
    pub width: u32,
    pub pixels: Vec<Layer>,
    /// Whether the rays are those of the method, and not cast to find out.
    pub of_the_method: bool,
}

/// Of one pixel.
#[derive(Clone, Copy, Debug, Default)]
pub struct Layer {
    /// Of the first ray; none where it meets no object.
    pub surface: Option<MetSurface>,
    /// Of all kinds, shadow rays too.
    pub rays: u64,
}

#[derive(Clone, Copy, Debug)]
pub struct MetSurface {
    pub object: u32,
    /// Along the view, as the depth buffer counts it.
    pub depth: f64,
    /// Unit, toward the incoming ray.
    pub normal: DVec3,
}

impl Layers {
    /// Of pixel (x, y); none beyond the picture.
    pub fn get(&self, x: u32, y: u32) -> Option<&Layer> {
        let index = y as usize * self.width as usize + x as usize;
        self.pixels.get(index).filter(|_| x < self.width)
    }
}

/// Finds the layers of the whole picture. `progress` is called after each row with the rows done and all rows; an error of it ends
/// the work.
pub fn layers<E>(
    setup: &Setup,
    method: Method,
    progress: impl FnMut(usize, usize) -> Result<(), E>,
) -> Result<Layers, E> {
    method.visit(Survey { setup, progress })
}

struct Survey<'a, P> {
    setup: &'a Setup,
    progress: P,
}

impl<E, P: FnMut(usize, usize) -> Result<(), E>> Survey<'_, P> {
    fn by<M: RayMethod>(mut self, of_the_method: bool) -> Result<Layers, E> {
        let tracer = M::tracer(self.setup, self.setup.needs(), Bvh);
        let view = &self.setup.prepared.view;
        let mut pixels = Vec::with_capacity(view.width as usize * view.height as usize);
        for y in 0..view.height {
            for x in 0..view.width {
                let mut seen = Seen::default();
                M::pixel(&tracer, x, y, &mut seen);
                let surface = seen.surface.map(|(object, position, normal)| MetSurface {
                    object,
                    depth: view.to_camera(position).z,
                    normal,
                });
                let rays = seen.counts.total();
                pixels.push(Layer { surface, rays });
            }
            (self.progress)(y as usize + 1, view.height as usize)?;
        }
        Ok(Layers {
            width: view.width,
            pixels,
            of_the_method,
        })
    }
}

impl<E, P: FnMut(usize, usize) -> Result<(), E>> Visitor for Survey<'_, P> {
    type Output = Result<Layers, E>;

    fn wireframe(self) -> Self::Output {
        self.by::<RayCasting>(false)
    }

    fn shading<M: ShadingMethod>(self) -> Self::Output {
        self.by::<RayCasting>(false)
    }

    fn rays<M: RayMethod>(self) -> Self::Output {
        self.by::<M>(true)
    }

    fn radiosity(self) -> Self::Output {
        self.by::<RayCasting>(false)
    }

    fn hierarchical(self) -> Self::Output {
        self.by::<RayCasting>(false)
    }
}

/// Listens to the rays of one pixel.
#[derive(Default)]
struct Seen {
    counts: RayCounts,
    /// Object, place and normal where the first ray meets a surface.
    surface: Option<(u32, DVec3, DVec3)>,
    faced: bool,
}

impl<E: Into<ray_tracing::Event>> Recorder<E> for Seen {
    fn step(&mut self, event: impl FnOnce() -> E) {
        // The first ray of the pixel is the only one before any other was opened.
        let is_first = self.counts.total() == 1 && !self.faced;
        if !is_first {
            return;
        }
        match event().into() {
            ray_tracing::Event::Surface(surface::Event::SurfaceMet {
                object,
                position,
                normal,
            }) => self.surface = Some((object, position, normal)),
            ray_tracing::Event::Surface(surface::Event::Faced { normal, .. }) => {
                self.faced = true;
                if let Some(met) = &mut self.surface {
                    met.2 = normal;
                }
            }
            _ => {}
        }
    }

    fn enter(&mut self, event: impl FnOnce() -> E) {
        Recorder::<E>::enter(&mut self.counts, event);
    }

    fn leave(&mut self, _: impl FnOnce() -> E) {}
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algorithms::prepared_scene::PreparedScene;
    use crate::algorithms::primary::Settings;
    use crate::render::render_counted;
    use crate::scene::{Limits, View, read};
    use std::convert::Infallible;
    use std::num::NonZeroUsize;

    fn setup() -> Setup {
        let scene = br#"{ "schema": 1,
            "camera": { "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "fov_x_degrees": 60 },
            "materials": { "mirror": { "reflection": 0.5 } },
            "objects": [
                { "name": "ball", "material": "mirror", "sphere": { "center": [0, 0, 0], "radius": 1 } },
                { "name": "second", "material": "mirror", "sphere": { "center": [3, 0, 0], "radius": 1 } }
            ],
            "lights": [{ "point": { "position": [0, 9, 9], "color": [1, 1, 1] } }]
        }"#;
        let scene = read(scene, &Limits::default(), &mut |_| panic!("no other file")).unwrap();
        let view = View::new(&scene.camera.unwrap(), 41, 31);
        Setup::new(PreparedScene::new(scene, view), Settings::default())
    }

    #[test]
    fn layers_show_what_is_seen_and_count_the_rays_of_the_picture() {
        let setup = setup();
        let all = |method| {
            let Ok(layers) = layers(&setup, method, |_, _| Ok::<(), Infallible>(()));
            layers
        };
        let traced = all(Method::RayTracing);
        let met = traced.get(20, 15).unwrap().surface.unwrap();
        assert_eq!(met.object, 0);
        assert!((met.depth - 4.0).abs() < 1e-12 && met.normal.distance(DVec3::Z) < 1e-12);
        assert!(traced.get(0, 0).unwrap().surface.is_none());
        assert_eq!(traced.get(0, 0).unwrap().rays, 1);
        assert!(traced.get(41, 0).is_none() && traced.get(0, 31).is_none());

        let one = NonZeroUsize::MIN;
        let (_, counts) =
            render_counted(&setup, Method::RayTracing, setup.needs(), one, &|_, _| {});
        let sum: u64 = traced.pixels.iter().map(|pixel| pixel.rays).sum();
        assert_eq!(sum, counts.total());

        let cast = all(Method::Phong);
        assert!(!cast.of_the_method && traced.of_the_method);
        for (one, other) in cast.pixels.iter().zip(&traced.pixels) {
            let object = |layer: &Layer| layer.surface.map(|met| met.object);
            assert_eq!(object(one), object(other));
        }
    }
}
