//! One recorded run of one of the algorithms.

use super::{Fold, Replay, Timeline, Walk, rays, shading, wireframe};
use crate::algorithms::flat::{self, Nothing};
use crate::algorithms::focus::Focus;
use crate::algorithms::frame::Frame;
use crate::algorithms::gouraud;
use crate::algorithms::ray_casting::{self, RayCaster};
use crate::algorithms::ray_tracing::{self, RayTracer};
use crate::algorithms::stage::Stage;
use crate::algorithms::visible::InTurn;
use crate::color::Rgb;
use crate::record::{Recording, RecordingLimit};
use crate::render::Method;
use std::sync::Arc;

/// A recorded run, standing at one of its steps.
pub enum Run {
    Wireframe(Box<Replay<crate::algorithms::wireframe::Event, wireframe::State>>),
    Flat(Box<Replay<flat::Event, shading::State<Nothing>>>),
    Gouraud(Box<Replay<gouraud::Event, shading::State<Rgb>>>),
    RayCasting(Box<Replay<ray_casting::Event, rays::State>>),
    RayTracing(Box<Replay<ray_tracing::Event, rays::State>>),
}

impl Run {
    /// Runs `method` on the part of the stage that `focus` takes, and keeps its steps within `limit`.
    pub fn record(stage: Arc<Stage>, method: Method, focus: Focus, limit: RecordingLimit) -> Run {
        match method {
            Method::Wireframe => Run::Wireframe(replay(
                Recording::new(limit),
                &stage,
                wireframe::State::new,
                |frame, recording| {
                    crate::algorithms::wireframe::wireframe(&stage, focus, frame, recording);
                },
            )),
            Method::Flat => Run::Flat(replay(
                Recording::new(limit),
                &stage,
                shading::State::new,
                |frame, recording| {
                    flat::flat(&stage, focus, frame, recording);
                },
            )),
            Method::Gouraud => Run::Gouraud(replay(
                Recording::new(limit),
                &stage,
                shading::State::new,
                |frame, recording| {
                    gouraud::gouraud(&stage, focus, frame, recording);
                },
            )),
            Method::RayCasting => Run::RayCasting(replay(
                Recording::new(limit),
                &stage,
                rays::State::new,
                |frame, recording| {
                    let caster = RayCaster::new(&stage, stage.needs(), InTurn);
                    ray_casting::ray_casting(&caster, focus, frame, recording);
                },
            )),
            Method::RayTracing => Run::RayTracing(replay(
                Recording::new(limit),
                &stage,
                rays::State::new,
                |frame, recording| {
                    let tracer = RayTracer::new(&stage, stage.needs(), InTurn);
                    ray_tracing::ray_tracing(&tracer, focus, frame, recording);
                },
            )),
        }
    }

    pub fn walk(&self) -> &dyn Walk {
        match self {
            Run::Wireframe(replay) => &**replay,
            Run::Flat(replay) => &**replay,
            Run::Gouraud(replay) => &**replay,
            Run::RayCasting(replay) => &**replay,
            Run::RayTracing(replay) => &**replay,
        }
    }

    pub fn walk_mut(&mut self) -> &mut dyn Walk {
        match self {
            Run::Wireframe(replay) => &mut **replay,
            Run::Flat(replay) => &mut **replay,
            Run::Gouraud(replay) => &mut **replay,
            Run::RayCasting(replay) => &mut **replay,
            Run::RayTracing(replay) => &mut **replay,
        }
    }
}

fn replay<E, S: Fold<E>>(
    mut recording: Recording<E>,
    stage: &Arc<Stage>,
    initial: impl FnOnce(Arc<Stage>) -> S,
    run: impl FnOnce(&mut Frame, &mut Recording<E>),
) -> Box<Replay<E, S>> {
    let mut frame = Frame::new(
        stage.view.width,
        0..stage.view.height,
        stage.scene.background,
    );
    run(&mut frame, &mut recording);
    Box::new(Replay::new(Timeline::new(
        recording,
        initial(stage.clone()),
    )))
}
