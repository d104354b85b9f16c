//! One recorded run of one of the algorithms.

use super::current::CurrentPoint;
use super::{Fold, Replay, Timeline, Walk, form_factor, radiosity, rays, shading, wireframe};
use crate::algorithms::exact;
use crate::algorithms::fast_phong;
use crate::algorithms::flat::{self, Nothing};
use crate::algorithms::focus::Focus;
use crate::algorithms::form_factor::{FormFactors, Method as Integration};
use crate::algorithms::frame::Frame;
use crate::algorithms::gouraud;
use crate::algorithms::phong;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::radiosity::RecordFilter;
use crate::algorithms::ray_casting::{self, RayCaster};
use crate::algorithms::ray_tracing::{self, RayTracer};
use crate::algorithms::visible::BruteForce;
use crate::color::Rgb;
use crate::record::{Recorder, Recording, RecordingLimit, Unrecorded};
use crate::render::{Method, matrix};
use glam::DVec3;
use std::convert::Infallible;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::thread::available_parallelism;

/// A recorded run, standing at one of its steps.
pub enum Run {
    Wireframe(Box<Replay<crate::algorithms::wireframe::Event, wireframe::State>>),
    Flat(Box<Replay<flat::Event, shading::State<Nothing>>>),
    Gouraud(Box<Replay<gouraud::Event, shading::State<Rgb>>>),
    Phong(Box<Replay<phong::Event, shading::State<DVec3>>>),
    FastPhong(Box<Replay<fast_phong::Event, shading::State<Nothing>>>),
    Exact(Box<Replay<exact::Event, shading::State<DVec3>>>),
    RayCasting(Box<Replay<ray_casting::Event, rays::State>>),
    RayTracing(Box<Replay<ray_tracing::Event, rays::State>>),
    Radiosity(
        Arc<PreparedScene>,
        Box<Replay<crate::algorithms::radiosity::Event, radiosity::State>>,
    ),
    FormFactor(
        Arc<PreparedScene>,
        Box<Replay<crate::algorithms::form_factor::Event, form_factor::State>>,
    ),
}

/// How exact the form factor is that others are compared with.
const REFERENCE: Integration = Integration::Contour { tolerance: 1e-10 };

impl Run {
    /// Runs `method` on the part of the stage that `focus` takes, and keeps its steps within `limit`.
    pub fn record(
        prepared: Arc<PreparedScene>,
        method: Method,
        focus: Focus,
        limit: RecordingLimit,
    ) -> Run {
        match method {
            Method::Wireframe => Run::Wireframe(replay(
                Recording::new(limit),
                &prepared,
                wireframe::State::new,
                |frame, recording| {
                    crate::algorithms::wireframe::wireframe(&prepared, focus, frame, recording);
                },
            )),
            Method::Flat => Run::Flat(replay(
                Recording::new(limit),
                &prepared,
                shading::State::new,
                |frame, recording| {
                    flat::flat(&prepared, focus, frame, recording);
                },
            )),
            Method::Gouraud => Run::Gouraud(replay(
                Recording::new(limit),
                &prepared,
                shading::State::new,
                |frame, recording| {
                    gouraud::gouraud(&prepared, focus, frame, recording);
                },
            )),
            Method::Exact => Run::Exact(replay(
                Recording::new(limit),
                &prepared,
                shading::State::new,
                |frame, recording| {
                    exact::exact(&prepared, focus, frame, recording);
                },
            )),
            Method::Phong => Run::Phong(replay(
                Recording::new(limit),
                &prepared,
                shading::State::new,
                |frame, recording| {
                    phong::phong(&prepared, focus, frame, recording);
                },
            )),
            Method::FastPhong => Run::FastPhong(replay(
                Recording::new(limit),
                &prepared,
                shading::State::new,
                |frame, recording| {
                    fast_phong::fast_phong(&prepared, focus, frame, recording);
                },
            )),
            Method::RayCasting => Run::RayCasting(replay(
                Recording::new(limit),
                &prepared,
                rays::State::new,
                |frame, recording| {
                    let caster = RayCaster::new(&prepared, prepared.needs(), BruteForce);
                    ray_casting::ray_casting(&caster, focus, frame, recording);
                },
            )),
            Method::RayTracing => Run::RayTracing(replay(
                Recording::new(limit),
                &prepared,
                rays::State::new,
                |frame, recording| {
                    let tracer = RayTracer::new(&prepared, prepared.needs(), BruteForce);
                    ray_tracing::ray_tracing(&tracer, focus, frame, recording);
                },
            )),
            Method::Radiosity => match focus {
                Focus::FormFactor { i, j } => {
                    let run = form_factor_run(&prepared, i as usize, j as usize, limit);
                    Run::FormFactor(prepared, run)
                }
                _ => {
                    let run = radiosity_run(&prepared, focus, limit);
                    Run::Radiosity(prepared, run)
                }
            },
        }
    }

    /// The rays in hand, where the run follows rays.
    pub fn rays(&self) -> Option<&rays::State> {
        match self {
            Run::RayCasting(replay) => Some(replay.state()),
            Run::RayTracing(replay) => Some(replay.state()),
            _ => None,
        }
    }

