//! Form-factor methods by the number of their samples, for pairs of unit squares whose form factor has a closed form.
//!
//! With a scene of the user's: all its form factors, what stands between left aside, against the automatic choice at its sharpest.

use crate::algorithms::form_factor::hemicube::Hemicubes;
use crate::algorithms::form_factor::{FormFactors, Method};
use crate::language::Message;
use crate::record::Counter;
use crate::record::Unrecorded;
use crate::scene::Scene;
use crate::scene::patches::Patches;
use crate::study::count::operations;
use crate::study::fit::Law;
use crate::study::form::{
    Axes, Curve, Operations, Reference, Request, Setting, Study, Sweep, Values,
};
use crate::study::label::Label;
use crate::study::machine::SEED;
use std::rc::Rc;

pub static STUDY: Study = Study {
    name: "form-factors",
    title: Message("study-form-factors"),
    about: Message("study-form-factors-about"),
    sweeps,
};

/// Pairs of unit squares: the key of its title, corners of the second one, and F to 17 digits, from the closed forms.
const PAIRS: [(&str, [[f64; 3]; 4], f64); 3] = [
    (
        "part-squares-at-distance-1",
        [[0., 0., 1.], [0., 1., 1.], [1., 1., 1.], [1., 0., 1.]],
        0.199_824_895_698_387_38,
    ),
    (
        "part-squares-at-distance-0-1",
        [[0., 0., 0.1], [0., 1., 0.1], [1., 1., 0.1], [1., 0., 0.1]],
        0.826_994_522_397_256_6,
    ),
    (
        "part-squares-with-a-common-edge",
        [[0., 0., 0.], [0., 1., 0.], [0., 1., 1.], [0., 0., 1.]],
        0.200_043_776_075_403_15,
    ),
];

const FIRST: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];

fn sweeps(request: &Request) -> Result<Vec<Sweep>, String> {
    match request.scene {
        Some(scene) => whole_scene(scene, request).map(|sweep| vec![sweep]),
        None => PAIRS.iter().map(|pair| of_pair(pair, request)).collect(),
    }
}

