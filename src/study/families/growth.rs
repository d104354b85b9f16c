//! How time and memory grow with the size of the work, algorithm by algorithm.

use super::pictures::{self, MEMORY, sends_rays_on, settings};
use super::solvers::{Problem, solvers};
use super::{memory, scenes};
use crate::algorithms::focus::Focus;
use crate::algorithms::form_factor::{self, FormFactors};
use crate::algorithms::frame::Frame;
use crate::algorithms::gouraud::{self, gouraud};
use crate::algorithms::prepared_scene::PreparedScene;
use crate::algorithms::primary::Settings;
use crate::algorithms::shading::ShadedScene;
use crate::language::Message;
use crate::record::{Mark, Outline, Recording, RecordingLimit, Unrecorded};
use crate::render::Method;
use crate::scene::patches::Patches;
use crate::scene::{Scene, Shape, sphere_mesh};
use crate::study::fit::Law;
use crate::study::form::{
    Axes, Curve, Operations, Reference, Request, Setting, Study, Sweep, Values,
};
use crate::study::label::Label;
use glam::DVec3;
use std::rc::Rc;
use std::sync::Arc;

pub static STUDY: Study = Study {
    name: "growth",
    title: Message("study-growth"),
    about: Message("study-growth-about"),
    sweeps,
};

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    if let Some(scene) = request.scene {
        // Of a scene that is given only the picture and the depth can be varied.
        let mut parts = vec![pixels(scene, request)?];
        parts.extend(
            sends_rays_on(scene)
                .then(|| depth(&[("curve-the-scene", scene)], request))
                .transpose()?,
        );
        return Ok(parts);
    }
    let [mirrors, balls] = [scenes::MIRRORS, scenes::BALLS].map(scenes::own);
    Ok(vec![
        pixels(&balls, request)?,
        triangles(request)?,
        depth(
            &[
                ("curve-two-mirrors", &mirrors),
                ("curve-a-glass-ball", &balls),
            ],
            request,
        )?,
        form_factors(request)?,
        solving(request)?,
        events(request)?,
    ])
}

fn part(
    title: &'static str,
    size: Message,
    memory: Message,
    curves: impl IntoIterator<Item = Curve>,
) -> Sweep {
    Sweep {
        title: Label::of(title),
        axes: Axes::TimeOverSize,
        size,
        quantity: Message("measure-nothing"),
        law: Law::Power,
        reference: Reference::none(),
        memory,
        curves: curves.into_iter().collect(),
    }
}

/// All methods that draw without solving for light first.
fn methods() -> impl Iterator<Item = Method> {
    let draws = |method: &Method| method.draws_pixels();
    Method::ALL.into_iter().filter(draws)
}

fn pixels(scene: &Scene, request: &Request) -> Result<Sweep, String> {
    let camera = scenes::camera(scene)?;
    let doublings = request.either(4, 6);
    let stages: Vec<_> = (0..doublings)
        .map(|step| [40 << step, 30 << step])
        .map(|size| {
            (
                size,
                Arc::new(scenes::prepared(scene.clone(), &camera, size)),
            )
        })
        .collect();
    let curves = methods().map(|method| {
        let sweep_settings = stages.iter().map(|([width, height], prepared)| {
            let pixels = f64::from(width * height);
            let setting = Label::Plain(format!("{width}×{height}"));
            pictures::sweep_setting(setting, pixels, prepared, method, Settings::default())
        });
        Curve {
            name: Label::Method(method),
            sweep_settings: sweep_settings.collect(),
        }
    });
    Ok(part(
        "part-pixels",
        Message("measure-pixels"),
        MEMORY,
        curves,
    ))
}

fn triangles(request: &Request) -> Result<Sweep, String> {
    let steps = request.either(5, 7);
    let mut stages = Vec::new();
    for step in 0..steps {
        let longitudes = 8 << step;
        let mut scene = scenes::own(scenes::BALLS);
        let mesh = sphere_mesh(DVec3::ZERO, 1.2, [longitudes, longitudes / 2]);
        scene.objects.truncate(1);
        scene.objects[0].shape = Shape::Mesh(mesh);
        let camera = scenes::camera(&scene)?;
        let prepared = scenes::prepared(scene, &camera, [160, 120]);
        stages.push((longitudes, Arc::new(prepared)));
    }
    let curves = methods().map(|method| {
        let sweep_settings = stages.iter().map(|(longitudes, prepared)| {
            // Quadrilaterals, but for the triangles at the poles
            let triangles = longitudes * (longitudes - 2);
            let setting = Label::with("setting-triangles", "count", triangles);
            pictures::sweep_setting(
                setting,
                triangles.into(),
                prepared,
                method,
                Settings::default(),
            )
        });
        Curve {
            name: Label::Method(method),
            sweep_settings: sweep_settings.collect(),
        }
    });
    Ok(part(
        "part-triangles",
        Message("measure-triangles"),
        MEMORY,
        curves,
    ))
}

