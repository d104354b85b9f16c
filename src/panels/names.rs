//! What objects, lights and rays are called.

use super::strings::{Language, Words};
use crate::algorithms::enclosure::Enclosure;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::record::Value;
use crate::replay::Walk;
use crate::scene::Light;

const POINT: Words = Words::new("point light", "cahaya titik");
const DIRECTIONAL: Words = Words::new("directional light", "cahaya terarah");
const LIGHT: Words = Words::new("light", "cahaya");
const BACKGROUND: Words = Words::new("background", "latar belakang");

/// The kinds of ray as events name them, in words, and the letters that stand for them in drawings.
const RAYS: [(&str, Words, &str); 4] = [
    ("primary", Words::new("primary", "primer"), "P"),
    ("reflected", Words::new("reflected", "pantul"), "R"),
    ("transmitted", Words::new("transmitted", "bias"), "T"),
    (
        "total_internal_reflection",
        Words::new("total internal reflection", "pantulan internal total"),
        "TIR",
    ),
];

/// Words that events tell, where a sentence has others for them.
const WORDS: [(&str, Words); 11] = [
    ("red", Words::new("red", "merah")),
    ("green", Words::new("green", "hijau")),
    ("blue", Words::new("blue", "biru")),
    ("jacobi", Words::new("Jacobi’s iteration", "iterasi Jacobi")),
    (
        "gauss-seidel",
        Words::new("Gauss–Seidel iteration", "iterasi Gauss–Seidel"),
    ),
    (
        "over-relaxation",
        Words::new(
            "successive over-relaxation",
            "relaksasi lebih berturut-turut",
        ),
    ),
    ("shooting", Words::new("shooting", "penembakan")),
    (
        "overshooting",
        Words::new("overshooting", "penembakan lebih"),
    ),
    (
        "chebyshev",
        Words::new("Chebyshev’s iteration", "iterasi Chebyshev"),
    ),
    (
        "conjugate-gradients",
        Words::new("conjugate gradients", "gradien konjugat"),
    ),
    ("direct", Words::new("elimination", "eliminasi")),
];

/// A word that an event tells, in a sentence.
pub(super) fn word(word: &'static str, language: Language) -> &'static str {
    let known = WORDS.iter().find(|(recorded, _)| *recorded == word);
    known.map_or(word, |(_, strings)| strings.in_language(language))
}

/// The object of that number.
pub(super) fn object(prepared: &PreparedScene, number: u32) -> &str {
    let object = prepared.scene.objects.get(number as usize);
    object.map_or("", |object| object.name.as_str())
}

/// A patch of the room: its object, and its cell where there is more than one.
pub(super) fn patch(prepared: &PreparedScene, room: &Enclosure, number: usize) -> String {
    let patch = &room.patches[number];
    let name = object(prepared, patch.object);
    let [nu, nv] = room.patches.surfaces[patch.object as usize].grid;
    match patch.cell {
        _ if nu * nv == 1 => name.to_string(),
        [i, _] if nv == 1 => format!("{name} {i}"),
        [i, j] => format!("{name} ({i}, {j})"),
    }
}

/// The light of that number: lights have no names.
pub(super) fn light(number: u32, language: Language) -> String {
    format!("{} {number}", LIGHT.in_language(language))
}

/// What the number told under a field's name stands for, where it stands for a thing of the scene.
pub(super) fn of_field<'a>(
    prepared: &'a PreparedScene,
    field: &str,
    value: Value,
    language: Language,
) -> Option<&'a str> {
    let Value::Integer(number) = value else {
        return None;
    };
    let number = u32::try_from(number).ok()?;
    match field {
        "object" | "blocker" => Some(object(prepared, number)).filter(|name| !name.is_empty()),
        "light" => Some(match prepared.scene.lights.get(number as usize)? {
            Light::Point { .. } => POINT.in_language(language),
            Light::Directional { .. } => DIRECTIONAL.in_language(language),
        }),
        _ => None,
    }
}

/// A kind of ray in words, and the letters for it.
pub(super) fn ray_kind(name: &str, language: Language) -> (&'static str, &'static str) {
    let known = RAYS.iter().find(|(kind, ..)| *kind == name);
    let (_, strings, letters) = known.unwrap_or(&RAYS[0]);
    (strings.in_language(language), letters)
}

/// What the ray is called that `scope` opens, from the longest form to the shortest: its kind and what it meets, its kind,
/// its letters.
pub(super) fn ray(
    walk: &dyn Walk,
    scope: usize,
    prepared: &PreparedScene,
    language: Language,
) -> Option<[String; 3]> {
    if walk.kind(scope) != "Ray" {
        return None;
    }
    // Ray casting follows primary rays alone, and does not say so of each.
    let (kind, letters) = match walk.own_fields(scope).get("ray") {
        Some(Value::Word(kind)) => ray_kind(kind, language),
        _ => ray_kind("primary", language),
    };
    let goes = match goal(walk, scope, prepared, language) {
        Some(goal) => format!("{kind} → {goal}"),
        None => kind.to_string(),
    };
    Some([goes, kind.to_string(), letters.to_string()])
}

/// What the ray meets that `scope` opens: its search says so at its end.
fn goal(
    walk: &dyn Walk,
    scope: usize,
    prepared: &PreparedScene,
    language: Language,
) -> Option<String> {
    let search = Some(scope + 1).filter(|&step| step < walk.len())?;
    if walk.kind(search) != "Search" {
        return None;
    }
    let found = walk.own_fields(walk.outline().last(search));
    let number = |name| match found.get(name) {
        Some(Value::Integer(number)) => u32::try_from(number).ok(),
        _ => None,
    };
    match found.get("met")? {
        Value::Word("object") => Some(object(prepared, number("object")?).to_string()),
        Value::Word("light") => Some(light(number("light")?, language)),
        _ => Some(BACKGROUND.in_language(language).to_string()),
    }
}
