//! The runs that laws walk through: those of the lessons, and of scenes at random by every method.

use lightwalk::algorithms::enclosure;
use lightwalk::algorithms::focus::Focus;
use lightwalk::algorithms::form_factor;
use lightwalk::algorithms::prepared_scene::PreparedScene;
use lightwalk::algorithms::radiosity::Solver;
use lightwalk::color::Rgb;
use lightwalk::lesson::builtins;
use lightwalk::methods::Setup;
use lightwalk::record::RecordingLimit;
use lightwalk::render::Method;
use lightwalk::replay::Run;
use lightwalk::scene::{Scene, Shape, View};
use std::sync::Arc;

/// The run of each lesson, with the lesson's name.
pub fn lessons() -> impl Iterator<Item = (&'static str, Run)> {
    builtins().iter().map(|builtin| {
        let open = builtin.read().and_then(|lesson| lesson.open());
        let open = open.unwrap_or_else(|error| panic!("{}: {error}", builtin.id));
        (builtin.id, open.run)
    })
}

/// The run of the whole of a small picture.
pub fn recorded(mut scene: Scene, method: Method, solver: Solver) -> Run {
    for object in &mut scene.objects {
        object.divisions = 4;
    }
    if method == Method::Radiosity {
        return radiosity(
            scene,
            Focus::Frame,
            enclosure::Settings {
                solver,
                ..enclosure::Settings::default()
            },
        );
    }
    record(scene, method, Focus::Frame, enclosure::Settings::default())
}

/// The form factor from the first polygon of the scene to the second.
pub fn form_factor(scene: Scene, form_factors: form_factor::Method) -> Run {
    let settings = enclosure::Settings {
        form_factors,
        ..enclosure::Settings::default()
    };
    radiosity(scene, Focus::FormFactor { i: 0, j: 1 }, settings)
}

fn radiosity(mut scene: Scene, focus: Focus, settings: enclosure::Settings) -> Run {
    scene
        .objects
        .retain(|object| matches!(object.shape, Shape::Polygon { .. }));
    for material in &mut scene.materials {
        material.reflectance = material.specular * 0.9;
        material.emission = Rgb::splat(material.shininess);
    }
    record(scene, Method::Radiosity, focus, settings)
}

fn record(scene: Scene, method: Method, focus: Focus, settings: enclosure::Settings) -> Run {
    let view = View::new(&scene.camera.expect("a camera"), 12, 9);
    let setup = Setup::new(PreparedScene::new(scene, view), settings);
    Run::record(Arc::new(setup), method, focus, RecordingLimit::default())
}
