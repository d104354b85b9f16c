//! The state of ray casting and of ray tracing at one step: the picture so far, and the tree of rays of the current pixel, with what
//! is known of each.

mod difference;
mod levels;
mod media;
mod ray;

pub use difference::{Difference, Differs, first_difference};
pub use ray::{
    CurrentBranch, CurrentRefraction, CurrentSearch, CurrentShadow, CurrentSurface, Outcome,
    RayState, Target, Tested, Verdict,
};

use super::Canvas;
use super::Fold;
use super::cow_vec::CowVec;
use super::current::CurrentPoint;
use super::shading::Dot;
use crate::algorithms::incidence::divisor;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::ray_tree::{self, RayKind};
use crate::algorithms::visible;
use crate::algorithms::{primary, ray_tracing, surface};
use crate::color::Rgb;
use crate::methods::Setup;
use crate::scene::primitives::Ray;
use glam::DVec2;
use std::num::NonZeroU32;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub struct State {
    /// What does not change from step to step.
    pub prepared: Arc<PreparedScene>,
    /// The last level that is shaded.
    pub depth: NonZeroU32,
    /// The transparent objects that the eye is inside, outermost first.
    around_eye: Arc<[u32]>,
    pub canvas: Canvas<Dot>,
    /// The current pixel, and the point of the screen that its primary ray goes through.
    pub pixel: Option<(u32, u32)>,
    pub through: Option<DVec2>,
    /// The rays of the pixel, each behind its parent; the first is primary. They stay until the next primary ray.
    pub rays: CowVec<RayState>,
    /// The current ray: the innermost that has not returned yet; the primary one, once all have.
    pub current: Option<usize>,
    /// What the search has found so far, while it goes on.
    pub search: Option<CurrentSearch>,
    /// The current shadow ray.
    pub shadow: Option<CurrentShadow>,
    /// The point that is being lit, or was lit last.
    pub point: Option<CurrentPoint>,
}

impl State {
    /// Before the first step: an empty picture.
    pub fn new(setup: &Setup) -> Self {
        let prepared = setup.prepared.clone();
        State {
            depth: setup.settings.get::<primary::Settings>().depth,
            canvas: Canvas::blank(&prepared),
            around_eye: media::around_eye(&prepared).into(),
            prepared,
            pixel: None,
            through: None,
            rays: CowVec::default(),
            current: None,
            search: None,
            shadow: None,
            point: None,
        }
    }

    /// The current ray.
    pub fn ray(&self) -> Option<&RayState> {
        self.rays.get(self.current?)
    }

    /// The current ray, the one that it comes from, and so on up to the primary ray, as indices of [`State::rays`].
    pub fn way(&self) -> impl Iterator<Item = usize> {
        std::iter::successors(self.current, |&index| self.rays.get(index)?.parent)
    }

    fn ray_mut(&mut self) -> Option<&mut RayState> {
        self.rays.get_mut(self.current?)
    }

    fn open_ray(&mut self, kind: RayKind, level: u16, ray: Ray, step: usize) {
        if kind == RayKind::Primary {
            self.rays = CowVec::default();
            self.current = None;
        }
        let index = self.rays.len();
        if let Some(branch) = self.ray_mut().and_then(|ray| branch_mut(ray, kind)) {
            branch.outcome = Outcome::Ray(index);
        }
        self.rays.push(RayState {
            kind,
            level,
            parent: self.current,
            ray,
            step,
            met: None,
            surface: None,
            lit: None,
            shadows: Vec::new(),
            local: None,
            refraction: None,
            branches: [None; 2],
            sum: None,
            returned: None,
        });
        self.current = Some(index);
        self.point = None;
    }

    fn close_ray(&mut self, color: Rgb, step: usize) {
        let Some(ray) = self.ray_mut() else { return };
        ray.returned = Some((color, step));
        let parent = ray.parent;
        self.current = parent.or(self.current);
        self.point = None;
    }

    /// Of what the pixel's primary ray met, along the view; infinite where it met no surface.
    fn first_depth(&self) -> f64 {
        let surface = self.rays.iter().next().and_then(|ray| ray.surface);
        surface.map_or(f64::INFINITY, |surface| {
            self.prepared.view.to_camera(surface.position).z
        })
    }

    fn color_pixel(&mut self, step: usize, event: &primary::Event) {
        match *event {
            primary::Event::Pixel { x, y, .. } => {
                self.pixel = Some((x, y));
                self.rays = CowVec::default();
                self.current = None;
            }
            primary::Event::Through { place, .. } => self.through = Some(place),
            primary::Event::PixelColored { color } => {
                if let Some((x, y)) = self.pixel {
                    let dot = Dot {
                        color,
                        step: Some(step as u32),
                        depth: self.first_depth(),
                    };
                    self.canvas.set(x as usize, y as usize, dot);
                }
            }
        }
    }

    fn look(&mut self, event: &visible::Event) {
        use visible::Event;
        match *event {
            Event::Search { .. } => {
                self.search = Some(CurrentSearch {
                    tested: None,
                    nearest: None,
                });
            }
            Event::ObjectTested {
                object, t, nearer, ..
            } => self.test(Target::Object(object), t, nearer),
            Event::LightTested {
                light, t, nearer, ..
            } => self.test(Target::Light(light), t, nearer),
            Event::Found { met } => {
                self.search = None;
                if let Some(ray) = self.ray_mut() {
                    ray.met = Some(met);
                }
            }
            Event::BetweenTested {
                object, t, blocks, ..
            } => {
                if let Some(shadow) = &mut self.shadow {
                    shadow.tested = Some((object, t, blocks));
                }
            }
            Event::Unshadowing { .. } => {}
        }
    }