fn of_pair(
    (title, second, f): &(&'static str, [[f64; 3]; 4], f64),
    request: &Request,
) -> Result<Sweep, String> {
    let squares = super::scenes::polygons(&[FIRST, *second]);
    let patches = Rc::new(Patches::of(&squares, 2).map_err(|error| error.to_string())?);
    let truth: Rc<[f64]> = Rc::new([*f]);
    let curves = curves(request, |method| {
        let counted = &mut Counter::default();
        FormFactors::new(&patches, method, None).pair(0, 1, counted);
        let operations = operations(counted, &KINDS);
        let patches = patches.clone();
        let run = move || {
            let form_factors = FormFactors::new(&patches, method, None);
            Values::Numbers(vec![form_factors.pair(0, 1, &mut Unrecorded)])
        };
        (
            operations,
            scratch(method),
            Box::new(move || Ok(run())) as _,
        )
    });
    Ok(sweep(
        Label::of(title),
        Reference {
            what: Label::with("reference-closed-form", "f", format!("{f:.15}")),
            error: 1e-16,
            known_by: Label::of("reference-17-digits"),
        },
        curves,
        &truth,
    ))
}

fn whole_scene(scene: &Scene, request: &Request) -> Result<Sweep, String> {
    let patches = Patches::of(scene, 100_000).map_err(|error| error.to_string())?;
    let n = patches.len();
    let most = request.either(200, 500);
    if !(2..=most).contains(&n) {
        return Err(format!(
            "the scene has {n} patches; measured are 2 to {most}, whose matrix is made again and again"
        ));
    }
    let patches = Rc::new(patches);
    let matrix = |tolerance| FormFactors::new(&patches, Method::Auto { tolerance }, None).matrix();
    let truth: Rc<[f64]> = matrix(1e-10).into();
    let curves = curves(request, |method| {
        let entries = Operations {
            of: "form_factors",
            count: (n * n) as u64,
        };
        let patches = patches.clone();
        let run = move || Values::Numbers(FormFactors::new(&patches, method, None).matrix());
        let bytes = scratch(method) + (n * n * size_of::<f64>()) as u64;
        (vec![entries], bytes, Box::new(move || Ok(run())) as _)
    });
    let reference = Reference {
        what: Label::of("reference-automatic-choice"),
        error: 1e-10,
        known_by: Label::of("reference-tolerance"),
    };
    Ok(sweep(
        Label::of("part-all-form-factors"),
        reference,
        curves,
        &truth,
    ))
}

fn sweep(title: Label, reference: Reference, curves: Vec<Unfinished>, truth: &Rc<[f64]>) -> Sweep {
    let curves = curves.into_iter();
    let curves =
        curves.map(|(key, sweep_settings)| Curve::against(truth, Label::of(key), sweep_settings));
    Sweep {
        title,
        axes: Axes::ErrorOverTime,
        size: Message("measure-samples"),
        quantity: Message("measure-form-factor"),
        law: Law::Power,
        reference,
        memory: Message("memory-matrix-and-hemicube"),
        curves: curves.collect(),
    }
}

/// The key of a curve's name, and its settings without what is right.
type Unfinished = (&'static str, Vec<Setting>);

/// Operations, bytes, and the work.
type Work = (Vec<Operations>, u64, Box<crate::study::form::Run>);

/// Every method with more and more samples.
fn curves(request: &Request, work: impl Fn(Method) -> Work) -> Vec<Unfinished> {
    let points: &[usize] = request.either(&[1, 2, 3, 4, 6, 8], &[1, 2, 3, 4, 6, 8, 12, 16]);
    let tolerances: &[i32] =
        request.either(&[2, 4, 6, 8, 10], &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11]);
    let rays: &[u32] = request.either(&[6, 8, 10, 12, 14], &[6, 8, 10, 12, 14, 16, 18]);
    let pixels: &[u32] = request.either(&[16, 32, 64, 128], &[16, 32, 64, 128, 256, 512]);
    let sweep_setting = |setting: Label, size: f64, method: Method| {
        let (operations, bytes, run) = work(method);
        Setting {
            setting,
            size,
            bytes,
            operations,
            truth: None,
            drawn: None,
            run,
        }
    };
    let gauss = |n: usize| n as f64;
    let area = points.iter().map(|&points| {
        let setting = Label::with("setting-pairs", "points", points);
        sweep_setting(
            setting,
            gauss(points).powi(4),
            Method::AreaToArea { points },
        )
    });
    let element = points.iter().map(|&points| {
        let setting = Label::with("setting-points", "points", points);
        sweep_setting(
            setting,
            gauss(points).powi(2),
            Method::ElementToPolygon { points },
        )
    });
    let tolerance = |exponent: i32| 10_f64.powi(-exponent);
    let contour = tolerances.iter().map(|&exponent| {
        let tolerance = tolerance(exponent);
        let setting = Label::with("setting-tolerance", "tolerance", format!("{tolerance:e}"));
        sweep_setting(setting, 1.0 / tolerance, Method::Contour { tolerance })
    });
    let auto = tolerances.iter().map(|&exponent| {
        let tolerance = tolerance(exponent);
        let setting = Label::with("setting-tolerance", "tolerance", format!("{tolerance:e}"));
        sweep_setting(setting, 1.0 / tolerance, Method::Auto { tolerance })
    });
    let monte_carlo = rays.iter().map(|&power| {
        let (rays, seed) = (1 << power, SEED);
        sweep_setting(
            Label::with("setting-rays", "count", rays),
            rays.into(),
            Method::MonteCarlo { rays, seed },
        )
    });
    let hemicube = |points: u32| {
        let sweep_setting = &sweep_setting;
        let sweep_settings = pixels.iter().map(move |&resolution| {
            let hemicubes = Hemicubes { resolution, points };
            let size = 3.0 * f64::from(resolution * points).powi(2);
            sweep_setting(
                Label::with("setting-pixels", "count", resolution),
                size,
                Method::Hemicube(hemicubes),
            )
        });
        sweep_settings.collect()
    };
    vec![
        ("value-area-to-area", area.collect()),
        ("value-element-to-polygon", element.collect()),
        ("value-contour", contour.collect()),
        ("value-auto", auto.collect()),
        ("value-monte-carlo", monte_carlo.collect()),
        ("curve-hemicube-at-the-centre", hemicube(1)),
        ("curve-4-by-4-hemicubes", hemicube(4)),
    ]
}

/// What the methods record of their work.
const KINDS: [(&str, &str); 5] = [
    ("Pair", "pairs_of_points"),
    ("Edge", "edges_seen"),
    ("EdgePair", "pairs_of_edges"),
    ("Ray", "rays"),
    ("Pixel", "hemicube_pixels_of_the_patch"),
];

/// The depth buffers of the five faces of a hemicube.
fn scratch(method: Method) -> u64 {
    match method {
        Method::Hemicube(Hemicubes { resolution, .. }) => {
            5 * u64::from(resolution).pow(2) * size_of::<f64>() as u64
        }
        _ => 0,
    }
}
