//! One recorded run of one of the algorithms.

use super::current::CurrentPoint;
use super::radiosity::Solved;
use super::{
    Fold, Replay, Timeline, Walk, form_factor, hierarchical, radiosity, rays, shading, wireframe,
};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::shading::{Shading, ShadingEvent};
use crate::algorithms::visible::BruteForce;
use crate::color::Rgb;
use crate::methods;
use crate::methods::{Draw, Method, RayMethod, Setup, ShadingMethod, Visitor, Wireframe};
use crate::record::{Event, Recording, RecordingLimit};
use crate::render::matrix;
use crate::vocabulary::Declared;
use std::convert::Infallible;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::thread::available_parallelism;

/// A recorded run, standing at one of its steps: an arm for each kind of state.
pub enum Run {
    Wireframe(Box<Replay<crate::algorithms::wireframe::Event, wireframe::State>>),
    Shading(Method, Box<dyn WalkOf<shading::State>>),
    Rays(Method, Box<dyn WalkOf<rays::State>>),
    Radiosity(
        Arc<Setup>,
        Box<Replay<crate::algorithms::radiosity::Event, radiosity::State>>,
    ),
    FormFactor(
        Arc<Setup>,
        Box<Replay<crate::algorithms::form_factor::Event, form_factor::State>>,
    ),
    Hierarchical(
        Arc<Setup>,
        Box<Replay<crate::algorithms::hierarchical::Event, hierarchical::State>>,
    ),
}

/// A replay whose states are of type `S`, whatever its events are.
pub trait WalkOf<S>: Walk + Send + Sync {
    fn state(&self) -> &S;
}

impl<E: Event + Declared, S: Fold<E> + Send + Sync> WalkOf<S> for Replay<E, S> {
    fn state(&self) -> &S {
        Replay::state(self)
    }
}

impl Run {
    /// Records what `method` does within `focus`, up to `limit` steps.
    pub fn record(setup: Arc<Setup>, method: Method, focus: Focus, limit: RecordingLimit) -> Run {
        method.visit(Record {
            setup,
            method,
            focus,
            limit,
        })
    }

    /// The rays of the current pixel, where the run follows rays.
    pub fn rays(&self) -> Option<&rays::State> {
        match self {
            Run::Rays(_, replay) => Some(replay.state()),
            _ => None,
        }
    }

    /// The scene of the run.
    pub fn prepared(&self) -> &Arc<PreparedScene> {
        match self {
            Run::Wireframe(replay) => &replay.state().prepared,
            Run::Shading(_, replay) => &replay.state().prepared,
            Run::Rays(_, replay) => &replay.state().prepared,
            Run::Radiosity(setup, _) | Run::FormFactor(setup, _) | Run::Hierarchical(setup, _) => {
                &setup.prepared
            }
        }
    }

    /// The picture so far, where the run draws pixels.
    pub fn canvas(&self) -> Option<&super::Canvas<shading::Dot>> {
        match self {
            Run::Wireframe(replay) => Some(&replay.state().canvas),
            Run::Shading(_, replay) => Some(&replay.state().canvas),
            Run::Rays(_, replay) => Some(&replay.state().canvas),
            Run::Radiosity(..) | Run::FormFactor(..) | Run::Hierarchical(..) => None,
        }
    }

    /// The point that is being lit, or was lit last, where the run lights points; with the lights of its scene.
    pub fn lit(&self) -> (Option<&PreparedScene>, Option<&CurrentPoint>) {
        match self {
            Run::Shading(_, replay) => {
                let state = replay.state();
                (Some(&*state.prepared), state.point.as_ref())
            }
            Run::Rays(_, replay) => {
                let state = replay.state();
                let ray = state.ray().and_then(|ray| ray.lit.as_deref());
                (Some(&*state.prepared), state.point.as_ref().or(ray))
            }
            Run::Wireframe(_)
            | Run::Radiosity(..)
            | Run::FormFactor(..)
            | Run::Hierarchical(..) => (None, None),
        }
    }

    /// The patches of the scene, where the run exchanges light between them.
    pub fn enclosure(&self) -> Option<&Enclosure> {
        match self {
            Run::Radiosity(setup, _) | Run::FormFactor(setup, _) | Run::Hierarchical(setup, _) => {
                setup.enclosure().ok()
            }
            _ => None,
        }
    }

    /// The light of every patch so far, and what it is multiplied by to be shown; none where the run exchanges none.
    pub fn light(&self) -> Option<(Vec<Rgb>, f64)> {
        let room = self.enclosure()?;
        let (light, exposure) = match self {
            Run::Radiosity(_, replay) => {
                let solved = replay.state().solved.as_ref();
                let exposure = solved.map(|solved| solved.exposure);
                (replay.state().light(room), exposure)
            }
            Run::Hierarchical(_, replay) => {
                let solved = replay.state().solved.as_ref();
                let exposure = solved.map(|solved| solved.exposure);
                (replay.state().light(room), exposure)
            }
            _ => return None,
        };
        Some((light, exposure.unwrap_or(1.0)))
    }