    /// The point that is being lit, or was lit last, where the run lights points; with the lights of its scene.
    pub fn lit(&self) -> (Option<&PreparedScene>, Option<&CurrentPoint>) {
        fn of<A>(state: &shading::State<A>) -> (Option<&PreparedScene>, Option<&CurrentPoint>) {
            (Some(&state.prepared), state.point.as_ref())
        }
        match self {
            Run::Flat(replay) => of(replay.state()),
            Run::Gouraud(replay) => of(replay.state()),
            Run::Phong(replay) => of(replay.state()),
            Run::FastPhong(replay) => of(replay.state()),
            Run::Exact(replay) => of(replay.state()),
            Run::RayCasting(_) | Run::RayTracing(_) => {
                let state = self.rays();
                let ray = state.and_then(|state| state.ray()?.lit.as_deref());
                let lit = state.and_then(|state| state.point.as_ref()).or(ray);
                (state.map(|state| &*state.prepared), lit)
            }
            Run::Wireframe(_) | Run::Radiosity(..) | Run::FormFactor(..) => (None, None),
        }
    }

    /// What was recorded.
    pub fn method(&self) -> Method {
        match self {
            Run::Wireframe(_) => Method::Wireframe,
            Run::Flat(_) => Method::Flat,
            Run::Gouraud(_) => Method::Gouraud,
            Run::Phong(_) => Method::Phong,
            Run::FastPhong(_) => Method::FastPhong,
            Run::Exact(_) => Method::Exact,
            Run::RayCasting(_) => Method::RayCasting,
            Run::RayTracing(_) => Method::RayTracing,
            Run::Radiosity(..) | Run::FormFactor(..) => Method::Radiosity,
        }
    }

    pub fn walk(&self) -> &dyn Walk {
        match self {
            Run::Wireframe(replay) => &**replay,
            Run::Flat(replay) => &**replay,
            Run::Gouraud(replay) => &**replay,
            Run::Phong(replay) => &**replay,
            Run::FastPhong(replay) => &**replay,
            Run::Exact(replay) => &**replay,
            Run::RayCasting(replay) => &**replay,
            Run::RayTracing(replay) => &**replay,
            Run::Radiosity(_, replay) => &**replay,
            Run::FormFactor(_, replay) => &**replay,
        }
    }

    pub fn walk_mut(&mut self) -> &mut dyn Walk {
        match self {
            Run::Wireframe(replay) => &mut **replay,
            Run::Flat(replay) => &mut **replay,
            Run::Gouraud(replay) => &mut **replay,
            Run::Phong(replay) => &mut **replay,
            Run::FastPhong(replay) => &mut **replay,
            Run::Exact(replay) => &mut **replay,
            Run::RayCasting(replay) => &mut **replay,
            Run::RayTracing(replay) => &mut **replay,
            Run::Radiosity(_, replay) => &mut **replay,
            Run::FormFactor(_, replay) => &mut **replay,
        }
    }
}

fn replay<E, S: Fold<E>>(
    mut recording: Recording<E>,
    prepared: &Arc<PreparedScene>,
    initial: impl FnOnce(Arc<PreparedScene>) -> S,
    run: impl FnOnce(&mut Frame, &mut Recording<E>),
) -> Box<Replay<E, S>> {
    let mut frame = Frame::new(
        prepared.view.width,
        0..prepared.view.height,
        prepared.scene.background,
    );
    run(&mut frame, &mut recording);
    Box::new(Replay::new(Timeline::new(
        recording,
        initial(prepared.clone()),
    )))
}

/// The solution of a room. A room that cannot be divided tells nothing: `PreparedScene::enclosure` says why.
fn radiosity_run(
    prepared: &Arc<PreparedScene>,
    focus: Focus,
    limit: RecordingLimit,
) -> Box<Replay<crate::algorithms::radiosity::Event, radiosity::State>> {
    let mut recording = Recording::new(limit);
    if let Ok(enclosure) = prepared.enclosure() {
        let threads = available_parallelism().unwrap_or(NonZeroUsize::MIN);
        let Ok(matrix) = matrix(enclosure, threads, &|_, _| Ok::<(), Infallible>(()));
        let mut filter = RecordFilter::default();
        match focus {
            Focus::Iterations { start, end } => filter.iterations = Some(start..end),
            Focus::Patch(patch) => filter.patch = Some(patch),
            _ => {}
        }
        // What kept it from a solution is the last that the run tells.
        let _ = enclosure.solve(matrix, &filter, &mut recording);
    }
    Box::new(Replay::new(Timeline::new(
        recording,
        radiosity::State::default(),
    )))
}

/// One form factor, and what it is compared with.
fn form_factor_run(
    prepared: &Arc<PreparedScene>,
    i: usize,
    j: usize,
    limit: RecordingLimit,
) -> Box<Replay<crate::algorithms::form_factor::Event, form_factor::State>> {
    let mut recording = Recording::new(limit);
    if let Ok(enclosure) = prepared.enclosure() {
        let blockers = enclosure.settings.visibility.then_some(&enclosure.blockers);
        let reference = FormFactors::new(&enclosure.patches, REFERENCE, blockers);
        let f = reference.pair(i, j, &mut Unrecorded);
        recording.step(|| crate::algorithms::form_factor::Event::Reference { f });
        enclosure.form_factors().pair(i, j, &mut recording);
    }
    Box::new(Replay::new(Timeline::new(
        recording,
        form_factor::State::default(),
    )))
}