    fn test(&mut self, target: Target, t: f64, nearer: bool) {
        if let Some(search) = &mut self.search {
            let tested = Tested { target, t };
            search.tested = Some(tested);
            if nearer {
                search.nearest = Some(tested);
            }
        }
    }

    fn meet_surface(&mut self, event: &surface::Event) {
        use surface::Event;
        let Some(ray) = self.ray_mut() else { return };
        match (*event, &mut ray.surface) {
            (
                Event::SurfaceMet {
                    object,
                    position,
                    normal,
                },
                surface,
            ) => {
                *surface = Some(CurrentSurface {
                    object,
                    position,
                    geometric: normal,
                    facing: None,
                    texture: None,
                });
            }
            (
                Event::Faced {
                    normal,
                    cos_theta_i,
                    entering,
                },
                Some(surface),
            ) => surface.facing = Some((normal, cos_theta_i, entering)),
            (Event::Textured { uv, color }, Some(surface)) => surface.texture = Some((uv, color)),
            _ => {}
        }
    }

    fn set_local(&mut self, local: Rgb) {
        let lit = self.point.clone().map(Arc::new);
        if let Some(ray) = self.ray_mut() {
            ray.lit = lit;
            ray.local = Some(local);
            ray.sum = Some(local);
        }
    }

    fn grow_tree(&mut self, step: usize, event: &ray_tree::Event) {
        use ray_tree::Event;
        match *event {
            Event::Ray { kind, level, ray } => self.open_ray(kind, level, ray, step),
            Event::Returned { color } => self.close_ray(color, step),
            Event::ShadowRay {
                light,
                direction,
                distance,
                ..
            } => {
                self.shadow = Some(CurrentShadow {
                    light,
                    direction,
                    distance,
                    tested: None,
                    step,
                });
            }
            Event::Shadow { light, blocked, by } => {
                let shadow = self.shadow.take();
                if let (Some(shadow), Some(ray)) = (shadow, self.ray_mut()) {
                    ray.shadows.push(Verdict {
                        light,
                        blocked,
                        by,
                        direction: shadow.direction,
                        distance: shadow.distance,
                        step,
                    });
                }
            }
            Event::Local { local, .. } => self.set_local(local),
            Event::Refraction {
                eta_i,
                eta_r,
                radicand,
                ..
            } => {
                if let Some(ray) = self.ray_mut() {
                    ray.refraction = Some(CurrentRefraction {
                        eta_i,
                        eta_r,
                        radicand,
                        step,
                    });
                }
            }
            Event::Branched { branch } => {
                if let Some(ray) = self.ray_mut() {
                    ray.branches[side(branch.kind)] = Some(CurrentBranch {
                        branch: Some(branch),
                        kind: branch.kind,
                        outcome: Outcome::Open,
                        attenuation: None,
                        carried: None,
                        step,
                    });
                }
            }
            Event::Ended { kind, end } => {
                let Some(ray) = self.ray_mut() else { return };
                let ended = ray.branches[side(kind)].get_or_insert(CurrentBranch {
                    branch: None,
                    kind,
                    outcome: Outcome::Open,
                    attenuation: None,
                    carried: None,
                    step,
                });
                ended.outcome = Outcome::Ended(end);
            }
            Event::Attenuated {
                kind,
                distance,
                attenuation,
                ..
            } => {
                let divisor = divisor(attenuation, distance);
                if let Some(branch) = self.ray_mut().and_then(|ray| branch_mut(ray, kind)) {
                    branch.attenuation = Some((distance, divisor));
                }
            }
            Event::Added { kind, carried, sum } => {
                let Some(ray) = self.ray_mut() else { return };
                ray.sum = Some(sum);
                if let Some(branch) = branch_mut(ray, kind) {
                    branch.carried = Some(carried);
                }
            }
        }
    }

    fn beyond(&self, before: &Self) -> usize {
        let lights = self
            .point
            .as_ref()
            .map_or(0, |point| size_of_val(&*point.lights));
        size_of::<Self>()
            + lights
            + self.rays.bytes_beyond(&before.rays)
            + self.canvas.bytes_beyond(&before.canvas)
    }
}

/// The place of a branch among the two of a surface.
fn side(kind: RayKind) -> usize {
    match kind {
        RayKind::Primary | RayKind::Reflected => 0,
        RayKind::Transmitted | RayKind::TotalInternalReflection => 1,
    }
}

fn branch_mut(ray: &mut RayState, kind: RayKind) -> Option<&mut CurrentBranch> {
    ray.branches[side(kind)].as_mut()
}

impl<E: Copy + Into<ray_tracing::Event>> Fold<E> for State {
    fn apply(&mut self, step: usize, event: &E) {
        use ray_tracing::Event;
        match (*event).into() {
            Event::PreparedScene(_) => {}
            Event::Primary(event) => self.color_pixel(step, &event),
            Event::Visible(event) => self.look(&event),
            Event::Surface(event) => self.meet_surface(&event),
            Event::Illumination(event) => CurrentPoint::light(&mut self.point, step, &event),
            Event::Tree(event) => self.grow_tree(step, &event),
        }
    }

    fn bytes_beyond(&self, before: &Self) -> usize {
        self.beyond(before)
    }
}