fn depth(scenes: &[(&'static str, &Scene)], request: &Request) -> Result<Sweep, String> {
    let size = request.either([40, 30], [160, 120]);
    let deepest = request.either(8, 12);
    let mut curves = Vec::new();
    for &(key, scene) in scenes {
        let camera = scenes::camera(scene)?;
        let prepared = scenes::prepared(scene.clone(), &camera, size);
        let prepared = Arc::new(prepared);
        let sweep_settings = (1..=deepest).map(|depth| {
            let setting = Label::with("setting-depth", "depth", depth);
            pictures::sweep_setting(
                setting,
                depth.into(),
                &prepared,
                Method::RayTracing,
                settings(depth, 1),
            )
        });
        curves.push(Curve {
            name: Label::of(key),
            sweep_settings: sweep_settings.collect(),
        });
    }
    Ok(part(
        "part-depth-of-rays",
        Message("measure-levels"),
        MEMORY,
        curves,
    ))
}

fn form_factors(request: &Request) -> Result<Sweep, String> {
    let most = request.either(4, 8);
    let mut rooms = Vec::new();
    for n in 1..=most {
        let patches = Patches::of(&scenes::cube(n), 100_000).map_err(|error| error.to_string())?;
        rooms.push(Rc::new(patches));
    }
    let curves = form_factor::Method::ALL.into_iter().map(|method| {
        let name = method.name();
        let method = match method {
            // A sixteenth of the rays and pixels: how they grow is the same.
            form_factor::Method::MonteCarlo { rays, seed } => form_factor::Method::MonteCarlo {
                rays: rays / 16,
                seed,
            },
            form_factor::Method::Hemicube(cubes) => {
                form_factor::Method::Hemicube(form_factor::hemicube::Hemicubes {
                    resolution: cubes.resolution / 4,
                    ..cubes
                })
            }
            method => method,
        };
        let sweep_settings = rooms.iter().map(|patches| matrix_rung(patches, method));
        Curve {
            name: Label::Value(name),
            sweep_settings: sweep_settings.collect(),
        }
    });
    Ok(part(
        "part-form-factors-of-a-cube",
        Message("measure-patches"),
        Message("memory-matrix"),
        curves,
    ))
}

fn matrix_rung(patches: &Rc<Patches>, method: form_factor::Method) -> Setting {
    let n = patches.len();
    let shared = patches.clone();
    Setting {
        setting: Label::with("setting-patches", "count", n),
        size: n as f64,
        bytes: (n * n * size_of::<f64>()) as u64,
        operations: vec![Operations {
            of: "form_factors",
            count: (n * n) as u64,
        }],
        truth: None,
        drawn: None,
        run: Box::new(move || {
            let matrix = FormFactors::new(&shared, method, None).matrix();
            Ok(Values::Numbers(matrix))
        }),
    }
}

fn solving(request: &Request) -> Result<Sweep, String> {
    let sides: &[u32] = request.either(&[2, 3, 4, 6], &[2, 3, 4, 6, 8, 12]);
    let mut problems = Vec::new();
    for &n in sides {
        problems.push(Rc::new(Problem::of(&scenes::cube(n), usize::MAX)?));
    }
    let curves = solvers().map(|solver| {
        let sweep_settings = problems.iter().map(|problem| {
            let n = problem.patches();
            let shared = problem.clone();
            Setting {
                setting: Label::with("setting-patches", "count", n),
                size: n as f64,
                bytes: problem.bytes(),
                operations: Vec::new(),
                truth: None,
                drawn: None,
                run: Box::new(move || {
                    let solution = shared.solve(solver, 1e-6, &mut Unrecorded)?;
                    Ok(Values::Numbers(solution.radiosity))
                }),
            }
        });
        Curve {
            name: Label::Solver(solver),
            sweep_settings: sweep_settings.collect(),
        }
    });
    Ok(part(
        "part-solving-a-cube",
        Message("measure-patches"),
        Message("memory-one-matrix"),
        curves,
    ))
}

/// A Gouraud frame, recorded whole into memory that is used again, and unrecorded.
fn events(request: &Request) -> Result<Sweep, String> {
    let steps = request.either(4, 5);
    let scene = scenes::own(scenes::BALLS);
    let camera = scenes::camera(&scene)?;
    let (mut recorded, mut unrecorded) = (Vec::new(), Vec::new());
    for step in 0..steps {
        let size = [40 << step, 30 << step];
        let prepared = Rc::new(scenes::prepared(scene.clone(), &camera, size));
        let record = {
            let prepared = prepared.clone();
            move || {
                let mut recording = Recording::new(RecordingLimit::default());
                draw(&prepared, &mut recording);
                recording.len()
            }
        };
        let events = record();
        let sweep_setting = |bytes: u64, run: Box<crate::study::form::Run>| Setting {
            setting: Label::with("setting-events", "count", events),
            size: events as f64,
            bytes,
            operations: vec![Operations {
                of: "events",
                count: events as u64,
            }],
            truth: None,
            drawn: None,
            run,
        };
        let an_event = size_of::<gouraud::Event>() + size_of::<Mark>() + Outline::BYTES_AN_EVENT;
        let frame = memory::frame(size);
        recorded.push(sweep_setting(
            frame + (events * an_event) as u64,
            Box::new(move || {
                record();
                Ok(Values::Numbers(Vec::new()))
            }),
        ));
        unrecorded.push(sweep_setting(
            frame,
            Box::new(move || {
                draw(&prepared, &mut Unrecorded);
                Ok(Values::Numbers(Vec::new()))
            }),
        ));
    }
    let curves = [
        ("curve-recorded", recorded),
        ("curve-unrecorded", unrecorded),
    ];
    let curves = curves.map(|(key, sweep_settings)| Curve {
        name: Label::of(key),
        sweep_settings,
    });
    Ok(part(
        "part-events",
        Message("measure-events"),
        Message("memory-events"),
        curves,
    ))
}

fn draw(prepared: &PreparedScene, recorder: &mut impl crate::record::Recorder<gouraud::Event>) {
    let view = &prepared.view;
    let mut frame = Frame::new(view.width, 0..view.height, prepared.scene.background);
    gouraud(
        &ShadedScene::of(prepared),
        Focus::Frame,
        &mut frame,
        recorder,
    );
}
