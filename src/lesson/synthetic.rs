//! Lessons that are made in the program: a picture that can be walked through, with a few words at its first step.

use super::file::StepFile;
use super::parameters::{Coefficient, Parameter};
use super::resolve::Lesson;
use super::text::Text;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::{Language, Message};
use crate::methods::{Family, Settings};
use crate::methods::{Method, Setup};
use crate::panels::Panel;
use crate::replay::Query;
use crate::scene::{Light, Movable, Scene};

impl Lesson {
    /// The size of the picture of a scene that is walked through freely.
    pub const SIZE_OF_A_WALK: [u32; 2] = [480, 360];

    /// A walk through a scene of that name, by the method that suits it: ray tracing, or radiosity where it has surfaces that give off
    /// light and no lamps.
    pub fn of_scene(name: &str, prepared: PreparedScene) -> Lesson {
        let scene = &prepared.scene;
        let glows = scene
            .materials
            .iter()
            .any(|material| material.emission.max_channel() > 0.0);
        let method = match scene.lights.is_empty() && glows {
            true => Method::Radiosity,
            false => Method::RayTracing,
        };
        let setup = Setup::new(prepared, Settings::default());
        // Braces would stand for values of the run.
        let name: String = name.chars().filter(|c| !matches!(c, '{' | '}')).collect();
        let title = Language::ALL.map(|_| name.clone());
        let say = Language::ALL.map(|language| Message("free-walk-say").text(language).to_owned());
        Lesson::walk(title, say, &setup, method)
    }

    /// A walk through a scene by that method. `title` and `say` are by language; in neither may there be braces.
    pub fn walk(title: [String; 2], say: [String; 2], setup: &Setup, method: Method) -> Lesson {
        let lesson = Lesson::of_picture(title, say, setup, method);
        Lesson {
            id: FREE_WALK.into(),
            ..lesson.by_method(method)
        }
    }

    /// Whether it is a walk through a scene, whose method can be chosen.
    pub fn is_free_walk(&self) -> bool {
        self.number == Lesson::UNNUMBERED && self.id == FREE_WALK
    }

    /// Whether a parameter may be changed: those of the lesson, and in a walk through a scene the place of everything but of patches
    /// that exchange light.
    pub fn may_change(&self, parameter: Parameter) -> bool {
        let is_free = || self.is_free_walk() && !self.method.family().exchanges_light();
        self.parameters.contains(&parameter)
            || matches!(parameter, Parameter::Place(_)) && is_free()
    }

    /// The same walk by another method.
    pub fn by_method(&self, method: Method) -> Lesson {
        let panels = method.family().panels_of_a_walk().into_iter();
        let parameters = match method.family() {
            Family::Exchange | Family::Hierarchy => Vec::new(),
            Family::Polygons | Family::Rays => parameters(&self.scene),
        };
        Lesson {
            method,
            focus: method.family().focus(self.size),
            panels: panels.filter_map(Panel::called).collect(),
            parameters,
            ..self.clone()
        }
    }

    /// The same walk with a picture of another size.
    pub fn of_size(&self, size: [u32; 2]) -> Lesson {
        let resized = Lesson {
            size,
            ..self.clone()
        };
        resized.by_method(self.method)
    }

    /// The number of a lesson that stands in no list.
    pub const UNNUMBERED: u32 = 0;

    /// A lesson about the middle of a picture. `title` and `say` are by language; in neither may there be braces.
    pub fn of_picture(
        title: [String; 2],
        say: [String; 2],
        setup: &Setup,
        method: Method,
    ) -> Lesson {
        let prepared = &setup.prepared;
        let size = [prepared.view.width, prepared.view.height];
        let panels = method.panels().into_iter();
        let [title, say] = [title, say].map(Text::new);
        Lesson {
            id: "picture".into(),
            number: Lesson::UNNUMBERED,
            chapter: None,
            title,
            summary: say.clone(),
            topics: Vec::new(),
            scene: prepared.scene.clone(),
            method,
            size,
            settings: setup.settings.clone(),
            compare: Vec::new(),
            focus: method.family().focus(size),
            parameters: Vec::new(),
            by_path: Vec::new(),
            missing: Vec::new(),
            source: None,
            packed: None,
            text: None,
            recap: None,
            panels: panels.filter_map(Panel::called).collect(),
            steps: vec![StepFile {
                at: Query::default(),
                title: None,
                key: None,
                say,
                slide: None,
                question: None,
                mistake: None,
                otherwise: None,
            }],
        }
    }
}

/// The id of a walk through a scene.
const FREE_WALK: &str = "scene";
/// Of so many materials coefficients can be changed.
const MATERIALS: usize = 4;

/// What can be changed in a scene: its lamps, the eye, and the coefficients of its first materials.
fn parameters(scene: &Scene) -> Vec<Parameter> {
    let lights = scene.lights.iter().enumerate();
    let lamps = lights.filter(|(_, light)| matches!(light, Light::Point { .. }));
    let lamps = lamps.map(|(light, _)| Movable::Light(light));
    let materials = 0..scene.materials.len().min(MATERIALS);
    let coefficients = [
        Coefficient::Diffuse,
        Coefficient::Specular,
        Coefficient::Shininess,
    ];
    let of_materials = materials.flat_map(|material| {
        coefficients.map(|coefficient| Parameter::Coefficient(material, coefficient))
    });
    let places = lamps.chain([Movable::Eye]).map(Parameter::Place);
    places.chain(of_materials).collect()
}