    /// The method that was recorded.
    pub fn method(&self) -> Method {
        match self {
            Run::Wireframe(_) => Method::Wireframe,
            Run::Shading(method, _) | Run::Rays(method, _) => *method,
            Run::Radiosity(..) | Run::FormFactor(..) => Method::Radiosity,
            Run::Hierarchical(..) => Method::HierarchicalRadiosity,
        }
    }

    pub fn walk(&self) -> &dyn Walk {
        match self {
            Run::Wireframe(replay) => &**replay,
            Run::Shading(_, replay) => &**replay,
            Run::Rays(_, replay) => &**replay,
            Run::Radiosity(_, replay) => &**replay,
            Run::FormFactor(_, replay) => &**replay,
            Run::Hierarchical(_, replay) => &**replay,
        }
    }

    pub fn walk_mut(&mut self) -> &mut dyn Walk {
        match self {
            Run::Wireframe(replay) => &mut **replay,
            Run::Shading(_, replay) => &mut **replay,
            Run::Rays(_, replay) => &mut **replay,
            Run::Radiosity(_, replay) => &mut **replay,
            Run::FormFactor(_, replay) => &mut **replay,
            Run::Hierarchical(_, replay) => &mut **replay,
        }
    }
}

/// Records a run of the method that it visits.
struct Record {
    setup: Arc<Setup>,
    method: Method,
    focus: Focus,
    limit: RecordingLimit,
}

impl Record {
    fn frame<M: Draw, S: Fold<M::Event>>(
        &self,
        initial: impl FnOnce(&Setup) -> S,
    ) -> Box<Replay<M::Event, S>> {
        let mut recording = Recording::new(self.limit);
        let frame = &mut self.setup.prepared.empty_frame();
        M::draw(&self.setup, self.focus, frame, BruteForce, &mut recording);
        let initial = initial(&self.setup);
        Box::new(Replay::new(Timeline::new(recording, initial)))
    }
}

impl Visitor for Record {
    type Output = Run;

    fn wireframe(self) -> Run {
        Run::Wireframe(
            self.frame::<Wireframe, _>(|setup| wireframe::State::new(setup.prepared.clone())),
        )
    }

    fn shading<M: ShadingMethod>(self) -> Run {
        type Recorded<E> = <<E as ShadingEvent>::Shading as Shading>::Recorded;
        let replay = self.frame::<M, _>(|setup| {
            shading::State::new::<Recorded<M::Event>>(setup.prepared.clone())
        });
        Run::Shading(self.method, replay)
    }

    fn rays<M: RayMethod>(self) -> Run {
        Run::Rays(self.method, self.frame::<M, _>(rays::State::new))
    }

    fn radiosity(self) -> Run {
        let Record {
            setup,
            focus,
            limit,
            ..
        } = self;
        match focus {
            Focus::FormFactor { i, j } => {
                let run = form_factor_run(&setup, [i, j], limit);
                Run::FormFactor(setup, run)
            }
            _ => {
                let run = radiosity_run(&setup, focus, limit);
                Run::Radiosity(setup, run)
            }
        }
    }

    fn hierarchical(self) -> Run {
        let mut recording = Recording::new(self.limit);
        let go_on = || Ok::<(), Infallible>(());
        let Ok(solved) = methods::hierarchical::solve(&self.setup, &mut recording, go_on);
        let solved = solved
            .ok()
            .map(|hierarchy| hierarchical::Solved::new(&hierarchy));
        let replay = Replay::new(Timeline::new(recording, hierarchical::State::new(solved)));
        Run::Hierarchical(self.setup, Box::new(replay))
    }
}

/// The solution of the enclosure. Nothing is recorded of a scene that cannot be divided: `Setup::enclosure` says why.
fn radiosity_run(
    setup: &Setup,
    focus: Focus,
    limit: RecordingLimit,
) -> Box<Replay<crate::algorithms::radiosity::Event, radiosity::State>> {
    let mut recording = Recording::new(limit);
    let mut solved = None;
    if let Ok(enclosure) = setup.enclosure() {
        let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let Ok(matrix) = matrix(enclosure, threads, &|_, _| Ok::<(), Infallible>(()));
        let light = methods::radiosity::solve(enclosure, matrix, focus, &mut recording);
        solved = Some(Solved::new(enclosure, matrix, light.as_ref().ok()));
        let _ = enclosure.light_or(|| light);
    }
    Box::new(Replay::new(Timeline::new(
        recording,
        radiosity::State::new(solved),
    )))
}

/// One form factor, and what it is compared with.
fn form_factor_run(
    setup: &Setup,
    pair: [u32; 2],
    limit: RecordingLimit,
) -> Box<Replay<crate::algorithms::form_factor::Event, form_factor::State>> {
    let mut recording = Recording::new(limit);
    if let Ok(enclosure) = setup.enclosure() {
        methods::radiosity::form_factor(enclosure, pair, &mut recording);
    }
    Box::new(Replay::new(Timeline::new(
        recording,
        form_factor::State::default(),
    )))
}
